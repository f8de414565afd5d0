"""ICP with a fixed estimator, under Open3D's names."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from numpy.typing import ArrayLike

from ...core.argument_errors import explain_argument_errors
from ...pcd.cloud import PointCloud
from ..result import RegistrationResult
from .constraint import Prior
from .estimation import (
    TransformationEstimationForColoredICP,
    TransformationEstimationForGeneralizedICP,
    TransformationEstimationSymmetric,
)
from .icp import ICPConvergenceCriteria, registration_icp


@explain_argument_errors
def registration_colored_icp(
    source: PointCloud,
    target: PointCloud,
    max_correspondence_distance: float,
    init: ArrayLike | None = None,
    estimation_method: TransformationEstimationForColoredICP | None = None,
    criteria: ICPConvergenceCriteria | None = None,
    *,
    overlap: float | None = 1.0,
    free: Sequence[str] | None = None,
    frame: ArrayLike | None = None,
    pivot: ArrayLike | None = None,
    prior: Prior | None = None,
    weights: ArrayLike | str | None = None,
    noise: float | None = None,
) -> RegistrationResult:
    """`registration_icp` with TransformationEstimationForColoredICP: both clouds need colors, the target normals."""
    method = TransformationEstimationForColoredICP() if estimation_method is None else estimation_method
    options: Any = {"free": free, "frame": frame, "pivot": pivot, "prior": prior, "weights": weights, "noise": noise}
    pair = source, target, max_correspondence_distance, init
    return registration_icp(*pair, method, criteria, overlap=overlap, **options)


@explain_argument_errors
def registration_generalized_icp(
    source: PointCloud,
    target: PointCloud,
    max_correspondence_distance: float,
    init: ArrayLike | None = None,
    estimation_method: TransformationEstimationForGeneralizedICP | None = None,
    criteria: ICPConvergenceCriteria | None = None,
    *,
    overlap: float | None = 1.0,
    free: Sequence[str] | None = None,
    frame: ArrayLike | None = None,
    pivot: ArrayLike | None = None,
    prior: Prior | None = None,
    weights: ArrayLike | str | None = None,
    noise: float | None = None,
) -> RegistrationResult:
    """`registration_icp` with TransformationEstimationForGeneralizedICP."""
    method = TransformationEstimationForGeneralizedICP() if estimation_method is None else estimation_method
    options: Any = {"free": free, "frame": frame, "pivot": pivot, "prior": prior, "weights": weights, "noise": noise}
    pair = source, target, max_correspondence_distance, init
    return registration_icp(*pair, method, criteria, overlap=overlap, **options)


@explain_argument_errors
def registration_symmetric_icp(
    source: PointCloud,
    target: PointCloud,
    max_correspondence_distance: float,
    init: ArrayLike | None = None,
    estimation_method: TransformationEstimationSymmetric | None = None,
    criteria: ICPConvergenceCriteria | None = None,
    *,
    overlap: float | None = 1.0,
    weights: ArrayLike | str | None = None,
) -> RegistrationResult:
    """`registration_icp` with TransformationEstimationSymmetric: both clouds need normals."""
    method = TransformationEstimationSymmetric() if estimation_method is None else estimation_method
    pair = source, target, max_correspondence_distance, init
    return registration_icp(*pair, method, criteria, overlap=overlap, weights=weights)
