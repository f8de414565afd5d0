"""Angles from square roots and a polynomial only: bitwise identical on every device and compiler."""

from ..lang import cross, dot, float64, func, length, sqrt, vec3d

PI = 3.141592653589793
LAST_POWER = 23  # of the series: truncation error tan(pi / 16) ^ 25 / 25 = 1e-19


@func
def arc_tangent(t: float64) -> float64:
    """atan t for t in 0 .. tan(pi / 16), by its series."""
    square = t * t
    total = float64(0.0)
    terms = int((LAST_POWER + 1) // 2)
    for k in range(terms):
        total = 1.0 / float64(LAST_POWER - 2 * k) - square * total
    return t * total


@func
def angle_of(sine: float64, cosine: float64) -> float64:
    """Angle [rad] in 0 .. pi from a sine >= 0 and a cosine of common scale. 0 for (0, 0)."""
    scale = sqrt(sine * sine + cosine * cosine)
    angle = float64(0.0)
    if scale > 0.0:
        t = sine / (scale + abs(cosine))  # tangent of half the angle to the nearer side
        t = t / (1.0 + sqrt(1.0 + t * t))
        t = t / (1.0 + sqrt(1.0 + t * t))
        angle = 8.0 * arc_tangent(t)
        if cosine < 0.0:
            angle = float64(PI) - angle
    return angle


@func
def arctangent(y: float64, x: float64) -> float64:
    """Angle [rad] of the direction (x, y), -pi to pi. 0 for zero."""
    size = y if y >= 0.0 else -y
    angle = angle_of(size, x)
    return angle if y >= 0.0 else -angle


@func
def angle_between(u: vec3d, v: vec3d) -> float64:
    return angle_of(length(cross(u, v)), dot(u, v))
