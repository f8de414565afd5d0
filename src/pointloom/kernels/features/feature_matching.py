"""Nearest rows between two feature sets, one-way or mutual.

Small sets on CUDA are compared by all pairs (all_pairs.py). Otherwise both sides get a FeatureTree with the same axes.
For mutual matches, each claimed target row searches only within the distance of its nearest claimant, and stops at the
first nearer row. One thread per query, without a stack: 16 child boxes are tested together, then rows by 6, 16 and all
coordinates (60 groups and 30 full rows of 8,500 FPFH rows). Results are keys: squared distance bits above the row
number, so ties go to the lower number.
"""

import math

import numpy as np

from ..algebra.plain_min_max import larger, smaller
from ..array_types import Array2, Indices, Mask
from ..arrays.packed_keys import key_index, key_number, pack_key
from ..arrays.select import positions_of
from ..lang import (
    INFINITY,
    array,
    atomic_min,
    bit_count,
    compute,
    float32,
    float64,
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
from ..memory import empty, full, zeros
from .all_pairs import NO_ROW, NO_ROW_KEY, PairwiseMatch, StoredRows, eight, is_for_all_pairs
from .feature_tree import (
    BOX_AXES,
    FAN_OUT,
    NUMBERS_PER_NODE,
    NUMBERS_PER_STEP,
    ROW_AXES,
    ROWS_PER_GROUP,
    FeatureRows,
    FeatureTree,
    axes,
    find_axes,
)

LEVEL_BITS = 0xFFFF  # pending bits of one level
UPPER_BITS = 0xFFFF_FFFF_0000  # pending bits of the upper levels
EQUAL_ROWS = 1  # a group of equal rows ...
FIRST_TWO = 3  # ... of which these two lanes are sufficient
REPEATED_ROWS = 2  # equal to the previous group, which has lower numbers
WIDEST_LIMIT = 3.0e38  # initial limit: below infinity, which marks missing children
MIN_PRODUCT = 1.0e-30  # covers subnormal products, whose rounding is not relative

lanes = vector(16, float32)
closest = vector(2, int64)  # keys of the nearest row and the second nearest


@func
def square_distance(a: int, some: array(dtype=float32), b: int, others: array(dtype=float32), width: int) -> float:
    """|a - b|^2 of packed rows, as eight parallel sums. Symmetric."""
    sums = eight(0.0)
    for c in range(width // NUMBERS_PER_STEP):
        for j in range(NUMBERS_PER_STEP):
            gap = some[a + c * NUMBERS_PER_STEP + j] - others[b + c * NUMBERS_PER_STEP + j]
            sums[j] += gap * gap
    return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]))


@func
def limit_of(key: int64, slack: float, margin: float) -> float:
    """Squared coordinate distance beyond which no row is as near as a key's. With the longest row R, u = 2^-24 and d
    columns: coordinates round by u R and the residual length by 7e-8 d^(1/2) R; `margin` exceeds both for two rows.
    `slack` covers (d / 8 + 6) u of the row's distance and 20 u of the coordinates'.
    """
    bound = sqrt(key_number(key)) * slack + margin
    return smaller(bound * bound * slack + MIN_PRODUCT, WIDEST_LIMIT)


@func
def lanes_within(sqdists: lanes, limit: float) -> int:
    bits = 0
    for j in range(FAN_OUT):
        bits = bits | ((1 if sqdists[j] <= limit else 0) << j)
    return bits


@func
def smallest_lane(sqdists: lanes) -> int:
    lane = 0
    smallest = sqdists[0]
    for j in range(1, FAN_OUT):
        if sqdists[j] < smallest:
            smallest = sqdists[j]
            lane = j
    return lane


@func
def measure_children(node: int, boxes: array(dtype=float32), y: axes) -> lanes:
    """Squared distances to the boxes of a node's children, infinite for missing children."""
    at = node * NUMBERS_PER_NODE
    sqdists = lanes(0.0)
    for k in range(BOX_AXES):
        x = y[k]
        for j in range(FAN_OUT):
            gap = larger(larger(boxes[at + k * FAN_OUT + j] - x, x - boxes[at + (BOX_AXES + k) * FAN_OUT + j]), 0.0)
            sqdists[j] += gap * gap
    return sqdists


@func
def rows_within(group: int, grouped: array(dtype=float32), y: axes, limit: float) -> int:
    """Bit mask of a group's rows within the limit by coordinates."""
    at = group * ROW_AXES * ROWS_PER_GROUP
    sqdists = lanes(0.0)
    for k in range(BOX_AXES):
        x = y[k]
        for j in range(ROWS_PER_GROUP):
            gap = grouped[at + k * ROWS_PER_GROUP + j] - x
            sqdists[j] += gap * gap
    bits = lanes_within(sqdists, limit)
    if bits != 0:
        for k in range(BOX_AXES, ROW_AXES):
            x = y[k]
            for j in range(ROWS_PER_GROUP):
                gap = grouped[at + k * ROWS_PER_GROUP + j] - x
                sqdists[j] += gap * gap
        bits = lanes_within(sqdists, limit)
    return bits


@func
def coordinates_of(position: int, tree: FeatureTree) -> axes:
    y = axes(0.0)
    at = (position // ROWS_PER_GROUP) * ROW_AXES * ROWS_PER_GROUP + position % ROWS_PER_GROUP
    for k in range(ROW_AXES):
        y[k] = tree.grouped[at + k * ROWS_PER_GROUP]
    return y


@func
def offer_group(
    group: int, y: axes, limit: float, position: int, queries: FeatureTree, tree: FeatureTree, keys: closest
) -> closest:
    """Update the two smallest keys with a group's rows. Of equal rows only two are compared (n duplicates)."""
    best = keys[0]
    next_best = keys[1]
    left = 0
    if tree.alike[group] != REPEATED_ROWS:
        left = rows_within(group, tree.grouped, y, limit)
        if tree.alike[group] == EQUAL_ROWS:
            left = left & FIRST_TWO
    while left != 0:
        lowest = left & (-left)
        left = left ^ lowest
        row = group * ROWS_PER_GROUP + bit_count(lowest - 1)
        sqdist = square_distance(position * tree.width, queries.packed, row * tree.width, tree.packed, tree.width)
        key = pack_key(sqdist, tree.labels[row])
        if key < best:
            next_best = best
            best = key
        elif key < next_best:
            next_best = key
    return closest(best, next_best)


@func
def closest_group(y: axes, tree: FeatureTree) -> int:
    """Descend to the nearest child at each level."""
    node = 0
    min_sqdist = float(INFINITY)
    for root in range(tree.roots):
        sqdists = measure_children(tree.third + root, tree.boxes, y)
        lane = smallest_lane(sqdists)
        if sqdists[lane] < min_sqdist:
            min_sqdist = sqdists[lane]
            node = root * FAN_OUT + lane
    node = node * FAN_OUT + smallest_lane(measure_children(tree.second + node, tree.boxes, y))
    return node * FAN_OUT + smallest_lane(measure_children(node, tree.boxes, y))


@func
def search_rows(
    y: axes,
    position: int,
    queries: FeatureTree,
    tree: FeatureTree,
    keys: closest,
    searched: int,
    counted: int,
    stop: int,
    slack: float,
    margin: float,
) -> closest:
    """Update the two smallest keys with all rows except group `searched`, if nearer than keys[counted]."""
    updated = keys
    limit = limit_of(updated[counted], slack, margin)
    searching = 1
    for root in range(tree.roots):
        node = root
        level = 3  # of the node; children of level 1 are groups
        left = int64(lanes_within(measure_children(tree.third + root, tree.boxes, y), limit)) << 32
        while left != 0 and searching == 1:
            shift = int64(FAN_OUT * (level - 1))
            bits = int(left >> shift) & LEVEL_BITS
            if bits == 0:
                node = node // FAN_OUT
                level += 1
            else:
                lowest = bits & (-bits)
                left = left ^ (int64(lowest) << shift)
                child = node * FAN_OUT + bit_count(lowest - 1)
                if level > 1:
                    node = child
                    level -= 1
                    first = 0 if level == 1 else tree.second
                    inside = lanes_within(measure_children(first + node, tree.boxes, y), limit)
                    left = left | (int64(inside) << int64(FAN_OUT * (level - 1)))
                elif child != searched:
                    now = offer_group(child, y, limit, position, queries, tree, updated)
                    if now[counted] < updated[counted]:
                        limit = limit_of(now[counted], slack, margin)
                        inside = lanes_within(measure_children(node, tree.boxes, y), limit)
                        left = left & (int64(inside) | int64(UPPER_BITS))
                        searching = 1 - stop
                    updated = now
    return updated


CPU_RUN = 32  # queries per CPU thread: some 70 microseconds


@struct
class FeatureMatch:
    """Nearest target row of each source row: `nearest` or NO_ROW; `sqdists`; `second_sqdists`, without `second` only an
    upper bound; `slack` and `rounding` (in lengths of the longest row) as in `limit_of`.
    """

    nearest: array(dtype=int32)
    sqdists: array(dtype=float32)
    second_sqdists: array(dtype=float32)
    slack: float
    rounding: float

    def __init__(self, source: Array2[float32], target: Array2[float32], *, second: bool = True) -> None:
        """Match float32 device arrays (n, d) and (m, d). Raises ValueError if they are too large."""
        self.device, columns = source.device, source.shape[1]
        sides = FeatureRows(source), FeatureRows(target)
        basis = find_axes(*sides)
        self.source, self.target = (FeatureTree(side, basis) for side in sides)
        self.row_counts = source.shape[0], target.shape[0]
        self.slack, self.rounding = 1 + (columns / 8 + 32) * 2**-23, 4e-7 + 1.6e-7 * math.sqrt(columns)
        self.nearest = full(self.row_counts[0], NO_ROW, int32, self.device)
        self.sqdists, self.second_sqdists = (full(self.row_counts[0], math.inf, float32, self.device) for _ in range(2))
        run = self._run()
        search = [run, int(second), self.source, self.target, self]
        launch(find_nearest_rows_kernel, -(-self.source.count // run), search)

    def _run(self) -> int:
        return 1 if self.device.is_cuda else CPU_RUN

    def mutual(self) -> Mask:
        claims = full(self.row_counts[1], NO_ROW_KEY, int64, self.device)
        launch(claim_rows_kernel, self.row_counts[0], [self.nearest, self.sqdists, claims])
        mask, run = zeros(self.row_counts[0], uint8, self.device), self._run()
        search = [run, self.target, self.source, self, claims, mask]
        launch(keep_mutual_kernel, -(-self.target.count // run), search)
        return mask


@func
def margin_of(queries: FeatureTree, tree: FeatureTree, rounding: float) -> float:
    """Rounding bound of the distance between two rows' coordinates."""
    return sqrt(max(queries.extent[0], tree.extent[0])) * rounding


@kernel
def find_nearest_rows_kernel(run: int, counted: int, queries: FeatureTree, tree: FeatureTree, match: FeatureMatch):
    """Nearest row of each query with its distance and the second distance."""
    i = tid()
    margin = margin_of(queries, tree, match.rounding)
    for position in range(i * run, min((i + 1) * run, queries.labels.shape[0])):
        y = coordinates_of(position, queries)
        keys = closest(int64(NO_ROW_KEY), int64(NO_ROW_KEY))
        searched = closest_group(y, tree)
        limit = limit_of(keys[0], match.slack, margin)
        keys = offer_group(searched, y, limit, position, queries, tree, keys)
        keys = search_rows(y, position, queries, tree, keys, searched, counted, 0, match.slack, margin)
        row = queries.labels[position]
        if keys[0] < int64(NO_ROW_KEY):
            match.nearest[row] = key_index(keys[0])
            match.sqdists[row] = key_number(keys[0])
            match.second_sqdists[row] = key_number(keys[1])


@kernel
def claim_rows_kernel(nearest: array(dtype=int32), sqdists: array(dtype=float32), claims: array(dtype=int64)):
    """Smallest key of the claimants of a target row. A minimum has no order."""
    i = tid()
    if nearest[i] != NO_ROW:
        atomic_min(claims, nearest[i], pack_key(sqdists[i], i))


@kernel
def keep_mutual_kernel(
    run: int,
    queries: FeatureTree,
    tree: FeatureTree,
    match: FeatureMatch,
    claims: array(dtype=int64),
    mask: array(dtype=uint8),
):
    """Flag the claimant of a target row unless another source row is nearer."""
    i = tid()
    margin = margin_of(queries, tree, match.rounding)
    for position in range(i * run, min((i + 1) * run, queries.labels.shape[0])):
        claim = claims[queries.labels[position]]
        if claim < int64(NO_ROW_KEY):
            y = coordinates_of(position, queries)
            keys = closest(claim, int64(NO_ROW_KEY))
            keys = search_rows(y, position, queries, tree, keys, -1, 0, 1, match.slack, margin)
            if keys[0] == claim:
                mask[key_index(claim)] = 1


@kernel
def keep_matched_kernel(nearest: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    mask[i] = uint8(1 if nearest[i] != NO_ROW else 0)


@kernel
def drop_ambiguous_kernel(
    sqdists: array(dtype=float32), second_sqdists: array(dtype=float32), square_ratio: float64, mask: array(dtype=uint8)
):
    """Clear rows whose nearest distance is not below the ratio to the second."""
    i = tid()
    if not (float64(sqdists[i]) < square_ratio * float64(second_sqdists[i])):
        mask[i] = 0


@kernel
def write_pairs_kernel(rows: array(dtype=int32), nearest: array(dtype=int32), pairs: array(dtype=int32, ndim=2)):
    i = tid()
    pairs[i, 0] = rows[i]
    pairs[i, 1] = nearest[rows[i]]


def pair_rows(nearest: Indices, mask: Mask) -> Array2[int32]:
    """Selected (source, target) rows, int32 (m, 2), by source row (one sync)."""
    rows = positions_of(mask)
    pairs = empty((rows.size, 2), int32, nearest.device)
    launch(write_pairs_kernel, rows.size, [rows, nearest, pairs])
    return pairs


def pair_features(
    source: Array2[float32],
    target: Array2[float32],
    *,
    mutual: bool = False,
    mutual_consistency_ratio: float = 0.1,
    ratio: float | None = None,
) -> Array2[int32]:
    """Matched rows, int32 (k, 2), by source row; `mutual` ones unless below `mutual_consistency_ratio` of n."""
    if is_for_all_pairs(source, target):
        match = PairwiseMatch(StoredRows(source), StoredRows(target))
    else:
        match = FeatureMatch(source, target, second=ratio is not None)
    mask, pairs = None, None
    if mutual:
        mask = match.mutual()
        pairs = pair_rows(match.nearest, mask)
        min_count = np.float32(mutual_consistency_ratio) * np.float32(source.shape[0])  # rounded as in Open3D
        if pairs.shape[0] < int(min_count):
            mask = None
    if mask is None:
        mask, pairs = compute(keep_matched_kernel, source.shape[0], [match.nearest], uint8, source.device), None
    if ratio is not None:
        launch(drop_ambiguous_kernel, mask.size, [match.sqdists, match.second_sqdists, float(ratio) ** 2, mask])
        pairs = None
    return pair_rows(match.nearest, mask) if pairs is None else pairs
