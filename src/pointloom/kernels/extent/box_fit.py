"""Minimum-volume oriented bounding box of a convex hull in float64.

Two adjacent faces of the box contain a hull edge each (O'Rourke, "Finding minimal enclosing boxes", IJCIS 1985).
Candidates have a facet's normal, or for an edge pair normals on both edges' arcs that are orthogonal, one bilinear
equation (Jylanki, "An exact algorithm for finding minimum oriented bounding boxes", 2015). The volume along its
solutions is sampled, and promising minima are refined by golden section. Extents by hill climbing.
"""

import numpy as np

from ..array_types import Device
from ..lang import (
    INFINITY,
    array,
    compute,
    cross,
    dot,
    float64,
    func,
    int32,
    kernel,
    launch,
    length,
    struct,
    tid,
    vec2d,
    vec3d,
)
from ..linear_algebra import matmul
from ..memory import download, empty, upload
from .hull_filter import aim_direction, grid_index, locate_direction

TABLE_WIDTH = 16  # cells per edge of each table face: fewer climbing steps than neighbors to test
TABLE_CHUNK = 1 << 22  # products of directions and vertices in memory: 32 MB


@kernel
def aim_table_kernel(width: int, directions: array(dtype=vec3d)):
    i = tid()
    u = (float64(i // width % width) + 0.5) / float64(width) * 2.0 - 1.0
    v = (float64(i % width) + 0.5) / float64(width) * 2.0 - 1.0
    directions[i] = aim_direction(i // (width * width), u, v)


@struct
class ClimbedHull:
    """Convex hull for hill climbing: `starts`, `neighbors` by vertex; `table`: extreme vertex per cube-map cell."""

    vertices: array(dtype=vec3d)
    starts: array(dtype=int32)
    neighbors: array(dtype=int32)
    table: array(dtype=int32)

    def __init__(self, vertices: np.ndarray, edges: np.ndarray, device: Device) -> None:
        """`vertices` float64 (m, 3); `edges` of two vertices, int (e, 2)."""
        directions = compute(aim_table_kernel, 6 * TABLE_WIDTH**2, [TABLE_WIDTH], vec3d, device)
        aims = download(directions)  # sync
        rows = max(1, TABLE_CHUNK // len(vertices))
        table = np.concatenate(
            [matmul(aims[k : k + rows], vertices.T).argmax(axis=1) for k in range(0, len(aims), rows)]
        )
        ends = np.concatenate([edges, edges[:, ::-1]])
        ends = ends[np.lexsort((ends[:, 1], ends[:, 0]))]
        starts = np.searchsorted(ends[:, 0], np.arange(len(vertices) + 1))
        self.starts, self.neighbors, self.table = (upload(v, int32, device) for v in (starts, ends[:, 1], table))
        self.vertices = upload(vertices, vec3d, device)


@func
def support(n: vec3d, hull: ClimbedHull) -> float64:
    """Extent of the hull: the largest n . vertex."""
    location = locate_direction(n)
    row = int(location[0]) * TABLE_WIDTH + grid_index(location[1], TABLE_WIDTH)
    best = hull.table[row * TABLE_WIDTH + grid_index(location[2], TABLE_WIDTH)]
    value = dot(n, hull.vertices[best])
    here = -1
    while here != best:
        here = best
        for j in range(hull.starts[here], hull.starts[here + 1]):
            other = dot(n, hull.vertices[hull.neighbors[j]])
            if other > value:
                value = other
                best = hull.neighbors[j]
    return value


@func
def box_volume(n: vec3d, m: vec3d, hull: ClimbedHull) -> float64:
    k = cross(n, m)
    volume = float64(1.0)
    width = float64(0.0)
    for side in range(6):  # a loop, so that compilers inline `support` once
        direction = n + 0.0 * n
        if side // 2 == 1:
            direction = m
        if side // 2 == 2:
            direction = k
        if side % 2 == 1:
            direction = -direction
        width += support(direction, hull)
        if side % 2 == 1:
            volume = volume * width
            width = 0.0
    return volume


GOLDEN_FRACTION = 0.3819660112501051
ARC_STEP = 0.05  # [rad] between samples on an arc. Arcs of detailed hulls are shorter
MIN_SAMPLES, MAX_SAMPLES = 5, 40  # samples per range of solutions
STEPS_PER_MINIMUM = 16  # finer steps across a minimum: detailed hulls have several kinks in one
ROUGH_STEPS, FINE_STEPS = 20, 60  # golden section steps: to 1e-4 of a step, and to rounding near the best box
MAX_VOLUME_RATIO = 1.01  # of the best volume
FLAT_ARC = 1e-9  # [rad] facets closer than this are coplanar, and their edge is a diagonal


@struct
class FoundBoxes:
    """Smallest box of each thread: `volumes` float64. Unit axes `firsts`, `seconds`."""

    volumes: array(dtype=float64)
    firsts: array(dtype=vec3d)
    seconds: array(dtype=vec3d)

    def __init__(self, count: int, device: Device) -> None:
        self.volumes = empty(count, float64, device)
        self.firsts, self.seconds = empty(count, vec3d, device), empty(count, vec3d, device)

    def smallest(self) -> tuple[float, np.ndarray, np.ndarray]:
        """The smallest volume and its two axes. The first of equal ones."""
        volumes = download(self.volumes)  # sync
        best = int(volumes.argmin())
        axes = empty(2, vec3d, self.volumes.device)
        launch(copy_axes_kernel, 1, [self, best, axes])
        first, second = np.array(download(axes))  # sync
        return float(volumes[best]), first, second


@kernel
def copy_axes_kernel(boxes: FoundBoxes, best: int, axes: array(dtype=vec3d)):
    i = tid()
    axes[i] = boxes.firsts[best]
    axes[i + 1] = boxes.seconds[best]


@func
def unit_or(v: vec3d, other: vec3d) -> vec3d:
    size = length(v)
    unit = other
    if size > 1e-12:
        unit = v / size
    return unit


@func
def arc_point(a: vec3d, b: vec3d, t: float64) -> vec3d:
    return unit_or(a * (1.0 - t) + b * t, a)


@func
def partner(a: vec3d, b: vec3d, c: vec3d, d: vec3d, t: float64) -> vec3d:
    """Normal on the arc c to d that is orthogonal to the one at t of the arc a to b."""
    n = arc_point(a, b, t)
    at_c = dot(n, c)
    at_d = dot(n, d)
    m = unit_or(c * at_d - d * at_c, c)  # the sign is irrelevant for a box
    return unit_or(m - n * dot(n, m), cross(n, c))


@func
def partnered_range(p: float64, q: float64, r: float64, s: float64, second: int) -> vec2d:
    """Range of t in 0..1 with a partner, from products p, q at t = 0 and r, s at t = 1; empty: (1, 0)."""
    zero = float64(0.0)
    one = float64(1.0)
    low = one + zero
    high = one + zero
    if (p < zero and r > zero) or (p > zero and r < zero):
        low = p / (p - r)
    if (q < zero and s > zero) or (q > zero and s < zero):
        high = q / (q - s)
    if low > high:
        swap = low
        low = high
        high = swap
    interval = vec2d(one, zero)
    if second == 0:
        if (p <= zero and q >= zero) or (p >= zero and q <= zero):
            interval = vec2d(zero, low)
        else:
            if low < one:
                interval = vec2d(low, high)
    else:
        if ((p <= zero and q >= zero) or (p >= zero and q <= zero)) and high < one:
            interval = vec2d(high, one)
    return interval


@func
def volume_at(t: float64, a: vec3d, b: vec3d, c: vec3d, d: vec3d, hull: ClimbedHull) -> float64:
    """Volume of the box with a normal at t of one arc and its partner."""
    return box_volume(arc_point(a, b, t), partner(a, b, c, d, t), hull)


@func
def search_dip(
    left: float64,
    middle: float64,
    right: float64,
    volume: float64,
    bound: float64,
    a: vec3d,
    b: vec3d,
    c: vec3d,
    d: vec3d,
    hull: ClimbedHull,
) -> vec2d:
    """(t, volume) of the minimum around a sample, by golden section; completed only near the bound."""
    low = left
    high = right
    best = vec2d(middle, volume)
    step = 0
    last = int(ROUGH_STEPS)
    while step < last:
        t = best[0] - float64(GOLDEN_FRACTION) * (best[0] - low)
        if high - best[0] > best[0] - low:
            t = best[0] + float64(GOLDEN_FRACTION) * (high - best[0])
        there = volume_at(t, a, b, c, d, hull)
        if there < best[1]:
            if t > best[0]:
                low = best[0]
            else:
                high = best[0]
            best = vec2d(t, there)
        else:
            if t > best[0]:
                high = t
            else:
                low = t
        step = step + 1
        if step == ROUGH_STEPS and best[1] < bound * float64(MAX_VOLUME_RATIO):
            last = FINE_STEPS
    return best


@func
def floor_beside(before: float64, here: float64, after: float64) -> float64:
    """Lower estimate of the volume near a local minimum sample, from the slopes, infinite elsewhere."""
    infinite = float64(INFINITY)
    low = float64(INFINITY)
    if here < infinite and here <= before and here <= after:
        drop = float64(0.0)
        if before < infinite:
            drop = max(drop, before - here)
        if after < infinite:
            drop = max(drop, after - here)
        low = here - 2.0 * drop
    return low


@func
def search_dips(
    t0: float64, t1: float64, best: vec2d, a: vec3d, b: vec3d, c: vec3d, d: vec3d, hull: ClimbedHull
) -> vec2d:
    """Better of the best (t, volume) and the minima between finer samples."""
    result = best + 0.0 * best
    count = int(STEPS_PER_MINIMUM)
    step = (t1 - t0) / float64(count)
    before = float64(INFINITY)
    here = float64(INFINITY)
    for j in range(count + 2):  # evaluates sample j - 1 once its successor is known
        after = float64(INFINITY)
        if j <= count:
            after = volume_at(t0 + step * float64(j), a, b, c, d, hull)
        if floor_beside(before, here, after) < result[1]:
            t = t0 + step * float64(j - 1)
            low = max(t - step, t0)
            high = min(t + step, t1)
            dip = search_dip(low, t, high, here, result[1], a, b, c, d, hull)
            if dip[1] < result[1]:
                result = dip
        before = here
        here = after
    return result


@func
def search_range(
    t0: float64, t1: float64, best: float64, a: vec3d, b: vec3d, c: vec3d, d: vec3d, hull: ClimbedHull
) -> vec2d:
    """(t, volume) of the smallest box on a range. The best known with t = -1 if none is smaller."""
    result = vec2d(-1.0, best)
    arc = length(partner(a, b, c, d, t1) - partner(a, b, c, d, t0)) + length(b - a) * (t1 - t0)
    count = min(max(int(arc / float64(ARC_STEP)) + 2, MIN_SAMPLES), MAX_SAMPLES)
    step = (t1 - t0) / float64(count - 1)
    before = float64(INFINITY)
    here = float64(INFINITY)
    for j in range(count + 1):  # evaluates sample j - 1 once its successor is known
        after = float64(INFINITY)
        if j < count:
            after = volume_at(t0 + step * float64(j), a, b, c, d, hull)
        if floor_beside(before, here, after) < result[1]:
            t = t0 + step * float64(j - 1)
            low = max(t - step, t0)
            high = min(t + step, t1)
            result = search_dips(low, high, result, a, b, c, d, hull)
        before = here
        here = after
    return result


@kernel
def fit_on_facets_kernel(normals: array(dtype=vec3d), arcs: array(dtype=vec3d), hull: ClimbedHull, boxes: FoundBoxes):
    """Smallest box with a face on a facet and another on an edge (Freeman and Shapira 1975)."""
    i = tid()
    n = normals[i]
    best = float64(INFINITY)
    second = n + n
    for e in range(arcs.shape[0] // 2):
        a = arcs[2 * e]
        b = arcs[2 * e + 1]
        p = dot(n, a)
        q = dot(n, b)
        if p * q <= 0.0:
            m = unit_or(a * q - b * p, a)
            m = unit_or(m - n * dot(n, m), n + n)
            if abs(dot(n, m)) < 1e-9:  # otherwise the edge's facets are this one or the opposite one
                volume = box_volume(n, m, hull)
                if volume < best:
                    best = volume
                    second = m
    boxes.volumes[i] = best
    boxes.firsts[i] = n
    boxes.seconds[i] = second


@kernel
def fit_on_edges_kernel(arcs: array(dtype=vec3d), bound: float64, hull: ClimbedHull, boxes: FoundBoxes):
    """Smallest box below a bound with faces on this edge and one of the next E/2 edges."""
    i = tid()
    count = arcs.shape[0] // 2
    a = arcs[2 * i]
    b = arcs[2 * i + 1]
    best = bound
    first = a + a
    second = a + a
    for k in range(1, count // 2 + 1):
        e = (i + k) % count
        c = arcs[2 * e]
        d = arcs[2 * e + 1]
        p = dot(a, c)
        q = dot(a, d)
        r = dot(b, c)
        s = dot(b, d)
        if min(min(p, q), min(r, s)) <= 0.0 and max(max(p, q), max(r, s)) >= 0.0:
            for part in range(2):
                span = partnered_range(p, q, r, s, part)
                if span[0] <= span[1]:
                    minimum = search_range(span[0], span[1], best, a, b, c, d, hull)
                    if minimum[1] < best:
                        best = minimum[1]
                        first = arc_point(a, b, minimum[0])
                        second = partner(a, b, c, d, minimum[0])
    boxes.volumes[i] = best
    boxes.firsts[i] = first
    boxes.seconds[i] = second


def smallest_frame(
    vertices: np.ndarray, edges: np.ndarray, arcs: np.ndarray, normals: np.ndarray, device: Device
) -> np.ndarray:
    """Axes of the minimum box, float64 (3, 3), as right-handed columns; deterministic. `arcs` (e, 2, 3): unit normals
    of both facets of an edge; `vertices` near zero.
    """
    hull = ClimbedHull(vertices, edges, device)
    bent = arcs[np.linalg.norm(arcs[:, 0] - arcs[:, 1], axis=1) > FLAT_ARC]
    bends = upload(bent.reshape(-1, 3), vec3d, device)
    _, firsts = np.unique(np.round(normals / FLAT_ARC), axis=0, return_index=True)
    distinct = upload(normals[np.sort(firsts)], vec3d, device)
    boxes = FoundBoxes(distinct.size, device)
    launch(fit_on_facets_kernel, distinct.size, [distinct, bends, hull, boxes])
    on_facets = boxes.smallest()
    boxes = FoundBoxes(len(bent), device)
    launch(fit_on_edges_kernel, len(bent), [bends, on_facets[0], hull, boxes])
    on_edges = boxes.smallest()
    _, n, m = on_edges if on_edges[0] < on_facets[0] else on_facets
    return np.stack([n, m, np.cross(n, m)], axis=1)
