"""Points drawn into a z-buffer as round splats.

Few points: one thread a point visits the cells of its disc. Many: each point goes to the cell of its middle alone, in
a buffer of its own (12 B read a point, 8 B of one cell), and only the point that is foremost there is drawn as a disc.
The points left out lie behind a disc of the same or a larger size whose middle is in the same cell, so that at most a
sliver of a cell's width is lost; 20 points a cell then cost little more than one. Discs of a few cells are drawn the
other way round: each cell looks for the foremost middle around it, without an atomic.
"""

import numpy as np

from ..arrays.packed_keys import NO_KEY, key_index, key_number, offer_cell
from ..lang import array, atomic_add, floor, func, int32, int64, kernel, launch, struct, tid, vec3
from ..memory import download, upload, zeros
from .z_buffer import DepthBuffer, View, is_before, project, to_camera

MOST_RADIUS = 512.0  # [cells] of a disc: a point right before the camera does not take the time of all others
MOST_GATHERED = 3.0  # [cells] radius up to which cells look for middles
FEW_POINTS = 0.03125  # points a cell up to which each draws its own disc
SAMPLE = 1 << 18  # points that are looked at for a size that closes gaps
SQUARE = 32  # [cells] side of the squares that are counted in


@struct
class Splat:
    """The size of discs: radius + reach / depth, in cells.

    Attributes:
        radius: [cells].
        reach: [cells x units of depth].
    """

    radius: float
    reach: float

    def __init__(self, radius, reach=0.0):
        self.radius, self.reach = radius, reach


@func
def radius_at(depth: float, splat: Splat) -> float:
    """The radius of a disc [cells]."""
    return min(splat.radius + splat.reach / depth, MOST_RADIUS)


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
    near = int(0)
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
def gather_middles_kernel(middles: DepthBuffer, halves: array(dtype=int32), buffer: DepthBuffer):
    """Give each cell the foremost of the middles within a disc around it, whose rows have these half widths."""
    i = tid()
    column = i % buffer.width
    row = i // buffer.width
    reach = halves.shape[0] // 2
    best = buffer.words[i]
    for k in range(max(reach - row, 0), min(reach + buffer.height - row, halves.shape[0])):
        line = (row + k - reach) * buffer.width
        half = halves[k]
        for other in range(max(column - half, 0), min(column + half + 1, buffer.width)):
            best = min(best, middles.words[line + other])
    buffer.words[i] = best


@kernel
def spread_middles_kernel(
    middles: DepthBuffer, points: array(dtype=vec3), view: View, splat: Splat, start: int, buffer: DepthBuffer
):
    """Draw the discs of the points that are foremost in the cells of their middles."""
    i = tid()
    word = middles.words[i]
    if word != int64(NO_KEY):
        p = project(to_camera(points[key_index(word) - start], view), view)
        draw_disc(p[0], p[1], key_number(word), key_index(word), splat, buffer)


@kernel
def count_in_squares_kernel(points: array(dtype=vec3), stride: int, view: View, wide: int, counts: array(dtype=int32)):
    """Count every so-many-th point in its square of the picture."""
    i = tid()
    q = to_camera(points[i * stride], view)
    if is_before(q) == 1:
        p = project(q, view)
        column = int(floor(p[0] + 0.5))
        row = int(floor(p[1] + 0.5))
        if column >= 0 and row >= 0 and column < view.camera.width and row < view.camera.height:
            # whole numbers: the sum is the same in any order
            atomic_add(counts, (row // SQUARE) * wide + column // SQUARE, 1)


def draw_points(points, view, buffer, *, splat, start=0):
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
    if splat.reach == 0 and splat.radius <= MOST_GATHERED:
        rows = np.arange(-int(splat.radius), int(splat.radius) + 1)
        halves = upload(np.floor(np.sqrt(splat.radius**2 - rows**2)).astype(np.int32), int32, points.device)
        launch(gather_middles_kernel, cells, [middles, halves, buffer])
        return
    launch(spread_middles_kernel, cells, [middles, points, view, splat, start, buffer])


def count_in_squares(points, view):
    """About how many points lie in each square of SQUARE x SQUARE cells of the picture; float64 on the host (sync)."""
    wide, high = -(-view.camera.width // SQUARE), -(-view.camera.height // SQUARE)
    counts = zeros(wide * high, int32, points.device)
    stride = max(1, points.size // SAMPLE)
    launch(count_in_squares_kernel, points.size // stride, [points, stride, view, wide, counts])
    return download(counts).astype(float) * stride  # sync
