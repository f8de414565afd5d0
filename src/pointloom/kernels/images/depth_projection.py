"""Points projected to a depth image with colors. The nearest point wins by an atomic minimum of depth bits above the
index, independent of thread order. Float64, so a pixel's own point projects back to it.
"""

import numpy as np

from ..algebra.camera import Camera, CameraLike
from ..algebra.transform import Transform, transform_point, widen
from ..array_types import Array2, LongIntegers, Points, Scalars, Vectors
from ..arrays.packed_keys import NO_KEY, key_index, key_number, offer_cell
from ..lang import array, compute, float32, float64, floor, func, int64, isfinite, kernel, launch, tid, uint8, vec3
from ..memory import empty, full


@kernel
def project_points_kernel(
    points: array(dtype=vec3), T_camera_points: Transform, camera: Camera, farthest: float, words: array(dtype=int64)
):
    i = tid()
    p = points[i]
    if isfinite(p):
        q = transform_point(widen(p), T_camera_points)
        z = float(q[2])
        if z > 0.0 and z <= farthest:
            u = floor(camera.fx * q[0] / q[2] + camera.cx + 0.5)
            v = floor(camera.fy * q[1] / q[2] + camera.cy + 0.5)
            if u >= 0.0 and v >= 0.0 and u < float64(camera.width) and v < float64(camera.height):
                offer_cell(int(v) * camera.width + int(u), z, i, words)


@kernel
def read_depth_kernel(words: array(dtype=int64), scale: float64, depth: array(dtype=float32)):
    """Depth of each pixel times the scale. 0 if empty."""
    i = tid()
    word = words[i]
    d = 0.0
    if word < int64(NO_KEY):
        d = float(float64(key_number(word)) * scale)
    depth[i] = d


@func
def to_byte(value: float) -> int:
    """0..1 to 0..255, rounded and clamped."""
    return int(floor(min(max(value, 0.0), 1.0) * 255.0 + 0.5))


@kernel
def read_colors_kernel(words: array(dtype=int64), colors: array(dtype=vec3), pixels: array(dtype=uint8, ndim=2)):
    i = tid()
    word = words[i]
    c = vec3(0.0, 0.0, 0.0)
    if word < int64(NO_KEY):
        c = colors[key_index(word)]
    for channel in range(3):
        pixels[i, channel] = uint8(to_byte(c[channel]))


def project_points(points: Points, T_camera_points: np.ndarray, camera: CameraLike, farthest: float) -> LongIntegers:
    """Projected words for `read_depth` and `read_colors`. `T_camera_points` float64 (4, 4); `farthest` depth [m]."""
    words = full(camera.width * camera.height, NO_KEY, int64, points.device)
    arguments = [points, Transform(T_camera_points), camera, float(farthest), words]
    launch(project_points_kernel, points.size, arguments)
    return words


def read_depth(words: LongIntegers, scale: float = 1.0) -> Scalars:
    """Depth [m] times `scale`, float32 (pixels). 0 if empty."""
    return compute(read_depth_kernel, words.size, [words, float(scale)], float32, words.device)


def read_colors(words: LongIntegers, colors: Vectors) -> Array2[uint8]:
    pixels = empty((words.size, 3), uint8, words.device)
    launch(read_colors_kernel, words.size, [words, colors, pixels])
    return pixels
