"""Pairs of rows of two sets of features that are nearest to each other, one way or mutually.

Both sides get a FeatureTree about the same axes; the queries then follow its order, so that those of neighbouring
threads visit the same rows. The way back is no second search: of all source rows that have the same target row as their
nearest, only the nearest one can be its mutual partner, and it is one unless the target row has a nearer source row
yet. So each target row that is somebody's nearest searches within that distance, and stops at the first that it finds.

Distances are exact float32 sums of squared differences in one order of operations, whichever side asks. Nothing depends
on the number of threads: ties go to the lower number, and the atomic is a minimum.
"""

import math

import numpy as np

from ..array_types import Array2, Mask
from ..arrays.packed_keys import key_index, key_number, pack_key
from ..arrays.select import positions_of
from ..lang import array, atomic_min, float32, float64, func, int32, int64, kernel, launch, sqrt, struct, tid, uint8
from ..memory import empty, full, zeros
from .feature_search import NO_ROW_KEY, closest, closest_group, coordinates_of, limit_of, offer_group, search_rows
from .feature_tree import FeatureRows, FeatureTree, find_axes

CPU_RUN = 32  # queries a thread on the CPU: some 70 microseconds of work
NO_ROW = -1  # the index where there is no row


@struct
class FeatureMatch:
    """The nearest target row of each source row.

    Attributes:
        nearest: int32 [n]; NO_ROW where a source row is not finite or there is no target row.
        sqdists: float32 [n], infinite there.
        second_sqdists: float32 [n], of the second nearest row, infinite where there is none; without `second` no more
            than a bound from above.
        slack, rounding: How far distances of coordinates may be off, see `limit_of`; `rounding` in lengths of the
            longest row.
        source, target: The FeatureTrees.
    """

    nearest: array(dtype=int32)
    sqdists: array(dtype=float32)
    second_sqdists: array(dtype=float32)
    slack: float
    rounding: float

    def __init__(self, source: Array2[float32], target: Array2[float32], *, second: bool = True) -> None:
        """Match the rows of two float32 device arrays [n, d] and [m, d]; `second` False leaves out the second nearest.

        Raises:
            ValueError: More numbers than one array holds.
        """
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

    def matched(self) -> Mask:
        """A mask, uint8 [n], of the source rows that have a nearest one."""
        kept = empty(self.row_counts[0], uint8, self.device)
        launch(keep_matched_kernel, kept.size, [self.nearest, kept])
        return kept

    def mutual(self) -> Mask:
        """A mask, uint8 [n], of the source rows that are the nearest of their nearest."""
        claims = full(self.row_counts[1], NO_ROW_KEY, int64, self.device)
        launch(claim_rows_kernel, self.row_counts[0], [self.nearest, self.sqdists, claims])
        kept, run = zeros(self.row_counts[0], uint8, self.device), self._run()
        search = [run, self.target, self.source, self, claims, kept]
        launch(keep_mutual_kernel, -(-self.target.count // run), search)
        return kept

    def pairs(self, kept: Mask) -> Array2[int32]:
        """The marked source rows with their nearest, int32 [m, 2] on the device, by source row (one sync)."""
        rows = positions_of(kept)
        pairs = empty((rows.size, 2), int32, self.device)
        launch(write_pairs_kernel, rows.size, [rows, self.nearest, pairs])
        return pairs


@func
def margin_of(queries: FeatureTree, tree: FeatureTree, rounding: float) -> float:
    """By how much the distance of two rows' coordinates may be off."""
    return sqrt(max(queries.extent[0], tree.extent[0])) * rounding


@kernel
def find_nearest_rows_kernel(run: int, counted: int, queries: FeatureTree, tree: FeatureTree, match: FeatureMatch):
    """The nearest row of each query of a run, and how far that and the next one are."""
    i = tid()
    margin = margin_of(queries, tree, match.rounding)
    for place in range(i * run, min((i + 1) * run, queries.labels.shape[0])):
        y = coordinates_of(place, queries)
        held = closest(int64(NO_ROW_KEY), int64(NO_ROW_KEY))
        seen = closest_group(y, tree)
        limit = limit_of(held[0], match.slack, margin)
        held = offer_group(seen, y, limit, place, queries, tree, held)
        held = search_rows(y, place, queries, tree, held, seen, counted, 0, match.slack, margin)
        row = queries.labels[place]
        if held[0] < int64(NO_ROW_KEY):
            match.nearest[row] = key_index(held[0])
            match.sqdists[row] = key_number(held[0])
            match.second_sqdists[row] = key_number(held[1])


@kernel
def claim_rows_kernel(nearest: array(dtype=int32), sqdists: array(dtype=float32), claims: array(dtype=int64)):
    """The smallest key of the source rows that have a target row as their nearest; a minimum has no order."""
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
    kept: array(dtype=uint8),
):
    """Mark the source row that claims a target row, unless another source row is nearer to that."""
    i = tid()
    margin = margin_of(queries, tree, match.rounding)
    for place in range(i * run, min((i + 1) * run, queries.labels.shape[0])):
        claim = claims[queries.labels[place]]
        if claim < int64(NO_ROW_KEY):
            y = coordinates_of(place, queries)
            held = closest(claim, int64(NO_ROW_KEY))
            held = search_rows(y, place, queries, tree, held, -1, 0, 1, match.slack, margin)
            if held[0] == claim:
                kept[key_index(claim)] = 1


@kernel
def keep_matched_kernel(nearest: array(dtype=int32), kept: array(dtype=uint8)):
    """Mark the rows that have a nearest one."""
    i = tid()
    kept[i] = uint8(1 if nearest[i] != NO_ROW else 0)


@kernel
def drop_ambiguous_kernel(
    sqdists: array(dtype=float32), second_sqdists: array(dtype=float32), square_ratio: float64, kept: array(dtype=uint8)
):
    """Take the mark from rows whose nearest is not nearer than a share of the way to the next."""
    i = tid()
    if not (float64(sqdists[i]) < square_ratio * float64(second_sqdists[i])):
        kept[i] = 0


@kernel
def write_pairs_kernel(rows: array(dtype=int32), nearest: array(dtype=int32), pairs: array(dtype=int32, ndim=2)):
    """Rows with their nearest."""
    i = tid()
    pairs[i, 0] = rows[i]
    pairs[i, 1] = nearest[rows[i]]


def pair_features(
    source: Array2[float32],
    target: Array2[float32],
    *,
    mutual: bool = False,
    mutual_consistency_ratio: float = 0.1,
    ratio: float | None = None,
) -> Array2[int32]:
    """Pairs of rows, nearest to each other.

    Args:
        source: float32 device array [n, d].
        target: float32 device array [m, d].
        mutual: Keep pairs only where the source row is also the nearest of the target row, unless those are too few.
        mutual_consistency_ratio: Fewer than this share of n are too few.
        ratio: Keep pairs only where the nearest row is closer than `ratio` times the second nearest; None keeps all.

    Returns:
        int32 device array [k, 2], (source row, target row), by source row.
    """
    match = FeatureMatch(source, target, second=ratio is not None)
    kept, pairs = None, None
    if mutual:
        kept = match.mutual()
        pairs = match.pairs(kept)
        fewest = np.float32(mutual_consistency_ratio) * np.float32(source.shape[0])  # as Open3D rounds it
        if pairs.shape[0] < int(fewest):
            kept = None
    if kept is None:
        kept, pairs = match.matched(), None
    if ratio is not None:
        launch(drop_ambiguous_kernel, kept.size, [match.sqdists, match.second_sqdists, float(ratio) ** 2, kept])
        pairs = None
    return match.pairs(kept) if pairs is None else pairs
