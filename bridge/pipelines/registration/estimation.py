"""What ICP asks pairs to bring together, and what it returns."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....registration import result, rigid, robust_kernels
from ....registration.icp import estimation
from ...geometry import PointCloud
from ...held import Held, as_array, ours
from ...settings import Settings
from ...vectors import Vector2iVector


class RobustKernel(Settings):
    """A weight as a function of the residual; the kernels below are its kinds."""

    _kind = robust_kernels.RobustKernel

    def weight(self, residual: float) -> float:
        """How much a residual counts."""
        return float(self._ours.weight(residual))

    def __repr__(self) -> str:
        scale = "".join(f" with k={value:f}" for value in self._keywords().values())
        return f"RobustKernel::{type(self).__name__}{scale}"


@dataclass(eq=False, repr=False)
class L2Loss(RobustKernel):
    """Least squares."""

    _kind = robust_kernels.L2Loss


@dataclass(eq=False, repr=False)
class L1Loss(RobustKernel):
    """Least absolute residuals."""

    _kind = robust_kernels.L1Loss


@dataclass(eq=False, repr=False)
class HuberLoss(RobustKernel):
    """Least squares up to k, absolute residuals beyond."""

    _kind = robust_kernels.HuberLoss
    k: float


@dataclass(eq=False, repr=False)
class CauchyLoss(RobustKernel):
    """1 / (1 + (r / k)^2)."""

    _kind = robust_kernels.CauchyLoss
    k: float


@dataclass(eq=False, repr=False)
class GMLoss(RobustKernel):
    """Geman and McClure's, k a squared residual."""

    _kind = robust_kernels.GMLoss
    k: float


@dataclass(eq=False, repr=False)
class TukeyLoss(RobustKernel):
    """(1 - (r / k)^2)^2 up to k, zero beyond."""

    _kind = robust_kernels.TukeyLoss
    k: float


class TransformationEstimation(Settings):
    """How a pose follows from pairs; the estimations below are its kinds."""

    _kind = estimation.TransformationEstimation

    def _take_kernel(self, default: float) -> None:
        """Sort a kernel that was given alone, in the place of the number that comes first."""
        first, kernel = next(iter(self._keywords())), getattr(self, next(iter(self._keywords())))
        if isinstance(kernel, RobustKernel):
            self.kernel = kernel
            setattr(self, first, default)


@dataclass(eq=False, repr=False)
class TransformationEstimationPointToPoint(TransformationEstimation):
    """Least squared distances of the pairs."""

    _kind = estimation.TransformationEstimationPointToPoint
    with_scaling: bool = False

    def compute_transformation(self, source: Any, target: Any, corres: Any) -> NDArray[np.float64]:
        """The motion [4, 4] that brings pairs (source, target) together best."""
        p, q = _pairs(source, target, corres)
        return rigid.fit_pose(p, q, with_scaling=bool(self.with_scaling))

    def compute_rmse(self, source: Any, target: Any, corres: Any) -> float:
        """The root of the mean squared distance of pairs."""
        p, q = _pairs(source, target, corres)
        return float(np.sqrt(((p - q) ** 2).sum(axis=1).mean())) if len(p) else 0.0

    def __repr__(self) -> str:
        return f"TransformationEstimationPointToPoint(with_scaling={bool(self.with_scaling)})"


@dataclass(eq=False, repr=False)
class TransformationEstimationPointToPlane(TransformationEstimation):
    """Least squared distances from the target's planes."""

    _kind = estimation.TransformationEstimationPointToPlane
    kernel: RobustKernel = field(default_factory=L2Loss)


@dataclass(eq=False, repr=False)
class TransformationEstimationSymmetric(TransformationEstimation):
    """Both clouds' planes at once."""

    _kind = estimation.TransformationEstimationSymmetric
    kernel: RobustKernel = field(default_factory=L2Loss)


@dataclass(eq=False, repr=False)
class TransformationEstimationForColoredICP(TransformationEstimation):
    """Planes and colours; `(lambda_geometric)`, `(kernel)` or both."""

    _kind = estimation.TransformationEstimationForColoredICP
    lambda_geometric: Any = 0.968
    kernel: RobustKernel = field(default_factory=L2Loss)

    def __post_init__(self) -> None:
        super().__post_init__()
        self._take_kernel(0.968)

    def __repr__(self) -> str:
        return f"TransformationEstimationForColoredICP(lambda_geometric={self.lambda_geometric:g})"


@dataclass(eq=False, repr=False)
class TransformationEstimationForGeneralizedICP(TransformationEstimation):
    """Both clouds' planes as thin Gaussians; `(epsilon)`, `(kernel)` or both."""

    _kind = estimation.TransformationEstimationForGeneralizedICP
    epsilon: Any = 0.001
    kernel: RobustKernel = field(default_factory=L2Loss)

    def __post_init__(self) -> None:
        super().__post_init__()
        self._take_kernel(0.001)

    def __repr__(self) -> str:
        return f"TransformationEstimationForGeneralizedICP(epsilon={self.epsilon:g})"


class RegistrationResult(Held):
    """A pose, and how well the clouds lie on each other under it; its values are assigned, as in Open3D."""

    _kind = result.RegistrationResult

    def __init__(self, other: Any = None):
        given = ours(other, RegistrationResult, "arg0") if other is not None else self._none()
        vars(self).update(vars(self._of(given)))

    @staticmethod
    def _none() -> result.RegistrationResult:
        return result.RegistrationResult(np.eye(4), 0.0, 0.0, np.empty((0, 2), np.int32))

    @property
    def transformation(self) -> NDArray[np.float64]:
        """T_target_source, shape [4, 4]."""
        return self._held.transformation

    @transformation.setter
    def transformation(self, T: Any) -> None:
        self._held.transformation = np.array(T, np.float64)

    @property
    def fitness(self) -> float:
        """The share of the source's points with a correspondence."""
        return self._held.fitness

    @fitness.setter
    def fitness(self, share: float) -> None:
        self._held.fitness = float(share)

    @property
    def inlier_rmse(self) -> float:
        """The root of the mean squared distance of the correspondences."""
        return self._held.inlier_rmse

    @inlier_rmse.setter
    def inlier_rmse(self, rmse: float) -> None:
        self._held.inlier_rmse = float(rmse)

    @property
    def correspondence_set(self) -> Vector2iVector:
        """The correspondences (source, target)."""
        return Vector2iVector(np.asarray(self._held.correspondence_set))

    @correspondence_set.setter
    def correspondence_set(self, pairs: Any) -> None:
        vars(self._held)["correspondence_set"] = as_array(Vector2iVector(pairs))

    def __copy__(self) -> RegistrationResult:
        made = self._none()
        made.transformation, made.fitness, made.inlier_rmse = self.transformation.copy(), self.fitness, self.inlier_rmse
        copied = RegistrationResult._of(made)
        copied.correspondence_set = self.correspondence_set
        return copied

    def __repr__(self) -> str:
        numbers = f"fitness={self.fitness:e}, inlier_rmse={self.inlier_rmse:e}"
        count = len(self._held.correspondence_set)
        return (
            f"RegistrationResult with {numbers}, and correspondence_set size of {count}\n"
            "Access transformation to get result."
        )


def _pairs(source: Any, target: Any, corres: Any) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    pairs = as_array(Vector2iVector(corres))
    clouds = ours(source, PointCloud, "source"), ours(target, PointCloud, "target")
    return clouds[0].points[pairs[:, 0]], clouds[1].points[pairs[:, 1]]
