"""TSDF voxels in hashed blocks of 8^3.

4 B of distance, 2 B of weight (at most 65535 frames), and optionally 6 B of 16-bit color per voxel, since an 8-bit
running mean would stall. 32 to 56 B per block. Memory at least doubles when it grows, and nothing is moved. Frames are
integrated atomically (arrays/atomic_changes.py): new blocks do not count before the launch that writes them.
"""

from typing import Any

import numpy as np

from ..array_types import Array1, Array2, Device, Integers, Keys, Scalars
from ..arrays.atomic_changes import Changes
from ..arrays.hash_table import HashTable, list_keys, number_new
from ..arrays.select import gather_rows, positions_of
from ..lang import array, float32, float64, func, int64, struct, uint16, vec3
from ..memory import copy, empty, upload, zeros
from .frame_record import FrameCounts, FrameRecord
from .tsdf_blocks import BLOCK_VOXELS, MAX_BLOCKS

FIRST_CAPACITY = 256
COLOR_SCALE = 257.0  # 8-bit to 16-bit: 255 becomes 65535


@struct
class VoxelBlocks:
    """Blocks of voxels on one device: signed `distances` over the truncation (-1..1), `weights`, and `colors` uint16
    (one row without color); `keys` in order of creation. `record` is that of the current frame. `cache` stores derived
    data by name (block_rows.py, block_signs.py): writers must announce a change, and reordering needs new Changes.
    `latest` is the last change and its touched blocks, if listed."""

    voxel_size: float64
    truncation: float64
    keys: array(dtype=int64)
    table: HashTable
    distances: array(dtype=float32)
    weights: array(dtype=uint16)
    colors: array(dtype=uint16, ndim=2)
    changes: Changes

    def __init__(self, voxel_size: float, truncation: float, has_color: bool, device: Device) -> None:
        self.voxel_size, self.truncation, self.has_color, self.device = voxel_size, truncation, has_color, device
        self.changes, self.table, self.keys = Changes(0, device), HashTable(device), empty(0, int64, device)
        self.record, self.cache = FrameRecord(device), {}
        self.latest: tuple[int, Any] = (0, None)
        self.reserve(FIRST_CAPACITY)

    @property
    def count(self) -> int:
        self._resolve()
        return self._counted()

    def _counted(self) -> int:
        value = self.changes.value
        return value.counted if isinstance(value, FrameCounts) else value

    @property
    def frame_count(self) -> int:
        self._resolve()
        return self.changes.count

    @property
    def memory_bytes(self) -> int:
        voxels = (self.distances, self.weights, self.colors)
        return sum(a.capacity for a in (*voxels, self.keys, self.table.keys, self.table.positions))

    def reserve(self, count: int) -> None:
        if count > self.keys.size:
            self._move(min(MAX_BLOCKS, max(count, 2 * self.keys.size)))

    def _move(self, capacity: int) -> None:
        voxels = capacity * BLOCK_VOXELS
        keys = empty(capacity, int64, self.device)
        colors = zeros((voxels if self.has_color else 1, 3), uint16, self.device)
        distances, weights = zeros(voxels, float32, self.device), zeros(voxels, uint16, self.device)
        self._copy_to(keys, distances, weights, colors)
        self.distances, self.weights, self.colors = distances, weights, colors
        self.keys = keys  # last: its size defines the capacity

    @property
    def block_bytes(self) -> int:
        return BLOCK_VOXELS * (12 if self.has_color else 6) + 56

    def has_room(self, count: int) -> bool:
        return count <= self.keys.size and 2 * self.keys.size <= self.table.capacity

    def make_room(self, count: int) -> None:
        if count > self.keys.size:
            self._move(count)
        if not self.has_room(count):
            self._list_keys()

    def _copy_to(self, keys: Keys, distances: Scalars, weights: Array1[uint16], colors: Array2[uint16]) -> None:
        count = self._counted()
        if not count:  # initially no arrays either
            return
        voxels = count * BLOCK_VOXELS
        copy(keys, self.keys, count=count)
        copy(distances, self.distances, count=voxels)
        copy(weights, self.weights, count=voxels)
        if self.has_color:
            copy(colors, self.colors, count=3 * voxels)

    def begin(self, keys: Keys) -> Integers:
        """Begin a frame over blocks `keys`, appending new ones. Return their positions, int32. They count once a launch
        records `changes` and `end` follows. Raises ValueError for more blocks than int32 can index."""
        indices, known, new = begin_blocks(self, keys, "volume")
        self.record.write_counts(known, keys.size, new)
        return indices

    def begin_on_device(self, frames: int = 1) -> FrameCounts:
        """Begin frames whose blocks the device finds, with enough room. Return the FrameCounts of the last one."""
        counts = FrameCounts(self.record)
        self.changes.begin(counts, frames)
        self.record.readback.forget()
        return counts

    def end(self) -> None:
        self.changes.end()

    def _resolve(self) -> None:
        """Complete or undo an interrupted frame, depending on its launch (sync)."""
        self.changes.recover(self._list_keys)

    def _list_keys(self) -> None:
        room = self.keys.size if self.device.is_cuda else 0  # if launches insert without the host
        self.table = list_keys(self.keys, self._counted(), room)

    def clone(self) -> "VoxelBlocks":
        count, other = self.count, VoxelBlocks(self.voxel_size, self.truncation, self.has_color, self.device)
        other.reserve(count)
        self._copy_to(other.keys, other.distances, other.weights, other.colors)
        other.table, other.changes = list_keys(other.keys, count), Changes(count, self.device)
        other.record = FrameRecord(self.device, count)
        return other

    def without_voxels(self, keys: Keys) -> "VoxelBlocks":
        """Blocks with these keys and no voxels, for lookups along rays."""
        other = VoxelBlocks(self.voxel_size, self.truncation, False, self.device)
        other.keys, other.table = keys, list_keys(keys, keys.size)
        other.changes = Changes(keys.size, self.device)
        return other

    def fill(self, arrays: dict[str, np.ndarray]) -> None:
        count = len(arrays["keys"])
        self.reserve(count)
        for name, values in arrays.items():
            target = getattr(self, name)
            copy(target, upload(values, target.dtype, self.device), count=values.size)
        self.table, self.changes = list_keys(self.keys, count), Changes(count, self.device)
        self.record = FrameRecord(self.device, count)


def begin_blocks(blocks: Any, keys: Keys, what: str) -> tuple[Integers, int, int]:
    """Begin a change over blocks with distinct int64 keys. Return (positions int32, previous count, new count). Raises
    ValueError, with the name `what`, for more blocks than int32 can index."""
    known = blocks.count
    indices, absent = blocks.table.find(keys)
    missing = positions_of(absent)
    count = known + missing.size
    check_block_count(count, what)
    blocks.reserve(count)
    blocks.changes.begin(count)
    if missing.size:
        copy(blocks.keys, gather_rows(keys, missing), offset=known, count=missing.size)
        number_new(missing, known, indices)
        blocks.table.append(blocks.keys, count, missing.size)
    return indices, known, missing.size


def check_block_count(count: int, what: str = "volume") -> None:
    """Raise ValueError for more blocks than int32 can index."""
    if count > MAX_BLOCKS:
        raise ValueError(f"the {what} would need {count:,} blocks, more than {MAX_BLOCKS:,}; take larger voxels")


@func
def voxel_color(voxel: int, blocks: VoxelBlocks) -> vec3:
    return vec3(float(blocks.colors[voxel, 0]), float(blocks.colors[voxel, 1]), float(blocks.colors[voxel, 2]))
