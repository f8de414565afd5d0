"""Levels of an adaptive octree as arrays: cells and corners in blocks of eight.

Level d has 2^d cells per axis. A cell and its lowest corner share a slot, and eight slots with the same halved position
form a block (x + 2 y + 4 z), the child of a slot of level d - 1: no hash is needed. Blocks with a divided parent
contain cells, halo blocks only corners. A cell is divided together with its 26 neighbors, so adjacent cells differ by
one level at most. 180 B per block.
"""

import numpy as np

from ..array_types import Device, Integers
from ..arrays.prefix_sum import exclusive_scan, offsets_of
from ..lang import array, compute, func, int32, kernel, launch, struct, tid, uint8, vec3i
from ..memory import check_room, empty, fill, full, upload, zeros

BLOCK_SLOTS = 8  # of a block
BLOCKS_AROUND = 27  # blocks around a block, including itself


@struct
class OctreeLevel:
    """One level of the tree with `count` blocks of eight slots. `positions` are half the positions of first slots.
    `parents` are slots of the level above (-1 on level 1). `around` are the 27 blocks around each, x slowest, -1 for
    none. `children` are blocks of the next level by slot, or -1."""

    depth: int
    count: int
    positions: array(dtype=vec3i)
    parents: array(dtype=int32)
    has_cells: array(dtype=uint8)
    around: array(dtype=int32)
    divided: array(dtype=uint8)
    children: array(dtype=int32)

    def __init__(self, depth: int, count: int, device: Device) -> None:
        self.depth, self.count, self.device = depth, count, device
        self.positions, self.parents = empty(count, vec3i, device), empty(count, int32, device)
        self.has_cells, self.around = empty(count, uint8, device), empty(BLOCKS_AROUND * count, int32, device)
        self.divided, self.children = (
            zeros(BLOCK_SLOTS * count, uint8, device),
            full(BLOCK_SLOTS * count, -1, int32, device),
        )


@func
def slot_beside(around: array(dtype=int32), block: int, x: int, y: int, z: int) -> int:
    """Slot at (x, y, z), each -2..3, from the first slot of a block, or -1 for none."""
    other = around[BLOCKS_AROUND * block + 9 * ((x >> 1) + 1) + 3 * ((y >> 1) + 1) + (z >> 1) + 1]
    slot = -1
    if other >= 0:
        slot = BLOCK_SLOTS * other + (x & 1) + 2 * (y & 1) + 4 * (z & 1)
    return slot


@func
def slot_position(slot: int, level: OctreeLevel) -> vec3i:
    position = level.positions[slot // BLOCK_SLOTS]
    return vec3i(2 * position[0] + (slot & 1), 2 * position[1] + ((slot >> 1) & 1), 2 * position[2] + ((slot >> 2) & 1))


@func
def is_cell(slot: int, level: OctreeLevel) -> int:
    flag = 0
    if slot >= 0:
        flag = int(level.has_cells[slot // BLOCK_SLOTS])
    return flag


@func
def is_divided(slot: int, level: OctreeLevel) -> int:
    flag = 0
    if slot >= 0:
        flag = int(level.divided[slot])
    return flag


@func
def neighbor_slot(slot: int, x: int, y: int, z: int, level: OctreeLevel) -> int:
    """Slot at an offset of -2..2 per axis, or -1."""
    return slot_beside(
        level.around, slot // BLOCK_SLOTS, x + (slot & 1), y + ((slot >> 1) & 1), z + ((slot >> 2) & 1)
    )  # fmt: skip


@kernel
def divide_around_kernel(wanted: array(dtype=int32), level: OctreeLevel):
    """Divide the given cells (-1 for none) and their neighbors. All threads write 1."""
    i = tid()
    n = int(3)
    if wanted[i] < 0:
        n = 0
    for x in range(n):
        for y in range(n):
            for z in range(n):
                slot = neighbor_slot(wanted[i], x - 1, y - 1, z - 1, level)
                if is_cell(slot, level) == 1:
                    level.divided[slot] = 1


@kernel
def divide_all_kernel(level: OctreeLevel):
    i = tid()
    level.divided[i] = level.has_cells[i // BLOCK_SLOTS]


@kernel
def mark_children_kernel(level: OctreeLevel, marks: array(dtype=int32)):
    i = tid()
    mark = 0
    n = int(2)
    for x in range(n):
        for y in range(n):
            for z in range(n):
                if is_divided(neighbor_slot(i, -x, -y, -z, level), level) == 1:
                    mark = 1
    marks[i] = mark


@kernel
def begin_blocks_kernel(level: OctreeLevel, marks: array(dtype=int32), offsets: array(dtype=int32), below: OctreeLevel):
    """Create the blocks of the next level in the order of their parents."""
    i = tid()
    if marks[i] == 1:
        block = offsets[i]
        level.children[i] = block
        below.parents[block] = i
        below.positions[block] = slot_position(i, level)
        below.has_cells[block] = level.divided[i]


@kernel
def find_blocks_around_kernel(level: OctreeLevel, below: OctreeLevel):
    """Neighbors of each new block: the children of the slots around its parent."""
    i = tid()
    parent = below.parents[i]
    at = BLOCKS_AROUND * i
    n = int(3)
    for x in range(n):
        for y in range(n):
            for z in range(n):
                slot = neighbor_slot(parent, x - 1, y - 1, z - 1, level)
                other = -1
                if slot >= 0:
                    other = level.children[slot]
                below.around[at] = other
                at += 1


def first_levels(device: Device) -> tuple[OctreeLevel, OctreeLevel]:
    """Level 0, which stores only its child, and level 1: one block of octants and a halo of seven."""
    root = OctreeLevel(0, 1, device)
    fill(root.children, 0)
    level = OctreeLevel(1, BLOCK_SLOTS, device)
    grid = np.stack([np.arange(BLOCK_SLOTS) >> axis & 1 for axis in range(3)], axis=1).astype(np.int32)
    step = np.stack(np.meshgrid(*[[-1, 0, 1]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    beside = grid[:, None] + step[None]
    inside = ((beside == 0) | (beside == 1)).all(axis=2)
    around = np.where(inside, beside @ [1, 2, 4], -1).astype(np.int32)
    level.positions, level.around = upload(grid, vec3i, device), upload(around.ravel(), int32, device)
    level.has_cells = upload(np.array([1] + [0] * (BLOCK_SLOTS - 1), np.uint8), uint8, device)
    level.parents = full(BLOCK_SLOTS, -1, int32, device)
    return root, level


def next_level(level: OctreeLevel, block_bytes: int, is_full: bool = False) -> OctreeLevel | None:
    """Next level for the marked cells, or None. One sync unless `is_full`. Raises MemoryError before any allocation."""
    slots, device = BLOCK_SLOTS * level.count, level.device
    marks = compute(mark_children_kernel, slots, [level], int32, device)
    if is_full:
        offsets, count = offsets_of(marks), ((1 << level.depth) + 1) ** 3
    else:
        offsets, count = exclusive_scan(marks, largest=1)  # sync
    if count == 0:
        return None
    check_room(device, count * block_bytes, f"level {level.depth + 1} of the octree, {BLOCK_SLOTS * count:,} cells")
    below = OctreeLevel(level.depth + 1, count, device)
    launch(begin_blocks_kernel, slots, [level, marks, offsets, below])
    launch(find_blocks_around_kernel, count, [level, below])
    return below


def divide(level: OctreeLevel, wanted: Integers | None) -> None:
    """Mark cells (int32 slots, -1 for none) and their neighbors as divided. None for all cells."""
    if wanted is None:
        launch(divide_all_kernel, BLOCK_SLOTS * level.count, [level])
    else:
        launch(divide_around_kernel, wanted.size, [wanted, level])
