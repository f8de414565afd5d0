"""The voxels of a volume: truncated signed distances in blocks of 8^3 that appear where depth is.

A voxel is 4 B of distance, 2 B of weight (it stops at 65535 frames) and, where colour is kept, 6 B of colour (16-bit
fixed point, so that a long mean does not stall as it would in 8 bits). A block is 8 B of key and 24 to 48 B of hash
table more. Memory at least doubles when it grows, and nothing is moved within it.
"""

from ..arrays.hash_table import HashTable, number_new
from ..arrays.select import gather_rows, positions_of
from ..lang import array, float32, float64, func, int64, struct, uint16, vec3
from ..memory import copy, empty, zeros
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
        has_color: Whether colour is kept.
        count: Blocks.
    """

    voxel_size: float64
    truncation: float64
    keys: array(dtype=int64)
    table: HashTable
    distances: array(dtype=float32)
    weights: array(dtype=uint16)
    colors: array(dtype=uint16, ndim=2)

    def __init__(self, voxel_size, truncation, has_color, device):
        self.voxel_size, self.truncation, self.has_color, self.device = voxel_size, truncation, has_color, device
        self.count, self.table, self.keys = 0, HashTable(device), empty(0, int64, device)
        self.reserve(FIRST_CAPACITY)

    @property
    def memory_bytes(self):
        """Bytes of device memory held by voxels, keys and the hash table."""
        voxels = (self.distances, self.weights, self.colors)
        return sum(a.capacity for a in (*voxels, self.keys, self.table.keys, self.table.positions))

    def reserve(self, count):
        """Make room for so many blocks, at least doubling, and keep what there is."""
        if count <= self.keys.size:
            return
        capacity = min(MAX_BLOCKS, max(count, 2 * self.keys.size))
        voxels, used = capacity * BLOCK_VOXELS, self.count * BLOCK_VOXELS
        keys = empty(capacity, int64, self.device)
        colors = zeros((voxels if self.has_color else 1, 3), uint16, self.device)
        distances, weights = zeros(voxels, float32, self.device), zeros(voxels, uint16, self.device)
        if self.count:
            copy(keys, self.keys, count=self.count)
            copy(distances, self.distances, count=used)
            copy(weights, self.weights, count=used)
            if self.has_color:
                copy(colors, self.colors, count=3 * used)
        self.keys, self.distances, self.weights, self.colors = keys, distances, weights, colors

    def add(self, keys):
        """The positions of the blocks with these int64 keys, int32; those that are new are appended.

        Raises:
            ValueError: More blocks than 32 bits can index.
        """
        found, absent = self.table.find(keys)
        missing = positions_of(absent)
        if missing.size:
            count = self.count + missing.size
            if count > MAX_BLOCKS:
                raise ValueError(
                    f"the volume would need {count:,} blocks, more than {MAX_BLOCKS:,}; take larger voxels"
                )
            self.reserve(count)
            copy(self.keys, gather_rows(keys, missing), offset=self.count, count=missing.size)
            number_new(missing, self.count, found)
            self.table.append(self.keys, count, missing.size)
            self.count = count
        return found


@func
def voxel_color(voxel: int, blocks: VoxelBlocks) -> vec3:
    """The colour of a voxel, 0 to 65535."""
    return vec3(float(blocks.colors[voxel, 0]), float(blocks.colors[voxel, 1]), float(blocks.colors[voxel, 2]))
