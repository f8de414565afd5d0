"""The voxels that new points fall into, found and numbered without the host: it need not know how many there are.

Four launches and a scan over as many voxels as there are points, 28 B each.
"""

from ..array_types import Indices, Integers, Keys
from ..arrays.block_keys import block_key
from ..arrays.hash_table import HashTable, find_position, find_slot, insert_key
from ..lang import array, func, int32, int64, kernel, struct, tid
from .local_cells import LocalCells, key_cell


@struct
class TouchedVoxels:
    """The voxels that new points fall into, of which the device alone knows how many there are.

    Attributes:
        keys, order, starts: As of UniqueKeys, with room for n of them.
        told: int32 [3], as `write_heads` gives it.
        voxels: int32 [n], where each stands in the map.
        fresh: int32 [n], 1 where a voxel is new to it; then the sums of these.
    """

    keys: array(dtype=int64)
    order: array(dtype=int32)
    starts: array(dtype=int32)
    told: array(dtype=int32)
    voxels: array(dtype=int32)
    fresh: array(dtype=int32)

    def __init__(
        self, keys: Keys, order: Indices, starts: Integers, told: Integers, voxels: Indices, fresh: Integers
    ) -> None:
        self.keys, self.order, self.starts, self.told = keys, order, starts, told
        self.voxels, self.fresh = voxels, fresh


@func
def touched_key(i: int, touched: TouchedVoxels, cells: LocalCells) -> int64:
    """The map's key of a touched voxel; -1 behind the last one."""
    key = int64(-1)
    if i < touched.told[0]:
        if touched.keys[i] != cells.skipped:
            cell = key_cell(touched.keys[i], cells)
            key = block_key(cell[0], cell[1], cell[2])
    return key


@kernel
def find_voxels_kernel(touched: TouchedVoxels, cells: LocalCells, table: HashTable):
    """Where each touched voxel stands, -1 for a new one, -2 behind the last one; and which are new."""
    i = tid()
    key = touched_key(i, touched, cells)
    voxel = -2
    is_new = 0
    if key >= 0:
        voxel = find_position(key, table)
        if voxel < 0:
            is_new = 1
    touched.voxels[i] = voxel
    touched.fresh[i] = is_new


@kernel
def number_voxels_kernel(
    touched: TouchedVoxels,
    cells: LocalCells,
    after: int,
    totals: array(dtype=int32),
    keys: array(dtype=int64),
    table: HashTable,
):
    """New voxels stand behind those of the map, in the order of their keys; `totals[after]` is their number then."""
    i = tid()
    known = totals[1 - after]
    if touched.voxels[i] == -1:
        voxel = known + touched.fresh[i] - 1
        key = touched_key(i, touched, cells)
        touched.voxels[i] = voxel
        keys[voxel] = key
        insert_key(key, table)
    if i == 0:
        totals[after] = known + touched.fresh[touched.fresh.shape[0] - 1]


@kernel
def store_voxels_kernel(keys: array(dtype=int64), after: int, totals: array(dtype=int32), table: HashTable):
    """Store each voxel's place beside its key, which others may have moved."""
    i = tid()
    if i < totals[after]:
        table.positions[find_slot(keys[i], table)] = i
