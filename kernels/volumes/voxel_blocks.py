"""The voxels of a volume: truncated signed distances in blocks of 8^3 that appear where depth is.

A voxel is 4 B of distance, 2 B of weight (it stops at 65535 frames) and, where colour is kept, 6 B of colour (16-bit
fixed point, so that a long mean does not stall as it would in 8 bits). A block is 8 B of key and 24 to 48 B of hash
table more. Memory at least doubles when it grows, and nothing is moved within it.

A frame is folded in whole or not at all, whatever interrupts it (arrays/changes.py): until the launch that writes its
voxels was made, new blocks lie behind those that count.
"""

from typing import Any

import numpy as np

from ..array_types import Array1, Array2, Device, Integers, Keys, Scalars
from ..arrays.changes import Changes
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
    """Blocks of voxels on one device.

    Attributes:
        voxel_size: Edge of a voxel [m].
        truncation: Distance [m] at which signed distances are cut.
        keys: int64 [capacity], those of the blocks in the order in which they came.
        table: The HashTable of the keys.
        distances: float32 [capacity * 512], signed distances over the truncation, -1 to 1.
        weights: uint16 [capacity * 512], frames that saw each voxel.
        colors: uint16 [capacity * 512, 3]; one row where no colour is kept.
        changes: Frames that were folded in.
        has_color: Whether colour is kept.
        record: The FrameRecord of the frame in progress.
        kept: What other files know of the blocks and take further as these change, by name (block_rows.py,
            block_signs.py). Who writes to voxels announces a change, who lists blocks anew makes new Changes.
        latest: (number of a change, int32 positions of the blocks that it touched), where they are listed: the last.
    """

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
        self.record, self.kept = FrameRecord(device), {}
        self.latest: tuple[int, Any] = (0, None)
        self.reserve(FIRST_CAPACITY)

    @property
    def count(self) -> int:
        """Blocks."""
        self._settle()
        return self._counted()

    def _counted(self) -> int:
        value = self.changes.value
        return value.counted if isinstance(value, FrameCounts) else value

    @property
    def frame_count(self) -> int:
        """Frames that were folded in."""
        self._settle()
        return self.changes.count

    @property
    def memory_bytes(self) -> int:
        """Bytes of device memory held by voxels, keys and the hash table."""
        voxels = (self.distances, self.weights, self.colors)
        return sum(a.capacity for a in (*voxels, self.keys, self.table.keys, self.table.positions))

    def reserve(self, count: int) -> None:
        """Make room for so many blocks, at least doubling, and keep those that count."""
        if count > self.keys.size:
            self._move(min(MAX_BLOCKS, max(count, 2 * self.keys.size)))

    def _move(self, capacity: int) -> None:
        voxels = capacity * BLOCK_VOXELS
        keys = empty(capacity, int64, self.device)
        colors = zeros((voxels if self.has_color else 1, 3), uint16, self.device)
        distances, weights = zeros(voxels, float32, self.device), zeros(voxels, uint16, self.device)
        self._copy_to(keys, distances, weights, colors)
        self.distances, self.weights, self.colors = distances, weights, colors
        self.keys = keys  # last: its size says how much room there is

    @property
    def block_bytes(self) -> int:
        """Bytes that a block takes, with its key and its slots in the table."""
        return BLOCK_VOXELS * (12 if self.has_color else 6) + 56

    def has_room(self, count: int) -> bool:
        """Whether so many blocks have room, in the table too."""
        return count <= self.keys.size and 2 * self.keys.size <= self.table.capacity

    def make_room(self, count: int) -> None:
        """Make room for so many blocks and no more, in the table too."""
        if count > self.keys.size:
            self._move(count)
        if not self.has_room(count):
            self._list_keys()

    def _copy_to(self, keys: Keys, distances: Scalars, weights: Array1[uint16], colors: Array2[uint16]) -> None:
        count = self._counted()
        if not count:  # nor any arrays, at first
            return
        voxels = count * BLOCK_VOXELS
        copy(keys, self.keys, count=count)
        copy(distances, self.distances, count=voxels)
        copy(weights, self.weights, count=voxels)
        if self.has_color:
            copy(colors, self.colors, count=3 * voxels)

    def begin(self, keys: Keys) -> Integers:
        """Begin a frame over the blocks with these int64 keys, and give their positions, int32; new ones are appended.

        They count, and so does the frame, once a launch that writes to voxels notes `changes`, and `end` follows.

        Raises:
            ValueError: More blocks than 32 bits can index.
        """
        found, known, new = begin_blocks(self, keys, "volume")
        self.record.write_counts(known, keys.size, new)
        return found

    def begin_on_device(self) -> FrameCounts:
        """Begin a frame whose blocks the device finds, for which there is room; its FrameCounts."""
        counts = FrameCounts(self.record)
        self.changes.begin(counts)
        self.record.readback.forget()
        return counts

    def end(self) -> None:
        """The launch of the frame that was begun is made."""
        self.changes.end()

    def _settle(self) -> None:
        """Bring a frame that was interrupted to its end where its launch was made, else undo it (sync)."""
        self.changes.settle(self._list_keys)

    def _list_keys(self) -> None:
        room = self.keys.size if self.device.is_cuda else 0  # where launches insert without asking the host
        self.table = list_keys(self.keys, self._counted(), room)

    def clone(self) -> "VoxelBlocks":
        """The same blocks in arrays of their own."""
        count, other = self.count, VoxelBlocks(self.voxel_size, self.truncation, self.has_color, self.device)
        other.reserve(count)
        self._copy_to(other.keys, other.distances, other.weights, other.colors)
        other.table, other.changes = list_keys(other.keys, count), Changes(count, self.device)
        other.record = FrameRecord(self.device, count)
        return other

    def without_voxels(self, keys: Keys) -> "VoxelBlocks":
        """Blocks with these keys alone, of the same sizes: what rays pass is looked up in them."""
        other = VoxelBlocks(self.voxel_size, self.truncation, False, self.device)
        other.keys, other.table = keys, list_keys(keys, keys.size)
        other.changes = Changes(keys.size, self.device)
        return other

    def fill(self, arrays: dict[str, np.ndarray]) -> None:
        """Take blocks over from NumPy arrays "keys", "distances", "weights" and, where there are any, "colors", into a
        volume that has none."""
        count = len(arrays["keys"])
        self.reserve(count)
        for name, values in arrays.items():
            target = getattr(self, name)
            copy(target, upload(values, target.dtype, self.device), count=values.size)
        self.table, self.changes = list_keys(self.keys, count), Changes(count, self.device)
        self.record = FrameRecord(self.device, count)


def begin_blocks(blocks: Any, keys: Keys, what: str) -> tuple[Integers, int, int]:
    """Begin a change over the blocks with some keys, those that are new appended behind the ones that count.

    Args:
        blocks: What has `count`, `keys`, `table`, `changes` and `reserve` as VoxelBlocks has.
        keys: int64, distinct.
        what: What the blocks are of, for messages.

    Returns:
        (the position of each key, int32; how many blocks there were; how many are new).

    Raises:
        ValueError: More blocks than 32 bits can index.
    """
    known = blocks.count
    found, absent = blocks.table.find(keys)
    missing = positions_of(absent)
    count = known + missing.size
    check_block_count(count, what)
    blocks.reserve(count)
    blocks.changes.begin(count)
    if missing.size:
        copy(blocks.keys, gather_rows(keys, missing), offset=known, count=missing.size)
        number_new(missing, known, found)
        blocks.table.append(blocks.keys, count, missing.size)
    return found, known, missing.size


def check_block_count(count: int, what: str = "volume") -> None:
    """Refuse more blocks than 32 bits can index."""
    if count > MAX_BLOCKS:
        raise ValueError(f"the {what} would need {count:,} blocks, more than {MAX_BLOCKS:,}; take larger voxels")


@func
def voxel_color(voxel: int, blocks: VoxelBlocks) -> vec3:
    """The colour of a voxel, 0 to 65535."""
    return vec3(float(blocks.colors[voxel, 0]), float(blocks.colors[voxel, 1]), float(blocks.colors[voxel, 2]))
