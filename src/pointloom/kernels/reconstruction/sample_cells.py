"""Oriented points summed into the cells of a repeatedly halved cube: counts, means and normals.

Level d has 2^d cells per axis. A cell's code is the Morton code of its position: `code & 7` is its corner in its parent
(x + 2 y + 4 z), `code >> 3` the parent's code. One thread per cell sums in a fixed order: bitwise reproducible. 40 B
per cell and level, and 20 B per point while the codes are sorted.
"""

import numpy as np

from ..algebra.transform import narrow, widen
from ..array_types import Indices, LongIntegers, Points, Vectors
from ..arrays.bounds import bound_points
from ..arrays.prefix_sum import exclusive_scan, offsets_of
from ..arrays.select import positions_of
from ..arrays.sort import argsort_keys
from ..lang import (
    NAN,
    array,
    atomic_add,
    compute,
    float32,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    length,
    struct,
    tid,
    uint8,
    vec3,
    vec3d,
)
from ..memory import download, empty, zeros
from ..search.hilbert_order import spread_bits
from ..segmentation.octree_cells import mark_cells_kernel

MAX_DEPTH = 20  # three bits per level in 63 bits, and room for a carry
COUNT_ROWS = 64  # of results: a million atomics at one address would be serialized


@struct
class Cube:
    """The root cube: lowest corner [m] relative to the cloud's origin, edge [m], and 1 / edge."""

    corner: vec3d
    side: float64
    scale: float64

    def __init__(self, corner: np.ndarray, side: float) -> None:
        self.corner, self.side, self.scale = vec3d(*corner), float(side), 1.0 / float(side)


@func
def position_in_cube(p: vec3, cube: Cube) -> vec3d:
    return (widen(p) - cube.corner) * cube.scale


@kernel
def mark_samples_kernel(
    points: array(dtype=vec3), normals: array(dtype=vec3), mask: array(dtype=uint8), samples: array(dtype=vec3)
):
    """Mark finite points with a finite, nonzero normal, and replace all others by NaN."""
    i = tid()
    size = length(widen(normals[i]))
    usable = 0
    p = vec3(NAN, NAN, NAN)
    if isfinite(points[i]) and isfinite(size) and size > 0.0:
        usable = 1
        p = points[i]
    mask[i] = uint8(usable)
    samples[i] = p


@kernel
def encode_samples_kernel(
    points: array(dtype=vec3), rows: array(dtype=int32), cube: Cube, depth: int, codes: array(dtype=int64)
):
    i = tid()
    x = position_in_cube(points[rows[i]], cube)
    cells = float64(1 << depth)
    top = cells - 1.0
    cx = spread_bits(int(min(max(x[0] * cells, 0.0), top)))
    cy = spread_bits(int(min(max(x[1] * cells, 0.0), top)))
    cz = spread_bits(int(min(max(x[2] * cells, 0.0), top)))
    codes[i] = cx | (cy << 1) | (cz << 2)


@kernel
def count_cells_kernel(codes: array(dtype=int64), depth: int, counts: array(dtype=int32)):
    """Count each sorted code at the coarsest level on which it begins a cell. Sums, so the order does not matter."""
    i = tid()
    level = 0
    if i > 0:
        for above in range(depth + 1):
            shift = int64(3 * (depth - above))
            if (codes[i] >> shift) == (codes[i - 1] >> shift):
                level += 1
    if level <= depth:
        atomic_add(counts, (i % COUNT_ROWS) * (MAX_DEPTH + 1) + level, 1)


@kernel
def begin_cells_kernel(
    codes: array(dtype=int64),
    shift: int64,
    heads: array(dtype=int32),
    offsets: array(dtype=int32),
    cells: array(dtype=int64),
    starts: array(dtype=int32),
    parents: array(dtype=int32),
):
    """Code and first member of each cell. The cell of each member."""
    i = tid()
    cell = offsets[i] + heads[i] - 1
    parents[i] = cell
    if heads[i] == 1:
        cells[cell] = codes[i] >> shift
        starts[cell] = i
    if i + 1 == codes.shape[0]:
        starts[cell + 1] = i + 1


@kernel
def sum_samples_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    rows: array(dtype=int32),
    order: array(dtype=int32),
    cube: Cube,
    by_length: int,
    starts: array(dtype=int32),
    counts: array(dtype=float32),
    means: array(dtype=vec3),
    sums: array(dtype=vec3),
    weights: array(dtype=float32),
):
    """Counts, means, summed unit normals, and weights of the cells on the finest level."""
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    normal = vec3d(0.0, 0.0, 0.0)
    weight = float64(0.0)
    for j in range(starts[i], starts[i + 1]):
        row = rows[order[j]]
        total = total + position_in_cube(points[row], cube)
        n = widen(normals[row])
        size = length(n)
        fraction = float64(1.0)
        if by_length == 1:
            fraction = size
        normal = normal + n * (fraction / size)
        weight = weight + fraction
    count = starts[i + 1] - starts[i]
    counts[i] = float(count)
    means[i] = narrow(total * (1.0 / float64(count)))
    sums[i] = narrow(normal)
    weights[i] = float(weight)


@kernel
def sum_children_kernel(
    starts: array(dtype=int32),
    child_counts: array(dtype=float32),
    child_means: array(dtype=vec3),
    child_sums: array(dtype=vec3),
    child_weights: array(dtype=float32),
    counts: array(dtype=float32),
    means: array(dtype=vec3),
    sums: array(dtype=vec3),
    weights: array(dtype=float32),
):
    i = tid()
    total = vec3d(0.0, 0.0, 0.0)
    normal = vec3d(0.0, 0.0, 0.0)
    count = float64(0.0)
    weight = float64(0.0)
    for j in range(starts[i], starts[i + 1]):
        size = float64(child_counts[j])
        total = total + widen(child_means[j]) * size
        normal = normal + widen(child_sums[j])
        count = count + size
        weight = weight + float64(child_weights[j])
    counts[i] = float(count)
    means[i] = narrow(total * (1.0 / count))
    sums[i] = narrow(normal)
    weights[i] = float(weight)


@struct
class SampleCells:
    """Occupied cells of a level by code: `starts` of children, `parents`, `means` in the cube, `sums` of normals."""

    codes: array(dtype=int64)
    starts: array(dtype=int32)
    parents: array(dtype=int32)
    counts: array(dtype=float32)
    means: array(dtype=vec3)
    sums: array(dtype=vec3)
    weights: array(dtype=float32)

    def __init__(self, members: LongIntegers, shift: int, count: int | None) -> None:
        """Cells of sorted, shifted codes. One sync if `count` is None."""
        device, n = members.device, members.size
        heads = compute(mark_cells_kernel, n, [members, shift], int32, device)
        if count is None:
            offsets, self.count = exclusive_scan(heads, largest=1)  # sync
        else:
            offsets, self.count = offsets_of(heads), count
        self.codes, self.starts = empty(self.count, int64, device), empty(self.count + 1, int32, device)
        self.of_members, self.parents = empty(n, int32, device), None
        launch(begin_cells_kernel, n, [members, shift, heads, offsets, self.codes, self.starts, self.of_members])
        self.counts, self.weights = empty(self.count, float32, device), empty(self.count, float32, device)
        self.means, self.sums = empty(self.count, vec3, device), empty(self.count, vec3, device)


def bound_samples(points: Points, normals: Vectors) -> tuple[Indices, np.ndarray, np.ndarray]:
    """(rows, low, high): int32 rows of valid oriented points and their box, infinite if none. One sync."""
    mask, samples = empty(points.size, uint8, points.device), empty(points.size, vec3, points.device)
    launch(mark_samples_kernel, points.size, [points, normals, mask, samples])
    low, high, count = bound_points(samples)  # sync
    return positions_of(mask, count), low, high


def sample_rows(points: Points, normals: Vectors) -> Indices:
    """Rows with a finite point and a finite, nonzero normal, ascending (one sync)."""
    return bound_samples(points, normals)[0]


def count_cells(codes: LongIntegers, depth: int) -> list[int | None]:
    """Cells per level 0 .. depth (one sync). None on the CPU, where each level's scan counts."""
    device = codes.device
    if not device.is_cuda:
        return [None] * (depth + 1)
    counts = zeros(COUNT_ROWS * (MAX_DEPTH + 1), int32, device)
    launch(count_cells_kernel, codes.size, [codes, depth, counts])
    begun = download(counts).reshape(COUNT_ROWS, -1).sum(axis=0)  # sync
    return np.cumsum(begun[: depth + 1]).tolist()


def gather_samples(
    points: Points, normals: Vectors, rows: Indices, cube: Cube, depth: int, by_length: bool = False
) -> list[SampleCells]:
    """Occupied cells of levels 0 .. depth as a list of SampleCells. `by_length` weights samples by normal length."""
    device, n = points.device, rows.size
    codes = compute(encode_samples_kernel, n, [points, rows, cube, depth], int64, device)
    codes, order = argsort_keys(codes, max(1, 3 * depth))
    counts = count_cells(codes, depth)  # sync
    level = SampleCells(codes, 0, counts[depth])
    out = [level.counts, level.means, level.sums, level.weights]
    launch(sum_samples_kernel, level.count, [points, normals, rows, order, cube, int(by_length), level.starts, *out])
    levels = [level]
    for above in range(depth - 1, -1, -1):
        below = levels[-1]
        level = SampleCells(below.codes, 3, counts[above])
        below.parents = level.of_members
        inputs = [level.starts, below.counts, below.means, below.sums, below.weights]
        launch(sum_children_kernel, level.count, [*inputs, level.counts, level.means, level.sums, level.weights])
        levels.append(level)
    levels[-1].parents = empty(0, int32, device)
    return levels[::-1]
