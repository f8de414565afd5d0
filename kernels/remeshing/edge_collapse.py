"""Chosen edges collapse: their vertices move and take what belongs to both ends, their triangles go.

One thread an edge; no two of them share a triangle, so each writes its own. Where the vertex comes to lie off the edge,
normals, colours and texture coordinates are those of the place in the triangle of the edge beneath it.
"""

from collections.abc import Sequence

from ..algebra.transform import narrow, widen
from ..array_types import Indices
from ..arrays.loop_scan import LoopScan
from ..arrays.packed_keys import NO_KEY
from ..lang import array, dot, float64, func, int32, int64, kernel, launch, length, tid, vec2, vec3, vec3d, vec3i
from ..memory import empty, fill
from ..meshes.mesh_topology import corner_vertex, next_corner
from .collapse_mesh import CHOSEN, FREE, VERTICES, CollapseMesh, edge_at, last_corner, uv_at
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
def place_edges_kernel(
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    places: array(dtype=vec3d),
    shares: array(dtype=vec3d),
    tips: array(dtype=int32),
):
    """Where the vertices of edges come to lie.

    `shares` are those of the first end, the other end and the tip of the triangle beneath, whose corner is in `tips`.
    """
    i = tid()
    if i >= mesh.numbers[CHOSEN]:
        return
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
    places[i] = x
    shares[i] = best
    tips[i] = tip


@kernel
def collapse_edges_kernel(
    mesh: CollapseMesh,
    edges: array(dtype=int32),
    places: array(dtype=vec3d),
    partners: array(dtype=int32),
    positions: array(dtype=vec3d),
    quadrics: array(dtype=quadric),
    triangles: array(dtype=vec3i),
    keys: array(dtype=int64),
    moved: array(dtype=int32),
):
    """Move the first end of each edge to where its vertex comes to lie, and give it the triangles of the other end.

    `moved` are the first ends.
    """
    i = tid()
    if i >= mesh.numbers[CHOSEN]:
        return
    h = edges[i]
    a = corner_vertex(triangles, h)
    b = corner_vertex(triangles, next_corner(h))
    partners[a] = b
    partners[b] = -2 - a
    quadrics[a] = quadrics[a] + quadrics[b]
    positions[a] = places[i]
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
    if i >= mesh.numbers[CHOSEN]:
        return
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
    """The texture coordinates of the corners around edges that collapse; `uvs` are not those of the mesh."""
    i = tid()
    if i >= mesh.numbers[CHOSEN]:
        return
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
def take_uvs_kernel(mesh: CollapseMesh, edges: array(dtype=int32), merged: array(dtype=vec2), uvs: array(dtype=vec2)):
    """The coordinates of the corners around edges that collapse become what they were merged to."""
    i = tid()
    if i >= mesh.numbers[CHOSEN]:
        return
    h = edges[i]
    v = corner_vertex(mesh.triangles, h)
    for end in range(2):
        for j in range(mesh.starts[v], mesh.starts[v + 1]):
            c = mesh.corners[j]
            uvs[c] = merged[c]
        v = corner_vertex(mesh.triangles, next_corner(h))


class EdgeCollapse:
    """Room to collapse edges.

    Args:
        mesh: CollapseMesh.
        most: Edges at once.
        unit: For each of the mesh's rows whether they have unit length.

    Attributes:
        moved: The vertices that edges have become, int32.
    """

    def __init__(self, mesh: CollapseMesh, most: int, unit: Sequence[bool]) -> None:
        device, self.most, self.unit = mesh.numbers.device, most, unit
        self.moved: Indices = empty(most, int32, device)
        self._places, self._shares = empty(most, vec3d, device), empty(most, vec3d, device)
        self._tips, self._partners = empty(most, int32, device), empty(mesh.positions.size, int32, device)
        self._scan = LoopScan(mesh.positions.size, device)

    def run(self, mesh: CollapseMesh, twin: CollapseMesh, edges: Indices) -> None:
        """Collapse edges of which none is next to another: int32 half-edges, as many as the record says."""
        count, vertices = mesh.live(CHOSEN, self.most), mesh.live(VERTICES, mesh.positions.size)
        launch(place_edges_kernel, count, [mesh, edges, self._places, self._shares, self._tips])
        for rows, is_unit in zip(mesh.rows, self.unit, strict=True):
            launch(merge_rows_kernel, count, [mesh, edges, self._shares, self._tips, int(is_unit), rows])
        if mesh.has_uvs:
            launch(merge_uvs_kernel, count, [mesh, edges, self._shares, self._tips, twin.uvs])
            launch(take_uvs_kernel, count, [mesh, edges, twin.uvs, mesh.uvs])
        fill(self._partners[:vertices], -1)
        outputs = [self._partners, mesh.positions, mesh.quadrics, mesh.triangles, mesh.keys, self.moved]
        launch(collapse_edges_kernel, count, [mesh, edges, self._places, *outputs])
        mesh.join_corners(self._partners, twin, self._scan)
