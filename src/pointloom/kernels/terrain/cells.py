"""Grids of square cells with a fixed origin, and the points of each cell. Cell (x, y) of a window is number x * rows +
y. One float64 division locates a point, so all windows agree. Points of a cell keep their order.
"""

from typing import Any

import numpy as np

from ..array_types import Array1, Doubles, Points
from ..arrays.key_starts import find_key_starts
from ..arrays.sort import SortKeys, put_key
from ..lang import (
    NAN,
    array,
    compute,
    float32,
    float64,
    floor,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    struct,
    tid,
    vec3,
    vector,
)
from ..memory import empty

MAX_NUMBER = 2.0**48  # of a cell: its size is then still 32 float64 steps
CELL_MAX, CELL_MIN, CELL_COUNT, CELL_MEAN = 0, 1, 2, 3
moments = vector(10, float64)  # count, means u v z, sums of products of deviations uu uv vv uz vz zz


@struct
class FixedCells:
    """Grid window: grid origin `x0`, `y0`; `cell` size. Lowest cell `column0`, `row0`; `columns`, `rows`."""

    x0: float64
    y0: float64
    cell: float64
    column0: float64
    row0: float64
    columns: int
    rows: int

    def __init__(self, corner: np.ndarray, cell: float, first: np.ndarray, shape: np.ndarray) -> None:
        self.x0, self.y0, self.cell = float(corner[0]), float(corner[1]), float(cell)
        self.column0, self.row0 = float(first[0]), float(first[1])
        self.columns, self.rows = int(shape[0]), int(shape[1])

    @property
    def size(self) -> int:
        return self.columns * self.rows


def check_cell_numbers(first: np.ndarray, shape: np.ndarray) -> None:
    """Raise ValueError if more than 2^48 cells are between the origin and the window."""
    if not (np.abs(np.concatenate([first, first + shape])) < MAX_NUMBER).all():
        raise ValueError("corner: is more than 2^48 cells away from the points; take one that is nearer")


@func
def column_of(x: float32, cells: FixedCells) -> int:
    return int(floor((float64(x) - cells.x0) / cells.cell) - cells.column0)


@func
def row_of_cell(y: float32, cells: FixedCells) -> int:
    return int(floor((float64(y) - cells.y0) / cells.cell) - cells.row0)


@kernel
def encode_cells_kernel(points: array(dtype=vec3), cells: FixedCells, skipped: int64, keys: SortKeys):
    """Cell number of each point; `skipped` for points outside or not finite."""
    i = tid()
    p = points[i]
    key = skipped
    if isfinite(p):
        x = floor((float64(p[0]) - cells.x0) / cells.cell) - cells.column0
        y = floor((float64(p[1]) - cells.y0) / cells.cell) - cells.row0
        if x >= 0.0 and y >= 0.0 and x < float64(cells.columns) and y < float64(cells.rows):
            key = int64(x) * int64(cells.rows) + int64(y)
    put_key(i, key, keys)


@struct
class CellGroups:
    """Points of each cell of a window: `points` vec3 (n); `order` int32 (n), stable; `starts` int32 (cells + 1)."""

    points: array(dtype=vec3)
    order: array(dtype=int32)
    starts: array(dtype=int32)

    def __init__(self, points: Points, cells: FixedCells) -> None:
        self.points, self.cells = points, cells
        keys = SortKeys(points.size, points.device)
        launch(encode_cells_kernel, points.size, [points, cells, cells.size, keys])
        sorted_keys, self.order = keys.sort(cells.size.bit_length())
        self.starts = empty(cells.size + 1, int32, points.device)
        find_key_starts(sorted_keys, self.starts)

    def measure(self, values: Doubles, kind: int) -> Doubles:
        """CELL_MAX, CELL_MIN, CELL_COUNT or CELL_MEAN of finite values per cell, float64. NaN (count 0) if empty."""
        return compute(measure_cells_kernel, self.cells.size, [self, values, kind], float64, self.points.device)

    def moments(self) -> Array1[Any]:
        """Moments of the points of each cell, vector of 10 float64. u and v are in cells from the cell's center."""
        return compute(measure_moments_kernel, self.cells.size, [self, self.cells], moments, self.points.device)


@kernel
def measure_cells_kernel(groups: CellGroups, values: array(dtype=float64), kind: int, out: array(dtype=float64)):
    i = tid()
    first = groups.starts[i]
    end = groups.starts[i + 1]
    total = float64(0.0)
    count = float64(0.0)
    if kind == CELL_COUNT:
        total = float64(end - first)
    elif first == end:
        total = float64(NAN)
    else:
        if kind != CELL_MEAN:
            total = values[groups.order[first]]
        for at in range(first, end):
            value = values[groups.order[at]]
            if kind == CELL_MAX:
                total = max(total, value)
            elif kind == CELL_MIN:
                total = min(total, value)
            elif isfinite(value):
                total += value
                count += 1.0
        if kind == CELL_MEAN:
            total = total / count
    out[i] = total


@kernel
def measure_moments_kernel(groups: CellGroups, cells: FixedCells, out: array(dtype=moments)):
    i = tid()
    first = groups.starts[i]
    end = groups.starts[i + 1]
    x = cells.column0 + float64(i // cells.rows) + 0.5
    y = cells.row0 + float64(i % cells.rows) + 0.5
    found = moments(0.0)
    for at in range(first, end):
        p = groups.points[groups.order[at]]
        found[1] += (float64(p[0]) - cells.x0) / cells.cell - x
        found[2] += (float64(p[1]) - cells.y0) / cells.cell - y
        found[3] += float64(p[2])
    count = float64(end - first)
    found[0] = count
    for k in range(1, 4):
        found[k] = found[k] / max(count, float64(1.0))
    for at in range(first, end):
        p = groups.points[groups.order[at]]
        u = (float64(p[0]) - cells.x0) / cells.cell - x - found[1]
        v = (float64(p[1]) - cells.y0) / cells.cell - y - found[2]
        z = float64(p[2]) - found[3]
        found[4] += u * u
        found[5] += u * v
        found[6] += v * v
        found[7] += u * z
        found[8] += v * z
        found[9] += z * z
    out[i] = found


@kernel
def take_heights_kernel(points: array(dtype=vec3), heights: array(dtype=float64)):
    i = tid()
    heights[i] = float64(points[i][2])


def heights_of(points: Points) -> Doubles:
    """Heights of points about their origin, float64 device array (n)."""
    return compute(take_heights_kernel, points.size, [points], float64, points.device)
