"""Growing voxel map with a maximum number of points per voxel (Vizzo et al. 2023, "KISS-ICP", section III-C, with the
spacing of their implementation).

Points are float32 relative to integer voxels, exact to 1e-7 of a voxel at any distance. Voxels are in an ordered hash
table. One thread per voxel adds points in order while there is room and none is closer than the spacing, so results are
deterministic. Additions are atomic (arrays/atomic_changes.py). New voxels are numbered without a sync.
"""

import math

import numpy as np

from ..algebra.rigid_solve import move
from ..algebra.transform import narrow, widen
from ..array_types import Device, Indices, Integers, Keys, Points
from ..arrays.atomic_changes import Changes, note_change
from ..arrays.block_keys import block_key, key_block
from ..arrays.hash_table import HashTable, find_position, find_slot, insert_key, list_keys
from ..arrays.prefix_sum import exclusive_scan, inclusive_scan
from ..arrays.select import positions_of
from ..arrays.sort import argsort_keys
from ..arrays.unique import write_heads
from ..lang import (
    array,
    compute,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    mat44d,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import Readback, copy, download, empty, full, host_view, zeros
from .local_cells import LocalCells, cell_holding, key_cell, local_key, offset_in_cell


@struct
class TouchedVoxels:
    """Voxels of new points, counted on the device; `voxels`: index in the map; `fresh`: 1 for new, then sums."""

    keys: array(dtype=int64)
    order: array(dtype=int32)
    starts: array(dtype=int32)
    summary: array(dtype=int32)
    voxels: array(dtype=int32)
    fresh: array(dtype=int32)

    def __init__(
        self, keys: Keys, order: Indices, starts: Integers, summary: Integers, voxels: Indices, fresh: Integers
    ) -> None:
        self.keys, self.order, self.starts, self.summary = keys, order, starts, summary
        self.voxels, self.fresh = voxels, fresh


@func
def touched_key(i: int, touched: TouchedVoxels, cells: LocalCells) -> int64:
    """Map key of a touched voxel, or -1 behind the last."""
    key = int64(-1)
    if i < touched.summary[0]:
        if touched.keys[i] != cells.skipped:
            cell = key_cell(touched.keys[i], cells)
            key = block_key(cell[0], cell[1], cell[2])
    return key


@kernel
def find_voxels_kernel(touched: TouchedVoxels, cells: LocalCells, table: HashTable):
    """Index of each touched voxel, -1 if new, -2 behind the last; and flags of new ones."""
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
    """Append new voxels in key order; `totals[after]` is the new count."""
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
    """Store each voxel's index beside its key, which others may have moved."""
    i = tid()
    if i < totals[after]:
        table.positions[find_slot(keys[i], table)] = i


# voxels from the start along each axis: keys have 21 bits per axis, and searches go one further
CELL_LIMIT = 2**20 - 2
UNKNOWN_VOXEL, NO_VOXEL = -1, -2  # of a point: not yet in the map (as by `find_position`), not finite
COARSE_CELLS = 1 << 14  # more than the voxels of a map in any direction
SPARE_CELLS = 2  # voxels that a scan may exceed its range by: rounding, and the sensor's position in its voxel


@struct
class VoxelMap:
    """Points in voxels: `voxel_size` [m]; `room` points per voxel. Minimum squared distance `sqspacing` [m^2]; `keys`
    in insertion order; `offsets` from voxel corners [m]; `totals`: CUDA voxel counts after even and odd changes.
    """

    voxel_size: float64
    room: int
    sqspacing: float
    keys: array(dtype=int64)
    table: HashTable
    counts: array(dtype=int32)
    offsets: array(dtype=vec3)
    totals: array(dtype=int32)
    changes: Changes

    def __init__(self, voxel_size: float, room: int, device: Device) -> None:
        """An empty map with `room` points per voxel of edge `voxel_size` [m]."""
        self.voxel_size, self.room, self.device = voxel_size, room, device
        self.sqspacing = voxel_size * voxel_size / room
        self._begin(0)
        self.capacity = 0
        self._grow(1024)
        self.table = HashTable(device)

    def _begin(self, count: int) -> None:
        self.totals, self.changes = full(2, count, int32, self.device), Changes(count, self.device)
        self._readback, self._read = Readback(self.totals), (0, count)

    @property
    def count(self) -> int:
        """Occupied voxels; syncs on CUDA if not yet read since the last addition."""
        self._recover()
        return self._known()

    def _known(self) -> int:
        number = self.changes.count
        if not self.device.is_cuda:
            return self.changes.value
        if self._read[0] != number:
            self._read = (number, int(self._readback.read()[number & 1]))  # sync
        return self._read[1]

    @property
    def additions(self) -> int:
        self._recover()
        return self.changes.count

    def _recover(self) -> None:
        """Complete an interrupted addition if its launch was made, else undo it (sync)."""
        self.changes.recover(self._list_keys)

    def _list_keys(self) -> None:
        self.table = list_keys(self.keys, self._known())

    def cell_of(self, position: np.ndarray) -> list[int]:
        return [math.floor(float(x) / self.voxel_size) for x in position]

    def add(self, points: Points, pose: np.ndarray, max_range: float) -> None:
        """Add finite points under a pose, none farther than `max_range` [m]. Raises ValueError beyond 2^20 voxels."""
        if points.size == 0:
            return
        cells = math.ceil(max_range / self.voxel_size) + SPARE_CELLS
        center = self.cell_of(pose[:3, 3])
        if max(abs(c) for c in center) + cells > CELL_LIMIT:
            raise ValueError(
                f"voxel_size: {self.voxel_size} m reaches {CELL_LIMIT * self.voxel_size:.0f} m from the start, "
                f"the sensor is at {[round(float(x)) for x in pose[:3, 3]]}"
            )
        local = LocalCells(self.voxel_size, center, cells)
        offsets = empty(points.size, vec3, self.device)
        if self.device.is_cuda:
            keys = empty(points.size, int64, self.device)
            launch(encode_points_kernel, points.size, [points, mat44d(*pose.ravel()), local, keys, offsets])
            self._insert_unread(keys, local, offsets)
            return
        keys, voxels = empty(points.size, int64, self.device), empty(points.size, int32, self.device)
        placed = [points, mat44d(*pose.ravel().tolist()), self, keys, voxels, offsets]
        launch(find_voxels_of_points_kernel, points.size, placed)
        self._insert(keys, voxels, offsets)

    def _insert(self, keys: Keys, voxels: Indices, offsets: Points) -> None:
        """Insert points by the keys of their voxels, and their voxels in the map."""
        known = self.count
        new_keys = np.unique(download(keys)[download(voxels) == UNKNOWN_VOXEL])
        count = known + len(new_keys)
        self._grow(count)
        self.changes.begin(count)
        if count > known:
            host_view(self.keys)[known:count] = new_keys
            self.table.append(self.keys, count, count - known)
        launch(insert_points_kernel, 1, [keys, voxels, offsets, self])
        self.changes.end()

    def _insert_unread(self, keys: Keys, local: LocalCells, offsets: Points) -> None:
        """As `_insert` without a sync, over as many voxels as points."""
        n = keys.size
        max_count = self.count + n
        self._grow(max_count)
        sorted_keys, order = argsort_keys(keys, local.key_bits)
        heads, starts, summary = write_heads(sorted_keys)
        self._readback.forget()
        self.changes.begin(None)
        if 2 * max_count > self.table.capacity:
            self.table = list_keys(self.keys, max_count - n, 2 * max_count)
        voxels, fresh = empty(n, int32, self.device), empty(n, int32, self.device)
        touched = TouchedVoxels(heads, order, starts, summary, voxels, fresh)
        after = self.changes.number & 1
        launch(find_voxels_kernel, n, [touched, local, self.table])
        inclusive_scan(fresh, fresh)
        launch(number_voxels_kernel, n, [touched, local, after, self.totals, self.keys, self.table])
        launch(store_voxels_kernel, max_count, [self.keys, after, self.totals, self.table])
        launch(insert_touched_kernel, n, [touched, offsets, self])
        self.changes.end()
        self._readback.send()

    def _grow(self, count: int) -> None:
        if count <= self.capacity:
            return
        capacity = max(count, 2 * self.capacity)
        if capacity * self.room > 2**31 - 1:
            raise ValueError(f"max_points_per_voxel: {self.room} x {capacity:,} voxels are more than 2^31 points")
        known = self._known()
        keys, counts = empty(capacity, int64, self.device), zeros(capacity, int32, self.device)
        offsets = empty(capacity * self.room, vec3, self.device)
        if known:
            copy(keys, self.keys, count=known)
            copy(counts, self.counts, count=known)
            copy(offsets, self.offsets, count=known * self.room)
        self.keys, self.counts, self.offsets = keys, counts, offsets
        self.capacity = capacity  # last: it defines the room of all three

    def without_far(self, center: np.ndarray, limit: float) -> "VoxelMap":
        """Map without voxels farther than `limit` [m] from a position (by center); itself if there are none."""
        count = self.count
        marks = compute(mark_near_voxels_kernel, count, [self, vec3d(*center), limit], uint8, self.device)
        rows = positions_of(marks)  # sync
        if rows.size == count:
            return self
        nearby = VoxelMap(self.voxel_size, self.room, self.device)
        nearby._grow(rows.size + rows.size // 2)
        launch(gather_keys_kernel, rows.size, [self.keys, rows, 0, nearby.keys])
        launch(gather_voxels_kernel, rows.size, [rows, self.counts, self.offsets, nearby])
        nearby.table = list_keys(nearby.keys, rows.size)
        nearby._begin(rows.size)
        return nearby

    def coarser(self, factor: float, near: np.ndarray) -> "VoxelMap":
        """Map of the same points in voxels larger by a factor, for a sensor near a position."""
        points, origin = self.points(near)  # sync
        coarse, pose = VoxelMap(factor * self.voxel_size, self.room, self.device), np.eye(4)
        pose[:3, 3] = origin
        coarse.add(points, pose, COARSE_CELLS * coarse.voxel_size)
        return coarse

    def points(self, near: np.ndarray) -> tuple[Points, list[float]]:
        """Points by voxel in insertion order about the returned origin (3): the corner of `near`'s voxel."""
        first, count = self.cell_of(near), self.count
        origin = [c * self.voxel_size for c in first]
        if not count:
            return empty(0, vec3, self.device), origin
        offsets, total = exclusive_scan(self.counts[:count], largest=self.room)  # sync, points of a voxel
        points = empty(total, vec3, self.device)
        launch(gather_map_kernel, count, [self, offsets, vec3i(*first), points])
        return points, origin


@kernel
def encode_points_kernel(
    points: array(dtype=vec3), pose: mat44d, cells: LocalCells, keys: array(dtype=int64), offsets: array(dtype=vec3)
):
    i = tid()
    p = points[i]
    key = cells.skipped
    offset = vec3(0.0, 0.0, 0.0)
    if isfinite(p):
        x = move(pose, widen(p))
        cell = cell_holding(x, cells.size)
        key = local_key(cell, cells)
        offset = offset_in_cell(x, cell, cells.size)
    keys[i] = key
    offsets[i] = offset


@kernel(for_cpu=True)
def find_voxels_of_points_kernel(
    points: array(dtype=vec3),
    pose: mat44d,
    voxel_map: VoxelMap,
    keys: array(dtype=int64),
    voxels: array(dtype=int32),
    offsets: array(dtype=vec3),
):
    """Voxel of each point: its key, its index in the map, and the offset in it."""
    i = tid()
    p = points[i]
    voxel = int(NO_VOXEL)
    if isfinite(p):
        x = move(pose, widen(p))
        cell = cell_holding(x, voxel_map.voxel_size)
        key = block_key(cell[0], cell[1], cell[2])
        voxel = find_position(key, voxel_map.table)
        keys[i] = key
        offsets[i] = offset_in_cell(x, cell, voxel_map.voxel_size)
    voxels[i] = voxel


@kernel
def gather_keys_kernel(keys: array(dtype=int64), rows: array(dtype=int32), first: int, out: array(dtype=int64)):
    i = tid()
    out[first + i] = keys[rows[i]]


@func
def has_place(p: vec3, first: int, count: int, voxel_map: VoxelMap) -> int:
    """1 if a voxel with `count` points from slot `first` on has room, and none of them is near."""
    is_free = 1 if count < voxel_map.room else 0
    if is_free == 1:
        for slot in range(first, first + count):
            d = p - voxel_map.offsets[slot]
            if d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < voxel_map.sqspacing:
                is_free = 0
    return is_free


@func
def take_points(
    voxel: int,
    known: int,
    begin: int,
    end: int,
    order: array(dtype=int32),
    new_offsets: array(dtype=vec3),
    voxel_map: VoxelMap,
):
    """Add new points of a voxel in order, while there is room and none is near."""
    first = voxel * voxel_map.room
    count = 0
    if voxel < known:
        count = voxel_map.counts[voxel]
    for j in range(begin, end):
        p = new_offsets[order[j]]
        if has_place(p, first, count, voxel_map) == 1:
            voxel_map.offsets[first + count] = p
            count += 1
    voxel_map.counts[voxel] = count


@kernel(for_cpu=True)
def insert_points_kernel(
    keys: array(dtype=int64), voxels: array(dtype=int32), new_offsets: array(dtype=vec3), voxel_map: VoxelMap
):
    """Add points in order, while there is room in their voxel and none is near. One thread."""
    i = tid()
    note_change(i, voxel_map.changes)
    for j in range(i, voxels.shape[0]):
        voxel = voxels[j]
        if voxel == UNKNOWN_VOXEL:
            voxel = find_position(keys[j], voxel_map.table)
        if voxel >= 0:
            count = voxel_map.counts[voxel]
            first = voxel * voxel_map.room
            if has_place(new_offsets[j], first, count, voxel_map) == 1:
                voxel_map.offsets[first + count] = new_offsets[j]
                voxel_map.counts[voxel] = count + 1


@kernel
def insert_touched_kernel(touched: TouchedVoxels, new_offsets: array(dtype=vec3), voxel_map: VoxelMap):
    i = tid()
    note_change(i, voxel_map.changes)
    known = voxel_map.totals[1 - int(voxel_map.changes.number & 1)]
    voxel = touched.voxels[i]
    if voxel >= 0:
        take_points(voxel, known, touched.starts[i], touched.starts[i + 1], touched.order, new_offsets, voxel_map)


@kernel
def mark_near_voxels_kernel(voxel_map: VoxelMap, center: vec3d, limit: float64, marks: array(dtype=uint8)):
    """1 if a voxel's center is within a distance [m] of a position."""
    i = tid()
    cell = key_block(voxel_map.keys[i])
    x = (float64(cell[0]) + 0.5) * voxel_map.voxel_size - center[0]
    y = (float64(cell[1]) + 0.5) * voxel_map.voxel_size - center[1]
    z = (float64(cell[2]) + 0.5) * voxel_map.voxel_size - center[2]
    is_near = 0
    if x * x + y * y + z * z <= limit * limit:
        is_near = 1
    marks[i] = uint8(is_near)


@kernel
def gather_voxels_kernel(
    rows: array(dtype=int32), counts: array(dtype=int32), offsets: array(dtype=vec3), voxel_map: VoxelMap
):
    i = tid()
    voxel = rows[i]
    count = counts[voxel]
    voxel_map.counts[i] = count
    for slot in range(count):
        voxel_map.offsets[i * voxel_map.room + slot] = offsets[voxel * voxel_map.room + slot]


@kernel
def gather_map_kernel(voxel_map: VoxelMap, offsets: array(dtype=int32), first: vec3i, points: array(dtype=vec3)):
    """Points of one voxel, relative to the corner of voxel `first`."""
    i = tid()
    cell = key_block(voxel_map.keys[i]) - first
    corner = vec3d(float64(cell[0]), float64(cell[1]), float64(cell[2])) * voxel_map.voxel_size
    for j in range(offsets[i], offsets[i + 1]):
        points[j] = narrow(corner + widen(voxel_map.offsets[i * voxel_map.room + j - offsets[i]]))
