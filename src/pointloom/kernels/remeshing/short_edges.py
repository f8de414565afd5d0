"""Collapse edges below a length in parallel where the surface stays valid.

Free vertices move to a crease at the other end. Otherwise to the midpoint; line vertices move to corners. Requires the
link condition (Dey et al. 1999), triangles that turn by at most 60 degrees, and no edge above a length. Edges collapse
whose key (length and hash) is minimal at all vertices around both ends, so no two share a triangle.
"""

from ..algebra.transform import narrow, widen
from ..array_types import Bytes, Integers, Triangles
from ..arrays.select import gather_rows, positions_of
from ..lang import (
    array,
    atomic_add,
    atomic_min,
    compute,
    cross,
    dot,
    float64,
    float_bits,
    func,
    int32,
    int64,
    kernel,
    launch,
    length,
    tid,
    uint8,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import clone, download, full, zeros
from ..meshes.mesh_edges import opposite_vertex
from .creased_mesh import FREE_VERTEX, LINE_VERTEX, NO_NUMBER, CreasedMesh, after_round, is_edge, is_paired, mixed_key

MANTISSA_BITS = 23  # of float32
MIN_COSINE = 0.5  # between the normals of a triangle before and after


@func
def is_next_to(mesh: CreasedMesh, u: int, v: int) -> int:
    flag = 0
    for j in range(mesh.around.starts[v], mesh.around.starts[v + 1]):
        t = mesh.triangles[mesh.around.corners[j] // 3]
        if t[0] == u or t[1] == u or t[2] == u:
            flag = 1
    return flag


@func
def breaks_link(mesh: CreasedMesh, a: int, b: int, c: int, d: int) -> int:
    broken = 0
    for j in range(mesh.around.starts[a], mesh.around.starts[a + 1]):
        t = mesh.triangles[mesh.around.corners[j] // 3]
        for k in range(3):
            u = t[k]
            if u != a and u != b and u != c and u != d and broken == 0:
                broken = is_next_to(mesh, u, b)
    return broken


@func
def has_too_few(mesh: CreasedMesh, v: int) -> int:
    """1 for a vertex that would have too few triangles after losing one."""
    count = mesh.around.starts[v + 1] - mesh.around.starts[v]
    min_count = 4
    if mesh.rims[v] != 0:
        min_count = 2
    return 1 if count < min_count else 0


@func
def flips_triangle(mesh: CreasedMesh, a: int, b: int, x: vec3d, max_sqlength: float64) -> int:
    """1 if a triangle at a without b turns too far, or a squared edge exceeds `max_sqlength`, when a moves to x."""
    wrong = 0
    for j in range(mesh.around.starts[a], mesh.around.starts[a + 1]):
        t = mesh.triangles[mesh.around.corners[j] // 3]
        if t[0] != b and t[1] != b and t[2] != b:
            p = widen(mesh.vertices[t[0]])
            q = widen(mesh.vertices[t[1]])
            r = widen(mesh.vertices[t[2]])
            n = cross(q - p, r - p)
            if t[0] == a:
                p = x + vec3d(0.0, 0.0, 0.0)
            if t[1] == a:
                q = x + vec3d(0.0, 0.0, 0.0)
            if t[2] == a:
                r = x + vec3d(0.0, 0.0, 0.0)
            m = cross(q - p, r - p)
            if not dot(n, m) > float64(MIN_COSINE) * length(n) * length(m):
                wrong = 1
            longest = max(dot(q - p, q - p), max(dot(r - q, r - q), dot(p - r, p - r)))
            if longest > max_sqlength:
                wrong = 1
    return wrong


@func
def goal(mesh: CreasedMesh, e: int) -> int:
    """Target of a collapse: 0 none, 1 the lower vertex, 2 the higher one, 3 the midpoint."""
    a = int(mesh.kinds[mesh.edges.lows[e]])
    b = int(mesh.kinds[mesh.edges.highs[e]])
    crease = int(mesh.creases[mesh.edges.half_edges[mesh.edges.starts[e]]])
    way = 0
    if a == FREE_VERTEX and b == FREE_VERTEX:
        way = 3
    elif a == FREE_VERTEX:
        way = 2
    elif b == FREE_VERTEX:
        way = 1
    elif crease == 1:
        if a == LINE_VERTEX and b == LINE_VERTEX:
            way = 3
        elif a == LINE_VERTEX:
            way = 2
        elif b == LINE_VERTEX:
            way = 1
    return way


@func
def goal_position(mesh: CreasedMesh, e: int, way: int) -> vec3d:
    a = widen(mesh.vertices[mesh.edges.lows[e]])
    b = widen(mesh.vertices[mesh.edges.highs[e]])
    x = 0.5 * (a + b)
    if way == 1:
        x = a + vec3d(0.0, 0.0, 0.0)
    if way == 2:
        x = b + vec3d(0.0, 0.0, 0.0)
    return widen(narrow(x))


@kernel
def price_short_kernel(
    mesh: CreasedMesh,
    min_sqlength: float64,
    max_sqlength: float64,
    ignored_bits: int,
    ended: array(dtype=int32),
    keys: array(dtype=int64),
    lowest: array(dtype=int64),
):
    """Key of each edge that may collapse, and the minimum at each vertex, which does not depend on the order."""
    e = tid()
    keys[e] = int64(NO_NUMBER)
    if is_edge(mesh.edges, e) == 0:
        return
    if ended[0] != 0:
        return
    a = mesh.edges.lows[e]
    b = mesh.edges.highs[e]
    gap = widen(mesh.vertices[b]) - widen(mesh.vertices[a])
    sqdist = dot(gap, gap)
    if not sqdist < min_sqlength:
        return
    count = mesh.edges.starts[e + 1] - mesh.edges.starts[e]
    way = goal(mesh, e)
    paired = is_paired(mesh.triangles, mesh.edges, e)
    if way == 0 or (count != 1 and paired == 0):
        return
    g = mesh.edges.half_edges[mesh.edges.starts[e]]
    h = mesh.edges.half_edges[mesh.edges.starts[e] + count - 1]
    c = opposite_vertex(mesh.triangles[g // 3], a, b)
    d = opposite_vertex(mesh.triangles[h // 3], a, b)
    x = goal_position(mesh, e, way)
    rejected = has_too_few(mesh, c)
    if has_too_few(mesh, d) == 1:
        rejected = 1
    if count == 2 and c == d:
        rejected = 1
    if rejected == 0:
        rejected = breaks_link(mesh, a, b, c, d)
    if rejected == 0:
        rejected = flips_triangle(mesh, a, b, x, max_sqlength)
    if rejected == 0:
        rejected = flips_triangle(mesh, b, a, x, max_sqlength)
    if rejected == 0:
        key = mixed_key(float_bits(float(sqdist)) >> ignored_bits, e)
        keys[e] = key
        atomic_min(lowest, a, key)
        atomic_min(lowest, b, key)


@func
def is_lowest_around(mesh: CreasedMesh, v: int, key: int64, lowest: array(dtype=int64)) -> int:
    flag = 1
    for j in range(mesh.around.starts[v], mesh.around.starts[v + 1]):
        t = mesh.triangles[mesh.around.corners[j] // 3]
        if lowest[t[0]] < key or lowest[t[1]] < key or lowest[t[2]] < key:
            flag = 0
    return flag


@kernel
def collapse_short_kernel(
    mesh: CreasedMesh,
    keys: array(dtype=int64),
    lowest: array(dtype=int64),
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    fixed: array(dtype=uint8),
    count: array(dtype=int32),
):
    """Merge the ends of edges and remove their triangles; `count` is an integer sum."""
    e = tid()
    key = keys[e]
    if key == int64(NO_NUMBER):
        return
    a = mesh.edges.lows[e]
    b = mesh.edges.highs[e]
    first = is_lowest_around(mesh, a, key, lowest)
    if first == 1:
        first = is_lowest_around(mesh, b, key, lowest)
    if first == 1:
        atomic_add(count, 0, 1)
        vertices[a] = narrow(goal_position(mesh, e, goal(mesh, e)))
        fixed[a] = uint8(max(int(mesh.fixed[a]), int(mesh.fixed[b])))
        for j in range(mesh.around.starts[b], mesh.around.starts[b + 1]):
            i = mesh.around.corners[j] // 3
            t = mesh.triangles[i]
            if t[0] == a or t[1] == a or t[2] == a:
                triangles[i] = vec3i(vertices.shape[0])
            else:
                triangles[i] = vec3i(a if t[0] == b else t[0], a if t[1] == b else t[1], a if t[2] == b else t[2])


@kernel(for_cpu=True)
def mask_left_kernel(triangles: array(dtype=vec3i), mask: array(dtype=uint8)):
    i = tid()
    t = triangles[i]
    mask[i] = uint8(1 if t[0] != t[1] else 0)


@kernel(for_cpu=True)
def gather_creases_kernel(creases: array(dtype=uint8), rows: array(dtype=int32), gathered: array(dtype=uint8)):
    i = tid()
    gathered[i] = creases[3 * rows[i // 3] + i % 3]


def collapse_short_edges(
    mesh: CreasedMesh,
    shortest: float,
    longest: float,
    few: float,
    rounds: Integers | None = None,
    *,
    is_fast: bool = False,
) -> tuple[CreasedMesh, int | None]:
    """Collapse edges below `shortest` unless an edge exceeds `longest`. `few`, `rounds` as in `end_rounds` (no sync
    with `rounds`). Returns (mesh, number of collapses or None). Unused vertices stay.

    With `is_fast`, lengths of one power of two of their squares rank by the hash. Where lengths change slowly along the
    surface, few edges are shorter than all others around them, and many have the lowest hash.
    """
    device, edges = mesh.vertices.device, mesh.edges.count
    keys, lowest = full(edges, NO_NUMBER, int64, device), full(mesh.vertices.size, NO_NUMBER, int64, device)
    ended = zeros(1, int32, device) if rounds is None else rounds
    ignored_bits = MANTISSA_BITS if is_fast else 0
    limits = [shortest * shortest, longest * longest]
    launch(price_short_kernel, edges, [mesh, *limits, ignored_bits, ended, keys, lowest])
    vertices, triangles, fixed = clone(mesh.vertices), clone(mesh.triangles), clone(mesh.fixed)
    count = zeros(1, int32, device)
    launch(collapse_short_kernel, edges, [mesh, keys, lowest, vertices, triangles, fixed, count])
    if not device.is_cuda:
        if not download(count)[0]:
            return mesh, 0
        made = CreasedMesh(vertices, *without_removed(triangles, mesh.creases), fixed)
    else:
        made = CreasedMesh(vertices, triangles, clone(mesh.creases), fixed)
    return after_round(mesh, made, count, few, rounds)


def without_removed(triangles: Triangles, creases: Bytes) -> tuple[Triangles, Bytes]:
    """Remaining triangles and the flags of their half-edges. One sync."""
    mask = compute(mask_left_kernel, triangles.size, [triangles], uint8, triangles.device)
    rows = positions_of(mask)  # sync
    left = compute(gather_creases_kernel, 3 * rows.size, [creases, rows], uint8, triangles.device)
    return gather_rows(triangles, rows), left
