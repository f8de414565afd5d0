"""Compaction of a mesh during edge collapse, if the record requests it.

Triangles and vertices are marked and counted as one list. The rest is copied to the twin and, on CUDA, where the loop
has fixed arrays, back again. About 400 B per triangle.
"""

from ..array_types import Integers
from ..arrays.tile_scan import TileScan
from ..lang import array, func, int32, int64, kernel, launch, tid, uint8, vec2, vec2i, vec3, vec3d, vec3i
from ..memory import empty
from .collapse_mesh import (
    NEEDS_COMPACTION,
    OTHERS,
    SLOT_COUNT,
    STALE_KEY,
    TRIANGLE_COUNT,
    VERTEX_COUNT,
    CollapseMesh,
    mix_number,
)
from .quadrics import quadric


@kernel
def mark_left_kernel(mesh: CollapseMesh, marks: array(dtype=int32)):
    i = tid()
    slots = mesh.numbers[SLOT_COUNT]
    mark = 0
    if mesh.numbers[NEEDS_COMPACTION] == 1:
        if i < slots:
            t = mesh.triangles[i]
            mark = 1 if t[0] >= 0 else 0
        elif i < slots + mesh.numbers[VERTEX_COUNT]:
            v = i - slots
            mark = 1 if mesh.starts[v + 1] > mesh.starts[v] else 0
    marks[i] = mark


@kernel
def list_left_kernel(mesh: CollapseMesh, ranks: array(dtype=int32), old: array(dtype=int32)):
    """Remaining triangles, then vertices, in order; `ranks` count from one."""
    i = tid()
    slots = mesh.numbers[SLOT_COUNT]
    if mesh.numbers[NEEDS_COMPACTION] == 1 and i < slots + mesh.numbers[VERTEX_COUNT]:
        before = 0
        if i > 0:
            before = ranks[i - 1]
        if ranks[i] > before:
            old[before] = i if i < slots else i - slots


@func
def vertex_index(mesh: CollapseMesh, ranks: array(dtype=int32), v: int) -> int:
    slots = mesh.numbers[SLOT_COUNT]
    return ranks[slots + v] - 1 - ranks[slots - 1]


@kernel
def gather_edges_kernel(
    mesh: CollapseMesh,
    ranks: array(dtype=int32),
    old: array(dtype=int32),
    triangles: array(dtype=vec3i),
    keys: array(dtype=int64),
    flags: array(dtype=uint8),
    uvs: array(dtype=vec2),
    materials: array(dtype=int32),
):
    """Arrays of the remaining half-edges. Costs stay with new unique numbers."""
    i = tid()
    if mesh.numbers[NEEDS_COMPACTION] == 0 or i >= 3 * mesh.numbers[TRIANGLE_COUNT]:
        return
    row = old[i // 3]
    h = 3 * row + i % 3
    key = mesh.keys[h]
    if key < int64(STALE_KEY):
        key = ((key >> 32) << 32) | mix_number(i)
    keys[i] = key
    flags[i] = mesh.flags[h]
    if mesh.has_uvs == 1:
        uvs[i] = mesh.uvs[h]
    if i % 3 == 0:
        t = mesh.triangles[row]
        a = vertex_index(mesh, ranks, t[0])
        b = vertex_index(mesh, ranks, t[1])
        triangles[i // 3] = vec3i(a, b, vertex_index(mesh, ranks, t[2]))
        if mesh.has_materials == 1:
            materials[i // 3] = mesh.materials[row]


@kernel
def gather_vertices_kernel(
    mesh: CollapseMesh,
    ranks: array(dtype=int32),
    old: array(dtype=int32),
    positions: array(dtype=vec3d),
    quadrics: array(dtype=quadric),
    kinds: array(dtype=uint8),
    touched: array(dtype=uint8),
    starts: array(dtype=int32),
):
    i = tid()
    left = mesh.numbers[TRIANGLE_COUNT]
    count = left_vertices(mesh, ranks)
    if i == 0 and count >= 0:
        starts[count] = 3 * left
    if i >= count:
        return
    v = old[left + i]
    positions[i] = mesh.positions[v]
    quadrics[i] = mesh.quadrics[v]
    kinds[i] = mesh.kinds[v]
    touched[i] = mesh.touched[v]
    starts[i] = mesh.starts[v]


@func
def left_vertices(mesh: CollapseMesh, ranks: array(dtype=int32)) -> int:
    """Number of remaining vertices, -1 without compaction."""
    count = -1
    if mesh.numbers[NEEDS_COMPACTION] == 1:
        slots = mesh.numbers[SLOT_COUNT]
        count = ranks[slots + mesh.numbers[VERTEX_COUNT] - 1] - ranks[slots - 1]
    return count


@kernel
def gather_left_kernel(
    mesh: CollapseMesh,
    ranks: array(dtype=int32),
    old: array(dtype=int32),
    rows: array(dtype=vec3),
    out: array(dtype=vec3),
):
    i = tid()
    if i < left_vertices(mesh, ranks):
        out[i] = rows[old[mesh.numbers[TRIANGLE_COUNT] + i]]


@kernel
def renumber_corners_kernel(
    mesh: CollapseMesh, ranks: array(dtype=int32), corners: array(dtype=int32), spokes: array(dtype=vec2i)
):
    i = tid()
    if mesh.numbers[NEEDS_COMPACTION] == 0 or i >= 3 * mesh.numbers[TRIANGLE_COUNT]:
        return
    h = corners[i]
    s = spokes[i]
    corners[i] = 3 * (ranks[h // 3] - 1) + h % 3
    spokes[i] = vec2i(vertex_index(mesh, ranks, s[0]), vertex_index(mesh, ranks, s[1]))


@kernel
def keep_edges_kernel(
    mesh: CollapseMesh,
    triangles: array(dtype=vec3i),
    keys: array(dtype=int64),
    flags: array(dtype=uint8),
    uvs: array(dtype=vec2),
    materials: array(dtype=int32),
):
    i = tid()
    if mesh.numbers[NEEDS_COMPACTION] == 0 or i >= 3 * mesh.numbers[TRIANGLE_COUNT]:
        return
    keys[i] = mesh.keys[i]
    flags[i] = mesh.flags[i]
    if mesh.has_uvs == 1:
        uvs[i] = mesh.uvs[i]
    if i % 3 == 0:
        triangles[i // 3] = mesh.triangles[i // 3]
        if mesh.has_materials == 1:
            materials[i // 3] = mesh.materials[i // 3]


@kernel
def keep_vertices_kernel(
    mesh: CollapseMesh,
    ranks: array(dtype=int32),
    positions: array(dtype=vec3d),
    quadrics: array(dtype=quadric),
    kinds: array(dtype=uint8),
    touched: array(dtype=uint8),
    starts: array(dtype=int32),
):
    i = tid()
    count = left_vertices(mesh, ranks)
    if i <= count:
        starts[i] = mesh.starts[i]
    if i < count:
        positions[i] = mesh.positions[i]
        quadrics[i] = mesh.quadrics[i]
        kinds[i] = mesh.kinds[i]
        touched[i] = mesh.touched[i]


@kernel
def keep_rows_kernel(mesh: CollapseMesh, ranks: array(dtype=int32), rows: array(dtype=vec3), out: array(dtype=vec3)):
    i = tid()
    if i < left_vertices(mesh, ranks):
        out[i] = rows[i]


class Squeezing:
    """Buffers for compaction; `ranks` int32 [t + m] count remaining triangles, then vertices."""

    def __init__(self, mesh: CollapseMesh) -> None:
        capacity, device = mesh.triangles.size + mesh.positions.size, mesh.numbers.device
        self.ranks, self._old, self._scan = (
            empty(capacity, int32, device),
            empty(capacity, int32, device),
            TileScan(capacity, device),
        )

    def run(self, mesh: CollapseMesh, twin: CollapseMesh) -> None:
        """Compact. The counts in the record change at the end of the round."""
        ranks: Integers = self.ranks
        slots, count = mesh.live(SLOT_COUNT, mesh.triangles.size), mesh.live(VERTEX_COUNT, mesh.positions.size)
        launch(mark_left_kernel, slots + count, [mesh, ranks])
        self._scan.run(ranks, ranks, slots + count)
        launch(list_left_kernel, slots + count, [mesh, ranks, self._old])
        half_edge_count = 3 * mesh.live(TRIANGLE_COUNT, mesh.triangles.size)
        edges = ["triangles", "keys", "flags", "uvs", "materials"]
        launch(gather_edges_kernel, half_edge_count, [mesh, ranks, self._old, *(getattr(twin, name) for name in edges)])
        vertices = ["positions", "quadrics", "kinds", "touched", "starts"]
        launch(gather_vertices_kernel, count, [mesh, ranks, self._old, *(getattr(twin, name) for name in vertices)])
        launch(renumber_corners_kernel, half_edge_count, [mesh, ranks, mesh.corners, mesh.spokes])
        for rows, out in zip(mesh.rows, twin.rows, strict=True):
            launch(gather_left_kernel, count, [mesh, ranks, self._old, rows, out])
        if not mesh.numbers.device.is_cuda:
            mesh.exchange(twin, [*OTHERS, "starts", "rows"])
            return
        launch(keep_edges_kernel, half_edge_count, [twin, *(getattr(mesh, name) for name in edges)])
        launch(keep_vertices_kernel, count + 1, [twin, ranks, *(getattr(mesh, name) for name in vertices)])
        for rows, out in zip(twin.rows, mesh.rows, strict=True):
            launch(keep_rows_kernel, count, [twin, ranks, rows, out])
