"""Rows of 8 voxels across the blocks of a volume: neighbours, and one bit a voxel.

Row r of the volume belongs to block r // 64 and holds its voxels (x, y, 0..7), x = r // 8 % 8, y = r % 8. A row's word
has the signs of its voxels and of the first voxel of the row above in bits 0..8 (set where the distance is negative),
and in bits 16..24 which of these voxels are seen often enough.
"""

from ..arrays.block_keys import BIAS, block_key, key_block
from ..arrays.hash_table import find_position
from ..lang import array, float32, func, int32, int64, kernel, launch, tid, uint16
from ..memory import empty
from .tsdf_blocks import ROWS, SIDE

AROUND = 27  # a block and its neighbours; (dx, dy, dz) stands at 9 dx + 3 dy + dz + 13
VALID = 16  # shift of the bits that say which voxels are valid
NINE = 0x1FF
EIGHT = 0xFF


@kernel
def find_neighbors_kernel(
    block_keys: array(dtype=int64),
    mask: int64,
    keys: array(dtype=int64),
    positions: array(dtype=int32),
    neighbors: array(dtype=int32),
):
    """The 27 blocks around each block, itself among them; -1 where there is none."""
    i = tid()
    block = key_block(block_keys[i // AROUND])
    side = i % AROUND
    x = block[0] + side // 9 - 1
    y = block[1] + side // 3 % 3 - 1
    z = block[2] + side % 3 - 1
    found = int(-1)
    if max(max(abs(x), abs(y)), abs(z)) < BIAS - 1:  # the key of the last block of all means an empty slot
        found = find_position(keys, positions, mask, block_key(x, y, z))
    neighbors[i] = found


@func
def offset_of(c: int) -> int:
    """The block that a local coordinate in -8..15 falls into: -1, 0 or 1."""
    o = int(0)
    if c < 0:
        o = int(-1)
    if c >= SIDE:
        o = int(1)
    return o


@func
def row_near(neighbors: array(dtype=int32), block: int, x: int, y: int, dz: int) -> int:
    """The row at local (x, y), each in -8..15, of a block or its neighbours; -1 where there is no block."""
    dx = offset_of(x)
    dy = offset_of(y)
    other = neighbors[block * AROUND + 13 + 9 * dx + 3 * dy + dz]
    row = int(-1)
    if other >= 0:
        row = other * ROWS + (x - dx * SIDE) * SIDE + (y - dy * SIDE)
    return row


@func
def voxel_near(neighbors: array(dtype=int32), block: int, x: int, y: int, z: int) -> int:
    """The voxel at local (x, y, z), each in -8..15; -1 where there is no block."""
    dz = offset_of(z)
    row = row_near(neighbors, block, x, y, dz)
    voxel = int(-1)
    if row >= 0:
        voxel = row * SIDE + z - dz * SIDE
    return voxel


@func
def word_near(words: array(dtype=int32), neighbors: array(dtype=int32), block: int, x: int, y: int, dz: int) -> int:
    """A row's word, 0 (nothing valid) where there is no block."""
    row = row_near(neighbors, block, x, y, dz)
    word = int(0)
    if row >= 0:
        word = words[row]
    return word


@kernel
def pack_rows_kernel(
    distances: array(dtype=float32), weights: array(dtype=uint16), threshold: float, words: array(dtype=int32)
):
    """Signs and validity of the 8 voxels of each row; a voxel is valid where its weight exceeds the threshold."""
    i = tid()
    word = int(0)
    for j in range(SIDE):
        at = i * SIDE + j
        if float(weights[at]) > threshold:
            word = word | (1 << (j + VALID))
            if distances[at] < 0.0:
                word = word | (1 << j)
    words[i] = word


@kernel
def extend_rows_kernel(words: array(dtype=int32), neighbors: array(dtype=int32), extended: array(dtype=int32)):
    """Add the first voxel of the row above, in bits 8 and 24."""
    i = tid()
    block = i // ROWS
    word = words[i]
    above = neighbors[block * AROUND + 14]
    if above >= 0:
        first = words[above * ROWS + i % ROWS]
        word = word | ((first & 1) << SIDE) | (((first >> VALID) & 1) << (VALID + SIDE))
    extended[i] = word


def find_neighbors(block_keys, table):
    """The 27 blocks around each of the int64 keys, int32 [m * 27]; `table` is the HashTable of the keys."""
    neighbors = empty(block_keys.size * AROUND, int32, block_keys.device)
    launch(find_neighbors_kernel, neighbors.size, [block_keys, *table.arguments, neighbors])
    return neighbors


def pack_rows(distances, weights, threshold, neighbors):
    """Extended words of all rows, int32 [m * 64]."""
    count, device = neighbors.size // AROUND * ROWS, neighbors.device
    words, extended = empty(count, int32, device), empty(count, int32, device)
    launch(pack_rows_kernel, count, [distances, weights, float(threshold), words])
    launch(extend_rows_kernel, count, [words, neighbors, extended])
    return extended
