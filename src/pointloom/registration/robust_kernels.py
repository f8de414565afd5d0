"""Robust kernels for iteratively re-weighted least squares."""

from __future__ import annotations

import dataclasses
import math
from functools import cached_property
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_number, check_numeric, check_positive
from ..kernels.icp import robust_weights
from ..kernels.linear_algebra import elementwise

MIN_RESIDUAL = robust_weights.MIN_RESIDUAL


@dataclasses.dataclass(frozen=True)
class RobustKernel:
    """A robust kernel, which maps a residual to a weight: the base class of the kernels.

    The scale `k` has the residual's unit: meters for point-to-plane, none for generalized ICP.

    Example:
        >>> import pointloom as loom
        >>> loom.registration.HuberLoss(0.5).weight([0.1, 1.0, 2.0]).tolist()
        [1.0, 0.5, 0.25]
    """

    kind: ClassVar[int] = robust_weights.L2_LOSS
    _internal: ClassVar[tuple[str, ...]] = ("kind", "loss", "parameters")

    @property
    def parameters(self) -> tuple[int, float, float]:
        """(kind, scale, shape) for device code."""
        return self.kind, float(getattr(self, "k", 1.0)), float(getattr(self, "shape", 1.0))

    @cached_property
    def loss(self) -> robust_weights.Loss:
        """The parameters for kernels."""
        return robust_weights.Loss(*self.parameters)

    def weight(self, residual: ArrayLike) -> NDArray[np.float64]:
        """Weights of residuals, float64 of the same shape."""
        r = np.abs(check_numeric("residual", residual).astype(np.float64))
        with np.errstate(over="ignore"):  # the square may be infinite, with weight 0
            return np.asarray(self._weight(r), np.float64)

    def _weight(self, r: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.ones_like(r)


@dataclasses.dataclass(frozen=True)
class L2Loss(RobustKernel):
    """Least squares: all weights are 1."""


@dataclasses.dataclass(frozen=True)
class Geometry(RobustKernel):
    """Not a kernel: for rows that only determine degenerate motions."""

    kind = robust_weights.GEOMETRY_ONLY


@dataclasses.dataclass(frozen=True)
class L1Loss(RobustKernel):
    """Least absolute residuals: `1 / |r|`, clamped at 1e-9 (Open3D divides by zero there)."""

    kind = robust_weights.L1_LOSS

    def _weight(self, r: NDArray[np.float64]) -> NDArray[np.float64]:
        return 1 / np.maximum(r, MIN_RESIDUAL)


@dataclasses.dataclass(frozen=True)
class _Scaled(RobustKernel):
    k: float

    def __post_init__(self) -> None:
        check_positive("k", self.k)


@dataclasses.dataclass(frozen=True)
class HuberLoss(_Scaled):
    """`k / max(|r|, k)`: least squares up to k, absolute residuals beyond."""

    kind = robust_weights.HUBER_LOSS

    def _weight(self, r: NDArray[np.float64]) -> NDArray[np.float64]:
        return self.k / np.maximum(r, self.k)


@dataclasses.dataclass(frozen=True)
class CauchyLoss(_Scaled):
    """1 / (1 + (r / k)^2)."""

    kind = robust_weights.CAUCHY_LOSS

    def _weight(self, r: NDArray[np.float64]) -> NDArray[np.float64]:
        return 1 / (1 + (r / self.k) ** 2)


@dataclasses.dataclass(frozen=True)
class GMLoss(_Scaled):
    """k / (k + r^2)^2, Open3D's form of the Geman-McClure kernel: k is a squared residual."""

    kind = robust_weights.GEMAN_MCCLURE

    def _weight(self, r: NDArray[np.float64]) -> NDArray[np.float64]:
        return self.k / (self.k + r * r) ** 2


@dataclasses.dataclass(frozen=True)
class TukeyLoss(_Scaled):
    """(1 - (r / k)^2)^2 up to k, zero beyond."""

    kind = robust_weights.TUKEY_LOSS

    def _weight(self, r: NDArray[np.float64]) -> NDArray[np.float64]:
        return (1 - np.minimum(1, r / self.k) ** 2) ** 2


@dataclasses.dataclass(frozen=True)
class GeneralizedLoss(_Scaled):
    """Barron's general kernel: shape 2 is least squares, 1 pseudo-Huber, 0 Cauchy, -2 Geman-McClure, -inf Welsch.

    Args:
        k: Scale, where weights begin to fall.
        shape: Barron's alpha, at most 2.

    Notes:
        Barron, "A general and adaptive robust loss function", CVPR 2019, eq. 9, with his factor 1 / k^2.
    """

    shape: float = 1.0
    kind = robust_weights.GENERAL_LOSS

    def __post_init__(self) -> None:
        super().__post_init__()
        if not check_number("shape", self.shape, allow_nan=True, allow_infinite=True) <= 2:
            raise ValueError(f"shape: expected a number up to 2, got {self.shape!r}")

    @property
    def parameters(self) -> tuple[int, float, float]:
        """(kind, scale, shape) for device code."""
        return self.kind, float(self.k), max(float(self.shape), -1e30)

    def _weight(self, r: NDArray[np.float64]) -> NDArray[np.float64]:
        square, shape = (r / self.k) ** 2, self.shape
        if abs(shape - 2) <= robust_weights.TO_TWO:
            weights = np.ones_like(r)
        elif abs(shape) <= robust_weights.TO_ZERO:
            weights = 2 / (square + 2)
        elif shape < robust_weights.MINUS_INFINITY:
            weights = elementwise(math.exp, -square / 2)
        else:
            weights = elementwise(math.pow, square / abs(shape - 2) + 1, shape / 2 - 1)
        return weights / self.k**2
