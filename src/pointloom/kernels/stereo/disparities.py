"""Disparities of two rectified images from sums of path costs, and their depth in the original images.

The least sum wins. A pixel has no disparity if another one, not adjacent, costs almost the same, if the least sum is at
the end of the range, or if the best disparity of the corresponding pixel in the other image differs by more than one
(Hirschmueller 2008, sections 2.3 and 2.4). A parabola through three sums refines it. Cost: 4 B read per pixel and
disparity. Depth, normals: a plane fitted to the 24 pixels around that continue the surface, 100 B read per pixel.
"""

import numpy as np

from ..array_types import Array1, Scalars, Vectors
from ..arrays.lanes import min_int_of_lanes
from ..lang import (
    WARP,
    array,
    float32,
    floor,
    func,
    int32,
    kernel,
    lane,
    launch,
    mat33,
    struct,
    sync_lanes,
    tid,
    uint16,
    vec3,
    vec4,
    vector,
)
from ..memory import empty, full
from .census import LANE_COUNT, lanes
from .inverse_planes import normal_of

MAX_SUM_PERCENT = 90  # percent of another sum that the least one must not exceed
MAX_SUM = 1 << 30
SUM_KEY_FACTOR = 1 << 16  # of a sum above its disparity
MAX_DIFFERENCE = 1  # of the disparities of both images
NO_DISPARITY = -1.0e3  # farther from any other than a step
PLANE_RADIUS = 2  # [px] half the window of a plane
MAX_STEP = 1.0  # [px] between neighbors on one surface
MIN_SUPPORT = 13  # of the 25 pixels of a window
numbers = vector(LANE_COUNT, float32)
ONE_SOURCE_TRUST = 0.5  # n / (n + 1) of n = 1 source that agrees, as in `plane_results`


@func
def row_stride(width: int) -> int:
    """Elements per row of disparities with a border for the windows of planes."""
    return width + 2 * PLANE_RADIUS + LANE_COUNT


@func
def refined(before: int, least: int, after: int) -> float:
    """Offset of the minimum of a parabola through three sums, -0.5 to 0.5."""
    curvature = before + after - 2 * least
    offset = 0.0
    if curvature > 0:
        offset = 0.5 * float(before - after) / float(curvature)
    return offset


@func
def keep_winner(
    cell: int,
    count: int,
    key: int,
    other: int,
    best: array(dtype=int32),
    left_margin: array(dtype=float32),
    right_margin: array(dtype=float32),
):
    """Store the disparity of a pixel from its least sum and the least one that is not adjacent, -1 if ambiguous."""
    winner = key % SUM_KEY_FACTOR
    least_sum = key // SUM_KEY_FACTOR
    if winner == 0 or winner == count - 1 or least_sum * 100 >= other * MAX_SUM_PERCENT:
        winner = -1
    best[cell] = winner
    right_margin[cell] = 0.0
    left_margin[cell] = 1.0 - float(least_sum) / float(max(other, 1))


@func
def compare_images(
    x: int,
    y: int,
    sums: array(dtype=uint16),
    width: int,
    count: int,
    first: int,
    best: array(dtype=int32),
    best_right: array(dtype=int32),
    left: array(dtype=float32),
    right: array(dtype=float32),
    left_margin: array(dtype=float32),
    right_margin: array(dtype=float32),
):
    """Refine the disparities of pixel x of a row in both images where those of the corresponding pixels agree."""
    length = width + count
    padded = (y + PLANE_RADIUS) * row_stride(width) + PLANE_RADIUS
    d = best[y * width + x]
    if d > 0:
        corresponding = best_right[y * length + width - 1 - x + d] % SUM_KEY_FACTOR
        if abs(corresponding - d) <= MAX_DIFFERENCE:
            cell = (y * width + x) * count + d
            left[padded + x] = float(d) + refined(int(sums[cell - 1]), int(sums[cell]), int(sums[cell + 1]))
    reverse = width - 1 - first - x  # column of pixel x of the right image
    if reverse >= 0 and reverse < length:
        d = best_right[y * length + reverse] % SUM_KEY_FACTOR
        u = width - 1 - reverse + d
        if d > 0 and d < count - 1 and u > 0 and u < width - 1:
            if best[y * width + u] > 0 and abs(best[y * width + u] - d) <= MAX_DIFFERENCE:
                cell = (y * width + u) * count + d
                before = int(sums[cell - count - 1])
                after = int(sums[cell + count + 1])
                right[padded + x] = float(d) + refined(before, int(sums[cell]), after)
                right_margin[y * width + x] = left_margin[y * width + u]


@kernel
def find_disparities_kernel(
    sums: array(dtype=uint16),
    width: int,
    count: int,
    first: int,
    best: array(dtype=int32),
    best_right: array(dtype=int32),
    left: array(dtype=float32),
    right: array(dtype=float32),
    left_margin: array(dtype=float32),
    right_margin: array(dtype=float32),
):
    """Disparities of a row of both images, from `first` on, and their margins, 1 - least sum / next one."""
    y = tid()
    length = width + count
    for x in range(width):
        cell = (y * width + x) * count
        opposite = y * length + width - 1 - x
        least = lanes(MAX_SUM)
        for chunk in range(count // LANE_COUNT):
            d = chunk * LANE_COUNT
            keys = lanes(0)
            others = lanes(0)
            for k in range(LANE_COUNT):
                keys[k] = int(sums[cell + d + k]) * SUM_KEY_FACTOR + d + k
                others[k] = min(best_right[opposite + d + k], keys[k])
                least[k] = min(least[k], keys[k])
            for k in range(LANE_COUNT):
                best_right[opposite + d + k] = others[k]
        key = int(MAX_SUM)
        for k in range(LANE_COUNT):
            key = min(key, least[k])
        winner = key % SUM_KEY_FACTOR
        second = lanes(MAX_SUM)
        for chunk in range(count // LANE_COUNT):
            d = chunk * LANE_COUNT
            for k in range(LANE_COUNT):
                apart = abs(d + k - winner)
                value = int(sums[cell + d + k])
                if apart < 2:
                    value = MAX_SUM
                second[k] = min(second[k], value)
        other = int(MAX_SUM)
        for k in range(LANE_COUNT):
            other = min(other, second[k])
        keep_winner(y * width + x, count, key, other, best, left_margin, right_margin)
    for x in range(width):
        compare_images(x, y, sums, width, count, first, best, best_right, left, right, left_margin, right_margin)


@find_disparities_kernel.on_cuda
def find_disparities_in_lanes_kernel(
    sums: array(dtype=uint16),
    width: int,
    count: int,
    first: int,
    best: array(dtype=int32),
    best_right: array(dtype=int32),
    left: array(dtype=float32),
    right: array(dtype=float32),
    left_margin: array(dtype=float32),
    right_margin: array(dtype=float32),
):
    """CUDA variant: a warp per row, whose lanes have the disparities of a pixel, then the pixels of the row."""
    i = tid()
    y = i // WARP
    for x in range(width):
        cell = (y * width + x) * count
        opposite = y * (width + count) + width - 1 - x
        least = int(MAX_SUM)
        for chunk in range((count + WARP - 1) // WARP):
            d = chunk * WARP + lane()
            if d < count:
                sum_above = int(sums[cell + d]) * SUM_KEY_FACTOR + d
                best_right[opposite + d] = min(best_right[opposite + d], sum_above)
                least = min(least, sum_above)
        key = min_int_of_lanes(least)
        second = int(MAX_SUM)
        for chunk in range((count + WARP - 1) // WARP):
            d = chunk * WARP + lane()
            if d < count and abs(d - key % SUM_KEY_FACTOR) >= 2:
                second = min(second, int(sums[cell + d]))
        other = min_int_of_lanes(second)
        if lane() == 0:
            keep_winner(y * width + x, count, key, other, best, left_margin, right_margin)
        sync_lanes()
    for step in range((width + WARP - 1) // WARP):
        x = step * WARP + lane()
        if x < width:
            compare_images(x, y, sums, width, count, first, best, best_right, left, right, left_margin, right_margin)


@struct
class RectifiedView:
    """A rectified image: its size and lens, `per_unit`: disparity per inverse depth [px unit], `shift`: disparity of
    number 0 at infinite depth, negated [px], and `back`: rotation to the frame of the original camera.
    """

    width: int
    height: int
    lens: vec4
    per_unit: float
    shift: float
    back: mat33

    def __init__(
        self,
        width: int,
        height: int,
        lens: tuple[float, float, float, float],
        per_unit: float,
        shift: float,
        back: np.ndarray,
    ) -> None:
        self.width, self.height, self.lens = width, height, vec4(*lens)
        self.per_unit, self.shift, self.back = per_unit, shift, mat33(*back.ravel())


@kernel
def fit_planes_kernel(width: int, disparities: array(dtype=float32), planes: array(dtype=vec4)):
    """Disparity, slopes along x and y, and number of pixels of a plane around each of LANE_COUNT adjacent pixels.

    It is fitted by least squares to the pixels of a window that continue the surface. NO_DISPARITY if they are too few.
    """
    i = tid()
    blocks = (width + LANE_COUNT - 1) // LANE_COUNT
    y = i // blocks
    first = i % blocks * LANE_COUNT
    stride = row_stride(width)
    center = (y + PLANE_RADIUS) * stride + PLANE_RADIUS + first
    n = numbers(0.0)
    x1 = numbers(0.0)
    y1 = numbers(0.0)
    d1 = numbers(0.0)
    xx = numbers(0.0)
    xy = numbers(0.0)
    yy = numbers(0.0)
    xd = numbers(0.0)
    yd = numbers(0.0)
    for dy in range(-PLANE_RADIUS, PLANE_RADIUS + 1):
        for dx in range(-PLANE_RADIUS, PLANE_RADIUS + 1):
            a = float(dx)
            b = float(dy)
            limit = MAX_STEP * float(max(max(abs(dx), abs(dy)), 1))
            offset = dy * stride + dx
            for k in range(LANE_COUNT):
                here = disparities[center + k]
                other = disparities[center + k + offset]
                d = other - here
                one = 1.0 if other >= 0.0 and abs(d) <= limit else 0.0
                d = d * one
                n[k] = n[k] + one
                x1[k] = x1[k] + one * a
                y1[k] = y1[k] + one * b
                d1[k] = d1[k] + d
                xx[k] = xx[k] + one * (a * a)
                xy[k] = xy[k] + one * (a * b)
                yy[k] = yy[k] + one * (b * b)
                xd[k] = xd[k] + d * a
                yd[k] = yd[k] + d * b
    for k in range(LANE_COUNT):
        if first + k < width:
            here = disparities[center + k]
            plane = vec4(NO_DISPARITY, 0.0, 0.0, n[k])
            if here >= 0.0 and n[k] >= float(MIN_SUPPORT):
                fraction = 1.0 / n[k]
                sxx = xx[k] - x1[k] * x1[k] * fraction
                sxy = xy[k] - x1[k] * y1[k] * fraction
                syy = yy[k] - y1[k] * y1[k] * fraction
                sxd = xd[k] - x1[k] * d1[k] * fraction
                syd = yd[k] - y1[k] * d1[k] * fraction
                inverse = 1.0 / (sxx * syy - sxy * sxy)  # positive: so many pixels of a window are on no line
                gx = (syy * sxd - sxy * syd) * inverse
                gy = (sxx * syd - sxy * sxd) * inverse
                plane = vec4(here + (d1[k] - gx * x1[k] - gy * y1[k]) * fraction, gx, gy, n[k])
            planes[y * width + first + k] = plane


@kernel
def find_depth_kernel(
    columns: int,
    is_same: int,
    there: mat33,
    view: RectifiedView,
    planes: array(dtype=vec4),
    margins: array(dtype=float32),
    depth: array(dtype=float32),
    normals: array(dtype=vec3),
    confidence: array(dtype=float32),
):
    """Depth, normal and confidence of each pixel of an original image; `there` maps pixels to the rectified image."""
    i = tid()
    u = float(i % columns)
    v = float(i // columns)
    if is_same == 0:
        p = there @ vec3(u, v, 1.0)
        u = -1.0
        if p[2] > 0.0:
            u = min(max(p[0] / p[2], -1.0), float(view.width))
            v = min(max(p[1] / p[2], -1.0), float(view.height))
    column = int(floor(u + 0.5))
    row = int(floor(v + 0.5))
    z = 0.0
    n = vec3(0.0, 0.0, 0.0)
    trust = 0.0
    if column >= 0 and row >= 0 and column < view.width and row < view.height:
        plane = planes[row * view.width + column]
        if plane[0] >= 0.0:
            d = plane[0] + plane[1] * (u - float(column)) + plane[2] * (v - float(row)) + view.shift
            if d > 0.0:
                scale = 1.0 / view.per_unit
                w = d * scale
                away = normal_of(vec4(w, plane[1] * scale, plane[2] * scale, 0.0), column, row, view.lens)
                ray = vec3((u - view.lens[2]) / view.lens[0], (v - view.lens[3]) / view.lens[1], 1.0)
                position = view.back @ (ray * (1.0 / w))
                if position[2] > 0.0:
                    z = position[2]
                    n = view.back @ (away * -1.0)
                    trust = ONE_SOURCE_TRUST * margins[row * view.width + column]
    depth[i] = z
    normals[i] = n
    confidence[i] = trust


def find_disparities(
    sums: Array1[uint16], width: int, height: int, count: int, first: int
) -> tuple[tuple[Scalars, Scalars], tuple[Scalars, Scalars]]:
    """Disparity numbers and margins (height * width) of the left and the right image; number d: disparity `first` + d.

    The disparities are NO_DISPARITY if unknown, and in a border of PLANE_RADIUS pixels (LANE_COUNT more on the right).
    """
    device, size = sums.device, width * height
    padded = (width + 2 * PLANE_RADIUS + LANE_COUNT) * (height + 2 * PLANE_RADIUS)
    best, best_right = empty(size, int32, device), full(height * (width + count), MAX_SUM, int32, device)
    left, right = (full(padded, NO_DISPARITY, float32, device) for _ in range(2))
    left_margin, right_margin = (empty(size, float32, device) for _ in range(2))
    arrays = [sums, width, count, first, best, best_right, left, right, left_margin, right_margin]
    launch(find_disparities_kernel, height * (WARP if device.is_cuda else 1), arrays)
    return (left, left_margin), (right, right_margin)


def find_depth(
    columns: int, rows: int, there: np.ndarray | None, view: RectifiedView, disparities: Scalars, margins: Scalars
) -> tuple[Scalars, Vectors, Scalars]:
    """Depth, normals and confidence of an original image; `there` None if it is the rectified image."""
    count, device = columns * rows, disparities.device
    depth, confidence = (empty(count, float32, device) for _ in range(2))
    normals = empty(count, vec3, device)
    planes = empty(view.width * view.height, vec4, device)
    launch(fit_planes_kernel, -(-view.width // LANE_COUNT) * view.height, [view.width, disparities, planes])
    matrix = mat33(*np.eye(3).ravel() if there is None else there.ravel())
    arrays = [columns, int(there is None), matrix, view, planes, margins, depth, normals, confidence]
    launch(find_depth_kernel, count, arrays)
    return depth, normals, confidence
