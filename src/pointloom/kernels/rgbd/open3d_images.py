"""Image preparation of Open3D 0.20's odometry, for conformance. NaN is missing depth, and spreads."""

import numpy as np

from ..array_types import Scalars, Vectors
from ..lang import (
    NAN,
    array,
    compute,
    cross,
    dot,
    float32,
    float64,
    floor,
    func,
    isfinite,
    kernel,
    launch,
    sqrt,
    tid,
    vec3,
    vec4,
)
from ..memory import empty

SHORT_NORMAL = 1.0e-5  # [m^2] minimum divisor in Open3D


@kernel
def mark_missing_kernel(depth: array(dtype=float32), min_depth: float, max_depth: float, marked: array(dtype=float32)):
    i = tid()
    d = depth[i]
    value = float(NAN)
    if d > 0.0 and d >= min_depth and d <= max_depth:
        value = d
    marked[i] = value


@func
def mean_of_three(a: float, b: float, c: float) -> float:
    """(1, 2, 1) / 4 mean, rounded once, as in Open3D's filters."""
    quarter = float64(0.25)
    return float(quarter * float64(a) + 0.5 * float64(b) + quarter * float64(c))


@kernel
def smooth_kernel(image: array(dtype=float32), width: int, height: int, smoothed: array(dtype=float32)):
    """Open3D's Gaussian3: (1, 2, 1) / 4 along both axes; replicated border."""
    i = tid()
    u = i % width
    v = i // width
    left = max(u - 1, 0) - u
    right = min(u + 1, width - 1) - u
    up = (max(v - 1, 0) - v) * width
    down = (min(v + 1, height - 1) - v) * width
    above = mean_of_three(image[i + up + left], image[i + up], image[i + up + right])
    middle = mean_of_three(image[i + left], image[i], image[i + right])
    below = mean_of_three(image[i + down + left], image[i + down], image[i + down + right])
    smoothed[i] = mean_of_three(above, middle, below)


@kernel
def slope_kernel(
    image: array(dtype=float32), width: int, height: int, along: array(dtype=float32), down: array(dtype=float32)
):
    """Sobel gradients, 8 times too large; replicated border."""
    i = tid()
    u = i % width
    v = i // width
    left = max(u - 1, 0) - u
    right = min(u + 1, width - 1) - u
    up = (max(v - 1, 0) - v) * width
    low = (min(v + 1, height - 1) - v) * width
    a = image[i + up + left]
    b = image[i + up]
    c = image[i + up + right]
    d = image[i + left]
    f = image[i + right]
    g = image[i + low + left]
    h = image[i + low]
    k = image[i + low + right]
    # the center has weight zero, but NaN times zero is NaN: a hole there is a hole
    along[i] = 4.0 * mean_of_three(c - a + (b - b), f - d, k - g + (h - h))
    above = 4.0 * mean_of_three(a, b, c)
    down[i] = 4.0 * mean_of_three(g, h, k) - above + (d - d) + (f - f)


@kernel
def spread_holes_kernel(
    depth: array(dtype=float32), smoothed: array(dtype=float32), width: int, height: int, spread: array(dtype=float32)
):
    """Smoothed depth without pixels within 2 px of a hole, as in Open3D's bilateral filter with NaN."""
    i = tid()
    u = i % width
    v = i // width
    value = smoothed[i]
    n = int(2)
    for dv in range(-n, n + 1):
        for du in range(-n, n + 1):
            if du * du + dv * dv <= n * n:
                at = min(max(v + dv, 0), height - 1) * width + min(max(u + du, 0), width - 1)
                if not isfinite(depth[at]):
                    value = NAN
    spread[i] = value


@kernel
def halve_kernel(image: array(dtype=float32), width: int, columns: int, halved: array(dtype=float32)):
    i = tid()
    at = 2 * (i // columns) * width + 2 * (i % columns)
    halved[i] = (image[at] + image[at + 1] + image[at + width] + image[at + width + 1]) / 4.0


@kernel
def scale_kernel(image: array(dtype=float32), factor: float, scaled: array(dtype=float32)):
    i = tid()
    scaled[i] = image[i] * factor


@kernel
def fill_missing_kernel(depth: array(dtype=float32), filled: array(dtype=float32)):
    i = tid()
    d = depth[i]
    value = 0.0
    if d > 0.0:
        value = d
    filled[i] = value


@kernel
def round_shades_kernel(brightness: array(dtype=float32), rounded: array(dtype=float32)):
    i = tid()
    rounded[i] = floor(brightness[i] * 255.0 + 0.5) / 255.0


@func
def vertex_at(u: int, v: int, at: int, lens: vec4, depth: array(dtype=float32)) -> vec3:
    z = depth[at]
    return vec3((float(u) - lens[2]) * z / lens[0], (float(v) - lens[3]) * z / lens[1], z)


@kernel
def fit_short_normals_kernel(
    depth: array(dtype=float32), width: int, height: int, lens: vec4, normals: array(dtype=vec3)
):
    """Normals from the next pixels, divided by at least SHORT_NORMAL, so near ones are short."""
    i = tid()
    u = i % width
    v = i // width
    normal = vec3(NAN, NAN, NAN)
    if u < width - 1 and v < height - 1:
        p = vertex_at(u, v, i, lens, depth)
        along = vertex_at(u + 1, v, i + 1, lens, depth) - p
        down = vertex_at(u, v + 1, i + width, lens, depth) - p
        n = cross(down, along)
        normal = n / max(sqrt(dot(n, n)), SHORT_NORMAL)
        if not (isfinite(p[2]) and isfinite(n[0])):
            normal = vec3(NAN, NAN, NAN)
    normals[i] = normal


def fill_missing(depth: Scalars) -> Scalars:
    """Depth with 0 for NaN."""
    return compute(fill_missing_kernel, depth.size, [depth], float32, depth.device)


def round_shades(brightness: Scalars) -> Scalars:
    """Brightness in steps of 1 / 255, as in 8-bit images."""
    return compute(round_shades_kernel, brightness.size, [brightness], float32, brightness.device)


def short_normals(depth: Scalars, width: int, height: int, lens: np.ndarray) -> Vectors:
    """Open3D's normals of a depth image with NaN for none."""
    normals = empty(depth.size, vec3, depth.device)
    launch(fit_short_normals_kernel, depth.size, [depth, width, height, vec4(*map(float, lens)), normals])
    return normals


def mark_missing(depth: Scalars, min_depth: float, max_depth: float) -> Scalars:
    """Depth with NaN for none or out of range."""
    return compute(mark_missing_kernel, depth.size, [depth, float(min_depth), float(max_depth)], float32, depth.device)


def smooth(image: Scalars, width: int, height: int) -> Scalars:
    return compute(smooth_kernel, image.size, [image, width, height], float32, image.device)


def slopes(image: Scalars, width: int, height: int) -> tuple[Scalars, Scalars]:
    along, down = empty(image.size, float32, image.device), empty(image.size, float32, image.device)
    launch(slope_kernel, image.size, [image, width, height, along, down])
    return along, down


def spread_holes(depth: Scalars, smoothed: Scalars, width: int, height: int) -> Scalars:
    """Smoothed depth without pixels within 2 px of a hole."""
    return compute(spread_holes_kernel, depth.size, [depth, smoothed, width, height], float32, depth.device)


def halve(image: Scalars, width: int, height: int) -> Scalars:
    columns, rows = width // 2, height // 2
    return compute(halve_kernel, columns * rows, [image, width, columns], float32, image.device)


def scale(image: Scalars, factor: float) -> Scalars:
    return compute(scale_kernel, image.size, [image, float(factor)], float32, image.device)
