"""Check of the camera from the frames: `check_focal`."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from ...cameras.depth_range import DEPTH_MAX
from ...cameras.trajectory import Trajectory
from ...core.checks import check_count, check_list, check_positive, check_rigid
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError
from ...io.frames.frames import FrameSource, can_read, check_frames, depth_unit
from ...io.frames.rgbd_sources import RGBDSource
from ..odometry.camera_fit import rotated_pairs
from .camera_check import FocalCheck, assess_camera, view_of
from .frames import SensorFrame
from .tracking import track


def check_focal(
    frames: FrameSource | RGBDSource,
    trajectory: Trajectory | None = None,
    *,
    uncertain: Iterable[int] = (),
    depth_max: float = DEPTH_MAX,
    device: DeviceLike = None,
) -> FocalCheck | None:
    """Check whether frames that are rotated against each other fit better with another camera.

    Focal length, principal point and radial distortion are estimated together, since each hides errors of the others.

    Args:
        frames: From `open_frames`, `frames_from`, or any source with `intrinsic`, `depth_scale` and either `len` and
            `read(i)` or a repeatable iterator.
        trajectory: Poses of some frames, by ids or the first ones. None: estimated by `loom.rgbd.track`.
        uncertain: Frame numbers to ignore.
        depth_max: Maximum depth [m].
        device: Compute device; None: the CPU.

    Returns:
        None if the camera rotated too little, or too few frames overlap.

    Raises:
        TypeError, ValueError: Not frames of one camera, not a trajectory, or an invalid length or frame number.
        DeviceError: No such device.

    Notes:
        At most 60 pairs of frames are read. Bitwise reproducible. A wrong depth scale cannot be detected.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> frames = loom.frames_from([(None, np.ones((48, 64), np.float32))] * 3, camera)
        >>> still = loom.Trajectory(np.tile(np.eye(4), (3, 1, 1)))
        >>> print(loom.rgbd.check_focal(frames, still))  # a camera that did not turn tells nothing
        None
    """
    check_frames("frames", frames)
    where, farthest = resolve_device(device), check_positive("depth_max", depth_max)
    uncertain_frames = [
        check_count("uncertain", number, minimum=0) for number in check_list("uncertain", uncertain, "numbers")
    ]
    if trajectory is None:
        tracked = track(frames, depth_max=farthest, device=where)
        path, uncertain_frames = tracked.trajectory, [*uncertain_frames, *tracked.uncertain]
    elif isinstance(trajectory, Trajectory):
        path = trajectory
    else:
        raise TypeError(f"trajectory: expected a Trajectory or None, got {type(trajectory).__name__}")
    poses, numbers = _sure(path, uncertain_frames)
    chosen = sorted({index for pair in rotated_pairs(poses) for index in pair})
    read = _reader(frames, {int(numbers[index]) for index in chosen})
    views, their_poses = [], []
    for index in chosen:
        pose = check_rigid(f"trajectory: the pose of frame {numbers[index]}", poses[index])
        try:
            frame = read(int(numbers[index]))
        except FileError:
            continue
        views.append(view_of(SensorFrame(frame, frames.intrinsic, depth_unit(frames, frame), farthest, where)))
        their_poses.append(pose)
    return assess_camera(views, their_poses, frames.intrinsic)


def _sure(path: Trajectory, uncertain: Sequence[int]) -> tuple[Any, Any]:
    numbers = np.arange(len(path)) if path.ids is None else path.ids[:, 0]
    sure = ~np.isin(numbers, np.array(uncertain, np.int64))
    return path.poses[sure], numbers[sure]


def _reader(frames: FrameSource | RGBDSource, numbers: set[int]) -> Callable[[int], Any]:
    if can_read(frames):
        read: Callable[[int], Any] = frames.read
        known = numbers.intersection(range(len(frames)))
    else:
        cached = {i: frame for i, frame in enumerate(frames if numbers else ()) if i in numbers}  # type: ignore[arg-type]
        read, known = cached.__getitem__, set(cached)
    if unknown := numbers - known:
        raise ValueError(f"trajectory: frame {min(unknown)} is not in frames")
    return read
