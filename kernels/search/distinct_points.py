"""Distinct positions of a tree's points, for neighborhoods that copies of one position would fill.

The k nearest points of a position with k copies are the copies, so they define no plane. A neighborhood has at least
MIN_DISTINCT positions if none is repeated more than k / MIN_DISTINCT times. Copies are adjacent along the Hilbert curve
unless its cells contain many positions, so a test of adjacent points (4 comparisons per point) comes first. Then copies
are counted by a hash table: O(n), 50 B per point, once per tree.
"""

from typing import NamedTuple

from ..array_types import Indices, Integers, Points
from ..arrays.duplicates import find_equal_points, same_point
from ..arrays.prefix_sum import inclusive_scan
from ..arrays.select import gather_rows, positions_of
from ..lang import array, atomic_add, atomic_max, int32, isfinite, kernel, launch, tid, uint8, vec3
from ..memory import download, empty, zeros
from .point_tree import PointTree

MIN_DISTINCT = 5  # positions that determine a plane and its error, as in `plane_covariances`
WINDOW = 5  # points along the curve: a cell of it may contain several positions


@kernel
def find_adjacent_copies_kernel(tree: PointTree, flag: array(dtype=int32)):
    """1 if a point equals one of the next along the curve. All threads write the same value."""
    i = tid()
    p = tree.points[i]
    copies = 0
    for j in range(i + 1, min(i + WINDOW, tree.count)):
        if tree.points[j][0] == p[0]:
            copies += same_point(p, tree.points[j])
    if copies > 0:
        flag[0] = 1


@kernel
def count_copies_kernel(points: array(dtype=vec3), firsts: array(dtype=int32), counts: array(dtype=int32)):
    i = tid()
    p = points[i]
    if isfinite(p):
        atomic_add(counts, firsts[i], 1)  # integers: the order does not matter


@kernel
def find_most_copies_kernel(counts: array(dtype=int32), most: array(dtype=int32)):
    i = tid()
    if counts[i] > most[0]:
        atomic_max(most, 0, counts[i])  # the order does not matter


@kernel
def mask_heads_kernel(firsts: array(dtype=int32), mask: array(dtype=uint8), ranks: array(dtype=int32)):
    i = tid()
    is_first = 1 if firsts[i] == i else 0
    mask[i] = uint8(is_first)
    ranks[i] = is_first


@kernel
def number_copies_kernel(firsts: array(dtype=int32), ranks: array(dtype=int32), rows: array(dtype=int32)):
    """Row of each point's position among the distinct ones, from the prefix sums of the first ones."""
    i = tid()
    rows[i] = ranks[firsts[i]] - 1


class DistinctPoints(NamedTuple):
    """Distinct positions, in order of their first points.

    Attributes:
        tree: Their search tree.
        firsts: The first point of each position, int32 [m].
        rows: The position of each point, int32 [n].
    """

    tree: PointTree
    firsts: Indices
    rows: Indices


def distinct_points(tree: PointTree, max_nn: int | None) -> DistinctPoints | None:
    """The distinct positions if copies would fill a neighborhood of `max_nn` points, else None. Neighborhoods without a
    maximum number (None) contain all positions within their radius."""
    if max_nn is None or tree.count < 2 or copies_of(tree) <= max(1, max_nn // MIN_DISTINCT):
        return None
    if not hasattr(tree, "distinct"):
        tree.distinct = _select_distinct(tree.source, tree.firsts_of_copies)
    return tree.distinct


def copies_of(tree: PointTree) -> int:
    """Number of points at the position with most copies, 1 without copies. One or two syncs, once per tree."""
    if not hasattr(tree, "most_copies"):
        flag = zeros(1, int32, tree.device)
        launch(find_adjacent_copies_kernel, tree.count, [tree, flag])
        tree.most_copies = 1
        if int(download(flag)[0]):  # sync
            tree.firsts_of_copies = find_equal_points(tree.source)
            tree.most_copies = _count_most(tree.source, tree.firsts_of_copies)
    return tree.most_copies


def _count_most(points: Points, firsts: Indices) -> int:
    counts, most = zeros(firsts.size, int32, firsts.device), zeros(1, int32, firsts.device)
    launch(count_copies_kernel, firsts.size, [points, firsts, counts])
    launch(find_most_copies_kernel, firsts.size, [counts, most])
    return int(download(most)[0])  # sync


def _select_distinct(points: Points, firsts: Integers) -> DistinctPoints:
    mask, ranks = (empty(firsts.size, kind, firsts.device) for kind in (uint8, int32))
    launch(mask_heads_kernel, firsts.size, [firsts, mask, ranks])
    heads, rows = positions_of(mask), empty(firsts.size, int32, firsts.device)
    inclusive_scan(ranks, ranks)
    launch(number_copies_kernel, firsts.size, [firsts, ranks, rows])
    return DistinctPoints(PointTree(gather_rows(points, heads)), heads, rows)
