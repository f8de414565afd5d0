"""Robust kernels: their scale `k` is assigned, as in Open3D."""

from __future__ import annotations

from dataclasses import dataclass

from ....registration import robust_kernels
from ...settings import Settings


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
