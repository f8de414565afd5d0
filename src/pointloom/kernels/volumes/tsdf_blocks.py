"""Blocks of 8^3 voxels touched by a depth frame.

Rays through every stride-th pixel traverse the blocks from depth - truncation to depth + truncation (Amanatides and
Woo, "A fast voxel traversal algorithm", Eurographics 1987). The stride keeps neighboring rays less than half a block
apart. Blocks are marked in a dense grid if that is small, else listed and sorted.
"""

import functools
import math

import numpy as np
from numpy.typing import NDArray

from ..algebra.camera import Camera, CameraLike, pixel_ray
from ..algebra.transform import Transform, transform_point
from ..array_types import Device, LongIntegers, Scalars
from ..arrays.block_keys import AXIS_BITS, CELL_BIAS, block_key, key_block
from ..arrays.packed_keys import NO_KEY
from ..arrays.select import positions_of
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    compute,
    float32,
    float64,
    floor,
    func,
    int32,
    int64,
    kernel,
    launch,
    loop,
    struct,
    tid,
    uint8,
    vec3d,
    vec3i,
)
from ..linear_algebra import matmul
from ..memory import download, empty, full, upload, zeros

BLOCK_SIDE = 8  # voxels per block edge
BLOCK_ROWS = BLOCK_SIDE**2  # rows per block: voxel (x, y, z) of a block has index (x * 8 + y) * 8 + z
BLOCK_VOXELS = BLOCK_SIDE**3
MAX_BLOCKS = (2**31 - 1) // (3 * BLOCK_VOXELS)  # colors of a volume have fewer than 2^31 numbers
MAX_GRID = 1 << 24  # cells of a dense grid: clearing 16 MB is faster than sorting a frame's keys
MAX_STRIDE = 4  # pixels between rays
NO_CROSSING = 1.0e30  # parameter of a ray parallel to an axis


@func
def voxel_in_block(x: int, y: int, z: int) -> int:
    return ((x & (BLOCK_SIDE - 1)) * BLOCK_SIDE + (y & (BLOCK_SIDE - 1))) * BLOCK_SIDE + (z & (BLOCK_SIDE - 1))


@func
def voxel_cell(voxel: int, keys: array(dtype=int64)) -> vec3i:
    block = key_block(keys[voxel // BLOCK_VOXELS])
    k = voxel % BLOCK_VOXELS
    return vec3i(
        BLOCK_SIDE * block[0] + k // BLOCK_ROWS,
        BLOCK_SIDE * block[1] + (k // BLOCK_SIDE) % BLOCK_SIDE,
        BLOCK_SIDE * block[2] + k % BLOCK_SIDE,
    )


@func
def first_crossing(start: float64, step: int, delta: float64) -> float64:
    t = float64(NO_CROSSING)
    if step > 0:
        t = (floor(start) + 1.0 - start) * delta
    if step < 0:
        t = (start - floor(start)) * delta
    return t


@func
def step_along(d: float64) -> int:
    s = 0
    if d > 0.0:
        s = 1
    if d < 0.0:
        s = -1
    return s


@func
def crossing_length(d: float64) -> float64:
    t = float64(NO_CROSSING)
    if d != 0.0:
        t = 1.0 / abs(d)
    return t


@loop
def blocks_on_segment(a: vec3d, b: vec3d, slots: int) -> tuple[int, int, int, int]:
    """At most `slots` blocks from a to b (positions in blocks), numbered in order."""
    along = b - a
    x = int(floor(a[0]))
    y = int(floor(a[1]))
    z = int(floor(a[2]))
    sx = step_along(along[0])
    sy = step_along(along[1])
    sz = step_along(along[2])
    dx = crossing_length(along[0])
    dy = crossing_length(along[1])
    dz = crossing_length(along[2])
    tx = first_crossing(a[0], sx, dx)
    ty = first_crossing(a[1], sy, dy)
    tz = first_crossing(a[2], sz, dz)
    for slot in range(slots):
        yield slot, x, y, z
        if min(tx, min(ty, tz)) > 1.0:
            break
        if tx <= ty and tx <= tz:
            x += sx
            tx += dx
        else:
            if ty <= tz:
                y += sy
                ty += dy
            else:
                z += sz
                tz += dz


@struct
class BlockMarks:
    """Blocks touched by rays: marks in a dense uint8 grid (z fastest), or `slots` keys per ray, padded with NO_KEY."""

    is_dense: int
    low: vec3i
    size: vec3i
    grid: array(dtype=uint8)
    slots: int
    keys: array(dtype=int64)

    def __init__(
        self, low: np.ndarray, size: np.ndarray, ray_count: int, slots: int, device: Device, limit: int = MAX_GRID
    ) -> None:
        self.is_dense = int(size.prod() <= limit)
        self.low, self.size, self.slots = vec3i(*low.astype(int)), vec3i(*size.astype(int)), slots
        self.grid = zeros(int(size.prod()) if self.is_dense else 1, uint8, device)
        self.keys = empty(1, int64, device) if self.is_dense else full(ray_count * slots, NO_KEY, int64, device)

    def touched(self) -> LongIntegers:
        if self.is_dense and self.grid.device.is_cpu:
            x, y, z = np.unravel_index(np.flatnonzero(download(self.grid)), self.size)
            return upload(box_keys(x + self.low[0], y + self.low[1], z + self.low[2]), int64, self.grid.device)
        if self.is_dense:
            cells = positions_of(self.grid)
            return compute(encode_cells_kernel, cells.size, [cells, self], int64, self.grid.device)
        unique = UniqueKeys(self.keys)
        unique.drop_last(NO_KEY)
        return unique.keys


@func
def leave_mark(x: int, y: int, z: int, ray: int, slot: int, marks: BlockMarks):
    """Mark or list a block as the `slot`-th of a ray."""
    if marks.is_dense == 1:
        cx = x - marks.low[0]
        cy = y - marks.low[1]
        cz = z - marks.low[2]
        if cx >= 0 and cy >= 0 and cz >= 0 and cx < marks.size[0] and cy < marks.size[1] and cz < marks.size[2]:
            marks.grid[(cx * marks.size[1] + cy) * marks.size[2] + cz] = 1  # all threads write the same
    else:
        marks.keys[ray * marks.slots + slot] = block_key(x, y, z)


@kernel
def traverse_rays_kernel(
    depth: array(dtype=float32),
    columns: int,
    stride: int,
    camera: Camera,
    T_volume_camera: Transform,
    truncation: float64,
    block_size: float64,
    marks: BlockMarks,
):
    """Mark or list at most `slots` blocks around the depth of each ray."""
    i = tid()
    u = min((i % columns) * stride, camera.width - 1)  # including the last column and row
    v = min((i // columns) * stride, depth.shape[0] // camera.width - 1)
    d = float64(depth[v * camera.width + u])
    if d > 0.0:
        ray = pixel_ray(float64(u), float64(v), camera)
        near = max(d - truncation, 0.0)
        a = transform_point(ray * near, T_volume_camera) / block_size
        b = transform_point(ray * (d + truncation), T_volume_camera) / block_size
        for slot, x, y, z in blocks_on_segment(a, b, marks.slots):
            leave_mark(x, y, z, i, slot, marks)


@kernel
def encode_cells_kernel(cells: array(dtype=int32), marks: BlockMarks, keys: array(dtype=int64)):
    i = tid()
    c = cells[i]
    x = c // (marks.size[1] * marks.size[2])
    y = (c // marks.size[2]) % marks.size[1]
    z = c % marks.size[2]
    keys[i] = block_key(x + marks.low[0], y + marks.low[1], z + marks.low[2])


def ray_stride(farthest: float, camera: CameraLike, block_size: float) -> int:
    """Pixel distance of rays for depths up to `farthest` [m]."""
    spacing = farthest / min(camera.fx, camera.fy)
    return int(min(max(block_size / 2 / spacing, 1), MAX_STRIDE)) if spacing > 0 else MAX_STRIDE


def ray_grid(camera: CameraLike, stride: int) -> tuple[int, int]:
    return -(-(camera.width - 1) // stride) + 1, -(-(camera.height - 1) // stride) + 1


def frame_box(
    farthest: float, camera: CameraLike, T_volume_camera: np.ndarray, truncation: float, voxel_size: float
) -> tuple[np.ndarray, np.ndarray, int]:
    """Frame bounds for depths up to `farthest` [m]: (low block, size in blocks, maximum number of blocks per ray)."""
    block_size = BLOCK_SIDE * voxel_size
    corners, _ = _corner_rays(camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy)
    ends = corners * (farthest + truncation)
    ends = matmul(ends, T_volume_camera[:3, :3].T) + T_volume_camera[:3, 3]
    low = np.floor(np.minimum.reduce(ends) / block_size) - 1
    size = np.floor(np.maximum.reduce(ends) / block_size) + 2 - low
    return low, size, ray_slots(camera, truncation, voxel_size)


def ray_slots(camera: CameraLike, truncation: float, voxel_size: float) -> int:
    """Maximum number of blocks per ray for any pose."""
    _, longest = _corner_rays(camera.width, camera.height, camera.fx, camera.fy, camera.cx, camera.cy)
    return int(math.ceil(2 * truncation * longest / (BLOCK_SIDE * voxel_size) * math.sqrt(3))) + 3


@functools.lru_cache(64)
def _corner_rays(
    width: int, height: int, fx: float, fy: float, cx: float, cy: float
) -> tuple[NDArray[np.float64], float]:
    """Rays through the image corners at depth 1 and the camera, float64 [5, 3]. The length of the longest."""
    corners = np.array([[u, v, 1.0] for u in (0, width - 1) for v in (0, height - 1)])
    corners = (corners - [cx, cy, 0]) / [fx, fy, 1]
    return np.vstack([corners, np.zeros((1, 3))]), float(np.linalg.norm(corners, axis=1).max())


def is_out_of_range(low: np.ndarray, size: np.ndarray) -> bool:
    return not max(np.abs(low).max(), np.abs(low + size).max()) < CELL_BIAS


def touched_blocks(
    depth: Scalars,
    farthest: float,
    camera: CameraLike,
    T_volume_camera: np.ndarray,
    truncation: float,
    voxel_size: float,
) -> LongIntegers:
    """Ascending keys of blocks within the truncation of depth [m] (0: none). Raises ValueError beyond 2^20 blocks."""
    block_size = BLOCK_SIDE * voxel_size
    stride = ray_stride(farthest, camera, block_size)
    columns, rows = ray_grid(camera, stride)
    low, size, slots = frame_box(farthest, camera, T_volume_camera, truncation, voxel_size)
    if is_out_of_range(low, size):
        far = np.abs(np.concatenate([low, low + size])).max() * block_size
        raise ValueError(
            f"depth, extrinsic: the frame reaches {far:.0f} m from the volume's origin; "
            f"at {voxel_size} m a voxel the limit is {CELL_BIAS * block_size:.0f} m"
        )
    marks = BlockMarks(low, size, columns * rows, slots, depth.device)
    frame = [depth, columns, stride, camera, Transform(T_volume_camera), truncation, block_size]
    launch(traverse_rays_kernel, columns * rows, [*frame, marks])
    return marks.touched()


def box_keys(x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    return (((x + CELL_BIAS) << AXIS_BITS | (y + CELL_BIAS)) << AXIS_BITS) | (z + CELL_BIAS)


def block_box(keys: np.ndarray) -> np.ndarray:
    mask = (1 << AXIS_BITS) - 1
    return np.stack([keys >> (2 * AXIS_BITS), (keys >> AXIS_BITS) & mask, keys & mask], axis=1) - CELL_BIAS
