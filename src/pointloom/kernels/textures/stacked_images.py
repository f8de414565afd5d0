"""Posed images on the device: projection, brightness and gradient.

Brightness is BT.601 luma in 0..1, smoothed by (1, 2, 1) / 4. Gradients are Sobel / 8 [1 / px] (Open3D omits the 8, so
its Gauss-Newton steps are too short). Both are bilinear. An optional warp shifts (u, v) bilinearly between grid anchors
(Zhou and Koltun 2014, "Color map optimization for 3D reconstruction with consumer depth cameras", section 4.3).
"""

import numpy as np

from ..array_types import Array2, Device, Scalars
from ..images.depth import BLUE_WEIGHT, GREEN_WEIGHT, RED_WEIGHT
from ..lang import (
    array,
    float32,
    float64,
    floor,
    func,
    isfinite,
    kernel,
    launch,
    mat44d,
    struct,
    tid,
    uint8,
    vec2d,
    vec3,
    vec3d,
    vec3i,
    vec4d,
    vector,
)
from ..memory import empty, upload, zeros

LANE_COUNT = 8  # pixels of a thread, which a CPU smooths at once
octet = vector(8, float32)
padded_octet = vector(10, float32)  # with the pixels on both sides
LARGEST_PIXEL = 1.0e9  # limit of image coordinates, which fits into int32
pixel = vector(3, float64)  # column, row and depth [m]
shade = vector(3, float64)  # brightness, and its gradient along row and column [1 / px]
warp_sample = vector(6, float64)  # shift along u and v, then its derivatives: du/du, dv/du, du/dv, dv/dv


@struct
class StackedImages:
    """Concatenated images. `sizes`: width, height, first pixel; `lenses`: fx, fy, cx, cy [px]; `poses` T_camera_world
    about the mesh origin; `margin` [px], ignored border.
    """

    sizes: array(dtype=vec3i)
    lenses: array(dtype=vec4d)
    poses: array(dtype=mat44d)
    pixels: array(dtype=uint8, ndim=2)
    brightness: array(dtype=float32)
    margin: float64

    def __init__(
        self,
        sizes: np.ndarray,
        lenses: np.ndarray,
        poses: np.ndarray,
        pixels: Array2[uint8],
        brightness: Scalars,
        margin: float,
    ) -> None:
        device = pixels.device
        self.sizes, self.lenses = upload(sizes, vec3i, device), upload(lenses, vec4d, device)
        self.poses = upload(poses, mat44d, device)
        self.pixels, self.brightness, self.margin = pixels, brightness, float(margin)
        self.count, self.device, self.layout = len(poses), device, sizes


@struct
class Warps:
    """Warp grids of images: `grids`: columns, rows, first anchor, column-major; `steps`, `shifts` in u, v [px]."""

    grids: array(dtype=vec3i)
    steps: array(dtype=float64)
    shifts: array(dtype=vec2d)

    def __init__(self, sizes: np.ndarray, rows: int, device: Device) -> None:
        sizes = np.asarray(sizes)
        steps = sizes[:, 1] / max(rows - 1, 1)
        columns = np.where(rows > 0, np.ceil(sizes[:, 0] / steps) + 1, 0).astype(np.int64)
        firsts = np.concatenate([[0], np.cumsum(columns * rows)])
        self.layout = np.column_stack([columns, np.full(len(sizes), rows), firsts[:-1]])
        self.grids, self.steps = upload(self.layout, vec3i, device), upload(steps, float64, device)
        self.count, self.rows = int(firsts[-1]), rows
        self.shifts = zeros(max(self.count, 1), vec2d, device)


@kernel
def smooth_brightness_kernel(
    pixels: array(dtype=uint8, ndim=2), first: int, width: int, height: int, brightness: array(dtype=float32)
):
    """Smoothed brightness of one image. The border is replicated. A thread smooths LANE_COUNT pixels of a row."""
    i = tid()
    groups = (width + LANE_COUNT - 1) // LANE_COUNT
    u = (i % groups) * LANE_COUNT
    v = i // groups
    total = octet(0.0)
    luma = padded_octet(0.0)
    for a in range(3):
        row = first + min(max(v + a - 1, 0), height - 1) * width
        for b in range(LANE_COUNT + 2):
            at = row + min(max(u + b - 1, 0), width - 1)
            luma[b] = (
                RED_WEIGHT * float(pixels[at, 0])
                + GREEN_WEIGHT * float(pixels[at, 1])
                + BLUE_WEIGHT * float(pixels[at, 2])
            )
        for lane in range(LANE_COUNT):
            line = luma[lane] + 2.0 * luma[lane + 1] + luma[lane + 2]
            total[lane] += line * float(2 - abs(a - 1))
    for lane in range(LANE_COUNT):
        if u + lane < width:
            brightness[first + v * width + u + lane] = total[lane] / 4080.0  # 16 weights times 255


@func
def camera_position(p: vec3, image: int, stack: StackedImages) -> vec3d:
    T = stack.poses[image]
    return vec3d(
        T[0, 0] * float64(p[0]) + T[0, 1] * float64(p[1]) + T[0, 2] * float64(p[2]) + T[0, 3],
        T[1, 0] * float64(p[0]) + T[1, 1] * float64(p[1]) + T[1, 2] * float64(p[2]) + T[1, 3],
        T[2, 0] * float64(p[0]) + T[2, 1] * float64(p[1]) + T[2, 2] * float64(p[2]) + T[2, 3],
    )


@func
def project_vertex(p: vec3, image: int, stack: StackedImages) -> pixel:
    """Column, row and depth of a point. Depth -1 behind the camera, or NaN."""
    q = camera_position(p, image, stack)
    lens = stack.lenses[image]
    projected = pixel(0.0, 0.0, -1.0)
    if isfinite(p) and q[2] > 0.0:
        u = lens[0] * q[0] / q[2] + lens[2]
        v = lens[1] * q[1] / q[2] + lens[3]
        if abs(u) < float64(LARGEST_PIXEL) and abs(v) < float64(LARGEST_PIXEL):
            projected = pixel(u, v, q[2])
    return projected


@func
def camera_center(image: int, stack: StackedImages) -> vec3d:
    T = stack.poses[image]
    return vec3d(
        -(T[0, 0] * T[0, 3] + T[1, 0] * T[1, 3] + T[2, 0] * T[2, 3]),
        -(T[0, 1] * T[0, 3] + T[1, 1] * T[1, 3] + T[2, 1] * T[2, 3]),
        -(T[0, 2] * T[0, 3] + T[1, 2] * T[1, 3] + T[2, 2] * T[2, 3]),
    )


@func
def is_inside(u: float64, v: float64, image: int, margin: float64, stack: StackedImages) -> int:
    size = stack.sizes[image]
    inside = 0
    if u >= margin and v >= margin and u < float64(size[0]) - margin and v < float64(size[1]) - margin:
        inside = 1
    return inside


@func
def nearest_pixel(u: float64, v: float64, image: int, stack: StackedImages) -> int:
    """Index of the nearest pixel, in the array of all pixels."""
    size = stack.sizes[image]
    column = min(int(floor(u + 0.5)), size[0] - 1)
    row = min(int(floor(v + 0.5)), size[1] - 1)
    return size[2] + row * size[0] + column


@func
def count_of_tap(k: int, t: float64) -> shade:
    """Weights of the k-th of four pixels at fraction t: bilinear, central difference, and smoothed by (1, 2, 1) / 4."""
    quarter = float64(0.25)
    half = float64(0.5)
    mean = float64(0.0)
    slope = (t - 1.0) * half
    smooth = (1.0 - t) * quarter
    if k == 1:
        mean = 1.0 - t
        slope = -t * half
        smooth = half - t * quarter
    if k == 2:
        mean = t
        slope = (1.0 - t) * half
        smooth = (1.0 + t) * quarter
    if k == 3:
        slope = t * half
        smooth = t * quarter
    return shade(mean, slope, smooth)


@func
def shade_at(u: float64, v: float64, image: int, stack: StackedImages) -> shade:
    """Brightness and its gradient inside an image."""
    size = stack.sizes[image]
    left = int(floor(u))
    top = int(floor(v))
    s = u - float64(left)
    t = v - float64(top)
    total = shade(0.0)
    n = int(4)
    for a in range(n):
        row = min(max(top + a - 1, 0), size[1] - 1)
        of_row = count_of_tap(a, t)
        line = shade(0.0)
        for b in range(n):
            column = min(max(left + b - 1, 0), size[0] - 1)
            value = float64(stack.brightness[size[2] + row * size[0] + column])
            line += count_of_tap(b, s) * value
        total += shade(line[0] * of_row[0], line[1] * of_row[2], line[2] * of_row[1])
    return total


@func
def warp_at(u: float64, v: float64, image: int, warps: Warps) -> warp_sample:
    """Warp shift and its derivatives. Zero without a warp."""
    grid = warps.grids[image]
    result = warp_sample(0.0)
    if grid[1] > 0:
        step = warps.steps[image]
        i = min(max(int(floor(u / step)), 0), grid[0] - 2)
        j = min(max(int(floor(v / step)), 0), grid[1] - 2)
        p = u / step - float64(i)
        q = v / step - float64(j)
        first = grid[2] + i * grid[1] + j
        a = warps.shifts[first]
        b = warps.shifts[first + 1]
        c = warps.shifts[first + grid[1]]
        d = warps.shifts[first + grid[1] + 1]
        one = float64(1.0)
        shift = (a * (one - q) + b * q) * (one - p) + (c * (one - q) + d * q) * p
        along_u = ((c - a) * (one - q) + (d - b) * q) / step
        along_v = ((b - a) * (one - p) + (d - c) * p) / step
        result = warp_sample(shift[0], shift[1], along_u[0], along_u[1], along_v[0], along_v[1])
    return result


@func
def find_vertex(p: vec3, image: int, stack: StackedImages, warps: Warps) -> pixel:
    """Warped image position of a point. Depth -1 if it is not visible."""
    projected = project_vertex(p, image, stack)
    if projected[2] > 0.0:
        warp = warp_at(projected[0], projected[1], image, warps)
        u = projected[0] + warp[0]
        v = projected[1] + warp[1]
        inside = is_inside(projected[0], projected[1], image, stack.margin, stack)
        inside += is_inside(u, v, image, stack.margin, stack)
        if inside == 2:
            projected = pixel(u, v, projected[2])
        else:
            projected = pixel(0.0, 0.0, -1.0)
    return projected


@func
def color_at(u: float64, v: float64, image: int, stack: StackedImages) -> vec3d:
    size = stack.sizes[image]
    left = int(floor(u))
    top = int(floor(v))
    right = min(left + 1, size[0] - 1)
    bottom = min(top + 1, size[1] - 1)
    s = u - float64(left)
    t = v - float64(top)
    one = float64(1.0)
    color = vec3d(0.0, 0.0, 0.0)
    n = int(3)
    for channel in range(n):
        a = float64(int(stack.pixels[size[2] + top * size[0] + left, channel]))
        b = float64(int(stack.pixels[size[2] + top * size[0] + right, channel]))
        c = float64(int(stack.pixels[size[2] + bottom * size[0] + left, channel]))
        d = float64(int(stack.pixels[size[2] + bottom * size[0] + right, channel]))
        color[channel] = (a * (one - s) + b * s) * (one - t) + (c * (one - s) + d * s) * t
    return color


@kernel
def unwarp_pixels_kernel(image: int, stack: StackedImages, warps: Warps, out: array(dtype=uint8, ndim=2)):
    i = tid()
    size = stack.sizes[image]
    position = vec2d(float64(i % size[0]), float64(i // size[0]))
    warp = warp_at(position[0], position[1], image, warps)
    u = position[0] + warp[0]
    v = position[1] + warp[1]
    color = vec3d(0.0, 0.0, 0.0)
    if is_inside(u, v, image, 0.0, stack) == 1:
        color = color_at(u, v, image, stack)
    n = int(3)
    for channel in range(n):
        out[i, channel] = uint8(int(floor(color[channel] + 0.5)))


def smooth_brightness(pixels: Array2[uint8], sizes: np.ndarray) -> Scalars:
    """Smoothed brightness of concatenated images, float32 (pixels)."""
    brightness = empty(pixels.shape[0], float32, pixels.device)
    for width, height, first in np.asarray(sizes).tolist():
        launch(smooth_brightness_kernel, -(-width // LANE_COUNT) * height, [pixels, first, width, height, brightness])
    return brightness


def unwarp_pixels(image: int, stack: StackedImages, warps: Warps) -> Array2[uint8]:
    """Unwarped image, uint8 (pixels, 3)."""
    width, height = stack.layout[image][:2]
    out = empty((int(width) * int(height), 3), uint8, stack.device)
    launch(unwarp_pixels_kernel, out.shape[0], [int(image), stack, warps, out])
    return out
