"""The ball of a given radius on three points, and whether it holds a fourth: exact but for rounding, ties by index.

All is in float64 relative to the first of the three, whose differences to the others are exact for float32 coordinates
of similar size. With edges B and C, N = B x C and a fourth point D, the ball's centre is

    x = (K + s N sqrt(R)) / (2 |N|^2),  K = |C|^2 (N x B) + |B|^2 (C x N),  R = 4 r^2 |N|^2 - |B|^2 |C|^2 |B - C|^2,

so D lies inside exactly where |D|^2 |N|^2 - D.K - s (D.N) sqrt(R) < 0: a polynomial and one root, homogeneous of degree
six, and hence the same decision at every scale. Where the value lies within its own rounding D counts as on the ball,
as points of a grid do, and the tie is broken as if each point were a ball itself, larger the lower its index, by
amounts each of which outweighs all later ones (Edelsbrunner and Muecke, "Simulation of simplicity", ACM TOG 1990). The
four points of a square then give two triangles of the four, any number on one circle a fan about the lowest index.

Bernardini et al., "The ball-pivoting algorithm for surface reconstruction", IEEE TVCG 1999.
"""

from ..algebra.transform import widen
from ..lang import cross, dot, float64, func, sqrt, vec3, vec3d

ROUNDING = 1.0e-14  # times the magnitudes: some 45 ulp, three times what the operations of the polynomial can lose
FACING = 1.0e-15  # times the lengths: a normal at a right angle agrees with a face, as in Open3D
THINNEST = 1.0e-20  # squared sine of the angle below which three points are one line: float32 cannot tell them apart
FLAT = 1.0e-10  # times the magnitudes: a centre is known to so much where the triangle is as thin as it may be
TAKEN = 4  # more than the places of four points


@func
def side_of_normals(n: vec3d, a: vec3, b: vec3, c: vec3) -> int:
    """1 where a face with normal n agrees with the normals of its corners, -1 where its back does, else 0."""
    p = widen(a)
    q = widen(b)
    r = widen(c)
    x = dot(n, p)
    y = dot(n, q)
    z = dot(n, r)
    size = sqrt(dot(n, n)) * float64(FACING)
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
    """sqrt(R) of the ball on 0, b and c; -1 where the points are in line or their circle is larger than the ball.

    Where the circle is the ball's to rounding its centre is the circle's.
    """
    n = cross(b, c)
    nn = dot(n, n)
    bb = dot(b, b)
    cc = dot(c, c)
    d = b - c
    whole = 4.0 * radius * radius * nn
    rest = whole - bb * cc * dot(d, d)
    root = float64(-1.0)
    if nn > float64(THINNEST) * bb * cc and rest >= -whole * float64(ROUNDING):
        root = sqrt(max(rest, 0.0))
    return root


@func
def ball_center(b: vec3d, c: vec3d, root: float64, side: int) -> vec3d:
    """The centre of the ball on 0, b and c, on one side of b x c."""
    n = cross(b, c)
    k = cross(n, b) * dot(c, c) + cross(c, n) * dot(b, b)
    return (k + n * (root * float64(side))) * (0.5 / dot(n, n))


@func
def width_of_circle(b: vec3d, c: vec3d, radius: float64) -> float:
    """The circle's squared radius through 0, b and c as a share of the ball's."""
    n = cross(b, c)
    d = b - c
    return float(dot(b, b) * dot(c, c) * dot(d, d) / (4.0 * radius * radius * dot(n, n)))


@func
def sign_of(x: float64, bound: float64) -> int:
    """-1, 0 or 1; 0 within the bound."""
    sign = 0
    if x > bound:
        sign = 1
    if x < -bound:
        sign = -1
    return sign


@func
def weigh_tie(on_a: int, on_b: int, on_c: int, a: int, b: int, c: int, d: int) -> int:
    """Whether D, on the ball of A, B and C, counts as inside: 1 or -1, from the signs of D's coordinates by them.

    The lowest index whose coordinate is not zero decides; that of D itself is -1.
    """
    decided = 0
    passed = -1
    for turn in range(TAKEN):
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
    """1 where d, which lies on the ball on 0, b and c, counts as inside, else -1."""
    n = cross(b, c)
    lengths = sqrt(dot(b, b) * dot(c, c))
    v = b - d
    w = c - d
    on_a = 0
    on_b = 0
    on_c = 0
    if abs(dot(d, n)) <= float64(ROUNDING) * sqrt(dot(d, d)) * lengths:  # in the plane of the others: on their circle
        on_a = sign_of(dot(n, cross(v, w)), float64(ROUNDING) * lengths * sqrt(dot(v, v) * dot(w, w)))
        on_b = sign_of(dot(n, cross(d, c)), float64(ROUNDING) * lengths * sqrt(dot(c, c) * dot(d, d)))
        on_c = sign_of(dot(n, cross(b, d)), float64(ROUNDING) * lengths * sqrt(dot(b, b) * dot(d, d)))
    else:  # coordinates as seen from the centre
        x = ball_center(b, c, root, side)
        size = sqrt(dot(x, x)) * float64(FLAT)
        on_a = -side * sign_of(dot(d - x, cross(v, w)), size * sqrt(dot(v, v) * dot(w, w)))
        on_b = -side * sign_of(-dot(x, cross(d, c)), size * sqrt(dot(d, d) * dot(c, c)))
        on_c = -side * sign_of(-dot(x, cross(b, d)), size * sqrt(dot(b, b) * dot(d, d)))
    return weigh_tie(on_a, on_b, on_c, ia, ib, ic, at)


@func
def holds_point(
    b: vec3d, c: vec3d, d: vec3d, root: float64, side: int, radius: float64, ia: int, ib: int, ic: int, at: int
) -> int:
    """1 where the ball on 0, b and c holds d, ties by the indices of the four; -1 where not."""
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
    whole = 4.0 * radius * radius * lengths * sqrt(nn)
    loss = float64(ROUNDING) * (whole + bb * cc * dot(b - c, b - c))  # of R
    bound = float64(ROUNDING) * far * lengths * (lengths * (far + sqrt(bb) + sqrt(cc)) + root)
    bound += abs(height) * loss / (root + sqrt(loss))
    inside = -sign_of(value, bound)
    if inside == 0:
        inside = break_tie(b, c, d, root, side, ia, ib, ic, at)
    return inside
