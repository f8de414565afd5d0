"""The ICP family, and how well clouds lie on each other."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....registration.icp import evaluation, icp
from ...geometry import PointCloud
from ...held import ours
from ...settings import Settings
from .estimation import (
    RegistrationResult,
    TransformationEstimation,
    TransformationEstimationForColoredICP,
    TransformationEstimationForGeneralizedICP,
    TransformationEstimationPointToPoint,
    TransformationEstimationSymmetric,
)

IDENTITY = np.eye(4)


@dataclass(eq=False, repr=False)
class ICPConvergenceCriteria(Settings):
    """When iterations end: both changes below their limits, or the iterations used up."""

    _kind = icp.ICPConvergenceCriteria
    relative_fitness: Any = 1e-6
    relative_rmse: float = 1e-6
    max_iteration: int = 30

    def __repr__(self) -> str:
        limits = f"relative_fitness={self.relative_fitness:e}, relative_rmse={self.relative_rmse:e}"
        return f"ICPConvergenceCriteria({limits}, max_iteration={self.max_iteration})"


def registration_icp(
    source: Any,
    target: Any,
    max_correspondence_distance: float,
    init: ArrayLike = IDENTITY,
    estimation_method: Any = None,
    criteria: Any = None,
) -> RegistrationResult:
    """Bring a source onto a target from a pose nearby."""
    method = TransformationEstimationPointToPoint() if estimation_method is None else estimation_method
    return _register(source, target, max_correspondence_distance, init, method, criteria, TransformationEstimation)


def registration_colored_icp(
    source: Any,
    target: Any,
    max_correspondence_distance: float,
    init: ArrayLike = IDENTITY,
    estimation_method: Any = None,
    criteria: Any = None,
) -> RegistrationResult:
    """By planes and colours: both clouds need colours, the target normals."""
    kind = TransformationEstimationForColoredICP
    method = kind() if estimation_method is None else estimation_method
    return _register(source, target, max_correspondence_distance, init, method, criteria, kind)


def registration_generalized_icp(
    source: Any,
    target: Any,
    max_correspondence_distance: float,
    init: ArrayLike = IDENTITY,
    estimation_method: Any = None,
    criteria: Any = None,
) -> RegistrationResult:
    """By both clouds' planes as thin Gaussians."""
    kind = TransformationEstimationForGeneralizedICP
    method = kind() if estimation_method is None else estimation_method
    return _register(source, target, max_correspondence_distance, init, method, criteria, kind)


def registration_symmetric_icp(
    source: Any,
    target: Any,
    max_correspondence_distance: float,
    init: ArrayLike = IDENTITY,
    estimation_method: Any = None,
    criteria: Any = None,
) -> RegistrationResult:
    """By both clouds' planes: both need normals."""
    kind = TransformationEstimationSymmetric
    method = kind() if estimation_method is None else estimation_method
    return _register(source, target, max_correspondence_distance, init, method, criteria, kind)


def evaluate_registration(
    source: Any, target: Any, max_correspondence_distance: float, transformation: ArrayLike = IDENTITY
) -> RegistrationResult:
    """Fitness, rmse and correspondences under a pose."""
    clouds = clouds_of(source, target)
    return RegistrationResult._of(
        evaluation.evaluate_registration(*clouds, max_correspondence_distance, transformation)
    )


def get_information_matrix_from_point_clouds(
    source: Any, target: Any, max_correspondence_distance: float, transformation: ArrayLike
) -> NDArray[np.float64]:
    """How firmly the correspondences hold each of the six motions, shape [6, 6]."""
    clouds = clouds_of(source, target)
    return evaluation.get_information_matrix_from_point_clouds(*clouds, max_correspondence_distance, transformation)


def clouds_of(source: Any, target: Any) -> tuple[Any, Any]:
    """Our two clouds."""
    return ours(source, PointCloud, "source"), ours(target, PointCloud, "target")


def _register(
    source: Any,
    target: Any,
    distance: float,
    init: ArrayLike,
    method: Any,
    criteria: Any,
    kind: type[TransformationEstimation],
) -> RegistrationResult:
    rules = ICPConvergenceCriteria() if criteria is None else criteria
    found = icp.registration_icp(
        *clouds_of(source, target),
        distance,
        init,
        ours(method, kind, "estimation_method"),
        ours(rules, ICPConvergenceCriteria, "criteria"),
    )
    return RegistrationResult._of(found)
