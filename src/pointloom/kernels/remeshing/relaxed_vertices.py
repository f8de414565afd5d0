"""Tangential relaxation of vertices, undone where a triangle would flip.

A free vertex moves in its tangent plane to the area-weighted mean of its triangle centers, one on a line to the middle
between its neighbors along their direction.
"""

import itertools

from ..algebra.transform import narrow, widen
from ..array_types import Integers, Points
from ..lang import array, atomic_add, compute, dot, float64, int32, kernel, launch, length, tid, uint8, vec3, vec3d
from ..memory import download, empty, zeros
from ..meshes.mesh_measures import triangle_cross
from .creased_mesh import FREE_VERTEX, LINE_VERTEX, CreasedMesh, line_neighbor
from .flipped_edges import agrees

RESTORE_PASSES = 2  # of restoring before the host reads the count: the first nearly always restores nothing


@kernel
def relax_kernel(mesh: CreasedMesh, moved: array(dtype=vec3)):
    i = tid()
    p = widen(mesh.vertices[i])
    x = mesh.vertices[i]
    kind = int(mesh.kinds[i])
    if kind == FREE_VERTEX:
        n = vec3d(0.0, 0.0, 0.0)
        q = vec3d(0.0, 0.0, 0.0)
        total = float64(0.0)
        for j in range(mesh.around.starts[i], mesh.around.starts[i + 1]):
            t = mesh.triangles[mesh.around.corners[j] // 3]
            m = triangle_cross(mesh.vertices, t)
            area = length(m)
            middle = (widen(mesh.vertices[t[0]]) + widen(mesh.vertices[t[1]]) + widen(mesh.vertices[t[2]])) / 3.0
            n = n + m
            q = q + area * (middle - p)
            total += area
        size = length(n)
        if total > 0.0 and size > 0.0:
            n = n / size
            q = q / total
            x = narrow(p + (q - dot(n, q) * n))
    if kind == LINE_VERTEX:
        u = line_neighbor(mesh, i, -1)
        w = line_neighbor(mesh, i, u)
        if u >= 0 and w >= 0:
            a = widen(mesh.vertices[u])
            b = widen(mesh.vertices[w])
            way = b - a
            size = dot(way, way)
            if size > 0.0:
                x = narrow(p + (dot(way, 0.5 * (a + b) - p) / size) * way)
    moved[i] = x


@kernel
def mark_flipped_kernel(mesh: CreasedMesh, moved: array(dtype=vec3), back: array(dtype=uint8)):
    """1 for vertices of triangles that flip. All threads write the same value."""
    i = tid()
    t = mesh.triangles[i]
    wrong = 0
    if t[0] != t[1]:
        n = triangle_cross(mesh.vertices, t)
        m = triangle_cross(moved, t)
        if length(n) > 0.0:
            wrong = 1 - agrees(n, m)
    for k in range(3):
        if wrong == 1:
            back[t[k]] = uint8(1)


@kernel
def take_back_kernel(
    before: array(dtype=vec3), back: array(dtype=uint8), moved: array(dtype=vec3), taken: array(dtype=int32)
):
    """Restore marked vertices. The number that had moved is an integer sum."""
    i = tid()
    if back[i] != 0:
        p = before[i]
        q = moved[i]
        if p[0] != q[0] or p[1] != q[1] or p[2] != q[2]:
            atomic_add(taken, 0, 1)
        moved[i] = p


@kernel
def choose_positions_kernel(
    kinds: array(dtype=uint8),
    before: array(dtype=vec3),
    on_surface: array(dtype=vec3),
    on_lines: array(dtype=vec3),
    chosen: array(dtype=vec3),
):
    i = tid()
    x = before[i]
    if int(kinds[i]) == FREE_VERTEX:
        x = on_surface[i]
    if int(kinds[i]) == LINE_VERTEX:
        x = on_lines[i]
    chosen[i] = x


def relaxed(mesh: CreasedMesh) -> Points:
    return compute(relax_kernel, mesh.vertices.size, [mesh], vec3, mesh.vertices.device)


def choose_positions(mesh: CreasedMesh, on_surface: Points, on_lines: Points) -> Points:
    chosen = empty(mesh.vertices.size, vec3, mesh.vertices.device)
    launch(choose_positions_kernel, chosen.size, [mesh.kinds, mesh.vertices, on_surface, on_lines, chosen])
    return chosen


def move_without_flips(mesh: CreasedMesh, moved: Points, taken: Integers | None = None) -> None:
    """Move vertices, except those of triangles that would turn by more than 60 degrees; modifies `moved` (vec3 [m]).
    With `taken` (int32 [1], zero) there is no sync: PASSES passes run, and the last adds the number of restored
    vertices. If that is zero, the result is complete."""
    for pass_number in itertools.count(1):  # each pass restores a vertex that had moved
        back, count = zeros(moved.size, uint8, moved.device), zeros(1, int32, moved.device)
        if taken is not None and pass_number == RESTORE_PASSES:
            count = taken
        launch(mark_flipped_kernel, mesh.triangles.size, [mesh, moved, back])
        launch(take_back_kernel, moved.size, [mesh.vertices, back, moved, count])
        if pass_number == RESTORE_PASSES if taken is not None else not download(count)[0]:  # sync, if it is not given
            break
    mesh.vertices = moved
