"""Moments of points about a point: their count, sums and products, and the covariance that they give."""

from ..lang import float64, func, int64, mat33d, vec3, vector

WHOLE = 1099511627776.0  # 2^40: steps of a unit in whole moments, so that 2^22 neighbours fit
moments = vector(10, float64)  # count; x, y, z; xx, xy, xz, yy, yz, zz
whole_moments = vector(10, int64)  # the same in steps, and of products in steps of the unit's square


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
def whole_steps(x: float64) -> int64:
    """A number in whole steps, cut towards zero."""
    return int64(x * float64(WHOLE))


@func
def add_whole_difference(total: whole_moments, p: vec3, q: vec3, scale: float64) -> whole_moments:
    """Add the count, the components and the products of q - p, which is no longer than one by a scale, a power of two.

    Sums of whole numbers are the same in any order: neighbours that are met in another order give the same bits.
    """
    x = (float64(q[0]) - float64(p[0])) * scale
    y = (float64(q[1]) - float64(p[1])) * scale
    z = (float64(q[2]) - float64(p[2])) * scale
    sums = whole_moments(
        1, whole_steps(x), whole_steps(y), whole_steps(z), whole_steps(x * x), whole_steps(x * y), whole_steps(x * z),
        whole_steps(y * y), whole_steps(y * z), whole_steps(z * z),
    )  # fmt: skip
    return total + sums


@func
def moments_in_units(total: whole_moments) -> moments:
    """Whole moments as moments of lengths in units."""
    sums = moments(0.0)
    for k in range(10):
        sums[k] = float64(total[k]) / float64(WHOLE)
    sums[0] = float64(total[0])
    return sums
