"""Rows of 8 voxels in volume blocks: neighbor lookup, and one bit per voxel.

Row r belongs to block r // 64 and contains voxels (x, y, 0..7), x = r // 8 % 8, y = r % 8. In its word, bits 0..8 are
set for negative distances of its voxels and the first voxel above, bits 16..24 for sufficient observations.
"""

from typing import TYPE_CHECKING

from ..array_types import Device, Indices, Integers
from ..arrays.block_keys import CELL_BIAS, block_key, key_block
from ..arrays.hash_table import find_position
from ..lang import array, compute, func, int32, kernel, launch, struct, tid
from ..memory import copy, empty
from .tsdf_blocks import BLOCK_ROWS, BLOCK_SIDE
from .voxel_blocks import VoxelBlocks

if TYPE_CHECKING:
    from ..arrays.atomic_changes import Changes

BLOCKS_AROUND = 27  # a block and its neighbors; (dx, dy, dz) is at 9 dx + 3 dy + dz + 13
VALID_SHIFT = 16  # shift of the validity bits
NINE_BITS = 0x1FF
EIGHT_BITS = 0xFF


@struct
class SeenBlocks:
    """Blocks with their 27 neighbors (int32, -1 for none). Voxels with at most `threshold` frames count as absent."""

    blocks: VoxelBlocks
    neighbors: array(dtype=int32)
    threshold: float

    def __init__(self, blocks: VoxelBlocks, threshold: float) -> None:
        self.blocks, self.threshold, self.row_count = blocks, float(threshold), blocks.count * BLOCK_ROWS
        self.neighbors = neighbors_of(blocks)


class BlockNeighbors:
    """Cached neighbors of a volume's blocks, extended as it grows. The first `count` blocks are complete."""

    def __init__(self, changes: "Changes", device: Device) -> None:
        self.changes, self.listed, self.count = changes, empty(0, int32, device), 0

    def update(self, blocks: VoxelBlocks) -> Integers:
        """Complete the neighbors of all blocks. A repetition after an interruption writes the same values."""
        count, known = blocks.count, self.count
        if count > known:
            listed = self.listed
            if listed.size < count * BLOCKS_AROUND:
                listed = empty(blocks.keys.size * BLOCKS_AROUND, int32, blocks.device)
                if known:
                    copy(listed, self.listed, count=known * BLOCKS_AROUND)
            launch(find_neighbors_kernel, (count - known) * BLOCKS_AROUND, [blocks, known, listed])
            self.listed, self.count = listed, count
        return self.listed


def neighbors_of(blocks: VoxelBlocks) -> Indices:
    cached = blocks.cache.get("neighbors")
    if cached is None or cached.changes is not blocks.changes:
        cached = blocks.cache["neighbors"] = BlockNeighbors(blocks.changes, blocks.device)
    return cached.update(blocks)


@kernel
def find_neighbors_kernel(blocks: VoxelBlocks, known: int, neighbors: array(dtype=int32)):
    """The 27 blocks around each new block including itself, or -1. Known blocks get new neighbors."""
    i = tid()
    position = known + i // BLOCKS_AROUND
    block = key_block(blocks.keys[position])
    side = i % BLOCKS_AROUND
    x = block[0] + side // 9 - 1
    y = block[1] + side // 3 % 3 - 1
    z = block[2] + side % 3 - 1
    neighbor = -1
    if max(max(abs(x), abs(y)), abs(z)) < CELL_BIAS - 1:  # the key of the last possible block means an empty slot
        neighbor = find_position(block_key(x, y, z), blocks.table)
    neighbors[position * BLOCKS_AROUND + side] = neighbor
    if neighbor >= 0 and neighbor < known:
        neighbors[neighbor * BLOCKS_AROUND + BLOCKS_AROUND - 1 - side] = position  # no other thread has this pair


@func
def offset_of(c: int) -> int:
    """Block of a local coordinate in -8..15: -1, 0 or 1."""
    o = 0
    if c < 0:
        o = -1
    if c >= BLOCK_SIDE:
        o = 1
    return o


@func
def row_near(block: int, x: int, y: int, dz: int, seen: SeenBlocks) -> int:
    """Row at local (x, y), each in -8..15, or -1."""
    dx = offset_of(x)
    dy = offset_of(y)
    other = seen.neighbors[block * BLOCKS_AROUND + 13 + 9 * dx + 3 * dy + dz]
    row = -1
    if other >= 0:
        row = other * BLOCK_ROWS + (x - dx * BLOCK_SIDE) * BLOCK_SIDE + (y - dy * BLOCK_SIDE)
    return row


@func
def voxel_near(block: int, x: int, y: int, z: int, seen: SeenBlocks) -> int:
    """Voxel at local (x, y, z), each in -8..15, or -1."""
    dz = offset_of(z)
    row = row_near(block, x, y, dz, seen)
    voxel = -1
    if row >= 0:
        voxel = row * BLOCK_SIDE + z - dz * BLOCK_SIDE
    return voxel


@func
def word_near(words: array(dtype=int32), block: int, x: int, y: int, dz: int, seen: SeenBlocks) -> int:
    """Word of a row, 0 (nothing valid) without a block."""
    row = row_near(block, x, y, dz, seen)
    word = 0
    if row >= 0:
        word = words[row]
    return word


@func
def signs_of(voxel: int, index: int, seen: SeenBlocks) -> int:
    """A voxel's bits in a word. It is valid if its weight exceeds the threshold."""
    word = 0
    if float(seen.blocks.weights[voxel]) > seen.threshold:
        word = 1 << (index + VALID_SHIFT)
        if seen.blocks.distances[voxel] < 0.0:
            word = word | (1 << index)
    return word


@kernel
def pack_rows_kernel(seen: SeenBlocks, words: array(dtype=int32)):
    i = tid()
    word = 0
    for j in range(BLOCK_SIDE):
        word = word | signs_of(i * BLOCK_SIDE + j, j, seen)
    above = seen.neighbors[i // BLOCK_ROWS * BLOCKS_AROUND + 14]
    if above >= 0:
        word = word | signs_of((above * BLOCK_ROWS + i % BLOCK_ROWS) * BLOCK_SIDE, BLOCK_SIDE, seen)
    words[i] = word


def pack_rows(seen: SeenBlocks) -> Integers:
    return compute(pack_rows_kernel, seen.row_count, [seen], int32, seen.neighbors.device)
