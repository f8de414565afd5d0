"""The smallest box around a convex hull, by its edges.

O'Rourke ("Finding minimal enclosing boxes", IJCIS 1985): two faces of the smallest box that meet hold an edge of the
hull each. A face that holds an edge has its normal on the edge's arc between the normals of the two facets beside it.
So the boxes to search are those with a facet's normal (`fit_on_facets_kernel`: all rectangles in its plane that touch
an edge), and for each pair of edges the frames with one normal on either arc (`fit_on_edges_kernel`). With the arcs as
(1 - t) a + t b and (1 - s) c + s d, that the normals are orthogonal is one bilinear equation in t and s, which has
solutions where the four products of the arcs' ends differ in sign (Jylanki, "An exact algorithm for finding minimum
oriented bounding boxes", 2015). Along them the volume is smooth between few kinks. It is sampled; each dip that could
reach below the best box is sampled anew, and the dips found there are searched by golden section. Jylanki's third edge
is one of the kinks.

In float64. E edges: one thread an edge, E/2 pairs each, some 40 operations a pair, and for the E^1.5 or so pairs with
solutions some thousands.

How far a convex hull reaches in a direction: by climbing along its edges from a table of directions. On a convex hull
every vertex but the farthest has a neighbour that is farther, so climbing finds the farthest one. A table on a cube map
begins the climb near its end: some ten neighbours are looked at, 24 B each, whatever the hull's size. In float64.
"""

import numpy as np

from ..array_types import Device
from ..lang import INFINITY, array, cross, dot, float64, func, int32, kernel, launch, length, struct, tid, vec2d, vec3d
from ..linear_algebra import matmul
from ..memory import download, empty, upload
from .hull_filter import aim_direction, grid_place, locate_direction

TABLE_WIDTH = 16  # cells along an edge of each face of the table: fewer steps to climb than neighbours to look at
TABLE_CHUNK = 1 << 22  # products of directions and vertices held at a time: 32 MB


@kernel
def aim_table_kernel(width: int, directions: array(dtype=vec3d)):
    """The direction of the middle of each cell of a cube map."""
    i = tid()
    u = (float64(i // width % width) + 0.5) / float64(width) * 2.0 - 1.0
    v = (float64(i % width) + 0.5) / float64(width) * 2.0 - 1.0
    directions[i] = aim_direction(i // (width * width), u, v)


@struct
class ClimbedHull:
    """A convex hull to climb on.

    Attributes:
        vertices: float64.
        starts: Where the neighbours of each vertex begin; [m + 1].
        neighbors: Vertices that share an edge with one, vertex after vertex.
        table: The vertex that is farthest in the direction of each cell of a cube map.
    """

    vertices: array(dtype=vec3d)
    starts: array(dtype=int32)
    neighbors: array(dtype=int32)
    table: array(dtype=int32)

    def __init__(self, vertices: np.ndarray, edges: np.ndarray, device: Device) -> None:
        """Prepare the climbs.

        Args:
            vertices: float64 [m, 3].
            edges: Rows of two vertices that an edge joins, integers [e, 2].
            device: Where they go.
        """
        directions = empty(6 * TABLE_WIDTH**2, vec3d, device)
        launch(aim_table_kernel, directions.size, [TABLE_WIDTH, directions])
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
def reach(n: vec3d, hull: ClimbedHull) -> float64:
    """How far the hull reaches in a direction: the largest n . vertex."""
    place = locate_direction(n)
    row = int(place[0]) * TABLE_WIDTH + grid_place(place[1], TABLE_WIDTH)
    best = hull.table[row * TABLE_WIDTH + grid_place(place[2], TABLE_WIDTH)]
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
    """The volume of the box with axes n, m and n x m."""
    k = cross(n, m)
    volume = float64(1.0)
    width = float64(0.0)
    for side in range(6):  # a loop, so that the compilers, which copy functions in, hold `reach` once
        direction = n + 0.0 * n
        if side // 2 == 1:
            direction = m
        if side // 2 == 2:
            direction = k
        if side % 2 == 1:
            direction = -direction
        width += reach(direction, hull)
        if side % 2 == 1:
            volume = volume * width
            width = 0.0
    return volume


GOLDEN = 0.3819660112501051
STEP = 0.05  # [rad] between samples on an arc; arcs of hulls with hundreds of vertices are shorter
FEWEST, MOST = 5, 40  # samples a range of solutions
SPLIT = 16  # finer steps across a dip of the samples: hulls with hundreds of vertices have several kinks in one
ROUGH, FINE = 20, 60  # golden sections: to 1e-4 of a step, and to rounding where the best box comes near
NEAR = 1.01  # of the best volume
FLAT_ARC = 1e-9  # [rad] facets closer than this are one, and their edge only a diagonal of it


@struct
class FoundBoxes:
    """The smallest box that each thread has found.

    Attributes:
        volumes: float64, in cubes of the hull's unit of length.
        firsts, seconds: Two unit axes of it.
    """

    volumes: array(dtype=float64)
    firsts: array(dtype=vec3d)
    seconds: array(dtype=vec3d)

    def __init__(self, count: int, device: Device) -> None:
        self.volumes = empty(count, float64, device)
        self.firsts, self.seconds = empty(count, vec3d, device), empty(count, vec3d, device)

    def smallest(self) -> tuple[float, np.ndarray, np.ndarray]:
        """The smallest volume and its two axes; of equal ones the first."""
        found = download(self.volumes)  # sync
        best = int(found.argmin())
        axes = empty(2, vec3d, self.volumes.device)
        launch(copy_axes_kernel, 1, [self, best, axes])
        first, second = np.array(download(axes))  # sync
        return float(found[best]), first, second


@kernel
def copy_axes_kernel(boxes: FoundBoxes, best: int, axes: array(dtype=vec3d)):
    """The two axes of a box."""
    i = tid()
    axes[i] = boxes.firsts[best]
    axes[i + 1] = boxes.seconds[best]


@func
def unit_or(v: vec3d, other: vec3d) -> vec3d:
    """v made unit; another vector where v vanishes."""
    size = length(v)
    unit = other
    if size > 1e-12:
        unit = v / size
    return unit


@func
def arc_point(a: vec3d, b: vec3d, t: float64) -> vec3d:
    """The unit normal at t of the arc from a to b."""
    return unit_or(a * (1.0 - t) + b * t, a)


@func
def partner(a: vec3d, b: vec3d, c: vec3d, d: vec3d, t: float64) -> vec3d:
    """The normal on the arc from c to d that is orthogonal to the one at t of the arc from a to b."""
    n = arc_point(a, b, t)
    at_c = dot(n, c)
    at_d = dot(n, d)
    m = unit_or(c * at_d - d * at_c, c)  # the sign does not matter to a box
    return unit_or(m - n * dot(n, m), cross(n, c))


@func
def partnered_range(p: float64, q: float64, r: float64, s: float64, second: int) -> vec2d:
    """The t between 0 and 1 with a partner: p, q at t = 0 and r, s at t = 1 are the products with the other arc's ends.

    There may be two ranges; the last argument asks for the second. Empty ones begin at 1 and end at 0.
    """
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
    found = vec2d(one, zero)
    if second == 0:
        if (p <= zero and q >= zero) or (p >= zero and q <= zero):
            found = vec2d(zero, low)
        else:
            if low < one:
                found = vec2d(low, high)
    else:
        if ((p <= zero and q >= zero) or (p >= zero and q <= zero)) and high < one:
            found = vec2d(high, one)
    return found


@func
def volume_at(t: float64, a: vec3d, b: vec3d, c: vec3d, d: vec3d, hull: ClimbedHull) -> float64:
    """The volume of the box with a normal at t of one arc and its partner on the other."""
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
    """(t, volume) at the bottom of a dip about a sample, by golden section; in full only where it nears the bound."""
    low = left
    high = right
    best = vec2d(middle, volume)
    step = 0
    last = int(ROUGH)
    while step < last:
        t = best[0] - float64(GOLDEN) * (best[0] - low)
        if high - best[0] > best[0] - low:
            t = best[0] + float64(GOLDEN) * (high - best[0])
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
        if step == ROUGH and best[1] < bound * float64(NEAR):
            last = FINE
    return best


@func
def floor_beside(before: float64, here: float64, after: float64) -> float64:
    """How low the volume may be beside a sample that is no higher than those before and after; infinite elsewhere.

    A kink beside it lies about as deep as the slopes lead, and twice that where there are several.
    """
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
    """The better of the best (t, volume) known so far and the bottoms of the dips between finer samples."""
    found = best + 0.0 * best
    count = int(SPLIT)
    step = (t1 - t0) / float64(count)
    before = float64(INFINITY)
    here = float64(INFINITY)
    for j in range(count + 2):  # looks at sample j - 1 once that after it is known
        after = float64(INFINITY)
        if j <= count:
            after = volume_at(t0 + step * float64(j), a, b, c, d, hull)
        if floor_beside(before, here, after) < found[1]:
            t = t0 + step * float64(j - 1)
            low = max(t - step, t0)
            high = min(t + step, t1)
            dip = search_dip(low, t, high, here, found[1], a, b, c, d, hull)
            if dip[1] < found[1]:
                found = dip
        before = here
        here = after
    return found


@func
def search_range(
    t0: float64, t1: float64, best: float64, a: vec3d, b: vec3d, c: vec3d, d: vec3d, hull: ClimbedHull
) -> vec2d:
    """(t, volume) of the smallest box on a range of solutions; the best one known so far, at t = -1, if none is."""
    found = vec2d(-1.0, best)
    arc = length(partner(a, b, c, d, t1) - partner(a, b, c, d, t0)) + length(b - a) * (t1 - t0)
    count = min(max(int(arc / float64(STEP)) + 2, FEWEST), MOST)
    step = (t1 - t0) / float64(count - 1)
    before = float64(INFINITY)
    here = float64(INFINITY)
    for j in range(count + 1):  # looks at sample j - 1 once that after it is known
        after = float64(INFINITY)
        if j < count:
            after = volume_at(t0 + step * float64(j), a, b, c, d, hull)
        if floor_beside(before, here, after) < found[1]:
            t = t0 + step * float64(j - 1)
            low = max(t - step, t0)
            high = min(t + step, t1)
            found = search_dips(low, high, found, a, b, c, d, hull)
        before = here
        here = after
    return found


@kernel
def fit_on_facets_kernel(normals: array(dtype=vec3d), arcs: array(dtype=vec3d), hull: ClimbedHull, boxes: FoundBoxes):
    """The smallest box with a face on a facet: another face holds an edge (Freeman and Shapira 1975)."""
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
            if abs(dot(n, m)) < 1e-9:  # else the edge's facets are this one or the opposite one
                volume = box_volume(n, m, hull)
                if volume < best:
                    best = volume
                    second = m
    boxes.volumes[i] = best
    boxes.firsts[i] = n
    boxes.seconds[i] = second


@kernel
def fit_on_edges_kernel(arcs: array(dtype=vec3d), bound: float64, hull: ClimbedHull, boxes: FoundBoxes):
    """The smallest box, below a bound, with one edge on a face and one of the next E/2 edges on a face beside it."""
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
                    found = search_range(span[0], span[1], best, a, b, c, d, hull)
                    if found[1] < best:
                        best = found[1]
                        first = arc_point(a, b, found[0])
                        second = partner(a, b, c, d, found[0])
    boxes.volumes[i] = best
    boxes.firsts[i] = first
    boxes.seconds[i] = second


def smallest_frame(
    vertices: np.ndarray, edges: np.ndarray, arcs: np.ndarray, normals: np.ndarray, device: Device
) -> np.ndarray:
    """The axes of the smallest box around a convex hull.

    Args:
        vertices: float64 [m, 3], near zero.
        edges: Rows of two vertices that an edge joins, integers [e, 2].
        arcs: Unit normals of the two facets beside each edge, float64 [e, 2, 3].
        normals: Unit normals of the facets, float64 [f, 3].
        device: Where to search.

    Returns:
        float64 [3, 3], the axes as columns, right-handed. The same from run to run.
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
