"""Camera rays into a volume, with depth bounds per tile of 8 x 8 pixels.

One thread per block projects the boxes of its 4^3 parts that may contain a surface (block_signs.py) and extends the
depth range of the tiles that they cover. 8 B per tile.
"""

import numpy as np

from ..algebra.camera import Camera, CameraLike
from ..algebra.transform import narrow
from ..arrays.block_keys import CELL_BIAS, key_block
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
from ..linear_algebra import inv, matmul
from ..memory import empty, fill
from .block_signs import PART_CELLS, PARTS_PER_BLOCK, BlockSigns
from .tsdf_blocks import BLOCK_SIDE
from .voxel_blocks import VoxelBlocks

TILE_PIXELS = 8  # pixels per side
BLOCK_MARGIN = 1.0  # [px] margin around a projected block, above rounding
HALF_PART = 2.0  # [voxels] from the center of a part to its faces
INFINITY_BITS = 0x7F800000  # the bits of infinity


@struct
class CameraRays:
    """Camera rays in voxels relative to the camera's voxel `base`. `R` is camera to volume; `sight` maps a pixel
    (column, row, 1) to its ray per meter of depth; `nears` and `fars` are bits of the depth range [m] of tiles."""

    camera: Camera
    R: mat33d
    sight: mat33d
    base: vec3i
    start: vec3
    nearest: float
    farthest: float
    columns: int
    nears: array(dtype=int32)
    fars: array(dtype=int32)

    def __init__(
        self,
        camera: CameraLike,
        T_volume_camera: np.ndarray,
        nearest: float,
        farthest: float,
        blocks: VoxelBlocks,
        signs: BlockSigns,
    ) -> None:
        self.camera, self.nearest, self.farthest = camera, nearest, farthest  # type: ignore[assignment]  # like a Camera
        position = T_volume_camera[:3, 3] / blocks.voxel_size
        if np.abs(position).max() >= CELL_BIAS * BLOCK_SIDE:
            raise ValueError(
                f"extrinsic: the camera is {np.abs(T_volume_camera[:3, 3]).max():.0f} m from the volume's origin; "
                f"at {blocks.voxel_size} m a voxel the limit is {CELL_BIAS * BLOCK_SIDE * blocks.voxel_size:.0f} m"
            )
        base = np.floor(position)
        self.R, self.base = mat33d(*T_volume_camera[:3, :3].ravel()), vec3i(*base.astype(int))
        self.start = position - base
        K = np.array([[camera.fx, 0.0, camera.cx], [0.0, camera.fy, camera.cy], [0.0, 0.0, 1.0]])
        self.sight = mat33d(*(matmul(T_volume_camera[:3, :3], inv(K)) / blocks.voxel_size).ravel())
        self.columns, rows = -(-camera.width // TILE_PIXELS), -(-camera.height // TILE_PIXELS)
        device = blocks.keys.device
        self.nears, self.fars = empty(self.columns * rows, int32, device), empty(self.columns * rows, int32, device)
        fill(self.nears, INFINITY_BITS)
        fill(self.fars, 0)
        launch(bound_tiles_kernel, blocks.count, [self, blocks, signs, rows, self.nears, self.fars])


@func
def ray_of(column: int, row: int, rays: CameraRays) -> vec3:
    return narrow(rays.sight @ vec3d(float64(column), float64(row), 1.0))


@func
def in_camera(x: float64, y: float64, z: float64, R: mat33d) -> vec3d:
    return vec3d(
        R[0, 0] * x + R[1, 0] * y + R[2, 0] * z,
        R[0, 1] * x + R[1, 1] * y + R[2, 1] * z,
        R[0, 2] * x + R[1, 2] * y + R[2, 2] * z,
    )


@func
def tile_of(pixel: float64, count: int) -> int:
    inside = max(0.0, min(pixel, float64(count * TILE_PIXELS - 1)))
    return int(inside) // TILE_PIXELS


@func
def bound_box(
    middle: vec3d, half_size: vec3d, rays: CameraRays, rows: int, nears: array(dtype=int32), fars: array(dtype=int32)
):
    """Extend the depth range of the tiles that a box in the camera frame [m] may cover."""
    near = max(middle[2] - half_size[2], float64(rays.nearest))
    far = middle[2] + half_size[2]
    if far >= near and near <= float64(rays.farthest):
        left = min((middle[0] - half_size[0]) / near, (middle[0] - half_size[0]) / far)
        right = max((middle[0] + half_size[0]) / near, (middle[0] + half_size[0]) / far)
        top = min((middle[1] - half_size[1]) / near, (middle[1] - half_size[1]) / far)
        bottom = max((middle[1] + half_size[1]) / near, (middle[1] + half_size[1]) / far)
        left = rays.camera.fx * left + rays.camera.cx - float64(BLOCK_MARGIN)
        right = rays.camera.fx * right + rays.camera.cx + float64(BLOCK_MARGIN)
        top = rays.camera.fy * top + rays.camera.cy - float64(BLOCK_MARGIN)
        bottom = rays.camera.fy * bottom + rays.camera.cy + float64(BLOCK_MARGIN)
        is_beside = right < 0.0 or left > float64(rays.camera.width)
        is_above = bottom < 0.0 or top > float64(rays.camera.height)
        if not is_beside and not is_above:
            near_bits = float_bits(float(near))
            far_bits = float_bits(float(far))
            for row in range(tile_of(top, rows), tile_of(bottom, rows) + 1):
                for column in range(tile_of(left, rays.columns), tile_of(right, rays.columns) + 1):
                    atomic_min(nears, row * rays.columns + column, near_bits)
                    atomic_max(fars, row * rays.columns + column, far_bits)


@kernel
def bound_tiles_kernel(
    rays: CameraRays,
    blocks: VoxelBlocks,
    signs: BlockSigns,
    rows: int,
    nears: array(dtype=int32),
    fars: array(dtype=int32),
):
    """Extend the depth range of tiles that surface parts of a block may cover, by order-independent extremes."""
    i = tid()
    parts = signs.parts[i]
    if parts != 0:
        low = key_block(blocks.keys[i]) * BLOCK_SIDE - rays.base
        size = blocks.voxel_size
        half = size * float64(HALF_PART)
        R = rays.R
        half_size = vec3d(
            half * (abs(R[0, 0]) + abs(R[1, 0]) + abs(R[2, 0])),
            half * (abs(R[0, 1]) + abs(R[1, 1]) + abs(R[2, 1])),
            half * (abs(R[0, 2]) + abs(R[1, 2]) + abs(R[2, 2])),
        )
        for part in range(PARTS_PER_BLOCK):
            if ((parts >> part) & 1) == 1:
                x = float64(low[0] + (part >> 2) * PART_CELLS) + float64(HALF_PART) - float64(rays.start[0])
                y = float64(low[1] + ((part >> 1) & 1) * PART_CELLS) + float64(HALF_PART) - float64(rays.start[1])
                z = float64(low[2] + (part & 1) * PART_CELLS) + float64(HALF_PART) - float64(rays.start[2])
                bound_box(in_camera(x * size, y * size, z * size, R), half_size, rays, rows, nears, fars)
