"""Which vertices are close to an earlier one: greedy in the order of their numbers, with many threads at once.

A vertex stays where no earlier one that stayed lies within the reach; else it follows the earliest of those. So the
vertices that stay are the first maximal independent set by number, which is one set whatever the order of the threads
(Blelloch, Fineman and Shun, "Greedy sequential maximal independent set and matching are parallel on average", SPAA
2012): a vertex is settled once the earlier ones about it are.

Vertices lie in cells of half the reach, whose diagonal is shorter than the reach: at most one vertex of a cell stays,
and the others after it follow. So a vertex looks at the states of at most 512 cells, whatever the reach and however
many vertices lie in it, and the time is linear. Cells stand in blocks of 4 x 4 x 4, found by a hash of their
coordinates; where two blocks have one hash another one is taken. A vertex reaches into at most eight blocks. A round
lets all vertices try that come first in their cells; after 64 rounds, which only chains of thousands of vertices in
the order of their numbers need, one thread goes through the rest. About 130 B a vertex.
"""

from ..algebra.transform import widen
from ..array_types import Indices, Integers, Points
from ..arrays.hash_table import HashTable, find_position, list_keys, mix_bits
from ..arrays.open_rows import settle_in_rounds
from ..arrays.select import gather_rows
from ..arrays.sort import argsort_keys
from ..arrays.unique import UniqueKeys, cut_together
from ..lang import (
    array,
    atomic_max,
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
from .mesh_edges import run_places

HASH_BITS = 57  # of a block
CELL_BITS = 6  # of a cell in it
NO_STATE = -1  # of a cell in which none stayed
WIDER = 1 + 1e-6  # cells than half the reach: more than coordinates of up to 1e10 times the reach round by
cell = vector(3, int64)


@func
def block_of(p: vec3d, side: float64) -> cell:
    """The block that a point lies in."""
    return cell(int64(floor(p[0] / side)), int64(floor(p[1] / side)), int64(floor(p[2] / side)))


@func
def hash_block(at: cell, salt: int64) -> int64:
    """A hash of a block's coordinates."""
    h = mix_bits(at[0] + salt)
    h = mix_bits((h ^ at[1]) + salt)
    h = mix_bits((h ^ at[2]) + salt)
    return h & ((1 << int64(HASH_BITS)) - 1)


@kernel
def hash_cells_kernel(points: array(dtype=vec3), side: float64, salt: int64, keys: array(dtype=int64)):
    """The hash of a point's block, and which of its cells the point lies in."""
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
    """Set where two blocks of one hash are not the same; keys are sorted, and any thread may set it."""
    i = tid()
    if i > 0:
        if (keys[i] >> int64(CELL_BITS)) == (keys[i - 1] >> int64(CELL_BITS)):
            a = block_of(widen(points[order[i]]), side)
            b = block_of(widen(points[order[i - 1]]), side)
            if a[0] != b[0] or a[1] != b[1] or a[2] != b[2]:
                atomic_max(differ, 0, 1)


@kernel
def list_blocks_kernel(keys: array(dtype=int64), blocks: array(dtype=int64)):
    """The hash of the block that each point lies in."""
    i = tid()
    blocks[i] = keys[i] >> int64(CELL_BITS)


@kernel
def begin_at_cells_kernel(own: array(dtype=int32), cell_count: int, starts: array(dtype=int32)):
    """Where the cells of each block begin, in the place of where its points do; and the end of all."""
    i = tid()
    starts[i] = own[starts[i]]
    if i + 2 == starts.shape[0]:
        starts[i + 1] = cell_count


@kernel
def begin_states_kernel(cells: UniqueKeys, states: array(dtype=int32)):
    """The first vertex of each cell is the one to settle."""
    i = tid()
    states[i] = cells.order[cells.starts[i]]


@kernel
def place_points_kernel(
    cells: UniqueKeys, own: array(dtype=int32), of_point: array(dtype=int32), place: array(dtype=int32)
):
    """The cell and the place of each point."""
    i = tid()
    of_point[cells.order[i]] = own[i]
    place[cells.order[i]] = i


@struct
class Cells:
    """Points in cells of half the reach.

    Coordinates beyond 1e10 times the reach differ by more than the reach in float32, or not at all.

    Attributes:
        cells: UniqueKeys of the cells; points of a cell stand by their numbers.
        blocks: UniqueKeys of the blocks; their `starts` are those of cells, which stand in their order.
        table: HashTable of the blocks.
        of_point, place: int32 [n], the cell of each point, and where it stands.
        states: int32, one a cell: the vertex to settle next; NO_STATE: none of it stayed; -2 - v: vertex v stayed.
    """

    cells: UniqueKeys
    blocks: UniqueKeys
    table: HashTable
    points: array(dtype=vec3)
    of_point: array(dtype=int32)
    place: array(dtype=int32)
    states: array(dtype=int32)
    side: float64
    reach: float64
    salt: int64

    def __init__(self, points: Points, reach: float) -> None:
        device, count = points.device, points.size
        self.points, self.salt = points, 0
        self.reach = float(reach) * float(reach)
        self.side = 2 * float(reach) * WIDER
        while True:
            keys = empty(count, int64, device)
            launch(hash_cells_kernel, count, [points, self.side, self.salt, keys])
            keys, order = argsort_keys(keys, HASH_BITS + CELL_BITS)
            self.cells = UniqueKeys(keys, in_order=(keys, order), padded=True)
            blocks, differ = empty(count, int64, device), zeros(1, int32, device)
            launch(list_blocks_kernel, count, [keys, blocks])
            self.blocks = UniqueKeys(blocks, in_order=(blocks, order), padded=True)
            launch(compare_blocks_kernel, count, [points, self.side, keys, order, differ])
            if not cut_together([self.cells, self.blocks], differ)[0][0]:  # sync
                break
            self.salt += 1
        own = run_places(self.cells, count)
        launch(begin_at_cells_kernel, self.blocks.count, [own, self.cells.count, self.blocks.starts])
        self.table = list_keys(self.blocks.keys, self.blocks.count)
        self.of_point, self.place = empty(count, int32, device), empty(count, int32, device)
        launch(place_points_kernel, count, [self.cells, own, self.of_point, self.place])
        self.states = empty(self.cells.count, int32, device)
        launch(begin_states_kernel, self.cells.count, [self.cells, self.states])


@func
def square_gap(p: vec3, q: vec3) -> float64:
    """The squared distance [m^2] of two points, in float64."""
    d = widen(p) - widen(q)
    return dot(d, d)


@func
def look_around(v: int, cells: Cells) -> int:
    """The earliest vertex that stayed before v within its reach; -1 where there is none; -2 where one is not settled.

    A vertex that is not settled counts wherever it lies in its cell: waiting for it changes no result.
    """
    p = cells.points[v]
    half = cells.side * 0.5
    first = block_of(widen(p) - vec3d(half, half, half), cells.side)
    last = block_of(widen(p) + vec3d(half, half, half), cells.side)
    found = -1
    waits = 0
    n = int(8)
    for k in range(n):
        at = cell(first[0] + int64(k >> 2), first[1] + int64((k >> 1) & 1), first[2] + int64(k & 1))
        place = -1
        if at[0] <= last[0] and at[1] <= last[1] and at[2] <= last[2]:
            place = find_position(hash_block(at, cells.salt), cells.table)
        if place >= 0:
            for c in range(cells.blocks.starts[place], cells.blocks.starts[place + 1]):
                state = cells.states[c]
                if state >= 0 and state < v:
                    waits = 1
                other = -2 - state
                if state < NO_STATE and other < v:
                    if square_gap(p, cells.points[other]) < cells.reach and (found < 0 or other < found):
                        found = other
    if found < 0 and waits == 1:
        found = -2
    return found


@func
def settle(v: int, cells: Cells) -> int:
    """Settle a vertex where its turn has come: 1 where it is settled now or was before.

    Only the thread of the vertex that a cell's state names writes there, and its neighbours read whole words, so they
    see it settled or not.
    """
    c = cells.of_point[v]
    state = cells.states[c]
    done = 1
    if state >= 0 and state <= v:
        done = 0
        if state == v:
            found = look_around(v, cells)
            if found == -1:
                cells.states[c] = -2 - v
                done = 1
            if found >= 0:
                after = cells.place[v] + 1
                following = NO_STATE
                if after < cells.cells.starts[c + 1]:
                    following = cells.cells.order[after]
                cells.states[c] = following
                done = 1
    return done


@kernel
def try_vertices_kernel(rows: array(dtype=int32), cells: Cells, open_rows: array(dtype=uint8)):
    """Settle those whose turn has come; 1 for the others."""
    i = tid()
    open_rows[i] = uint8(1 - settle(rows[i], cells))


@kernel
def settle_rest_kernel(rows: array(dtype=int32), cells: Cells):
    """Settle all in their order; one thread."""
    i = tid()
    for j in range(i, rows.shape[0]):
        settle(rows[j], cells)


@kernel
def find_owners_kernel(cells: Cells, owners: array(dtype=int32)):
    """The vertex that each one follows, itself where it stayed."""
    i = tid()
    owner = i
    if cells.states[cells.of_point[i]] != -2 - i:
        owner = look_around(i, cells)
    owners[i] = owner


@kernel
def spread_owners_kernel(rows: array(dtype=int32), found: array(dtype=int32), owners: array(dtype=int32)):
    """Owners by the rows of all vertices."""
    i = tid()
    owners[rows[i]] = rows[found[i]]


def find_close_vertices(vertices: Points, finite: Integers, reach: float, owners: Indices) -> None:
    """Write which vertex each of some follows.

    Args:
        vertices: vec3 [m].
        finite: int32 [n], the rows that take part, ascending.
        reach: [m] a Python number; vertices closer than it are close.
        owners: int32 [m], written at those rows.
    """
    device, count = vertices.device, finite.size
    if count == 0:
        return
    cells = Cells(gather_rows(vertices, finite), reach)
    rows = settle_in_rounds(
        lambda rows, open_rows: launch(try_vertices_kernel, rows.size, [rows, cells, open_rows]), count, device
    )
    launch(settle_rest_kernel, min(1, rows.size), [rows, cells])
    found = empty(count, int32, device)
    launch(find_owners_kernel, count, [cells, found])
    launch(spread_owners_kernel, count, [finite, found, owners])
