"""Chosen edges collapse: their vertices move and take what belongs to both ends, their triangles go.

One thread an edge; no two of them share a triangle, so each writes its own. Where the vertex comes to lie off the edge,
normals, colours and texture coordinates are those of the place in the triangle of the edge beneath it.
"""

from collections.abc import Sequence

from ..algebra.transform import narrow, widen
from ..array_types import Bytes, Indices
from ..arrays.packed_keys import NO_KEY
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.select import gather_rows, positions_of
from ..arrays.sort import argsort_keys
from ..lang import array, dot, float64, func, int32, int64, kernel, launch, length, tid, uint8, vec2, vec3, vec3d, vec3i
from ..memory import clone, empty, full
from ..meshes.mesh_topology import corner_vertex, next_corner
from .collapse_mesh import FREE, CollapseMesh, edge_at, edge_valence, last_corner, uv_at
from .edge_prices import place_vertex, placement
from .quadrics import quadric


@func
def place_in_triangle(a: vec3d, b: vec3d, c: vec3d, x: vec3d) -> vec3d:
    """The shares of a triangle's corners at the foot of x, none negative; c has none in a triangle without area."""
    u = b - a
    v = c - a
    w = x - a
    uu = dot(u, u)
    uv = dot(u, v)
    vv = dot(v, v)
    uw = dot(u, w)
    vw = dot(v, w)
    zero = float64(0.0)
    one = float64(1.0)
    tip = zero + zero
    area = uu * vv - uv * uv
    if area > zero:
        tip = min(max((uu * vw - uv * uw) / area, zero), one)
    share = zero + zero
    if uu > zero:
        share = min(max((uw - tip * uv) / uu, zero), one - tip)
    return vec3d(one - tip - share, share, tip)


@kernel
def collapse_edges_kernel(
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    shares: array(dtype=vec3d),
    tips: array(dtype=int32),
    partners: array(dtype=int32),
    positions: array(dtype=vec3d),
    quadrics: array(dtype=quadric),
    triangles: array(dtype=vec3i),
    keys: array(dtype=int64),
    moved: array(dtype=int32),
):
    """Move the first end of each edge to where its vertex comes to lie, and give it the triangles of the other end.

    `shares` are those of the first end, the other end and the tip of the triangle beneath, whose corner is in `tips`;
    `moved` are the first ends.
    """
    i = tid()
    h = edges[i]
    a = corner_vertex(mesh.triangles, h)
    b = corner_vertex(mesh.triangles, next_corner(h))
    mode = placement(mesh, h, a, b)
    place = place_vertex(mesh, a, b, mode)
    x = vec3d(place[0], place[1], place[2])
    p = mesh.positions[a]
    r = mesh.positions[b]
    best = place_in_triangle(p, r, p, x)
    tip = -1
    if int(mesh.kinds[a]) == FREE and int(mesh.kinds[b]) == FREE:
        for j in range(mesh.starts[a], mesh.starts[a + 1]):
            g = edge_at(mesh, j, b)
            if g >= 0:
                other = last_corner(g)
                here = place_in_triangle(p, r, mesh.positions[corner_vertex(mesh.triangles, other)], x)
                if here[2] > best[2]:
                    best = here
                    tip = other
    shares[i] = best
    tips[i] = tip
    partners[a] = b
    partners[b] = -2 - a
    quadrics[a] = mesh.quadrics[a] + mesh.quadrics[b]
    positions[a] = x
    moved[i] = a
    for j in range(mesh.starts[b], mesh.starts[b + 1]):
        s = mesh.spokes[j]
        c = mesh.corners[j]
        k = c % 3
        t = vec3i(a, s[0], s[1])
        if k == 1:
            t = vec3i(s[1], a, s[0])
        if k == 2:
            t = vec3i(s[0], s[1], a)
        if s[0] == a or s[1] == a:
            t = vec3i(-1, -1, -1)
            for m in range(3):
                keys[3 * (c // 3) + m] = int64(NO_KEY)
        triangles[c // 3] = t


@kernel
def merge_rows_kernel(
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    shares: array(dtype=vec3d),
    tips: array(dtype=int32),
    unit: int,
    rows: array(dtype=vec3),
):
    """The rows of vertices that edges become; of unit length where `unit` is 1 and there is a length."""
    i = tid()
    h = edges[i]
    a = corner_vertex(mesh.triangles, h)
    s = shares[i]
    row = widen(rows[a]) * s[0]
    if s[1] > 0.0:
        row = row + widen(rows[corner_vertex(mesh.triangles, next_corner(h))]) * s[1]
    if tips[i] >= 0:
        row = row + widen(rows[corner_vertex(mesh.triangles, tips[i])]) * s[2]
    size = length(row)
    if unit == 1 and size > 0.0:
        row = row / size
    rows[a] = narrow(row)


@func
def merged_uv(mesh: CollapseMesh, a: int, b: int, v: int, old: vec2, s: vec3d, tip: int) -> vec2:
    """What the coordinates `old` of a corner at v, one end of the edge a, b, become.

    They go with the triangle at the edge that has the same at v; with none they stay.
    """
    new = old
    found = 0
    for j in range(mesh.starts[a], mesh.starts[a + 1]):
        g = edge_at(mesh, j, b)
        if g >= 0 and found == 0:
            p = uv_at(mesh, g, a)
            q = uv_at(mesh, g, b)
            here = p
            if v == b:
                here = q
            if here[0] == old[0] and here[1] == old[1]:
                found = 1
                new = p * float(s[0]) + q * float(s[1])
                if tip >= 0:
                    new = new + mesh.uvs[tip] * float(s[2])
    return new


@kernel
def merge_uvs_kernel(
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    shares: array(dtype=vec3d),
    tips: array(dtype=int32),
    uvs: array(dtype=vec2),
):
    """The texture coordinates of the corners around edges that collapse; `uvs` is a copy of those of the mesh."""
    i = tid()
    h = edges[i]
    a = corner_vertex(mesh.triangles, h)
    b = corner_vertex(mesh.triangles, next_corner(h))
    for j in range(mesh.starts[a], mesh.starts[a + 1]):
        c = mesh.corners[j]
        uvs[c] = merged_uv(mesh, a, b, a, mesh.uvs[c], shares[i], tips[i])
    for j in range(mesh.starts[b], mesh.starts[b + 1]):
        d = mesh.corners[j]
        uvs[d] = merged_uv(mesh, a, b, b, mesh.uvs[d], shares[i], tips[i])


@kernel
def count_gone_kernel(mesh: CollapseMesh, edges: array(dtype=int32), counts: array(dtype=int32)):
    """How many triangles go with each edge."""
    i = tid()
    a = corner_vertex(mesh.triangles, edges[i])
    b = corner_vertex(mesh.triangles, next_corner(edges[i]))
    counts[i] = edge_valence(mesh, a, b)


@kernel
def gather_keys_kernel(mesh: CollapseMesh, edges: array(dtype=int32), keys: array(dtype=int64)):
    """The keys of some edges."""
    i = tid()
    keys[i] = mesh.keys[edges[i]]


@kernel
def mark_first_kernel(offsets: array(dtype=int32), most: int, mask: array(dtype=uint8)):
    """1 for rows before which fewer than `most` are counted."""
    i = tid()
    first = 0
    if offsets[i] < most:
        first = 1
    mask[i] = uint8(first)


def cheapest_edges(mesh: CollapseMesh, edges: Indices, most: int) -> Indices:
    """The cheapest of some edges, as many as it takes for `most` triangles to go; all where they are not enough."""
    device, count = edges.device, edges.size
    keys, counts, mask = empty(count, int64, device), empty(count, int32, device), empty(count, uint8, device)
    launch(gather_keys_kernel, count, [mesh, edges, keys])
    edges = gather_rows(edges, argsort_keys(keys)[1])
    launch(count_gone_kernel, count, [mesh, edges, counts])
    offsets, _ = exclusive_scan(counts)  # sync
    launch(mark_first_kernel, count, [offsets, most, mask])
    return gather_rows(edges, positions_of(mask))  # sync


def collapse_edges(mesh: CollapseMesh, edges: Indices, unit: Sequence[bool], touched: Bytes) -> Indices:
    """Collapse edges of which none is next to another.

    Args:
        mesh: CollapseMesh.
        edges: int32, half-edges.
        unit: For each of the mesh's rows whether they have unit length.
        touched: uint8 [m], 1 for the vertices of the edges and those around them.

    Returns:
        The vertices that they have become, int32.
    """
    device, count = edges.device, edges.size
    shares, tips, moved = empty(count, vec3d, device), empty(count, int32, device), empty(count, int32, device)
    partners = full(mesh.positions.size, -1, int32, device)
    places, triangles = clone(mesh.positions), clone(mesh.triangles)
    outputs = [shares, tips, partners, places, mesh.quadrics, triangles, mesh.keys, moved]
    launch(collapse_edges_kernel, count, [mesh, edges, *outputs])
    for rows, is_unit in zip(mesh.rows, unit, strict=True):
        launch(merge_rows_kernel, count, [mesh, edges, shares, tips, int(is_unit), rows])
    if mesh.has_uvs:
        uvs = clone(mesh.uvs)
        launch(merge_uvs_kernel, count, [mesh, edges, shares, tips, uvs])
        mesh.uvs = uvs
    mesh.triangles, mesh.positions, mesh.touched = triangles, places, touched
    mesh.join_corners(partners)
    return moved
