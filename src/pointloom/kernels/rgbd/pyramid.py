"""Image pyramid of an RGB-D frame: depth, brightness and surface plane per pixel and level.

Pixel k of a level covers 2 k and 2 k + 1 of the finer one (Newcombe et al. 2011, "KinectFusion", section 3.2). Depth is
the mean over the nearest surface. Holes neither count nor spread. Planes are fitted to inverse depths of a window
(Holzer et al. 2012), which are linear on planes and, for stereo and structured light, uniformly noisy.
"""

import functools
import math
from collections.abc import Hashable

import numpy as np
from numpy.typing import ArrayLike

from ..array_types import Array2, Device, Points, Scalars
from ..images.depth import BLUE_WEIGHT, GREEN_WEIGHT, RED_WEIGHT
from ..lang import array, float32, func, kernel, launch, sqrt, struct, tid, uint8, vec3, vec4, vec4i, vector
from ..memory import empty, full, upload

PIXELS_PER_THREAD = 8  # pixels of a thread that fits planes, which a CPU fits at once
nine = vector(9, float32)  # sums over a window: 1, u, v, u^2, u v, v^2, w, u w, v w, relative to the center
five = vector(5, float32)  # a plane, and its depth on the ray of a pixel
octet = vector(8, float32)  # one number per pixel of a thread
SAME_SURFACE = 0.04  # relative depth difference of four pixels of one surface: 80 degrees of slope at f = 300 px
WINDOW_SURFACE = 0.06  # the same per pixel of distance from a window's center
NO_DEPTH = 1.0e30  # [m] result without valid pixels
NO_COLOR = -1.0  # brightness of pixels without color
MIN_SINE = 0.08  # of the angle between surface and view: flatter ones have no reliable plane
MIN_SUPPORT = 0.55  # fraction of a window's pixels required for a plane


class LevelSizes:
    """Sizes and lenses of the levels of a camera, and their tables on a device."""

    def __init__(self, sizes: np.ndarray, lenses: np.ndarray, device: Device) -> None:
        self.sizes, self.lenses, self.counts = sizes, lenses, sizes[:, 0] * sizes[:, 1]
        self.firsts = np.concatenate([[0], np.cumsum(self.counts)[:-1]])
        self.total = int(self.counts.sum())
        layout = np.column_stack([sizes, self.firsts, self.counts])
        self.tables = upload(layout, vec4i, device), upload(lenses, vec4, device)


_sizes: dict[Hashable, LevelSizes] = {}  # all frames of a camera share them
MAX_CAMERAS = 32


def _sizes_of(sizes: np.ndarray, lenses: np.ndarray, device: Device) -> LevelSizes:
    """The same LevelSizes for the same numbers. Each stream has its own."""
    stream = device.stream.cuda_stream if device.is_cuda else 0
    key = sizes.tobytes(), lenses.tobytes(), device.alias, stream
    known = _sizes.get(key)
    if known is None:
        if len(_sizes) >= MAX_CAMERAS:
            _sizes.clear()
        known = _sizes[key] = LevelSizes(sizes.copy(), lenses.copy(), device)
    return known


@struct
class FrameLevels:
    """Concatenated levels, finest first. `layout`: width, height, first pixel, pixel count; `depth` [m], 0 for none;
    `brightness` or NO_COLOR; `planes`: unit normal n toward the camera and n . q of surface points q [m], or zero.
    """

    layout: array(dtype=vec4i)
    lenses: array(dtype=vec4)
    depth: array(dtype=float32)
    brightness: array(dtype=float32)
    planes: array(dtype=vec4)

    def __init__(self, sizes: ArrayLike, lenses: ArrayLike, device: Device) -> None:
        known = _sizes_of(np.asarray(sizes, np.int64), np.asarray(lenses, np.float64), device)
        self.sizes, self.counts, self.firsts, self.host_lenses = known.sizes, known.counts, known.firsts, known.lenses
        self.layout, self.lenses = known.tables
        self.device, self.total, self.count = device, known.total, len(known.counts)
        self.depth, self.brightness = empty(self.total, float32, device), empty(self.total, float32, device)
        self.planes = empty(self.total, vec4, device)

    @property
    def key(self) -> tuple[Hashable, ...]:
        """The same for all frames of a camera."""
        return self.device.alias, self.sizes.tobytes(), self.host_lenses.tobytes()

    def like(self) -> "FrameLevels":
        """Uninitialized levels of the same sizes."""
        return FrameLevels(self.sizes, self.host_lenses, self.device)


@func
def nearest_depth(a: float, b: float, c: float, d: float) -> float:
    """Least valid depth of four. NO_DEPTH without any."""
    near = float(NO_DEPTH)
    if a > 0.0:
        near = min(near, a)
    if b > 0.0:
        near = min(near, b)
    if c > 0.0:
        near = min(near, c)
    if d > 0.0:
        near = min(near, d)
    return near


@func
def halved_depth(a: float, b: float, c: float, d: float) -> float:
    """Mean depth of the nearest surface among four. 0 without any."""
    near = nearest_depth(a, b, c, d)
    far = near * (1.0 + SAME_SURFACE)
    total = 0.0
    count = 0.0
    if a > 0.0 and a <= far:
        total += a
        count += 1.0
    if b > 0.0 and b <= far:
        total += b
        count += 1.0
    if c > 0.0 and c <= far:
        total += c
        count += 1.0
    if d > 0.0 and d <= far:
        total += d
        count += 1.0
    mean = 0.0
    if count > 0.0:
        mean = total / count
    return mean


@func
def halved_brightness(a: float, b: float, c: float, d: float) -> float:
    """Mean of four. NO_COLOR if one has none."""
    mean = (a + b + c + d) * 0.25
    if min(min(a, b), min(c, d)) < 0.0:
        mean = NO_COLOR
    return mean


@kernel
def halve_image_kernel(
    depth: array(dtype=float32),
    brightness: array(dtype=float32),
    width: int,
    columns: int,
    halved_depths: array(dtype=float32),
    halved_brightnesses: array(dtype=float32),
):
    i = tid()
    at = 2 * (i // columns) * width + 2 * (i % columns)
    halved_depths[i] = halved_depth(depth[at], depth[at + 1], depth[at + width], depth[at + width + 1])
    halved_brightnesses[i] = halved_brightness(
        brightness[at], brightness[at + 1], brightness[at + width], brightness[at + width + 1]
    )


@func
def luma(at: int, pixels: array(dtype=uint8, ndim=2)) -> float:
    return (
        RED_WEIGHT * float(pixels[at, 0]) + GREEN_WEIGHT * float(pixels[at, 1]) + BLUE_WEIGHT * float(pixels[at, 2])
    ) / 255.0


@kernel
def halve_colors_kernel(
    depth: array(dtype=float32),
    pixels: array(dtype=uint8, ndim=2),
    width: int,
    columns: int,
    halved_depths: array(dtype=float32),
    halved_brightnesses: array(dtype=float32),
):
    i = tid()
    at = 2 * (i // columns) * width + 2 * (i % columns)
    halved_depths[i] = halved_depth(depth[at], depth[at + 1], depth[at + width], depth[at + width + 1])
    total = luma(at, pixels) + luma(at + 1, pixels) + luma(at + width, pixels) + luma(at + width + 1, pixels)
    halved_brightnesses[i] = total * 0.25


@func
def finite_depth(z: float) -> float:
    """A valid depth, else 0."""
    good = 0.0
    if z > 0.0 and z < 1.0e6:
        good = z
    return good


@func
def finite_brightness(b: float) -> float:
    """A valid brightness, else NO_COLOR."""
    good = float(NO_COLOR)
    if b >= 0.0 and b < 1.0e6:
        good = b
    return good


# Sources of the first level. A rendered image has no brightness without depth: black would look like an edge.
IS_FILLED, FROM_DEPTH, FROM_BRIGHTNESS, FROM_COLORS, FROM_RENDERED = 0, 1, 2, 3, 4


@kernel
def fill_levels_kernel(
    kind: int,
    depth: array(dtype=float32),
    brightness: array(dtype=float32),
    pixels: array(dtype=uint8, ndim=2),
    levels: FrameLevels,
):
    """Depth and brightness of all levels from an image, or of the coarser ones from the first level.

    A thread fills the pixels of all levels that cover one pixel of the coarsest level, or would if the image continued.
    """
    i = tid()
    side = 1
    for _k in range(levels.layout.shape[0] - 1):
        side = 2 * side
    size = levels.layout[0]
    columns = (size[0] + side - 1) // side
    u = i % columns * side
    v = i // columns * side
    if kind != IS_FILLED:
        for y in range(v, min(v + side, size[1])):
            for x in range(u, min(u + side, size[0])):
                at = y * size[0] + x
                shade = float(NO_COLOR)
                if kind == FROM_BRIGHTNESS or (kind == FROM_RENDERED and depth[at] > 0.0):
                    shade = finite_brightness(brightness[at])
                if kind == FROM_COLORS:
                    shade = luma(at, pixels)
                levels.depth[at] = finite_depth(depth[at])
                levels.brightness[at] = shade
    for level in range(1, levels.layout.shape[0]):
        finer = levels.layout[level - 1]
        coarser = levels.layout[level]
        side = side // 2
        u = u // 2
        v = v // 2
        for y in range(v, min(v + side, coarser[1])):
            for x in range(u, min(u + side, coarser[0])):
                a = finer[2] + 2 * y * finer[0] + 2 * x
                b = a + finer[0]
                at = coarser[2] + y * coarser[0] + x
                levels.depth[at] = halved_depth(
                    levels.depth[a], levels.depth[a + 1], levels.depth[b], levels.depth[b + 1]
                )
                levels.brightness[at] = halved_brightness(
                    levels.brightness[a], levels.brightness[a + 1], levels.brightness[b], levels.brightness[b + 1]
                )


@func
def plane_of(sums: nine, z: float, u: float, v: float, lens: vec4, support: float) -> five:
    """Plane of a pixel's window sums and its depth on the ray. A zero plane and `z` if the window has no plane."""
    n = sums[0]
    mu = sums[1] / n
    mv = sums[2] / n
    mw = sums[6] / n
    cuu = sums[3] / n - mu * mu
    cuv = sums[4] / n - mu * mv
    cvv = sums[5] / n - mv * mv
    cuw = sums[7] / n - mu * mw
    cvw = sums[8] / n - mv * mw
    det = cuu * cvv - cuv * cuv
    a = (cuw * cvv - cvw * cuv) / det
    b = (cvw * cuu - cuw * cuv) / det
    c = 1.0 / z + mw - a * mu - b * mv
    nx = a * lens[0]
    ny = b * lens[1]
    nz = c + a * (lens[2] - u) + b * (lens[3] - v)
    length = sqrt(nx * nx + ny * ny + nz * nz)
    rx = (u - lens[2]) / lens[0]
    ry = (v - lens[3]) / lens[1]
    ray = sqrt(rx * rx + ry * ry + 1.0)
    has_plane = n >= support and det > 0.1 and c > MIN_SINE * length * ray  # n . ray = c here
    return five(
        -nx / length if has_plane else 0.0,
        -ny / length if has_plane else 0.0,
        -nz / length if has_plane else 0.0,
        -1.0 / length if has_plane else 0.0,
        1.0 / c if has_plane else z,
    )


@func
def group_count(size: vec4i) -> int:
    return size[1] * ((size[0] + PIXELS_PER_THREAD - 1) // PIXELS_PER_THREAD)


@kernel
def fit_planes_kernel(radius: int, levels: FrameLevels, planes: array(dtype=vec4), smoothed: array(dtype=float32)):
    """Least-squares planes: w = 1 / z = a (u - u0) + b (v - v0) + c = n . (x, y, 1) / (n . q), x = (u - cx) / fx. Over
    window pixels on the surface of a pixel. A thread fits PIXELS_PER_THREAD pixels of a row."""
    i = tid()
    level = 0
    group = i
    for k in range(levels.layout.shape[0] - 1):
        groups = group_count(levels.layout[k])
        if level == k and group >= groups:
            level = k + 1
            group = group - groups
    size = levels.layout[level]
    lens = levels.lenses[level]
    width = size[0]
    first = group % ((width + PIXELS_PER_THREAD - 1) // PIXELS_PER_THREAD) * PIXELS_PER_THREAD
    v = group // ((width + PIXELS_PER_THREAD - 1) // PIXELS_PER_THREAD)
    line = size[2] + v * width
    z = octet(0.0)
    d = octet(0.0)
    count = octet(0.0)
    su = octet(0.0)
    sv = octet(0.0)
    suu = octet(0.0)
    suv = octet(0.0)
    svv = octet(0.0)
    sw = octet(0.0)
    suw = octet(0.0)
    svw = octet(0.0)
    for lane in range(PIXELS_PER_THREAD):
        z[lane] = levels.depth[line + min(first + lane, width - 1)]
    for dv in range(max(-radius, -v), min(radius, size[1] - 1 - v) + 1):
        y = float(dv)
        for du in range(-radius, radius + 1):
            x = float(du)
            start = first + du
            if start >= 0 and start + PIXELS_PER_THREAD <= width:
                for lane in range(PIXELS_PER_THREAD):
                    d[lane] = levels.depth[line + dv * width + start + lane]
            else:
                for lane in range(PIXELS_PER_THREAD):
                    column = min(max(start + lane, 0), width - 1)
                    value = levels.depth[line + dv * width + column]
                    d[lane] = value if column == start + lane else 0.0
            for lane in range(PIXELS_PER_THREAD):
                is_near = abs(d[lane] - z[lane]) <= WINDOW_SURFACE * z[lane]
                one = 1.0 if is_near else 0.0
                w = 1.0 / d[lane] - 1.0 / z[lane] if is_near else 0.0  # relative to the center
                count[lane] += one
                su[lane] += one * x
                sv[lane] += one * y
                suu[lane] += one * (x * x)
                suv[lane] += one * (x * y)
                svv[lane] += one * (y * y)
                sw[lane] += w
                suw[lane] += x * w
                svw[lane] += y * w
    support = MIN_SUPPORT * float(2 * radius + 1) * float(2 * radius + 1)
    for lane in range(PIXELS_PER_THREAD):
        sums = nine(
            count[lane], su[lane], sv[lane], suu[lane], suv[lane], svv[lane], sw[lane], suw[lane], svw[lane]
        )  # fmt: skip
        plane = plane_of(sums, z[lane], float(first + lane), float(v), lens, support)
        su[lane] = plane[0]
        sv[lane] = plane[1]
        suu[lane] = plane[2]
        suv[lane] = plane[3]
        svv[lane] = plane[4]
    for lane in range(PIXELS_PER_THREAD):
        if first + lane < width:
            at = line + first + lane
            if z[lane] > 0.0:
                planes[at] = vec4(su[lane], sv[lane], suu[lane], suv[lane])
                smoothed[at] = svv[lane]
            else:
                planes[at] = vec4(0.0, 0.0, 0.0, 0.0)
                smoothed[at] = z[lane]


@kernel
def take_normals_kernel(
    normals: array(dtype=vec3), depth: array(dtype=float32), lens: vec4, width: int, planes: array(dtype=vec4)
):
    """Planes of given normals in the first level. Zero where depth or normal is missing."""
    i = tid()
    z = depth[i]
    n = normals[i]
    plane = vec4(0.0, 0.0, 0.0, 0.0)
    square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2]
    if z > 0.0 and square > 0.25 and square < 4.0:
        length = sqrt(square)
        x = (float(i % width) - lens[2]) / lens[0] * z
        y = (float(i // width) - lens[3]) / lens[1] * z
        d = (n[0] * x + n[1] * y + n[2] * z) / length
        side = float(1.0)
        if d > 0.0:
            side = -1.0
        plane = vec4(side * n[0] / length, side * n[1] / length, side * n[2] / length, side * d)
    planes[i] = plane


@functools.lru_cache(MAX_CAMERAS)
def level_sizes(
    width: int, height: int, lens: tuple[float, float, float, float], max_pixels: int, min_side: int
) -> tuple[tuple[tuple[int, int], ...], np.ndarray, int]:
    """(sizes, lenses, initial halvings to `max_pixels`) of an image's levels, finest first; sides >= `min_side`."""
    sizes: list[tuple[int, int]] = []
    lenses: list[np.ndarray] = []
    size, camera, halvings = (width, height), np.asarray(lens, np.float64), 0
    while True:
        if size[0] * size[1] <= max_pixels or min(size) < 2:
            sizes.append(size)
            lenses.append(camera)
        else:
            halvings += 1
        size = (size[0] // 2, size[1] // 2)
        camera = np.concatenate([camera[:2] / 2, (camera[2:] + 0.5) / 2 - 0.5])
        if min(size) < min_side and sizes:
            return tuple(sizes), np.array(lenses), halvings


def make_levels(
    depth: Scalars,
    brightness: Scalars | Array2[uint8] | None,
    size: tuple[int, int],
    lens: tuple[float, float, float, float],
    *,
    max_pixels: int,
    min_side: int,
    radius: int,
    normals: Points | None = None,
    is_rendered: bool = False,
) -> FrameLevels:
    """FrameLevels of an image: depth [m], brightness 0..1 or 8-bit colors or None. `radius`: half the window of a plane
    [px]. If the first level is the image itself: its `normals`, None fits them, and whether it `is_rendered`, so that
    pixels without depth have no brightness.
    """
    device = depth.device
    sizes, lenses, halvings = level_sizes(*size, lens, max_pixels, min_side)
    levels = FrameLevels(sizes, lenses, device)
    for step in range(halvings):
        depth, brightness = _halve(depth, brightness, size, levels if step == halvings - 1 else None)
        size = (size[0] // 2, size[1] // 2)
    _fill(levels, depth, brightness, is_filled=halvings > 0, is_rendered=is_rendered)
    smoothed = empty(levels.total, float32, device)
    groups = sum(rows * -(-columns // PIXELS_PER_THREAD) for columns, rows in sizes)
    launch(fit_planes_kernel, groups, [radius, levels, levels.planes, smoothed])
    levels.depth = smoothed
    if normals is not None and not halvings:
        arguments = [normals, levels.depth, vec4(*map(float, lenses[0])), int(sizes[0][0]), levels.planes]
        launch(take_normals_kernel, int(levels.counts[0]), arguments)
    return levels


def _halve(
    depth: Scalars, brightness: Scalars | Array2[uint8] | None, size: tuple[int, int], levels: FrameLevels | None
) -> tuple[Scalars, Scalars]:
    """Halve depth and brightness, into the first level of `levels` if given."""
    columns, rows = size[0] // 2, size[1] // 2
    count = columns * rows
    if levels is None:
        halved = empty(count, float32, depth.device), empty(count, float32, depth.device)
    else:
        halved = levels.depth, levels.brightness
    if brightness is None:
        brightness = full(depth.size, NO_COLOR, float32, depth.device)
    if brightness.dtype == uint8:
        launch(halve_colors_kernel, count, [depth, brightness, size[0], columns, *halved])
    else:
        launch(halve_image_kernel, count, [depth, brightness, size[0], columns, *halved])
    return halved


def _fill(
    levels: FrameLevels,
    depth: Scalars,
    brightness: Scalars | Array2[uint8] | None,
    *,
    is_filled: bool,
    is_rendered: bool,
) -> None:
    """Fill levels from an image of the size of the first level. `is_filled`: that one is filled."""
    kind, shades, pixels = FROM_RENDERED if is_rendered else FROM_BRIGHTNESS, brightness, brightness
    if brightness is None or brightness.dtype == uint8:
        kind, shades = FROM_DEPTH if brightness is None else FROM_COLORS, depth
    if brightness is None or brightness.dtype == float32:
        pixels = empty((1, 3), uint8, levels.device)
    threads = math.prod(-(-int(extent) // 2 ** (levels.count - 1)) for extent in levels.sizes[0])
    launch(fill_levels_kernel, threads, [IS_FILLED if is_filled else kind, depth, shades, pixels, levels])
