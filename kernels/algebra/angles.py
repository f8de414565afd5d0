"""The arctangent by sums, products and roots alone, so that it has the same bits on every device and compiler.

x is halved in angle three times (tan(a / 2) = tan a / (1 + sqrt(1 + tan^2 a))), which leaves at most pi / 32, and nine
terms of the series: 4e-16 off at most.
"""

from ..lang import cross, dot, float64, func, length, sqrt, vec3d

QUARTER = 1.5707963267948966
HALF = 3.141592653589793


@func
def half_tangent(t: float64) -> float64:
    """The tangent of half the angle whose tangent is t."""
    return t / (float64(1.0) + sqrt(float64(1.0) + t * t))


@func
def arctangent(y: float64, x: float64) -> float64:
    """The angle of the direction (x, y), -pi to pi; 0 where both are zero."""
    ax = x if x >= float64(0.0) else -x
    ay = y if y >= float64(0.0) else -y
    large = max(ax, ay)
    t = float64(0.0)
    if large > float64(0.0):
        t = half_tangent(half_tangent(half_tangent(min(ax, ay) / large)))
    s = t * t
    series = float64(1.0) / float64(15.0) - s * (float64(1.0) / float64(17.0))
    series = float64(1.0) / float64(13.0) - s * series
    series = float64(1.0) / float64(11.0) - s * series
    series = float64(1.0) / float64(9.0) - s * series
    series = float64(1.0) / float64(7.0) - s * series
    series = float64(1.0) / float64(5.0) - s * series
    series = float64(1.0) / float64(3.0) - s * series
    angle = float64(8.0) * t * (float64(1.0) - s * series)
    if ay > ax:
        angle = float64(QUARTER) - angle
    if x < float64(0.0):
        angle = float64(HALF) - angle
    return angle if y >= float64(0.0) else -angle


@func
def angle_between(u: vec3d, v: vec3d) -> float64:
    """The angle between two vectors, 0 to pi."""
    return arctangent(length(cross(u, v)), dot(u, v))
