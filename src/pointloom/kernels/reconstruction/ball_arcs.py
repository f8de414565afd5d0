"""Arcs of the circle of centers of balls on two points, from which other points remove arcs.

Arcs are kept too long rather than too short. Directions on the circle are numbers from 0 to FULL_CIRCLE (`point_at`).
"""

from ..lang import array, cross, dot, float64, func, sqrt, vec3d

MAX_ARCS = 8  # per circle. If there are more, one is not split, so that too much of it remains
ARC_ROUNDING = 1.0e-9  # relative rounding of the numbers that define an arc's ends, by which it is shortened
LENGTH_ROUNDING = 1.0e-14  # of the lengths, which covers rounding
FULL_CIRCLE = 4.0


@func
def across(b: vec3d) -> vec3d:
    """A unit vector perpendicular to b."""
    axis = vec3d(0.0, 0.0, 1.0)
    if abs(b[2]) > abs(b[0]) and abs(b[2]) > abs(b[1]):
        axis = vec3d(1.0, 0.0, 0.0)
    v = cross(b, axis)
    return v / sqrt(dot(v, v))


@func
def direction_of(x: float64, y: float64) -> float64:
    """Direction as a number from 0 to 4 that grows with the angle, one per quadrant, without sines."""
    direction = float64(0.0)
    if y >= 0.0:
        if x >= 0.0:
            direction = y / (x + y)
        else:
            direction = 1.0 - x / (y - x)
    else:
        if x < 0.0:
            direction = 2.0 + y / (x + y)
        else:
            direction = 3.0 + x / (x - y)
    return direction


@func
def point_at(direction: float64, u: vec3d, v: vec3d) -> vec3d:
    """Unit vector in a direction; u is direction 0, v is 1."""
    x = 1.0 - direction
    y = direction
    if direction >= 1.0:
        y = 2.0 - direction
    if direction >= 2.0:
        x = direction - 3.0
    if direction >= 3.0:
        y = direction - 4.0
    return (u * x + v * y) / sqrt(x * x + y * y)


@func
def cut_arcs(arcs: array(dtype=float64), at: int, count: int, start: float64, end: float64) -> int:
    """Remove [start, end] from the arcs, stored as (start, end) at 2 j. Return the number of remaining arcs."""
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
            elif left < MAX_ARCS:
                arcs[at + 2 * j + 1] = start
                arcs[at + 2 * left] = end
                arcs[at + 2 * left + 1] = high
                left += 1
            j += 1
    return left


@func
def cut_wrapped_arcs(arcs: array(dtype=float64), at: int, count: int, start: float64, end: float64) -> int:
    """`cut_arcs` for an interval that may wrap around a full turn."""
    left = count
    if start <= end:
        left = cut_arcs(arcs, at, left, start, end)
    else:
        left = cut_arcs(arcs, at, left, start, float64(FULL_CIRCLE))
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
    """Remove the arc of centers whose balls contain q. Return the number of remaining arcs. Centers are b / 2 + height
    (u cos + v sin). q is inside if cos(angle to q) exceeds q.(q - b) / (2 height |q'|), q' perpendicular to b."""
    left = count
    rise = dot(q, q - b)
    x = dot(q, u)
    y = dot(q, v)
    limit = 2.0 * height * sqrt(x * x + y * y)
    rise += float64(ARC_ROUNDING) * (abs(rise) + limit) + float64(LENGTH_ROUNDING) * size * (size + length + height)
    if rise < limit:
        if rise <= -limit:
            left = 0
        else:
            s = sqrt(max(limit * limit - rise * rise, 0.0))  # cosine and sine, times limit
            start = direction_of(x * rise + y * s, y * rise - x * s)
            left = cut_wrapped_arcs(arcs, at, left, start, direction_of(x * rise - y * s, y * rise + x * s))
    return left


@func
def arc_sag(first: vec3d, last: vec3d, low: float64, high: float64, height: float64, slack: float64) -> float64:
    """Bound of how much closer to a point an arc is than its ends: 2 height (1 - cos(half the arc)) + slack."""
    gap = first - last
    half = dot(gap, gap) * 0.25  # (height sin(half the arc))^2
    sag = 4.0 * height
    if high - low < 1.5:
        sag = 2.0 * (height - sqrt(max(height * height - half, 0.0)))
    return sag + slack


@func
def passes_arc(q: vec3d, size: float64, first: vec3d, last: vec3d, sag: float64) -> int:
    """1 if a point is certainly outside all balls of an arc, given the centers at its ends."""
    near = max(dot(q, first), dot(q, last))
    passes = 0
    if size * (size - sag) > 2.0 * near:
        passes = 1
    return passes
