"""The mesh whose edges collapse: its arrays, the triangles around its vertices, and what its edges border.

An edge is a feature where a collapse across it would change what the mesh is: it has not exactly two triangles, or
texture coordinates or material numbers differ across it. A vertex is free where no feature edge ends, on a line where
two do, and a corner else. These are the orders of Dey, Edelsbrunner, Guha and Nekhayev, "Topology preserving edge
contraction", 1999.

Triangles around a vertex are listed once by a sort; each round then joins the lists of the ends of edges that
collapsed, so what a thread reads of its surroundings lies side by side. Half-edges and vertices keep their numbers from
round to round, and what is gone is squeezed out when it is a quarter of all. Some 150 B of memory a triangle, twice
that while it is squeezed.
"""

from collections.abc import Sequence

from ..array_types import Array1, Integers, Positions, Triangles, Vectors
from ..arrays.packed_keys import NO_KEY
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.select import gather_rows
from ..arrays.sort import positions
from ..lang import array, func, int32, int64, kernel, launch, struct, tid, uint8, vec2, vec2i, vec3d, vec3i
from ..memory import clone, empty, full, zeros
from ..meshes.mesh_edits import gather_corners, gather_triangles, renumber_triangles_kernel
from ..meshes.mesh_topology import CornersByVertex, corner_vertex, next_corner
from .quadrics import quadric

OWNER, FEATURE = 1, 2  # bits of a half-edge: the one that speaks for its edge; its edge is a feature
FREE, LINE, CORNER = 0, 1, 2  # kinds of vertices
REFUSED_KEY = NO_KEY - 1  # of an edge that may not collapse as things are around it
STALE_KEY = NO_KEY - 2  # of an edge that is to be priced


@struct
class CollapseMesh:
    """A mesh between two rounds.

    Attributes:
        positions: vec3d [m], in a box of one unit about zero.
        quadrics: Of the vertices.
        triangles: vec3i [t]; of three -1 where one is gone.
        uvs: vec2 [3 t], or one row where there are none.
        materials: int32 [t], or one row where there are none.
        starts: int32 [m + 1], where each vertex' corners begin.
        corners: The half-edges that leave vertices.
        spokes: For each of them the next and the last vertex of its triangle.
        flags: uint8 [3 t] of half-edges.
        kinds: uint8 [m].
        touched: uint8 [m], 1 for vertices of edges that collapsed in the last round, and those next to them.
        keys: int64 [3 t], the prices of edges at their owners; NO_KEY elsewhere.
        has_uvs, has_materials: 1 or 0.
        rows: The vec3 [m] arrays that belong to vertices; on the host.
        triangle_count: Triangles that are left; on the host.
    """

    positions: array(dtype=vec3d)
    quadrics: array(dtype=quadric)
    triangles: array(dtype=vec3i)
    uvs: array(dtype=vec2)
    materials: array(dtype=int32)
    starts: array(dtype=int32)
    corners: array(dtype=int32)
    spokes: array(dtype=vec2i)
    flags: array(dtype=uint8)
    kinds: array(dtype=uint8)
    touched: array(dtype=uint8)
    keys: array(dtype=int64)
    has_uvs: int
    has_materials: int

    def __init__(
        self,
        places: Positions,
        triangles: Triangles,
        uvs: Array1[vec2] | None,
        materials: Integers | None,
        rows: Sequence[Vectors],
    ) -> None:
        device = triangles.device
        self.positions, self.triangles = places, triangles
        self.rows, self.triangle_count = [clone(values) for values in rows], triangles.size
        self.has_uvs, self.has_materials = int(uvs is not None), int(materials is not None)
        self.uvs = empty(1, vec2, device) if uvs is None else uvs
        self.materials = empty(1, int32, device) if materials is None else materials
        around = CornersByVertex(triangles, places.size)
        self.starts, self.corners = around.starts, around.corners
        self.spokes = empty(3 * triangles.size, vec2i, device)
        launch(fill_spokes_kernel, self.spokes.size, [triangles, self.corners, self.spokes])
        self.flags, self.kinds = zeros(3 * triangles.size, uint8, device), zeros(places.size, uint8, device)
        self.touched = zeros(places.size, uint8, device)
        self.keys = full(3 * triangles.size, NO_KEY, int64, device)

    def find_all_features(self, with_seams: bool) -> None:
        """Flag all half-edges and sort all vertices into kinds; their edges are to be priced."""
        every = positions(self.positions.size, self.triangles.device)
        launch(flag_edges_kernel, every.size, [self, every, int(with_seams), 0, self.flags, self.keys])
        launch(sort_vertices_kernel, every.size, [self, every, self.kinds])

    def find_features(self, moved: Integers, with_seams: bool) -> None:
        """The same around vertices that moved, of which none is next to another; int32 device array."""
        launch(flag_edges_kernel, moved.size, [self, moved, int(with_seams), 1, self.flags, self.keys])
        launch(sort_vertices_kernel, moved.size, [self, moved, self.kinds])

    def join_corners(self, partners: Integers) -> None:
        """List the corners anew after a round.

        Args:
            partners: int32 [m], the vertex whose corners each takes over; -2 - v where v takes its own; else -1.
        """
        device, count = self.triangles.device, self.positions.size
        counts = empty(count, int32, device)
        launch(count_corners_kernel, count, [self, partners, counts])
        starts, total = exclusive_scan(counts)  # sync
        corners, spokes = empty(total, int32, device), empty(total, vec2i, device)
        launch(join_corners_kernel, count, [self, partners, starts, corners, spokes])
        self.starts, self.corners, self.spokes, self.triangle_count = starts, corners, spokes, total // 3

    def squeeze(self) -> None:
        """Renumber what is left, in its order."""
        device, slots = self.triangles.device, self.corners.size
        left = empty(self.triangles.size, int32, device)
        used = empty(self.positions.size, int32, device)
        launch(mark_triangles_kernel, left.size, [self.triangles, left])
        launch(mark_vertices_kernel, used.size, [self.starts, used])
        triangle_places, triangle_count = exclusive_scan(left)  # sync
        vertex_places, vertex_count = exclusive_scan(used)  # sync
        old_triangles, old_vertices = empty(triangle_count, int32, device), empty(vertex_count, int32, device)
        launch(list_marked_kernel, left.size, [left, triangle_places, old_triangles])
        launch(list_marked_kernel, used.size, [used, vertex_places, old_vertices])

        triangles = empty(triangle_count, vec3i, device)
        taken = gather_triangles(self.triangles, old_triangles)
        launch(renumber_triangles_kernel, triangle_count, [taken, vertex_places, triangles])
        keys, flags = empty(3 * triangle_count, int64, device), empty(3 * triangle_count, uint8, device)
        launch(gather_edges_kernel, keys.size, [self, old_triangles, keys, flags])
        if self.has_uvs:
            self.uvs = gather_corners(self.uvs, old_triangles)
        if self.has_materials:
            self.materials = gather_rows(self.materials, old_triangles)

        places, quadrics = empty(vertex_count, vec3d, device), empty(vertex_count, quadric, device)
        kinds, touched = empty(vertex_count, uint8, device), empty(vertex_count, uint8, device)
        starts = full(vertex_count + 1, slots, int32, device)
        launch(gather_vertices_kernel, vertex_count, [self, old_vertices, places, quadrics, kinds, touched, starts])
        launch(renumber_corners_kernel, slots, [triangle_places, vertex_places, self.corners, self.spokes])
        self.rows = [gather_rows(values, old_vertices) for values in self.rows]
        self.triangles, self.keys, self.flags, self.starts = triangles, keys, flags, starts
        self.positions, self.quadrics, self.kinds, self.touched = places, quadrics, kinds, touched


@func
def last_corner(h: int) -> int:
    """The half-edge before another in its triangle."""
    return h - 1 if h % 3 > 0 else h + 2


# ------------------------------------------------------------------------------------------------ lists of corners


@kernel
def fill_spokes_kernel(triangles: array(dtype=vec3i), corners: array(dtype=int32), spokes: array(dtype=vec2i)):
    """The other two vertices of each corner's triangle."""
    i = tid()
    h = corners[i]
    spokes[i] = vec2i(corner_vertex(triangles, next_corner(h)), corner_vertex(triangles, last_corner(h)))


@func
def joined_spoke(mesh: CollapseMesh, j: int, partners: array(dtype=int32)) -> vec2i:
    """A spoke by the vertices that are left."""
    s = mesh.spokes[j]
    p = partners[s[0]]
    q = partners[s[1]]
    return vec2i(s[0] if p > -2 else -2 - p, s[1] if q > -2 else -2 - q)


@kernel
def count_corners_kernel(mesh: CollapseMesh, partners: array(dtype=int32), counts: array(dtype=int32)):
    """How many triangles each vertex has after a round; those are gone that have a vertex twice."""
    i = tid()
    count = 0
    v = i if partners[i] > -2 else -1
    while v >= 0:
        for j in range(mesh.starts[v], mesh.starts[v + 1]):
            s = joined_spoke(mesh, j, partners)
            if s[0] != s[1] and s[0] != i and s[1] != i:
                count += 1
        v = partners[i] if v == i else -1
    counts[i] = count


@kernel
def join_corners_kernel(
    mesh: CollapseMesh,
    partners: array(dtype=int32),
    starts: array(dtype=int32),
    corners: array(dtype=int32),
    spokes: array(dtype=vec2i),
):
    """The corners of each vertex, then those that it takes over."""
    i = tid()
    place = starts[i]
    v = i if partners[i] > -2 else -1
    while v >= 0:
        for j in range(mesh.starts[v], mesh.starts[v + 1]):
            s = joined_spoke(mesh, j, partners)
            if s[0] != s[1] and s[0] != i and s[1] != i:
                corners[place] = mesh.corners[j]
                spokes[place] = s
                place += 1
        v = partners[i] if v == i else -1


@kernel
def mark_triangles_kernel(triangles: array(dtype=vec3i), left: array(dtype=int32)):
    """1 for triangles that are left."""
    i = tid()
    t = triangles[i]
    left[i] = 1 if t[0] >= 0 else 0


@kernel
def mark_vertices_kernel(starts: array(dtype=int32), used: array(dtype=int32)):
    """1 for vertices with triangles."""
    i = tid()
    used[i] = 1 if starts[i + 1] > starts[i] else 0


@kernel
def list_marked_kernel(marks: array(dtype=int32), places: array(dtype=int32), rows: array(dtype=int32)):
    """The rows with a mark."""
    i = tid()
    if marks[i] == 1:
        rows[places[i]] = i


@func
def mix_number(h: int) -> int64:
    """Another 32-bit number for each number, so that edges of one price are told apart, and in no order of space.

    Without that only the ends of a chain of edges whose prices rise could collapse at once.
    """
    x = (int64(h) * 0x9E3779B1) & 0xFFFFFFFF
    x = x ^ (x >> 15)
    return (x * 0x85EBCA6B) & 0xFFFFFFFF


@kernel
def gather_edges_kernel(
    mesh: CollapseMesh, rows: array(dtype=int32), keys: array(dtype=int64), flags: array(dtype=uint8)
):
    """What belongs to the half-edges of some triangles; prices stay, above the new numbers: no two keys are equal."""
    i = tid()
    h = 3 * rows[i // 3] + i % 3
    key = mesh.keys[h]
    if key < int64(STALE_KEY):
        key = ((key >> 32) << 32) | mix_number(i)
    keys[i] = key
    flags[i] = mesh.flags[h]


@kernel
def gather_vertices_kernel(
    mesh: CollapseMesh,
    rows: array(dtype=int32),
    positions: array(dtype=vec3d),
    quadrics: array(dtype=quadric),
    kinds: array(dtype=uint8),
    touched: array(dtype=uint8),
    starts: array(dtype=int32),
):
    """What belongs to some vertices, all those with corners."""
    i = tid()
    v = rows[i]
    positions[i] = mesh.positions[v]
    quadrics[i] = mesh.quadrics[v]
    kinds[i] = mesh.kinds[v]
    touched[i] = mesh.touched[v]
    starts[i] = mesh.starts[v]


@kernel
def renumber_corners_kernel(
    triangle_places: array(dtype=int32),
    vertex_places: array(dtype=int32),
    corners: array(dtype=int32),
    spokes: array(dtype=vec2i),
):
    """Corners and spokes by the new numbers."""
    i = tid()
    h = corners[i]
    s = spokes[i]
    corners[i] = 3 * triangle_places[h // 3] + h % 3
    spokes[i] = vec2i(vertex_places[s[0]], vertex_places[s[1]])


# ------------------------------------------------------------------------------------------------ features


@func
def valence(mesh: CollapseMesh, v: int) -> int:
    """The triangles at a vertex."""
    return mesh.starts[v + 1] - mesh.starts[v]


@func
def uv_at(mesh: CollapseMesh, h: int, v: int) -> vec2:
    """The texture coordinates at vertex v, an end of h, in the triangle of h."""
    place = h
    if corner_vertex(mesh.triangles, h) != v:
        place = next_corner(h)
    return mesh.uvs[place]


@func
def differ_across(mesh: CollapseMesh, g: int, h: int, a: int, b: int) -> int:
    """1 where two half-edges of the edge a, b have other texture coordinates or materials."""
    found = 0
    if mesh.has_uvs == 1:
        p = uv_at(mesh, g, a) - uv_at(mesh, h, a)
        q = uv_at(mesh, g, b) - uv_at(mesh, h, b)
        if p[0] != 0.0 or p[1] != 0.0 or q[0] != 0.0 or q[1] != 0.0:
            found = 1
    if mesh.has_materials == 1:
        if mesh.materials[g // 3] != mesh.materials[h // 3]:
            found = 1
    return found


@func
def edge_at(mesh: CollapseMesh, j: int, u: int) -> int:
    """The half-edge between the vertex of the j-th corner and u in the corner's triangle, or -1."""
    s = mesh.spokes[j]
    h = -1
    if s[0] == u:
        h = mesh.corners[j]
    elif s[1] == u:
        h = last_corner(mesh.corners[j])
    return h


@func
def edge_valence(mesh: CollapseMesh, a: int, b: int) -> int:
    """The triangles at an edge."""
    count = 0
    for j in range(mesh.starts[a], mesh.starts[a + 1]):
        if edge_at(mesh, j, b) >= 0:
            count += 1
    return count


@func
def edge_flags(mesh: CollapseMesh, h: int, a: int, b: int, seams: int) -> int:
    """The bits of a half-edge between a and b; the first half-edge of an edge owns it."""
    v = a
    u = b
    if valence(mesh, b) < valence(mesh, a):
        v = b
        u = a
    first = h
    other = -1
    count = 0
    for j in range(mesh.starts[v], mesh.starts[v + 1]):
        g = edge_at(mesh, j, u)
        if g >= 0:
            count += 1
            first = min(first, g)
            if g != h:
                other = g
    value = 0
    if count != 2:
        value = FEATURE
    elif seams == 1 and other >= 0:
        value = FEATURE * differ_across(mesh, h, other, a, b)
    if first == h:
        value += OWNER
    return value


@kernel
def flag_edges_kernel(
    mesh: CollapseMesh,
    rows: array(dtype=int32),
    seams: int,
    both_ways: int,
    flags: array(dtype=uint8),
    keys: array(dtype=int64),
):
    """The bits of the half-edges that leave some vertices, or also of those that lead there."""
    i = tid()
    v = rows[i]
    for j in range(mesh.starts[v], mesh.starts[v + 1]):
        c = mesh.corners[j]
        s = mesh.spokes[j]
        value = edge_flags(mesh, c, v, s[0], seams)
        flags[c] = uint8(value)
        keys[c] = int64(STALE_KEY) if (value & OWNER) != 0 else int64(NO_KEY)
        if both_ways == 1:
            d = last_corner(c)
            value = edge_flags(mesh, d, s[1], v, seams)
            flags[d] = uint8(value)
            keys[d] = int64(STALE_KEY) if (value & OWNER) != 0 else int64(NO_KEY)


@kernel
def sort_vertices_kernel(mesh: CollapseMesh, rows: array(dtype=int32), kinds: array(dtype=uint8)):
    """How many feature edges end at a vertex: none, two, or another number; each edge is counted at its owner."""
    i = tid()
    v = rows[i]
    count = 0
    both = OWNER + FEATURE
    for j in range(mesh.starts[v], mesh.starts[v + 1]):
        c = mesh.corners[j]
        if int(mesh.flags[c]) == both:
            count += 1
        if int(mesh.flags[last_corner(c)]) == both:
            count += 1
    kind = int(CORNER)
    if count == 0:
        kind = FREE
    if count == 2:
        kind = LINE
    kinds[v] = uint8(kind)
