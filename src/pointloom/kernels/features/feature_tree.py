"""Bounding-box tree over rows of many dimensions (features, descriptors).

Rows are rotated to their principal axes and stored as 16 coordinates: 15 leading axes and the residual length. Since |
|a| - |b| | <= |a - b|, these give a lower bound of the distance. Order by sort-tile-recursive slabs over four axes
(Leutenegger, Lopez and Edgington, "STR: a simple and efficient algorithm for R-tree packing", ICDE 1997). Pruning is
exact (`limit_of` in feature_matching.py). Memory 4 d + 200 B per row.
"""

import numpy as np

from ..algebra.plain_min_max import larger, smaller
from ..array_types import Array2, Indices
from ..arrays.concatenation import concatenate_rows
from ..arrays.select import positions_of
from ..arrays.sort import argsort_keys
from ..lang import (
    INFINITY,
    array,
    atomic_max,
    compute,
    float32,
    float64,
    float_bits,
    func,
    int32,
    int64,
    kernel,
    launch,
    sqrt,
    struct,
    tid,
    uint8,
    vector,
)
from ..memory import download, empty, upload, zeros

LEADING_AXES = 15  # principal axes
ROW_AXES = 16  # plus the residual length. With 9, three times as many rows need full comparisons
BOX_AXES = 6  # axes of a box: 9 would visit 10 % fewer groups in the same time
ROWS_PER_GROUP = 16  # rows stored interleaved
FAN_OUT = 16  # children of a node
NUMBERS_PER_NODE = 2 * BOX_AXES * FAN_OUT  # numbers of child boxes: low per axis, then high
NUMBERS_PER_STEP = 8  # numbers of a row summed in parallel
LARGEST_NUMBER = 1.0e15  # its squares can be summed in float32. Rows with larger numbers are excluded
SAMPLED_ROWS = 512  # rows per side for the axes
SORTED_AXES = 4  # axes that rows are sorted along
SLAB_RATIO = 1.6  # ratio of slab counts along successive axes: the first ones separate best
POWER_STEPS = 3  # power iterations per axis. More do not pay off
MIN_INDEPENDENT_LENGTH = 1.0e-3  # minimum independent component of a vector that becomes an axis
MIN_DIVISOR = 1.0e-300  # replaces zero divisors
MAX_NUMBERS = 2**31 - 1  # of one array

axes = vector(16, float32)
leading = vector(15, float64)
boxed = vector(6, float32)


@struct
class FeatureRows:
    """Usable `rows` of `features`, float32 (n, d): without NaN, infinity and numbers beyond LARGEST_NUMBER."""

    features: array(dtype=float32, ndim=2)
    rows: array(dtype=int32)

    def __init__(self, features: Array2[float32]) -> None:
        row_count, self.columns = features.shape
        self.features, self.device = features, features.device
        usable = compute(mark_rows_kernel, row_count, [features], uint8, self.device)
        self.rows = positions_of(usable)  # sync
        self.count = self.rows.size

    def sample(self) -> Array2[float32]:
        sample = empty((min(SAMPLED_ROWS, self.count), self.columns), float32, self.device)
        launch(gather_sample_kernel, sample.shape[0], [self, sample])
        return sample


@struct
class FeatureTree:
    """Ordered feature rows with boxes. `packed`: zero-padded rows; `grouped`: coordinates, interleaved by group;
    `alike`: 1 if all rows of a group are equal, 2 if equal to the previous group's too; `boxes`: of the children of
    each node, lowest level first; `extent`: squared length of the longest coordinates.
    """

    count: int
    width: int
    labels: array(dtype=int32)
    packed: array(dtype=float32)
    grouped: array(dtype=float32)
    alike: array(dtype=int32)
    boxes: array(dtype=float32)
    roots: int
    second: int
    third: int
    extent: array(dtype=float32)

    def __init__(self, source: FeatureRows, basis: Array2[float64]) -> None:
        """Sort a FeatureRows along the axes of `find_axes`, shared by both sides. Raises ValueError if too large."""
        self.device, self.count = source.device, source.count
        self.width = -(-source.columns // NUMBERS_PER_STEP) * NUMBERS_PER_STEP
        max_count = MAX_NUMBERS // max(self.width, ROW_AXES)
        if self.count + ROWS_PER_GROUP > max_count:
            raise ValueError(
                f"{self.count} features of {source.columns} numbers: one search holds {max_count}; split them"
            )
        coordinates = empty((self.count, ROW_AXES), float32, self.device)
        launch(project_rows_kernel, self.count, [source, basis, coordinates])
        before, moves = self._sort(coordinates)
        order, self.labels = empty(self.count, int32, self.device), empty(self.count, int32, self.device)
        self.packed = empty(self.count * self.width, float32, self.device)
        launch(pack_rows_kernel, self.count, [source, before, moves, order, self])
        self._bound(coordinates, order)

    def _sort(self, coordinates: Array2[float32]) -> tuple[Indices, Indices]:
        """The order before the last sort, and that sort."""
        before, order = empty(self.count, int32, self.device), empty(self.count, int32, self.device)
        keys = empty(self.count, int64, self.device)
        moves = before
        for axis, slab in enumerate(slab_sizes(self.count)):
            launch(make_slab_keys_kernel, self.count, [coordinates, before, moves, axis, slab, order, keys])
            moves = argsort_keys(keys, 32 + max(1, (self.count // slab).bit_length()))[1]
            before, order = order, before
        return before, moves

    def _bound(self, coordinates: Array2[float32], order: Indices) -> None:
        sizes = [max(1, -(-self.count // ROWS_PER_GROUP))]
        for _ in range(3):
            sizes.append(-(-sizes[-1] // FAN_OUT))
        groups, second, third, self.roots = sizes
        self.second, self.third = second, second + third
        self.boxes = empty((second + third + self.roots) * NUMBERS_PER_NODE, float32, self.device)
        self.grouped = empty(groups * ROWS_PER_GROUP * ROW_AXES, float32, self.device)
        self.extent, self.alike = zeros(1, float32, self.device), zeros(groups, int32, self.device)
        launch(bound_groups_kernel, second * FAN_OUT, [coordinates, order, self])
        launch(bound_children_kernel, third * FAN_OUT, [0, self.second, self.boxes])
        launch(bound_children_kernel, self.roots * FAN_OUT, [self.second, self.third, self.boxes])


@kernel
def mark_rows_kernel(features: array(dtype=float32, ndim=2), usable: array(dtype=uint8)):
    """1 for rows with finite numbers that are not too large."""
    i = tid()
    good = 1
    for c in range(features.shape[1]):
        if not (abs(features[i, c]) <= LARGEST_NUMBER):
            good = 0
    usable[i] = uint8(good)


@kernel
def gather_sample_kernel(source: FeatureRows, sample: array(dtype=float32, ndim=2)):
    i = tid()
    row = source.rows[int(int64(i) * int64(source.rows.shape[0]) // int64(sample.shape[0]))]
    for c in range(source.features.shape[1]):
        sample[i, c] = source.features[row, c]


@kernel
def project_rows_kernel(
    source: FeatureRows, basis: array(dtype=float64, ndim=2), coordinates: array(dtype=float32, ndim=2)
):
    """Coordinates of a row. basis[c] contains the mean of column c and the axes' components."""
    i = tid()
    row = source.rows[i]
    along = leading(0.0)
    left = float64(0.0)
    for c in range(source.features.shape[1]):
        x = float64(source.features[row, c]) - basis[c, 0]
        left += x * x
        for k in range(LEADING_AXES):
            along[k] += x * basis[c, 1 + k]
    for k in range(LEADING_AXES):
        left -= along[k] * along[k]
        coordinates[i, k] = float32(along[k])
    coordinates[i, LEADING_AXES] = float32(sqrt(max(left, 0.0)))


@kernel
def make_slab_keys_kernel(
    coordinates: array(dtype=float32, ndim=2),
    before: array(dtype=int32),
    moves: array(dtype=int32),
    axis: int,
    slab: int,
    order: array(dtype=int32),
    keys: array(dtype=int64),
):
    """Order after a sort (or of the input) and the keys of the next: slab, coordinate; backwards in odd slabs."""
    i = tid()
    position = i
    if axis > 0:
        position = before[moves[i]]
    order[i] = position
    bits = float_bits(coordinates[position, axis])
    ascending = bits ^ ((bits >> 31) & 0x7FFFFFFF)
    if (i // slab) % 2 == 1:
        ascending = -1 - ascending
    keys[i] = (int64(i // slab) << 32) + (int64(ascending) + 0x80000000)


@kernel
def pack_rows_kernel(
    source: FeatureRows,
    before: array(dtype=int32),
    moves: array(dtype=int32),
    order: array(dtype=int32),
    tree: FeatureTree,
):
    """Rows in final order, zero-padded, with their numbers."""
    i = tid()
    position = before[moves[i]]
    order[i] = position
    row = source.rows[position]
    tree.labels[i] = row
    columns = source.features.shape[1]
    for c in range(columns):
        tree.packed[i * tree.width + c] = source.features[row, c]
    for c in range(columns, tree.width):
        tree.packed[i * tree.width + c] = 0.0


@func
def is_one_row(first: int, last: int, tree: FeatureTree) -> int:
    same = 1
    at = (first + 1) * tree.width
    while at < last * tree.width and same == 1:
        if tree.packed[at] != tree.packed[at - tree.width]:
            same = 0
        at += 1
    return same


@kernel
def bound_groups_kernel(coordinates: array(dtype=float32, ndim=2), order: array(dtype=int32), tree: FeatureTree):
    """Interleaved coordinates, box, `alike` flag and maximum length of a group. Padding is at infinity."""
    i = tid()
    first = i * ROWS_PER_GROUP
    size = max(0, min(ROWS_PER_GROUP, order.shape[0] - first))
    low = boxed(INFINITY)
    high = boxed(-INFINITY)
    longest = 0.0
    for lane in range(size):
        position = order[first + lane]
        sqlength = 0.0
        for k in range(ROW_AXES):
            x = coordinates[position, k]
            tree.grouped[(i * ROW_AXES + k) * ROWS_PER_GROUP + lane] = x
            sqlength += x * x
        for k in range(BOX_AXES):
            low[k] = smaller(low[k], coordinates[position, k])
            high[k] = larger(high[k], coordinates[position, k])
        longest = larger(longest, sqlength)
    at = (i // FAN_OUT) * NUMBERS_PER_NODE + i % FAN_OUT
    for k in range(BOX_AXES):
        tree.boxes[at + k * FAN_OUT] = low[k]
        tree.boxes[at + (BOX_AXES + k) * FAN_OUT] = high[k]
    if i < tree.alike.shape[0]:
        for lane in range(size, ROWS_PER_GROUP):
            for k in range(ROW_AXES):
                tree.grouped[(i * ROW_AXES + k) * ROWS_PER_GROUP + lane] = INFINITY
    if size > 0:
        equal = is_one_row(first, first + size, tree)
        if equal == 1 and i > 0:
            equal += is_one_row(first - ROWS_PER_GROUP, first + size, tree)
        tree.alike[i] = equal
        atomic_max(tree.extent, 0, longest)  # maximum: order-independent


@kernel
def bound_children_kernel(below: int, first: int, boxes: array(dtype=float32)):
    """Copy the node boxes of a level into their parents. Empty for missing nodes."""
    i = tid()
    at = (first + i // FAN_OUT) * NUMBERS_PER_NODE + i % FAN_OUT
    for k in range(BOX_AXES):
        low = float(INFINITY)
        high = -float(INFINITY)
        if below + i < first:
            for j in range(FAN_OUT):
                child = (below + i) * NUMBERS_PER_NODE + k * FAN_OUT + j
                low = smaller(low, boxes[child])
                high = larger(high, boxes[child + BOX_AXES * FAN_OUT])
        boxes[at + k * FAN_OUT] = low
        boxes[at + (BOX_AXES + k) * FAN_OUT] = high


def find_axes(source: FeatureRows, target: FeatureRows) -> Array2[float64]:
    """Mean and leading axes of samples of two FeatureRows, float64 (d, 1 + LEADING_AXES), or zeros for missing axes."""
    samples = concatenate_rows([side.sample().flatten() for side in (source, target)])
    rows = download(samples).astype(np.float64).reshape(-1, source.columns)  # sync
    basis = np.zeros((source.columns, 1 + LEADING_AXES))
    if len(rows):
        basis[:, 0] = rows.mean(axis=0)
        rows -= basis[:, 0]
        basis[:, 1:] = leading_axes(np.einsum("ni,nj->ij", rows, rows))
    return upload(basis, float64, source.device)


def leading_axes(scatter: np.ndarray) -> np.ndarray:
    """Approximate leading eigenvectors by power iterations. LAPACK's spinning threads would delay the next kernels."""
    axes = np.zeros((len(scatter), LEADING_AXES))
    left = scatter / max(np.trace(scatter), MIN_DIVISOR)
    for k in range(min(LEADING_AXES, len(scatter))):
        axis = left[:, np.argmax(np.diag(left))]
        for _ in range(POWER_STEPS):
            axis = np.einsum("ij,j->i", left, axis)
            axis = axis / max(np.sqrt((axis * axis).sum()), MIN_DIVISOR)
        for _ in range(2):  # the second pass corrects rounding of the first
            axis = axis - np.einsum("ij,j->i", axes, np.einsum("ij,i->j", axes, axis))
            length = np.sqrt((axis * axis).sum())
            if length < MIN_INDEPENDENT_LENGTH:
                return axes
            axis = axis / length
        axes[:, k] = axis
        shadow = np.einsum("ij,j->i", left, axis)
        across = np.outer(shadow - 0.5 * (shadow * axis).sum() * axis, axis)
        left = left - across - across.T
    return axes


def slab_sizes(count: int) -> list[int]:
    """Row counts of the slabs in each round."""
    fan = max(1.0, count / ROWS_PER_GROUP) ** (1 / SORTED_AXES)
    sizes = [ROWS_PER_GROUP]
    for k in range(SORTED_AXES - 1):
        sizes.append(sizes[-1] * max(1, round(fan * SLAB_RATIO ** (k - (SORTED_AXES - 1) / 2))))
    return [max(1, count), *reversed(sizes[1:])]
