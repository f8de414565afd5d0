"""ICP of clouds of tensors, from one scale or from coarse to fine, and the evaluation of a pose."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import field
from functools import partial
from typing import Any

import numpy as np

from .....pcd.cloud import PointCloud
from .....registration import result
from .....registration.icp import evaluation, multi_scale
from .....registration.icp import icp as native_icp
from ....argument_types import TensorCloud, TensorLike
from ....core.device import Device
from ....core.dtype import float64, int64
from ....core.tensor import Tensor
from ....pipelines.registration import globally
from ....settings import Settings
from ....wrapper import unwrap
from ..tensors import as_matrix, on_host, tensor_of
from .clouds import clouds_of
from .estimation import (
    IDENTITY_POSE,
    TransformationEstimation,
    TransformationEstimationPointToPoint,
    TransformationEstimationSymmetric,
)

Callback = Callable[[dict[str, Tensor]], Any]


class ICPConvergenceCriteria(globally.ICPConvergenceCriteria):
    """A scale ends if both absolute changes are below their limits, or after `max_iteration`."""

    def __repr__(self) -> str:
        limits = f"relative_fitness_={self.relative_fitness:e}, relative_rmse={self.relative_rmse:e}"
        return f"ICPConvergenceCriteria[{limits}, max_iteration_={self.max_iteration}]."


class RegistrationResult(Settings):
    """T_target_source (4, 4), float64 on the CPU, and its quality.

    `correspondence_set`: target index of each source point, or -1, int64 (n, 1). Both are those of the downsampled
    clouds if the last voxel size is positive.
    """

    transformation: Any = field(default_factory=lambda: as_matrix(IDENTITY_POSE))
    correspondence_set: Any = field(default_factory=lambda: tensor_of([], int64))
    inlier_rmse: float = 0.0
    fitness: float = 0.0
    converged: bool = False
    num_iterations: int = 0

    def __setattr__(self, name: str, value: Any) -> None:
        super().__setattr__(name, Tensor(value) if isinstance(value, np.ndarray) else value)

    def __repr__(self) -> str:
        state = f"converged={str(self.converged).lower()}, num_iteration={self.num_iterations}"
        numbers = f"fitness_={self.fitness:e}, inlier_rmse={self.inlier_rmse:e}"
        count = self.correspondence_set.shape[0]
        return f"RegistrationResult[{state}, {numbers}, correspondences={count}].\nAccess transformation to get result."


def icp(
    source: TensorCloud,
    target: TensorCloud,
    max_correspondence_distance: float,
    init_source_to_target: TensorLike = IDENTITY_POSE,
    estimation_method: TransformationEstimation | None = None,
    criteria: ICPConvergenceCriteria | None = None,
    voxel_size: float = -1.0,
    callback_after_iteration: Callback | None = None,
) -> RegistrationResult:
    """ICP of clouds downsampled by `voxel_size` [m], or of all points if it is not positive."""
    rules = ICPConvergenceCriteria() if criteria is None else criteria
    start, distances = init_source_to_target, [max_correspondence_distance]
    options = estimation_method, callback_after_iteration
    return multi_scale_icp(source, target, [voxel_size], [rules], distances, start, *options)


def multi_scale_icp(
    source: TensorCloud,
    target: TensorCloud,
    voxel_sizes: Iterable[float],
    criteria_list: Sequence[Any],
    max_correspondence_distances: Iterable[float],
    init_source_to_target: TensorLike = IDENTITY_POSE,
    estimation_method: TransformationEstimation | None = None,
    callback_after_iteration: Callback | None = None,
) -> RegistrationResult:
    """ICP from coarse to fine. The last voxel size may be -1 for all points. Grids go through zero.

    The callback gets tensors on the CPU by name: iteration_index, scale_index and scale_iteration_index from 0, and
    transformation, fitness and inlier_rmse after that iteration.
    """
    method = TransformationEstimationPointToPoint() if estimation_method is None else estimation_method
    native = unwrap(method, TransformationEstimation, "estimation_method")
    rules = [_native_criteria("criteria_list", criteria) for criteria in criteria_list]
    sizes, distances = multi_scale._check_scales([*voxel_sizes], [*max_correspondence_distances], rules)
    levels = _pyramid(clouds_of(source, target), sizes)
    pose, steps = on_host(init_source_to_target), 0
    found: Any = None
    point_count = 0
    for scale, (clouds, distance, limits) in enumerate(zip(levels, distances, rules, strict=True)):
        watch = None if callback_after_iteration is None else partial(_call, callback_after_iteration, scale, steps)
        found = native_icp.registration_icp(*clouds, distance, pose, native, limits, callback_after_iteration=watch)
        pose, steps, point_count = found.transformation, steps + found.iterations, len(clouds[0])
        if not found.fitness:
            break
    found.iterations = steps
    return _result_of(found, point_count, source.device)


def registration_symmetric_icp(
    source: TensorCloud,
    target: TensorCloud,
    max_correspondence_distance: float,
    init_source_to_target: TensorLike = IDENTITY_POSE,
    estimation_method: TransformationEstimation | None = None,
    criteria: ICPConvergenceCriteria | None = None,
) -> RegistrationResult:
    """Symmetric point-to-plane ICP: both clouds need normals."""
    method = TransformationEstimationSymmetric() if estimation_method is None else estimation_method
    unwrap(method, TransformationEstimationSymmetric, "estimation_method")
    return icp(source, target, max_correspondence_distance, init_source_to_target, method, criteria)


def evaluate_registration(
    source: TensorCloud,
    target: TensorCloud,
    max_correspondence_distance: float,
    transformation: TensorLike = IDENTITY_POSE,
) -> RegistrationResult:
    clouds = clouds_of(source, target)
    found = evaluation.evaluate_registration(*clouds, max_correspondence_distance, on_host(transformation))
    return _result_of(found, len(clouds[0]), source.device)


def get_information_matrix(
    source: TensorCloud, target: TensorCloud, max_correspondence_distance: float, transformation: TensorLike
) -> Tensor:
    """Information matrix of the correspondences, (6, 6), float64 on the CPU. Zero without any."""
    pose = on_host(transformation)
    return as_matrix(
        evaluation.get_information_matrix_from_point_clouds(
            *clouds_of(source, target), max_correspondence_distance, pose
        )
    )


def _native_criteria(name: str, criteria: object) -> Any:
    return unwrap(criteria, globally.ICPConvergenceCriteria, name)


def _pyramid(clouds: tuple[PointCloud, PointCloud], sizes: list[float]) -> list[tuple[PointCloud, PointCloud]]:
    """Both clouds at each scale, coarsest first, each downsampled from the next finer one."""
    levels = []
    for size in reversed(sizes):
        if size:
            source, target = (cloud.voxel_down_sample_and_trace(size, np.zeros(3)).cloud for cloud in clouds)
            clouds = source, target
        levels.insert(0, clouds)
    return levels


def _call(callback: Callback, scale: int, steps: int, state: dict[str, Any]) -> None:
    """Call a callback of Open3D with a state of pointloom. `steps`: iterations of the coarser scales."""
    own = state["iteration_index"] - 1
    indices = {"iteration_index": steps + own, "scale_index": scale, "scale_iteration_index": own}
    measured = {name: state[name] for name in ("transformation", "fitness", "inlier_rmse")}
    callback(
        {name: tensor_of(value, int64) for name, value in indices.items()}
        | {name: tensor_of(value, float64) for name, value in measured.items()}
    )


def _result_of(found: result.RegistrationResult, point_count: int, device: Device) -> RegistrationResult:
    pairs, targets = on_host(found.correspondence_set), np.full((point_count, 1), -1, np.int64)
    targets[pairs[:, 0], 0] = pairs[:, 1]
    return RegistrationResult(
        as_matrix(found.transformation),
        tensor_of(targets, int64, device),
        float(found.inlier_rmse),
        float(found.fitness),
        bool(found.converged),
        int(found.iterations),
    )
