"""The rays of a LiDAR scan through the blocks of a volume: which blocks they need, and which they pass.

A ray runs from where the scanner stood to a point. Around its end, from the truncation before the point to the
truncation behind it, it walks all voxels whose cells it crosses (Amanatides and Woo, "A fast voxel traversal
algorithm", Eurographics 1987), in float64; the blocks of these are what the scan needs. Before that it may pass blocks
that are there already, which are marked. Cells are centred on their voxels, at whole multiples of the voxel size.

24 B read a ray and scanner, 8 B written for each block that an end can touch: 5 for the usual truncation.
"""

import math
from typing import Any, NamedTuple

from ..array_types import Device, Keys, Mask, Points, Positions
from ..arrays.block_keys import BIAS, block_key
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
from .tsdf_blocks import SIDE, blocks_on_way
from .voxel_blocks import VoxelBlocks

HALF_SIDE_BITS = 3  # 2^3 voxels a block edge
DIAGONAL = 1.7320509  # cells that a walk of length 1 enters at most, beside those where it begins
SPARE = 4  # those, and one for rounding
INFINITE = 1.0e100  # [m] as large, or the root of its square overflows
RAYS_AT_A_TIME = 1 << 20  # whose blocks are listed together


@struct
class ScanRays:
    """Rays from scanners to points, about a volume's origin.

    Attributes:
        points: vec3d [n] [m].
        scanners: vec3d [n], or [1] for all.
        step: 1 where each point has a scanner of its own, else 0.
        colors: float32 [n, 3] in 0..1; one row where there are none.
        has_color: Whether there are.
        least, most: Ranges [m] that count; beyond the most a ray passes space, and has no end.
        voxel_size, truncation: [m].
    """

    points: array(dtype=vec3d)
    scanners: array(dtype=vec3d)
    step: int
    colors: array(dtype=vec3)
    has_color: int
    least: float64
    most: float64
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
        self.least, self.most = ranges[0], min(ranges[1], INFINITE)
        self.voxel_size, self.truncation = blocks.voxel_size, blocks.truncation

    @property
    def slots(self) -> int:
        """Blocks that the end of a ray touches at most."""
        return math.ceil(2 * self.truncation / (SIDE * self.voxel_size) * DIAGONAL) + SPARE

    @property
    def end_steps(self) -> int:
        """Voxels that it touches at most."""
        return math.ceil(2 * self.truncation / self.voxel_size * DIAGONAL) + SPARE


class Faults(NamedTuple):
    """The first rays that no volume takes, as many as there are rays where none is such.

    Attributes:
        infinite: A point or a distance that is not finite, NaN aside.
        far: An end, or a scanner, beyond what block keys reach.
    """

    infinite: int
    far: int


@func
def ray_range(i: int, rays: ScanRays) -> float64:
    """How far a point is from its scanner [m]; -1 where it does not count."""
    along = rays.points[i] - rays.scanners[i * rays.step]
    reach = float64(-1.0)
    if isfinite(along):
        reach = length(along)
        if reach < rays.least or reach == 0.0:
            reach = float64(-1.0)
    return reach


@func
def cell_at(reach: float64, direction: vec3d, scanner: vec3d, rays: ScanRays) -> vec3d:
    """The place in cells, which voxels lie in the middle of, at a range along a ray."""
    return (scanner + direction * reach) / rays.voxel_size + vec3d(0.5, 0.5, 0.5)


@func
def voxel_block_key(x: int, y: int, z: int) -> int64:
    """The key of a voxel's block."""
    return block_key(x >> HALF_SIDE_BITS, y >> HALF_SIDE_BITS, z >> HALF_SIDE_BITS)


@kernel
def find_faults_kernel(rays: ScanRays, limit: float64, faults: array(dtype=int32)):
    """The first infinite point, and the first that is farther than the limit from the origin; NaN is neither."""
    i = tid()
    p = rays.points[i]
    o = rays.scanners[i * rays.step]
    largest = max(abs(p[0]), max(abs(p[1]), abs(p[2])))
    if largest > float64(INFINITE):
        atomic_min(faults, 0, i)  # the least in any order
    if largest <= float64(INFINITE) and isfinite(p):
        reach = length(p - o)
        beyond = max(abs(o[0]), max(abs(o[1]), abs(o[2])))
        if reach >= rays.least and reach <= rays.most:
            beyond = max(beyond, largest)
        if beyond + min(reach, rays.most) * 1.0e-9 > limit:
            atomic_min(faults, 1, i)


@kernel
def list_end_blocks_kernel(rays: ScanRays, first: int, slots: int, steps: int, keys: array(dtype=int64)):
    """The keys of the blocks around each point, `slots` a ray; the rest stay NO_KEY."""
    i = tid()
    ray = first + i
    reach = ray_range(ray, rays)
    if reach > 0.0 and reach <= rays.most:
        o = rays.scanners[ray * rays.step]
        d = (rays.points[ray] - o) / reach
        a = cell_at(max(reach - rays.truncation, 0.0), d, o, rays)
        b = cell_at(reach + rays.truncation, d, o, rays)
        last = int64(-1)
        count = 0
        for _slot, x, y, z in blocks_on_way(a, b, steps):
            key = voxel_block_key(x, y, z)
            if key != last and count < slots:
                keys[i * slots + count] = key
                count += 1
            last = key


@kernel
def mark_passed_blocks_kernel(rays: ScanRays, blocks: VoxelBlocks, passed: array(dtype=uint8)):
    """1 for the blocks of the volume that a ray passes before its end."""
    i = tid()
    reach = ray_range(i, rays)
    free = min(reach, rays.most) - rays.truncation
    if free > 0.0:
        o = rays.scanners[i * rays.step]
        d = (rays.points[i] - o) / reach
        side = rays.voxel_size * float64(SIDE)
        a = cell_at(float64(0.0), d, o, rays) / float64(SIDE)
        b = cell_at(free, d, o, rays) / float64(SIDE)
        for _slot, x, y, z in blocks_on_way(a, b, int(free / side * float64(DIAGONAL)) + SPARE):
            found = find_position(block_key(x, y, z), blocks.table)
            if found >= 0:
                passed[found] = 1  # all threads write the same


def find_faults(rays: ScanRays) -> Faults:
    """The first rays that the volume cannot take (one sync)."""
    limit = (BIAS - 2) * SIDE * rays.voxel_size - rays.truncation - rays.voxel_size
    faults = full(2, rays.points.size, int32, rays.points.device)
    launch(find_faults_kernel, rays.points.size, [rays, limit, faults])
    infinite, far = download(faults).tolist()  # sync
    return Faults(infinite, far)


def end_blocks(rays: ScanRays) -> Keys:
    """The keys of the blocks around the points, int64, ascending: those that the scan needs."""
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
    """The keys of the volume's blocks that rays pass before their ends, int64."""
    known = blocks.count
    passed: Mask = zeros(known, uint8, rays.points.device)
    launch(mark_passed_blocks_kernel, rays.points.size, [rays, blocks, passed])
    return gather_rows(blocks.keys, positions_of(passed))


def distinct_keys(parts: list[Any], device: Device) -> Keys:
    """The distinct ones among several lists of keys, ascending."""
    parts = [keys for keys in parts if keys.size]
    if len(parts) == 1:
        return parts[0]
    together = empty(sum(keys.size for keys in parts), int64, device)
    place = 0
    for keys in parts:
        copy(together, keys, count=keys.size, offset=place)
        place += keys.size
    return UniqueKeys(together).keys
