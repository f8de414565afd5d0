"""SLAC: fragments aligned together with the distortion of their camera, and frames fused through what it found.

The optimiser is registration/deformable/slac.py.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.images import RGBDImage
from ...core.checks import check_positive, check_rigid
from ...kernels.linear_algebra import inv, matmul
from ...meshing.volume.tsdf import TSDFVolume
from ...registration.deformable.control_grid import ControlGrid
from ...registration.deformable.slac import (
    SLACOptimizerParams,
    run_rigid_optimizer_for_fragments,
    run_slac_optimizer_for_fragments,
)
from ...registration.pose_graphs.reports import FragmentOverlap, RefinementReport
from ...registration.rigid import invert_pose

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
    depth_scale: float | None = None,
    depth_max: float = 3.0,
) -> int:
    """Fold a frame into a volume, its depth bent straight by a control grid on the way.

    Args:
        volume: What it is folded into; on the grid's device.
        grid: As `run_slac_optimizer_for_fragments` gives it.
        depth: Shape [h, w]; integers of 16 bits and more, or floats.
        intrinsic: The camera, of the picture's size.
        T_world_fragment: Pose of the frame's fragment, shape [4, 4], as the optimiser gives it.
        T_fragment_camera: Where in its fragment the frame was taken; None where the fragment began.
        color: uint8 [h, w, 3]; as of `TSDFVolume.integrate`.
        depth_scale: Units of depth a metre; None for 1000 of integers and 1 of floats.
        depth_max: Farthest depth used [m], before and after.

    Returns:
        The number of blocks touched.

    Raises:
        TypeError, ValueError, DeviceError: As `TSDFVolume.integrate` and `ControlGrid.deform_depth`. The volume stays
            as it was.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.rgbd.reconstruction.slac import integrate_deformed
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> depth, grid = np.full((48, 64), 1000, np.uint16), loom.reconstruction.ControlGrid()
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
    place = inv(step)
    if color is None:
        straight = grid.deform_depth(depth, intrinsic, place, depth_scale, depth_max)
        return volume.integrate(straight, intrinsic, invert_pose(matmul(T, step)), depth_max=depth_max)
    frame = RGBDImage(color, depth, depth_scale=depth_scale, depth_trunc=depth_max, device=grid.device)
    straight = grid.deform_rgbd(frame, intrinsic, place, depth_max=depth_max)
    given = straight.depth, intrinsic, invert_pose(matmul(T, step))
    return volume.integrate(*given, color=straight.color, depth_max=depth_max)
