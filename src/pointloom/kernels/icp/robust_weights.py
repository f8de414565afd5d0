"""Weights w(r) = rho'(r) / r of iteratively reweighted least squares, as in Open3D: Zhang 1997, table 1, Open3D's
Geman-McClure k / (k + r^2)^2, and the general kernel of Barron 2019, eq. 9.
"""

from ..lang import exp, float64, func, pow, struct

GEOMETRY_ONLY = -1  # not a kernel: rows that only measure which motions are determined
L2_LOSS = 0
L1_LOSS = 1
HUBER_LOSS = 2
CAUCHY_LOSS = 3
GEMAN_MCCLURE = 4
TUKEY_LOSS = 5
GENERAL_LOSS = 6
MIN_RESIDUAL = 1.0e-9  # [m] lower limit of |r|: exact matches get a large finite weight
TO_TWO = 2.0e-3  # closer shapes count as 2, as in Open3D
TO_ZERO = 1.0e-8
MINUS_INFINITY = -1.0e7  # smaller shapes use the limit at minus infinity


@struct
class Loss:
    """A robust kernel: `kind` is one of the constants above. Scale `k` in the residual's unit; `shape` if general."""

    kind: int
    k: float64
    shape: float64

    def __init__(self, kind: int, k: float, shape: float) -> None:
        self.kind, self.k, self.shape = kind, k, shape


@func
def general_weight(r: float64, k: float64, shape: float64) -> float64:
    square = (r / k) * (r / k)
    weight = float64(1.0)
    if abs(shape - 2.0) <= float64(TO_TWO):
        weight = 1.0
    elif abs(shape) <= float64(TO_ZERO):
        weight = 2.0 / (square + 2.0)
    elif shape < float64(MINUS_INFINITY):
        weight = exp(-float64(0.5) * square)
    else:
        base = square / abs(shape - 2.0) + 1.0
        weight = pow(base, 0.5 * shape - 1.0)
    return weight / (k * k)


@func
def robust_weight(loss: Loss, r: float64) -> float64:
    size = abs(r)
    weight = float64(1.0)
    if loss.kind == L1_LOSS:
        weight = 1.0 / max(size, float64(MIN_RESIDUAL))
    if loss.kind == HUBER_LOSS:
        weight = loss.k / max(size, loss.k)
    if loss.kind == CAUCHY_LOSS:
        weight = 1.0 / (1.0 + (r / loss.k) * (r / loss.k))
    if loss.kind == GEMAN_MCCLURE:
        weight = loss.k / ((loss.k + r * r) * (loss.k + r * r))
    if loss.kind == TUKEY_LOSS:
        rest = 1.0 - min(1.0, size / loss.k) * min(1.0, size / loss.k)
        weight = rest * rest
    if loss.kind == GENERAL_LOSS:
        weight = general_weight(r, loss.k, loss.shape)
    return weight
