"""RGB-D odometry of images of tensors, with Open3D's weights."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field
from typing import Any

import numpy as np

from .....cameras.images import RGBDImage
from .....rgbd.odometry import options, rgbd_odometry
from .....rgbd.odometry.options import OdometryMethod as Method
from ....argument_types import TensorFrame, TensorImage, TensorLike
from ....core.tensor import Tensor
from ....settings import Settings
from ....wrapper import IDENTITY_POSE, unwrap
from ..tensors import as_matrix, on_host
from .images import plane_of, rgbd_of

PointToPlane, Intensity, Hybrid = Method


class OdometryConvergenceCriteria(Settings, of=options):
    """A level ends if both relative changes are below their limits, or after `max_iteration`."""

    max_iteration: Any
    relative_rmse: float = 1e-6
    relative_fitness: float = 1e-6

    def __repr__(self) -> str:
        limits = f"relative_rmse={self.relative_rmse:e}, relative_fitness={self.relative_fitness:e}"
        return f"OdometryConvergenceCriteria(max_iteration={self.max_iteration}, {limits})"


class OdometryLossParams(Settings, of=options):
    """Largest depth difference of a pair [m], and Huber limits of depth [m] and intensity (0..1)."""

    depth_outlier_trunc: Any = 0.07
    depth_huber_delta: float = 0.05
    intensity_huber_delta: float = 0.1

    def __repr__(self) -> str:
        return (
            f"OdometryLossParams[{', '.join(f'{name}={value:e}' for name, value in self.native_keywords().items())}]."
        )


class OdometryResult(Settings):
    """T_target_source (4, 4), float64 on the CPU. As in Open3D, `inlier_rmse` is the mean Huber loss of the pairs."""

    transformation: Any = field(default_factory=lambda: as_matrix(IDENTITY_POSE))
    inlier_rmse: float = 0.0
    fitness: float = 0.0

    def __setattr__(self, name: str, value: Any) -> None:
        super().__setattr__(name, Tensor(value) if isinstance(value, np.ndarray) else value)

    def __repr__(self) -> str:
        numbers = f"fitness={self.fitness:e}, inlier_rmse={self.inlier_rmse:e}"
        return f"OdometryResult[{numbers}].\nAccess transformation to get result."


def rgbd_odometry_multi_scale(
    source: TensorFrame,
    target: TensorFrame,
    intrinsics: TensorLike,
    init_source_to_target: TensorLike = IDENTITY_POSE,
    depth_scale: float = 1000.0,
    depth_max: float = 3.0,
    criteria_list: Sequence[Any] | None = None,
    method: Method = Hybrid,
    params: OdometryLossParams | None = None,
) -> OdometryResult:
    """Motion between two images, the coarsest level first. Raises RuntimeError if the pixels do not determine it.

    Uses Open3D's weights without further checks. `loom.rgbd.align_frames` weights by noise and reports failures.
    """
    frames = rgbd_of("source", source, depth_scale), rgbd_of("target", target, depth_scale)
    return align(*frames, intrinsics, init_source_to_target, depth_max, criteria_list, method, params)


def align(
    source: RGBDImage,
    target: RGBDImage,
    intrinsics: TensorLike,
    start: TensorLike,
    depth_max: float,
    criteria_list: Sequence[Any] | None,
    method: Method,
    params: OdometryLossParams | None,
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
    source_depth: TensorImage,
    target_depth: TensorImage,
    intrinsic: TensorLike,
    source_to_target: TensorLike,
    dist_threshold: float,
    depth_scale: float = 1000.0,
    depth_max: float = 3.0,
) -> Tensor:
    """Information matrix (6, 6) of pixel pairs within `dist_threshold` [m], float64 on the CPU."""
    depths = plane_of(source_depth.as_tensor()), plane_of(target_depth.as_tensor())
    camera, pose = on_host(intrinsic), on_host(source_to_target)
    limits = dist_threshold, depth_scale, depth_max
    return as_matrix(rgbd_odometry.compute_odometry_information_matrix(*depths, camera, pose, *limits))
