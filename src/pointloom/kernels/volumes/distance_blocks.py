"""Exact squared distances to the nearest occupied voxel, in blocks of 8^3 voxels.

Blocks within the distance limit of an occupied block along each axis are created. Those without any known distance are
then removed. A dense box has all its blocks. 8 B per voxel (squared distance and index), 16 B more during construction,
24 B if signed. 32 to 56 B per block.
"""

import math
from typing import NamedTuple

from ..array_types import Cells, Device, Indices, Integers, Keys
from ..arrays.block_keys import CELL_BIAS, block_key, key_block
from ..arrays.hash_table import HashTable, find_position, list_keys
from ..arrays.packed_keys import NO_KEY
from ..arrays.select import gather_rows, positions_of
from ..arrays.unique import UniqueKeys
from ..lang import array, atomic_max, compute, func, int32, int64, kernel, launch, struct, tid, uint8, vec3i
from ..memory import check_room, empty, full, zeros
from .distance_cells import NOT_FINITE_CELL
from .distance_sweeps import MAX_RANGE_VOXELS, MAX_SQUARED_VOXELS, NO_SEED, sweep_blocks
from .tsdf_blocks import BLOCK_SIDE, BLOCK_VOXELS, voxel_cell, voxel_in_block

MAX_BLOCKS = (2**31 - 1) // BLOCK_VOXELS  # voxels are counted in 32 bits
BLOCK_BYTES = 32 * BLOCK_VOXELS + 64  # of memory per block while signed distances are computed


class DistanceLimits(NamedTuple):
    """Distance limits [voxels]: `along` an axis, `limit` squared; or the size of a dense box."""

    along: int
    limit: int
    box: tuple[int, int, int] | None = None

    @property
    def blocks(self) -> int:
        """Radius in blocks around an occupied block."""
        return 0 if self.box else (self.along + BLOCK_SIDE - 1) // BLOCK_SIDE

    @property
    def largest_coordinate(self) -> int:
        """Upper bound of occupied coordinates."""
        return BLOCK_SIDE * (CELL_BIAS - 2 - self.blocks)


def limits_for(distance: float) -> DistanceLimits:
    """Limits for a distance [voxels]. Raises ValueError if its square exceeds int32."""
    if distance > MAX_RANGE_VOXELS:
        raise ValueError(f"max_distance: {distance:.0f} voxels, more than {MAX_RANGE_VOXELS:,}; take larger voxels")
    return DistanceLimits(int(distance), int(distance * distance))


def limits_for_box(shape: tuple[int, int, int]) -> DistanceLimits:
    """Limits of a dense box. Raises ValueError if the squared diagonal exceeds int32."""
    diagonal = math.sqrt(sum(n * n for n in shape))
    if diagonal > MAX_SQUARED_VOXELS:
        raise ValueError(
            f"occupied: {list(shape)} voxels are {diagonal:,.0f} across, more than {MAX_SQUARED_VOXELS:,}; give a "
            "max_distance"
        )
    return DistanceLimits(MAX_SQUARED_VOXELS, NO_SEED - 1, shape)


@struct
class DistanceBlocks:
    """Squared distances [voxels^2] at the voxels of blocks with ascending int64 keys. `sqdists` are FAR if unknown. If
    signed, occupied voxels have the negative distance to the nearest free one. `nearest` is the row of the nearest
    occupied voxel, undefined if unknown. `occupied` are sorted by block."""

    keys: array(dtype=int64)
    table: HashTable
    sqdists: array(dtype=int32)
    nearest: array(dtype=int32)
    occupied: array(dtype=vec3i)

    def __init__(self, keys: Keys, sqdists: Integers, nearest: Integers, occupied: Cells) -> None:
        self.keys, self.sqdists, self.nearest, self.occupied = keys, sqdists, nearest, occupied
        self.table = list_keys(keys, keys.size)

    @property
    def device(self) -> Device:
        return self.keys.device

    @property
    def memory_bytes(self) -> int:
        arrays = (self.keys, self.sqdists, self.nearest, self.occupied, self.table.keys, self.table.positions)
        return sum(a.capacity for a in arrays)


@func
def block_of(cell: vec3i) -> vec3i:
    return vec3i(cell[0] // BLOCK_SIDE, cell[1] // BLOCK_SIDE, cell[2] // BLOCK_SIDE)


@func
def find_voxel(cell: vec3i, table: HashTable) -> int:
    """Index of a voxel among those of a table's blocks, or -1."""
    block = block_of(cell)
    position = find_position(block_key(block[0], block[1], block[2]), table)
    voxel = -1
    if position >= 0:
        voxel = position * BLOCK_VOXELS + voxel_in_block(cell[0], cell[1], cell[2])
    return voxel


@kernel
def find_block_keys_kernel(cells: array(dtype=vec3i), largest: int, keys: array(dtype=int64), far: array(dtype=int32)):
    """Key of each voxel's block. NO_KEY for NOWHERE and beyond the limit, which sets the flag."""
    i = tid()
    cell = cells[i]
    key = int64(NO_KEY)
    if cell[0] != NOT_FINITE_CELL:
        if max(abs(cell[0]), max(abs(cell[1]), abs(cell[2]))) < largest:
            block = block_of(cell)
            key = block_key(block[0], block[1], block[2])
        else:
            atomic_max(far, 0, 1)  # all threads write 1
    keys[i] = key


@kernel
def mark_cells_kernel(cells: array(dtype=vec3i), table: HashTable, marks: array(dtype=uint8)):
    """Mark voxels of existing blocks."""
    i = tid()
    cell = cells[i]
    if cell[0] != NOT_FINITE_CELL:
        marks[find_voxel(cell, table)] = 1  # all threads write the same


@kernel
def list_cells_kernel(voxels: array(dtype=int32), keys: array(dtype=int64), cells: array(dtype=vec3i)):
    i = tid()
    cells[i] = voxel_cell(voxels[i], keys)


@kernel
def spread_keys_kernel(keys: array(dtype=int64), axis: int, step: int, spread: array(dtype=int64)):
    """Keys of each block and its two neighbors along an axis."""
    i = tid()
    b = key_block(keys[i // 3])
    shift = (i % 3 - 1) * step
    key = block_key(b[0] + shift, b[1], b[2])
    if axis == 1:
        key = block_key(b[0], b[1] + shift, b[2])
    if axis == 2:
        key = block_key(b[0], b[1], b[2] + shift)
    spread[i] = key


@kernel
def list_box_keys_kernel(size: vec3i, keys: array(dtype=int64)):
    i = tid()
    keys[i] = block_key(i // (size[1] * size[2]), (i // size[2]) % size[1], i % size[2])


@kernel
def plant_seeds_kernel(
    cells: array(dtype=vec3i), table: HashTable, sqdists: array(dtype=int32), nearest: array(dtype=int32)
):
    i = tid()
    voxel = find_voxel(cells[i], table)
    sqdists[voxel] = 0
    nearest[voxel] = i


@kernel
def plant_free_kernel(size: vec3i, keys: array(dtype=int64), sqdists: array(dtype=int32), inner: array(dtype=int32)):
    """Distance 0 at each free voxel of a box, FAR at all others."""
    i = tid()
    cell = voxel_cell(i, keys)
    seed = int(NO_SEED)
    if sqdists[i] != 0 and cell[0] >= 0 and cell[1] >= 0 and cell[2] >= 0:
        if cell[0] < size[0] and cell[1] < size[1] and cell[2] < size[2]:
            seed = 0
    inner[i] = seed


@kernel
def sign_distances_kernel(inner: array(dtype=int32), sqdists: array(dtype=int32)):
    i = tid()
    if sqdists[i] == 0:
        sqdists[i] = -inner[i]


@kernel
def mark_known_kernel(sqdists: array(dtype=int32), known: array(dtype=uint8)):
    i = tid()
    is_known = 0
    k = 0
    while is_known == 0 and k < BLOCK_VOXELS:
        if sqdists[i * BLOCK_VOXELS + k] != NO_SEED:
            is_known = 1
        k += 1
    known[i] = uint8(is_known)


@kernel
def gather_voxels_kernel(values: array(dtype=int32), blocks: array(dtype=int32), out: array(dtype=int32)):
    i = tid()
    out[i] = values[blocks[i // BLOCK_VOXELS] * BLOCK_VOXELS + i % BLOCK_VOXELS]


def _check_blocks(count: int, device: Device) -> None:
    if count > MAX_BLOCKS:
        raise ValueError(
            f"the distance field would need {count:,} blocks of {BLOCK_SIDE}^3 voxels, more than {MAX_BLOCKS:,}; "
            "take larger voxels or a smaller max_distance"
        )
    check_room(device, count * BLOCK_BYTES, f"a distance field of {count:,} blocks of {BLOCK_SIDE}^3 voxels")


def _distinct(cells: Cells, limits: DistanceLimits) -> tuple[Keys, Cells]:
    """Ascending block keys, and each voxel once, sorted by block. Raises ValueError for voxels beyond the key range."""
    device = cells.device
    keys, far = empty(cells.size, int64, device), zeros(1, int32, device)
    launch(find_block_keys_kernel, cells.size, [cells, limits.largest_coordinate, keys, far])
    unique = UniqueKeys(keys, beside=far)  # sync
    if unique.beside[0]:
        raise ValueError(
            f"a voxel lies {limits.largest_coordinate:,} or more from the field's origin along an axis; crop what is "
            "far away, take larger voxels, or set the origin near the middle"
        )
    unique.drop_last(NO_KEY)
    _check_blocks(unique.count, device)
    marks = zeros(unique.count * BLOCK_VOXELS, uint8, device)
    launch(mark_cells_kernel, cells.size, [cells, list_keys(unique.keys, unique.count), marks])
    voxels: Indices = positions_of(marks)  # sync
    occupied = compute(list_cells_kernel, voxels.size, [voxels, unique.keys], vec3i, device)
    return unique.keys, occupied


def _blocks_within(keys: Keys, limits: DistanceLimits) -> Keys:
    """Ascending keys of all blocks within the limit. Raises ValueError if too many, MemoryError if they do not fit."""
    device = keys.device
    if limits.box:
        size = [-(-n // BLOCK_SIDE) for n in limits.box]
        count = math.prod(size)
        _check_blocks(count, device)
        return compute(list_box_keys_kernel, count, [vec3i(*size)], int64, device)
    if keys.size:
        _check_blocks((2 * limits.blocks + 1) ** 3, device)  # around one alone
    for axis in (2, 1, 0):
        along = 0  # existing blocks on either side
        while along < limits.blocks:
            step = min(2 * along + 1, limits.blocks - along)
            spread = compute(spread_keys_kernel, 3 * keys.size, [keys, axis, step], int64, device)
            keys, along = UniqueKeys(spread).keys, along + step  # sync
            _check_blocks(keys.size, device)
    return keys


def find_distances(
    cells: Cells, limits: DistanceLimits, signed_in: tuple[int, int, int] | None = None
) -> DistanceBlocks:
    """Distances around occupied voxels vec3i in any order (NOWHERE is ignored). `signed_in` is the size of a box whose
    other voxels are free, to get signed distances. Raises ValueError for voxels beyond the key range or too many
    blocks, MemoryError if they do not fit."""
    device = cells.device
    keys, occupied = _distinct(cells, limits)
    keys = _blocks_within(keys, limits)
    table, count = list_keys(keys, keys.size), keys.size * BLOCK_VOXELS
    sqdists, nearest = full(count, NO_SEED, int32, device), full(count, -1, int32, device)
    launch(plant_seeds_kernel, occupied.size, [occupied, table, sqdists, nearest])
    sweep_blocks(keys, limits.along, limits.limit, sqdists, nearest)
    if signed_in is not None:
        inner, unused = empty(count, int32, device), zeros(count, int32, device)
        launch(plant_free_kernel, count, [vec3i(*signed_in), keys, sqdists, inner])
        sweep_blocks(keys, limits.along, limits.limit, inner, unused)
        launch(sign_distances_kernel, count, [inner, sqdists])
    if not limits.box:
        keys, sqdists, nearest = _known_only(keys, sqdists, nearest)
    return DistanceBlocks(keys, sqdists, nearest, occupied)


def _known_only(keys: Keys, sqdists: Integers, nearest: Integers) -> tuple[Keys, Integers, Integers]:
    device = keys.device
    known = compute(mark_known_kernel, keys.size, [sqdists], uint8, device)
    blocks = positions_of(known)  # sync
    if blocks.size == keys.size:
        return keys, sqdists, nearest
    gathered = []
    for values in (sqdists, nearest):
        out = compute(gather_voxels_kernel, blocks.size * BLOCK_VOXELS, [values, blocks], int32, device)
        gathered.append(out)
    return gather_rows(keys, blocks), gathered[0], gathered[1]
