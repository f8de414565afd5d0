"""Split all edges above a length at their midpoints, at once.

A triangle becomes two, three, or four for one, two, or three long edges. Midpoints are shared, and parts of creases are
creases. New vertices are sorted by edge, triangles by their original.
"""

from ..algebra.transform import narrow, widen
from ..array_types import Integers
from ..arrays.prefix_sum import scan_together
from ..lang import array, atomic_add, compute, dot, float64, func, int32, kernel, launch, tid, uint8, vec3, vec3i
from ..memory import copy, download, empty, zeros
from ..meshes.mesh_topology import corner_vertex, next_corner
from .creased_mesh import CreasedMesh, is_edge


@kernel
def mark_long_kernel(mesh: CreasedMesh, max_sqlength: float64, marks: array(dtype=int32)):
    e = tid()
    mark = 0
    if is_edge(mesh.edges, e) == 1:
        d = widen(mesh.vertices[mesh.edges.highs[e]]) - widen(mesh.vertices[mesh.edges.lows[e]])
        if dot(d, d) > max_sqlength:
            mark = 1
    marks[e] = mark


@kernel
def count_lengths_kernel(mesh: CreasedMesh, min_sqlength: float64, max_sqlength: float64, counts: array(dtype=int32)):
    """Numbers of edges below, within and above two lengths (integer sums)."""
    e = tid()
    if is_edge(mesh.edges, e) == 1:
        d = widen(mesh.vertices[mesh.edges.highs[e]]) - widen(mesh.vertices[mesh.edges.lows[e]])
        slot = 1
        if dot(d, d) < min_sqlength:
            slot = 0
        if dot(d, d) > max_sqlength:
            slot = 2
        atomic_add(counts, slot, 1)


@kernel
def compute_middles_kernel(
    mesh: CreasedMesh, marks: array(dtype=int32), indices: array(dtype=int32), first: int, vertices: array(dtype=vec3)
):
    e = tid()
    if marks[e] == 1:
        middle = 0.5 * (widen(mesh.vertices[mesh.edges.lows[e]]) + widen(mesh.vertices[mesh.edges.highs[e]]))
        vertices[first + indices[e]] = narrow(middle)


@kernel
def count_parts_kernel(mesh: CreasedMesh, marks: array(dtype=int32), counts: array(dtype=int32)):
    i = tid()
    count = 0
    t = mesh.triangles[i]
    if t[0] != t[1]:
        count = 1 + marks[mesh.edge_of[3 * i]] + marks[mesh.edge_of[3 * i + 1]] + marks[mesh.edge_of[3 * i + 2]]
    counts[i] = count


@func
def put_part(slot: int, t: vec3i, flags: vec3i, triangles: array(dtype=vec3i), creases: array(dtype=uint8)):
    triangles[slot] = t
    creases[3 * slot] = uint8(flags[0])
    creases[3 * slot + 1] = uint8(flags[1])
    creases[3 * slot + 2] = uint8(flags[2])


@kernel
def write_parts_kernel(
    mesh: CreasedMesh,
    marks: array(dtype=int32),
    indices: array(dtype=int32),
    first_new: int,
    offsets: array(dtype=int32),
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    creases: array(dtype=uint8),
):
    """Parts of a triangle: corners cut off, and the rest split along its shorter diagonal."""
    i = tid()
    at = offsets[i]
    count = offsets[i + 1] - at
    if count == 0:
        return
    # Start at the corner between the two split edges, or with the single one.
    h = 3 * i
    for k in range(3):
        after = marks[mesh.edge_of[3 * i + k]]
        before = marks[mesh.edge_of[3 * i + (k + 2) % 3]]
        if (count == 3 and after == 1 and before == 1) or (count == 2 and after == 1):
            h = 3 * i + k
    h1 = next_corner(h)
    h2 = next_corner(h1)
    a = corner_vertex(mesh.triangles, h)
    b = corner_vertex(mesh.triangles, h1)
    c = corner_vertex(mesh.triangles, h2)
    ab = first_new + indices[mesh.edge_of[h]]
    bc = first_new + indices[mesh.edge_of[h1]]
    ca = first_new + indices[mesh.edge_of[h2]]
    f = int(mesh.creases[h])
    f1 = int(mesh.creases[h1])
    f2 = int(mesh.creases[h2])
    if count == 1:
        put_part(at, vec3i(a, b, c), vec3i(f, f1, f2), triangles, creases)
    if count == 2:
        put_part(at, vec3i(a, ab, c), vec3i(f, 0, f2), triangles, creases)
        put_part(at + 1, vec3i(ab, b, c), vec3i(f, f1, 0), triangles, creases)
    if count >= 3:
        put_part(at, vec3i(a, ab, ca), vec3i(f, 0, f2), triangles, creases)
    if count == 3:
        p = widen(vertices[ab]) - widen(vertices[c])
        q = widen(vertices[b]) - widen(vertices[ca])
        if dot(p, p) < dot(q, q) or (dot(p, p) == dot(q, q) and ab + c < b + ca):
            put_part(at + 1, vec3i(ab, b, c), vec3i(f, f1, 0), triangles, creases)
            put_part(at + 2, vec3i(ab, c, ca), vec3i(0, f2, 0), triangles, creases)
        else:
            put_part(at + 1, vec3i(ab, b, ca), vec3i(f, 0, 0), triangles, creases)
            put_part(at + 2, vec3i(b, c, ca), vec3i(f1, f2, 0), triangles, creases)
    if count == 4:
        put_part(at + 1, vec3i(ab, b, bc), vec3i(f, f1, 0), triangles, creases)
        put_part(at + 2, vec3i(bc, c, ca), vec3i(f1, f2, 0), triangles, creases)
        put_part(at + 3, vec3i(ab, bc, ca), vec3i(0, 0, 0), triangles, creases)


def count_lengths(mesh: CreasedMesh, shortest: float, longest: float) -> list[int]:
    """Numbers of edges below, within and above two lengths. One sync."""
    counts = zeros(3, int32, mesh.vertices.device)
    launch(count_lengths_kernel, mesh.edges.count, [mesh, shortest * shortest, longest * longest, counts])
    values: list[int] = download(counts).tolist()  # sync
    return values


def split_long_edges(
    mesh: CreasedMesh, longest: float, beside: Integers | None = None
) -> tuple[CreasedMesh, int, list[int]]:
    """(mesh, number of edges split, the values `beside`). One sync."""
    device, count = mesh.vertices.device, mesh.vertices.size
    marks = compute(mark_long_kernel, mesh.edges.count, [mesh, longest * longest], int32, device)
    counts = compute(count_parts_kernel, mesh.triangles.size, [mesh, marks], int32, device)
    wanted = [(marks, [marks.size]), (counts, [counts.size])]
    (indices, (split,)), (offsets, (total,)), *extra = scan_together(
        wanted, beside, largest=4
    )  # sync, parts of a triangle
    values = extra[0][1] if extra else []
    if not split:
        return mesh, 0, values
    vertices, fixed = empty(count + split, vec3, device), zeros(count + split, uint8, device)
    copy(vertices, mesh.vertices, count=count)
    copy(fixed, mesh.fixed, count=count)
    launch(compute_middles_kernel, marks.size, [mesh, marks, indices, count, vertices])
    triangles, creases = empty(total, vec3i, device), empty(3 * total, uint8, device)
    launch(write_parts_kernel, counts.size, [mesh, marks, indices, count, offsets, vertices, triangles, creases])
    return CreasedMesh(vertices, triangles, creases, fixed), split, values
