"""Frames at known poses to a volume, one frame in memory at a time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul
from ...meshing.volume.surface_weights import least_weights
from ...meshing.volume.tsdf import TSDFVolume
from ...pcd.cloud import PointCloud
from ...registration.deformable.control_grid import ControlGrid
from ...registration.rigid import invert_pose
from .frames import Frames, LostFrame, ReadFrame
from .slac import integrate_deformed

Matrix = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Straightener:
    """What takes a camera's distortion out of frames.

    Attributes:
        grid: In the coordinates of the frames' fragments.
        T_fragment_camera: Where in its fragment each frame was taken, float64 [n, 4, 4].
    """

    grid: ControlGrid
    T_fragment_camera: Matrix


def fuse_frames(
    frames: Frames,
    indices: Sequence[int],
    poses: Matrix,
    volume: TSDFVolume,
    *,
    straight: Straightener | None = None,
    seen: Callable[[ReadFrame], None] = lambda frame: None,
) -> list[LostFrame]:
    """Fold frames into a volume in the order given.

    Args:
        frames: Of the source.
        indices: Which of them.
        poses: T_volume_camera of each, [n, 4, 4].
        volume: With colour only where all of the frames have it.
        straight: Bends each frame straight on the way.
        seen: Called with each frame.

    Returns:
        The frames that cannot be read any more.
    """
    lost = []
    with frames.closing(indices) as read:
        for place, (frame, pose) in enumerate(zip(read, poses, strict=True)):
            color = frame.color if volume.has_color else None
            if frame.depth is None or (volume.has_color and color is None):
                reason = frame.reason or "has no colour any more"
                lost.append(LostFrame(frame.index, frame.name, reason))
            else:
                limit = frames.config.depth_max
                if straight is None:
                    volume.integrate(frame.depth, frames.intrinsic, invert_pose(pose), color, depth_max=limit)
                else:
                    T = straight.T_fragment_camera[place]
                    given = volume, straight.grid, frame.depth, frames.intrinsic, matmul(pose, invert_pose(T)), T, color
                    integrate_deformed(*given, depth_max=limit)
            seen(frame)
    return lost


def cloud_of(volume: TSDFVolume) -> PointCloud:
    """The surface of a volume as points; where few frames saw it, of all that they saw."""
    for threshold in least_weights(volume.frame_count):
        cloud = volume.extract_point_cloud(threshold)
        if len(cloud):
            return cloud
    return PointCloud()


def make_volume(voxel_size: float, truncation: float | None, colored: bool, device: Any) -> TSDFVolume:
    """A volume for frames that have colour or not."""
    return TSDFVolume(voxel_size=voxel_size, truncation=truncation, color=colored, device=device)
