"""Ground segmentation by a simple morphological filter (SMRF) on a grid of lowest points.

Pingel, Clarke and McBride, ISPRS Journal 77, 2013, after Zhang et al., IEEE TGRS 41, 2003. Octagonal windows are built
from segments by tripling: 8 log2(r) + 12 reads per cell. Gaps are filled by spring interpolation from coarse to fine.
28 B per cell.
"""

import math
from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np

from ..array_types import Bytes, Mask, Points, Scalars
from ..arrays.prefix_sum import sum_each
from ..lang import (
    INFINITY,
    NAN,
    array,
    atomic_min,
    float32,
    float64,
    floor,
    func,
    int32,
    isfinite,
    kernel,
    launch,
    record,
    replay,
    sqrt,
    struct,
    tid,
    uint8,
    vec3,
)
from ..memory import clone, copy, empty, full, zeros

EROSION_SIGN, DILATION_SIGN = 1.0, -1.0
LOW_RADIUS, LOW_SLOPE = 1, 5.0  # a cell five times deeper than wide is a stray return, as in the paper
SPRING_PASSES = 16  # passes per level: a hole of 36 cells in a slope is then filled to 0.6 of a cell's rise
DIAGONAL_FRACTION = 1 - math.sqrt(0.5)  # half length of the diagonal segments of a regular octagon of inner radius 1


@struct
class Cells:
    """Grid of cells with lowest corner and cell size [m]. Cell (x, y) has index x * rows + y."""

    x0: float64
    y0: float64
    cell: float64
    columns: int
    rows: int

    def __init__(self, corner: np.ndarray, cell: float, columns: int, rows: int) -> None:
        self.x0, self.y0, self.cell = float(corner[0]), float(corner[1]), float(cell)
        self.columns, self.rows = columns, rows


@kernel
def keep_lowest_kernel(points: array(dtype=vec3), cells: Cells, heights: array(dtype=float32)):
    """Lowest point of each cell. The minimum does not depend on the order."""
    i = tid()
    p = points[i]
    if isfinite(p):
        x = int(floor((float64(p[0]) - cells.x0) / cells.cell))
        y = int(floor((float64(p[1]) - cells.y0) / cells.cell))
        atomic_min(heights, x * cells.rows + y, p[2])


@kernel
def clear_cells_kernel(unwanted: array(dtype=uint8), heights: array(dtype=float32), out: array(dtype=float32)):
    """Heights, NaN for empty or unwanted cells."""
    i = tid()
    height = heights[i]
    if unwanted[i] != 0 or not isfinite(height):
        height = float(NAN)
    out[i] = height


@kernel
def average_cells_kernel(heights: array(dtype=float32), columns: int, rows: int, coarse: array(dtype=float32)):
    """Mean of the known cells under each coarse cell. NaN if none."""
    i = tid()
    coarse_rows = (rows + 1) // 2
    x = 2 * (i // coarse_rows)
    y = 2 * (i % coarse_rows)
    total = 0.0
    count = 0.0
    for a in range(x, min(x + 2, columns)):
        for b in range(y, min(y + 2, rows)):
            height = heights[a * rows + b]
            if isfinite(height):
                total += height
                count += 1.0
    coarse[i] = total / count


@func
def clamp_cell(x: float, size: int) -> float:
    return min(max(x, 0.0), float(size - 1))


@func
def interpolate(heights: array(dtype=float32), columns: int, rows: int, x: float, y: float) -> float:
    """Bilinear height at a position in cells. Cell centers are integers."""
    u = clamp_cell(x, columns)
    v = clamp_cell(y, rows)
    a = min(int(u), max(columns - 2, 0))
    b = min(int(v), max(rows - 2, 0))
    s = u - float(a)
    t = v - float(b)
    c = min(a + 1, columns - 1)
    d = min(b + 1, rows - 1)
    low = heights[a * rows + b] * (1.0 - t) + heights[a * rows + d] * t
    high = heights[c * rows + b] * (1.0 - t) + heights[c * rows + d] * t
    return low * (1.0 - s) + high * s


@kernel
def fill_cells_kernel(
    known: array(dtype=float32), coarse: array(dtype=float32), columns: int, rows: int, heights: array(dtype=float32)
):
    i = tid()
    height = known[i]
    if not isfinite(height):
        x = 0.5 * float(i // rows) - 0.25
        y = 0.5 * float(i % rows) - 0.25
        height = interpolate(coarse, (columns + 1) // 2, (rows + 1) // 2, x, y)
    heights[i] = height


@kernel
def pull_cells_kernel(
    known: array(dtype=float32), heights: array(dtype=float32), columns: int, rows: int, out: array(dtype=float32)
):
    """Replace unknown cells by the mean of their neighbors. The edge repeats the cell itself."""
    i = tid()
    height = known[i]
    if not isfinite(height):
        x = i // rows
        y = i % rows
        left = heights[max(x - 1, 0) * rows + y]
        right = heights[min(x + 1, columns - 1) * rows + y]
        below = heights[x * rows + max(y - 1, 0)]
        above = heights[x * rows + min(y + 1, rows - 1)]
        height = 0.25 * ((left + right) + (below + above))
    out[i] = height


@kernel
def filter_along_kernel(
    heights: array(dtype=float32),
    columns: int,
    rows: int,
    dx: int,
    dy: int,
    distance: int,
    side: float,
    out: array(dtype=float32),
):
    """Minimum (side 1) or maximum (side -1) of each cell and the two at `distance` along a direction. Extremes of
    segments of half length h become those of h + distance (distance <= 2 h + 1). Beyond the grid: the last cell."""
    i = tid()
    x = i // rows
    y = i % rows
    before = distance
    after = distance
    if dx != 0:
        before = min(before, x)
        after = min(after, columns - 1 - x)
    if dy > 0:
        before = min(before, y)
        after = min(after, rows - 1 - y)
    if dy < 0:
        before = min(before, rows - 1 - y)
        after = min(after, y)
    step = dx * rows + dy
    extreme = min(side * heights[i - before * step], side * heights[i + after * step])
    out[i] = side * min(extreme, side * heights[i])


@kernel
def flag_steps_kernel(
    heights: array(dtype=float32), opened: array(dtype=float32), limit: float, side: float, flags: array(dtype=uint8)
):
    i = tid()
    if side * (heights[i] - opened[i]) > limit:
        flags[i] = 1


@kernel
def grade_cells_kernel(
    heights: array(dtype=float32), columns: int, rows: int, cell: float, slopes: array(dtype=float32)
):
    i = tid()
    x = i // rows
    y = i % rows
    a = max(x - 1, 0)
    b = min(x + 1, columns - 1)
    c = max(y - 1, 0)
    d = min(y + 1, rows - 1)
    gx = (heights[b * rows + y] - heights[a * rows + y]) / (cell * float(max(b - a, 1)))
    gy = (heights[x * rows + d] - heights[x * rows + c]) / (cell * float(max(d - c, 1)))
    slopes[i] = sqrt(gx * gx + gy * gy)


@kernel
def mask_ground_kernel(
    points: array(dtype=vec3),
    cells: Cells,
    heights: array(dtype=float32),
    slopes: array(dtype=float32),
    threshold: float,
    scaling: float,
    mask: array(dtype=uint8),
):
    i = tid()
    p = points[i]
    ground = 0
    if isfinite(p):
        x = float((float64(p[0]) - cells.x0) / cells.cell - 0.5)
        y = float((float64(p[1]) - cells.y0) / cells.cell - 0.5)
        distance = abs(p[2] - interpolate(heights, cells.columns, cells.rows, x, y))
        if distance <= threshold + scaling * interpolate(slopes, cells.columns, cells.rows, x, y):
            ground = 1
    mask[i] = uint8(ground)


@kernel
def compare_masks_kernel(
    points: array(dtype=vec3),
    mask: array(dtype=uint8),
    other: array(dtype=uint8),
    outside: array(dtype=int32),
    changed: array(dtype=int32),
):
    i = tid()
    is_outside = 0
    is_changed = 0
    if mask[i] == 0 and isfinite(points[i]):
        is_outside = 1
        is_changed = int(other[i])
    outside[i] = is_outside
    changed[i] = is_changed


def compare_masks(points: Points, mask: Mask, other: Mask) -> list[int]:
    """Numbers of finite points outside a mask, and of those among them that are in the other mask. One sync."""
    counts = [empty(points.size, int32, points.device) for _ in range(2)]
    launch(compare_masks_kernel, points.size, [points, mask, other, *counts])
    return sum_each(*counts)  # sync


class HeightGrid:
    """Heights (float32, y fastest; NaN or inf if unknown): lowest points, then the ground."""

    def __init__(self, points: Points, corner: np.ndarray, cell: float, columns: int, rows: int) -> None:
        """Lowest finite point of each cell. All points must be in the grid."""
        self.points, self.device = points, points.device
        self.cells = Cells(corner, cell, columns, rows)
        self.cell, self.columns, self.rows, self.size = float(cell), columns, rows, columns * rows
        self.heights = full(self.size, INFINITY, float32, self.device)
        launch(keep_lowest_kernel, points.size, [points, self.cells, self.heights])

    def uncover(self, slopes: Sequence[float], max_window: float) -> list[Scalars]:
        """Ground for each slope: a window of radius r <= max_window [m] removes heights above slope * r."""
        unwanted = zeros(self.size, uint8, self.device)
        fill_gaps, surface = self.prepare_filling(unwanted)
        fill_gaps()
        opened = self.open_by(surface, LOW_RADIUS, DILATION_SIGN)
        flag_steps(surface, opened, LOW_SLOPE * self.cell, DILATION_SIGN, unwanted)
        fill_gaps()
        bare, flags = surface, [unwanted, *(clone(unwanted) for _ in slopes[1:])]
        # Radius grows by one cell: growth by a third would remove at once what slopes of 60% rise to, including
        # ridges.
        for radius in range(1, math.ceil(max_window / self.cell) + 1):
            opened = self.open_by(surface, radius, EROSION_SIGN)
            for slope, flagged in zip(slopes, flags, strict=True):
                flag_steps(surface, opened, slope * radius * self.cell, EROSION_SIGN, flagged)
            surface = opened
        grounds = []
        for flagged in flags:
            if flagged is not unwanted:
                copy(unwanted, flagged, count=self.size)
            fill_gaps()
            grounds.append(bare if len(slopes) == 1 else clone(bare))
        return grounds

    def near(self, ground: Scalars, threshold: float, scaling: float) -> Mask:
        """uint8 [n]: 1 for points closer to the ground than the threshold [m] plus scaling times the slope."""
        slopes = empty(self.size, float32, self.device)
        launch(grade_cells_kernel, self.size, [ground, self.columns, self.rows, self.cell, slopes])
        mask = empty(self.points.size, uint8, self.device)
        arguments = [self.points, self.cells, ground, slopes, threshold, scaling, mask]
        launch(mask_ground_kernel, self.points.size, arguments)
        return mask

    def prepare_filling(self, unwanted: Bytes) -> tuple[Callable[[], None], Scalars]:
        """A reusable function that fills unknown and unwanted cells by springs, and its output; recorded on a GPU."""
        levels = [(empty(self.size, float32, self.device), self.columns, self.rows)]
        while levels[-1][1] * levels[-1][2] > 1:
            columns, rows = (levels[-1][1] + 1) // 2, (levels[-1][2] + 1) // 2
            levels.append((empty(columns * rows, float32, self.device), columns, rows))
        spare = [[empty(known.size, float32, self.device) for _ in range(2)] for known, _, _ in levels[:-1]]

        def fill() -> None:
            launch(clear_cells_kernel, self.size, [unwanted, self.heights, levels[0][0]])
            for (fine, columns, rows), (coarse, _, _) in pairwise(levels):
                launch(average_cells_kernel, coarse.size, [fine, columns, rows, coarse])
            filled = levels[-1][0]
            for (known, columns, rows), (heights, pulled) in zip(levels[-2::-1], spare[::-1], strict=True):
                launch(fill_cells_kernel, known.size, [known, filled, columns, rows, heights])
                for _ in range(SPRING_PASSES):  # an even number, so that the heights end in the original array
                    launch(pull_cells_kernel, known.size, [known, heights, columns, rows, pulled])
                    heights, pulled = pulled, heights
                filled = heights

        filled = spare[0][0] if spare else levels[0][0]
        if not self.device.is_cuda:
            return fill, filled
        recorded = record(self.device, fill)

        def fill_again(_keeps_the_arrays: Callable[[], None] = fill) -> None:
            replay(recorded)

        return fill_again, filled

    def open_by(self, heights: Scalars, radius: int, first: float) -> Scalars:
        """Open (first EROSION_SIGN) or close (first DILATION_SIGN) heights by an octagon."""
        segments = segments_of(radius)
        filtered = filter_along(heights, self.columns, self.rows, segments, first)
        return filter_along(filtered, self.columns, self.rows, segments[::-1], -first)


def segments_of(radius: int) -> list[tuple[int, int, int]]:
    """Directions and half lengths of the segments whose sum is an octagon."""
    diagonal = int(DIAGONAL_FRACTION * radius + 0.5)
    straight = radius - 2 * diagonal
    return [(1, 0, straight), (0, 1, straight), (1, 1, diagonal), (1, -1, diagonal)]


def filter_along(
    heights: Scalars, columns: int, rows: int, segments: list[tuple[int, int, int]], side: float
) -> Scalars:
    """Minimum (side 1) or maximum (side -1) over a sum of segments."""
    for dx, dy, half in segments:
        for distance in pass_distances(half):
            out = empty(heights.size, float32, heights.device)
            launch(filter_along_kernel, heights.size, [heights, columns, rows, dx, dy, distance, side, out])
            heights = out
    return heights


def flag_steps(heights: Scalars, opened: Scalars, limit: float, side: float, flags: Mask) -> None:
    launch(flag_steps_kernel, heights.size, [heights, opened, limit, side, flags])


def pass_distances(half: int) -> list[int]:
    """Distances of successive passes for a segment of this half length. Each triples it."""
    steps, length = [], 0
    while length < half:
        steps.append(min(2 * length + 1, half - length))
        length += steps[-1]
    return steps
