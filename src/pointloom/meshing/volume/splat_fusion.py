"""Surface of Gaussian splats by fusion of rendered depth."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera
from ...cameras.depth_range import UNLIMITED_DEPTH
from ...core.checks import check_list, check_positive, check_progress, check_rigid
from ...core.progress import ReportProgress
from ...kernels.linear_algebra import inv, matmul, norm
from ...kernels.splats.blending import color_surface
from ...pcd.splat_images import surface_before
from ...pcd.splats import GaussianSplats
from ..mesh.mesh import TriangleMesh
from .tsdf import TSDFVolume

DEFAULT_VIEWS = 60  # default views of an object
TRUNCATION_VOXELS = 3.0  # voxels
MAX_VOXELS = 1 << 20  # along an axis
PIXELS_PER_VOXEL = 3.0  # image pixels per voxel
MIN_SIDE, MAX_SIDE = 64, 1200  # [px] of the rendered images
CAMERA_DISTANCE = 2.5  # camera distance in radii
OUTLIER_FRACTION = 0.02  # fraction of splats outside the radius: floating fog


def fuse_splats(
    splats: GaussianSplats,
    intrinsic: PinholeCameraIntrinsic | None = None,
    extrinsics: Sequence[ArrayLike] | None = None,
    *,
    voxel_size: float,
    truncation: float | None = None,
    depth_max: float = UNLIMITED_DEPTH,
    weight_threshold: float = 2.0,
    progress: ReportProgress | None = None,
) -> TriangleMesh:
    """Extract the surface of splats as a colored mesh by TSDF fusion of median depths (`GaussianSplats.rasterize`).

    Args:
        splats: The splats. Remove fog first with `splats.clean`.
        intrinsic: The camera. If None: that of the default views.
        extrinsics: T_camera_world of each view, such as those of the training images. If None: 60 views around an
            object.
        voxel_size: Edge of a voxel [m].
        truncation: As of TSDFVolume, default 3 voxels: splat depths have no noise.
        depth_max: Maximum depth used [m].
        weight_threshold: A cell needs more views than this at all 8 voxels.
        progress: Called with "fuse splats", the finished and all views.

    Returns:
        The mesh, as `TSDFVolume.extract_triangle_mesh`, on the splats' device. Bitwise reproducible.

    Raises:
        ValueError, TypeError: If there are no splats, camera and views do not fit, a pose is not rigid, a size is not
            positive, or no view sees a surface, or if `splats` or the camera has another type.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> ball = loom.TriangleMesh.create_sphere(1.0).compute_vertex_normals()
        >>> cloud = ball.sample_points_uniformly(4000, seed=0)
        >>> scales, turns = np.full((4000, 3), 0.04), np.tile([1.0, 0, 0, 0], (4000, 1))
        >>> splats = loom.GaussianSplats(cloud.points, scales, turns, np.full(4000, 0.9), np.zeros((4000, 3)))
        >>> mesh = loom.meshing.fuse_splats(splats, voxel_size=0.05)
        >>> bool(np.median(abs(np.linalg.norm(mesh.vertices, axis=1) - 1)) < 0.05)  # splats are 0.04 thick
        True
    """
    if not isinstance(splats, GaussianSplats):
        raise TypeError(f"splats: expected GaussianSplats, got {type(splats).__name__}")
    if not len(splats):
        raise ValueError("splats: expected at least one splat, got none")
    if (intrinsic is None) != (extrinsics is None):
        raise ValueError("extrinsics: expected intrinsic and extrinsics together, or neither for views from all sides")
    report = check_progress(progress)
    farthest = check_positive("depth_max", depth_max, allow_infinite=True)
    edge = check_positive("voxel_size", voxel_size)
    extent = float(np.ptp(splats.centers, axis=0).max())
    if extent > MAX_VOXELS * edge:
        raise ValueError(
            f"voxel_size: {voxel_size} m is too small for splats {extent:g} m across. Use about {extent / 1000:g} m"
        )
    limit = TRUNCATION_VOXELS * edge if truncation is None else check_positive("truncation", truncation)
    if limit > MAX_VOXELS * edge:
        raise ValueError(f"truncation: {truncation} m is too large for voxels of {voxel_size} m. 3 voxels are usual")
    if intrinsic is None or extrinsics is None:
        intrinsic, poses = views_around(splats.centers, edge)
    else:
        check_camera("intrinsic", intrinsic)
        given = check_list("extrinsics", extrinsics, "poses")
        poses = [check_rigid(f"extrinsics[{i}]", T) for i, T in enumerate(given)]
    volume = TSDFVolume(voxel_size=voxel_size, truncation=limit, device=splats.device)
    for done, T in enumerate(poses):
        report("fuse splats", done, len(poses))
        seen = surface_before(splats, intrinsic, T)
        T_world_camera, colors = inv(T), color_surface(seen)
        try:
            volume.integrate_device_frame(seen.medians, intrinsic, T_world_camera, colors, depth_max=farthest)
        except ValueError as error:
            raise ValueError(f"voxel_size, truncation: {error}") from None
    mesh = volume.extract_triangle_mesh(weight_threshold)
    if not len(mesh.triangles):
        raise ValueError(f"extrinsics: no surface is visible in more than {weight_threshold:g} of {len(poses)} views")
    return mesh


def views_around(
    centers: NDArray[np.float64], voxel_size: float
) -> tuple[PinholeCameraIntrinsic, list[NDArray[np.float64]]]:
    """A camera and poses evenly distributed on a sphere around the centers."""
    middle = np.median(centers, axis=0)
    radius = float(np.quantile(np.linalg.norm(centers - middle, axis=1), 1 - OUTLIER_FRACTION))
    away = CAMERA_DISTANCE * max(radius, 1e-9)
    side = int(min(max(PIXELS_PER_VOXEL * 2 * radius / voxel_size, MIN_SIDE), MAX_SIDE))
    focal = 0.5 * side * math.sqrt(CAMERA_DISTANCE**2 - 1)
    camera = PinholeCameraIntrinsic(side, side, focal, focal, 0.5 * (side - 1), 0.5 * (side - 1))
    poses = []
    for k in range(DEFAULT_VIEWS):
        z = 1 - (2 * k + 1) / DEFAULT_VIEWS
        angle = k * math.pi * (3 - math.sqrt(5))
        around = math.sqrt(1 - z * z)
        forward = -np.array([around * math.cos(angle), around * math.sin(angle), z])
        right = np.cross([0.0, 0.0, -1.0], forward) if around > 0.05 else np.array([1.0, 0.0, 0.0])
        right = right - matmul(right, forward) * forward
        right /= norm(right)
        T = np.eye(4)
        T[:3, :3] = np.stack([right, np.cross(forward, right), forward])
        T[:3, 3] = matmul(-T[:3, :3], middle - away * forward)
        poses.append(T)
    return camera, poses
