"""The cells of an octree over points, level by level, and which of them are still to be tested for something.

Points are sorted by the code of their cell on the finest level, three bits a level, so the cells of each level are
runs of that order. One sort, then a few passes over 8 B a point for each level.
"""

import numpy as np

from ..array_types import Indices, Integers, Points
from ..arrays.bounds import bound_points
from ..arrays.prefix_sum import exclusive_scan
from ..arrays.select import gather_rows, positions_of
from ..arrays.sort import argsort_keys
from ..lang import array, atomic_max, func, int32, int64, kernel, launch, tid, uint8, vec3
from ..memory import download, empty, full, zeros
from ..search.hilbert_order import spread_bits

LEVELS = 16  # 65,536 cells an axis


@kernel
def encode_cells_kernel(
    points: array(dtype=vec3), rows: array(dtype=int32), low: vec3, scale: float, codes: array(dtype=int64)
):
    """The cell of each point on the finest level, three bits a level."""
    i = tid()
    p = (points[rows[i]] - low) * scale
    top = float((1 << LEVELS) - 1)
    x = spread_bits(int(min(max(p[0], 0.0), top)))
    y = spread_bits(int(min(max(p[1], 0.0), top)))
    z = spread_bits(int(min(max(p[2], 0.0), top)))
    codes[i] = (x << 2) | (y << 1) | z


@kernel
def find_deepest_kernel(codes: array(dtype=int64), fewest: int, deepest: array(dtype=int32)):
    """The deepest level of a cell with enough points; the maximum of whole numbers is the same in any order."""
    i = tid()
    differing = codes[i] ^ codes[i + fewest - 1]
    level = int(LEVELS)
    while differing != 0:
        differing = differing >> 3
        level = level - 1
    atomic_max(deepest, 0, level)


@kernel
def mark_cells_kernel(codes: array(dtype=int64), shift: int64, marks: array(dtype=int32), heads: array(dtype=uint8)):
    """1 where a cell begins."""
    i = tid()
    mark = 1
    if i > 0:
        if (codes[i] >> shift) == (codes[i - 1] >> shift):
            mark = 0
    marks[i] = mark
    heads[i] = uint8(mark)


@func
def cell_of(marks: array(dtype=int32), offsets: array(dtype=int32), i: int) -> int:
    """The number of the cell that holds the i-th point."""
    return offsets[i] + marks[i] - 1


@kernel
def find_covered_kernel(
    covered: array(dtype=uint8), marks: array(dtype=int32), offsets: array(dtype=int32), flat: array(dtype=int32)
):
    """1 for cells with a flat cell within them; all threads write the same."""
    i = tid()
    if covered[i] != 0:
        atomic_max(flat, cell_of(marks, offsets, i), 1)


@func
def count_points(starts: array(dtype=int32), count: int, cell: int) -> int:
    """How many of `count` points lie in a cell."""
    end = count
    if cell + 1 < starts.shape[0]:
        end = starts[cell + 1]
    return end - starts[cell]


@kernel
def choose_cells_kernel(
    starts: array(dtype=int32), count: int, flat: array(dtype=int32), fewest: int, mask: array(dtype=uint8)
):
    """1 for cells to test: enough points, and none within them is flat."""
    i = tid()
    size = count_points(starts, count, i)
    chosen = 0
    if size >= fewest and flat[i] == 0:
        chosen = 1
    mask[i] = uint8(chosen)


@kernel
def number_cells_kernel(
    cells: array(dtype=int32),
    starts: array(dtype=int32),
    count: int,
    numbers: array(dtype=int32),
    counts: array(dtype=int32),
):
    """Number the chosen cells, and count their points."""
    i = tid()
    cell = cells[i]
    numbers[cell] = i
    counts[i] = count_points(starts, count, cell)


@kernel
def number_points_kernel(
    marks: array(dtype=int32),
    offsets: array(dtype=int32),
    numbers: array(dtype=int32),
    runs: array(dtype=int32),
    mask: array(dtype=uint8),
):
    """The number of each point's chosen cell, -1 for none; and 1 where there is one."""
    i = tid()
    number = numbers[cell_of(marks, offsets, i)]
    runs[i] = number
    inside = 0
    if number >= 0:
        inside = 1
    mask[i] = uint8(inside)


@kernel
def cover_cells_kernel(
    marks: array(dtype=int32),
    offsets: array(dtype=int32),
    numbers: array(dtype=int32),
    flat: array(dtype=int32),
    passed: array(dtype=int32),
    covered: array(dtype=uint8),
):
    """1 for all points of cells that are flat or hold a flat one."""
    i = tid()
    cell = cell_of(marks, offsets, i)
    if flat[cell] == 1:
        covered[i] = 1
    if numbers[cell] >= 0:
        if passed[numbers[cell]] == 1:
            covered[i] = 1


class Octree:
    """The cells of an octree over some points, level by level; its box is a cube about theirs."""

    def __init__(self, points: Points, rows: Indices) -> None:
        low, high, _ = bound_points(gather_rows(points, rows))
        self.extent = float((high.astype(np.float64) - low).max())
        corner = 0.5 * (low.astype(np.float64) + high) - 0.5 * self.extent
        codes = empty(rows.size, int64, points.device)
        scale = 2**LEVELS / self.extent if self.extent > 1e-30 else 0.0
        launch(encode_cells_kernel, rows.size, [points, rows, vec3(*corner), scale, codes])
        self.codes, order = argsort_keys(codes, 3 * LEVELS)
        self.rows, self.device = gather_rows(rows, order), points.device
        self.covered = zeros(rows.size, uint8, self.device)

    def deepest(self, fewest: int) -> int:
        """The deepest level with a cell of at least so many points; 0 where there is none."""
        level = zeros(1, int32, self.device)
        launch(find_deepest_kernel, max(0, self.rows.size - fewest + 1), [self.codes, fewest, level])
        return int(download(level)[0])  # sync

    def runs(self, level: int, fewest: int) -> tuple[Integers, Integers, np.ndarray] | None:
        """The points of the cells of a level that are to be tested: (rows, runs, counts); None where there are none.

        Rows and runs are int32 device arrays, the points by cell and the number of the cell of each; counts is a NumPy
        array, the points of each cell.
        """
        count, device = self.rows.size, self.device
        self.marks, heads = empty(count, int32, device), empty(count, uint8, device)
        launch(mark_cells_kernel, count, [self.codes, 3 * (LEVELS - level), self.marks, heads])
        self.offsets, cell_count = exclusive_scan(self.marks)
        starts = positions_of(heads)
        self.flat, mask = zeros(cell_count, int32, device), empty(cell_count, uint8, device)
        launch(find_covered_kernel, count, [self.covered, self.marks, self.offsets, self.flat])
        launch(choose_cells_kernel, cell_count, [starts, count, self.flat, fewest, mask])
        cells = positions_of(mask)
        self.numbers = full(cell_count, -1, int32, device)
        counts = empty(cells.size, int32, device)
        launch(number_cells_kernel, cells.size, [cells, starts, count, self.numbers, counts])
        runs, inside = empty(count, int32, device), empty(count, uint8, device)
        launch(number_points_kernel, count, [self.marks, self.offsets, self.numbers, runs, inside])
        if cells.size == 0:
            return None
        elements = positions_of(inside)
        runs = gather_rows(runs, elements)
        return gather_rows(self.rows, elements), runs, download(counts)  # sync

    def cover(self, passed: Integers) -> None:
        """Take note which of the tested cells are flat; their ancestors are not tested."""
        arguments = [self.marks, self.offsets, self.numbers, self.flat, passed, self.covered]
        launch(cover_cells_kernel, self.rows.size, arguments)
