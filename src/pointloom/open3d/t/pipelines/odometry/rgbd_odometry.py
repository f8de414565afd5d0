"""RGB-D odometry of images of tensors, with Open3D's weights."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .....kernels.rgbd import open3d_rows as rows
from .....rgbd.odometry import options, rgbd_odometry
from .....rgbd.odometry.options import OdometryMethod as Method
from ....core.tensor import Tensor
from ....settings import Settings
from ....wrapper import unwrap
from ..tensors import as_matrix, on_host
from .images import flat, flat_vectors, plane_of, rgbd_of

IDENTITY = np.eye(4)
PointToPlane, Intensity, Hybrid = Method


@dataclass(eq=False, repr=False)
class OdometryConvergenceCriteria(Settings):
    """A level ends if both relative changes are below their limits, or after `max_iteration`."""

    _kind = options.OdometryConvergenceCriteria
    max_iteration: Any
    relative_rmse: float = 1e-6
    relative_fitness: float = 1e-6

    def __repr__(self) -> str:
        limits = f"relative_rmse={self.relative_rmse:e}, relative_fitness={self.relative_fitness:e}"
        return f"OdometryConvergenceCriteria(max_iteration={self.max_iteration}, {limits})"


@dataclass(eq=False, repr=False)
class OdometryLossParams(Settings):
    """Largest depth difference of a pair [m], and Huber limits of depth [m] and intensity (0..1)."""

    _kind = options.OdometryLossParams
    depth_outlier_trunc: Any = 0.07
    depth_huber_delta: float = 0.05
    intensity_huber_delta: float = 0.1

    def __repr__(self) -> str:
        return f"OdometryLossParams[{', '.join(f'{name}={value:e}' for name, value in self._keywords().items())}]."


@dataclass(eq=False, repr=False)
class OdometryResult(Settings):
    """T_target_source (4, 4), float64 on the CPU. As in Open3D, `inlier_rmse` is the mean Huber loss of the pairs."""

    transformation: Any = field(default_factory=lambda: as_matrix(IDENTITY))
    inlier_rmse: float = 0.0
    fitness: float = 0.0

    def __setattr__(self, name: str, value: Any) -> None:
        super().__setattr__(name, Tensor(value) if isinstance(value, np.ndarray) else value)

    def __repr__(self) -> str:
        numbers = f"fitness={self.fitness:e}, inlier_rmse={self.inlier_rmse:e}"
        return f"OdometryResult[{numbers}].\nAccess transformation to get result."


def rgbd_odometry_multi_scale(
    source: Any,
    target: Any,
    intrinsics: Any,
    init_source_to_target: Any = IDENTITY,
    depth_scale: float = 1000.0,
    depth_max: float = 3.0,
    criteria_list: Sequence[Any] | None = None,
    method: Method = Hybrid,
    params: Any = None,
) -> OdometryResult:
    """Motion between two images, the coarsest level first. Raises RuntimeError if the pixels do not determine it.

    Uses Open3D's weights without further checks. `loom.rgbd.align_frames` weights by noise and reports failures.
    """
    frames = rgbd_of("source", source, depth_scale), rgbd_of("target", target, depth_scale)
    return align(*frames, intrinsics, init_source_to_target, depth_max, criteria_list, method, params)


def align(
    source: Any,
    target: Any,
    intrinsics: Any,
    start: Any,
    depth_max: float,
    criteria_list: Sequence[Any] | None,
    method: Method,
    params: Any,
) -> OdometryResult:
    """`rgbd_odometry_multi_scale` of pointloom's images."""
    criteria = None if criteria_list is None else [
        unwrap(one, OdometryConvergenceCriteria, "criteria_list") for one in criteria_list
    ]  # fmt: skip
    found = rgbd_odometry.open3d_multi_scale_odometry(
        source,
        target,
        on_host(intrinsics),
        on_host(start),
        depth_max,
        criteria,
        method,
        None if params is None else unwrap(params, OdometryLossParams, "params"),
    )
    if found.warnings:
        raise RuntimeError(f"source, target: {'; '.join(found.warnings)}")
    return OdometryResult(as_matrix(found.transformation), float(found.inlier_rmse), float(found.fitness))


def compute_odometry_information_matrix(
    source_depth: Any,
    target_depth: Any,
    intrinsic: Any,
    source_to_target: Any,
    dist_threshold: float,
    depth_scale: float = 1000.0,
    depth_max: float = 3.0,
) -> Tensor:
    """Information matrix (6, 6) of pixel pairs within `dist_threshold` [m], float64 on the CPU."""
    depths = plane_of(source_depth.as_tensor()), plane_of(target_depth.as_tensor())
    camera, pose = on_host(intrinsic), on_host(source_to_target)
    limits = dist_threshold, depth_scale, depth_max
    return as_matrix(rgbd_odometry.compute_odometry_information_matrix(*depths, camera, pose, *limits))


def compute_odometry_result_point_to_plane(
    source_vertex_map: Tensor,
    target_vertex_map: Tensor,
    target_normal_map: Tensor,
    intrinsics: Any,
    init_source_to_target: Any,
    depth_outlier_trunc: float,
    depth_huber_delta: float,
) -> OdometryResult:
    """One step from vertices and normals (h, w, 3), NaN if missing. `transformation` is the increment."""
    depths = [flat(vertices[:, :, 2]) for vertices in (source_vertex_map, target_vertex_map)]
    rules = rows.Open3DRules(rows.TENSOR, rows.PLANE, depth_outlier_trunc, depth_huber_delta)
    level = _level(source_vertex_map, intrinsics, depths[1], depths[1])
    level.normals = flat_vectors(target_normal_map)
    return _step(depths[0], depths[0], level, init_source_to_target, rules)


def compute_odometry_result_intensity(
    source_depth: Tensor,
    target_depth: Tensor,
    source_intensity: Tensor,
    target_intensity: Tensor,
    target_intensity_dx: Tensor,
    target_intensity_dy: Tensor,
    source_vertex_map: Tensor,
    intrinsics: Any,
    init_source_to_target: Any,
    depth_outlier_trunc: float,
    intensity_huber_delta: float,
) -> OdometryResult:
    """One step from intensities and their Sobel gradients (h, w, 1). Depth [m], NaN if missing."""
    rules = rows.Open3DRules(rows.TENSOR, rows.COLOR, depth_outlier_trunc, 0.0, intensity_huber_delta)
    level = _level(source_depth, intrinsics, flat(target_depth), flat(target_intensity))
    level.along, level.down = flat(target_intensity_dx), flat(target_intensity_dy)
    return _step(flat(source_depth), flat(source_intensity), level, init_source_to_target, rules)


def compute_odometry_result_hybrid(
    source_depth: Tensor,
    target_depth: Tensor,
    source_intensity: Tensor,
    target_intensity: Tensor,
    target_depth_dx: Tensor,
    target_depth_dy: Tensor,
    target_intensity_dx: Tensor,
    target_intensity_dy: Tensor,
    source_vertex_map: Tensor,
    intrinsics: Any,
    init_source_to_target: Any,
    depth_outlier_trunc: float,
    depth_huber_delta: float,
    intensity_huber_delta: float,
) -> OdometryResult:
    """One step from intensities, depths [m], NaN if missing, and the Sobel gradients of both (h, w, 1)."""
    deltas, root = (depth_huber_delta, intensity_huber_delta), rgbd_odometry.HALF_ROOT
    rules = rows.Open3DRules(rows.TENSOR, rows.HYBRID, depth_outlier_trunc, *deltas, root, root)
    level = _level(source_depth, intrinsics, flat(target_depth), flat(target_intensity))
    level.along, level.down = flat(target_intensity_dx), flat(target_intensity_dy)
    level.depth_along, level.depth_down = flat(target_depth_dx), flat(target_depth_dy)
    return _step(flat(source_depth), flat(source_intensity), level, init_source_to_target, rules)


def _level(image: Tensor, intrinsics: Any, depth: Any, shade: Any) -> rows.Open3DLevel:
    """A target level of the size of an image, with gradients that the caller replaces if they are used."""
    matrix, (height, width) = on_host(intrinsics), image.shape[:2]
    lens = np.array([matrix[0, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2]])
    return rgbd_odometry._level((width, height), lens, depth, shade)


def _step(depth: Any, shade: Any, level: rows.Open3DLevel, start: Any, rules: rows.Open3DRules) -> OdometryResult:
    sums = rgbd_odometry._sum(depth, shade, level, on_host(start).astype(np.float64), rules)
    count = sums[rows.COUNT]
    step = rgbd_odometry._solve(sums) if count else None
    if step is None:
        raise RuntimeError("init_source_to_target: the pixels do not determine the motion from this pose")
    return OdometryResult(as_matrix(step), float(sums[rows.SQUARES] / count), float(count / depth.size))
