"""Moments of points about a point, and their covariance. Quantized moments do not depend on the order of points."""

from ..lang import bits_float, float64, float_bits, floor, func, int64, mat33d, vec3, vector

moments = vector(10, float64)  # count; x, y, z; xx, xy, xz, yy, yz, zz
integer_moments = vector(10, int64)  # the same of differences in integer steps
MAX_EXACT_POINTS = 131072  # points whose integer moments fit into 64 bits: products have 46
STEP_FACTOR = 2.0**-8  # step factor for up to 2^33 points


@func
def steps_for(sqdist: float, count: int) -> float:
    """Steps per meter for differences up to sqrt(sqdist): 2^23 in the next power of two, less if sums overflow."""
    power = ((float_bits(sqdist) >> 23) - 125) >> 1  # sqdist < 4^power
    steps = bits_float((150 - power) << 23)
    if count > MAX_EXACT_POINTS:
        steps = steps * STEP_FACTOR
    return steps


@func
def integer_steps(length: float, steps: float) -> int64:
    """A difference [m] in integer steps, rounded."""
    return int64(int(floor(length * steps + 0.5)))


@func
def add_integer_moments(total: integer_moments, p: vec3, q: vec3, steps: float) -> integer_moments:
    """Add the float32-rounded moments of q - p for near points."""
    x = integer_steps(q[0] - p[0], steps)
    y = integer_steps(q[1] - p[1], steps)
    z = integer_steps(q[2] - p[2], steps)
    return total + integer_moments(int64(1), x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)


@func
def in_meters(m: integer_moments, steps: float) -> moments:
    """Integer moments in meters and square meters."""
    s = 1.0 / float64(steps)
    t = s * s
    return moments(
        float64(m[0]), float64(m[1]) * s, float64(m[2]) * s, float64(m[3]) * s, float64(m[4]) * t, float64(m[5]) * t,
        float64(m[6]) * t, float64(m[7]) * t, float64(m[8]) * t, float64(m[9]) * t,
    )  # fmt: skip


@func
def add_rounded_difference(total: moments, p: vec3, q: vec3) -> moments:
    """Add the float32-rounded moments of q - p for near points, in float64."""
    x = float64(q[0] - p[0])
    y = float64(q[1] - p[1])
    z = float64(q[2] - p[2])
    return total + moments(1.0, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)


@func
def covariance_of(m: moments) -> mat33d:
    """Covariance [m^2] about the mean, divided by the count."""
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
    """Add the moments of q - p, exact in float64."""
    x = float64(q[0]) - float64(p[0])
    y = float64(q[1]) - float64(p[1])
    z = float64(q[2]) - float64(p[2])
    return total + moments(1.0, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)
