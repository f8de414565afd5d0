"""Greedy vertex merging by distance, in parallel: each vertex stays or follows the earliest close one that stays.

The result is the lexicographically first maximal independent set, independent of the thread order (Blelloch, Fineman
and Shun, SPAA 2012). Cells have half the radius, so at most one vertex per cell stays. They are grouped in hashed
blocks of 4 x 4 x 4. After 64 rounds, one thread processes the rest. About 130 B per vertex.
"""

from ..algebra.transform import widen
from ..array_types import Indices, Integers, Points
from ..arrays.hash_table import HashTable, find_position, list_keys, mix_bits
from ..arrays.open_rows import resolve_in_rounds
from ..arrays.select import gather_rows
from ..arrays.sort import argsort_keys
from ..arrays.unique import UniqueKeys, cut_together
from ..lang import (
    array,
    atomic_max,
    compute,
    dot,
    float64,
    floor,
    func,
    int32,
    int64,
    kernel,
    launch,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vector,
)
from ..memory import empty, zeros
from .mesh_edges import run_indices

HASH_BITS = 57  # of a block
CELL_BITS = 6  # of a cell in it
NO_STATE = -1  # of a cell in which no vertex stayed
CELL_MARGIN = 1 + 1e-6  # cells per half radius: more than the rounding of coordinates up to 1e10 times the radius
cell = vector(3, int64)


@func
def block_of(p: vec3d, side: float64) -> cell:
    return cell(int64(floor(p[0] / side)), int64(floor(p[1] / side)), int64(floor(p[2] / side)))


@func
def hash_block(at: cell, salt: int64) -> int64:
    h = mix_bits(at[0] + salt)
    h = mix_bits((h ^ at[1]) + salt)
    h = mix_bits((h ^ at[2]) + salt)
    return h & ((1 << int64(HASH_BITS)) - 1)


@kernel
def hash_cells_kernel(points: array(dtype=vec3), side: float64, salt: int64, keys: array(dtype=int64)):
    i = tid()
    p = widen(points[i])
    block = block_of(p, side)
    quarter = block_of(p, side * 0.25)
    part = int64(0)
    for axis in range(3):
        part = part * 4 + (quarter[axis] - 4 * block[axis])
    keys[i] = (hash_block(block, salt) << int64(CELL_BITS)) | part


@kernel
def compare_blocks_kernel(
    points: array(dtype=vec3),
    side: float64,
    keys: array(dtype=int64),
    order: array(dtype=int32),
    differ: array(dtype=int32),
):
    """Set `differ` on a hash collision of blocks. Keys are sorted, and all threads write the same value."""
    i = tid()
    if i > 0:
        if (keys[i] >> int64(CELL_BITS)) == (keys[i - 1] >> int64(CELL_BITS)):
            a = block_of(widen(points[order[i]]), side)
            b = block_of(widen(points[order[i - 1]]), side)
            if a[0] != b[0] or a[1] != b[1] or a[2] != b[2]:
                atomic_max(differ, 0, 1)


@kernel
def list_blocks_kernel(keys: array(dtype=int64), blocks: array(dtype=int64)):
    i = tid()
    blocks[i] = keys[i] >> int64(CELL_BITS)


@kernel
def begin_at_cells_kernel(cell_of: array(dtype=int32), cell_count: int, starts: array(dtype=int32)):
    """Replace the first point of each block by its first cell, and add the end."""
    i = tid()
    starts[i] = cell_of[starts[i]]
    if i + 2 == starts.shape[0]:
        starts[i + 1] = cell_count


@kernel
def begin_states_kernel(cells: UniqueKeys, states: array(dtype=int32)):
    i = tid()
    states[i] = cells.order[cells.starts[i]]


@kernel
def rank_points_kernel(
    cells: UniqueKeys, cell_of: array(dtype=int32), of_point: array(dtype=int32), rank: array(dtype=int32)
):
    i = tid()
    of_point[cells.order[i]] = cell_of[i]
    rank[cells.order[i]] = i


@struct
class Cells:
    """Points in cells of half the radius. Cells and blocks are sorted; `rank` is a point's position in its cell order.
    A cell's state is the vertex to decide next, NO_STATE (none stays), or -2 - v (v stays). Coordinates beyond 1e10
    radii differ by more than the radius in float32, or not at all."""

    cells: UniqueKeys
    blocks: UniqueKeys
    table: HashTable
    points: array(dtype=vec3)
    of_point: array(dtype=int32)
    rank: array(dtype=int32)
    states: array(dtype=int32)
    side: float64
    square_radius: float64
    salt: int64

    def __init__(self, points: Points, radius: float) -> None:
        device, count = points.device, points.size
        self.points, self.salt = points, 0
        self.square_radius = float(radius) * float(radius)
        self.side = 2 * float(radius) * CELL_MARGIN
        while True:
            keys = compute(hash_cells_kernel, count, [points, self.side, self.salt], int64, device)
            keys, order = argsort_keys(keys, HASH_BITS + CELL_BITS)
            self.cells = UniqueKeys(keys, in_order=(keys, order), padded=True)
            blocks, differ = empty(count, int64, device), zeros(1, int32, device)
            launch(list_blocks_kernel, count, [keys, blocks])
            self.blocks = UniqueKeys(blocks, in_order=(blocks, order), padded=True)
            launch(compare_blocks_kernel, count, [points, self.side, keys, order, differ])
            if not cut_together([self.cells, self.blocks], differ)[0][0]:  # sync
                break
            self.salt += 1
        cell_of = run_indices(self.cells, count)
        launch(begin_at_cells_kernel, self.blocks.count, [cell_of, self.cells.count, self.blocks.starts])
        self.table = list_keys(self.blocks.keys, self.blocks.count)
        self.of_point, self.rank = empty(count, int32, device), empty(count, int32, device)
        launch(rank_points_kernel, count, [self.cells, cell_of, self.of_point, self.rank])
        self.states = empty(self.cells.count, int32, device)
        launch(begin_states_kernel, self.cells.count, [self.cells, self.states])


@func
def square_gap(p: vec3, q: vec3) -> float64:
    d = widen(p) - widen(q)
    return dot(d, d)


@func
def find_earlier_vertex(v: int, cells: Cells) -> int:
    """Earliest staying vertex before v within the radius, or -1 if none, -2 if a candidate is undecided."""
    p = cells.points[v]
    half = cells.side * 0.5
    first = block_of(widen(p) - vec3d(half, half, half), cells.side)
    last = block_of(widen(p) + vec3d(half, half, half), cells.side)
    earliest = -1
    waits = 0
    n = int(8)
    for k in range(n):
        at = cell(first[0] + int64(k >> 2), first[1] + int64((k >> 1) & 1), first[2] + int64(k & 1))
        block = -1
        if at[0] <= last[0] and at[1] <= last[1] and at[2] <= last[2]:
            block = find_position(hash_block(at, cells.salt), cells.table)
        if block >= 0:
            for c in range(cells.blocks.starts[block], cells.blocks.starts[block + 1]):
                state = cells.states[c]
                if state >= 0 and state < v and waits == 0:
                    waits = 1
                    if cells.rank[state] + 1 == cells.cells.starts[c + 1]:  # the last vertex of its cell
                        if square_gap(p, cells.points[state]) >= cells.square_radius:
                            waits = 0
                other = -2 - state
                if state < NO_STATE and other < v:
                    if square_gap(p, cells.points[other]) < cells.square_radius and (earliest < 0 or other < earliest):
                        earliest = other
    if earliest < 0 and waits == 1:
        earliest = -2
    return earliest


@func
def decide_vertex(v: int, cells: Cells) -> int:
    """Decide a vertex if possible. 1 if decided. Only the thread of a cell's state writes. Others read whole words."""
    c = cells.of_point[v]
    state = cells.states[c]
    done = 1
    if state >= 0 and state <= v:
        done = 0
        if state == v:
            earliest = find_earlier_vertex(v, cells)
            if earliest == -1:
                cells.states[c] = -2 - v
                done = 1
            if earliest >= 0:
                after = cells.rank[v] + 1
                following = NO_STATE
                if after < cells.cells.starts[c + 1]:
                    following = cells.cells.order[after]
                cells.states[c] = following
                done = 1
    return done


@kernel
def try_vertices_kernel(rows: array(dtype=int32), cells: Cells, open_rows: array(dtype=uint8)):
    i = tid()
    open_rows[i] = uint8(1 - decide_vertex(rows[i], cells))


@kernel
def decide_rest_kernel(rows: array(dtype=int32), cells: Cells):
    i = tid()
    for j in range(i, rows.shape[0]):
        decide_vertex(rows[j], cells)


@kernel
def find_owners_kernel(cells: Cells, owners: array(dtype=int32)):
    i = tid()
    owner = i
    if cells.states[cells.of_point[i]] != -2 - i:
        owner = find_earlier_vertex(i, cells)
    owners[i] = owner


@kernel
def spread_owners_kernel(rows: array(dtype=int32), local_owners: array(dtype=int32), owners: array(dtype=int32)):
    i = tid()
    owners[rows[i]] = rows[local_owners[i]]


def find_close_vertices(vertices: Points, finite: Integers, max_distance: float, owners: Indices) -> None:
    """Write to `owners` (int32 [m]) which vertex, within `max_distance` [m], each ascending `finite` row follows."""
    device, count = vertices.device, finite.size
    if count == 0:
        return
    cells = Cells(gather_rows(vertices, finite), max_distance)
    rows = resolve_in_rounds(
        lambda rows, open_rows: launch(try_vertices_kernel, rows.size, [rows, cells, open_rows]), count, device
    )
    launch(decide_rest_kernel, min(1, rows.size), [rows, cells])
    local_owners = compute(find_owners_kernel, count, [cells], int32, device)
    launch(spread_owners_kernel, count, [finite, local_owners, owners])
