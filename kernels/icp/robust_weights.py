"""Weights of iteratively re-weighted least squares, w(r) = rho'(r) / r, as Open3D defines them.

Zhang 1997, table 1, but for Geman-McClure, which is Open3D's k / (k + r^2)^2; the general kernel is Barron 2019, eq. 9
with its special cases.
"""

from ..lang import exp, float64, func, pow

GEOMETRY = -1  # not a kernel: rows that only tell which motions the clouds determine
L2 = 0
L1 = 1
HUBER = 2
CAUCHY = 3
GEMAN_MCCLURE = 4
TUKEY = 5
GENERAL = 6
LEAST_RESIDUAL = 1.0e-9  # [m] where 1/|r| ends: an exact match outweighs others a millionfold, not infinitely
TO_TWO = 2.0e-3  # shapes as near to 2 as this are 2, as Open3D has it
TO_ZERO = 1.0e-8
MINUS_INFINITY = -1.0e7  # shapes below are the limit at minus infinity


@func
def general_weight(r: float64, k: float64, shape: float64) -> float64:
    """Barron's kernel with scale k."""
    square = (r / k) * (r / k)
    weight = float64(1.0)
    if abs(shape - float64(2.0)) <= float64(TO_TWO):
        weight = float64(1.0)
    elif abs(shape) <= float64(TO_ZERO):
        weight = float64(2.0) / (square + float64(2.0))
    elif shape < float64(MINUS_INFINITY):
        weight = exp(-float64(0.5) * square)
    else:
        base = square / abs(shape - float64(2.0)) + float64(1.0)
        weight = pow(base, float64(0.5) * shape - float64(1.0))
    return weight / (k * k)


@func
def robust_weight(kind: int, k: float64, shape: float64, r: float64) -> float64:
    """The weight of a residual under a kernel with scale k; `shape` is the general kernel's."""
    size = abs(r)
    weight = float64(1.0)
    if kind == L1:
        weight = float64(1.0) / max(size, float64(LEAST_RESIDUAL))
    if kind == HUBER:
        weight = k / max(size, k)
    if kind == CAUCHY:
        weight = float64(1.0) / (float64(1.0) + (r / k) * (r / k))
    if kind == GEMAN_MCCLURE:
        weight = k / ((k + r * r) * (k + r * r))
    if kind == TUKEY:
        rest = float64(1.0) - min(float64(1.0), size / k) * min(float64(1.0), size / k)
        weight = rest * rest
    if kind == GENERAL:
        weight = general_weight(r, k, shape)
    return weight
