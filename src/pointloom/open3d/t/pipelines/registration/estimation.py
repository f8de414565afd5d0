"""The estimators of the ICP family."""

from __future__ import annotations

from dataclasses import field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .....registration import rigid
from .....registration.icp import estimation
from ....argument_types import TensorCloud, TensorLike
from ....core.tensor import Tensor
from ....pipelines.registration.pairs import fit_step, residual_rmse
from ....settings import Settings
from ....wrapper import IDENTITY_POSE
from ..tensors import as_matrix, on_host
from .clouds import clouds_of, pairs_of, points_of
from .robust_kernel import RobustKernel

Points = NDArray[np.float64]


class TransformationEstimation(Settings, of=estimation):
    """Base class of the estimators. `correspondences`: target index of each source point, or -1, int64 (n,)."""

    def __setattr__(self, name: str, value: Any) -> None:
        super().__setattr__(name, RobustKernel(value) if isinstance(value, RobustKernel) else value)

    def compute_transformation(
        self,
        source: TensorCloud,
        target: TensorCloud,
        correspondences: TensorLike,
        current_transform: TensorLike = IDENTITY_POSE,
        iteration: int = 0,
    ) -> Tensor:
        """The step (4, 4) of one iteration, float64 on the CPU. Only Doppler ICP uses `current_transform`."""
        clouds = clouds_of(source, target)
        return as_matrix(fit_step(*clouds, pairs_of(correspondences, len(clouds[0])), self.native))

    def compute_rmse(self, source: TensorCloud, target: TensorCloud, correspondences: TensorLike) -> float:
        """Root mean square of the residuals of the pairs that `compute_transformation` minimizes, without a kernel."""
        clouds = clouds_of(source, target)
        return residual_rmse(*clouds, pairs_of(correspondences, len(clouds[0])), self.native)


class TransformationEstimationPointToPoint(TransformationEstimation, of=estimation):
    def __init__(self, other: object = None):
        """`other` is one to copy."""

    def compute_transformation(
        self,
        source: TensorCloud,
        target: TensorCloud,
        correspondences: TensorLike,
        current_transform: TensorLike = IDENTITY_POSE,
        iteration: int = 0,
    ) -> Tensor:
        """Least-squares motion (4, 4) of the pairs, float64 on the CPU."""
        p, q = _points_of(source, target, correspondences)
        return as_matrix(rigid.fit_pose(p, q) if len(p) else IDENTITY_POSE)

    def compute_rmse(self, source: TensorCloud, target: TensorCloud, correspondences: TensorLike) -> float:
        p, q = _points_of(source, target, correspondences)
        return float(np.sqrt(((p - q) ** 2).sum(axis=1).mean())) if len(p) else 0.0


class TransformationEstimationPointToPlane(TransformationEstimation, of=estimation):
    kernel: Any = field(default_factory=RobustKernel)


class TransformationEstimationSymmetric(TransformationEstimation, of=estimation):
    """Point to plane with the normals of both clouds."""

    kernel: Any = field(default_factory=RobustKernel)


class TransformationEstimationForColoredICP(TransformationEstimation, of=estimation):
    """Planes and colors; `(lambda_geometric)`, `(kernel)` or both."""

    lambda_geometric: Any = 0.968
    kernel: Any = field(default_factory=RobustKernel)

    def __post_init__(self) -> None:
        super().__post_init__()
        if isinstance(self.lambda_geometric, RobustKernel):
            self.kernel, self.lambda_geometric = self.lambda_geometric, 0.968

    def __repr__(self) -> str:
        return f"TransformationEstimationForColoredICP with lambda_geometric: {self.lambda_geometric:f}"


class _DopplerFields(TransformationEstimation):
    period: Any = 0.1
    lambda_doppler: float = 0.01
    reject_dynamic_outliers: bool = False
    doppler_outlier_threshold: float = 2.0
    outlier_rejection_min_iteration: int = 2
    geometric_robust_loss_min_iteration: int = 0
    doppler_robust_loss_min_iteration: int = 2
    geometric_kernel: Any = field(default_factory=RobustKernel)
    doppler_kernel: Any = field(default_factory=RobustKernel)
    transform_vehicle_to_sensor: Any = field(default_factory=lambda: as_matrix(IDENTITY_POSE))


class TransformationEstimationForDopplerICP(_DopplerFields, of=estimation):
    """Planes and radial velocities: all fields, or `(lambda_doppler)` alone.

    The source needs the attribute "dopplers" [m/s]; "directions" are those of its points without it.
    """

    def __init__(self, *fields: Any, **named: Any):
        if len(fields) == 1 and not named and not isinstance(fields[0], TransformationEstimation):
            fields, named = (), {"lambda_doppler": fields[0]}
        super().__init__(*fields, **named)

    def __setattr__(self, name: str, value: Any) -> None:
        super().__setattr__(name, as_matrix(value) if name == "transform_vehicle_to_sensor" else value)

    def native_keywords(self) -> dict[str, Any]:
        return super().native_keywords() | {"transform_vehicle_to_sensor": on_host(self.transform_vehicle_to_sensor)}

    def compute_transformation(
        self,
        source: TensorCloud,
        target: TensorCloud,
        correspondences: TensorLike,
        current_transform: TensorLike = IDENTITY_POSE,
        iteration: int = 0,
    ) -> Tensor:
        """The step (4, 4) of iteration `iteration` of a source that has been moved by `current_transform`."""
        clouds, current = clouds_of(source, target), on_host(current_transform)
        pairs = pairs_of(correspondences, len(clouds[0]))
        return as_matrix(fit_step(*clouds, pairs, self.native, current, iteration))

    def compute_rmse(self, source: TensorCloud, target: TensorCloud, correspondences: TensorLike) -> float:
        """Root mean square of the point-to-plane residuals, as in Open3D without the velocities."""
        return TransformationEstimationPointToPlane().compute_rmse(source, target, correspondences)

    def __repr__(self) -> str:
        return f"TransformationEstimationForDopplerICP with lambda_doppler: {self.lambda_doppler:f}"


def _points_of(source: TensorCloud, target: TensorCloud, correspondences: TensorLike) -> tuple[Points, Points]:
    """Positions (k, 3) of the pairs, float64."""
    p, q = points_of("source", source), points_of("target", target)
    pairs = pairs_of(correspondences, len(p))
    return p[pairs[:, 0]], q[pairs[:, 1]]
