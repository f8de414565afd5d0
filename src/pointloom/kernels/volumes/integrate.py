"""TSDF integration of depth frames into blocks.

Curless and Levoy, SIGGRAPH 1996: running mean of min(1, (d - z) / truncation) over frames that observe a voxel at most
the truncation behind the surface. 6 B per voxel, 12 B with color. A CPU thread processes rows of 8 voxels, a CUDA
thread single voxels, with bitwise equal results.
"""

import numpy as np

from ..algebra.camera import Camera, CameraLike
from ..algebra.plain_min_max import larger, smaller
from ..algebra.transform import narrow
from ..array_types import Array2, Doubles, Integers, Keys, Scalars
from ..arrays.block_keys import key_block
from ..lang import (
    array,
    float32,
    float64,
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
    vec3,
    vec3d,
    vector,
)
from ..memory import zeros
from .frame_record import (
    CHANGE_NUMBER,
    COUNTED_INDEX,
    INTO_CAMERA,
    MISSING_INDEX,
    TOUCHED_INDEX,
    recorded_rotation,
    recorded_translation,
)
from .tsdf_blocks import BLOCK_ROWS, BLOCK_SIDE, BLOCK_VOXELS
from .voxel_blocks import COLOR_SCALE, VoxelBlocks

CPU_RUN = 8  # rows per thread: the pose is applied once per 64 voxels
CUDA_GROUPS = 264  # groups of 512 threads: capacity of 132 SMs. Each processes several blocks of a frame
MAX_WEIGHT = 65535.0
COLOR_LIMIT = 65535.0  # removals may lead beyond it by rounding
MIN_DEPTH = 1.0e-6  # [m] keeps the division finite for voxels behind the camera, which are not used
UNSEEN_DISTANCE = -2.0  # below every truncated distance
run_values = vector(64, float32)  # of CPU_RUN rows
run_pixels = vector(64, int32)


@struct
class Frame:
    """A depth image [m] (0: none, at most `farthest`), its camera, and colors uint8 [h * w, 3] if `has_color`."""

    depth: array(dtype=float32)
    pixels: array(dtype=uint8, ndim=2)
    has_color: int
    camera: Camera

    def __init__(
        self, depth: Scalars, farthest: float, camera: CameraLike, pixels: Array2[uint8] | None = None
    ) -> None:
        self.depth, self.farthest, self.has_color = depth, farthest, int(pixels is not None)
        self.camera = camera  # type: ignore[assignment]  # like a Camera
        self.pixels = zeros((1, 3), uint8, depth.device) if pixels is None else pixels


@func
def changed_mean(mean: float, w: float, value: float, change: float) -> float:
    """The mean of `w` values after one is added (`change` 1.0) or removed (-1.0)."""
    return (mean * w + change * value) / (w + change)


@func
def change_color(voxel: int, pixel: int, change: float, frame: Frame, blocks: VoxelBlocks):
    """Add a pixel's color to a voxel's mean or remove it, as in `changed_mean`, before its weight changes."""
    w = float(blocks.weights[voxel])
    for c in range(3):
        shade = float(frame.pixels[pixel, c]) * COLOR_SCALE
        mean = changed_mean(float(blocks.colors[voxel, c]), w, shade, change)
        blocks.colors[voxel, c] = uint16(smaller(larger(mean, 0.0), COLOR_LIMIT) + 0.5)


@func
def pixel_of(u: float, v: float, right: float, bottom: float, width: int) -> int:
    column = int(smaller(larger(u, 0.0), right - 1.0))
    return int(smaller(larger(v, 0.0), bottom - 1.0)) * width + column


@func
def margin_of(u: float, v: float, right: float, bottom: float, z: float, d: float, truncation: float) -> float:
    """Positive if a voxel is observed: in the image, before the camera, measured, and not behind the truncation."""
    inside = smaller(smaller(u, right - u), smaller(v, bottom - v))
    return smaller(inside, smaller(smaller(z, d), d - z + truncation))


@func
def project_voxel(i: int, block: int, R: mat33d, t: vec3d, frame: Frame, blocks: VoxelBlocks) -> vec3:
    """The position (u, v) of a voxel in the image, from the image's corner [px], and its depth [m]."""
    row = float(i // BLOCK_SIDE % BLOCK_SIDE)
    j = float(i % BLOCK_SIDE)
    size = blocks.voxel_size
    corner = key_block(blocks.keys[block]) * BLOCK_SIDE
    x = corner[0] + i // BLOCK_ROWS % BLOCK_SIDE
    p = narrow(R @ (vec3d(float64(x), float64(corner[1]), float64(corner[2])) * size) + t)
    p0 = p[0] + float(R[0, 1] * size) * row
    p1 = p[1] + float(R[1, 1] * size) * row
    p2 = p[2] + float(R[2, 1] * size) * row
    depth_z = p2 + float(R[2, 2] * size) * j
    scale = 1.0 / larger(depth_z, MIN_DEPTH)
    u = (p0 + float(R[0, 2] * size) * j) * scale * float(frame.camera.fx) + (float(frame.camera.cx) + 0.5)
    v = (p1 + float(R[1, 2] * size) * j) * scale * float(frame.camera.fy) + (float(frame.camera.cy) + 0.5)
    return vec3(u, v, depth_z)


@func
def note_frame(i: int, counts: array(dtype=int32), record: array(dtype=float64), blocks: VoxelBlocks):
    if i == 0:
        counts[COUNTED_INDEX] = counts[COUNTED_INDEX] + counts[MISSING_INDEX]
        blocks.changes.latest[0] = int64(record[CHANGE_NUMBER])


@kernel(max_registers=64)
def integrate_depth_kernel(
    touched: array(dtype=int32),
    counts: array(dtype=int32),
    record: array(dtype=float64),
    stride: int,
    frame: Frame,
    blocks: VoxelBlocks,
):
    """Integrate `stride` rows per thread. All are computed before the first is stored: the branch is unpredictable."""
    i = tid()
    note_frame(i, counts, record, blocks)
    block = touched[i * stride // BLOCK_ROWS]
    first = i * stride % BLOCK_ROWS
    corner = key_block(blocks.keys[block])
    x = corner[0] * BLOCK_SIDE + first // BLOCK_SIDE
    y = corner[1] * BLOCK_SIDE + first % BLOCK_SIDE
    z = corner[2] * BLOCK_SIDE
    size = blocks.voxel_size
    R = recorded_rotation(record, INTO_CAMERA)
    p = narrow(R @ (vec3d(float64(x), float64(y), float64(z)) * size) + recorded_translation(record, INTO_CAMERA))
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
    values = run_values(0.0)
    pixels_seen = run_pixels(0)
    for row in range(stride):
        p0 = p[0] + next_row[0] * float(row)
        p1 = p[1] + next_row[1] * float(row)
        p2 = p[2] + next_row[2] * float(row)
        # The first and last loop have no branches, and the first stores to registers only: vector code on the CPU.
        for j in range(BLOCK_SIDE):
            depth_z = p2 + step[2] * float(j)
            scale = 1.0 / larger(depth_z, MIN_DEPTH)
            u = (p0 + step[0] * float(j)) * scale * fx + (cx + 0.5)
            v = (p1 + step[1] * float(j)) * scale * fy + (cy + 0.5)
            pixel = pixel_of(u, v, right, bottom, width)
            d = frame.depth[pixel]
            value = float(UNSEEN_DISTANCE)
            if margin_of(u, v, right, bottom, depth_z, d, truncation) > 0.0:
                value = smaller((d - depth_z) * inverse, 1.0)
            values[row * BLOCK_SIDE + j] = value
            pixels_seen[row * BLOCK_SIDE + j] = pixel
    for row in range(stride):
        base = (block * BLOCK_ROWS + first + row) * BLOCK_SIDE
        at = row * BLOCK_SIDE
        seen = 0
        for j in range(BLOCK_SIDE):
            if values[at + j] > UNSEEN_DISTANCE:
                seen += 1
        if seen > 0:
            if frame.has_color == 1:
                for j in range(BLOCK_SIDE):
                    if values[at + j] > UNSEEN_DISTANCE:
                        change_color(base + j, pixels_seen[at + j], 1.0, frame, blocks)
            for j in range(BLOCK_SIDE):
                old = blocks.distances[base + j]
                w = float(blocks.weights[base + j])
                new = old
                heavier = w
                if values[at + j] > UNSEEN_DISTANCE:
                    new = changed_mean(old, w, values[at + j], 1.0)
                    heavier = min(w + 1.0, MAX_WEIGHT)
                blocks.distances[base + j] = new
                blocks.weights[base + j] = uint16(heavier)


@integrate_depth_kernel.on_cuda
def integrate_voxels_kernel(
    touched: array(dtype=int32),
    counts: array(dtype=int32),
    record: array(dtype=float64),
    stride: int,
    frame: Frame,
    blocks: VoxelBlocks,
):
    """One thread per voxel of every `stride`-th touched block."""
    i = tid()
    note_frame(i, counts, record, blocks)
    R = recorded_rotation(record, INTO_CAMERA)
    t = recorded_translation(record, INTO_CAMERA)
    width = frame.camera.width
    truncation = float(blocks.truncation)
    right = float(width)
    bottom = float(frame.camera.height)
    at = i // BLOCK_VOXELS
    while at < counts[TOUCHED_INDEX]:
        block = touched[at]
        at += stride
        voxel = block * BLOCK_VOXELS + i % BLOCK_VOXELS
        at_pixel = project_voxel(i, block, R, t, frame, blocks)
        u = at_pixel[0]
        v = at_pixel[1]
        depth_z = at_pixel[2]
        pixel = pixel_of(u, v, right, bottom, width)
        d = frame.depth[pixel]
        if margin_of(u, v, right, bottom, depth_z, d, truncation) > 0.0:
            value = smaller((d - depth_z) * (1.0 / truncation), 1.0)
            if frame.has_color == 1:
                change_color(voxel, pixel, 1.0, frame, blocks)
            w = float(blocks.weights[voxel])
            blocks.distances[voxel] = changed_mean(blocks.distances[voxel], w, value, 1.0)
            blocks.weights[voxel] = uint16(min(w + 1.0, MAX_WEIGHT))


def launch_integration(
    touched: Integers, count: int, frame: Frame, blocks: VoxelBlocks, values: Doubles | None = None
) -> None:
    """Integrate a frame into `count` blocks. On CUDA into blocks.record.counts. `values`: another record."""
    stride, threads = CPU_RUN, count * BLOCK_ROWS // CPU_RUN
    if touched.device.is_cuda:
        stride, threads = CUDA_GROUPS, CUDA_GROUPS * BLOCK_VOXELS
    record = blocks.record
    given = record.values if values is None else values
    launch(integrate_depth_kernel, threads, [touched, record.counts, given, stride, frame, blocks])


def integrate_depth(keys: Keys, frame: Frame, T_camera_volume: np.ndarray, blocks: VoxelBlocks) -> None:
    """Integrate a frame atomically into blocks `keys`. Raises ValueError for more blocks than int32 can index."""
    touched = blocks.begin(keys)
    nowhere = np.zeros(3)
    blocks.record.write(np.eye(4), T_camera_volume, nowhere, nowhere, blocks.changes.number)
    launch_integration(touched, keys.size, frame, blocks)
    blocks.end()
    blocks.latest = (blocks.changes.number, touched)
