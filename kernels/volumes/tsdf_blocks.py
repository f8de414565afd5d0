"""Which blocks of a volume a depth frame touches.

A block is 8^3 voxels. A ray through every stride-th pixel walks the blocks between depth - truncation and depth +
truncation (Amanatides and Woo, "A fast voxel traversal algorithm", Eurographics 1987), so none on the ray is missed;
the stride is chosen so that neighbouring rays are less than half a block apart. Touched blocks are marked in a dense
grid over the frame's box where that is small, else listed and sorted: both give ascending keys.
"""

import math

import numpy as np

from ..arrays.block_keys import AXIS_BITS, BIAS, block_key
from ..arrays.packed_keys import NO_KEY
from ..arrays.select import positions_of
from ..arrays.unique import UniqueKeys
from ..lang import (
    array,
    float32,
    float64,
    floor,
    func,
    int32,
    int64,
    kernel,
    launch,
    mat33d,
    tid,
    uint8,
    vec3d,
    vec3i,
    vec4d,
)
from ..memory import empty, full, zeros

SIDE = 8  # voxels a block edge
ROWS = SIDE**2  # rows a block: voxel (x, y, z) of a block stands at (x * 8 + y) * 8 + z
BLOCK_VOXELS = SIDE**3
MAX_BLOCKS = (2**31 - 1) // (3 * BLOCK_VOXELS)  # colours of a volume stay below 2^31 numbers
MAX_GRID = 1 << 24  # cells of a dense grid: clearing 16 MB takes less than sorting a frame's keys
NO_CROSSING = 1.0e30  # the parameter of a ray that leaves its cell nowhere along an axis


@func
def first_crossing(start: float64, step: int, delta: float64) -> float64:
    """Ray parameter at which a ray leaves its first cell along one axis."""
    t = float64(NO_CROSSING)
    if step > 0:
        t = (floor(start) + float64(1.0) - start) * delta
    if step < 0:
        t = (start - floor(start)) * delta
    return t


@func
def step_along(d: float64) -> int:
    """The sign of a direction: -1, 0 or 1."""
    s = int(0)
    if d > float64(0.0):
        s = int(1)
    if d < float64(0.0):
        s = int(-1)
    return s


@func
def crossing_length(d: float64) -> float64:
    """Ray parameter between two crossings along one axis."""
    t = float64(NO_CROSSING)
    if d != float64(0.0):
        t = float64(1.0) / abs(d)
    return t


@kernel
def walk_rays_kernel(
    depth: array(dtype=float32),
    width: int,
    columns: int,
    stride: int,
    camera: vec4d,
    R: mat33d,
    t: vec3d,
    truncation: float64,
    block_size: float64,
    slots: int,
    dense: int,
    low: vec3i,
    size: vec3i,
    marks: array(dtype=uint8),
    keys: array(dtype=int64),
):
    """Mark or list the blocks on the piece of each ray around its depth; at most `slots` of them."""
    i = tid()
    u = min((i % columns) * stride, width - 1)  # the last column and row too
    v = min((i // columns) * stride, depth.shape[0] // width - 1)
    d = float64(depth[v * width + u])
    if d > float64(0.0):
        ray = vec3d((float64(u) - camera[2]) / camera[0], (float64(v) - camera[3]) / camera[1], float64(1.0))
        near = max(d - truncation, float64(0.0))
        a = (R @ (ray * near) + t) / block_size
        b = (R @ (ray * (d + truncation)) + t) / block_size
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
            if dense == 1:
                cx = x - low[0]
                cy = y - low[1]
                cz = z - low[2]
                if cx >= 0 and cy >= 0 and cz >= 0 and cx < size[0] and cy < size[1] and cz < size[2]:
                    marks[(cx * size[1] + cy) * size[2] + cz] = uint8(1)  # all threads write the same
            else:
                keys[i * slots + slot] = block_key(x, y, z)
            if min(tx, min(ty, tz)) > float64(1.0):
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


@kernel
def encode_cells_kernel(cells: array(dtype=int32), low: vec3i, size: vec3i, keys: array(dtype=int64)):
    """The block keys of cells of the dense grid."""
    i = tid()
    c = cells[i]
    x = c // (size[1] * size[2])
    y = (c // size[2]) % size[1]
    z = c % size[2]
    keys[i] = block_key(x + low[0], y + low[1], z + low[2])


def touched_blocks(depth, width, height, farthest, camera, T_world_camera, truncation, voxel_size):
    """The keys of the blocks within the truncation of a depth frame, ascending.

    Args:
        depth: float32 device array [height * width] in metres, 0 without measurement.
        farthest: No depth is beyond this [m].
        camera: (fx, fy, cx, cy).
        T_world_camera: float64 [4, 4], relative to the volume's origin.
        truncation, voxel_size: [m].

    Returns:
        int64 device array.

    Raises:
        ValueError: The frame reaches beyond 2^20 blocks from the volume's origin.
    """
    device, block_size = depth.device, SIDE * voxel_size
    spacing = farthest / min(camera[0], camera[1])
    stride = int(np.clip(block_size / 2 / spacing, 1, 4)) if spacing > 0 else 4
    columns, rows = -(-(width - 1) // stride) + 1, -(-(height - 1) // stride) + 1
    rays = columns * rows
    corners = np.array([[u, v, 1.0] for u in (0, width - 1) for v in (0, height - 1)])
    corners = (corners - [camera[2], camera[3], 0]) / [camera[0], camera[1], 1]
    reach = farthest + truncation
    ends = np.vstack([corners * reach, np.zeros((1, 3))]) @ T_world_camera[:3, :3].T + T_world_camera[:3, 3]
    low = np.floor(ends.min(axis=0) / block_size) - 1
    size = np.floor(ends.max(axis=0) / block_size) + 2 - low
    if np.abs(low).max() >= BIAS or np.abs(low + size).max() >= BIAS:
        raise ValueError(
            f"depth, extrinsic: the frame reaches {np.abs(ends).max():.0f} m from the volume's origin; "
            f"at {voxel_size} m a voxel the limit is {BIAS * block_size:.0f} m"
        )
    slots = (
        int(math.ceil(2 * truncation * float(np.linalg.norm(corners, axis=1).max()) / block_size * math.sqrt(3))) + 3
    )
    dense = bool(size.prod() <= MAX_GRID)
    marks = zeros(int(size.prod()) if dense else 1, uint8, device)
    keys = empty(1, int64, device) if dense else full(rays * slots, NO_KEY, int64, device)
    R, t = mat33d(*T_world_camera[:3, :3].ravel()), vec3d(*T_world_camera[:3, 3])
    frame = [depth, width, columns, stride, vec4d(*camera), R, t, truncation, block_size, slots]
    box = [vec3i(*low.astype(int)), vec3i(*size.astype(int))]
    launch(walk_rays_kernel, rays, [*frame, int(dense), *box, marks, keys])
    if dense:
        cells = positions_of(marks)
        keys = empty(cells.size, int64, device)
        launch(encode_cells_kernel, cells.size, [cells, *box, keys])
        return keys
    unique = UniqueKeys(keys)
    unique.drop_last(NO_KEY)
    return unique.keys


def block_box(keys):
    """Block coordinates of a NumPy array of keys, int64 [m, 3]."""
    mask = (1 << AXIS_BITS) - 1
    return np.stack([keys >> (2 * AXIS_BITS), (keys >> AXIS_BITS) & mask, keys & mask], axis=1) - BIAS
