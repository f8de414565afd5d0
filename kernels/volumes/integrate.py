"""Integration of depth frames into blocks of truncated signed distances.

Curless and Levoy, "A volumetric method for building complex models from range images", SIGGRAPH 1996: each voxel keeps
the running mean of min(1, (d - z) / truncation) over the frames that see it no more than the truncation behind their
surface, d the depth at its pixel and z its own depth. One thread a run of rows of 8 voxels: 6 B read and written a
voxel without colour, 12 B with it, and one pixel.

A voxel is 4 B of distance, 2 B of weight (it stops at 65535 frames) and 6 B of colour (16-bit fixed point, so that a
long mean does not stall as it would in 8 bits).
"""

from ..algebra.plain_min_max import larger, smaller
from ..arrays.block_keys import key_block
from ..lang import (
    array,
    float32,
    float64,
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
    vector,
)
from .tsdf_blocks import ROWS, SIDE

CPU_RUN = 8  # rows a thread: the pose is applied once for 64 voxels
CUDA_RUN = 1  # as many threads as can be; not measured
MAX_WEIGHT = 65535.0
COLOR_SCALE = 257.0  # 8-bit to 16-bit: 255 becomes 65535
NEAREST = 1.0e-6  # [m] keeps the division finite for voxels behind the camera, which are not used
UNSEEN = -2.0  # below every truncated distance
row_values = vector(8, float32)
row_pixels = vector(8, int32)


@kernel
def integrate_depth_kernel(
    block_keys: array(dtype=int64),
    touched: array(dtype=int32),
    run: int,
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
    block = touched[i * run // ROWS]
    first = i * run % ROWS
    corner = key_block(block_keys[block])
    x = corner[0] * SIDE + first // SIDE
    y = corner[1] * SIDE + first % SIDE
    z = corner[2] * SIDE
    start = R @ (vec3d(float64(x), float64(y), float64(z)) * voxel_size) + t
    p = vec3(float(start[0]), float(start[1]), float(start[2]))
    next_row = vec3(float(R[0, 1] * voxel_size), float(R[1, 1] * voxel_size), float(R[2, 1] * voxel_size))
    step = vec3(float(R[0, 2] * voxel_size), float(R[1, 2] * voxel_size), float(R[2, 2] * voxel_size))
    right = float(width)
    bottom = float(height)
    inverse = 1.0 / truncation
    values = row_values(0.0)
    pixels_seen = row_pixels(0)
    for row in range(run):
        base = (block * ROWS + first + row) * SIDE
        p0 = p[0] + next_row[0] * float(row)
        p1 = p[1] + next_row[1] * float(row)
        p2 = p[2] + next_row[2] * float(row)
        # The first and the last loop have no branches, and the first stores to registers alone: vector code on the CPU.
        for j in range(SIDE):
            depth_z = p2 + step[2] * float(j)
            scale = 1.0 / larger(depth_z, NEAREST)
            u = (p0 + step[0] * float(j)) * scale * camera[0] + (camera[2] + 0.5)
            v = (p1 + step[1] * float(j)) * scale * camera[1] + (camera[3] + 0.5)
            column = int(smaller(larger(u, 0.0), right - 1.0))
            pixel = int(smaller(larger(v, 0.0), bottom - 1.0)) * width + column
            d = depth[pixel]
            sdf = d - depth_z
            # All that must be positive: in the picture, before the camera, measured, not behind the truncation.
            inside = smaller(smaller(u, right - u), smaller(v, bottom - v))
            least = smaller(inside, smaller(smaller(depth_z, d), sdf + truncation))
            value = float(UNSEEN)
            if least > 0.0:
                value = smaller(sdf * inverse, 1.0)
            values[j] = value
            pixels_seen[j] = pixel
        seen = int(0)
        for j in range(SIDE):
            if values[j] > UNSEEN:
                seen += 1
        if seen > 0:
            if has_color == 1:
                for j in range(SIDE):
                    if values[j] > UNSEEN:
                        w = float(weights[base + j])
                        for c in range(3):
                            mean = float(colors[base + j, c]) * w + float(pixels[pixels_seen[j], c]) * COLOR_SCALE
                            colors[base + j, c] = uint16(mean / (w + 1.0) + 0.5)
            for j in range(SIDE):
                old = distances[base + j]
                w = float(weights[base + j])
                new = old + 0.0
                heavier = w + 0.0
                if values[j] > UNSEEN:
                    new = (old * w + values[j]) / (w + 1.0)
                    heavier = min(w + 1.0, MAX_WEIGHT)
                distances[base + j] = new
                weights[base + j] = uint16(heavier)


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
    run = CUDA_RUN if touched.device.is_cuda else CPU_RUN
    arguments = [block_keys, touched, run, *frame, vec4(*camera), R, t, voxel_size, truncation, *voxels]
    launch(integrate_depth_kernel, touched.size * ROWS // run, arguments)
