"""TSDF fusion of frames with known poses, optionally undistorted by SLAC (registration/deformable/slac.py)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.depth_range import OPEN3D_DEPTH_MAX
from ...cameras.images import RGBDImage
from ...core.checks import check_positive, check_rigid
from ...kernels.linear_algebra import inv, matmul
from ...meshing.volume.surface_weights import min_weights
from ...meshing.volume.tsdf import TSDFVolume
from ...pcd.cloud import PointCloud
from ...registration.deformable.control_grid import ControlGrid
from ...registration.deformable.slac import (
    SLACOptimizerParams,
    run_rigid_optimizer_for_fragments,
    run_slac_optimizer_for_fragments,
)
from ...registration.pose_graphs.reports import FragmentOverlap, RefinementReport
from ...registration.rigid import invert_pose
from .frames import Frames, LostFrame, ReadFrame

Matrix = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Straightener:
    """SLAC's distortion grid, and the camera pose of each frame in its fragment, float64 [n, 4, 4]."""

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
    """Fuse frames at poses T_volume_camera [n, 4, 4] in order. Returns the unreadable ones. Calls `seen` with each."""
    lost = []
    with frames.closing(indices) as read:
        for index, (frame, pose) in enumerate(zip(read, poses, strict=True)):
            color = frame.color if volume.has_color else None
            if frame.depth is None or (volume.has_color and color is None):
                reason = frame.reason or "no longer has color"
                lost.append(LostFrame(frame.index, frame.name, reason))
            else:
                limit = frames.config.depth_max
                if straight is None:
                    volume.integrate(frame.depth, frames.intrinsic, invert_pose(pose), color, depth_max=limit)
                else:
                    T = straight.T_fragment_camera[index]
                    given = volume, straight.grid, frame.depth, frames.intrinsic, matmul(pose, invert_pose(T)), T, color
                    integrate_deformed(*given, depth_max=limit)
            seen(frame)
    return lost


def cloud_of(volume: TSDFVolume) -> PointCloud:
    """The surface of a volume as points. With few frames, of all observed voxels."""
    for threshold in min_weights(volume.frame_count):
        cloud = volume.extract_point_cloud(threshold)
        if len(cloud):
            return cloud
    return PointCloud()


__all__ = [
    "ControlGrid",
    "FragmentOverlap",
    "RefinementReport",
    "SLACOptimizerParams",
    "integrate_deformed",
    "run_rigid_optimizer_for_fragments",
    "run_slac_optimizer_for_fragments",
]


def integrate_deformed(
    volume: TSDFVolume,
    grid: ControlGrid,
    depth: ArrayLike,
    intrinsic: PinholeCameraIntrinsic,
    T_world_fragment: ArrayLike,
    T_fragment_camera: ArrayLike | None = None,
    color: ArrayLike | None = None,
    depth_max: float = OPEN3D_DEPTH_MAX,
) -> int:
    """Fuse a frame into a volume after undistortion of its depth by a control grid.

    Args:
        volume: The volume, on the grid's device.
        grid: From `run_slac_optimizer_for_fragments`.
        depth: Shape [h, w]. Integers of 16 bits and more [mm], or floats [m].
        intrinsic: The camera, of the image size.
        T_world_fragment: Optimized pose of the frame's fragment, shape [4, 4].
        T_fragment_camera: Camera pose in the fragment; None: the identity.
        color: uint8 [h, w, 3]. As of `TSDFVolume.integrate`.
        depth_max: Maximum depth [m], before and after undistortion.

    Returns:
        The number of blocks touched.

    Raises:
        TypeError, ValueError, DeviceError: As `TSDFVolume.integrate` and `ControlGrid.deform_depth`. The volume is
        unchanged.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.rgbd.reconstruction.volumes import integrate_deformed
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> depth, grid = np.full((48, 64), 1000, np.uint16), loom.rgbd.ControlGrid()
        >>> grid.touch(loom.PointCloud.create_from_depth_image(depth, camera))
        >>> grid.set_positions(1.02 * grid.get_init_positions())
        >>> volume = loom.TSDFVolume(voxel_size=0.02, truncation=0.08)
        >>> touched = integrate_deformed(volume, grid, depth, camera, np.eye(4))
        >>> mesh = volume.extract_triangle_mesh(weight_threshold=0)
        >>> bool(np.allclose(mesh.vertices[:, 2], 1.02, atol=1e-5))
        True
    """
    if not isinstance(volume, TSDFVolume):
        raise TypeError(f"volume: expected a TSDFVolume, got {type(volume).__name__}")
    if not isinstance(grid, ControlGrid):
        raise TypeError(f"grid: expected a ControlGrid, got {type(grid).__name__}")
    check_positive("depth_max", depth_max, allow_infinite=True)
    T = check_rigid("T_world_fragment", T_world_fragment)
    step = np.eye(4) if T_fragment_camera is None else check_rigid("T_fragment_camera", T_fragment_camera)
    T_camera_fragment = inv(step)
    if color is None:
        straight = grid.deform_depth(depth, intrinsic, T_camera_fragment, depth_max=depth_max)
        return volume.integrate(straight, intrinsic, invert_pose(matmul(T, step)), depth_max=depth_max)
    frame = RGBDImage(color, depth, depth_trunc=depth_max, device=grid.device)
    straight = grid.deform_rgbd(frame, intrinsic, T_camera_fragment, depth_max=depth_max)
    given = straight.depth, intrinsic, invert_pose(matmul(T, step))
    return volume.integrate(*given, color=straight.color, depth_max=depth_max)
