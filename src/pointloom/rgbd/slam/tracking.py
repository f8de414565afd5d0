"""Camera trajectory from RGB-D frames: `track`."""

from __future__ import annotations

import contextlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.depth_range import DEPTH_MAX
from ...cameras.pose_files import trajectory_of
from ...cameras.trajectory import Trajectory
from ...core.checks import check_count, check_positive, check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError
from ...core.number_ranges import some_frames
from ...core.progress import ReportProgress
from ...core.timing import Clock, check_clock
from ...io.frames.frames import (
    READ_AHEAD,
    FrameSource,
    check_frames,
    count_of,
    depth_unit,
    measured_fractions,
    read_frames_or_errors,
    source_warnings,
)
from ...io.frames.rgbd_sources import RGBDSource
from .dense_slam import DenseSLAM
from .frame_checks import BLANK
from .maps import map_sizes
from .results import TrackingResult
from .tracked_path import TrackedPath
from .volume_sizes import check_sizes

VOXEL_SIZE = 0.02  # [m] of the model
MAX_GAP, MAX_GAP_SECONDS = 15, 0.5  # frames, and [s] if there are timestamps, without an image


def track(
    frames: FrameSource | RGBDSource,
    *,
    voxel_size: float = VOXEL_SIZE,
    depth_max: float = DEPTH_MAX,
    device: DeviceLike = None,
    read_ahead: int = READ_AHEAD,
    progress: ReportProgress | None = None,
    clock: Clock | None = None,
) -> TrackedPath:
    """Estimate the pose of each frame of a moving depth camera, as `pointloom track` does.

    Frame-to-model tracking with `loom.rgbd.DenseSLAM`.

    Args:
        frames: From `open_frames`, `frames_from`, a camera, or any ordered source with `intrinsic`, `depth_scale` and
            either `len` and `read(i)` or an iterator. Their poses are only kept as the truth.
        voxel_size: Voxel edge of the model [m].
        depth_max: Maximum depth [m].
        device: Compute device; None: the CPU.
        read_ahead: Number of frames read ahead; 0: none.
        progress: Called with (stage, steps done, steps in all or 0 if unknown).
        clock: Measures the stages "read" (waiting for frames) and "track".

    Returns:
        The poses T_world_camera, with the first frame with depth as the world, and the status of each frame. Lost or
        unreadable frames have no pose, but a reason. A camera that is lost for long starts a new map. Unjoined ones are
        in `TrackedPath.other_maps`.

    Raises:
        TypeError, ValueError: Not frames of one camera, a length out of range, no frame, or a wrong image size.
        FileError: No frame can be read, or a frame of a stream cannot be read.
        DeviceError: No such device.

    Notes:
        Bitwise reproducible for any number of threads.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> v, u = np.mgrid[:48, :64]
        >>> depth = np.float32(1.0 + 0.1 * np.sin(u / 5) * np.cos(v / 7))
        >>> path = loom.rgbd.track(loom.frames_from([(None, depth)] * 3, camera))
        >>> path.trajectory, path.lost
        (Trajectory(3 poses, ids), {})
    """
    check_frames("frames", frames)
    sizes: dict[str, Any] = {"voxel_size": check_sizes(voxel_size)[0], "device": resolve_device(device)}
    sizes["depth_max"] = check_positive("depth_max", depth_max)
    options: dict[str, Any] = {"read_ahead": read_ahead, "progress": progress, "clock": clock}
    return track_with(make_slam(frames, **sizes), frames, **sizes, **options)


def track_with(
    slam: DenseSLAM,
    frames: FrameSource | RGBDSource,
    *,
    voxel_size: float,
    depth_max: float,
    device: DeviceLike,
    read_ahead: int = READ_AHEAD,
    progress: ReportProgress | None = None,
    clock: Clock | None = None,
) -> TrackedPath:
    report_progress, clock = check_progress(progress), check_clock(clock)
    tally, count = _Tally(slam), count_of(frames)
    first_error: FileError | None = None
    report_progress("frames", 0, count)
    with contextlib.closing(read_frames_or_errors(frames, check_count("read_ahead", read_ahead, minimum=0))) as taken:
        for number, frame in enumerate(taken):
            clock.stop("read")
            if isinstance(frame, FileError):
                first_error = first_error or frame
                tally.unreadable[number] = str(frame)
            else:
                tally.take(number, frame, depth_max * depth_unit(frames, frame))
                clock.stop("track")
            tally.count += 1
            report_progress("frames", tally.count, count)
    if first_error is not None and len(tally.unreadable) == tally.count:
        raise first_error
    if not tally.count:
        raise ValueError("frames: expected at least one frame, got none")
    slam.join_maps()
    clock.stop("track")
    sizes: dict[str, Any] = {"voxel_size": voxel_size, "depth_max": depth_max, "device": str(device)}
    return tally.path(**sizes, source_warnings=(*source_warnings(frames), *slam.images.warnings))


def make_slam(
    frames: FrameSource | RGBDSource,
    *,
    voxel_size: float,
    depth_max: float,
    device: DeviceLike,
    submap_frames: int | None = None,
) -> DenseSLAM:
    options: dict[str, Any] = {"depth_scale": frames.depth_scale, "depth_max": depth_max, "device": device}
    return DenseSLAM(frames.intrinsic, voxel_size=voxel_size, submap_frames=submap_frames, **options)


class _Tally:
    def __init__(self, slam: DenseSLAM):
        self.slam, self.count, self._first = slam, 0, len(slam.results)
        self.stepped: list[int] = []
        self.timestamps: dict[int, float | None] = {}
        self.true_poses: dict[int, NDArray[np.float64] | None] = {}
        self.unreadable: dict[int, str] = {}
        self.fractions: list[tuple[float, float]] = []

    def take(self, number: int, frame: Any, farthest: float) -> None:
        self.fractions.append(measured_fractions(frame.depth, farthest))
        self.slam.step(frame)
        self.stepped.append(number)
        self.timestamps[number] = getattr(frame, "timestamp", None)
        self.true_poses[number] = getattr(frame, "T_world_camera", None)

    def path(self, **sizes: Any) -> TrackedPath:
        results = dict(zip(self.stepped, self.slam.results[self._first :], strict=True))
        located = {number: result for number, result in results.items() if result.pose is not None}
        largest, *others = map_sizes(list(located.values())) or [0]
        main = [number for number, result in located.items() if result.map == largest]
        aligned = [result for result in located.values() if result.iterations]  # not the first frames of maps
        covered, fixed = covered_frames(results, largest), self.slam.fixed_parts.note
        remaining = [n for n, r in located.items() if r.status == "uncertain" and r.fused and not r.has_drifted]
        stream = self.slam.stream.problems
        if stream and remaining:
            stream += f"; {len(remaining)} of these frames ({some_frames(remaining)}) remain in the model"
        notes = [f"{len(covered)} frames are blank and were left out ({some_frames(covered)})"] if covered else []
        depth_fraction, used_fraction = np.mean(self.fractions, axis=0).tolist() if self.fractions else (0.0, 0.0)
        return TrackedPath(
            trajectory=self._trajectory(main, results), true_poses=tuple(self.true_poses[n] for n in main),
            frame_count=self.count, uncertain=tuple(n for n, result in located.items() if not result.is_tracked),
            lost={n: "; ".join(result.warnings) for n, result in results.items() if result.pose is None},
            unreadable=self.unreadable, residuals=tuple(result.inlier_rmse for result in aligned),
            fitness=tuple(result.fitness for result in aligned),
            other_maps=tuple(
                self._trajectory([n for n, result in located.items() if result.map == other], results)
                for other in others
            ),
            joins=tuple(self.slam.joins),
            uncertain_warning=next(("; ".join(r.warnings) for r in located.values() if not r.is_tracked), ""),
            stream=stream, deviations=tuple(results[n].position_deviation for n in main),
            pose_covariances=tuple(found for n in main if (found := results[n].pose_covariance) is not None),
            drifted=tuple(n for n, result in located.items() if result.has_drifted),
            covered=tuple(covered), notes=(*notes, *((fixed,) if fixed else ()), *self.slam.images.notes),
            depth_fraction=depth_fraction, used_fraction=used_fraction, camera=self.slam.check_camera(), **sizes,
        )  # fmt: skip

    def _trajectory(self, numbers: list[int], results: dict[int, TrackingResult]) -> Trajectory:
        poses = [pose for n in numbers if (pose := results[n].pose) is not None]
        return trajectory_of(poses, numbers, [self.timestamps[n] for n in numbers])


def covered_frames(results: dict[int, TrackingResult], main: int) -> list[int]:
    """Blank frames of short gaps, after which the next frame was tracked in the main map without ambiguity."""
    covered: list[int] = []
    gap: list[int] = []
    before: TrackingResult | None = None
    for number, result in results.items():
        if result.warnings == (BLANK,):
            gap.append(number)
            continue
        is_short = len(gap) <= MAX_GAP
        if before is not None and gap and before.timestamp is not None and result.timestamp is not None:
            is_short = result.timestamp - before.timestamp <= MAX_GAP_SECONDS
        if gap and before is not None and is_short and result.is_tracked and before.map == result.map == main:
            covered += gap
        gap, before = [], result
    return covered
