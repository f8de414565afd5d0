"""Integration of depth frames into blocks of truncated signed distances.

Curless and Levoy, "A volumetric method for building complex models from range images", SIGGRAPH 1996: each voxel keeps
the running mean of min(1, (d - z) / truncation) over the frames that see it no more than the truncation behind their
surface, d the depth at its pixel and z its own depth. One thread a row of 8 voxels: 6 B read and written a voxel
without colour, 12 B with it, and one pixel.

A voxel is 4 B of distance, 2 B of weight (it stops at 65535 frames) and 6 B of colour (16-bit fixed point, so that a
long mean does not stall as it would in 8 bits).
"""

from .lang import (
    array,
    float32,
    float64,
    floor,
    int32,
    int64,
    kernel,
    launch,
    mat33d,
    tid,
    uint8,
    uint16,
    vec3,
    vec3d,
    vec4,
)
from .tsdf_blocks import SIDE, key_block

ROWS = 64  # rows of a block: voxel (x, y, z) of a block stands at (x * 8 + y) * 8 + z
MAX_WEIGHT = 65535.0
COLOR_SCALE = 257.0  # 8-bit to 16-bit: 255 becomes 65535


@kernel
def integrate_depth_kernel(
    block_keys: array(dtype=int64),
    touched: array(dtype=int32),
    depth: array(dtype=float32),
    pixels: array(dtype=uint8, ndim=2),
    has_color: int,
    width: int,
    height: int,
    camera: vec4,
    R: mat33d,
    t: vec3d,
    voxel_size: float64,
    truncation: float,
    distances: array(dtype=float32),
    weights: array(dtype=uint16),
    colors: array(dtype=uint16, ndim=2),
):
    """Fold one frame into the rows of the touched blocks. R, t: volume to camera."""
    i = tid()
    block = touched[i // ROWS]
    row = i % ROWS
    corner = key_block(block_keys[block])
    x = corner[0] * SIDE + row // SIDE
    y = corner[1] * SIDE + row % SIDE
    z = corner[2] * SIDE
    start = R @ (vec3d(float64(x), float64(y), float64(z)) * voxel_size) + t
    p = vec3(float(start[0]), float(start[1]), float(start[2]))
    step = vec3(float(R[0, 2] * voxel_size), float(R[1, 2] * voxel_size), float(R[2, 2] * voxel_size))
    base = (block * ROWS + row) * SIDE
    inverse = 1.0 / truncation
    for j in range(SIDE):
        q = p + step * float(j)
        if q[2] > 0.0:
            scale = 1.0 / q[2]
            u = floor(q[0] * scale * camera[0] + camera[2] + 0.5)
            v = floor(q[1] * scale * camera[1] + camera[3] + 0.5)
            if u >= 0.0 and v >= 0.0 and u < float(width) and v < float(height):
                pixel = int(v) * width + int(u)
                d = depth[pixel]
                sdf = d - q[2]
                if d > 0.0 and sdf >= -truncation:
                    at = base + j
                    w = float(weights[at])
                    share = 1.0 / (w + 1.0)
                    distances[at] = (distances[at] * w + min(1.0, sdf * inverse)) * share
                    weights[at] = uint16(min(w + 1.0, MAX_WEIGHT))
                    if has_color == 1:
                        for c in range(3):
                            mean = float(colors[at, c]) * w + float(pixels[pixel, c]) * COLOR_SCALE
                            colors[at, c] = uint16(mean * share + 0.5)


def integrate_depth(block_keys, touched, frame, camera, T_camera_volume, voxel_size, truncation, voxels):
    """Fold one frame into touched blocks.

    Args:
        block_keys: int64 keys of all blocks.
        touched: int32 positions of the touched ones.
        frame: (depth float32 [h * w] in metres, pixels uint8 [h * w, 3], has_color, width, height).
        camera: (fx, fy, cx, cy).
        T_camera_volume: float64 [4, 4].
        voxel_size, truncation: [m].
        voxels: (distances float32, weights uint16, colors uint16 [.., 3]).
    """
    R, t = mat33d(*T_camera_volume[:3, :3].ravel()), vec3d(*T_camera_volume[:3, 3])
    arguments = [block_keys, touched, *frame, vec4(*camera), R, t, voxel_size, truncation, *voxels]
    launch(integrate_depth_kernel, touched.size * ROWS, arguments)
