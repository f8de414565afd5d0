"""Count, mean and covariance of each point's neighbors, in one pass after their limits are known.

Float64 sums of differences to the point, in search order: points with the same neighbors agree up to 1e-15 of the
radius squared. `moments_within` sums integers and is independent of the order.
"""

from typing import Any

from ..algebra.moments import (
    MAX_EXACT_POINTS,
    add_difference,
    add_integer_moments,
    in_meters,
    integer_moments,
    moments,
    steps_for,
)
from ..array_types import Array1
from ..arrays.packed_keys import key_index
from ..lang import array, func, int32, int64, kernel, tid, vec3
from ..memory import empty
from ..search.bucket_walk import points_within
from ..search.group_scratch import GroupScratch, LaunchPart, stored_key
from ..search.neighbor_limits import Neighborhood, members_of, neighbors_of
from ..search.point_tree import PointTree


@func
def moments_within(start: int, p: vec3, max_sqdist: float, widest: float, tree: PointTree) -> moments:
    """Moments of the points within `max_sqdist` of p in integer steps, starting at a bucket; `widest` bounds it."""
    steps = steps_for(widest, 0)
    total = integer_moments(0)
    for j, sqdist in points_within(start, p, max_sqdist, tree):
        total = add_integer_moments(total, p, tree.points[j], steps)
    if total[0] > int64(MAX_EXACT_POINTS):  # too many for these steps. Testing in the loop would take 50 % longer
        steps = steps_for(widest, int(total[0]))
        total = integer_moments(0)
        for j, sqdist in points_within(start, p, max_sqdist, tree):
            total = add_integer_moments(total, p, tree.points[j], steps)
    return in_meters(total, steps)


@kernel(max_registers=80)
def sum_moments_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    neighborhood: Neighborhood,
    scratch: GroupScratch,
    sums: array(dtype=moments),
):
    i = tid()
    for member, base, key_count in members_of(i, part, ranks, neighborhood, scratch):
        rank = ranks[member]
        p = neighborhood.tree.points[rank]
        limit = neighborhood.limits[rank]
        total = moments(0.0)
        if key_count < 0:
            for j, sqdist in neighbors_of(rank, neighborhood):
                total = add_difference(total, p, neighborhood.tree.points[j])
        for j in range(key_count):
            key = stored_key(scratch, base, j)
            if key <= limit:
                total = add_difference(total, p, neighborhood.tree.points[key_index(key)])
        sums[rank] = total


def sum_neighbor_moments(neighborhood: Neighborhood) -> Array1[Any]:
    """Moments of each point's neighbors about the point, in tree order. See algebra.moments."""
    tree = neighborhood.tree
    sums = empty(tree.count, moments, tree.device)
    neighborhood.visit(sum_moments_kernel, neighborhood.positions, [sums])
    return sums
