"""Fusion of rigidly moved volumes into one, by trilinear resampling.

Each voxel of the result reads distance, weight and color at its position in each volume, if all contributing voxels are
observed. A coincident voxel copies its bits. Weighted running mean in float64. Curless and Levoy, SIGGRAPH 1996,
section 3.3. Kaehler, Prisacariu and Murray, ECCV 2016.
"""

import itertools
from collections.abc import Sequence

import numpy as np

from ..array_types import Device, Keys
from ..arrays.atomic_changes import Changes
from ..arrays.block_keys import CELL_BIAS, block_key, key_block
from ..arrays.concatenation import concatenate_rows
from ..arrays.hash_table import find_position, list_keys
from ..arrays.packed_keys import NO_KEY
from ..arrays.select import gather_rows, positions_of
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    compute,
    float64,
    floor,
    func,
    int32,
    int64,
    kernel,
    launch,
    mat33d,
    struct,
    tid,
    uint8,
    uint16,
    vec3d,
    vec3i,
    vector,
)
from ..linear_algebra import inv, matmul
from ..memory import copy, empty
from .block_rows import SeenBlocks, voxel_near
from .frame_record import FrameRecord
from .integrate import MAX_WEIGHT
from .tsdf_blocks import BLOCK_ROWS, BLOCK_SIDE, BLOCK_VOXELS, block_box, is_out_of_range
from .voxel_blocks import VoxelBlocks, check_block_count

CPU_RUN = 8  # voxels per thread: a row, mostly in one block of the other volume
SNAP_DISTANCE = 1.0e-6  # [voxels] closer positions are snapped to the voxel: float64 sums deviate by some 1e-10
KEYS_AT_ONCE = 1 << 23  # keys listed together: 64 MB
BLOCK_EDGE = 8.0  # [voxels] BLOCK_SIDE, for 64 bits
HALF_EDGE = 4.0  # [voxels] from the center of a block of positions to its face
sample = vector(5, float64)  # distance, weight, color


@struct
class MovedVolume:
    """A volume and its pose: q = R p + t maps voxels of the result to its own. `shrink`: ratio of truncations."""

    seen: SeenBlocks
    R: mat33d
    t: vec3d
    shrink: float64
    has_color: int

    def __init__(self, blocks: VoxelBlocks, matrix: np.ndarray, shrink: float, has_color: bool) -> None:
        self.seen, self.shrink, self.has_color = SeenBlocks(blocks, 0.0), shrink, int(has_color)
        self.R, self.t = mat33d(*matrix[:3, :3].ravel()), vec3d(*matrix[:3, 3])


@func
def snapped(a: float64) -> float64:
    nearest = floor(a + 0.5)
    b = a
    if abs(a - nearest) < float64(SNAP_DISTANCE):
        b = nearest
    return b


@func
def position_in(x: int, y: int, z: int, moved: MovedVolume) -> vec3d:
    q = moved.R @ vec3d(float64(x), float64(y), float64(z)) + moved.t
    return vec3d(snapped(q[0]), snapped(q[1]), snapped(q[2]))


@func
def block_at(a: float64) -> int:
    return int(floor(a / float64(BLOCK_EDGE)))


@func
def block_around(b: vec3i, moved: MovedVolume) -> int:
    block = -1
    if max(max(abs(b[0]), abs(b[1])), abs(b[2])) < CELL_BIAS - 1:
        block = find_position(block_key(b[0], b[1], b[2]), moved.seen.blocks.table)
    return block


@func
def fraction_of(f: float64, side: int) -> float64:
    fraction = 1.0 - f
    if side == 1:
        fraction = f
    return fraction


@func
def sample_volume(q: vec3d, block: int, b: vec3i, moved: MovedVolume) -> sample:
    """Trilinear mean at a position in a block. Weight 0 if a contributing voxel is unobserved."""
    x = int(floor(q[0]))
    y = int(floor(q[1]))
    z = int(floor(q[2]))
    fx = q[0] - float64(x)
    fy = q[1] - float64(y)
    fz = q[2] - float64(z)
    mean = sample(0.0)
    lacking = 0
    n = int(8)
    for c in range(n):
        dx = c >> 2
        dy = (c >> 1) & 1
        dz = c & 1
        fraction = fraction_of(fx, dx) * fraction_of(fy, dy) * fraction_of(fz, dz)
        if fraction > 0.0:
            voxel = voxel_near(
                block, x - b[0] * BLOCK_SIDE + dx, y - b[1] * BLOCK_SIDE + dy, z - b[2] * BLOCK_SIDE + dz, moved.seen
            )
            weight = float64(0.0)
            if voxel >= 0:
                weight = float64(moved.seen.blocks.weights[voxel])
            if weight > 0.0:
                mean[0] += fraction * float64(moved.seen.blocks.distances[voxel])
                mean[1] += fraction * weight
                if moved.has_color == 1:
                    for k in range(3):
                        mean[2 + k] += fraction * float64(moved.seen.blocks.colors[voxel, k])
            else:
                lacking += 1
    if lacking > 0:
        mean[1] = 0.0
    return mean


@func
def fold_sample(voxel: int, values: sample, moved: MovedVolume, blocks: VoxelBlocks):
    weight = max(floor(values[1] + 0.5), 1.0)
    old = float64(blocks.weights[voxel])
    total = old + weight
    d = min(max(values[0] * moved.shrink, -1.0), 1.0)
    blocks.distances[voxel] = float((float64(blocks.distances[voxel]) * old + d * weight) / total)
    if moved.has_color == 1:
        for k in range(3):
            shade = (float64(blocks.colors[voxel, k]) * old + values[2 + k] * weight) / total
            blocks.colors[voxel, k] = uint16(int(floor(shade + 0.5)))
    blocks.weights[voxel] = uint16(int(min(total, float64(MAX_WEIGHT))))


@kernel
def fold_volume_kernel(touched: array(dtype=int32), run: int, moved: MovedVolume, blocks: VoxelBlocks):
    """Merge another volume into the voxels of touched blocks, `run` voxels per thread."""
    i = tid()
    first = i * run
    own = touched[first // BLOCK_VOXELS]
    corner = key_block(blocks.keys[own])
    x = corner[0] * BLOCK_SIDE + first // BLOCK_ROWS % BLOCK_SIDE
    y = corner[1] * BLOCK_SIDE + first // BLOCK_SIDE % BLOCK_SIDE
    z = corner[2] * BLOCK_SIDE + first % BLOCK_SIDE
    last = vec3i(CELL_BIAS, CELL_BIAS, CELL_BIAS)
    block = -1
    for j in range(run):
        q = position_in(x, y, z + j, moved)
        b = vec3i(block_at(q[0]), block_at(q[1]), block_at(q[2]))
        if b[0] != last[0] or b[1] != last[1] or b[2] != last[2]:
            block = block_around(b, moved)
            last = vec3i(b[0], b[1], b[2])
        if block >= 0:
            values = sample_volume(q, block, b, moved)
            if values[1] > 0.0:
                fold_sample(own * BLOCK_VOXELS + first % BLOCK_VOXELS + j, values, moved, blocks)


@struct
class BlockMapping:
    """Mapping of a moved volume's blocks to those of the result: `R`, `t` to the result's voxels, `R_back`, `t_back`
    from them. Half sizes of the bounding boxes [voxels]. Maximum `slots` per axis."""

    R: mat33d
    t: vec3d
    half: vec3d
    R_back: mat33d
    t_back: vec3d
    half_back: vec3d
    slots: int

    def __init__(self, back: np.ndarray) -> None:
        there = inv(back)
        half = np.abs(there[:3, :3]).sum(axis=1) * HALF_EDGE
        half_back = np.abs(back[:3, :3]).sum(axis=1) * (HALF_EDGE - 0.5)
        self.R, self.t, self.half = mat33d(*there[:3, :3].ravel()), vec3d(*there[:3, 3]), vec3d(*half)
        self.R_back, self.t_back = mat33d(*back[:3, :3].ravel()), vec3d(*back[:3, 3])
        self.half_back = vec3d(*half_back)
        self.slots = int(np.ceil(2 * half.max() / BLOCK_SIDE)) + 1


@kernel
def list_reached_kernel(own_keys: array(dtype=int64), mapping: BlockMapping, reached: array(dtype=int64)):
    """Key of a block that may be reached, or NO_KEY if the boxes are disjoint."""
    i = tid()
    per_block = mapping.slots * mapping.slots * mapping.slots
    slot = i % per_block
    corner = key_block(own_keys[i // per_block])
    middle = vec3d(float64(corner[0]) + 0.5, float64(corner[1]) + 0.5, float64(corner[2]) + 0.5)
    middle = middle * float64(BLOCK_EDGE)
    p = mapping.R @ middle + mapping.t
    x = block_at(p[0] - mapping.half[0]) + slot // (mapping.slots * mapping.slots)
    y = block_at(p[1] - mapping.half[1]) + slot // mapping.slots % mapping.slots
    z = block_at(p[2] - mapping.half[2]) + slot % mapping.slots
    inner = vec3d(float64(x * BLOCK_SIDE), float64(y * BLOCK_SIDE), float64(z * BLOCK_SIDE)) + vec3d(3.5, 3.5, 3.5)
    back = mapping.R_back @ inner + mapping.t_back - middle
    apart = 0
    for axis in range(3):
        if abs(p[axis] - inner[axis]) > mapping.half[axis] + float64(HALF_EDGE):
            apart += 1
        if abs(back[axis]) > mapping.half_back[axis] + float64(HALF_EDGE) + float64(SNAP_DISTANCE):
            apart += 1
    key = int64(NO_KEY)
    if apart == 0:
        key = block_key(x, y, z)
    reached[i] = key


@kernel
def mark_seen_blocks_kernel(blocks: VoxelBlocks, seen: array(dtype=uint8)):
    i = tid()
    some = 0
    n = int(BLOCK_VOXELS)
    for j in range(n):
        if int(blocks.weights[i * BLOCK_VOXELS + j]) > 0:
            some = 1
    seen[i] = uint8(some)


def reached_blocks(blocks: VoxelBlocks, back: np.ndarray) -> Keys:
    """Ascending int64 keys of the result's blocks that a volume may reach. Raises ValueError beyond 2^20 blocks."""
    mapping, device = BlockMapping(back), blocks.device
    per_block = mapping.slots**3
    parts = []
    chunk = max(1, KEYS_AT_ONCE // per_block)
    own = blocks.keys[: blocks.count]
    for first in range(0, own.size, chunk):
        part = own[first : min(first + chunk, own.size)]
        reached = compute(list_reached_kernel, part.size * per_block, [part, mapping], int64, device)
        unique = UniqueKeys(reached)
        unique.drop_last(NO_KEY)
        parts.append(unique.keys)
    return _distinct(parts, device)


def _distinct(parts: Sequence[Keys], device: Device) -> Keys:
    parts = [part for part in parts if part.size]
    if not parts:
        return empty(0, int64, device)
    return parts[0] if len(parts) == 1 else UniqueKeys(concatenate_rows(parts)).keys


def check_range(keys: np.ndarray, back: np.ndarray) -> None:
    boxes = block_box(keys)
    low, high = boxes.min(axis=0) * BLOCK_SIDE, (boxes.max(axis=0) + 1) * BLOCK_SIDE
    corners = np.array(list(itertools.product(*zip(low, high, strict=True))), np.float64)
    there = inv(back)
    moved = (matmul(corners, there[:3, :3].T) + there[:3, 3]) / BLOCK_SIDE
    low = np.floor(moved.min(axis=0)) - 2
    if is_out_of_range(low, np.ceil(moved.max(axis=0)) + 2 - low):
        far = np.abs(moved).max()
        message = f"poses: a volume reaches {far:.3g} blocks from the result's origin; the limit is {CELL_BIAS:,}"
        raise ValueError(f"{message}; bring the poses nearer or take a larger voxel_size")


def fuse_moved(
    volumes: Sequence[VoxelBlocks],
    backs: Sequence[np.ndarray],
    colored: bool,
    voxel_size: float,
    truncation: float,
    has_color: bool,
    device: Device,
) -> VoxelBlocks:
    """Fuse volumes with poses `backs` (voxels of the result to those of each). Their order affects the last bits.
    `colored` selects the volumes whose colors are merged. Raises ValueError for more blocks than int32 can index."""
    reached = [reached_blocks(blocks, back) for blocks, back in zip(volumes, backs, strict=True)]
    keys = _distinct(reached, device)
    check_block_count(keys.size)
    result = blocks_of(keys, voxel_size, truncation, has_color, device)
    run = 1 if device.is_cuda else CPU_RUN
    for blocks, back, wanted in zip(volumes, backs, reached, strict=True):
        if wanted.size:
            touched, _ = result.table.find(wanted)
            moved = MovedVolume(blocks, back, blocks.truncation / truncation, colored)
            launch(fold_volume_kernel, wanted.size * BLOCK_VOXELS // run, [touched, run, moved, result])
    return drop_unseen(result)


def blocks_of(keys: Keys, voxel_size: float, truncation: float, has_color: bool, device: Device) -> VoxelBlocks:
    blocks = VoxelBlocks(voxel_size, truncation, has_color, device)
    blocks.reserve(keys.size)
    if keys.size:
        copy(blocks.keys, keys, count=keys.size)
    blocks.table, blocks.changes = list_keys(blocks.keys, keys.size), Changes(keys.size, device)
    blocks.record = FrameRecord(device, keys.size)
    return blocks


def drop_unseen(blocks: VoxelBlocks) -> VoxelBlocks:
    count = blocks.count
    if not count:
        return blocks
    seen = compute(mark_seen_blocks_kernel, count, [blocks], uint8, blocks.device)
    rows = positions_of(seen)
    if rows.size == count:
        return blocks
    keys = gather_rows(blocks.keys, rows) if rows.size else empty(0, int64, blocks.device)
    remaining = blocks_of(keys, blocks.voxel_size, blocks.truncation, blocks.has_color, blocks.device)
    if rows.size:
        columns = [("distances", 1), ("weights", 1), *([("colors", 3)] if blocks.has_color else [])]
        for name, width in columns:
            wide = getattr(blocks, name).reshape((-1, BLOCK_VOXELS * width))
            gathered = gather_rows(wide, rows)
            target = getattr(remaining, name)
            copy(target, gathered.reshape(-1) if width == 1 else gathered.reshape((-1, width)), count=gathered.size)
    return remaining
