"""Cells of a volume in which rays may meet a surface: one bit per cell with a corner behind a surface.

A block has a 64-bit word per slice x, bit 8 y + z. A voxel's bit is set if it was observed with a distance <= 0, a
cell's bit if one of its corners is. Only touched blocks are updated: 6 B read per voxel, 128 B stored per block.
"""

import weakref
from typing import TYPE_CHECKING

from ..array_types import Device
from ..lang import array, func, int32, int64, kernel, launch, struct, tid
from ..memory import empty
from .block_rows import BLOCKS_AROUND, neighbors_of
from .tsdf_blocks import BLOCK_SIDE
from .voxel_blocks import VoxelBlocks

if TYPE_CHECKING:
    from ..arrays.atomic_changes import Changes

MIDDLE_BLOCK = 13  # index of a block among its neighbors
LOW_SEVEN = 0x7F7F7F7F7F7F7F7F  # voxels with one above along z in the slice
LOWEST_BITS = 0x0101010101010101
LOW_SEVEN_ROWS = 0x00FFFFFFFFFFFFFF  # y
LOW_Y = 0x00000000FFFFFFFF
LOW_Z = 0x0F0F0F0F0F0F0F0F
PART_CELLS = BLOCK_SIDE // 2  # cells per edge of a part
PARTS_PER_BLOCK = 8  # of a block, bit 4 x + 2 y + z


@struct
class BlockSigns:
    """Cells that may contain a surface: int64 per slice for voxels (`signs`) and cells, and a bit per 4^3 part."""

    signs: array(dtype=int64)
    cells: array(dtype=int64)
    parts: array(dtype=int32)

    def __init__(self, changes: "Changes", device: Device) -> None:
        self.changes, self.number = changes, -1
        self._voxels = ()
        self.signs, self.cells, self.parts = (empty(0, t, device) for t in (int64, int64, int32))

    def update(self, blocks: VoxelBlocks) -> None:
        """Update the bits. A repetition after an interruption writes the same values."""
        count, number = blocks.count, blocks.frame_count
        voxels = (blocks.distances, blocks.weights)
        is_same = len(self._voxels) == 2 and all(a() is b for a, b in zip(self._voxels, voxels, strict=True))
        if is_same and number == self.number:
            return
        frame, touched = blocks.latest
        if self.parts.size < count:
            self._reserve(blocks.keys.size)
            is_same = False
        if is_same and number == frame == self.number + 1:
            launch(find_touched_signs_kernel, touched.size * BLOCK_SIDE, [touched, blocks, self.signs])
        else:
            launch(find_signs_kernel, count * BLOCK_SIDE, [blocks, self.signs])
        launch(find_cells_with_signs_kernel, count, [neighbors_of(blocks), self.signs, self.cells, self.parts])
        self._voxels, self.number = tuple(weakref.ref(a) for a in voxels), number

    def _reserve(self, count: int) -> None:
        device = self.signs.device
        self.number = -1
        self.signs, self.cells = (empty(count * BLOCK_SIDE, int64, device) for _ in range(2))
        self.parts = empty(count, int32, device)


def signs_of(blocks: VoxelBlocks) -> BlockSigns:
    cached = blocks.cache.get("signs")
    if cached is None or cached.changes is not blocks.changes:
        cached = blocks.cache["signs"] = BlockSigns(blocks.changes, blocks.device)
    cached.update(blocks)
    return cached


@func
def slice_signs(layer: int, blocks: VoxelBlocks) -> int64:
    word = int64(0)
    n = int(8)
    for y in range(n):
        row = 0
        for z in range(8):
            voxel = (layer * BLOCK_SIDE + y) * BLOCK_SIDE + z
            row = row | ((int(blocks.distances[voxel] <= 0.0) & int(int(blocks.weights[voxel]) > 0)) << z)
        word = word | (int64(row) << int64(8 * y))
    return word


@kernel
def find_signs_kernel(blocks: VoxelBlocks, signs: array(dtype=int64)):
    i = tid()
    signs[i] = slice_signs(i, blocks)


@kernel
def find_touched_signs_kernel(touched: array(dtype=int32), blocks: VoxelBlocks, signs: array(dtype=int64)):
    i = tid()
    layer = touched[i // BLOCK_SIDE] * BLOCK_SIDE + i % BLOCK_SIDE
    signs[layer] = slice_signs(layer, blocks)


@func
def slice_at(block: int, x: int, signs: array(dtype=int64)) -> int64:
    word = int64(0)
    if block >= 0:
        word = signs[block * BLOCK_SIDE + x]
    return word


@func
def spread_slice(first: int, x: int, neighbors: array(dtype=int32), signs: array(dtype=int64)) -> int64:
    """Bits y, z of a slice x, combined with those one above along y, z or both. `first`: first neighbor in layer."""
    w = slice_at(neighbors[first], x, signs)
    above_z = slice_at(neighbors[first + 1], x, signs)
    above_y = slice_at(neighbors[first + 3], x, signs)
    above = slice_at(neighbors[first + 4], x, signs)
    w = w | ((w >> 1) & int64(LOW_SEVEN)) | ((above_z & int64(LOWEST_BITS)) << 7)
    up = above_y | ((above_y >> 1) & int64(LOW_SEVEN)) | ((above & int64(LOWEST_BITS)) << 7)
    return w | ((w >> 8) & int64(LOW_SEVEN_ROWS)) | (up << 56)


@func
def parts_of(word: int64) -> int:
    y_low = word & int64(LOW_Y)
    y_high = (word >> 32) & int64(LOW_Y)
    parts = int((y_low & int64(LOW_Z)) != 0) | (int((y_low & ~int64(LOW_Z)) != 0) << 1)
    return parts | (int((y_high & int64(LOW_Z)) != 0) << 2) | (int((y_high & ~int64(LOW_Z)) != 0) << 3)


@kernel
def find_cells_with_signs_kernel(
    neighbors: array(dtype=int32), signs: array(dtype=int64), cells: array(dtype=int64), parts: array(dtype=int32)
):
    """Cells of a block with a corner behind a surface. Cells of the last slices use the blocks above."""
    i = tid()
    first = i * BLOCKS_AROUND + MIDDLE_BLOCK
    word = spread_slice(first, 0, neighbors, signs)
    low = int64(0)
    high = int64(0)
    n = int(8)
    for x in range(n):
        following = int64(0)
        if x < BLOCK_SIDE - 1:
            following = spread_slice(first, x + 1, neighbors, signs)
        else:
            following = spread_slice(first + 9, 0, neighbors, signs)
        word = word | following
        cells[i * BLOCK_SIDE + x] = word
        if x < PART_CELLS:
            low = low | word
        else:
            high = high | word
        word = following
    parts[i] = parts_of(low) | (parts_of(high) << 4)
