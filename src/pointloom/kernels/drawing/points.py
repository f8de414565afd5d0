"""Points as round splats in a z-buffer. With many points, only the foremost point per center cell is drawn as a disc,
at a loss of at most a sliver of a cell, so 20 points per cell cost little more than one.
"""

import numpy as np

from ..array_types import Points
from ..arrays.packed_keys import NO_KEY, key_number, offer_cell, pack_key
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
    vector,
)
from ..memory import download, full, zeros
from .z_buffer import DepthBuffer, View, is_before, project, to_camera

MAX_RADIUS = 512.0  # [cells] limits the time of a disc right in front of the camera
FEW_POINTS = 0.03125  # points per cell up to which each draws its own disc
MAX_SAMPLE_POINTS = 1 << 18  # points sampled to find the size that closes gaps
SQUARE_SIDE = 32  # [cells] of the counting squares
MAX_DEPTH_RATIO = 1.04  # of the nearest depth in a square: farther points belong to another surface
POINTS_PER_THREAD = 8
CELLS_PER_THREAD = 32  # which a CPU compares at once
MAX_GATHERED = 4.0  # [cells] radius up to which cells look for the points around them
eight_cells, eight_keys = vector(8, int32), vector(8, int64)
words_of_thread = vector(32, int64)
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
def mark_middles_kernel(points: array(dtype=vec3), threads: int, view: View, start: int, middles: DepthBuffer):
    """Mark the center cells of points i, i + threads, ... A loop of its own reads the cells, so the reads overlap."""
    i = tid()
    cells = eight_cells(-1)
    keys = eight_keys(int64(NO_KEY))
    for k in range(POINTS_PER_THREAD):
        j = i + k * threads
        if j < points.shape[0]:
            q = to_camera(points[j], view)
            p = project(q, view)
            column = int(floor(p[0] + 0.5))
            row = int(floor(p[1] + 0.5))
            if column >= 0 and row >= 0 and column < middles.width and row < middles.height and is_before(q) == 1:
                cells[k] = row * middles.width + column
                keys[k] = pack_key(p[2], start + j)
    for k in range(POINTS_PER_THREAD):
        cells[k] = cells[k] if keys[k] < middles.words[max(cells[k], 0)] else -1
    for k in range(POINTS_PER_THREAD):
        if cells[k] >= 0:
            atomic_min(middles.words, cells[k], keys[k])  # minimum: order-independent


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
def least_around(up: int, down: int, left: int, right: int, words: array(dtype=int64)) -> int64:
    return min(min(words[up + left], words[up + right]), min(words[down + left], words[down + right]))


@kernel
def gather_middles_kernel(middles: DepthBuffer, radius: float, buffer: DepthBuffer):
    """As `spread_middles_kernel` for discs of one radius: each cell takes the foremost point around it. A thread takes
    LANES cells of a row. Clamped rows and columns are nearer ones of the disc."""
    i = tid()
    groups = (buffer.width + CELLS_PER_THREAD - 1) // CELLS_PER_THREAD
    first = (i % groups) * CELLS_PER_THREAD
    row = i // groups
    last = buffer.width - 1
    nearest = words_of_thread(int64(NO_KEY))
    for rise in range(int(radius) + 1):
        up = max(row - rise, 0) * buffer.width
        down = min(row + rise, buffer.height - 1) * buffer.width
        half = int(sqrt(radius * radius - float(rise * rise)))
        inside = first >= half and first + CELLS_PER_THREAD - 1 + half <= last
        for shift in range(half + 1):
            if inside:
                for lane in range(CELLS_PER_THREAD):
                    left = first + lane - shift
                    nearest[lane] = min(nearest[lane], least_around(up, down, left, left + 2 * shift, middles.words))
            else:
                for lane in range(CELLS_PER_THREAD):
                    left = min(max(first + lane - shift, 0), last)
                    right = min(first + lane + shift, last)
                    nearest[lane] = min(nearest[lane], least_around(up, down, left, right, middles.words))
    for lane in range(min(CELLS_PER_THREAD, last + 1 - first)):
        cell = row * buffer.width + first + lane
        buffer.words[cell] = min(buffer.words[cell], nearest[lane])


@func
def square_of(q: vec3, view: View) -> int:
    """Image square of a camera-frame point, or -1."""
    square = -1
    if is_before(q) == 1:
        p = project(q, view)
        column = int(floor(p[0] + 0.5))
        row = int(floor(p[1] + 0.5))
        if column >= 0 and row >= 0 and column < view.camera.width and row < view.camera.height:
            square = (row // SQUARE_SIDE) * (
                (view.camera.width + SQUARE_SIDE - 1) // SQUARE_SIDE
            ) + column // SQUARE_SIDE
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
        if q[2] <= MAX_DEPTH_RATIO * bits_float(nearest[square]):
            atomic_add(counts, square, 1)  # integer sum: order-independent


def mark_middles(points: Points, view: View, start: int, middles: DepthBuffer) -> None:
    """Mark the center cells of points; `start` is the first index."""
    threads = -(-points.size // POINTS_PER_THREAD)
    launch(mark_middles_kernel, threads, [points, threads, view, start, middles])


def draw_points(points: Points, view: View, buffer: DepthBuffer, *, splat: Splat, start: int = 0) -> None:
    """Draw points as discs into a z-buffer, if finite and before the camera; `start` is the first index."""
    cells = buffer.width * buffer.height
    if points.size <= FEW_POINTS * cells:
        launch(draw_points_kernel, points.size, [points, view, splat, start, buffer])
        return
    if splat.scaled_radius == 0 and splat.radius <= 0.5:  # [cells] the disc is its center cell
        mark_middles(points, view, start, buffer)
        return
    middles = DepthBuffer(buffer.width, buffer.height, points.device)
    mark_middles(points, view, start, middles)
    if not points.device.is_cuda and splat.scaled_radius == 0 and splat.radius <= MAX_GATHERED:
        gather_middles(middles, splat.radius, buffer)
    else:
        launch(spread_middles_kernel, cells, [middles, splat, buffer])


def gather_middles(middles: DepthBuffer, radius: float, buffer: DepthBuffer) -> None:
    """Draw discs of one `radius` around their center cells without atomics, which suits the vectors of a CPU."""
    threads = buffer.height * -(-buffer.width // CELLS_PER_THREAD)
    launch(gather_middles_kernel, threads, [middles, float(radius), buffer])


def count_in_squares(points: Points, view: View) -> tuple[np.ndarray, np.ndarray]:
    """Counts of foremost points (estimated) and least depths of occupied squares: float64 on the host. Two syncs."""
    squares = -(-view.camera.width // SQUARE_SIDE) * -(-view.camera.height // SQUARE_SIDE)
    counts = zeros(squares, int32, points.device)
    nearest = full(squares, FAR_BITS, int32, points.device)
    stride = max(1, points.size // MAX_SAMPLE_POINTS)
    launch(find_nearest_kernel, points.size // stride, [points, stride, view, nearest])
    launch(count_in_squares_kernel, points.size // stride, [points, stride, view, nearest, counts])
    occupancy = download(counts)  # sync
    depths = download(nearest).view(np.float32)  # sync
    return occupancy[occupancy > 0].astype(float) * stride, depths[occupancy > 0].astype(float)
