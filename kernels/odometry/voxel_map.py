"""A growing map of points in voxels, at most so many in each.

A point is stored as its place inside its voxel in float32, and the voxel by whole numbers: however far the sensor has
travelled, a point is exact to 1e-7 of a voxel, and nothing is ever moved. Voxels are found through an ordered hash
table. 12 B a point of a voxel's room, 24 to 48 B more a voxel.

Points are added by one thread a voxel, in their own order, so what a voxel keeps does not depend on threads: a point
is taken while there is room and none of those kept lies closer than the spacing at which the room would be filled.
What searches it stands in voxel_map_search.py.

Source: Vizzo et al. 2023, "KISS-ICP", section III-C; the spacing is that of their implementation.
"""

import math

from ..algebra.rigid_solve import move
from ..algebra.transform import narrow, widen
from ..arrays.block_keys import block_key, key_block
from ..arrays.hash_table import HashTable
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.select import positions_of
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    float64,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    mat44d,
    tid,
    uint8,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import copy, empty, zeros
from .voxel_map_search import cell_below, place_in_cell

# voxels from the start along each axis: keys have 21 bits an axis, and searches look one further
CELL_LIMIT = 2**20 - 2
SPARE_CELLS = 2  # voxels that a scan may reach beyond its range: rounding, and the sensor's place inside its own


@kernel
def encode_points_kernel(
    points: array(dtype=vec3),
    pose: mat44d,
    size: float64,
    first: vec3i,
    bits: int,
    skipped: int64,
    keys: array(dtype=int64),
    places: array(dtype=vec3),
):
    """The voxel of each moved point, counted from voxel `first` on, and its place in it."""
    i = tid()
    p = points[i]
    key = skipped + int64(0)
    place = vec3(0.0, 0.0, 0.0)
    if isfinite(p):
        x = move(pose, widen(p))
        cx = cell_below(x[0], size)
        cy = cell_below(x[1], size)
        cz = cell_below(x[2], size)
        place = vec3(place_in_cell(x[0], cx, size), place_in_cell(x[1], cy, size), place_in_cell(x[2], cz, size))
        high = (int64(cx - first[0]) << int64(bits)) | int64(cy - first[1])
        key = (high << int64(bits)) | int64(cz - first[2])
    keys[i] = key
    places[i] = place


@kernel
def widen_keys_kernel(local: array(dtype=int64), first: vec3i, bits: int, keys: array(dtype=int64)):
    """Keys of voxels counted from `first` on as keys of the map."""
    i = tid()
    key = local[i]
    low = (int64(1) << int64(bits)) - int64(1)
    x = int(key >> int64(2 * bits)) + first[0]
    y = int((key >> int64(bits)) & low) + first[1]
    z = int(key & low) + first[2]
    keys[i] = block_key(x, y, z)


@kernel
def gather_keys_kernel(keys: array(dtype=int64), rows: array(dtype=int32), first: int, out: array(dtype=int64)):
    """out[first + i] = keys[rows[i]]."""
    i = tid()
    out[first + i] = keys[rows[i]]


@kernel
def number_missing_kernel(missing: array(dtype=int32), first: int, voxels: array(dtype=int32)):
    """The i-th missing voxel becomes number first + i."""
    i = tid()
    voxels[missing[i]] = first + i


@kernel
def insert_points_kernel(
    voxels: array(dtype=int32),
    starts: array(dtype=int32),
    order: array(dtype=int32),
    new_places: array(dtype=vec3),
    known: int,
    room: int,
    sqspacing: float,
    counts: array(dtype=int32),
    places: array(dtype=vec3),
):
    """Take the new points of one voxel in their own order, while there is room and none is near."""
    i = tid()
    voxel = voxels[i]
    count = int(0)
    if voxel < known:
        count = counts[voxel]
    for j in range(starts[i], starts[i + 1]):
        if count < room:
            p = new_places[order[j]]
            near = int(0)
            for slot in range(voxel * room, voxel * room + count):
                d = p - places[slot]
                if d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < sqspacing:
                    near = 1
            if near == 0:
                places[voxel * room + count] = p
                count += 1
    counts[voxel] = count


@kernel
def mark_near_voxels_kernel(
    keys: array(dtype=int64), center: vec3d, size: float64, limit: float64, marks: array(dtype=uint8)
):
    """1 where a voxel's middle lies within a distance [m] of a place."""
    i = tid()
    cell = key_block(keys[i])
    x = (float64(cell[0]) + float64(0.5)) * size - center[0]
    y = (float64(cell[1]) + float64(0.5)) * size - center[1]
    z = (float64(cell[2]) + float64(0.5)) * size - center[2]
    kept = int(0)
    if x * x + y * y + z * z <= limit * limit:
        kept = 1
    marks[i] = uint8(kept)


@kernel
def gather_voxels_kernel(
    rows: array(dtype=int32),
    room: int,
    counts: array(dtype=int32),
    places: array(dtype=vec3),
    new_counts: array(dtype=int32),
    new_places: array(dtype=vec3),
):
    """The points of the voxels that stay."""
    i = tid()
    voxel = rows[i]
    count = counts[voxel]
    new_counts[i] = count
    for slot in range(count):
        new_places[i * room + slot] = places[voxel * room + slot]


@kernel
def gather_map_kernel(
    keys: array(dtype=int64),
    offsets: array(dtype=int32),
    room: int,
    size: float64,
    first: vec3i,
    places: array(dtype=vec3),
    points: array(dtype=vec3),
):
    """The points of one voxel, relative to the low corner of voxel `first`."""
    i = tid()
    cell = key_block(keys[i])
    corner = vec3d(
        float64(cell[0] - first[0]) * size, float64(cell[1] - first[1]) * size, float64(cell[2] - first[2]) * size
    )
    for j in range(offsets[i], offsets[i + 1]):
        points[j] = narrow(corner + widen(places[i * room + j - offsets[i]]))


class VoxelMap:
    """Points in voxels on one device.

    Attributes:
        count: Voxels that hold points.
    """

    def __init__(self, voxel_size, room, device):
        """An empty map of voxels with this edge [m] and room for so many points each."""
        self.voxel_size, self.room, self.device = voxel_size, room, device
        self.sqspacing = voxel_size * voxel_size / room
        self.count, self.capacity = 0, 0
        self._grow(1024)
        self.table = HashTable(device)

    @property
    def point_arguments(self):
        """size, room, mask, keys, positions, counts, places: what `find_nearest_in_map` takes last."""
        return [self.voxel_size, self.room, *self.table.arguments, self.counts, self.places]

    def cell_of(self, place):
        """The voxel of a place [m] on the host."""
        return [math.floor(float(x) / self.voxel_size) for x in place]

    def add(self, points, pose, reach):
        """Add points under a pose.

        Args:
            points: Device array of vec3; those that are not finite are left out.
            pose: float64 [4, 4].
            reach: No finite point lies farther [m] from zero.

        Raises:
            ValueError: Beyond 2^20 voxels from the start.
        """
        if points.size == 0:
            return
        cells = math.ceil(reach / self.voxel_size) + SPARE_CELLS
        center = self.cell_of(pose[:3, 3])
        if max(abs(c) for c in center) + cells > CELL_LIMIT:
            raise ValueError(
                f"voxel_size: {self.voxel_size} m reaches {CELL_LIMIT * self.voxel_size:.0f} m from the start, "
                f"the sensor is at {[round(float(x)) for x in pose[:3, 3]]}"
            )
        first, bits = vec3i(*(c - cells for c in center)), (2 * cells).bit_length()
        keys, places = empty(points.size, int64, self.device), empty(points.size, vec3, self.device)
        skipped = 1 << (3 * bits)
        arguments = [points, mat44d(*pose.ravel()), self.voxel_size, first, bits, skipped, keys, places]
        launch(encode_points_kernel, points.size, arguments)
        groups = UniqueKeys(keys, 3 * bits + 1)  # sync
        groups.drop_last(skipped)  # sync
        self._insert(groups, first, bits, places)

    def _insert(self, groups, first, bits, places):
        touched = empty(groups.count, int64, self.device)
        launch(widen_keys_kernel, groups.count, [groups.keys, first, bits, touched])
        voxels, missing = self.table.find(touched)
        rows = positions_of(missing)  # sync
        known = self.count
        if rows.size:
            self._grow(known + rows.size)
            launch(gather_keys_kernel, rows.size, [touched, rows, known, self.keys])
            launch(number_missing_kernel, rows.size, [rows, known, voxels])
            self.count = known + rows.size
            self.table.append(self.keys, self.count, rows.size)
        arguments = [voxels, groups.starts, groups.order, places, known, self.room, self.sqspacing]
        launch(insert_points_kernel, groups.count, [*arguments, self.counts, self.places])

    def _grow(self, count):
        if count <= self.capacity:
            return
        capacity = max(count, 2 * self.capacity)
        if capacity * self.room > 2**31 - 1:
            raise ValueError(f"max_points_per_voxel: {self.room} x {capacity:,} voxels are more than 2^31 points")
        keys, counts = empty(capacity, int64, self.device), zeros(capacity, int32, self.device)
        places = empty(capacity * self.room, vec3, self.device)
        if self.count:
            copy(keys, self.keys, count=self.count)
            copy(counts, self.counts, count=self.count)
            copy(places, self.places, count=self.count * self.room)
        self.keys, self.counts, self.places, self.capacity = keys, counts, places, capacity

    def remove_far(self, center, limit):
        """Drop the voxels whose middle is farther [m] than a limit from a place; the others keep their order."""
        if not self.count:
            return
        marks = empty(self.count, uint8, self.device)
        arguments = [self.keys, vec3d(*center), self.voxel_size, limit, marks]
        launch(mark_near_voxels_kernel, self.count, arguments)
        rows = positions_of(marks)  # sync
        if rows.size == self.count:
            return
        old_keys, old_counts, old_places = self.keys, self.counts, self.places
        self.count, self.capacity = 0, 0
        self._grow(max(1024, rows.size + rows.size // 2))
        launch(gather_keys_kernel, rows.size, [old_keys, rows, 0, self.keys])
        launch(gather_voxels_kernel, rows.size, [rows, self.room, old_counts, old_places, self.counts, self.places])
        self.count = rows.size
        self.table = HashTable(self.device)
        self.table.append(self.keys, self.count, self.count)

    def points(self, near):
        """The points by voxel in the order of the voxels' coming: device array of vec3, about the float64 origin [3]
        that comes with it: the low corner of the voxel of the place `near` [m]."""
        first = self.cell_of(near)
        origin = [c * self.voxel_size for c in first]
        if not self.count:
            return empty(0, vec3, self.device), origin
        offsets, total = exclusive_scan(self.counts[: self.count].contiguous())  # sync
        points = empty(total, vec3, self.device)
        arguments = [self.keys, offsets, self.room, self.voxel_size, vec3i(*first), self.places, points]
        launch(gather_map_kernel, self.count, arguments)
        return points, origin
