"""Edge flips that bring vertex valences closer to six, or four at boundaries.

An edge flips if it is no crease, its quadrilateral is convex and almost flat, and the other diagonal is no edge. Of
these, edges flip whose key (gain and hash) is minimal at all four vertices.
"""

from ..algebra.transform import widen
from ..array_types import Integers
from ..lang import (
    array,
    atomic_add,
    atomic_min,
    cross,
    dot,
    float64,
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
from ..meshes.mesh_topology import corner_vertex, last_corner, next_corner
from .creased_mesh import NO_NUMBER, CreasedMesh, after_round, is_crease, is_edge, mixed_key
from .short_edges import MIN_COSINE, is_next_to

MAX_GAIN = 1 << 20  # above all gains


@func
def excess(mesh: CreasedMesh, v: int, change: int) -> int:
    count = mesh.around.starts[v + 1] - mesh.around.starts[v] + change
    wanted = 6
    if mesh.rims[v] != 0:
        wanted = 3  # triangles: one less than edges
    return (count - wanted) * (count - wanted)


@func
def normal_of(a: vec3, b: vec3, c: vec3) -> vec3d:
    p = widen(a)
    return cross(widen(b) - p, widen(c) - p)


@func
def agrees(n: vec3d, m: vec3d) -> int:
    return 1 if dot(n, m) > float64(MIN_COSINE) * length(n) * length(m) else 0


@func
def flip_gain(mesh: CreasedMesh, e: int) -> int:
    """Decrease of the squared valence errors by a flip. 0 if not allowed."""
    gain = 0
    flippable = is_edge(mesh.edges, e)
    if flippable == 1:
        flippable = 1 - is_crease(mesh, e)
    if flippable == 1:
        g = mesh.edges.half_edges[mesh.edges.starts[e]]
        h = mesh.edges.half_edges[mesh.edges.starts[e] + 1]
        a = corner_vertex(mesh.triangles, g)
        b = corner_vertex(mesh.triangles, next_corner(g))
        c = corner_vertex(mesh.triangles, last_corner(g))
        d = corner_vertex(mesh.triangles, last_corner(h))
        before = excess(mesh, a, 0) + excess(mesh, b, 0) + excess(mesh, c, 0) + excess(mesh, d, 0)
        after = excess(mesh, a, -1) + excess(mesh, b, -1) + excess(mesh, c, 1) + excess(mesh, d, 1)
        if after < before and c != d:
            pa = mesh.vertices[a]
            pb = mesh.vertices[b]
            pc = mesh.vertices[c]
            pd = mesh.vertices[d]
            n = normal_of(pa, pb, pc)
            m = normal_of(pb, pa, pd)
            q = normal_of(pa, pd, pc)
            r = normal_of(pd, pb, pc)
            fits = agrees(n, q) * agrees(n, r) * agrees(m, q) * agrees(m, r)
            if fits == 1:
                fits = 1 - is_next_to(mesh, c, d)
            if fits == 1:
                gain = before - after
    return gain


@kernel
def price_flips_kernel(
    mesh: CreasedMesh, ended: array(dtype=int32), keys: array(dtype=int64), lowest: array(dtype=int64)
):
    """Key of each edge that may flip, and the minimum at each vertex, which does not depend on the order."""
    e = tid()
    keys[e] = int64(NO_NUMBER)
    gain = 0
    if ended[0] == 0:
        gain = flip_gain(mesh, e)
    if gain > 0:
        g = mesh.edges.half_edges[mesh.edges.starts[e]]
        h = mesh.edges.half_edges[mesh.edges.starts[e] + 1]
        key = mixed_key(MAX_GAIN - gain, e)
        keys[e] = key
        atomic_min(lowest, corner_vertex(mesh.triangles, g), key)
        atomic_min(lowest, corner_vertex(mesh.triangles, next_corner(g)), key)
        atomic_min(lowest, corner_vertex(mesh.triangles, last_corner(g)), key)
        atomic_min(lowest, corner_vertex(mesh.triangles, last_corner(h)), key)


@kernel
def flip_kernel(
    mesh: CreasedMesh,
    keys: array(dtype=int64),
    lowest: array(dtype=int64),
    triangles: array(dtype=vec3i),
    creases: array(dtype=uint8),
    count: array(dtype=int32),
):
    """Flip edges; `count` is an integer sum."""
    e = tid()
    key = keys[e]
    if key == int64(NO_NUMBER):
        return
    g = mesh.edges.half_edges[mesh.edges.starts[e]]
    h = mesh.edges.half_edges[mesh.edges.starts[e] + 1]
    a = corner_vertex(mesh.triangles, g)
    b = corner_vertex(mesh.triangles, next_corner(g))
    c = corner_vertex(mesh.triangles, last_corner(g))
    d = corner_vertex(mesh.triangles, last_corner(h))
    if lowest[a] == key and lowest[b] == key and lowest[c] == key and lowest[d] == key:
        atomic_add(count, 0, 1)
        i = g // 3
        j = h // 3
        triangles[i] = vec3i(a, d, c)
        triangles[j] = vec3i(d, b, c)
        creases[3 * i] = mesh.creases[next_corner(h)]
        creases[3 * i + 1] = uint8(0)
        creases[3 * i + 2] = mesh.creases[last_corner(g)]
        creases[3 * j] = mesh.creases[last_corner(h)]
        creases[3 * j + 1] = mesh.creases[next_corner(g)]
        creases[3 * j + 2] = uint8(0)


def flip_edges(mesh: CreasedMesh, few: float, rounds: Integers | None = None) -> tuple[CreasedMesh, int | None]:
    """One round: (mesh, number of flips); `few` and `rounds` as in `collapse_short_edges`."""
    device, edges = mesh.vertices.device, mesh.edges.count
    keys, lowest = full(edges, NO_NUMBER, int64, device), full(mesh.vertices.size, NO_NUMBER, int64, device)
    launch(price_flips_kernel, edges, [mesh, zeros(1, int32, device) if rounds is None else rounds, keys, lowest])
    triangles, creases, count = clone(mesh.triangles), clone(mesh.creases), zeros(1, int32, device)
    launch(flip_kernel, edges, [mesh, keys, lowest, triangles, creases, count])
    if not device.is_cuda and not download(count)[0]:
        return mesh, 0
    return after_round(mesh, CreasedMesh(mesh.vertices, triangles, creases, mesh.fixed), count, few, rounds)
