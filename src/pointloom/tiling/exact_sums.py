"""Exact sums of float64 numbers and their squares, independent of order and grouping."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

_LOW_BITS = 27
_FRACTION_BITS = 1200  # unit 2^-1200: below half the smallest float64


@dataclass(frozen=True)
class ExactSums:
    """Count, `total` in units of 2^-1200, and `squares` in units of 2^-2400."""

    count: int = 0
    total: int = 0
    squares: int = 0

    @classmethod
    def of(cls, values: NDArray[np.float64]) -> ExactSums:
        """Sums of the finite values."""
        values = values[np.isfinite(values)]
        mantissas, exponents = np.frexp(values)
        integers = np.ldexp(mantissas, 53).astype(np.int64)
        high, low = integers >> _LOW_BITS, integers & ((1 << _LOW_BITS) - 1)
        total = squares = 0
        for exponent in np.unique(exponents).tolist():
            here = exponents == exponent
            a, b = high[here], low[here]
            scale = exponent - 53 + _FRACTION_BITS
            total += ((_sum(a) << _LOW_BITS) + _sum(b)) << scale
            square = (_sum(a * a) << 2 * _LOW_BITS) + (_sum(a * b) << (_LOW_BITS + 1)) + _sum(b * b)
            squares += square << 2 * scale
        return cls(len(values), total, squares)

    def __add__(self, other: ExactSums) -> ExactSums:
        return ExactSums(self.count + other.count, self.total + other.total, self.squares + other.squares)

    def mean_and_deviation(self) -> tuple[float, float]:
        """Mean and standard deviation with n - 1, rounded once or twice. NaN if empty."""
        if not self.count:
            return math.nan, math.nan
        mean = Fraction(self.total, self.count << _FRACTION_BITS)
        if self.count == 1:
            return float(mean), 0.0
        spread = Fraction(self.squares, 1 << 2 * _FRACTION_BITS) - self.count * mean * mean
        return float(mean), math.sqrt(spread / (self.count - 1))


def _sum(values: NDArray[np.int64]) -> int:
    """Sum of integers below 2^54, in halves that cannot overflow."""
    return (int((values >> 27).sum()) << 27) + int((values & ((1 << 27) - 1)).sum())
