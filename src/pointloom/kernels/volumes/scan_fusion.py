"""Integration of LiDAR scans into TSDF blocks.

Truncated distance along the ray ("simple" integrator of Oleynikova et al., "Voxblox", IROS 2017, section IV; Vizzo et
al., "VDBFusion", Sensors 2022, section 3.2). A voxel's mean over a scan counts as one frame. Integer sums, so the order
does not matter. 12 B per voxel of touched blocks, 44 B with color. One launch writes the volume.
"""

import numpy as np

from ..array_types import Array1, Integers, Keys
from ..arrays.hash_table import find_position
from ..arrays.select import number_rows_kernel
from ..lang import (
    array,
    atomic_add,
    dot,
    float64,
    floor,
    func,
    int32,
    int64,
    kernel,
    launch,
    struct,
    tid,
    uint16,
    vec3d,
)
from ..memory import full, zeros
from .integrate import MAX_WEIGHT, note_frame
from .scan_rays import (
    CELLS_PER_LENGTH,
    SPARE_CELLS,
    ScanRays,
    cell_at,
    distinct_keys,
    end_blocks,
    passed_blocks,
    ray_range,
    voxel_block_key,
)
from .tsdf_blocks import BLOCK_VOXELS, blocks_on_segment, voxel_in_block
from .voxel_blocks import VoxelBlocks

VALUE_STEPS = 16777216.0  # steps of a value, 2^24: the float32 resolution. Sums stay exact for 2^38 rays
COLOR_STEPS = 65535.0
SURFACE_SHADE = 65536  # weight of a color at its point, over that of 1 in the free space before it


@struct
class ScanSums:
    """Sums of a scan over the voxels of touched blocks. `slots` are the indices of blocks among these, or -1. `values`
    are in steps; `colors` int64 [512 m * 4] are weighted red, green, blue, and the weight."""

    slots: array(dtype=int32)
    values: array(dtype=int64)
    counts: array(dtype=int32)
    colors: array(dtype=int64)

    def __init__(self, touched: Integers, block_count: int, has_color: bool) -> None:
        device, voxels = touched.device, touched.size * BLOCK_VOXELS
        self.slots = full(block_count, -1, int32, device)
        launch(number_rows_kernel, touched.size, [touched, self.slots])
        self.values, self.counts = zeros(voxels, int64, device), zeros(voxels, int32, device)
        self.colors = zeros(4 * voxels if has_color else 4, int64, device)


@func
def slot_of(key: int64, blocks: VoxelBlocks, sums: ScanSums) -> int:
    block = find_position(key, blocks.table)
    slot = -1
    if block >= 0:
        slot = sums.slots[block]
    return slot


@func
def shade_steps(shade: float) -> int64:
    return int64(floor(float64(min(max(shade, 0.0), 1.0)) * float64(COLOR_STEPS) + 0.5))


@func
def add_value(
    i: int, slot: int, x: int, y: int, z: int, distance: float64, d: vec3d, o: vec3d, rays: ScanRays, sums: ScanSums
):
    """Add a ray's value at a voxel. Integer sums do not depend on the order."""
    to_voxel = vec3d(float64(x), float64(y), float64(z)) * rays.voxel_size - o
    value = (distance - dot(to_voxel, d)) / rays.truncation
    if value > -1.0:
        at = slot * BLOCK_VOXELS + voxel_in_block(x, y, z)
        atomic_add(sums.values, at, int64(floor(min(value, 1.0) * float64(VALUE_STEPS) + 0.5)))
        atomic_add(sums.counts, at, 1)
        if rays.has_color == 1:
            fraction = int64(1)
            if value < 1.0:
                fraction = int64(SURFACE_SHADE)
            color = rays.colors[i]
            atomic_add(sums.colors, 4 * at, fraction * shade_steps(color[0]))
            atomic_add(sums.colors, 4 * at + 1, fraction * shade_steps(color[1]))
            atomic_add(sums.colors, 4 * at + 2, fraction * shade_steps(color[2]))
            atomic_add(sums.colors, 4 * at + 3, fraction)


@kernel
def sum_rays_kernel(rays: ScanRays, carve: int, steps: int, blocks: VoxelBlocks, sums: ScanSums):
    """Add each ray to the voxels around its point and, if it carves, before it, in touched blocks, each voxel once."""
    i = tid()
    distance = ray_range(i, rays)
    if distance > 0.0:
        o = rays.scanners[i * rays.step]
        d = (rays.points[i] - o) / distance
        free = min(distance, rays.max_range) - rays.truncation
        a = cell_at(max(free, 0.0), d, o, rays)
        ax = int(floor(a[0]))
        ay = int(floor(a[1]))
        az = int(floor(a[2]))
        last = int64(-1)
        slot = -1
        has_end = distance <= rays.max_range
        if carve == 1 and free > 0.0:
            start = cell_at(float64(0.0), d, o, rays)
            for _k, x, y, z in blocks_on_segment(
                start, a, int(free / rays.voxel_size * float64(CELLS_PER_LENGTH)) + SPARE_CELLS
            ):
                key = voxel_block_key(x, y, z)
                if key != last:
                    slot = slot_of(key, blocks, sums)
                last = key
                if slot >= 0 and not (has_end and x == ax and y == ay and z == az):
                    add_value(i, slot, x, y, z, distance, d, o, rays, sums)
        last = int64(-1)
        if has_end:
            b = cell_at(distance + rays.truncation, d, o, rays)
            for _k, x, y, z in blocks_on_segment(a, b, steps):
                key = voxel_block_key(x, y, z)
                if key != last:
                    slot = slot_of(key, blocks, sums)
                last = key
                if slot >= 0:
                    add_value(i, slot, x, y, z, distance, d, o, rays, sums)


@kernel
def fold_sums_kernel(
    touched: array(dtype=int32),
    counts: array(dtype=int32),
    record: array(dtype=float64),
    has_color: int,
    sums: ScanSums,
    blocks: VoxelBlocks,
):
    """Fold a scan's means into the touched blocks. One thread per voxel."""
    i = tid()
    note_frame(i, counts, record, blocks)
    rays = sums.counts[i]
    if rays > 0:
        voxel = touched[i // BLOCK_VOXELS] * BLOCK_VOXELS + i % BLOCK_VOXELS
        w = float(blocks.weights[voxel])
        if has_color == 1:
            shades = float64(sums.colors[4 * i + 3])
            for c in range(3):
                mean = float64(blocks.colors[voxel, c]) * float64(w) + float64(sums.colors[4 * i + c]) / shades
                blocks.colors[voxel, c] = uint16(mean / float64(w + 1.0) + 0.5)
        value = float(float64(sums.values[i]) / float64(rays) / float64(VALUE_STEPS))
        blocks.distances[voxel] = (blocks.distances[voxel] * w + value) / (w + 1.0)
        blocks.weights[voxel] = uint16(min(w + 1.0, MAX_WEIGHT))


def scan_blocks(rays: ScanRays, carve: bool, blocks: VoxelBlocks) -> Keys:
    """Ascending int64 keys of the blocks around the points and, with `carve`, of existing blocks that rays pass."""
    ends = end_blocks(rays)
    return distinct_keys([ends, passed_blocks(rays, blocks)], rays.points.device) if carve else ends


def integrate_scan(keys: Keys, rays: ScanRays, carve: bool, blocks: VoxelBlocks) -> None:
    """Integrate a scan atomically into blocks `keys`, and carve space. Raises ValueError beyond int32 blocks."""
    touched = blocks.begin(keys)
    room: Array1[int64] = blocks.keys
    sums = ScanSums(touched, room.size, bool(rays.has_color))
    launch(sum_rays_kernel, rays.points.size, [rays, int(carve), rays.end_steps, blocks, sums])
    nowhere = np.zeros(3)
    record = blocks.record
    record.write(np.eye(4), np.eye(4), nowhere, nowhere, blocks.changes.number)
    fold = [touched, record.counts, record.values, rays.has_color, sums, blocks]
    launch(fold_sums_kernel, touched.size * BLOCK_VOXELS, fold)
    blocks.end()
    blocks.latest = (blocks.changes.number, touched)
