"""Depth images to meters, points, normals and colors. Pinhole model x = (u - cx) z / fx, pixel centers at integers."""

import numpy as np

from ..algebra.camera import Camera, CameraLike
from ..algebra.transform import Transform, narrow, transform_point
from ..array_types import AnyArray, Array1, Array2, Bytes, Integers, Scalars, Vectors
from ..arrays.packed_keys import BYTE_MASK
from ..arrays.row_atomics import raise_int
from ..arrays.runs import Runs, elements_of, row_of
from ..lang import (
    NAN,
    array,
    compute,
    cross,
    dot,
    float32,
    float64,
    float_bits,
    floor,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    mat33d,
    sqrt,
    struct,
    tid,
    uint8,
    uint16,
    vec3,
    vec3d,
    vector,
)
from ..memory import download, empty, zeros

PIXELS_PER_RUN = 1024  # pixels per thread of an atomic reduction on the CPU
UINT16_MAX = 0xFFFF  # the largest raw depth
LANE_COUNT = 8  # pixels of a thread that fits normals, which a CPU fits at once
octet = vector(8, float32)  # one number per pixel of a thread
NYU_SCALE, NYU_OFFSET = 351.3, 1092.5  # meters = scale / (offset - raw), as in the data set's toolbox
RED_WEIGHT, GREEN_WEIGHT, BLUE_WEIGHT = 0.2990, 0.5870, 0.1140  # weights of brightness (ITU-R BT.601)


@kernel
def decode_sun_kernel(raw: array(dtype=uint16), depth: array(dtype=uint16)):
    """SUN3D: millimeters, rotated left by three bits."""
    i = tid()
    x = int(raw[i])
    depth[i] = uint16(((x >> 3) | (x << 13)) & UINT16_MAX)


@kernel
def decode_nyu_kernel(raw: array(dtype=uint16), depth: array(dtype=uint16)):
    """NYU Depth v2: byte-swapped disparity; whole millimeters, 0 for none."""
    i = tid()
    x = int(raw[i])
    x = ((x & BYTE_MASK) << 8) | (x >> 8)
    meters = float64(NYU_SCALE) / (float64(NYU_OFFSET) - float64(x))
    millimeters = 0
    if meters > 0.0:
        millimeters = min(int(floor(meters * 1000.0 + 0.5)), UINT16_MAX)
    depth[i] = uint16(millimeters)


@kernel
def scale_depth_kernel(
    raw: array(dtype=uint16),
    runs: Runs,
    scale: float,
    farthest: float,
    depth: array(dtype=float32),
    largest: array(dtype=int32),
):
    """Integers to meters, 0 beyond the limit; and a row's maximum, as bits."""
    i = tid()
    maximum = 0
    for j in elements_of(i, runs):
        d = float(raw[j]) / scale
        if d > farthest:
            d = 0.0
        depth[j] = d
        maximum = max(maximum, float_bits(d))  # bits of positive floats are ordered
    raise_int(largest, row_of(i, runs), maximum)


@kernel
def limit_depth_kernel(
    raw: array(dtype=float32),
    runs: Runs,
    scale: float,
    farthest: float,
    depth: array(dtype=float32),
    largest: array(dtype=int32),
):
    """Valid depth in meters of floats. 0 if it is 0, negative, not finite or too far."""
    i = tid()
    maximum = 0
    for j in elements_of(i, runs):
        d = raw[j] / scale
        meters = 0.0
        if d > 0.0 and d <= farthest and isfinite(d):
            meters = d
        depth[j] = meters
        maximum = max(maximum, float_bits(meters))
    raise_int(largest, row_of(i, runs), maximum)


@struct
class PixelGrid:
    """Every `stride`-th pixel of every `stride`-th row: `columns` x `rows`, `count`. Image `width` [px]."""

    stride: int
    columns: int
    width: int

    def __init__(self, width: int, height: int, stride: int) -> None:
        self.width, self.stride = width, stride
        self.columns, self.rows = -(-width // stride), -(-height // stride)
        self.count = self.rows * self.columns


@func
def grid_pixel(i: int, grid: PixelGrid) -> int:
    return (i // grid.columns) * grid.stride * grid.width + (i % grid.columns) * grid.stride


@func
def unproject_pixel(u: int, v: int, d: float, camera: Camera) -> vec3d:
    z = float64(d)
    return vec3d((float64(u) - camera.cx) * z / camera.fx, (float64(v) - camera.cy) * z / camera.fy, z)


@kernel
def unproject_depth_kernel(
    depth: array(dtype=float32),
    grid: PixelGrid,
    camera: Camera,
    T_world_camera: Transform,
    points: array(dtype=vec3),
    valid: array(dtype=uint8),
):
    """World points of a pixel grid, NaN without depth."""
    i = tid()
    u = (i % grid.columns) * grid.stride
    v = (i // grid.columns) * grid.stride
    d = depth[v * grid.width + u]
    p = vec3(NAN, NAN, NAN)
    good = 0
    if d > 0.0:
        p = narrow(transform_point(unproject_pixel(u, v, d, camera), T_world_camera))
        good = 1
    points[i] = p
    valid[i] = uint8(good)


@func
def meet_neighbors(u: int, v: int, depths: vec3, stride: int, camera: Camera) -> vec3d:
    """Unnormalized normal, toward the camera, of a pixel and its right and lower neighbors, of these depths."""
    p = unproject_pixel(u, v, depths[0], camera)
    along = unproject_pixel(u + stride, v, depths[1], camera) - p
    down = unproject_pixel(u, v + stride, depths[2], camera) - p
    return cross(down, along)


@kernel
def fit_pixel_normals_kernel(
    depth: array(dtype=float32),
    grid: PixelGrid,
    camera: Camera,
    R: mat33d,
    fill: float,
    normals: array(dtype=vec3),
    valid: array(dtype=uint8),
):
    """R times unit normals, toward the camera, from the right and lower neighbors; `fill` if one has no depth. A thread
    fits LANE_COUNT pixels of a row."""
    i = tid()
    groups = (grid.columns + LANE_COUNT - 1) // LANE_COUNT
    first = (i % groups) * LANE_COUNT
    row = i // groups
    v = row * grid.stride
    line = v * grid.width
    below = min(v + grid.stride, camera.height - 1) * grid.width
    x = octet(0.0)
    y = octet(0.0)
    z = octet(0.0)
    for lane in range(LANE_COUNT):
        u = min((first + lane) * grid.stride, camera.width - 1)
        right = min(u + grid.stride, camera.width - 1)
        depths = vec3(depth[line + u], depth[line + right], depth[below + u])
        m = meet_neighbors(u, v, depths, grid.stride, camera)
        size = dot(m, m)
        n = narrow(R @ (m / sqrt(size)))
        inside = u + grid.stride < camera.width and v + grid.stride < camera.height
        good = inside and size > 0.0 and min(min(depths[0], depths[1]), depths[2]) > 0.0
        x[lane] = n[0] if good else float(NAN)
        y[lane] = n[1] if good else float(NAN)
        z[lane] = n[2] if good else float(NAN)
    for lane in range(LANE_COUNT):
        if first + lane < grid.columns:
            at = row * grid.columns + first + lane
            n = vec3(x[lane], y[lane], z[lane])
            fitted = 1
            if not isfinite(n):
                n = vec3(fill, fill, fill)
                fitted = 0
            normals[at] = n
            valid[at] = uint8(fitted)


@kernel
def color_pixels_kernel(pixels: array(dtype=uint8, ndim=2), grid: PixelGrid, colors: array(dtype=vec3)):
    """Colors 0..1 of a pixel grid of an 8-bit image (pixels, 3)."""
    i = tid()
    j = grid_pixel(i, grid)
    colors[i] = vec3(float(pixels[j, 0]) / 255.0, float(pixels[j, 1]) / 255.0, float(pixels[j, 2]) / 255.0)


@kernel
def gray_pixels_kernel(intensity: array(dtype=float32), grid: PixelGrid, colors: array(dtype=vec3)):
    """Gray colors 0..1 of a pixel grid of a grayscale image."""
    i = tid()
    g = intensity[grid_pixel(i, grid)]
    colors[i] = vec3(g, g, g)


@kernel
def weigh_colors_kernel(pixels: array(dtype=uint8, ndim=2), intensity: array(dtype=float32)):
    i = tid()
    intensity[i] = (
        RED_WEIGHT * float(pixels[i, 0]) + GREEN_WEIGHT * float(pixels[i, 1]) + BLUE_WEIGHT * float(pixels[i, 2])
    ) / 255.0


def decode_depth(raw: Array1[uint16], layout: str) -> Array1[uint16]:
    """Millimeters, uint16, from the raw depths of a data set; `layout` is "sun" or "nyu"."""
    return compute({"sun": decode_sun_kernel, "nyu": decode_nyu_kernel}[layout], raw.size, [raw], uint16, raw.device)


def metric_depth(raw: Scalars | Array1[uint16], scale: float, farthest: float) -> tuple[Scalars, Integers]:
    """(depth [m] float32 (pixels), 0 for none; int32 bits of maxima) from uint16 or float32, divided by `scale`."""
    depth, largest = empty(raw.size, float32, raw.device), zeros(depth_runs(raw).rows, int32, raw.device)
    scale_depth(raw, scale, farthest, depth, largest)
    return depth, largest


def depth_runs(raw: Scalars | Array1[uint16]) -> Runs:
    """Runs of a depth image, with as many rows as `largest`."""
    return Runs(raw.size, raw.device, PIXELS_PER_RUN)


def scale_depth(
    raw: Scalars | Array1[uint16], scale: float, farthest: float, depth: Scalars, largest: Integers
) -> None:
    """As `metric_depth`, into existing arrays; `largest` starts at 0."""
    runs = depth_runs(raw)
    if raw.dtype == uint16:
        launch(scale_depth_kernel, runs.threads, [raw, runs, float(scale), float(farthest), depth, largest])
    else:
        launch(limit_depth_kernel, runs.threads, [raw, runs, float(scale), float(farthest), depth, largest])


def largest_depth(largest: Integers) -> float:
    """Maximum depth [m] of `metric_depth`, 0 for none. One sync."""
    return float(download(largest).max().view(np.float32))  # sync


def unproject_depth(
    depth: Scalars, grid: PixelGrid, camera: CameraLike, T_world_camera: np.ndarray
) -> tuple[Vectors, Bytes]:
    """(world points vec3 (grid.count), NaN without depth; valid uint8) of a pixel grid; `depth` in meters."""
    points, valid = empty(grid.count, vec3, depth.device), empty(grid.count, uint8, depth.device)
    launch(unproject_depth_kernel, grid.count, [depth, grid, camera, Transform(T_world_camera), points, valid])
    return points, valid


def pixel_normals(
    depth: Scalars, grid: PixelGrid, camera: CameraLike, R: np.ndarray, fill: float = NAN
) -> tuple[Vectors, Bytes]:
    """(normals vec3 (grid.count) toward the camera, `fill` for none; valid uint8), rotated by the float64 matrix R."""
    normals, valid = empty(grid.count, vec3, depth.device), empty(grid.count, uint8, depth.device)
    arguments = [depth, grid, camera, mat33d(*R.ravel()), float(fill), normals, valid]
    launch(fit_pixel_normals_kernel, grid.rows * -(-grid.columns // LANE_COUNT), arguments)
    return normals, valid


def color_pixels(pixels: Scalars | Array2[uint8], grid: PixelGrid) -> Vectors:
    """Colors 0..1, vec3 (grid.count), of an image uint8 (pixels, 3) or grayscale float32 (pixels)."""
    colors = empty(grid.count, vec3, pixels.device)
    pick = gray_pixels_kernel if pixels.dtype == float32 else color_pixels_kernel
    launch(pick, grid.count, [pixels, grid, colors])
    return colors


def intensity_of(pixels: AnyArray) -> Scalars:
    """Brightness 0..1, float32 (pixels), of a uint8 device image (pixels, 3)."""
    return compute(weigh_colors_kernel, pixels.shape[0], [pixels], float32, pixels.device)
