"""Points as round splats in a z-buffer. With many points, only the foremost point per center cell is drawn as a disc,
at a loss of at most a sliver of a cell, so 20 points per cell cost little more than one.
"""

import numpy as np

from ..array_types import Points
from ..arrays.packed_keys import NO_KEY, key_number, offer_cell
from ..lang import (
    array,
    atomic_add,
    atomic_min,
    bits_float,
    float_bits,
    floor,
    func,
    int32,
    int64,
    kernel,
    launch,
    sqrt,
    struct,
    tid,
    vec3,
)
from ..memory import download, full, zeros
from .z_buffer import DepthBuffer, View, is_before, project, to_camera

MAX_RADIUS = 512.0  # [cells] limits the time of a disc right in front of the camera
FEW_POINTS = 0.03125  # points per cell up to which each draws its own disc
SAMPLE = 1 << 18  # points sampled to find the size that closes gaps
SQUARE = 32  # [cells] side of the counting squares
LAYER = 1.04  # of the nearest depth in a square: farther points belong to another surface
FAR_BITS = 0x7F7F_FFFF  # bits of the largest float32


@struct
class Splat:
    """Disc size [cells]: `scaled_radius` / depth, clamped to `radius`..`max_radius`."""

    radius: float
    scaled_radius: float
    max_radius: float

    def __init__(self, radius: float, scaled_radius: float = 0.0, max_radius: float = MAX_RADIUS) -> None:
        self.radius, self.scaled_radius, self.max_radius = radius, scaled_radius, max_radius


@func
def radius_at(depth: float, splat: Splat) -> float:
    return min(max(splat.radius, splat.scaled_radius / depth), splat.max_radius)


@func
def draw_disc(x: float, y: float, depth: float, index: int, splat: Splat, buffer: DepthBuffer):
    """Draw a disc's cells, always including the center cell."""
    radius = radius_at(depth, splat)
    middle_column = int(floor(x + 0.5))
    middle_row = int(floor(y + 0.5))
    first = max(int(floor(x - radius + 0.5)), 0)
    last = min(int(floor(x + radius + 0.5)), buffer.width - 1)
    top = max(int(floor(y - radius + 0.5)), 0)
    bottom = min(int(floor(y + radius + 0.5)), buffer.height - 1)
    for row in range(top, bottom + 1):
        for column in range(first, last + 1):
            dx = float(column) - x
            dy = float(row) - y
            if dx * dx + dy * dy <= radius * radius or (column == middle_column and row == middle_row):
                offer_cell(row * buffer.width + column, depth, index, buffer.words)


@func
def is_near_picture(p: vec3, radius: float, buffer: DepthBuffer) -> int:
    """1 for a projected point whose disc may touch the image."""
    near = 0
    if p[0] > -radius - 1.0 and p[1] > -radius - 1.0:
        if p[0] < float(buffer.width) + radius and p[1] < float(buffer.height) + radius:
            near = 1
    return near


@kernel
def draw_points_kernel(points: array(dtype=vec3), view: View, splat: Splat, start: int, buffer: DepthBuffer):
    i = tid()
    q = to_camera(points[i], view)
    if is_before(q) == 1:
        p = project(q, view)
        if is_near_picture(p, radius_at(p[2], splat), buffer) == 1:
            draw_disc(p[0], p[1], p[2], start + i, splat, buffer)


@kernel
def mark_middles_kernel(points: array(dtype=vec3), view: View, start: int, middles: DepthBuffer):
    i = tid()
    q = to_camera(points[i], view)
    if is_before(q) == 1:
        p = project(q, view)
        column = int(floor(p[0] + 0.5))
        row = int(floor(p[1] + 0.5))
        if column >= 0 and row >= 0 and column < middles.width and row < middles.height:
            offer_cell(row * middles.width + column, p[2], start + i, middles.words)


@kernel
def spread_middles_kernel(middles: DepthBuffer, splat: Splat, buffer: DepthBuffer):
    """Draw the discs of the foremost points around their center cells."""
    i = tid()
    word = middles.words[i]
    if word != int64(NO_KEY):
        column = i % buffer.width
        row = i // buffer.width
        radius = radius_at(key_number(word), splat)
        rows = int(radius)
        for other in range(max(row - rows, 0), min(row + rows + 1, buffer.height)):
            rise = float(other - row)
            half = int(sqrt(max(radius * radius - rise * rise, 0.0)))
            line = other * buffer.width
            for x in range(max(column - half, 0), min(column + half + 1, buffer.width)):
                if word < buffer.words[line + x]:
                    atomic_min(buffer.words, line + x, word)  # minimum: order-independent


@func
def square_of(q: vec3, view: View) -> int:
    """Image square of a camera-frame point, or -1."""
    square = -1
    if is_before(q) == 1:
        p = project(q, view)
        column = int(floor(p[0] + 0.5))
        row = int(floor(p[1] + 0.5))
        if column >= 0 and row >= 0 and column < view.camera.width and row < view.camera.height:
            square = (row // SQUARE) * ((view.camera.width + SQUARE - 1) // SQUARE) + column // SQUARE
    return square


@kernel
def find_nearest_kernel(points: array(dtype=vec3), stride: int, view: View, nearest: array(dtype=int32)):
    """Least depth bits in each square, over every `stride`-th point."""
    i = tid()
    q = to_camera(points[i * stride], view)
    square = square_of(q, view)
    if square >= 0:
        atomic_min(nearest, square, float_bits(q[2]))  # minimum: order-independent


@kernel
def count_in_squares_kernel(
    points: array(dtype=vec3), stride: int, view: View, nearest: array(dtype=int32), counts: array(dtype=int32)
):
    """Count every `stride`-th point in its square if it is near the foremost depth."""
    i = tid()
    q = to_camera(points[i * stride], view)
    square = square_of(q, view)
    if square >= 0:
        if q[2] <= LAYER * bits_float(nearest[square]):
            atomic_add(counts, square, 1)  # integer sum: order-independent


def draw_points(points: Points, view: View, buffer: DepthBuffer, *, splat: Splat, start: int = 0) -> None:
    """Draw points as discs into a z-buffer, if finite and before the camera; `start` is the first index."""
    cells = buffer.width * buffer.height
    if points.size <= FEW_POINTS * cells:
        launch(draw_points_kernel, points.size, [points, view, splat, start, buffer])
        return
    if splat.scaled_radius == 0 and splat.radius <= 0.5:  # [cells] the disc is its center cell
        launch(mark_middles_kernel, points.size, [points, view, start, buffer])
        return
    middles = DepthBuffer(buffer.width, buffer.height, points.device)
    launch(mark_middles_kernel, points.size, [points, view, start, middles])
    launch(spread_middles_kernel, cells, [middles, splat, buffer])


def count_in_squares(points: Points, view: View) -> tuple[np.ndarray, np.ndarray]:
    """Counts of foremost points (estimated) and least depths of occupied squares: float64 on the host. Two syncs."""
    squares = -(-view.camera.width // SQUARE) * -(-view.camera.height // SQUARE)
    counts = zeros(squares, int32, points.device)
    nearest = full(squares, FAR_BITS, int32, points.device)
    stride = max(1, points.size // SAMPLE)
    launch(find_nearest_kernel, points.size // stride, [points, stride, view, nearest])
    launch(count_in_squares_kernel, points.size // stride, [points, stride, view, nearest, counts])
    occupancy = download(counts)  # sync
    depths = download(nearest).view(np.float32)  # sync
    return occupancy[occupancy > 0].astype(float) * stride, depths[occupancy > 0].astype(float)
