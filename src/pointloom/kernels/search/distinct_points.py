"""Distinct positions of a tree's points, for neighborhoods that copies of one position would fill.

The k nearest points of a position with k copies are the copies, so they define no plane. A neighborhood has at least
MIN_DISTINCT positions if none is repeated more than k / MIN_DISTINCT times. Copies are adjacent along the Hilbert curve
unless its cells contain many positions, so a test of adjacent points (4 comparisons per point) comes first. Then copies
are counted by a hash table: O(n), 50 B per point, once per tree.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from ..array_types import Indices, Integers, Points
from ..arrays.bounds import maximum_of
from ..arrays.concatenation import concatenate_rows
from ..arrays.duplicates import find_equal_points
from ..arrays.packed_keys import key_index
from ..arrays.prefix_sum import inclusive_scan
from ..arrays.select import gather_rows, positions_of
from ..arrays.sort import positions
from ..lang import array, atomic_add, int32, isfinite, kernel, launch, tid, uint8, vec3
from ..memory import download, empty, zeros
from .group_scratch import GroupScratch, LaunchPart, stored_key
from .group_search import launch_over_leaves, nearest_of_leaves
from .point_tree import PointTree, copies_after
from .tree_search import squared_radius

MIN_DISTINCT = 5  # positions that determine a plane and its error, as in `plane_covariances`


@kernel
def find_adjacent_copies_kernel(tree: PointTree, flag: array(dtype=int32)):
    """1 if a point equals one of the next along the curve. All threads write the same value."""
    i = tid()
    if copies_after(i, tree) > 0:
        flag[0] = 1


@kernel
def count_copies_kernel(points: array(dtype=vec3), firsts: array(dtype=int32), counts: array(dtype=int32)):
    i = tid()
    p = points[i]
    if isfinite(p):
        atomic_add(counts, firsts[i], 1)  # integers: the order does not matter


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


@kernel(max_registers=80)
def pick_results_kernel(
    part: LaunchPart,
    tree: PointTree,
    labels: array(dtype=int32),
    scratch: GroupScratch,
    max_sqdist: float,
    firsts: array(dtype=int32),
    counts: array(dtype=int32),
    rows: array(dtype=int32),
    limit: int,
    picks: array(dtype=int32),
):
    """Row of each point's result: its own, or if copies fill its neighborhood that of its position, after all own ones.

    The neighborhood decides, so that the results of a part of a cloud do not depend on the rest.
    """
    i = tid()
    for rank, base, size in nearest_of_leaves(i, part, tree, labels, scratch, max_sqdist, 0):
        most = int(0)
        for j in range(size):
            most = max(most, counts[firsts[tree.order[key_index(stored_key(scratch, base, j))]]])
        row = tree.order[rank]
        picks[row] = row
        if most > limit:
            picks[row] = picks.shape[0] + rows[row]


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


class Copies(NamedTuple):
    """First point at each point's position, int32 [n], the number of finite points at each first one, and the largest
    number."""

    firsts: Indices
    counts: Integers
    most: int


def distinct_points(tree: PointTree, max_nn: int | None, most: int | None = None) -> DistinctPoints | None:
    """The distinct positions if copies would fill a neighborhood of `max_nn` points, else None. Neighborhoods without a
    maximum number (None) contain all positions within their radius. More than `most` copies of a position fill one: if
    None, so many that fewer than MIN_DISTINCT positions may remain."""
    if max_nn is None:
        return None
    copies = copies_of(tree)
    return None if copies is None or copies.most <= _limit(max_nn, most) else _distinct_of(tree, copies)


def without_copies(tree: PointTree) -> PointTree:
    """The tree of the distinct positions; the given tree if there are no copies."""
    copies = copies_of(tree)
    return tree if copies is None else _distinct_of(tree, copies).tree


def _distinct_of(tree: PointTree, copies: Copies) -> DistinctPoints:
    if tree.distinct is None:
        tree.distinct = _select_distinct(tree, copies.firsts)
    return tree.distinct


def by_distinct_points(
    tree: PointTree,
    max_nn: int | None,
    radius: float,
    measure: Callable[..., list[Any]],
    *given: Any,
    most: int | None = None,
) -> list[Any]:
    """Arrays (n, ...) of `measure(tree, *given)`, from neighborhoods of a tree's points with arrays `given` (n, ...).

    Where copies of one position fill a neighborhood of the `max_nn` nearest within `radius`, results are those of the
    distinct positions, with what is given for the first point of each. `most` is that of `distinct_points`.
    """
    values, distinct = measure(tree, *given), distinct_points(tree, max_nn, most)
    if distinct is None:
        return values
    copies, picks = copies_of(tree), positions(tree.source.size, tree.device)
    assert copies is not None and max_nn is not None
    known = [copies.firsts, copies.counts, distinct.rows, _limit(max_nn, most), picks]
    launch_over_leaves(pick_results_kernel, tree, max_nn, [squared_radius(radius), *known])
    others = measure(distinct.tree, *(gather_rows(values, distinct.firsts) for values in given))
    return [gather_rows(concatenate_rows(pair), picks) for pair in zip(values, others, strict=True)]


def copies_of(tree: PointTree) -> Copies | None:
    """The copies of each position, None if there are none. One or two syncs, once per tree."""
    if not tree.is_searched_for_copies and tree.count > 1:
        flag = zeros(1, int32, tree.device)
        launch(find_adjacent_copies_kernel, tree.count, [tree, flag])
        if int(download(flag)[0]):  # sync
            tree.copies = _count_copies(tree.source)
        tree.is_searched_for_copies = True
    return tree.copies


def _limit(max_nn: int, most: int | None) -> int:
    return max(1, max_nn // MIN_DISTINCT if most is None else most)


def _count_copies(points: Points) -> Copies:
    firsts = find_equal_points(points)
    counts = zeros(firsts.size, int32, firsts.device)
    launch(count_copies_kernel, firsts.size, [points, firsts, counts])
    return Copies(firsts, counts, int(download(maximum_of(counts))[0]))  # sync


def _select_distinct(tree: PointTree, firsts: Integers) -> DistinctPoints:
    mask, ranks = empty(firsts.size, uint8, firsts.device), empty(firsts.size, int32, firsts.device)
    launch(mask_heads_kernel, firsts.size, [firsts, mask, ranks])
    heads, rows = positions_of(mask), empty(firsts.size, int32, firsts.device)
    inclusive_scan(ranks, ranks)
    launch(number_copies_kernel, firsts.size, [firsts, ranks, rows])
    # on the same curve, which decides ties
    return DistinctPoints(PointTree(gather_rows(tree.source, heads), tree.curve), heads, rows)
