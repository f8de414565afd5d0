"""Exact tests of a ball on three points: its side, its center, and whether it contains a fourth point.

Formulas and sources: ball_faces.py.
"""

from ..algebra.transform import widen
from ..lang import cross, dot, float64, func, sqrt, vec3, vec3d

RELATIVE_ROUNDING = 1.0e-14  # times the magnitudes: some 45 ulp, three times the rounding of the polynomial
MIN_NORMAL_AGREEMENT = 1.0e-15  # times the lengths: a perpendicular normal agrees with a face, as in Open3D
MIN_SINE_SQUARED = 1.0e-20  # squared sine of the angle below which three float32 points are collinear
CENTER_ACCURACY = 1.0e-10  # times the magnitudes: accuracy of a center for the thinnest triangle allowed
TIE_STEPS = 4  # more than the indices of four points


@func
def side_of_normals(n: vec3d, a: vec3, b: vec3, c: vec3) -> int:
    """1 if a face with normal n agrees with the normals of its corners, -1 if its back does, else 0."""
    p = widen(a)
    q = widen(b)
    r = widen(c)
    x = dot(n, p)
    y = dot(n, q)
    z = dot(n, r)
    size = sqrt(dot(n, n)) * float64(MIN_NORMAL_AGREEMENT)
    side = 0
    if x + y + z > 0.0:
        side = 1
    if x + y + z < 0.0:
        side = -1
    s = float64(side)
    if s * x < -size * sqrt(dot(p, p)) or s * y < -size * sqrt(dot(q, q)) or s * z < -size * sqrt(dot(r, r)):
        side = 0
    return side


@func
def root_of_ball(b: vec3d, c: vec3d, radius: float64) -> float64:
    """sqrt(R) of the ball on 0, b and c, or -1 if collinear or if the circle is larger than the ball."""
    n = cross(b, c)
    nn = dot(n, n)
    bb = dot(b, b)
    cc = dot(c, c)
    d = b - c
    scale = 4.0 * radius * radius * nn
    rest = scale - bb * cc * dot(d, d)
    root = float64(-1.0)
    if nn > float64(MIN_SINE_SQUARED) * bb * cc and rest >= -scale * float64(RELATIVE_ROUNDING):
        root = sqrt(max(rest, 0.0))
    return root


@func
def ball_center(b: vec3d, c: vec3d, root: float64, side: int) -> vec3d:
    n = cross(b, c)
    k = cross(n, b) * dot(c, c) + cross(c, n) * dot(b, b)
    return (k + n * (root * float64(side))) * (0.5 / dot(n, n))


@func
def width_of_circle(b: vec3d, c: vec3d, radius: float64) -> float:
    """Squared radius of the circle through 0, b and c as a fraction of the ball's."""
    n = cross(b, c)
    d = b - c
    return float(dot(b, b) * dot(c, c) * dot(d, d) / (4.0 * radius * radius * dot(n, n)))


@func
def sign_of(x: float64, bound: float64) -> int:
    sign = 0
    if x > bound:
        sign = 1
    if x < -bound:
        sign = -1
    return sign


@func
def weigh_tie(on_a: int, on_b: int, on_c: int, a: int, b: int, c: int, d: int) -> int:
    """1 if D on the ball of A, B and C counts as inside, else -1. The lowest index with a coordinate != 0 decides."""
    decided = 0
    passed = -1
    for step in range(TIE_STEPS):
        lowest = d
        sign = -1
        if d <= passed:
            sign = 0
            lowest = 0x7FFFFFFF
        if a > passed and a < lowest:
            lowest = a
            sign = on_a
        if b > passed and b < lowest:
            lowest = b
            sign = on_b
        if c > passed and c < lowest:
            lowest = c
            sign = on_c
        passed = lowest
        if decided == 0:
            decided = sign
    return -decided


@func
def break_tie(b: vec3d, c: vec3d, d: vec3d, root: float64, side: int, ia: int, ib: int, ic: int, at: int) -> int:
    """1 if d, on the ball on 0, b and c, counts as inside, else -1."""
    n = cross(b, c)
    lengths = sqrt(dot(b, b) * dot(c, c))
    v = b - d
    w = c - d
    on_a = 0
    on_b = 0
    on_c = 0
    if (
        abs(dot(d, n)) <= float64(RELATIVE_ROUNDING) * sqrt(dot(d, d)) * lengths
    ):  # in the plane of the others: on their circle
        on_a = sign_of(dot(n, cross(v, w)), float64(RELATIVE_ROUNDING) * lengths * sqrt(dot(v, v) * dot(w, w)))
        on_b = sign_of(dot(n, cross(d, c)), float64(RELATIVE_ROUNDING) * lengths * sqrt(dot(c, c) * dot(d, d)))
        on_c = sign_of(dot(n, cross(b, d)), float64(RELATIVE_ROUNDING) * lengths * sqrt(dot(b, b) * dot(d, d)))
    else:  # coordinates relative to the center
        x = ball_center(b, c, root, side)
        size = sqrt(dot(x, x)) * float64(CENTER_ACCURACY)
        on_a = -side * sign_of(dot(d - x, cross(v, w)), size * sqrt(dot(v, v) * dot(w, w)))
        on_b = -side * sign_of(-dot(x, cross(d, c)), size * sqrt(dot(d, d) * dot(c, c)))
        on_c = -side * sign_of(-dot(x, cross(b, d)), size * sqrt(dot(b, b) * dot(d, d)))
    return weigh_tie(on_a, on_b, on_c, ia, ib, ic, at)


@func
def contains_point(
    b: vec3d, c: vec3d, d: vec3d, root: float64, side: int, radius: float64, ia: int, ib: int, ic: int, at: int
) -> int:
    """1 if the ball on 0, b and c contains d, else -1. Ties by the indices of the four."""
    n = cross(b, c)
    nn = dot(n, n)
    bb = dot(b, b)
    cc = dot(c, c)
    dd = dot(d, d)
    k = cross(n, b) * cc + cross(c, n) * bb
    height = dot(d, n)
    value = dd * nn - dot(d, k) - float64(side) * height * root
    lengths = sqrt(bb * cc)
    far = sqrt(dd)
    scale = 4.0 * radius * radius * lengths * sqrt(nn)
    loss = float64(RELATIVE_ROUNDING) * (scale + bb * cc * dot(b - c, b - c))  # of R
    bound = float64(RELATIVE_ROUNDING) * far * lengths * (lengths * (far + sqrt(bb) + sqrt(cc)) + root)
    bound += abs(height) * loss / (root + sqrt(loss))
    inside = -sign_of(value, bound)
    if inside == 0:
        inside = break_tie(b, c, d, root, side, ia, ib, ic, at)
    return inside
