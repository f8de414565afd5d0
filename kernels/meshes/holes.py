"""Holes closed by triangles between the vertices of their borders.

Loops are closed in batches of like sizes by the triangulations of least weight (hole_weights.py). Where two holes took
the same chord, the later one waits for the next pass, in which the chord is an edge. About 130 B a triangle of the mesh
for its edges, and 44 B for each pair of vertices of the loops of a batch.
"""

import numpy as np

from ..algebra.transform import widen
from ..array_types import Array1, Indices, Integers, Points, Triangles
from ..arrays.concatenation import concatenate_rows
from ..arrays.select import gather_rows, positions_of
from ..arrays.unique import UniqueKeys
from ..lang import INFINITY, array, atomic_max, float64, int32, kernel, launch, length, tid, uint8, vec2, vec3, vec3d
from ..memory import copy, download, empty, zeros
from .boundary_loops import Border, find_loops
from .hole_weights import close_loops
from .mesh_edges import find_edges
from .mesh_edits import gather_triangles

MOST_VERTICES = 1000  # of a loop: 1.7e8 triangles are looked at, a second or two on two cores
MOST_CELLS = 2**24  # pairs of vertices at once: 740 MB
PASSES = 8  # over holes that took a chord of another


@kernel
def measure_loops_kernel(
    vertices: array(dtype=vec3),
    of_loop: array(dtype=int32),
    half_edges: array(dtype=int32),
    starts: array(dtype=int32),
    radii: array(dtype=float64),
):
    """The largest distance [m] of a loop's vertices to the middle of their box.

    NaN where one is not finite, infinite for the border of one triangle, which is no hole. One thread a loop.
    """
    i = tid()
    first = starts[i]
    last = starts[i + 1]
    low = widen(vertices[of_loop[first]])
    high = low + vec3d(0.0, 0.0, 0.0)
    gap = float64(0.0)  # becomes NaN with any vertex that is not finite
    alone = 1
    for j in range(first, last):
        p = widen(vertices[of_loop[j]])
        gap += (p[0] - p[0]) + (p[1] - p[1]) + (p[2] - p[2])
        low = vec3d(min(low[0], p[0]), min(low[1], p[1]), min(low[2], p[2]))
        high = vec3d(max(high[0], p[0]), max(high[1], p[1]), max(high[2], p[2]))
        if half_edges[j] // 3 != half_edges[first] // 3:
            alone = 0
    middle = (low + high) * 0.5
    farthest = float64(0.0)
    for j in range(first, last):
        farthest = max(farthest, length(widen(vertices[of_loop[j]]) - middle))
    if alone == 1:
        farthest = float64(INFINITY)
    radii[i] = farthest + gap


@kernel
def find_conflicts_kernel(edges: UniqueKeys, of_loop: array(dtype=int32), waits: array(dtype=int32)):
    """1 for the loops that took a chord of an earlier one; any thread may set it."""
    i = tid()
    first = edges.starts[i]
    last = edges.starts[i + 1]
    if last - first > 2:
        least = of_loop[edges.order[first] // 3]
        for j in range(first, last):
            least = min(least, of_loop[edges.order[j] // 3])
        for j in range(first, last):
            loop = of_loop[edges.order[j] // 3]
            if loop != least:
                atomic_max(waits, loop, 1)


@kernel
def mask_settled_kernel(of_loop: array(dtype=int32), waits: array(dtype=int32), mask: array(dtype=uint8)):
    """1 for the pieces of loops that need not wait."""
    i = tid()
    mask[i] = uint8(1 - waits[of_loop[i]])


@kernel
def gather_three_kernel(values: array(dtype=int32), rows: array(dtype=int32), gathered: array(dtype=int32)):
    """The three values of each piece."""
    i = tid()
    for k in range(3):
        gathered[3 * i + k] = values[3 * rows[i] + k]


class FoundLoops:
    """All loops of a mesh: their vertices and half-edges (device arrays), where they begin, their radii (NumPy)."""

    def __init__(self, vertices: Points, triangles: Triangles) -> None:
        border = Border(triangles, vertices.size)
        rows, loops, starts = find_loops(border)  # sync
        self.vertices, self.half_edges = gather_rows(border.vertices, rows), gather_rows(border.half_edges, rows)
        self.starts, self.edge_keys, self.border_count = loops.starts, border.edges.keys, border.half_edges.size
        self.counts = np.diff(starts)
        radii = empty(loops.count, float64, vertices.device)
        launch(measure_loops_kernel, loops.count, [vertices, self.vertices, self.half_edges, self.starts, radii])
        self.radii = download(radii).copy()  # sync


def plan_batches(chosen: np.ndarray, counts: np.ndarray) -> list[np.ndarray]:
    """Chosen loops (NumPy array) in batches of like sizes, none with more than MOST_CELLS chords; the largest first."""
    order, batches, cells = chosen[np.argsort(-counts[chosen], kind="stable")], [], 0
    for loop, count in zip(order.tolist(), counts[order].tolist(), strict=True):
        cells += count * count
        if not batches or cells > MOST_CELLS or 2 * count < counts[batches[-1][0]]:
            batches.append([])
            cells = count * count
        batches[-1].append(loop)
    return [np.array(batch) for batch in batches]


def drop_conflicts(
    pieces: Triangles, corners: Indices, of_loop: Integers, loop_count: int, vertex_count: int
) -> tuple[Triangles, Indices, int]:
    """The pieces of loops that share no chord with an earlier one, their corners, and how many loops wait."""
    device = pieces.device
    edges, waits = find_edges(pieces, vertex_count, padded=True), zeros(loop_count, int32, device)
    launch(find_conflicts_kernel, edges.count, [edges, of_loop, waits])
    waiting = int(download(waits).sum())  # sync
    if not waiting:
        return pieces, corners, 0
    mask = empty(pieces.size, uint8, device)
    launch(mask_settled_kernel, pieces.size, [of_loop, waits, mask])
    rows = positions_of(mask)  # sync
    kept = empty(3 * rows.size, int32, device)
    launch(gather_three_kernel, rows.size, [corners, rows, kept])
    return gather_triangles(pieces, rows), kept, waiting


class Filling:
    """The triangles that close holes.

    Args:
        vertices: vec3 [m].
        triangles: vec3i [t].
        hole_size: [m], the largest radius of a hole.

    Attributes:
        triangles: vec3i [t + p], those of the mesh first.
        corners: int32 [3 p], the half-edge of the mesh at whose start each new corner lies.
        filled: Holes closed.
        left: Holes within the size that stay open.
    """

    def __init__(self, vertices: Points, triangles: Triangles, hole_size: float) -> None:
        self.triangles, self.filled, waiting = triangles, 0, 1
        self.corners = empty(0, int32, triangles.device)
        for _ in range(PASSES):
            if waiting:
                waiting = self._fill(vertices, hole_size)

    def _fill(self, vertices: Points, hole_size: float) -> int:
        """Close what can be closed at once; how many loops have to wait for others."""
        found = FoundLoops(vertices, self.triangles)
        within = found.radii <= hole_size
        chosen = np.flatnonzero(within & (found.counts <= MOST_VERTICES))
        self.left = int(within.sum())
        parts = [close_loops(vertices, self.triangles, found, batch) for batch in plan_batches(chosen, found.counts)]
        if not parts:
            return 0
        pieces, corners, of_loop = (concatenate_rows(rows) for rows in list(zip(*parts, strict=True))[:3])
        closed = sum(count for *_, count in parts)
        pieces, corners, waiting = drop_conflicts(pieces, corners, of_loop, len(found.counts), vertices.size)
        self.filled += closed - waiting
        self.left -= closed - waiting
        self.triangles = concatenate_rows([self.triangles, pieces])
        self.corners = concatenate_rows([self.corners, corners])
        return waiting


@kernel
def spread_corners_kernel(values: array(dtype=vec2), corners: array(dtype=int32), first: int, out: array(dtype=vec2)):
    """The values of new corners, behind the others."""
    i = tid()
    out[first + i] = values[corners[i]]


@kernel
def spread_ids_kernel(ids: array(dtype=int32), corners: array(dtype=int32), first: int, out: array(dtype=int32)):
    """The material of the triangle at the first corner of each new one, behind the others."""
    i = tid()
    out[first + i] = ids[corners[3 * i] // 3]


def spread_corners(values: Array1[vec2], corners: Indices) -> Array1[vec2]:
    """Values vec2 [3 t] of corners, and behind them those of new corners."""
    out = empty(values.size + corners.size, vec2, values.device)
    copy(out, values, count=values.size)
    launch(spread_corners_kernel, corners.size, [values, corners, values.size, out])
    return out


def spread_ids(ids: Indices, corners: Indices) -> Integers:
    """Material numbers int32 [t], and behind them those of new triangles."""
    out = empty(ids.size + corners.size // 3, int32, ids.device)
    copy(out, ids, count=ids.size)
    launch(spread_ids_kernel, corners.size // 3, [ids, corners, ids.size, out])
    return out
