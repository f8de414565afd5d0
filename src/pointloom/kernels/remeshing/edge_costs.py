"""Cost, position, and validity of edge collapses.

Quadrics sum the planes of triangles and perpendicular planes along features (Garland and Heckbert 1997, section 6).
Corners stay. Free vertices move to lines, and lines collapse along themselves. An edge may collapse if it satisfies the
link condition (Dey et al. 1999) and no adjacent triangle turns by more than 78 degrees or degenerates.
"""

from ..arrays.packed_keys import NO_KEY, key_bits
from ..lang import (
    array,
    atomic_add,
    cross,
    dot,
    float64,
    float_bits,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    length,
    tid,
    uint8,
    vec3d,
    vec4d,
)
from ..meshes.mesh_topology import corner_vertex, last_corner, next_corner
from .collapse_mesh import (
    FEATURE_BIT,
    FREE_VERTEX,
    HIGHEST_BIN,
    LINE_VERTEX,
    SLOT_COUNT,
    STALE_KEY,
    CollapseMesh,
    mix_number,
    reads_other,
)
from .quadrics import minimum_point, plane_quadric, quadric, quadric_error, quadric_trace

# Possible positions of the merged vertex.
REJECTED_POSITION, BEST_POSITION, FIRST_POSITION, SECOND_POSITION = -1, 0, 1, 2
PRICE_UNIT = 2.0**60  # costs are stored in float32: nonzero costs should not be subnormal
LENGTH_WEIGHT = 1e-9  # what the squared length adds to the cost: short edges go first on ties
MIDPOINT_WEIGHT = 1e-8  # prior weight of the edge midpoint relative to the planes
MAX_SHIFT = 2.0  # edge lengths: maximum distance of the merged vertex from the midpoint
COST_BITS = 21  # of a float's bits: costs are compared in quarters of a doubling; equal ones go in any order
MIN_COSINE = 0.2  # minimum cosine between a triangle's normals before and after: 78 degrees
MIN_AREA_FRACTION = 1e-3  # minimum fraction of a triangle's area that remains
BIN_SHIFT = 19  # of a float's bits: sign, exponent and four more bits give a bin
COST_BINS = 4096
KEY_SHIFT = 32 + BIN_SHIFT  # of a key


@func
def border_quadric(mesh: CollapseMesh, h: int, normal: vec3d, weight: float64) -> quadric:
    p = mesh.positions[corner_vertex(mesh.triangles, h)]
    upright = cross(mesh.positions[corner_vertex(mesh.triangles, next_corner(h))] - p, normal)
    size = length(upright)
    q = quadric(0.0)
    if size > 0.0:
        q = plane_quadric(upright / size, p, weight)
    return q


@kernel
def sum_quadrics_kernel(mesh: CollapseMesh, border_weight: float64, quadrics: array(dtype=quadric)):
    """Initial quadrics of vertices. Degenerate or non-finite triangles are ignored."""
    i = tid()
    total = quadric(0.0)
    p = mesh.positions[i]
    for j in range(mesh.starts[i], mesh.starts[i + 1]):
        s = mesh.spokes[j]
        n = cross(mesh.positions[s[0]] - p, mesh.positions[s[1]] - p)
        size = length(n)
        if size > 0.0 and isfinite(size):
            area = size * 0.5
            n = n / size
            total += plane_quadric(n, p, area)
            c = mesh.corners[j]
            d = last_corner(c)
            if (int(mesh.flags[c]) & FEATURE_BIT) != 0:
                total += border_quadric(mesh, c, n, area * border_weight)
            if (int(mesh.flags[d]) & FEATURE_BIT) != 0:
                total += border_quadric(mesh, d, n, area * border_weight)
    quadrics[i] = total


@func
def placement(mesh: CollapseMesh, h: int, a: int, b: int) -> int:
    ka = int(mesh.kinds[a])
    kb = int(mesh.kinds[b])
    mode = int(REJECTED_POSITION)
    if (int(mesh.flags[h]) & FEATURE_BIT) != 0:
        if ka == LINE_VERTEX and kb == LINE_VERTEX:
            mode = BEST_POSITION
        elif ka == LINE_VERTEX:
            mode = SECOND_POSITION
        elif kb == LINE_VERTEX:
            mode = FIRST_POSITION
    elif ka == FREE_VERTEX and kb == FREE_VERTEX:
        mode = BEST_POSITION
    elif ka == FREE_VERTEX:
        mode = SECOND_POSITION
    elif kb == FREE_VERTEX:
        mode = FIRST_POSITION
    return mode


@func
def merged_position(mesh: CollapseMesh, a: int, b: int, mode: int) -> vec4d:
    q = mesh.quadrics[a] + mesh.quadrics[b]
    p = mesh.positions[a]
    r = mesh.positions[b]
    x = p
    if mode == SECOND_POSITION:
        x = r
    if mode == BEST_POSITION:
        middle = (p + r) * 0.5
        x = minimum_point(q, middle, float64(MIDPOINT_WEIGHT))
        shift = x - middle
        edge = r - p
        if not (dot(shift, shift) <= float64(MAX_SHIFT * MAX_SHIFT) * dot(edge, edge)):
            x = middle
            if quadric_error(q, p) < quadric_error(q, x):
                x = p
            if quadric_error(q, r) < quadric_error(q, x):
                x = r
    error = quadric_error(q, x)
    return vec4d(x[0], x[1], x[2], error)


@func
def edge_key(mesh: CollapseMesh, h: int, a: int, b: int, max_error: float64) -> int64:
    """Cost of an edge with a unique number in the low bits."""
    key = int64(NO_KEY)
    mode = placement(mesh, h, a, b)
    if mode != REJECTED_POSITION:
        merged = merged_position(mesh, a, b, mode)
        if merged[3] <= max_error and isfinite(merged[3]):
            edge = mesh.positions[b] - mesh.positions[a]
            weight = quadric_trace(mesh.quadrics[a]) + quadric_trace(mesh.quadrics[b])
            price = float((merged[3] + weight * dot(edge, edge) * float64(LENGTH_WEIGHT)) * float64(PRICE_UNIT))
            key = (int64((float_bits(price) >> COST_BITS) << COST_BITS) << 32) | mix_number(h)
    return key


@kernel
def price_edges_kernel(mesh: CollapseMesh, max_error: float64, keys: array(dtype=int64), bins: array(dtype=int32)):
    """Keys of edges at owners, and a histogram of costs. Unmoved edges keep theirs. Rejected ones are reevaluated."""
    i = tid()
    if i >= 3 * mesh.numbers[SLOT_COUNT]:
        return
    key = keys[i]
    if key != int64(NO_KEY):
        if key >= int64(STALE_KEY):
            a = corner_vertex(mesh.triangles, i)
            b = corner_vertex(mesh.triangles, next_corner(i))
            if key == int64(STALE_KEY) or mesh.touched[a] != 0 or mesh.touched[b] != 0:
                key = edge_key(mesh, i, a, b, max_error)
                keys[i] = key
        if key < int64(STALE_KEY):
            atomic_add(bins, key_bits(key) >> BIN_SHIFT, 1)  # integers: the order does not matter


@kernel
def mark_cheap_edges_kernel(keys: array(dtype=int64), numbers: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    cheap = 0
    if i < 3 * numbers[SLOT_COUNT]:
        if int(keys[i] >> int64(KEY_SHIFT)) <= numbers[HIGHEST_BIN]:
            cheap = 1
    mask[i] = uint8(cheap)


@func
def has_neighbor(mesh: CollapseMesh, v: int, u: int) -> int:
    """1 if a triangle of v contains u."""
    w = v
    wanted = u
    if reads_other(mesh, v, u) == 1:
        w = u
        wanted = v
    flag = 0
    j = mesh.starts[w]
    while j < mesh.starts[w + 1] and flag == 0:
        s = mesh.spokes[j]
        if s[0] == wanted or s[1] == wanted:
            flag = 1
        j += 1
    return flag


@func
def has_triangle(mesh: CollapseMesh, v: int, p: int, q: int) -> int:
    flag = 0
    j = mesh.starts[v]
    while j < mesh.starts[v + 1] and flag == 0:
        s = mesh.spokes[j]
        if (s[0] == p and s[1] == q) or (s[0] == q and s[1] == p):
            flag = 1
        j += 1
    return flag


@func
def breaks_surface(mesh: CollapseMesh, a: int, b: int) -> int:
    broken = 0
    closed = 0  # 1 if each neighbor of a begins a triangle there
    if int(mesh.kinds[a]) == FREE_VERTEX:
        closed = 1
    j = mesh.starts[a]
    while j < mesh.starts[a + 1] and broken == 0:
        p = mesh.spokes[j][0]
        q = mesh.spokes[j][1]
        if p == b or q == b:
            # At least one of the two merged sides must not be a feature.
            c = mesh.corners[j]
            side = c
            if p == b:
                side = last_corner(c)
            if (int(mesh.flags[side]) & int(mesh.flags[next_corner(c)]) & FEATURE_BIT) != 0:
                broken = 1
        else:
            near_p = has_neighbor(mesh, b, p)
            near_q = 0
            if near_p == 1:
                broken += 1 - has_triangle(mesh, a, b, p)
            if near_p == 1 or closed == 0:
                near_q = has_neighbor(mesh, b, q)
            if near_q == 1:
                broken += 1 - has_triangle(mesh, a, b, q)
            if near_p == 1 and near_q == 1:
                broken += has_triangle(mesh, b, p, q)
        j += 1
    return min(broken, 1)


@func
def bends_surface(mesh: CollapseMesh, v: int, other: int, x: vec3d) -> int:
    """1 if a triangle of v flips or degenerates when v moves to x, except those with the other end."""
    bent = 0
    j = mesh.starts[v]
    while j < mesh.starts[v + 1] and bent == 0:
        p = mesh.spokes[j][0]
        q = mesh.spokes[j][1]
        if p != other and q != other:
            side = mesh.positions[q] - mesh.positions[p]
            before = cross(side, mesh.positions[v] - mesh.positions[p])
            after = cross(side, x - mesh.positions[p])
            old = dot(before, before)
            new = dot(after, after)
            product = dot(before, after)
            flips = product < 0.0 or product * product < float64(MIN_COSINE * MIN_COSINE) * (old * new)
            if flips or new < old * float64(MIN_AREA_FRACTION * MIN_AREA_FRACTION):
                bent = 1
        j += 1
    return bent


@func
def may_collapse(mesh: CollapseMesh, h: int, a: int, b: int, bending: int) -> int:
    """1 if an edge may collapse; `bending` is 1 if triangles may flip."""
    mode = placement(mesh, h, a, b)
    rejected = 1
    if mode != REJECTED_POSITION:
        rejected = breaks_surface(mesh, a, b)
        if rejected == 0 and bending == 0:
            merged = merged_position(mesh, a, b, mode)
            x = vec3d(merged[0], merged[1], merged[2])
            rejected = bends_surface(mesh, a, b, x)
            if rejected == 0:
                rejected = bends_surface(mesh, b, a, x)
    return 1 - rejected
