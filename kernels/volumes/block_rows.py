"""Rows of 8 voxels across the blocks of a volume: neighbours, and one bit a voxel.

Row r of the volume belongs to block r // 64 and holds its voxels (x, y, 0..7), x = r // 8 % 8, y = r % 8. A row's word
has the signs of its voxels and of the first voxel of the row above in bits 0..8 (set where the distance is negative),
and in bits 16..24 which of these voxels are seen often enough.
"""

from typing import TYPE_CHECKING

from ..array_types import Device, Indices, Integers
from ..arrays.block_keys import BIAS, block_key, key_block
from ..arrays.hash_table import find_position
from ..lang import array, func, int32, kernel, launch, struct, tid
from ..memory import copy, empty
from .tsdf_blocks import ROWS, SIDE
from .voxel_blocks import VoxelBlocks

if TYPE_CHECKING:
    from ..arrays.changes import Changes

AROUND = 27  # a block and its neighbours; (dx, dy, dz) stands at 9 dx + 3 dy + dz + 13
VALID = 16  # shift of the bits that say which voxels are valid
NINE = 0x1FF
EIGHT = 0xFF


@struct
class SeenBlocks:
    """The blocks of a volume and their neighbours, as far as enough frames have seen them.

    Attributes:
        blocks: The VoxelBlocks.
        neighbors: int32 [blocks * 27 or more], the positions of the blocks around each; -1 where there is none.
        threshold: Voxels seen by no more frames than this are as if absent.
        row_count: Rows of 8 voxels.
    """

    blocks: VoxelBlocks
    neighbors: array(dtype=int32)
    threshold: float

    def __init__(self, blocks: VoxelBlocks, threshold: float) -> None:
        self.blocks, self.threshold, self.row_count = blocks, float(threshold), blocks.count * ROWS
        self.neighbors = neighbors_of(blocks)


class BlockNeighbors:
    """The neighbours of a volume's blocks, kept with it and taken further as it grows.

    Attributes:
        listed: Positions int32 [27 a block or more]; those of the first `count` blocks are known.
        changes: The Changes of the list of blocks that they are of.
    """

    def __init__(self, changes: "Changes", device: Device) -> None:
        self.changes, self.listed, self.count = changes, empty(0, int32, device), 0

    def update(self, blocks: VoxelBlocks) -> Integers:
        """The neighbours of all blocks; a repeated update after an interruption writes the same."""
        count, known = blocks.count, self.count
        if count > known:
            listed = self.listed
            if listed.size < count * AROUND:
                listed = empty(blocks.keys.size * AROUND, int32, blocks.device)
                if known:
                    copy(listed, self.listed, count=known * AROUND)
            launch(find_neighbors_kernel, (count - known) * AROUND, [blocks, known, listed])
            self.listed, self.count = listed, count
        return self.listed


def neighbors_of(blocks: VoxelBlocks) -> Indices:
    """The 27 blocks around each block of VoxelBlocks, int32 [27 a block or more]."""
    kept = blocks.kept.get("neighbors")
    if kept is None or kept.changes is not blocks.changes:
        kept = blocks.kept["neighbors"] = BlockNeighbors(blocks.changes, blocks.device)
    return kept.update(blocks)


@kernel
def find_neighbors_kernel(blocks: VoxelBlocks, known: int, neighbors: array(dtype=int32)):
    """The 27 blocks around each new block, itself among them; -1 where there is none. Known blocks get new ones."""
    i = tid()
    position = known + i // AROUND
    block = key_block(blocks.keys[position])
    side = i % AROUND
    x = block[0] + side // 9 - 1
    y = block[1] + side // 3 % 3 - 1
    z = block[2] + side % 3 - 1
    found = -1
    if max(max(abs(x), abs(y)), abs(z)) < BIAS - 1:  # the key of the last block of all means an empty slot
        found = find_position(block_key(x, y, z), blocks.table)
    neighbors[position * AROUND + side] = found
    if found >= 0 and found < known:
        neighbors[found * AROUND + AROUND - 1 - side] = position  # no other thread has this pair


@func
def offset_of(c: int) -> int:
    """The block that a local coordinate in -8..15 falls into: -1, 0 or 1."""
    o = 0
    if c < 0:
        o = -1
    if c >= SIDE:
        o = 1
    return o


@func
def row_near(block: int, x: int, y: int, dz: int, seen: SeenBlocks) -> int:
    """The row at local (x, y), each in -8..15, of a block or its neighbours; -1 where there is no block."""
    dx = offset_of(x)
    dy = offset_of(y)
    other = seen.neighbors[block * AROUND + 13 + 9 * dx + 3 * dy + dz]
    row = -1
    if other >= 0:
        row = other * ROWS + (x - dx * SIDE) * SIDE + (y - dy * SIDE)
    return row


@func
def voxel_near(block: int, x: int, y: int, z: int, seen: SeenBlocks) -> int:
    """The voxel at local (x, y, z), each in -8..15; -1 where there is no block."""
    dz = offset_of(z)
    row = row_near(block, x, y, dz, seen)
    voxel = -1
    if row >= 0:
        voxel = row * SIDE + z - dz * SIDE
    return voxel


@func
def word_near(words: array(dtype=int32), block: int, x: int, y: int, dz: int, seen: SeenBlocks) -> int:
    """A row's word, 0 (nothing valid) where there is no block."""
    row = row_near(block, x, y, dz, seen)
    word = 0
    if row >= 0:
        word = words[row]
    return word


@func
def signs_of(voxel: int, place: int, seen: SeenBlocks) -> int:
    """A voxel's bits in a word; it is valid where its weight exceeds the threshold."""
    word = 0
    if float(seen.blocks.weights[voxel]) > seen.threshold:
        word = 1 << (place + VALID)
        if seen.blocks.distances[voxel] < 0.0:
            word = word | (1 << place)
    return word


@kernel
def pack_rows_kernel(seen: SeenBlocks, words: array(dtype=int32)):
    """Signs and validity of the 8 voxels of each row, and of the first voxel of the row above."""
    i = tid()
    word = 0
    for j in range(SIDE):
        word = word | signs_of(i * SIDE + j, j, seen)
    above = seen.neighbors[i // ROWS * AROUND + 14]
    if above >= 0:
        word = word | signs_of((above * ROWS + i % ROWS) * SIDE, SIDE, seen)
    words[i] = word


def pack_rows(seen: SeenBlocks) -> Integers:
    """The words of all rows of SeenBlocks, int32 [blocks * 64]."""
    words = empty(seen.row_count, int32, seen.neighbors.device)
    launch(pack_rows_kernel, seen.row_count, [seen, words])
    return words
