"""Depth images: to metres, and to points.

One thread a pixel; reads 2 or 4 B, writes 4 or 12 B. Pinhole model: x = (u - cx) z / fx, pixel centres at integers.
"""

import math

import numpy as np

from .lang import (
    array,
    atomic_max,
    float32,
    float64,
    float_bits,
    int32,
    isfinite,
    kernel,
    launch,
    mat33d,
    tid,
    uint8,
    uint16,
    vec3,
    vec3d,
    vec4d,
)
from .memory import empty, zeros
from .transform import narrow

NAN = math.nan
RUN = 1024  # pixels a thread of a reduction by atomics


@kernel
def scale_depth_kernel(
    raw: array(dtype=uint16),
    run: int,
    scale: float,
    farthest: float,
    depth: array(dtype=float32),
    largest: array(dtype=int32),
):
    """Raw integers to metres, 0 beyond the farthest depth, a run of pixels a thread; and the largest, as its bits."""
    i = tid()
    most = int(0)
    for j in range(i * run, min((i + 1) * run, raw.shape[0])):
        d = float(raw[j]) / scale
        if d > farthest:
            d = 0.0
        depth[j] = d
        most = max(most, float_bits(d))  # positive floats are in the order of their bits
    if most > 0:
        atomic_max(largest, 0, most)  # settles which run's largest is the largest


@kernel
def limit_depth_kernel(
    raw: array(dtype=float32), run: int, farthest: float, depth: array(dtype=float32), largest: array(dtype=int32)
):
    """Depth in metres; 0 where there is no measurement (0, negative, NaN, infinite) or it is beyond the farthest."""
    i = tid()
    most = int(0)
    for j in range(i * run, min((i + 1) * run, raw.shape[0])):
        d = raw[j]
        metres = float(0.0)
        if d > 0.0 and d <= farthest and isfinite(d):
            metres = d
        depth[j] = metres
        most = max(most, float_bits(metres))
    if most > 0:
        atomic_max(largest, 0, most)  # settles which run's largest is the largest


@kernel
def unproject_depth_kernel(
    depth: array(dtype=float32),
    width: int,
    columns: int,
    stride: int,
    camera: vec4d,
    R: mat33d,
    t: vec3d,
    points: array(dtype=vec3),
    valid: array(dtype=uint8),
):
    """The world point R (x, y, z) + t of every stride-th pixel, NaN where there is no depth. camera: fx fy cx cy."""
    i = tid()
    u = (i % columns) * stride
    v = (i // columns) * stride
    d = depth[v * width + u]
    p = vec3(NAN, NAN, NAN)
    good = int(0)
    if d > 0.0:
        z = float64(d)
        x = (float64(u) - camera[2]) * z / camera[0]
        y = (float64(v) - camera[3]) * z / camera[1]
        p = narrow(R @ vec3d(x, y, z) + t)
        good = 1
    points[i] = p
    valid[i] = uint8(good)


@kernel
def color_pixels_kernel(
    pixels: array(dtype=uint8, ndim=2), width: int, columns: int, stride: int, colors: array(dtype=vec3)
):
    """Colours 0..1 of every stride-th pixel of an 8-bit image of shape [pixels, 3]."""
    i = tid()
    j = (i // columns) * stride * width + (i % columns) * stride
    colors[i] = vec3(float(pixels[j, 0]) / 255.0, float(pixels[j, 1]) / 255.0, float(pixels[j, 2]) / 255.0)


def metric_depth(raw, scale, farthest):
    """Depth in metres from a uint16 (divided by `scale`) or float32 (metres) device array.

    Returns:
        (depth, largest): float32 [pixels], 0 without measurement, and int32 [1], the bits of the largest depth.
    """
    depth, largest = empty(raw.size, float32, raw.device), zeros(1, int32, raw.device)
    runs = -(-raw.size // RUN)
    if raw.dtype == uint16:
        launch(scale_depth_kernel, runs, [raw, RUN, float(scale), float(farthest), depth, largest])
    else:
        launch(limit_depth_kernel, runs, [raw, RUN, float(farthest), depth, largest])
    return depth, largest


def largest_depth(largest):
    """The largest depth [m] that `metric_depth` found, 0 for none; one sync."""
    return float(largest.numpy().view(np.float32)[0])  # sync


def unproject_depth(depth, width, height, stride, camera, T_world_camera):
    """World points of every stride-th pixel, row by row.

    Args:
        depth: float32 device array [height * width] in metres.
        camera: (fx, fy, cx, cy).
        T_world_camera: float64 [4, 4].

    Returns:
        (points, valid, rows, columns): vec3 [rows * columns], NaN without depth, and uint8 of the same length.
    """
    columns, rows = -(-width // stride), -(-height // stride)
    points, valid = empty(rows * columns, vec3, depth.device), empty(rows * columns, uint8, depth.device)
    R, t = mat33d(*T_world_camera[:3, :3].ravel()), vec3d(*T_world_camera[:3, 3])
    arguments = [depth, width, columns, stride, vec4d(*camera), R, t, points, valid]
    launch(unproject_depth_kernel, rows * columns, arguments)
    return points, valid, rows, columns


def color_pixels(pixels, width, rows, columns, stride):
    """Colours 0..1, vec3 [rows * columns], of every stride-th pixel of a uint8 device image [pixels, 3]."""
    colors = empty(rows * columns, vec3, pixels.device)
    launch(color_pixels_kernel, rows * columns, [pixels, width, columns, stride, colors])
    return colors
