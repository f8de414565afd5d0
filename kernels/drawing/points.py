"""Points drawn into a z-buffer as round splats.

Few points: one thread a point visits the cells of its disc. Many: each point goes to the cell of its middle alone, in
a buffer of its own (12 B read a point, 8 B of one cell), and only the point that is foremost there is drawn as a disc.
The points left out lie behind a disc of the same or a larger size whose middle is in the same cell, so that at most a
sliver of a cell's width is lost; 20 points a cell then cost little more than one. A thread a cell draws these discs, so
that threads side by side write side by side.
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

MOST_RADIUS = 512.0  # [cells] of a disc: a point right before the camera does not take the time of all others
FEW_POINTS = 0.03125  # points a cell up to which each draws its own disc
SAMPLE = 1 << 18  # points that are looked at for a size that closes gaps
SQUARE = 32  # [cells] side of the squares that are counted in
LAYER = 1.04  # of the nearest depth in a square: what lies farther back belongs to another surface
FAR_BITS = 0x7F7F_FFFF  # of the largest float32


@struct
class Splat:
    """The size of discs [cells]: reach / depth, within bounds.

    Attributes:
        radius: The least.
        reach: [cells x units of depth].
        most: The most.
    """

    radius: float
    reach: float
    most: float

    def __init__(self, radius: float, reach: float = 0.0, most: float = MOST_RADIUS) -> None:
        self.radius, self.reach, self.most = radius, reach, most


@func
def radius_at(depth: float, splat: Splat) -> float:
    """The radius of a disc [cells]."""
    return min(max(splat.radius, splat.reach / depth), splat.most)


@func
def draw_disc(x: float, y: float, depth: float, index: int, splat: Splat, buffer: DepthBuffer):
    """Offer a disc's cells, the one of its middle in any case."""
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
def is_near_picture(p: vec3, reach: float, buffer: DepthBuffer) -> int:
    """1 for a projected point whose disc may touch the picture."""
    near = 0
    if p[0] > -reach - 1.0 and p[1] > -reach - 1.0:
        if p[0] < float(buffer.width) + reach and p[1] < float(buffer.height) + reach:
            near = 1
    return near


@kernel
def draw_points_kernel(points: array(dtype=vec3), view: View, splat: Splat, start: int, buffer: DepthBuffer):
    """Write the depth and index of each point to the cells of its disc."""
    i = tid()
    q = to_camera(points[i], view)
    if is_before(q) == 1:
        p = project(q, view)
        if is_near_picture(p, radius_at(p[2], splat), buffer) == 1:
            draw_disc(p[0], p[1], p[2], start + i, splat, buffer)


@kernel
def mark_middles_kernel(points: array(dtype=vec3), view: View, start: int, middles: DepthBuffer):
    """Write the depth and index of each point to the cell of its middle."""
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
    """Draw the discs of the points that are foremost in the cells of their middles, around these cells."""
    i = tid()
    word = middles.words[i]
    if word != int64(NO_KEY):
        column = i % buffer.width
        row = i // buffer.width
        radius = radius_at(key_number(word), splat)
        reach = int(radius)
        for other in range(max(row - reach, 0), min(row + reach + 1, buffer.height)):
            rise = float(other - row)
            half = int(sqrt(max(radius * radius - rise * rise, 0.0)))
            line = other * buffer.width
            for place in range(max(column - half, 0), min(column + half + 1, buffer.width)):
                if word < buffer.words[line + place]:
                    atomic_min(buffer.words, line + place, word)  # the least stays, in any order


@func
def square_of(q: vec3, view: View) -> int:
    """The square of the picture that a point of the camera's frame is seen in, or -1."""
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
    """The bits of the least depth in each square of the picture, of every so-many-th point."""
    i = tid()
    q = to_camera(points[i * stride], view)
    square = square_of(q, view)
    if square >= 0:
        # whichever comes first, the least stays
        atomic_min(nearest, square, float_bits(q[2]))


@kernel
def count_in_squares_kernel(
    points: array(dtype=vec3), stride: int, view: View, nearest: array(dtype=int32), counts: array(dtype=int32)
):
    """Count every so-many-th point in its square, where it is hardly behind the nearest there."""
    i = tid()
    q = to_camera(points[i * stride], view)
    square = square_of(q, view)
    if square >= 0:
        if q[2] <= LAYER * bits_float(nearest[square]):
            # whole numbers: the sum is the same in any order
            atomic_add(counts, square, 1)


def draw_points(points: Points, view: View, buffer: DepthBuffer, *, splat: Splat, start: int = 0) -> None:
    """Draw points as discs into a z-buffer.

    Args:
        points: Device array of vec3; what is not finite or behind the camera is left out.
        view: The View of these points.
        buffer: The DepthBuffer, of the view's size.
        splat: The Splat.
        start: The index of the first point in the buffer.
    """
    cells = buffer.width * buffer.height
    if points.size <= FEW_POINTS * cells:
        launch(draw_points_kernel, points.size, [points, view, splat, start, buffer])
        return
    if splat.reach == 0 and splat.radius <= 0.5:  # [cells] a disc is its middle
        launch(mark_middles_kernel, points.size, [points, view, start, buffer])
        return
    middles = DepthBuffer(buffer.width, buffer.height, points.device)
    launch(mark_middles_kernel, points.size, [points, view, start, middles])
    launch(spread_middles_kernel, cells, [middles, splat, buffer])


def count_in_squares(points: Points, view: View) -> tuple[np.ndarray, np.ndarray]:
    """About how many points of the foremost layer lie in each square of SQUARE x SQUARE cells of the picture.

    Returns:
        (counts, depths): float64 on the host, of squares that have any, and the least depth in each. Two syncs.
    """
    squares = -(-view.camera.width // SQUARE) * -(-view.camera.height // SQUARE)
    counts = zeros(squares, int32, points.device)
    nearest = full(squares, FAR_BITS, int32, points.device)
    stride = max(1, points.size // SAMPLE)
    launch(find_nearest_kernel, points.size // stride, [points, stride, view, nearest])
    launch(count_in_squares_kernel, points.size // stride, [points, stride, view, nearest, counts])
    found = download(counts)  # sync
    depths = download(nearest).view(np.float32)  # sync
    return found[found > 0].astype(float) * stride, depths[found > 0].astype(float)
