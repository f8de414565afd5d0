"""Occupancy grid: log odds in hashed blocks of 8^3 voxels along rays.

The update is `OccupancyOcTreeBase::updateNode` of OctoMap: clamped float32 sums. 4 B per voxel, 32 to 56 B per block,
and 1 B per voxel of touched blocks during a scan. Memory at least doubles when it grows. One launch writes a scan, so
updates are atomic (arrays/atomic_changes.py).
"""

from typing import Any

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Array, Device, Indices, Integers, Keys, Mask, Points, Positions, Scalars
from ..arrays.atomic_changes import Changes, note_change
from ..arrays.block_keys import block_key
from ..arrays.bounds import bound_each
from ..arrays.hash_table import HashTable, find_position, list_keys
from ..arrays.select import number_rows_kernel, positions_of
from ..lang import (
    INFINITY,
    NAN,
    array,
    float32,
    float64,
    floor,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import copy, download, empty, full, zeros
from .occupancy_rays import (
    Lattice,
    ScanRays,
    mark_blocks_kernel,
    mark_hits_kernel,
    mark_passed_kernel,
    prepare_rays_kernel,
    voxels_on_ray,
)
from .tsdf_blocks import BLOCK_SIDE, BLOCK_VOXELS, MAX_BLOCKS, BlockMarks, voxel_cell, voxel_in_block
from .voxel_blocks import begin_blocks

UNKNOWN_LOG_ODDS = 1.0e9  # log odds of unobserved voxels. Observed ones are clamped far below
KNOWN_BELOW = 1.0e8
FIRST_CAPACITY = 256
MAX_CELLS = 1 << 26  # blocks in the box of a scan: 64 MB of flags
LARGEST_COMPONENT = 1.0e100  # of a direction: squares of larger ones overflow
MAX_KEY_VOXELS = 2.0**22  # [voxels] from the grid's origin: half the range of block keys


@struct
class OddsBlocks:
    """Blocks of log odds (UNKNOWN if never observed). `hit` and `miss` are increments of end points and passing rays,
    `lowest` and `highest` the clamps."""

    lattice: Lattice
    keys: array(dtype=int64)
    table: HashTable
    odds: array(dtype=float32)
    changes: Changes
    hit: float
    miss: float
    lowest: float
    highest: float

    def __init__(self, lattice: Lattice, log_odds: tuple[float, float, float, float], device: Device) -> None:
        self.lattice, self.log_odds, self.device = lattice, log_odds, device
        self.hit, self.miss, self.lowest, self.highest = log_odds
        self.changes, self.table, self.keys = Changes(0, device), HashTable(device), empty(0, int64, device)
        self.reserve(FIRST_CAPACITY)

    @property
    def count(self) -> int:
        self.changes.recover(self._list_keys)
        return int(self.changes.value)

    @property
    def scan_count(self) -> int:
        self.changes.recover(self._list_keys)
        return self.changes.count

    def _list_keys(self) -> None:
        self.table = list_keys(self.keys, int(self.changes.value))

    @property
    def memory_bytes(self) -> int:
        return sum(a.capacity for a in (self.odds, self.keys, self.table.keys, self.table.positions))

    def reserve(self, count: int) -> None:
        if count <= self.keys.size:
            return
        capacity, known = min(MAX_BLOCKS, max(count, 2 * self.keys.size)), int(self.changes.value)
        keys, odds = (
            empty(capacity, int64, self.device),
            full(capacity * BLOCK_VOXELS, UNKNOWN_LOG_ODDS, float32, self.device),
        )
        if known:
            copy(keys, self.keys, count=known)
            copy(odds, self.odds, count=known * BLOCK_VOXELS)
        self.odds = odds
        self.keys = keys  # last: its size defines the capacity

    def begin(self, keys: Keys) -> Indices:
        """Begin a scan over blocks with these int64 keys, appending new ones. Return their positions, int32."""
        return begin_blocks(self, keys, "grid")[0]

    def clone(self) -> "OddsBlocks":
        count, other = self.count, OddsBlocks(self.lattice, self.log_odds, self.device)
        other.reserve(count)
        if count:
            copy(other.keys, self.keys, count=count)
            copy(other.odds, self.odds, count=count * BLOCK_VOXELS)
        other.table, other.changes = list_keys(other.keys, count), Changes(count, self.device)
        return other

    def fill(self, keys: Keys, odds: Scalars) -> None:
        self.reserve(keys.size)
        if keys.size:
            copy(self.keys, keys, count=keys.size)
            copy(self.odds, odds, count=odds.size)
        self.table, self.changes = list_keys(self.keys, keys.size), Changes(keys.size, self.device)


@kernel
def fold_scan_kernel(indices: array(dtype=int32), flags: array(dtype=uint8), blocks: OddsBlocks):
    i = tid()
    note_change(i, blocks.changes)
    flag = int(flags[i])
    if flag != 0:
        voxel = indices[i // BLOCK_VOXELS] * BLOCK_VOXELS + i % BLOCK_VOXELS
        value = blocks.odds[voxel]
        if value > float(KNOWN_BELOW):
            value = 0.0
        if flag == 2:
            value = value + blocks.hit
        else:
            value = value + blocks.miss
        blocks.odds[voxel] = max(min(value, blocks.highest), blocks.lowest)


class WildScanError(ValueError):
    """A scan covers more blocks than supported at once."""


def prepare_rays(points: Points, shift: tuple[float, float, float], starts: Points, longest: float, lattice: Lattice):
    """Rays of a scan, and whether a point is infinite (sync)."""
    n, device = points.size, points.device
    rays = ScanRays(lattice, starts, empty(n, vec3, device), empty(n, uint8, device))
    infinite = zeros(1, int32, device)
    launch(prepare_rays_kernel, n, [points, vec3d(*shift), longest, rays, infinite])
    return rays, bool(download(infinite)[0])  # sync


def fold_scan(rays: ScanRays, blocks: OddsBlocks) -> int:
    """Integrate a scan. Return the number of touched blocks. Raises WildScanError if the rays are too long."""
    boxes = bound_each([rays.ends, rays.starts])  # sync
    if not boxes[0][2]:
        return 0
    low = np.minimum(boxes[0][0], boxes[1][0]).astype(np.float64) * blocks.lattice.per_meter
    high = np.maximum(boxes[0][1], boxes[1][1]).astype(np.float64) * blocks.lattice.per_meter
    if not max(np.abs(low).max(), np.abs(high).max()) < MAX_KEY_VOXELS:
        raise WildScanError(f"the scan reaches {max(np.abs(low).max(), np.abs(high).max()):.3g} voxels from the origin")
    low = np.floor(low / BLOCK_SIDE) - 1
    size = np.floor(high / BLOCK_SIDE) + 2 - low
    if size.prod() > MAX_CELLS:
        around = " x ".join(f"{BLOCK_SIDE * s * blocks.lattice.voxel_size:.6g}" for s in size)
        raise WildScanError(f"the scan fills a box of {around} m, {size.prod():.3g} blocks of 8^3 voxels")
    marks = BlockMarks(low, size, 0, 1, blocks.device, MAX_CELLS)
    launch(mark_blocks_kernel, rays.ends.size, [rays, marks])
    keys: Any = marks.touched()
    del marks
    indices = blocks.begin(keys)
    rows = empty(int(blocks.keys.size), int32, blocks.device)
    launch(number_rows_kernel, indices.size, [indices, rows])
    flags = zeros(indices.size * BLOCK_VOXELS, uint8, blocks.device)
    launch(mark_passed_kernel, rays.ends.size, [rays, blocks.table, rows, flags])
    launch(mark_hits_kernel, rays.ends.size, [rays, blocks.table, rows, flags])
    launch(fold_scan_kernel, flags.size, [indices, flags, blocks])
    blocks.changes.end()
    return int(indices.size)


@func
def odds_at(x: int, y: int, z: int, blocks: OddsBlocks) -> float:
    """Log odds of a voxel. UNKNOWN without a block."""
    position = find_position(block_key(x >> 3, y >> 3, z >> 3), blocks.table)
    value = float(UNKNOWN_LOG_ODDS)
    if position >= 0:
        value = blocks.odds[position * BLOCK_VOXELS + voxel_in_block(x, y, z)]
    return value


@kernel
def look_up_kernel(points: array(dtype=vec3), shift: vec3d, blocks: OddsBlocks, out: array(dtype=float32)):
    """Log odds at each point. UNKNOWN if it is out of range or not finite."""
    i = tid()
    p = narrow(widen(points[i]) + shift)
    value = float(UNKNOWN_LOG_ODDS)
    if isfinite(p):
        q = widen(p) * blocks.lattice.per_meter
        if max(abs(q[0]), max(abs(q[1]), abs(q[2]))) < float64(MAX_KEY_VOXELS):
            value = odds_at(int(floor(q[0])), int(floor(q[1])), int(floor(q[2])), blocks)
    out[i] = value


@kernel
def look_up_box_kernel(low: vec3i, size: vec3i, blocks: OddsBlocks, out: array(dtype=float32)):
    i = tid()
    x = i // (size[1] * size[2])
    y = (i // size[2]) % size[1]
    z = i % size[2]
    out[i] = odds_at(low[0] + x, low[1] + y, low[2] + z, blocks)


@kernel
def name_states_kernel(values: array(dtype=float32), threshold: float, unknown: int, states: array(dtype=uint8)):
    """State of each log odds: 1 occupied, 0 free, or `unknown`."""
    i = tid()
    value = values[i]
    state = 1
    if value < threshold:
        state = 0
    if value > float(KNOWN_BELOW):
        state = unknown
    states[i] = uint8(state)


@kernel
def hide_unknown_kernel(values: array(dtype=float32), out: array(dtype=float32)):
    i = tid()
    value = values[i]
    if value > float(KNOWN_BELOW):
        value = float(NAN)
    out[i] = value


@kernel
def mark_occupied_kernel(blocks: OddsBlocks, threshold: float, mask: array(dtype=uint8)):
    i = tid()
    value = blocks.odds[i]
    taken = 0
    if value >= threshold and value < float(KNOWN_BELOW):
        taken = 1
    mask[i] = uint8(taken)


@kernel
def list_voxels_kernel(rows: array(dtype=int32), blocks: OddsBlocks, out: array(dtype=vec3i)):
    i = tid()
    out[i] = voxel_cell(rows[i], blocks.keys)


@kernel
def write_centers_kernel(voxels: array(dtype=vec3i), lattice: Lattice, out: array(dtype=vec3)):
    i = tid()
    v = voxels[i]
    q = vec3d(float64(v[0]) + 0.5, float64(v[1]) + 0.5, float64(v[2]) + 0.5)
    out[i] = narrow(q * lattice.voxel_size)


@kernel
def prepare_queries_kernel(
    origins: array(dtype=vec3d),
    directions: array(dtype=vec3d),
    origin: vec3d,
    length: float64,
    limit: float64,
    starts: array(dtype=vec3),
    ends: array(dtype=vec3),
    faults: array(dtype=int32),
):
    """Ends of rays about the grid's origin, as of NumPy. One origin, or one per ray. `faults`: 1 if a direction is not
    finite, is zero, or a ray leaves the range. Marks are the same in any order."""
    i = tid()
    d = directions[i]
    size = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])
    a = origins[min(i, origins.shape[0] - 1)] - origin
    b = vec3d(a[0] + d[0] / size * length, a[1] + d[1] / size * length, a[2] + d[2] / size * length)
    largest = max(max(abs(d[0]), max(abs(d[1]), abs(d[2]))), float64(0.0))
    if not isfinite(d) or largest > float64(LARGEST_COMPONENT):
        faults[0] = 1
    elif not size > float64(0.0):
        faults[1] = 1
    elif not isfinite(a) or not isfinite(b):
        faults[2] = 1
    else:
        farthest = max(max(abs(a[0]), max(abs(a[1]), abs(a[2]))), max(abs(b[0]), max(abs(b[1]), abs(b[2]))))
        if not farthest < limit:
            faults[2] = 1
    starts[i] = narrow(a)
    ends[i] = narrow(b)


@kernel
def cast_rays_kernel(
    rays: ScanRays,
    threshold: float,
    blocks: OddsBlocks,
    states: array(dtype=int32),
    distances: array(dtype=float64),
    voxels: array(dtype=vec3i),
):
    """First non-free voxel on each ray: 1 occupied, -1 unknown, 0 none. Distance (infinite if none) and voxel."""
    i = tid()
    state = int(0)
    distance = float64(INFINITY)
    met = vec3i(0, 0, 0)
    a = rays.starts[i]
    b = rays.ends[i]
    for x, y, z, t in voxels_on_ray(a, b, 1, rays.lattice):
        value = odds_at(x, y, z, blocks)
        if value >= threshold:
            state = 1
            if value > float(KNOWN_BELOW):
                state = -1
            distance = t
            met = vec3i(x, y, z)
            break
    states[i] = state
    distances[i] = distance
    voxels[i] = met


def look_up(points: Points, shift: tuple[float, float, float], blocks: OddsBlocks) -> Scalars:
    out = empty(points.size, float32, points.device)
    launch(look_up_kernel, points.size, [points, vec3d(*shift), blocks, out])
    return out


def find_states(values: Scalars, threshold: float) -> Mask:
    """States of log odds: 1 occupied, 0 free, -1 unknown, as the bits of int8."""
    states = empty(values.size, uint8, values.device)
    launch(name_states_kernel, values.size, [values, threshold, 255, states])
    return states


def mask_occupied(values: Scalars, threshold: float) -> Mask:
    mask = empty(values.size, uint8, values.device)
    launch(name_states_kernel, values.size, [values, threshold, 0, mask])
    return mask


def hide_unknown(values: Scalars) -> Scalars:
    """Log odds with NaN for unobserved voxels."""
    out = empty(values.size, float32, values.device)
    launch(hide_unknown_kernel, values.size, [values, out])
    return out


def look_up_box(low: tuple[int, int, int], size: tuple[int, int, int], blocks: OddsBlocks) -> Scalars:
    out = empty(size[0] * size[1] * size[2], float32, blocks.device)
    launch(look_up_box_kernel, out.size, [vec3i(*low), vec3i(*size), blocks, out])
    return out


def list_occupied(blocks: OddsBlocks, threshold: float) -> Array:
    """Occupied voxels, vec3i, in block order (sync)."""
    count = blocks.count * BLOCK_VOXELS
    mask = empty(count, uint8, blocks.device)
    launch(mark_occupied_kernel, count, [blocks, threshold, mask])
    rows = positions_of(mask)
    voxels: Any = empty(rows.size, vec3i, blocks.device)
    launch(list_voxels_kernel, rows.size, [rows, blocks, voxels])
    return voxels


def voxel_centers(voxels: Array, lattice: Lattice) -> Points:
    out = empty(voxels.size, vec3, voxels.device)
    launch(write_centers_kernel, voxels.size, [voxels, lattice, out])
    return out


def prepare_queries(
    origins: Positions, directions: Positions, origin: tuple[float, float, float], length: float, limit: float
) -> tuple[Points, Points, Any]:
    """(starts, ends, faults) of rays about the grid's origin, see `prepare_queries_kernel`. One sync."""
    count, device = directions.size, directions.device
    starts, ends, faults = empty(count, vec3, device), empty(count, vec3, device), zeros(3, int32, device)
    given = [origins, directions, vec3d(*origin), float64(length), float64(limit)]
    launch(prepare_queries_kernel, count, [*given, starts, ends, faults])
    return starts, ends, download(faults)  # sync


def cast_rays(starts: Points, ends: Points, threshold: float, blocks: OddsBlocks) -> tuple[Integers, Any, Array]:
    """First non-free voxel on each ray: states int32, distances [m] float64, voxels vec3i."""
    n, device = starts.size, starts.device
    rays = ScanRays(blocks.lattice, starts, ends, empty(1, uint8, device))
    states, distances = empty(n, int32, device), empty(n, float64, device)
    voxels: Any = empty(n, vec3i, device)
    launch(cast_rays_kernel, n, [rays, threshold, blocks, states, distances, voxels])
    return states, distances, voxels
