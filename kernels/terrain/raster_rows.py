"""Rows of a raster of numbers by cell: the northernmost row first, as files hold them.

One thread a value of the raster; sums are float64 and rounded once.
"""

from ..array_types import Doubles, Scalars
from ..lang import array, float32, float64, kernel, launch, tid
from ..memory import empty
from .cells import FixedCells


@kernel
def lay_rows_kernel(
    values: array(dtype=float64),
    below: array(dtype=float64),
    is_above: int,
    divisor: float64,
    base: float64,
    cells: FixedCells,
    out: array(dtype=float32),
):
    """A cell's value over the divisor, less what is below or above the base."""
    i = tid()
    row = i // cells.columns
    cell = (i - row * cells.columns) * cells.rows + (cells.rows - 1 - row)
    value = values[cell] / divisor
    if is_above != 0:
        value = value - below[cell]
    else:
        value = value + base
    out[i] = float32(value)


def lay_rows(
    values: Doubles, cells: FixedCells, *, below: Doubles | None = None, divisor: float = 1.0, base: float = 0.0
) -> Scalars:
    """The values of a raster, float32 device array [rows * columns].

    Args:
        values: A number a cell.
        cells: The window.
        below: What is taken from each; None adds the base.
        divisor: Of the values.
        base: Height of the points' origin.
    """
    out = empty(cells.size, float32, values.device)
    other = values if below is None else below
    launch(lay_rows_kernel, cells.size, [values, other, int(below is not None), divisor, base, cells, out])
    return out
