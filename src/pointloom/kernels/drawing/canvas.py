"""Strokes, shapes and glyphs in an image.

Coverage (0 to 255) is accumulated by atomic maximum, so crossing strokes do not darken, then blended in integers.
Float32 + - * / sqrt only: bitwise identical on every device. Cell centers are at integers.
"""

import numpy as np

from ..array_types import Bytes
from ..lang import array, atomic_max, ceil, floor, func, int32, kernel, launch, sqrt, struct, tid, uint8, vec2, vec4
from ..memory import upload, zeros

FULL_COVERAGE = 255  # coverage of a cell entirely inside


@struct
class Sheet:
    """Image of `width` x `height` cells: `picture` uint8 RGB; coverage `words` int32, 0 between paintings."""

    width: int
    height: int
    picture: array(dtype=uint8)
    words: array(dtype=int32)

    def __init__(self, picture: Bytes, width: int, height: int) -> None:
        self.width, self.height, self.picture = width, height, picture
        self.words = zeros(width * height, int32, picture.device)


@struct
class Paint:
    """Color and `opacity`, 0 to 255 each."""

    red: int
    green: int
    blue: int
    opacity: int

    def __init__(self, color: tuple[int, int, int], opacity: int) -> None:
        self.red, self.green, self.blue = color
        self.opacity = opacity


@func
def fraction_inside(depth: float) -> float:
    """Coverage of a cell whose center is `depth` [px] inside an edge."""
    return min(max(depth + 0.5, 0.0), 1.0)


@func
def cover_cell(column: int, row: int, fraction: float, sheet: Sheet):
    """Cover a cell by a fraction (atomic maximum)."""
    coverage = int(fraction * 255.0 + 0.5)
    if coverage > 0:
        cell = row * sheet.width + column
        if coverage > sheet.words[cell]:
            atomic_max(sheet.words, cell, coverage)


@func
def distance_to_segment(p: vec2, a: vec2, b: vec2) -> float:
    dx = b[0] - a[0]
    dy = b[1] - a[1]
    sqlength = dx * dx + dy * dy
    t = 0.0
    if sqlength > 0.0:
        t = min(max(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / sqlength, 0.0), 1.0)
    x = p[0] - (a[0] + t * dx)
    y = p[1] - (a[1] + t * dy)
    return sqrt(x * x + y * y)


@kernel
def cover_segments_kernel(segments: array(dtype=vec4), half: float, strength: float, sheet: Sheet):
    """Cover the cells within half a width of a segment, with round ends."""
    i = tid()
    s = segments[i]
    a = vec2(s[0], s[1])
    b = vec2(s[2], s[3])
    steep = abs(s[3] - s[1]) > abs(s[2] - s[0])
    start = s[0]
    stop = s[2]
    side = s[1]
    side_stop = s[3]
    steps = sheet.width
    sides = sheet.height
    if steep:
        start = s[1]
        stop = s[3]
        side = s[0]
        side_stop = s[2]
        steps = sheet.height
        sides = sheet.width
    radius = half + 1.0
    first = max(int(floor(min(start, stop) - radius)), 0)
    last = min(int(ceil(max(start, stop) + radius)), steps - 1)
    for step in range(first, last + 1):
        t = 0.0
        if start != stop:
            t = min(max((float(step) - start) / (stop - start), 0.0), 1.0)
        middle = side + t * (side_stop - side)
        low = max(int(floor(middle - 2.0 * radius)), 0)
        high = min(int(ceil(middle + 2.0 * radius)), sides - 1)
        for k in range(low, high + 1):
            column = step
            row = k
            if steep:
                column = k
                row = step
            gap = distance_to_segment(vec2(float(column), float(row)), a, b)
            cover_cell(column, row, strength * fraction_inside(half - gap), sheet)


@kernel
def cover_glyphs_kernel(glyphs: array(dtype=int32), rows: int, atlas: array(dtype=uint8), sheet: Sheet):
    """Cover the cells of glyphs, one thread per row: atlas offset, width, height, column, row."""
    i = tid()
    at = 5 * (i // rows)
    line = i % rows
    if line < glyphs[at + 2]:
        width = glyphs[at + 1]
        for k in range(width):
            column = glyphs[at + 3] + k
            row = glyphs[at + 4] + line
            if column >= 0 and column < sheet.width and row >= 0 and row < sheet.height:
                fraction = float(int(atlas[glyphs[at] + line * width + k])) / 255.0
                cover_cell(column, row, fraction, sheet)


@func
def fraction_of_span(center: float, low: float, high: float) -> float:
    return min(max(min(center + 0.5, high) - max(center - 0.5, low), 0.0), 1.0)


@kernel
def cover_box_kernel(left: int, top: int, columns: int, outer: vec4, inner: vec4, sheet: Sheet):
    """Cover the cells between two boxes (left, top, right, bottom). The inner may be empty."""
    i = tid()
    column = left + i % columns
    row = top + i // columns
    x = float(column)
    y = float(row)
    fraction = fraction_of_span(x, outer[0], outer[2]) * fraction_of_span(y, outer[1], outer[3])
    hole = fraction_of_span(x, inner[0], inner[2]) * fraction_of_span(y, inner[1], inner[3])
    cover_cell(column, row, fraction - hole, sheet)


@func
def blend_byte(old: uint8, added: int, fraction: int) -> uint8:
    return uint8(
        (int(old) * (FULL_COVERAGE * FULL_COVERAGE - fraction) + added * fraction + FULL_COVERAGE * FULL_COVERAGE // 2)
        // (FULL_COVERAGE * FULL_COVERAGE)
    )


@func
def blend_cell(cell: int, coverage: int, paint: Paint, picture: array(dtype=uint8)):
    fraction = coverage * paint.opacity
    picture[3 * cell] = blend_byte(picture[3 * cell], paint.red, fraction)
    picture[3 * cell + 1] = blend_byte(picture[3 * cell + 1], paint.green, fraction)
    picture[3 * cell + 2] = blend_byte(picture[3 * cell + 2], paint.blue, fraction)


@kernel
def blend_kernel(left: int, top: int, columns: int, paint: Paint, sheet: Sheet):
    i = tid()
    cell = (top + i // columns) * sheet.width + left + i % columns
    coverage = sheet.words[cell]
    if coverage != 0:
        blend_cell(cell, coverage, paint, sheet.picture)
        sheet.words[cell] = 0


@kernel
def blend_halo_kernel(left: int, top: int, columns: int, radius: int, paint: Paint, sheet: Sheet):
    """Blend the cells within `radius` cells of covered ones. Coverage stays."""
    i = tid()
    column = left + i % columns
    row = top + i // columns
    strength = 0.0
    for dy in range(-radius, radius + 1):
        for dx in range(-radius, radius + 1):
            x = column + dx
            y = row + dy
            if x >= 0 and x < sheet.width and y >= 0 and y < sheet.height:
                coverage = float(sheet.words[y * sheet.width + x])
                gap = sqrt(float(dx * dx + dy * dy))
                strength = max(strength, coverage * fraction_inside(float(radius) - gap))
    if strength > 0.0:
        blend_cell(row * sheet.width + column, int(strength + 0.5), paint, sheet.picture)


@kernel
def copy_image_kernel(
    image: array(dtype=uint8), image_width: int, x: int, y: int, left: int, top: int, columns: int, sheet: Sheet
):
    """Copy the cells of a box from an image with its first pixel at column x, row y."""
    i = tid()
    column = left + i % columns
    row = top + i // columns
    source = 3 * ((row - y) * image_width + column - x)
    cell = 3 * (row * sheet.width + column)
    for k in range(3):
        sheet.picture[cell + k] = image[source + k]


def clip_box(sheet: Sheet, left: int, top: int, right: int, bottom: int) -> tuple[int, int, int, int]:
    """Clip a box (inclusive) to the sheet: (left, top, columns, rows)."""
    left, top = max(left, 0), max(top, 0)
    columns, rows = min(right, sheet.width - 1) - left + 1, min(bottom, sheet.height - 1) - top + 1
    return left, top, max(columns, 0), max(rows, 0)


def cover_segments(sheet: Sheet, segments: np.ndarray, width: float) -> None:
    """Cover segments, float32 (n, 4) (x, y, x, y) [px]; thinner than a pixel they are fainter."""
    half, strength = max(width, 1.0) / 2, min(width, 1.0)
    table = upload(segments, vec4, sheet.words.device)
    launch(cover_segments_kernel, len(segments), [table, float(half), float(strength), sheet])


def cover_glyphs(sheet: Sheet, glyphs: np.ndarray, atlas: Bytes) -> None:
    """Cover glyphs, int32 (n, 5) on the host: offset in the coverage `atlas`, width, height, first column and row."""
    rows = int(glyphs[:, 2].max())
    table = upload(glyphs.ravel(), int32, sheet.words.device)
    launch(cover_glyphs_kernel, rows * len(glyphs), [table, rows, atlas, sheet])


def cover_box(
    sheet: Sheet,
    box: tuple[int, int, int, int],
    outer: tuple[float, float, float, float],
    inner: tuple[int, int, int, int],
) -> None:
    """Cover a box minus another, in floats; `box` as of `clip_box`."""
    left, top, columns, rows = box
    launch(cover_box_kernel, columns * rows, [left, top, columns, vec4(*outer), vec4(*inner), sheet])


def blend(sheet: Sheet, box: tuple[int, int, int, int], paint: Paint) -> None:
    """Blend the covered cells in a box, and clear them."""
    left, top, columns, rows = box
    launch(blend_kernel, columns * rows, [left, top, columns, paint, sheet])


def blend_halo(sheet: Sheet, box: tuple[int, int, int, int], radius: int, paint: Paint) -> None:
    """Blend a halo of `radius` cells around the covered cells in a box. Coverage stays."""
    left, top, columns, rows = box
    launch(blend_halo_kernel, columns * rows, [left, top, columns, radius, paint, sheet])


def copy_image(sheet: Sheet, box: tuple[int, int, int, int], image: Bytes, image_width: int, x: int, y: int) -> None:
    """Copy the box's part of an image, a uint8 device array with rows of that width."""
    left, top, columns, rows = box
    launch(copy_image_kernel, columns * rows, [image, image_width, x, y, left, top, columns, sheet])
