"""Integration of depth frames into blocks of truncated signed distances.

Curless and Levoy, "A volumetric method for building complex models from range images", SIGGRAPH 1996: each voxel keeps
the running mean of min(1, (d - z) / truncation) over the frames that see it no more than the truncation behind their
surface, d the depth at its pixel and z its own depth. One thread a run of rows of 8 voxels: 6 B read and written a
voxel without colour, 12 B with it, and one pixel.
"""

from ..algebra.camera import Camera
from ..algebra.plain_min_max import larger, smaller
from ..algebra.transform import Transform, narrow, transform_point
from ..arrays.block_keys import key_block
from ..arrays.changes import note_change
from ..lang import (
    array,
    float32,
    float64,
    int32,
    kernel,
    launch,
    struct,
    tid,
    uint8,
    uint16,
    vec3,
    vec3d,
    vector,
)
from ..memory import zeros
from .tsdf_blocks import ROWS, SIDE
from .voxel_blocks import COLOR_SCALE, VoxelBlocks

CPU_RUN = 8  # rows a thread: the pose is applied once for 64 voxels
CUDA_RUN = 1  # as many threads as can be; not measured
MAX_WEIGHT = 65535.0
NEAREST = 1.0e-6  # [m] keeps the division finite for voxels behind the camera, which are not used
UNSEEN = -2.0  # below every truncated distance
row_values = vector(8, float32)
row_pixels = vector(8, int32)


@struct
class Frame:
    """A depth picture, perhaps with colour, and its camera.

    Attributes:
        depth: float32 [h * w] in metres, 0 without measurement.
        farthest: No depth is beyond this [m].
        pixels: uint8 [h * w, 3], the colours; one row where there are none.
        has_color: Whether there are.
        camera: A Camera, or what has its attributes.
    """

    depth: array(dtype=float32)
    pixels: array(dtype=uint8, ndim=2)
    has_color: int
    camera: Camera

    def __init__(self, depth, farthest, camera, pixels=None):
        self.depth, self.farthest, self.camera, self.has_color = depth, farthest, camera, int(pixels is not None)
        self.pixels = zeros((1, 3), uint8, depth.device) if pixels is None else pixels


@kernel
def integrate_depth_kernel(
    touched: array(dtype=int32), run: int, frame: Frame, T_camera_volume: Transform, blocks: VoxelBlocks
):
    """Fold one frame into the rows of the touched blocks."""
    i = tid()
    note_change(i, blocks.changes)
    block = touched[i * run // ROWS]
    first = i * run % ROWS
    corner = key_block(blocks.keys[block])
    x = corner[0] * SIDE + first // SIDE
    y = corner[1] * SIDE + first % SIDE
    z = corner[2] * SIDE
    size = blocks.voxel_size
    start = transform_point(vec3d(float64(x), float64(y), float64(z)) * size, T_camera_volume)
    p = narrow(start)
    R = T_camera_volume.R
    next_row = vec3(float(R[0, 1] * size), float(R[1, 1] * size), float(R[2, 1] * size))
    step = vec3(float(R[0, 2] * size), float(R[1, 2] * size), float(R[2, 2] * size))
    width = frame.camera.width
    fx = float(frame.camera.fx)
    fy = float(frame.camera.fy)
    cx = float(frame.camera.cx)
    cy = float(frame.camera.cy)
    truncation = float(blocks.truncation)
    right = float(width)
    bottom = float(frame.camera.height)
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
            u = (p0 + step[0] * float(j)) * scale * fx + (cx + 0.5)
            v = (p1 + step[1] * float(j)) * scale * fy + (cy + 0.5)
            column = int(smaller(larger(u, 0.0), right - 1.0))
            pixel = int(smaller(larger(v, 0.0), bottom - 1.0)) * width + column
            d = frame.depth[pixel]
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
            if frame.has_color == 1:
                for j in range(SIDE):
                    if values[j] > UNSEEN:
                        w = float(blocks.weights[base + j])
                        for c in range(3):
                            shade = float(frame.pixels[pixels_seen[j], c]) * COLOR_SCALE
                            mean = float(blocks.colors[base + j, c]) * w + shade
                            blocks.colors[base + j, c] = uint16(mean / (w + 1.0) + 0.5)
            for j in range(SIDE):
                old = blocks.distances[base + j]
                w = float(blocks.weights[base + j])
                new = old + 0.0
                heavier = w + 0.0
                if values[j] > UNSEEN:
                    new = (old * w + values[j]) / (w + 1.0)
                    heavier = min(w + 1.0, MAX_WEIGHT)
                blocks.distances[base + j] = new
                blocks.weights[base + j] = uint16(heavier)


def integrate_depth(keys, frame, T_camera_volume, blocks):
    """Fold one frame into the blocks that it touches, wholly or, where that is interrupted, not at all.

    Args:
        keys: int64 keys of the touched blocks, at least one.
        frame: A Frame.
        T_camera_volume: float64 [4, 4].
        blocks: The VoxelBlocks.

    Raises:
        ValueError: More blocks than 32 bits can index; the blocks stay as they were.
    """
    touched = blocks.begin(keys)
    run = CUDA_RUN if touched.device.is_cuda else CPU_RUN
    arguments = [touched, run, frame, Transform(T_camera_volume), blocks]
    launch(integrate_depth_kernel, touched.size * ROWS // run, arguments)
    blocks.end()
