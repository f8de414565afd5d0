"""Ground filter (SMRF, as `segmentation/ground.py`) whose result depends only on points within a finite radius.

On cells with a fixed origin, with these changes: gaps are filled from up to `levels` coarse levels with few relaxation
passes, so wider gaps stay unknown. Unknown cells are ignored by openings. Each window opens the original surface (up to
some corner cells the same); beyond the outermost points the surface continues as at a gap.
"""

import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ..array_types import Bytes, Mask, Points, Scalars
from ..lang import (
    INFINITY,
    array,
    atomic_min,
    compute,
    float32,
    float64,
    floor,
    func,
    isfinite,
    kernel,
    launch,
    sqrt,
    tid,
    uint8,
    vec3,
)
from ..memory import clone, empty, full, zeros
from ..segmentation.ground import (
    DILATION_SIGN,
    EROSION_SIGN,
    LOW_RADIUS,
    LOW_SLOPE,
    average_cells_kernel,
    clear_cells_kernel,
    filter_along,
    flag_steps,
    segments_of,
)
from .cells import FixedCells, column_of, row_of_cell

SMALL_SPRINGS = (2, 2)  # passes per level, from the finest, before the openings
SPRINGS_PER_LEVEL = (2, 2, 2)  # for the ground. Coarser levels have none


@kernel
def keep_lowest_kernel(points: array(dtype=vec3), cells: FixedCells, heights: array(dtype=float32)):
    """Lowest point of each cell (atomic minimum)."""
    i = tid()
    p = points[i]
    if isfinite(p):
        atomic_min(heights, column_of(p[0], cells) * cells.rows + row_of_cell(p[1], cells), p[2])


@kernel
def spread_cells_kernel(
    known: array(dtype=float32), coarse: array(dtype=float32), columns: int, rows: int, heights: array(dtype=float32)
):
    """Known heights; elsewhere the bilinear mean of known coarse cells."""
    i = tid()
    height = known[i]
    if not isfinite(height):
        x = i // rows
        y = i % rows
        coarse_rows = rows // 2
        total = 0.0
        weights = 0.0
        for a in range(2):
            u = x // 2 + a * (2 * (x % 2) - 1)  # the parent coarse cell, then its neighbor
            for b in range(2):
                v = y // 2 + b * (2 * (y % 2) - 1)
                if u >= 0 and v >= 0 and u < columns // 2 and v < coarse_rows:
                    other = coarse[u * coarse_rows + v]
                    if isfinite(other):
                        weight = (0.75 - 0.5 * float(a)) * (0.75 - 0.5 * float(b))
                        total += weight * other
                        weights += weight
        height = total / weights  # NaN for 0 / 0
    heights[i] = height


@kernel
def relax_cells_kernel(
    known: array(dtype=float32), heights: array(dtype=float32), columns: int, rows: int, out: array(dtype=float32)
):
    """Set filled cells to the mean of their known neighbors."""
    i = tid()
    height = known[i]
    if not isfinite(height):
        height = heights[i]
        if isfinite(height):
            total = 0.0
            count = 0.0
            for side in range(4):
                x = i // rows + (side // 2) * (2 * (side % 2) - 1)
                y = i % rows + (1 - side // 2) * (2 * (side % 2) - 1)
                if x >= 0 and y >= 0 and x < columns and y < rows:
                    other = heights[x * rows + y]
                    if isfinite(other):
                        total += other
                        count += 1.0
            if count > 0.0:
                height = total / count
    out[i] = height


@kernel
def pass_over_kernel(heights: array(dtype=float32), value: float, out: array(dtype=float32)):
    """Replace missing heights by a neutral value."""
    i = tid()
    height = heights[i]
    if not isfinite(height):
        height = value
    out[i] = height


@kernel
def grade_cells_kernel(
    heights: array(dtype=float32), columns: int, rows: int, cell: float, slopes: array(dtype=float32)
):
    """Slope of each cell from known neighbors. 0 without any."""
    i = tid()
    slopes[i] = sqrt(
        squared_grade(heights, i, rows, i // rows, columns, cell) + squared_grade(heights, i, 1, i % rows, rows, cell)
    )


@func
def squared_grade(heights: array(dtype=float32), i: int, step: int, index: int, size: int, cell: float) -> float:
    below = i
    above = i
    if index > 0:
        if isfinite(heights[i - step]):
            below = i - step
    if index < size - 1:
        if isfinite(heights[i + step]):
            above = i + step
    grade = 0.0
    if above > below:
        grade = (heights[above] - heights[below]) / (cell * float((above - below) // step))
    if not isfinite(grade):
        grade = 0.0
    return grade * grade


@func
def height_at(heights: array(dtype=float32), a: int, b: int, s: float, t: float, columns: int, rows: int) -> float:
    """Bilinear mean of the known of four cells; s and t from the center of cell (a, b)."""
    total = 0.0
    weights = 0.0
    for k in range(4):
        x = a + k // 2
        y = b + k % 2
        if x >= 0 and y >= 0 and x < columns and y < rows:
            height = heights[x * rows + y]
            if isfinite(height):
                weight = abs(1.0 - float(k // 2) - s) * abs(1.0 - float(k % 2) - t)
                total += weight * height
                weights += weight
    return total / weights


@kernel
def mask_near_kernel(
    points: array(dtype=vec3),
    cells: FixedCells,
    heights: array(dtype=float32),
    slopes: array(dtype=float32),
    threshold: float,
    scaling: float,
    mask: array(dtype=uint8),
):
    """1 for points close to the ground, depending on slope."""
    i = tid()
    p = points[i]
    ground = 0
    if isfinite(p):
        x = (float64(p[0]) - cells.x0) / cells.cell - 0.5  # from the grid origin, so that all windows agree
        y = (float64(p[1]) - cells.y0) / cells.cell - 0.5
        s = float(x - floor(x))
        t = float(y - floor(y))
        a = int(floor(x) - cells.column0)
        b = int(floor(y) - cells.row0)
        height = height_at(heights, a, b, s, t, cells.columns, cells.rows)
        if isfinite(height):
            slope = height_at(slopes, a, b, s, t, cells.columns, cells.rows)
            if abs(p[2] - height) <= threshold + scaling * slope:
                ground = 1
    mask[i] = uint8(ground)


def levels_of(radius: int) -> int:
    """Coarse levels that fill what a window of this radius [cells] may remove."""
    return max(len(SPRINGS_PER_LEVEL), math.ceil(math.log2(1.5 * radius)))


def fill_radius(levels: int, springs: tuple[int, ...]) -> int:
    """Cells per side that affect a filled cell: at level k coarse cells 2 * 2^k, each relaxation pass 2^k more."""
    return 2 * (2**levels - 1) + sum(count << level for level, count in enumerate(springs))


def radius_in_cells(radius: int) -> int:
    """Cells per side that affect a point's classification, through all fillings, openings, slope and interpolation."""
    small = fill_radius(len(SMALL_SPRINGS), SMALL_SPRINGS)
    return 2 * small + 2 * LOW_RADIUS + 2 * radius + fill_radius(levels_of(radius), SPRINGS_PER_LEVEL) + 2


def window_over(low: np.ndarray, high: np.ndarray, radius: int) -> tuple[np.ndarray, np.ndarray]:
    """First cell and shape of the sufficient window around cells `low` to `high`."""
    small, levels = fill_radius(len(SMALL_SPRINGS), SMALL_SPRINGS), levels_of(radius)
    rim = max(fill_radius(levels, SPRINGS_PER_LEVEL) + 2, 2 * radius + 2 * small + 2 * LOW_RADIUS + 2)
    first = np.floor((low - rim) / 2**levels) * 2**levels
    return first, (np.floor((high + rim) / 2**levels) + 1) * 2**levels - first


class NearGround:
    """Ground surface on a window of a grid."""

    def __init__(self, points: Points, cells: FixedCells, radius: int) -> None:
        """Start from the lowest finite point of each cell of a `window_over` window."""
        self.points, self.cells, self.radius, self.device = points, cells, radius, points.device
        self.lowest = full(cells.size, INFINITY, float32, self.device)
        launch(keep_lowest_kernel, points.size, [points, cells, self.lowest])

    def masks(self, slopes: Sequence[float], threshold: float, scaling: float) -> list[Mask]:
        """uint8 (n) for each slope: 1 for ground points; parameters as of `classify_ground`."""
        cells, unwanted = self.cells, zeros(self.cells.size, uint8, self.device)
        surface = self._filled(unwanted, len(SMALL_SPRINGS), SMALL_SPRINGS)
        closed = self.open_by(surface, LOW_RADIUS, DILATION_SIGN)
        flag_steps(surface, closed, LOW_SLOPE * cells.cell, DILATION_SIGN, unwanted)
        surface = self._filled(unwanted, len(SMALL_SPRINGS), SMALL_SPRINGS)
        before, flags = surface, [unwanted, *(clone(unwanted) for _ in slopes[1:])]
        for radius in range(1, self.radius + 1):
            opened = self.open_by(surface, radius, EROSION_SIGN)
            for slope, flagged in zip(slopes, flags, strict=True):
                flag_steps(before, opened, slope * radius * cells.cell, EROSION_SIGN, flagged)
            before = opened
        return [self._mask(flagged, threshold, scaling) for flagged in flags]

    def _mask(self, unwanted: Bytes, threshold: float, scaling: float) -> Mask:
        cells = self.cells
        heights = self._filled(unwanted, levels_of(self.radius), SPRINGS_PER_LEVEL)
        slopes = empty(cells.size, float32, self.device)
        launch(grade_cells_kernel, cells.size, [heights, cells.columns, cells.rows, cells.cell, slopes])
        mask = empty(self.points.size, uint8, self.device)
        launch(mask_near_kernel, self.points.size, [self.points, cells, heights, slopes, threshold, scaling, mask])
        return mask

    def _filled(self, unwanted: Bytes, levels: int, springs: tuple[int, ...]) -> Scalars:
        """Lowest heights where not unwanted, elsewhere filled."""
        columns, rows = self.cells.columns, self.cells.rows
        known = [(empty(self.cells.size, float32, self.device), columns, rows)]
        launch(clear_cells_kernel, self.cells.size, [unwanted, self.lowest, known[0][0]])
        for level in range(1, levels + 1):
            shape = (columns >> level, rows >> level)
            known.append((empty(shape[0] * shape[1], float32, self.device), *shape))
        for (fine, wide, high), (coarse, _, _) in pairwise(known):
            launch(average_cells_kernel, coarse.size, [fine, wide, high, coarse])
        filled = known[-1][0]
        for level in range(levels - 1, -1, -1):
            own, wide, high = known[level]
            heights = compute(spread_cells_kernel, own.size, [own, filled, wide, high], float32, self.device)
            for _ in range(springs[level] if level < len(springs) else 0):
                pulled = compute(relax_cells_kernel, own.size, [own, heights, wide, high], float32, self.device)
                heights = pulled
            filled = heights
        return filled

    def open_by(self, heights: Scalars, radius: int, first: float) -> Scalars:
        """Opening (EROSION_SIGN first) or closing (DILATION_SIGN first) by octagons, ignoring unknown cells."""
        for side in (first, -first):
            known = compute(pass_over_kernel, self.cells.size, [heights, side * INFINITY], float32, self.device)
            heights = filter_along(known, self.cells.columns, self.cells.rows, segments_of(radius), side)
        return heights
