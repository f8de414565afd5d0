"""Shapes that fill many cells, cut into tiles for many threads.

One thread a shape draws those of up to SMALL cells, and lists the others; then groups of SIDE threads share out the
tiles of SIDE x SIDE cells of all that are listed, a column a thread, so that threads side by side write side by side.
The list has no order, since the smallest word of a cell wins in any. 12 B a shape. How many tiles there are stays on
the device: as many threads are launched as a device holds at once, whatever there is.
"""

from ..array_types import Device
from ..lang import array, atomic_add, func, int32, int64, loop, struct, vec4i
from ..memory import empty, zeros
from ..search.point_tree import find_run

SMALL = 256  # cells of a box that one thread draws
SIDE = 32  # [cells] of a tile, threads of a group
THREADS = 1 << 17
MOST_SHAPES = 1 << 20  # of a list
TILE_BITS = 43  # of a total: the number of tiles, below that of shapes
ONE_SHAPE = 1 << TILE_BITS
TILES = ONE_SHAPE - 1


@struct
class LargeShapes:
    """A list of shapes to be drawn in tiles.

    Attributes:
        shapes: int32 [most], their numbers.
        firsts: int64 [most], how many tiles those before it have.
        total: int64 [1], how many shapes there are above how many tiles.
    """

    shapes: array(dtype=int32)
    firsts: array(dtype=int64)
    total: array(dtype=int64)

    def __init__(self, most: int, device: Device) -> None:
        """An empty list for this many, up to MOST_SHAPES; with room for none threads draw whatever they have."""
        self.shapes, self.firsts = empty(most, int32, device), empty(most, int64, device)
        self.total = zeros(min(most, 1), int64, device)


@func
def is_large(box: vec4i, large: LargeShapes) -> int:
    """1 where a box (first and last column, first and last row) is for many threads."""
    columns = int64(max(box[1] - box[0] + 1, 0))
    rows = int64(max(box[3] - box[2] + 1, 0))
    return 1 if large.shapes.shape[0] > 0 and columns * rows > SMALL else 0


@func
def list_shape(i: int, box: vec4i, large: LargeShapes):
    """Put a shape on the list."""
    columns = (box[1] - box[0]) // SIDE + 1
    rows = (box[3] - box[2]) // SIDE + 1
    # where a shape stands in the list depends on the order of threads, what is seen does not
    before = atomic_add(large.total, 0, int64(ONE_SHAPE) + int64(columns) * int64(rows))
    entry = int(before >> int64(TILE_BITS))
    large.shapes[entry] = i
    large.firsts[entry] = before & int64(TILES)


@loop
def tiles_of_group(group: int, groups: int, large: LargeShapes) -> tuple[int, int]:
    """The shapes and the numbers of their tiles that a group of threads draws."""
    total = large.total[0]
    tile = int64(group)
    while tile < (total & int64(TILES)):
        entry = find_run(large.firsts, 0, int(total >> int64(TILE_BITS)), tile)
        shape = large.shapes[entry]
        number = int(tile - large.firsts[entry])
        yield shape, number
        tile += int64(groups)


@func
def column_of_tile(box: vec4i, tile: int, thread: int) -> vec4i:
    """The column of a box's tile that is a thread's, as a box."""
    columns = (box[1] - box[0]) // SIDE + 1
    column = box[0] + (tile % columns) * SIDE + thread
    row = box[2] + (tile // columns) * SIDE
    return vec4i(column, min(column, box[1]), row, min(row + SIDE - 1, box[3]))
