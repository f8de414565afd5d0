"""Robust kernels and the estimators of the ICP family."""

from __future__ import annotations

from dataclasses import field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....registration import rigid, robust_kernels
from ....registration.icp import estimation
from ...argument_errors import as_runtime_errors
from ...argument_types import CloudLike, VectorLike
from ...geometry import PointCloud
from ...settings import Settings
from ...vectors import Vector2iVector
from ...wrapper import as_array, unwrap
from .pairs import fit_step, residual_rmse


class RobustKernel(Settings, of=robust_kernels):
    """Base class of robust kernels: weight as a function of the residual."""

    def weight(self, residual: float) -> float:
        return float(self.native.weight(residual))

    def __repr__(self) -> str:
        scale = "".join(f" with k={value:f}" for value in self.native_keywords().values())
        return f"RobustKernel::{type(self).__name__}{scale}"


class L2Loss(RobustKernel, of=robust_kernels):
    pass


class L1Loss(RobustKernel, of=robust_kernels):
    pass


class HuberLoss(RobustKernel, of=robust_kernels):
    k: float


class CauchyLoss(RobustKernel, of=robust_kernels):
    """1 / (1 + (r / k)^2)."""

    k: float


class GMLoss(RobustKernel, of=robust_kernels):
    """Geman-McClure; k is a squared residual."""

    k: float


class TukeyLoss(RobustKernel, of=robust_kernels):
    """(1 - (r / k)^2)^2 up to k, zero beyond."""

    k: float


class TransformationEstimation(Settings, of=estimation):
    """Base class of the estimators."""

    @as_runtime_errors
    def compute_transformation(self, source: CloudLike, target: CloudLike, corres: VectorLike) -> NDArray[np.float64]:
        """The step (4, 4) of one iteration from pairs (source, target). The identity without pairs."""
        return fit_step(*clouds_of(source, target), as_array(Vector2iVector(corres)), self.native)

    @as_runtime_errors
    def compute_rmse(self, source: CloudLike, target: CloudLike, corres: VectorLike) -> float:
        """Root mean square of the residuals of the pairs that `compute_transformation` minimizes, without a kernel."""
        return residual_rmse(*clouds_of(source, target), as_array(Vector2iVector(corres)), self.native)

    def _take_kernel(self, default: float) -> None:
        """Reassign a kernel that was given in place of the first number."""
        first, kernel = next(iter(self.native_keywords())), getattr(self, next(iter(self.native_keywords())))
        if isinstance(kernel, RobustKernel):
            self.kernel = kernel
            setattr(self, first, default)


class TransformationEstimationPointToPoint(TransformationEstimation, of=estimation):
    with_scaling: bool = False

    @as_runtime_errors
    def compute_transformation(self, source: CloudLike, target: CloudLike, corres: VectorLike) -> NDArray[np.float64]:
        """Least-squares transformation (4, 4) of pairs (source, target)."""
        p, q = _pairs(source, target, corres)
        return rigid.fit_pose(p, q, with_scaling=bool(self.with_scaling)) if len(p) else np.eye(4)

    @as_runtime_errors
    def compute_rmse(self, source: CloudLike, target: CloudLike, corres: VectorLike) -> float:
        p, q = _pairs(source, target, corres)
        return float(np.sqrt(((p - q) ** 2).sum(axis=1).mean())) if len(p) else 0.0

    def __repr__(self) -> str:
        return f"TransformationEstimationPointToPoint(with_scaling={bool(self.with_scaling)})"


class TransformationEstimationPointToPlane(TransformationEstimation, of=estimation):
    kernel: RobustKernel = field(default_factory=L2Loss)


class TransformationEstimationSymmetric(TransformationEstimation, of=estimation):
    """Point to plane with the normals of both clouds."""

    kernel: RobustKernel = field(default_factory=L2Loss)


class TransformationEstimationForColoredICP(TransformationEstimation, of=estimation):
    """Planes and colors; `(lambda_geometric)`, `(kernel)` or both."""

    lambda_geometric: Any = 0.968
    kernel: RobustKernel = field(default_factory=L2Loss)

    def __post_init__(self) -> None:
        super().__post_init__()
        self._take_kernel(0.968)

    def __repr__(self) -> str:
        return f"TransformationEstimationForColoredICP(lambda_geometric={self.lambda_geometric:g})"


class _GivenCovariances(estimation.TransformationEstimationForGeneralizedICP):
    flattens_covariances = False


class TransformationEstimationForGeneralizedICP(TransformationEstimation, of=estimation):
    """Planes of both clouds as flat Gaussians, given covariances as they are; `(epsilon)`, `(kernel)` or both."""

    epsilon: Any = 0.001
    kernel: RobustKernel = field(default_factory=L2Loss)

    def __post_init__(self) -> None:
        super().__post_init__()
        self._take_kernel(0.001)

    @property
    def native(self) -> estimation.TransformationEstimation:
        return _GivenCovariances(**self.native_keywords())

    def __repr__(self) -> str:
        return f"TransformationEstimationForGeneralizedICP(epsilon={self.epsilon:g})"


def clouds_of(source: CloudLike, target: CloudLike) -> tuple[Any, Any]:
    """The two pointloom clouds."""
    return unwrap(source, PointCloud, "source"), unwrap(target, PointCloud, "target")


def _pairs(source: CloudLike, target: CloudLike, corres: VectorLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    clouds, pairs = clouds_of(source, target), as_array(Vector2iVector(corres))
    return clouds[0].points[pairs[:, 0]], clouds[1].points[pairs[:, 1]]
