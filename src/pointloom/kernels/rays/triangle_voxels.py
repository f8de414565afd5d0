"""Voxels touched by triangles: exact separating-axis tests in float64 (Akenine-Moller, "Fast 3D Triangle-Box Overlap
Testing", Journal of Graphics Tools 6 (2001)). Triangles are split into voxel columns along the main axis of the normal.
One thread per column, a counting and a writing pass. Contact within a billionth of an edge counts.
"""

from collections.abc import Sequence

import numpy as np

from ..algebra.transform import widen
from ..array_types import Cells, Integers, Keys, LongIntegers, Points, Triangles
from ..arrays.prefix_sum import find_owner, scan_unread, total_of
from ..arrays.side_by_side import read_together
from ..arrays.unique import UniqueKeys
from ..lang import (
    Kernel,
    array,
    compute,
    cross,
    dot,
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
    vec3d,
    vec3i,
)
from ..memory import check_room, empty

# Fraction of a voxel added to the tested range: more than any rounding. The cells are then tested exactly.
CELL_MARGIN = 1.0e-3
# Fraction of half an edge added to the box against rounding. Sufficient for triangles of 10^6 voxels.
BOX_FACTOR = 1.0 + 1.0 / 1073741824.0
COLUMNS_EACH, MIN_COLUMNS, MAX_COLUMNS = 4, 1024, 2**22  # columns per triangle of the first visit, and limits
COLUMN_BYTES = 8
HIT_BYTES = 52  # key, sort buffers with positions, flags and runs
MAX_COUNT = 2**31 - 1


@struct
class VoxelFrame:
    """Voxel grid in vertex coordinates: corner `low`, edge `size`, `counts` per axis."""

    low: vec3d
    size: float64
    counts: vec3i

    def __init__(self, low: np.ndarray, size: float, counts: Sequence[int] | np.ndarray) -> None:
        self.low, self.size, self.counts = vec3d(*low), float(size), vec3i(*(int(count) for count in counts))

    def key_bits(self) -> int:
        return max(1, int(np.prod([int(count) for count in self.counts], dtype=object)).bit_length())


@func
def widened_corners(vertices: array(dtype=vec3), t: vec3i) -> tuple[vec3d, vec3d, vec3d]:
    return widen(vertices[t[0]]), widen(vertices[t[1]]), widen(vertices[t[2]])


@func
def cell_key(c: vec3i, counts: vec3i) -> int64:
    """Voxel number, ascending with x, then y, then z."""
    return (int64(c[0]) * int64(counts[1]) + int64(c[1])) * int64(counts[2]) + int64(c[2])


@func
def cell_at(x: float64, low: float64, size: float64, slack: float64, count: int) -> int:
    """Cell of a coordinate shifted by a fraction of a cell; -1 and `count` for all cells outside."""
    cell = floor((x - low) / size + slack)
    return int(min(max(cell, -1.0), float64(count)))


@func
def first_cells(a: vec3d, b: vec3d, c: vec3d, frame: VoxelFrame) -> vec3i:
    cells = vec3i(0, 0, 0)
    for k in range(3):
        x = min(a[k], min(b[k], c[k]))
        cells[k] = max(cell_at(x, frame.low[k], frame.size, -float64(CELL_MARGIN), frame.counts[k]), 0)
    return cells


@func
def last_cells(a: vec3d, b: vec3d, c: vec3d, frame: VoxelFrame) -> vec3i:
    cells = vec3i(0, 0, 0)
    for k in range(3):
        x = max(a[k], max(b[k], c[k]))
        cells[k] = min(cell_at(x, frame.low[k], frame.size, float64(CELL_MARGIN), frame.counts[k]), frame.counts[k] - 1)
    return cells


@func
def main_axis(normal: vec3d, a: vec3d, b: vec3d, c: vec3d) -> int:
    """Main axis of a normal. For a zero normal the longest axis of the box."""
    best = 0
    longest = float64(-1.0)
    has_normal = dot(normal, normal) > 0.0
    for k in range(3):
        extent = max(a[k], max(b[k], c[k])) - min(a[k], min(b[k], c[k]))
        if has_normal:
            extent = abs(normal[k])
        if extent > longest:
            longest = extent
            best = k
    return best


@kernel
def count_columns_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    frame: VoxelFrame,
    upright: int,
    counts: array(dtype=int32),
):
    """Count of voxel columns that each triangle may touch, or `upright` ones along z it may cross. At most 2^31 - 1."""
    i = tid()
    a, b, c = widened_corners(vertices, triangles[i])
    count = int64(0)
    if isfinite(a) and isfinite(b) and isfinite(c):
        low = first_cells(a, b, c, frame)
        high = last_cells(a, b, c, frame)
        axis = 2
        if upright == 0:
            axis = main_axis(cross(b - a, c - a), a, b, c)
        count = 1
        for k in range(3):
            wide = max(high[k] - low[k] + 1, 0)
            if k == axis:
                wide = max(min(wide, 1), upright)
            count *= int64(wide)
    counts[i] = int(min(count, 2147483647))


@func
def edge_parts(e: vec3d, u: vec3d, w: vec3d, half: float64) -> int:
    """1 if the cross product of an edge and a box axis separates them; `u` is on the edge, `w` the other corner."""
    apart = 0
    for k in range(3):
        j = (k + 1) % 3
        m = (k + 2) % 3
        p = e[m] * u[j] - e[j] * u[m]
        q = e[m] * w[j] - e[j] * w[m]
        radius = abs(e[m]) * half + abs(e[j]) * half
        if min(p, q) > radius or max(p, q) < -radius:
            apart = 1
    return apart


@func
def touches_box(a: vec3d, b: vec3d, c: vec3d, half: float64) -> int:
    """1 if a triangle touches the cube about zero with this half edge."""
    apart = 0
    for k in range(3):
        if min(a[k], min(b[k], c[k])) > half or max(a[k], max(b[k], c[k])) < -half:
            apart = 1
    if apart == 0:
        apart = max(edge_parts(b - a, a, c, half), max(edge_parts(c - b, b, a, half), edge_parts(a - c, c, b, half)))
    if apart == 0:
        n = cross(b - a, c - b)
        radius = half * (abs(n[0]) + abs(n[1]) + abs(n[2]))
        if abs(dot(n, a)) > radius:
            apart = 1
    return 1 - apart


@kernel
def visit_columns_kernel(
    vertices: array(dtype=vec3),
    triangles: array(dtype=vec3i),
    frame: VoxelFrame,
    columns: array(dtype=int32),
    is_writing: int,
    hits: array(dtype=int32),
    keys: array(dtype=int64),
):
    """Voxels of each column that its triangle touches: the count, or (writing) keys from `hits` on."""
    i = tid()
    count = columns[columns.shape[0] - 1]
    if is_writing == 0:
        hits[i] = 0
        if i >= count or count > hits.shape[0]:
            return
    owner = find_owner(columns, i)
    a, b, c = widened_corners(vertices, triangles[owner])
    low = first_cells(a, b, c, frame)
    high = last_cells(a, b, c, frame)
    n = cross(b - a, c - a)
    axis = main_axis(n, a, b, c)
    u = (axis + 1) % 3
    v = (axis + 2) % 3
    half = frame.size * 0.5
    rank = i - columns[owner]
    width = high[v] - low[v] + 1
    cell = vec3i(0, 0, 0)
    cell[u] = low[u] + rank // width
    cell[v] = low[v] + rank % width
    center = vec3d(0.0, 0.0, 0.0)
    center[u] = (frame.low[u] + half) + float64(cell[u]) * frame.size
    center[v] = (frame.low[v] + half) + float64(cell[v]) * frame.size
    begin = low[axis]
    end = high[axis]
    if dot(n, n) > 0.0:  # the plane intersects the column
        across = (n[u] * (center[u] - a[u]) + n[v] * (center[v] - a[v])) / n[axis]
        radius = half * (abs(n[u]) + abs(n[v])) / abs(n[axis])
        middle = a[axis] - across
        at_low = cell_at(middle - radius, frame.low[axis], frame.size, -float64(CELL_MARGIN), frame.counts[axis])
        at_high = cell_at(middle + radius, frame.low[axis], frame.size, float64(CELL_MARGIN), frame.counts[axis])
        begin = max(begin, at_low)
        end = min(end, at_high)
    hit_count = 0
    for k in range(begin, end + 1):
        center[axis] = (frame.low[axis] + half) + float64(k) * frame.size
        if touches_box(a - center, b - center, c - center, half * float64(BOX_FACTOR)) == 1:
            if is_writing == 1:
                cell[axis] = k
                keys[hits[i] + hit_count] = cell_key(cell, frame.counts)
            hit_count += 1
    if is_writing == 0:
        hits[i] = hit_count


@kernel
def decode_cells_kernel(keys: array(dtype=int64), counts: vec3i, cells: array(dtype=vec3i)):
    i = tid()
    key = keys[i]
    rest = key // int64(counts[2])
    cells[i] = vec3i(int(rest // int64(counts[1])), int(rest % int64(counts[1])), int(key % int64(counts[2])))


def check_total(count: int, what: str) -> None:
    """Raise if there are more results than 32 bits count."""
    if count > MAX_COUNT:
        raise ValueError(f"voxel_size: {count:,} {what} are more than 2^31 - 1; take larger voxels")


class Columns:
    """Voxel columns over triangles and their counts, from a kernel like `visit_columns_kernel`. On CUDA the first visit
    runs before the count is known, with estimated room. `arrays` are read by `read_counts`; `hit_count`: total.
    """

    def __init__(self, visit: Kernel, vertices: Points, triangles: Triangles, frame: VoxelFrame, upright: int) -> None:
        device, count = triangles.device, triangles.size
        counts = compute(count_columns_kernel, count, [vertices, triangles, frame, upright], int32, device)
        x, y, z = (int(number) for number in frame.counts)
        self._offsets, totals = scan_unread(counts, max(x * y, y * z, z * x))
        self._tallest = max(x, y, z)  # most hits of a column
        self._visit, self._given, self.device = visit, [vertices, triangles, frame, self._offsets], device
        self.arrays, self.is_complete = [totals], False
        if device.is_cuda and count:
            expected = MIN_COLUMNS + COLUMNS_EACH * (count + 2 * (x * y + y * z + z * x))
            self.arrays.append(self._count(min(MAX_COLUMNS, expected)))

    def _count(self, room: int) -> Integers | LongIntegers:
        self._room, hits = room, empty(room, int32, self.device)
        launch(self._visit, room, [*self._given, 0, hits, empty(1, int64, self.device)])
        self._offsets, totals = scan_unread(hits, self._tallest)
        return totals

    def take(self, totals: np.ndarray, hit_totals: np.ndarray | None) -> None:
        """Store the host values of `arrays`. Incomplete ones must be read again."""
        self._total = total_of(totals)
        check_total(self._total, "columns of voxels over all triangles")
        size = self._total * COLUMN_BYTES
        check_room(self.device, size, f"voxel_size: {self._total:,} columns of voxels over all triangles")
        self.is_complete = hit_totals is not None and self._total <= self._room
        if hit_totals is not None and self.is_complete:
            self.hit_count = total_of(hit_totals)
        else:
            self.arrays = [self.arrays[0], self._count(self._total)]

    def write(self) -> Keys:
        """Keys found by all visits, int64 device array."""
        keys = empty(self.hit_count, int64, self.device)
        launch(self._visit, self._total, [*self._given, 1, self._offsets, keys])
        return keys


def read_counts(columns: Sequence[Columns]) -> None:
    """Read the counts. One sync, rarely two. Raises ValueError for 2^31 columns, MemoryError without room."""
    left = list(columns)
    while left:
        values = iter(read_together([array for of in left for array in of.arrays]))  # sync
        for of in left:
            of.take(next(values), next(values) if len(of.arrays) > 1 else None)
        left = [of for of in left if not of.is_complete]


def touched_columns(vertices: Points, triangles: Triangles, frame: VoxelFrame) -> Columns:
    return Columns(visit_columns_kernel, vertices, triangles, frame, 0)


def touched_voxels(columns: Columns) -> Keys:
    """Keys of touched voxels, with repeats. Raises ValueError for 2^31 voxels, MemoryError without room."""
    check_total(columns.hit_count, "voxels of triangles")
    size = columns.hit_count * HIT_BYTES
    check_room(columns.device, size, f"voxel_size: {columns.hit_count:,} voxels of triangles")
    return columns.write()


def voxels_of(keys: Keys, frame: VoxelFrame) -> Cells:
    unique = UniqueKeys(keys, frame.key_bits()) if keys.size else None
    count = 0 if unique is None else unique.count
    cells = empty(count, vec3i, keys.device)
    if unique is not None:
        launch(decode_cells_kernel, count, [unique.keys, frame.counts, cells])
    return cells
