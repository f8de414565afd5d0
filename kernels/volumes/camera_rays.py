"""The rays of a camera into a volume, and the depths between which they can meet its blocks.

The picture is parted into tiles of 8 x 8 pixels. One thread a block projects the box around it in the camera's
frame, and lowers the nearest and
raises the farthest depth of the tiles that it may be seen in: what the rays of a tile pass before that is empty. 8 B a
tile; of a room at 1 cm a voxel a VGA picture of 4,800 tiles is bounded in 2 ms.
"""

import numpy as np

from ..algebra.camera import Camera
from ..arrays.block_keys import BIAS, key_block
from ..lang import (
    array,
    atomic_max,
    atomic_min,
    float64,
    float_bits,
    func,
    int32,
    kernel,
    launch,
    mat33d,
    struct,
    tid,
    vec3,
    vec3d,
    vec3i,
)
from ..memory import empty, fill
from .tsdf_blocks import SIDE
from .voxel_blocks import VoxelBlocks

TILE = 8  # pixels a side
MARGIN = 1.0  # [px] about a block's picture: more than rounding moves it
BEYOND = 1.0e30  # any depth or pixel
FARTHEST = 0x7F800000  # the bits of infinity


@struct
class CameraRays:
    """The rays of a camera into a volume; places count in voxels from the camera's own voxel.

    Attributes:
        camera: A Camera, or what has its attributes.
        R: Camera to volume.
        base: The camera's own voxel.
        start: The camera.
        nearest, farthest: Depths [m] where rays begin and end.
        columns: Tiles a row.
        nears, fars: int32 [tiles], the bits of the depths [m] between which blocks are seen in each tile.
    """

    camera: Camera
    R: mat33d
    base: vec3i
    start: vec3
    nearest: float
    farthest: float
    columns: int
    nears: array(dtype=int32)
    fars: array(dtype=int32)

    def __init__(self, camera, T_volume_camera, nearest, farthest, blocks):
        self.camera, self.nearest, self.farthest = camera, nearest, farthest
        place = T_volume_camera[:3, 3] / blocks.voxel_size
        if np.abs(place).max() >= BIAS * SIDE:
            raise ValueError(
                f"extrinsic: the camera is {np.abs(T_volume_camera[:3, 3]).max():.0f} m from the volume's origin; "
                f"at {blocks.voxel_size} m a voxel the limit is {BIAS * SIDE * blocks.voxel_size:.0f} m"
            )
        base = np.floor(place)
        self.R, self.base, self.start = mat33d(*T_volume_camera[:3, :3].ravel()), vec3i(*base.astype(int)), place - base
        self.columns, rows = -(-camera.width // TILE), -(-camera.height // TILE)
        device = blocks.keys.device
        self.nears, self.fars = empty(self.columns * rows, int32, device), empty(self.columns * rows, int32, device)
        fill(self.nears, FARTHEST)
        fill(self.fars, 0)
        launch(bound_tiles_kernel, blocks.count, [self, blocks, rows, self.nears, self.fars])


@func
def corner_in_camera(block: vec3i, corner: int, rays: CameraRays, voxel_size: float64) -> vec3d:
    """A corner of a block in the camera's frame [m]."""
    x = float64((block[0] + (corner & 1)) * SIDE - rays.base[0]) - float64(rays.start[0])
    y = float64((block[1] + ((corner >> 1) & 1)) * SIDE - rays.base[1]) - float64(rays.start[1])
    z = float64((block[2] + (corner >> 2)) * SIDE - rays.base[2]) - float64(rays.start[2])
    R = rays.R
    return voxel_size * vec3d(
        R[0, 0] * x + R[1, 0] * y + R[2, 0] * z,
        R[0, 1] * x + R[1, 1] * y + R[2, 1] * z,
        R[0, 2] * x + R[1, 2] * y + R[2, 2] * z,
    )


@func
def tile_of(place: float64, count: int) -> int:
    """The tile of a row or column of pixels, the first or last of `count` beyond the picture."""
    inside = max(float64(0.0), min(place, float64(count * TILE - 1)))
    return int(inside) // TILE


@kernel
def bound_tiles_kernel(
    rays: CameraRays, blocks: VoxelBlocks, rows: int, nears: array(dtype=int32), fars: array(dtype=int32)
):
    """Widen the depths of the tiles that a block may be seen in; minima and maxima do not depend on the order."""
    i = tid()
    block = key_block(blocks.keys[i])
    low = vec3d(float64(BEYOND), float64(BEYOND), float64(BEYOND))
    high = -low
    n = int(8)
    for corner in range(n):
        p = corner_in_camera(block, corner, rays, blocks.voxel_size)
        low = vec3d(min(low[0], p[0]), min(low[1], p[1]), min(low[2], p[2]))
        high = vec3d(max(high[0], p[0]), max(high[1], p[1]), max(high[2], p[2]))
    near = max(low[2], float64(rays.nearest))
    far = high[2]
    if far >= near and near <= float64(rays.farthest):
        left = rays.camera.fx * min(low[0] / near, low[0] / far) + rays.camera.cx - float64(MARGIN)
        right = rays.camera.fx * max(high[0] / near, high[0] / far) + rays.camera.cx + float64(MARGIN)
        top = rays.camera.fy * min(low[1] / near, low[1] / far) + rays.camera.cy - float64(MARGIN)
        bottom = rays.camera.fy * max(high[1] / near, high[1] / far) + rays.camera.cy + float64(MARGIN)
        is_beside = right < float64(0.0) or left > float64(rays.camera.width)
        is_above = bottom < float64(0.0) or top > float64(rays.camera.height)
        if not is_beside and not is_above:
            near_bits = float_bits(float(near))
            far_bits = float_bits(float(far))
            for row in range(tile_of(top, rows), tile_of(bottom, rows) + 1):
                for column in range(tile_of(left, rays.columns), tile_of(right, rays.columns) + 1):
                    atomic_min(nears, row * rays.columns + column, near_bits)
                    atomic_max(fars, row * rays.columns + column, far_bits)
