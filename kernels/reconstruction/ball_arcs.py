"""Where a ball that touches two points may lie without holding a third: arcs of the circle of its centres.

The centres of the balls on points 0 and b are a circle about the middle of b. Each other point q forbids the arc of it
that lies nearer than the radius; where what is left begins, the ball touches b, q and 0 and holds nothing: a triangle.
So the triangles on an edge are found in one pass over the neighbours, and most edges have no arc left after few.

Arcs are kept too long rather than too short: what is found here is tried exactly afterwards (ball_geometry.py).
Directions on the circle are numbers from 0 to 4 that grow with the angle, without sines.
"""

from ..lang import array, cross, dot, float64, func, sqrt, vec3d

ARCS = 8  # kept of a circle; where more are left one is not split, so that too much of it stays
SHARE = 1.0e-9  # of the numbers that an arc's ends are computed from, by which it is taken to be shorter
LOSS = 1.0e-14  # of the lengths, which covers what those numbers lose to rounding
NEAR = 2.0e-8  # of the lengths: five times what SHARE makes an arc longer, so that what touches its end is known
FULL_TURN = 4.0


@func
def across(b: vec3d) -> vec3d:
    """A unit vector at a right angle to b."""
    axis = vec3d(0.0, 0.0, 1.0)
    if abs(b[2]) > abs(b[0]) and abs(b[2]) > abs(b[1]):
        axis = vec3d(1.0, 0.0, 0.0)
    v = cross(b, axis)
    return v / sqrt(dot(v, v))


@func
def turn_of(x: float64, y: float64) -> float64:
    """A direction as a number from 0 to 4, a quarter turn each."""
    turn = float64(0.0)
    if y >= 0.0:
        if x >= 0.0:
            turn = y / (x + y)
        else:
            turn = 1.0 - x / (y - x)
    else:
        if x < 0.0:
            turn = 2.0 + y / (x + y)
        else:
            turn = 3.0 + x / (x - y)
    return turn


@func
def point_at(turn: float64, u: vec3d, v: vec3d) -> vec3d:
    """The unit vector in a direction, u being 0 and v 1."""
    x = 1.0 - turn
    y = turn
    if turn >= 1.0:
        y = 2.0 - turn
    if turn >= 2.0:
        x = turn - 3.0
    if turn >= 3.0:
        y = turn - 4.0
    return (u * x + v * y) / sqrt(x * x + y * y)


@func
def cut_arcs(arcs: array(dtype=float64), at: int, count: int, start: float64, end: float64) -> int:
    """Take what lies between start and end out of the arcs; how many are left.

    An arc's start stands at 2 j, its end behind it.
    """
    left = count
    j = 0
    while j < left:
        low = arcs[at + 2 * j]
        high = arcs[at + 2 * j + 1]
        if end <= low or start >= high:
            j += 1
        elif start <= low and end >= high:
            left -= 1
            arcs[at + 2 * j] = arcs[at + 2 * left]
            arcs[at + 2 * j + 1] = arcs[at + 2 * left + 1]
        else:
            if start <= low:
                arcs[at + 2 * j] = end
            elif end >= high:
                arcs[at + 2 * j + 1] = start
            elif left < ARCS:
                arcs[at + 2 * j + 1] = start
                arcs[at + 2 * left] = end
                arcs[at + 2 * left + 1] = high
                left += 1
            j += 1
    return left


@func
def cut_turns(arcs: array(dtype=float64), at: int, count: int, start: float64, end: float64) -> int:
    """`cut_arcs` where the end may lie beyond a full turn, and so before the start."""
    left = count
    if start <= end:
        left = cut_arcs(arcs, at, left, start, end)
    else:
        left = cut_arcs(arcs, at, left, start, float64(FULL_TURN))
        left = cut_arcs(arcs, at, left, 0.0, end)
    return left


@func
def forbid_arc(
    arcs: array(dtype=float64),
    at: int,
    count: int,
    q: vec3d,
    size: float64,
    b: vec3d,
    length: float64,
    u: vec3d,
    v: vec3d,
    height: float64,
) -> int:
    """Take the arc out on whose balls a point q at this distance lies inside; how many are left.

    The centres are b / 2 + height (u cos + v sin), b of this length. q lies inside where cos(angle to q) exceeds
    q.(q - b) / (2 height |q'|), q' its part at a right angle to b.
    """
    left = count
    rise = dot(q, q - b)
    x = dot(q, u)
    y = dot(q, v)
    reach = 2.0 * height * sqrt(x * x + y * y)
    rise += float64(SHARE) * (abs(rise) + reach) + float64(LOSS) * size * (size + length + height)
    if rise < reach:
        if rise <= -reach:
            left = 0
        else:
            s = sqrt(max(reach * reach - rise * rise, 0.0))  # cosine and sine, times reach
            start = turn_of(x * rise + y * s, y * rise - x * s)
            left = cut_turns(arcs, at, left, start, turn_of(x * rise - y * s, y * rise + x * s))
    return left


@func
def arc_sag(first: vec3d, last: vec3d, low: float64, high: float64, height: float64, slack: float64) -> float64:
    """How much nearer than the centres at both ends of an arc its others can be to a point, as `passes_arc` takes it.

    2 height (1 - cos(half the arc)) and a slack, so that a point on a ball at an end does not pass; more than any point
    can pass by for half a turn and beyond.
    """
    gap = first - last
    half = dot(gap, gap) * 0.25  # (height sin(half the arc))^2
    sag = 4.0 * height
    if high - low < 1.5:
        sag = 2.0 * (height - sqrt(max(height * height - half, 0.0)))
    return sag + slack


@func
def passes_arc(q: vec3d, size: float64, first: vec3d, last: vec3d, sag: float64) -> int:
    """1 where a point at this distance surely lies outside all balls of an arc, from the centres at its ends."""
    near = max(dot(q, first), dot(q, last))
    passes = 0
    if size * (size - sag) > 2.0 * near:
        passes = 1
    return passes
