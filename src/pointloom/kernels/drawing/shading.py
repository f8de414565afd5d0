"""Shading: from z-buffer to image.

A pixel averages `CELLS_PER_PIXEL` x `CELLS_PER_PIXEL` cells. Each scene part adds its colors to a light array. The rest
is background.
A headlight, a lamp above left (Lambert), and ambient light. Points without normals use eye-dome lighting (Boucheny,
thesis, Grenoble 2009, chapter 4). Triangle edges by image distance (Baerentzen et al., "Single-pass wireframe
rendering", SIGGRAPH 2006). Only + - * / and sqrt: bitwise identical everywhere.
"""

from typing import NamedTuple

from ..array_types import Bytes, Device, Scalars, Vectors
from ..arrays.packed_keys import NO_KEY, key_index, key_number
from ..lang import (
    array,
    dot,
    float32,
    func,
    int32,
    int64,
    kernel,
    launch,
    length,
    loop,
    struct,
    tid,
    uint8,
    vec3,
    vector,
)
from ..memory import empty, zeros
from .z_buffer import DepthBuffer, View, ray_through

CELLS_PER_PIXEL = 2  # along each axis
AMBIENT_LIGHT = 0.34
HEAD_LIGHT = 0.36
KEY_LIGHT = 0.38
KEY_X, KEY_Y, KEY_Z = 0.45, 0.65, 0.612  # lamp above left, in the camera frame: x right, y down
RELIEF_STRENGTH = 45.0  # of eye-dome lighting, per logarithm of depth
RELIEF_LIMIT = 0.025  # ... maximum contribution of a neighbor, so that outlines stay gray
RELIEF_RADIUS = 3  # [cells]
PIXELS_PER_THREAD = 4  # of a thread that shades points
octet, sixteen, sixteen_points = vector(8, float32), vector(16, float32), vector(16, int32)


@struct
class Region:
    """Indices `start`..`stop` of a part in the z-buffer, and its rectangle: `left`, `top`, `wide` columns [px]."""

    start: int
    stop: int
    left: int
    top: int
    wide: int

    def __init__(self, start: int, stop: int, rectangle: tuple[int, int, int, int]) -> None:
        """From a rectangle (left, top, right, bottom) [px], right and bottom exclusive."""
        left, top, right, bottom = rectangle
        self.start, self.stop, self.left, self.top, self.wide = start, stop, left, top, max(right - left, 0)
        self.pixels = self.wide * max(bottom - top, 0)


@struct
class PixelRuns:
    """Pixels of each thread, PIXELS: `stride` between threads' first pixels, `step` within a thread."""

    count: int
    stride: int
    step: int

    def __init__(self, count: int, device: Device) -> None:
        self.count, self.threads = count, -(-count // PIXELS_PER_THREAD)
        self.stride, self.step = (1, self.threads) if device.is_cuda else (PIXELS_PER_THREAD, 1)


@struct
class Veil:
    """Transparency: `opacity` 0 to 1; `left` (cells), light left by the parts in front, empty if all is opaque."""

    opacity: float
    left: array(dtype=float)

    def __init__(self, opacity: float, left: Scalars) -> None:
        self.opacity, self.left = opacity, left


@func
def seen_fraction(cell: int, veil: Veil) -> float:
    """Fraction of a part's light that a cell shows. Reduces the remainder."""
    fraction = 1.0
    if veil.left.shape[0] > 0:
        left = veil.left[cell]
        fraction = left * veil.opacity
        veil.left[cell] = left - fraction
    return fraction


@func
def light_face(normal: vec3, facing: vec3, ray: vec3) -> float:
    """Two-sided light: headlight, lamp and ambient. The normal is oriented along `facing`, away from the camera."""
    size = length(normal)
    distance = length(ray)
    cosine = 0.5
    side = 0.5
    if size > 0.0 and distance > 0.0:
        scale = 1.0 / size
        if dot(normal, facing) < 0.0:
            scale = -scale
        cosine = max(dot(normal, ray) * scale / distance, 0.0)
        side = max(dot(normal, vec3(KEY_X, KEY_Y, KEY_Z)) * scale, 0.0)
    return AMBIENT_LIGHT + HEAD_LIGHT * cosine + KEY_LIGHT * side


@func
def eye_dome(cell: int, stop: int, buffer: DepthBuffer) -> float:
    """Eye-dome factor of a cell from neighbors with elements below an index."""
    depth = key_number(buffer.words[cell])
    hidden = 0.0
    middle_column = cell % buffer.width
    middle_row = cell // buffer.width
    rises = octet(0.0)
    for k in range(8):  # a CPU takes all at once
        neighbor = k + k // 4  # the 8 cells around the center of a 3 x 3 square
        column = middle_column + (neighbor % 3 - 1) * RELIEF_RADIUS
        row = middle_row + (neighbor // 3 - 1) * RELIEF_RADIUS
        inside = column >= 0 and column < buffer.width and row >= 0 and row < buffer.height
        word = buffer.words[row * buffer.width + column if inside else cell]
        other = key_number(word)
        rise = 2.0 * (depth - other) / (depth + other)  # difference of logarithms to third order
        counts = inside and word != int64(NO_KEY) and key_index(word) < stop
        rises[k] = min(max(rise, 0.0), RELIEF_LIMIT) if counts else 0.0
    for k in range(8):
        hidden += rises[k]
    x = RELIEF_STRENGTH * hidden * 0.125
    return 1.0 / (1.0 + x * (1.0 + x * (0.5 + x * (0.16666667 + x * 0.041666667))))  # exp(-x) to 1 % for x below 1.13


@func
def clamp_color(color: vec3) -> vec3:
    """Color clamped to 0..1. NaN becomes 0."""
    r = min(max(color[0], 0.0), 1.0)
    g = min(max(color[1], 0.0), 1.0)
    b = min(max(color[2], 0.0), 1.0)
    return vec3(r, g, b)


@func
def color_byte(value: float) -> uint8:
    return uint8(int(min(max(value, 0.0), 1.0) * 255.0 + 0.5))


@func
def pixel_of(i: int, region: Region, buffer: DepthBuffer) -> int:
    return (region.top + i // region.wide) * (buffer.width // CELLS_PER_PIXEL) + region.left + i % region.wide


@loop
def cells_of(pixel: int, buffer: DepthBuffer) -> int:
    columns = buffer.width // CELLS_PER_PIXEL
    first = (pixel // columns) * CELLS_PER_PIXEL * buffer.width + (pixel % columns) * CELLS_PER_PIXEL
    for k in range(CELLS_PER_PIXEL * CELLS_PER_PIXEL):
        cell = first + (k // CELLS_PER_PIXEL) * buffer.width + k % CELLS_PER_PIXEL
        yield cell


@func
def element_at(cell: int, region: Region, buffer: DepthBuffer) -> int:
    element = -1
    word = buffer.words[cell]
    if word != int64(NO_KEY):
        index = key_index(word)
        if index >= region.start and index < region.stop:
            element = index - region.start
    return element


@kernel
def shade_points_kernel(
    buffer: DepthBuffer,
    view: View,
    region: Region,
    pixels: PixelRuns,
    colors: array(dtype=vec3),
    normals: array(dtype=vec3),
    plain: vec3,
    lit: int,
    relief: int,
    last_point: int,
    around: DepthBuffer,
    veil: Veil,
    light: array(dtype=vec3),
):
    """Add the colors of cells that show points, shaded by the cells around them.

    A loop of its own reads the colors, so that the reads overlap.
    """
    i = tid()
    points = sixteen_points(-1)
    red = sixteen(plain[0])
    green = sixteen(plain[1])
    blue = sixteen(plain[2])
    last = -1
    for n in range(PIXELS_PER_THREAD):
        j = i * pixels.stride + n * pixels.step
        if j < pixels.count:
            k = n * CELLS_PER_PIXEL * CELLS_PER_PIXEL
            for cell in cells_of(pixel_of(j, region, buffer), buffer):
                points[k] = element_at(cell, region, buffer)
                last = max(last, points[k])
                k += 1
    if colors.shape[0] > 0 and last >= 0:
        for k in range(PIXELS_PER_THREAD * CELLS_PER_PIXEL * CELLS_PER_PIXEL):
            color = colors[max(points[k], 0)]
            red[k] = color[0]
            green[k] = color[1]
            blue[k] = color[2]
    for n in range(PIXELS_PER_THREAD):
        pixel = pixel_of(min(i * pixels.stride + n * pixels.step, pixels.count - 1), region, buffer)
        total = vec3(0.0, 0.0, 0.0)
        brightness = 0.0
        known = -1
        foremost = -1
        k = n * CELLS_PER_PIXEL * CELLS_PER_PIXEL
        for cell in cells_of(pixel, buffer):
            if points[k] >= 0:
                if foremost < 0 or buffer.words[cell] < buffer.words[max(foremost, 0)]:
                    foremost = cell
                color = vec3(red[k], green[k], blue[k])
                if colors.shape[0] > 0:
                    color = clamp_color(color)
                if lit == 1:
                    if points[k] != known:
                        known = points[k]
                        ray = ray_through(float(cell % buffer.width), float(cell // buffer.width), view)
                        brightness = light_face(view.rotation @ normals[known], ray, ray)
                    color = color * brightness
                total = total + color * seen_fraction(cell, veil)
            k += 1
        if foremost >= 0:
            if relief == 1:
                total = total * eye_dome(foremost, last_point, around)
            light[pixel] = light[pixel] + total


@kernel
def shade_lines_kernel(
    buffer: DepthBuffer, region: Region, colors: array(dtype=vec3), plain: vec3, veil: Veil, light: array(dtype=vec3)
):
    i = tid()
    pixel = pixel_of(i, region, buffer)
    total = vec3(0.0, 0.0, 0.0)
    for cell in cells_of(pixel, buffer):
        line = element_at(cell, region, buffer)
        if line >= 0:
            color = plain
            if colors.shape[0] > 0:
                color = clamp_color(colors[line])
            total = total + color * seen_fraction(cell, veil)
    light[pixel] = light[pixel] + total


@kernel
def finish_picture_kernel(
    buffer: DepthBuffer,
    light: array(dtype=vec3),
    left: array(dtype=float),
    background: vec3,
    picture: array(dtype=uint8),
):
    i = tid()
    total = light[i]
    for cell in cells_of(i, buffer):
        if buffer.words[cell] == int64(NO_KEY):
            fraction = 1.0
            if left.shape[0] > 0:
                fraction = left[cell]
            total = total + background * fraction
    mean = total / float(CELLS_PER_PIXEL * CELLS_PER_PIXEL)
    for k in range(3):
        picture[3 * i + k] = color_byte(mean[k])


@kernel
def read_depth_kernel(
    buffer: DepthBuffer, unit: float, first_line: int, last_line: int, closer: float, depths: array(dtype=float)
):
    """Depth of each pixel: harmonic mean of cells within 1 % of the nearest. 0 if empty."""
    i = tid()
    nearest = int64(NO_KEY)
    for cell in cells_of(i, buffer):
        nearest = min(nearest, buffer.words[cell])
    depth = 0.0
    if nearest != int64(NO_KEY):
        limit = key_number(nearest) * 1.01
        total = 0.0
        count = 0.0
        for cell in cells_of(i, buffer):
            word = buffer.words[cell]
            if word != int64(NO_KEY):
                if key_number(word) <= limit:
                    total = total + 1.0 / key_number(word)
                    count = count + 1.0
        depth = count / total * unit
        if key_index(nearest) >= first_line and key_index(nearest) < last_line:
            depth = depth / closer
    depths[i] = depth


def start_light(buffer: DepthBuffer) -> Vectors:
    """Light array of all parts: vec3 (pixels)."""
    return zeros((buffer.width // CELLS_PER_PIXEL) * (buffer.height // CELLS_PER_PIXEL), vec3, buffer.words.device)


class PointLook(NamedTuple):
    """Colors of points (`plain` without `colors`), and their light: that of `normals` if `lit` and `shaded`, else
    eye-dome lighting if `shaded`."""

    colors: Vectors
    normals: Vectors
    plain: vec3
    shaded: bool
    lit: bool


def shade_points(
    buffer: DepthBuffer,
    view: View,
    region: Region,
    light: Vectors,
    look: PointLook,
    *,
    last_point: int,
    around: DepthBuffer,
    veil: Veil,
) -> None:
    """Add the light of points. Eye-dome lighting is cast by points up to `last_point` in the buffer `around` (a
    transparent cloud has its own)."""
    lit = look.shaded and look.lit and look.normals.size > 0
    lights = [int(lit), int(look.shaded and not lit), last_point, around, veil, light]
    pixels = PixelRuns(region.pixels, light.device)
    launch(
        shade_points_kernel,
        pixels.threads,
        [buffer, view, region, pixels, look.colors, look.normals, look.plain, *lights],
    )


def shade_lines(
    buffer: DepthBuffer, region: Region, light: Vectors, *, colors: Vectors, plain: vec3, veil: Veil
) -> None:
    launch(shade_lines_kernel, region.pixels, [buffer, region, colors, plain, veil, light])


def finish_picture(buffer: DepthBuffer, light: Vectors, left: Scalars, background: vec3) -> Bytes:
    """Final image, uint8 (3 pixels), of the light before a background (RGB); `left` as of a `Veil`."""
    picture = empty(3 * light.size, uint8, light.device)
    launch(finish_picture_kernel, light.size, [buffer, light, left, background, picture])
    return picture


def read_depth(buffer: DepthBuffer, unit: float, *, lines: tuple[int, int] = (0, 0), closer: float = 1.0) -> Scalars:
    """Depth per pixel, float32 (pixels), times a unit [m]. Lines in an index range get their true depth."""
    depths = empty((buffer.width // CELLS_PER_PIXEL) * (buffer.height // CELLS_PER_PIXEL), float32, buffer.words.device)
    launch(read_depth_kernel, depths.size, [buffer, float(unit), *lines, float(closer), depths])
    return depths
