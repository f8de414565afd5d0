"""LiDAR rays through volume blocks: required blocks, and blocks passed.

The end of a ray, the truncation before and behind the point, traverses all voxel cells (Amanatides and Woo, "A fast
voxel traversal algorithm", Eurographics 1987) in float64. The scan requires their blocks. Before that, only existing
blocks are marked. Cells are centered at multiples of the voxel size.
"""

import math
from typing import Any, NamedTuple

from ..array_types import Device, Keys, Mask, Points, Positions
from ..arrays.block_keys import CELL_BIAS, block_key
from ..arrays.hash_table import find_position
from ..arrays.packed_keys import NO_KEY
from ..arrays.select import gather_rows, positions_of
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    atomic_min,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    length,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
)
from ..memory import copy, download, empty, full, zeros
from .tsdf_blocks import BLOCK_SIDE, blocks_on_segment
from .voxel_blocks import VoxelBlocks

HALF_SIDE_BITS = 3  # 2^3 voxels per block edge
CELLS_PER_LENGTH = 1.7320509  # maximum number of cells on a path of length 1, besides the first
SPARE_CELLS = 4  # the same, plus one for rounding
MAX_FINITE_COORDINATE = 1.0e100  # [m] same limit, to prevent overflow of squares
RAYS_AT_A_TIME = 1 << 20  # blocks listed together


@struct
class ScanRays:
    """Rays from scanners to points relative to a volume's origin. `step` is 1 if each point has its own scanner, else
    0. `min_range` and `max_range` [m] limit the valid ranges. A longer ray passes space and has no end."""

    points: array(dtype=vec3d)
    scanners: array(dtype=vec3d)
    step: int
    colors: array(dtype=vec3)
    has_color: int
    min_range: float64
    max_range: float64
    voxel_size: float64
    truncation: float64

    def __init__(
        self,
        points: Positions,
        scanners: Positions,
        colors: Points | None,
        ranges: tuple[float, float],
        blocks: VoxelBlocks,
    ) -> None:
        self.points, self.scanners, self.step = points, scanners, int(scanners.size > 1)
        self.has_color = int(colors is not None)
        self.colors = zeros(1, vec3, points.device) if colors is None else colors
        self.min_range, self.max_range = ranges[0], min(ranges[1], MAX_FINITE_COORDINATE)
        self.voxel_size, self.truncation = blocks.voxel_size, blocks.truncation

    @property
    def slots(self) -> int:
        return math.ceil(2 * self.truncation / (BLOCK_SIDE * self.voxel_size) * CELLS_PER_LENGTH) + SPARE_CELLS

    @property
    def end_steps(self) -> int:
        return math.ceil(2 * self.truncation / self.voxel_size * CELLS_PER_LENGTH) + SPARE_CELLS


class Faults(NamedTuple):
    """First invalid rays, or the ray count: `infinite` for a non-finite point or distance, `far` out of range."""

    infinite: int
    far: int


@func
def ray_range(i: int, rays: ScanRays) -> float64:
    """Range of a point [m], or -1 if it is ignored."""
    along = rays.points[i] - rays.scanners[i * rays.step]
    distance = float64(-1.0)
    if isfinite(along):
        distance = length(along)
        if distance < rays.min_range or distance == 0.0:
            distance = float64(-1.0)
    return distance


@func
def cell_at(distance: float64, direction: vec3d, scanner: vec3d, rays: ScanRays) -> vec3d:
    """Position in cells at a range along a ray. Voxels are at cell centers."""
    return (scanner + direction * distance) / rays.voxel_size + vec3d(0.5, 0.5, 0.5)


@func
def voxel_block_key(x: int, y: int, z: int) -> int64:
    return block_key(x >> HALF_SIDE_BITS, y >> HALF_SIDE_BITS, z >> HALF_SIDE_BITS)


@kernel
def find_faults_kernel(rays: ScanRays, limit: float64, faults: array(dtype=int32)):
    """First infinite point, and the first beyond the limit. NaN is neither."""
    i = tid()
    p = rays.points[i]
    o = rays.scanners[i * rays.step]
    largest = max(abs(p[0]), max(abs(p[1]), abs(p[2])))
    if largest > float64(MAX_FINITE_COORDINATE):
        atomic_min(faults, 0, i)  # the minimum does not depend on the order
    if largest <= float64(MAX_FINITE_COORDINATE) and isfinite(p):
        distance = length(p - o)
        beyond = max(abs(o[0]), max(abs(o[1]), abs(o[2])))
        if distance >= rays.min_range and distance <= rays.max_range:
            beyond = max(beyond, largest)
        if beyond + min(distance, rays.max_range) * 1.0e-9 > limit:
            atomic_min(faults, 1, i)


@kernel
def list_end_blocks_kernel(rays: ScanRays, first: int, slots: int, steps: int, keys: array(dtype=int64)):
    """Keys of the blocks around each point, `slots` per ray, padded with NO_KEY."""
    i = tid()
    ray = first + i
    distance = ray_range(ray, rays)
    if distance > 0.0 and distance <= rays.max_range:
        o = rays.scanners[ray * rays.step]
        d = (rays.points[ray] - o) / distance
        a = cell_at(max(distance - rays.truncation, 0.0), d, o, rays)
        b = cell_at(distance + rays.truncation, d, o, rays)
        last = int64(-1)
        count = 0
        for _slot, x, y, z in blocks_on_segment(a, b, steps):
            key = voxel_block_key(x, y, z)
            if key != last and count < slots:
                keys[i * slots + count] = key
                count += 1
            last = key


@kernel
def mark_passed_blocks_kernel(rays: ScanRays, blocks: VoxelBlocks, passed: array(dtype=uint8)):
    i = tid()
    distance = ray_range(i, rays)
    free = min(distance, rays.max_range) - rays.truncation
    if free > 0.0:
        o = rays.scanners[i * rays.step]
        d = (rays.points[i] - o) / distance
        side = rays.voxel_size * float64(BLOCK_SIDE)
        a = cell_at(float64(0.0), d, o, rays) / float64(BLOCK_SIDE)
        b = cell_at(free, d, o, rays) / float64(BLOCK_SIDE)
        for _slot, x, y, z in blocks_on_segment(a, b, int(free / side * float64(CELLS_PER_LENGTH)) + SPARE_CELLS):
            block = find_position(block_key(x, y, z), blocks.table)
            if block >= 0:
                passed[block] = 1  # all threads write the same


def find_faults(rays: ScanRays) -> Faults:
    limit = (CELL_BIAS - 2) * BLOCK_SIDE * rays.voxel_size - rays.truncation - rays.voxel_size
    faults = full(2, rays.points.size, int32, rays.points.device)
    launch(find_faults_kernel, rays.points.size, [rays, limit, faults])
    infinite, far = download(faults).tolist()  # sync
    return Faults(infinite, far)


def end_blocks(rays: ScanRays) -> Keys:
    """Ascending int64 keys of the blocks around the points."""
    device, count, parts = rays.points.device, rays.points.size, []
    for first in range(0, count, RAYS_AT_A_TIME):
        some = min(RAYS_AT_A_TIME, count - first)
        keys = full(some * rays.slots, NO_KEY, int64, device)
        launch(list_end_blocks_kernel, some, [rays, first, rays.slots, rays.end_steps, keys])
        unique = UniqueKeys(keys)
        unique.drop_last(NO_KEY)
        parts.append(unique.keys)
    return distinct_keys(parts, device)


def passed_blocks(rays: ScanRays, blocks: VoxelBlocks) -> Keys:
    """Keys of existing blocks that rays pass before their ends, int64."""
    known = blocks.count
    passed: Mask = zeros(known, uint8, rays.points.device)
    launch(mark_passed_blocks_kernel, rays.points.size, [rays, blocks, passed])
    return gather_rows(blocks.keys, positions_of(passed))


def distinct_keys(parts: list[Any], device: Device) -> Keys:
    parts = [keys for keys in parts if keys.size]
    if len(parts) == 1:
        return parts[0]
    together = empty(sum(keys.size for keys in parts), int64, device)
    offset = 0
    for keys in parts:
        copy(together, keys, count=keys.size, offset=offset)
        offset += keys.size
    return UniqueKeys(together).keys
