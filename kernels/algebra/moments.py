"""Moments of points about a point: their count, sums and products, and the covariance that they give."""

from ..lang import float64, func, mat33d, vec3, vector

ROUNDER = 786432.0  # 1.5 * 2^19: what is added to it loses all bits below 2^-33
moments = vector(10, float64)  # count; x, y, z; xx, xy, xz, yy, yz, zz


@func
def add_rounded_difference(total: moments, p: vec3, q: vec3) -> moments:
    """Add the count, the components and the products of q - p, rounded to float32: for points close together."""
    x = float64(q[0] - p[0])
    y = float64(q[1] - p[1])
    z = float64(q[2] - p[2])
    return total + moments(1.0, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)


@func
def covariance_of(m: moments) -> mat33d:
    """The covariance [m^2] about the mean, divided by the count."""
    s = 1.0 / max(m[0], 1.0)
    x = m[1] * s
    y = m[2] * s
    z = m[3] * s
    xy = m[5] * s - x * y
    xz = m[6] * s - x * z
    yz = m[8] * s - y * z
    return mat33d(m[4] * s - x * x, xy, xz, xy, m[7] * s - y * y, yz, xz, yz, m[9] * s - z * z)


@func
def add_difference(total: moments, p: vec3, q: vec3) -> moments:
    """Add the count, the components and the products of q - p, which is exact in float64."""
    x = float64(q[0]) - float64(p[0])
    y = float64(q[1]) - float64(p[1])
    z = float64(q[2]) - float64(p[2])
    return total + moments(1.0, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)


@func
def in_steps(x: float64) -> float64:
    """A number up to one, rounded to a step: sums of up to 2^20 such numbers are exact, hence the same in any order."""
    return (x + float64(ROUNDER)) - float64(ROUNDER)
