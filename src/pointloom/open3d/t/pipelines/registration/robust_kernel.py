"""The module `robust_kernel`: kernels by name."""

from __future__ import annotations

import enum
from typing import Any

from .....registration import robust_kernels
from ....settings import Settings


class RobustKernelMethod(enum.Enum):
    """Names of the robust kernels."""

    L2Loss, L1Loss, HuberLoss, CauchyLoss, GMLoss, TukeyLoss, GeneralizedLoss = range(7)


L2Loss, L1Loss, HuberLoss, CauchyLoss, GMLoss, TukeyLoss, GeneralizedLoss = RobustKernelMethod


class RobustKernel(Settings):
    """A kernel of pointloom by its name, with its scale `k`. The shape is that of GeneralizedLoss."""

    type: Any = L2Loss
    scaling_parameter: float = 1.0
    shape_parameter: float = 1.0

    @property
    def native(self) -> robust_kernels.RobustKernel:
        if not isinstance(self.type, RobustKernelMethod):
            raise TypeError(f"type: expected a RobustKernelMethod, got {self.type!r}")
        kind = getattr(robust_kernels, self.type.name)
        if self.type in (L2Loss, L1Loss):
            return kind()
        shape = [self.shape_parameter] if self.type is GeneralizedLoss else []
        return kind(self.scaling_parameter, *shape)

    def __repr__(self) -> str:
        scale, shape = self.scaling_parameter, self.shape_parameter
        return f"RobustKernel[scaling_parameter_={scale:e}, shape_parameter_={shape:e}]."
