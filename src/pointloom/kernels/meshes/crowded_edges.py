"""Remove triangles, smallest first, until no edge has more than two.

Triangles are decided by ascending float32 area, then index. The result does not depend on the thread order, since one
word per edge shows which is next. Triangles at such edges that use a vertex twice are removed first. After 64 rounds,
one thread processes the rest. About 100 B per triangle at such edges.
"""

from ..array_types import Device, Indices, Mask, Points, Triangles
from ..arrays.open_rows import resolve_in_rounds
from ..arrays.select import gather_rows, positions_of_each
from ..arrays.sort import argsort_keys, positions
from ..arrays.unique import UniqueKeys
from ..lang import array, compute, float64, float_bits, func, int32, int64, kernel, launch, struct, tid, uint8, vec3i
from ..memory import empty, full, zeros
from .clean_triangles import uses_vertex_twice
from .mesh_edges import find_edges
from .surface_samples import measure_areas

MAX_EDGE_TRIANGLES = 2  # maximum number of triangles at an edge
COUNT_MASK = 0xFFFF_FFFF  # of a word: remaining triangles of an edge; decided ones above
UNDECIDED_TRIANGLE, KEPT_TRIANGLE, REMOVED_TRIANGLE = 0, 1, 2
# triangles that one CPU thread decides faster than rounds on two: 0.46 to 0.54 ms (2026-11-28)
MAX_SERIAL_TRIANGLES = 1 << 11


@kernel
def spread_edges_kernel(edges: UniqueKeys, of_half_edge: array(dtype=int32)):
    """Edge of each half-edge if it is crowded, else -1. One thread per edge."""
    i = tid()
    first = edges.starts[i]
    last = edges.starts[i + 1]
    edge = i if last - first > MAX_EDGE_TRIANGLES else -1
    for j in range(first, last):
        of_half_edge[edges.order[j]] = edge


@kernel
def mask_crowded_kernel(
    triangles: array(dtype=vec3i), of_half_edge: array(dtype=int32), mask: array(dtype=uint8), plain: array(dtype=uint8)
):
    """1 for triangles at crowded edges. `plain`: 0 for those of them that use a vertex twice."""
    i = tid()
    crowded = 0
    for k in range(3):
        if of_half_edge[3 * i + k] >= 0:
            crowded = 1
    mask[i] = uint8(crowded)
    plain[i] = uint8(1 - crowded * uses_vertex_twice(triangles[i]))


@kernel
def list_area_keys_kernel(areas: array(dtype=float64), rows: array(dtype=int32), keys: array(dtype=int64)):
    """Bits of each float32 area, which sort like the areas."""
    i = tid()
    keys[i] = int64(float_bits(float(areas[rows[i]])))


@kernel
def list_crowded_slots_kernel(
    rows: array(dtype=int32), of_half_edge: array(dtype=int32), none: int, keys: array(dtype=int64)
):
    """Crowded edges of each triangle, three slots each; `none` is the placeholder."""
    i = tid()
    for k in range(3):
        e = of_half_edge[3 * rows[i] + k]
        keys[3 * i + k] = int64(none if e < 0 else e)


@kernel
def rank_slots_kernel(groups: UniqueKeys, none: int, of_slot: array(dtype=int32), ranks: array(dtype=int32)):
    """Group of each slot and its rank there. One thread per group."""
    i = tid()
    if groups.starts[i + 1] > groups.starts[i]:
        if groups.keys[i] != int64(none):
            for j in range(groups.starts[i], groups.starts[i + 1]):
                of_slot[groups.order[j]] = i
                ranks[groups.order[j]] = j - groups.starts[i]


@kernel
def begin_words_kernel(groups: UniqueKeys, words: array(dtype=int64)):
    i = tid()
    words[i] = int64(groups.starts[i + 1] - groups.starts[i])


@struct
class CrowdedEdges:
    """Triangles at crowded edges by area. `of_slot` are three edges per triangle (-1 if not crowded), `ranks` its rank
    at each. A word per edge contains the number of decided triangles above the number of remaining ones."""

    of_slot: array(dtype=int32)
    ranks: array(dtype=int32)
    words: array(dtype=int64)
    states: array(dtype=int32)

    def __init__(self, rows: Indices, of_half_edge: Indices, edge_count: int) -> None:
        device, slots = rows.device, 3 * rows.size
        keys = empty(slots, int64, device)
        launch(list_crowded_slots_kernel, rows.size, [rows, of_half_edge, edge_count, keys])
        groups = UniqueKeys(keys, max(1, edge_count.bit_length()), padded=True)
        self.of_slot, self.ranks = full(slots, -1, int32, device), empty(slots, int32, device)
        launch(rank_slots_kernel, groups.count, [groups, edge_count, self.of_slot, self.ranks])
        self.words, self.states = empty(groups.count, int64, device), zeros(rows.size, int32, device)
        launch(begin_words_kernel, groups.count, [groups, self.words])


@func
def decide_triangle(i: int, crowded: CrowdedEdges) -> int:
    """Decide a triangle that is next at all its edges. Its state. Each word has one writer. Others read it whole."""
    before = crowded.states[i]
    state = KEPT_TRIANGLE
    for k in range(3):
        g = crowded.of_slot[3 * i + k]
        if g >= 0:
            word = crowded.words[g]
            if int(word >> 32) != crowded.ranks[3 * i + k]:
                state = UNDECIDED_TRIANGLE
            elif state == KEPT_TRIANGLE and int(word & int64(COUNT_MASK)) > MAX_EDGE_TRIANGLES:
                state = REMOVED_TRIANGLE
    if before != UNDECIDED_TRIANGLE:
        state = before
    if before == UNDECIDED_TRIANGLE and state != UNDECIDED_TRIANGLE:
        for k in range(3):
            g = crowded.of_slot[3 * i + k]
            if g >= 0:
                word = crowded.words[g] + (int64(1) << int64(32))
                if state == REMOVED_TRIANGLE:
                    word = word - 1
                crowded.words[g] = word
        crowded.states[i] = state
    return state


@kernel
def try_triangles_kernel(rows: array(dtype=int32), crowded: CrowdedEdges, open_rows: array(dtype=uint8)):
    i = tid()
    state = decide_triangle(rows[i], crowded)
    open_rows[i] = uint8(1 if state == UNDECIDED_TRIANGLE else 0)


@kernel
def decide_rest_kernel(rows: array(dtype=int32), crowded: CrowdedEdges):
    i = tid()
    for j in range(i, rows.shape[0]):
        decide_triangle(rows[j], crowded)


@kernel
def mask_removed_kernel(rows: array(dtype=int32), states: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    if states[i] == REMOVED_TRIANGLE:
        mask[rows[i]] = 1


def _crowded_edges_of(triangles: Triangles, vertex_count: int) -> tuple[Indices, int]:
    """(Edges of half-edges, -1 if not crowded; a number beyond all edges.)"""
    edges = find_edges(triangles, vertex_count, padded=True)
    of_half_edge = empty(3 * triangles.size, int32, triangles.device)
    launch(spread_edges_kernel, edges.count, [edges, of_half_edge])
    return of_half_edge, edges.count


class CrowdedTriangles:
    """Triangles at crowded edges (`rows`), and all but those of them that use a vertex twice (`plain`), int32,
    ascending. One sync.
    """

    def __init__(self, triangles: Triangles, vertex_count: int) -> None:
        device, count = triangles.device, triangles.size
        self.of_half_edge, self.edge_count = _crowded_edges_of(triangles, vertex_count)
        crowded, plain = empty(count, uint8, device), empty(count, uint8, device)
        launch(mask_crowded_kernel, count, [triangles, self.of_half_edge, crowded, plain])
        self.rows, self.plain = positions_of_each(crowded, plain)  # sync


def mask_crowding(vertices: Points, triangles: Triangles, at_crowded_edges: CrowdedTriangles) -> Mask:
    """uint8 [t]: 1 for triangles to remove, including those at crowded edges that use a vertex twice."""
    device, rows = triangles.device, at_crowded_edges.rows
    removed = zeros(triangles.size, uint8, device)
    if rows.size == 0:
        return removed
    keys = compute(list_area_keys_kernel, rows.size, [measure_areas(vertices, triangles), rows], int64, device)
    chosen = gather_rows(rows, argsort_keys(keys, 31)[1])
    crowded = CrowdedEdges(chosen, at_crowded_edges.of_half_edge, at_crowded_edges.edge_count)
    rest = _decide_in_rounds(crowded, chosen.size, device)
    launch(decide_rest_kernel, min(1, rest.size), [rest, crowded])
    launch(mask_removed_kernel, chosen.size, [chosen, crowded.states, removed])
    return removed


def _decide_in_rounds(crowded: CrowdedEdges, count: int, device: Device) -> Indices:
    """Decide triangles in rounds. Returns the rest, ascending, for one thread: on the CPU all if there are few."""
    if not device.is_cuda and count <= MAX_SERIAL_TRIANGLES:
        return positions(count, device)
    return resolve_in_rounds(
        lambda rows, open_rows: launch(try_triangles_kernel, rows.size, [rows, crowded, open_rows]), count, device
    )
