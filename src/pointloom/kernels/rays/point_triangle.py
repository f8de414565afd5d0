"""Nearest point of a triangle to a query in float64, and its feature (face, edge, corner).

Inside it is the perpendicular foot (Ericson, Real-Time Collision Detection, 2004, section 5.1.5), else the nearest of
the edges. Edges start at the lexicographically smaller end, so triangles with a common edge or corner have bitwise
equal distances there. Degenerate triangles count as their edges.
"""

from ..algebra.transform import widen
from ..lang import cross, dot, float64, func, vec2d, vec3, vec3d, vec4d

MIN_SQUARED_SINE = 1e-16  # squared sine of the first corner's angle, below which the normal is dominated by rounding
EDGE_FEATURE = 1  # features: 0 the face, 1 to 3 edges from corner 0, 1 and 2, 4 to 6 corners
CORNER_FEATURE = 4


@func
def precedes(a: vec3d, b: vec3d) -> int:
    """1 if a is lexicographically before b."""
    before = 0
    if a[0] < b[0] or (a[0] == b[0] and (a[1] < b[1] or (a[1] == b[1] and a[2] < b[2]))):
        before = 1
    return before


@func
def fraction_of_edge(p: vec3d, a: vec3d, b: vec3d) -> float64:
    """Parameter of the nearest point on the edge from a to b, 0..1."""
    along = dot(p - a, b - a)
    square_length = dot(b - a, b - a)
    fraction = float64(0.0)
    if along >= square_length:
        fraction = 1.0
    elif along > 0.0:
        fraction = along / square_length
    return fraction if square_length > 0.0 else 0.0


@func
def measure_edge(p: vec3d, a: vec3d, b: vec3d) -> vec2d:
    """Parameter of the nearest point on the edge from a to b, 0..1, and its squared distance [m^2]."""
    swapped = precedes(b, a)
    tail = a + vec3d(0.0, 0.0, 0.0)
    head = b + vec3d(0.0, 0.0, 0.0)
    if swapped == 1:
        tail = b + vec3d(0.0, 0.0, 0.0)
        head = a + vec3d(0.0, 0.0, 0.0)
    fraction = fraction_of_edge(p, tail, head)
    gap = p - (tail + (head - tail) * fraction)
    if fraction == 1.0:
        gap = p - head
    return vec2d(1.0 - fraction if swapped == 1 else fraction, dot(gap, gap))


@func
def measure_edges(p: vec3d, a: vec3d, b: vec3d, c: vec3d) -> vec4d:
    ab = measure_edge(p, a, b)
    bc = measure_edge(p, b, c)
    ca = measure_edge(p, c, a)
    which = 0
    fraction = ab[0]
    nearest = ab[1]
    if bc[1] < nearest:
        which = 1
        fraction = bc[0]
        nearest = bc[1]
    if ca[1] < nearest:
        which = 2
        fraction = ca[0]
        nearest = ca[1]
    part = EDGE_FEATURE + which
    if fraction == 0.0:
        part = CORNER_FEATURE + which
    elif fraction == 1.0:
        part = CORNER_FEATURE + (which + 1) % 3
    rest = 1.0 - fraction
    second = fraction if which == 0 else (rest if which == 1 else 0.0)
    third = 0.0 if which == 0 else (fraction if which == 1 else rest)
    return vec4d(second, third, float64(part), nearest)


@func
def measure_triangle(p: vec3d, a: vec3d, b: vec3d, c: vec3d) -> vec4d:
    """Nearest point of the triangle (a, b, c): weights of b and c, feature, squared distance [m^2]."""
    ab = b - a
    ac = c - a
    ap = p - a
    n = cross(ab, ac)
    size = dot(n, n)
    second = dot(cross(ap, ac), n)
    third = dot(cross(ab, ap), n)
    first = size - second - third
    zero = float64(0.0)
    is_wide = size > float64(MIN_SQUARED_SINE) * dot(ab, ab) * dot(ac, ac)
    nearest = vec4d(zero, zero, zero, zero)
    if is_wide and first > zero and second > zero and third > zero:
        height = dot(n, ap)
        nearest = vec4d(second / size, third / size, zero, height * height / size)
    else:
        nearest = measure_edges(p, a, b, c)
    return nearest


@func
def point_at(a: vec3, b: vec3, c: vec3, second: float64, third: float64) -> vec3d:
    return widen(a) * (1.0 - second - third) + widen(b) * second + widen(c) * third
