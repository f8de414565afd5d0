"""Grid of square map cells, aligned with a fixed corner, of limited size."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ...kernels.terrain.cells import check_cell_numbers
from ...pcd.raster_cells import MAX_CELLS, cells_over, cells_within

MAX_ALONG = 2**24  # cells per side: rows are processed completely
CELL_BYTES = 9  # per cell: color, height, fill flag
LENGTH_DIGITS = 2  # significant digits of a proposed length
MAX_PRINTED_NUMBER = 1e12  # largest number printed with all digits

Array = NDArray[np.float64]
Cells = tuple[Array, Array]  # first cell along x and y, and counts


@dataclass(frozen=True, eq=False)
class PlanGrid:
    """Square cells: low corner (2,), edge `cell`, and `shape` (rows, columns)."""

    corner: Array
    cell: float
    shape: tuple[int, int]


def grid_over(low: Array, high: Array, corner: Array, cell: float) -> PlanGrid:
    """Half-open cells over a range, both ends included. ValueError for too many cells, or too far from the corner."""
    return _grid_of(partial(cells_over, low, high, corner), corner, cell)


def grid_within(box: Array, corner: Array, cell: float) -> PlanGrid:
    """Cells of a box (x0, y0, x1, y1) that ends at or within cells."""
    return _grid_of(partial(cells_within, box.reshape(2, 2) - corner), corner, cell)


def _grid_of(cells_of: Callable[[float], Cells], corner: Array, cell: float) -> PlanGrid:
    with np.errstate(over="ignore", invalid="ignore"):  # overflow means too many cells
        first, counts = cells_of(cell)
        if not _fits(counts):
            columns, rows, gigabytes = map(_counted, (*counts, counts[0] * counts[1] * CELL_BYTES / 1e9))
            raise ValueError(
                f"cell: {cell:g} gives {columns} x {rows} cells, {gigabytes} GB; expected at most 2^28; "
                f"{_what_fits(cells_of, cell, counts)}, or use smaller bounds"
            )
    check_cell_numbers(first, counts)
    return PlanGrid(corner + first * cell, cell, (int(counts[1]), int(counts[0])))


def _fits(counts: Array) -> bool:
    return bool(counts[0] * counts[1] <= MAX_CELLS and counts.max() <= MAX_ALONG)


def _what_fits(cells_of: Callable[[float], Cells], cell: float, counts: Array) -> str:
    """Rounded cell size that gives few enough cells, as text."""
    larger = cell
    for _ in range(8):  # the first fits, except for a cell at the border
        fraction = max(math.sqrt(float(counts[0])) * math.sqrt(float(counts[1]) / MAX_CELLS), counts.max() / MAX_ALONG)
        if not math.isfinite(larger * fraction):
            break
        larger = _rounded_up(larger * max(fraction, 1.001))
        counts = cells_of(larger)[1]
        if _fits(counts):
            return f"a cell of {larger:g} fits"
    return "use larger cells"


def _counted(number: float) -> str:
    return f"{number:,.0f}" if number < MAX_PRINTED_NUMBER else f"{number:.1e}"


def _rounded_up(length: float) -> float:
    step = 10.0 ** (math.floor(math.log10(length)) + 1 - LENGTH_DIGITS)
    return math.ceil(length / step) * step
