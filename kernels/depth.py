"""Depth images: to metres, and to points.

One thread a pixel; reads 2 or 4 B, writes 4 or 12 B. Pinhole model: x = (u - cx) z / fx, pixel centres at integers.
"""

import math

from .lang import array, atomic_max, float32, float64, kernel, launch, mat33d, tid, uint8, uint16, vec3, vec3d, vec4d
from .memory import empty, zeros
from .transform import narrow

NAN = math.nan
RUN = 1024  # pixels a thread of a reduction by atomics


@kernel
def scale_depth_kernel(raw: array(dtype=uint16), scale: float, farthest: float, depth: array(dtype=float32)):
    """Raw integers to metres; 0 beyond the farthest depth."""
    i = tid()
    d = float(raw[i]) / scale
    if d > farthest:
        d = 0.0
    depth[i] = d


@kernel
def limit_depth_kernel(raw: array(dtype=float32), farthest: float, depth: array(dtype=float32)):
    """Depth in metres; 0 where there is no measurement (0, negative, NaN, infinite) or it is beyond the farthest."""
    i = tid()
    d = raw[i]
    good = int(0)
    if d > 0.0 and d <= farthest:
        good = 1
    if good == 0:
        d = 0.0
    depth[i] = d


@kernel
def find_largest_kernel(depth: array(dtype=float32), run: int, largest: array(dtype=float32)):
    """The largest depth, by one atomic a run."""
    i = tid()
    most = float(0.0)
    for j in range(i * run, min((i + 1) * run, depth.shape[0])):
        most = max(most, depth[j])
    if most > 0.0:
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


def largest_depth(depth):
    """The largest depth of a float32 device array [m], 0 for none; one sync."""
    largest = zeros(1, float32, depth.device)
    launch(find_largest_kernel, -(-depth.size // RUN), [depth, RUN, largest])
    return float(largest.numpy()[0])  # sync


def metric_depth(raw, scale, farthest):
    """Depth in metres, float32 [pixels], from a uint16 (divided by `scale`) or float32 (metres) device array."""
    depth = empty(raw.size, float32, raw.device)
    if raw.dtype == uint16:
        launch(scale_depth_kernel, raw.size, [raw, float(scale), float(farthest), depth])
    else:
        launch(limit_depth_kernel, raw.size, [raw, float(farthest), depth])
    return depth


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
