"""Octree cells over points by level, and those that remain to be tested.

Points are sorted by Morton code, so cells of each level are runs. A few passes over 8 B per point and level.
"""

import numpy as np

from ..array_types import Indices, Integers, Points
from ..arrays.bounds import bound_points
from ..arrays.prefix_sum import exclusive_scan, offsets_of, scan_together
from ..arrays.select import gather_rows
from ..arrays.sort import argsort_keys
from ..lang import array, atomic_max, compute, func, int32, int64, kernel, launch, tid, uint8, vec3
from ..memory import download, empty, zeros
from ..search.hilbert_order import spread_bits

OCTREE_LEVELS = 16  # 65,536 cells per axis


@kernel
def encode_cells_kernel(
    points: array(dtype=vec3), rows: array(dtype=int32), low: vec3, scale: float, codes: array(dtype=int64)
):
    i = tid()
    p = (points[rows[i]] - low) * scale
    top = float((1 << OCTREE_LEVELS) - 1)
    x = spread_bits(int(min(max(p[0], 0.0), top)))
    y = spread_bits(int(min(max(p[1], 0.0), top)))
    z = spread_bits(int(min(max(p[2], 0.0), top)))
    codes[i] = (x << 2) | (y << 1) | z


@kernel
def find_deepest_kernel(codes: array(dtype=int64), min_count: int, deepest: array(dtype=int32)):
    """Deepest level of a cell with enough points. The integer maximum does not depend on the order."""
    i = tid()
    differing = codes[i] ^ codes[i + min_count - 1]
    level = int(OCTREE_LEVELS)
    while differing != 0:
        differing = differing >> 3
        level = level - 1
    if level > deepest[0]:  # a stale value only adds an atomic
        atomic_max(deepest, 0, level)


@kernel
def mark_cells_kernel(codes: array(dtype=int64), shift: int64, marks: array(dtype=int32)):
    i = tid()
    mark = 1
    if i > 0:
        if (codes[i] >> shift) == (codes[i - 1] >> shift):
            mark = 0
    marks[i] = mark


@kernel
def start_cells_kernel(marks: array(dtype=int32), offsets: array(dtype=int32), starts: array(dtype=int32)):
    i = tid()
    if marks[i] == 1:
        starts[offsets[i]] = i
    if i + 1 == marks.shape[0]:
        starts[offsets[i + 1]] = i + 1


@func
def cell_of(marks: array(dtype=int32), offsets: array(dtype=int32), i: int) -> int:
    return offsets[i] + marks[i] - 1


@kernel
def find_covered_kernel(
    covered: array(dtype=uint8), marks: array(dtype=int32), offsets: array(dtype=int32), flat: array(dtype=int32)
):
    """1 for cells that contain a flat cell. All threads write the same value."""
    i = tid()
    if covered[i] != 0:
        atomic_max(flat, cell_of(marks, offsets, i), 1)


@kernel
def choose_cells_kernel(
    starts: array(dtype=int32),
    offsets: array(dtype=int32),
    flat: array(dtype=int32),
    min_count: int,
    chosen: array(dtype=int32),
):
    """1 for cells to test: enough points, and no flat cell within."""
    i = tid()
    wanted = 0
    if i < offsets[offsets.shape[0] - 1]:
        if starts[i + 1] - starts[i] >= min_count and flat[i] == 0:
            wanted = 1
    chosen[i] = wanted


@kernel
def number_cells_kernel(
    starts: array(dtype=int32), slots: array(dtype=int32), numbers: array(dtype=int32), counts: array(dtype=int32)
):
    """Number the selected cells (-1 for others) and count their points."""
    i = tid()
    number = -1
    if slots[i + 1] > slots[i]:
        number = slots[i]
        counts[number] = starts[i + 1] - starts[i]
    numbers[i] = number


@kernel
def mark_points_kernel(
    marks: array(dtype=int32), offsets: array(dtype=int32), numbers: array(dtype=int32), inside: array(dtype=int32)
):
    i = tid()
    is_inside = 0
    if numbers[cell_of(marks, offsets, i)] >= 0:
        is_inside = 1
    inside[i] = is_inside


@kernel
def list_points_kernel(
    marks: array(dtype=int32),
    offsets: array(dtype=int32),
    numbers: array(dtype=int32),
    points: array(dtype=int32),
    slots: array(dtype=int32),
    rows: array(dtype=int32),
    runs: array(dtype=int32),
):
    i = tid()
    if slots[i + 1] > slots[i]:
        rows[slots[i]] = points[i]
        runs[slots[i]] = numbers[cell_of(marks, offsets, i)]


@kernel
def cover_cells_kernel(
    marks: array(dtype=int32),
    offsets: array(dtype=int32),
    numbers: array(dtype=int32),
    flat: array(dtype=int32),
    names: array(dtype=int32),
    covered: array(dtype=uint8),
):
    """1 for all points of cells that are flat or contain a flat one."""
    i = tid()
    cell = cell_of(marks, offsets, i)
    if flat[cell] == 1:
        covered[i] = 1
    if numbers[cell] >= 0:
        if names[numbers[cell]] >= 0:
            covered[i] = 1


class Octree:
    """Octree cells over points by level, in a cube around them."""

    def __init__(self, points: Points, rows: Indices) -> None:
        low, high, _ = bound_points(gather_rows(points, rows))
        self.extent = float((high.astype(np.float64) - low).max())
        corner = 0.5 * (low.astype(np.float64) + high) - 0.5 * self.extent
        codes = empty(rows.size, int64, points.device)
        scale = 2**OCTREE_LEVELS / self.extent if self.extent > 1e-30 else 0.0
        launch(encode_cells_kernel, rows.size, [points, rows, vec3(*corner), scale, codes])
        self.codes, order = argsort_keys(codes, 3 * OCTREE_LEVELS)
        self.rows, self.device = gather_rows(rows, order), points.device
        self.covered = zeros(rows.size, uint8, self.device)

    def deepest(self, min_count: int) -> int:
        level = zeros(1, int32, self.device)
        launch(find_deepest_kernel, max(0, self.rows.size - min_count + 1), [self.codes, min_count, level])
        return int(download(level)[0])  # sync

    def runs(self, level: int, min_count: int) -> tuple[Integers, Integers, Integers] | None:
        """Points of cells to test on a level: (rows by cell, cell numbers, counts), or None. One sync."""
        count, device = self.rows.size, self.device
        self.marks = empty(count, int32, device)
        launch(mark_cells_kernel, count, [self.codes, 3 * (OCTREE_LEVELS - level), self.marks])
        if device.is_cuda:
            self.offsets, cells = offsets_of(self.marks), count
        else:
            self.offsets, cells = exclusive_scan(self.marks, largest=1)
        starts, chosen, self.numbers, counts = (empty(size, int32, device) for size in (cells + 1, cells, cells, cells))
        launch(start_cells_kernel, count, [self.marks, self.offsets, starts])
        self.flat = zeros(cells, int32, device)
        launch(find_covered_kernel, count, [self.covered, self.marks, self.offsets, self.flat])
        launch(choose_cells_kernel, cells, [starts, self.offsets, self.flat, min_count, chosen])
        slots = offsets_of(chosen)
        launch(number_cells_kernel, cells, [starts, slots, self.numbers, counts])
        inside = compute(mark_points_kernel, count, [self.marks, self.offsets, self.numbers], int32, device)
        (elements, (size,)), (_, (run_count,)) = scan_together([(inside, [count])], slots[cells:], largest=1)  # sync
        if not run_count:
            return None
        rows, runs = empty(size, int32, device), empty(size, int32, device)
        arguments = [self.marks, self.offsets, self.numbers, self.rows, elements, rows, runs]
        launch(list_points_kernel, count, arguments)
        return rows, runs, counts[:run_count]

    def cover(self, names: Integers | None) -> None:
        """Cover the tested cells of the last level with a name, int32 [r], and those that contain a flat cell."""
        if names is None:
            names = self.numbers  # without a tested cell
        arguments = [self.marks, self.offsets, self.numbers, self.flat, names, self.covered]
        launch(cover_cells_kernel, self.rows.size, arguments)
