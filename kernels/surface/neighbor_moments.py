"""Count, mean and covariance of each point's neighbours, in one pass after their limits are known.

Differences to the point itself, taken and summed in float64 in the order in which the search meets them: points with
the same neighbours get the same covariance to some 1e-15 of the radius squared, though each sums about itself and in
an order of its own. 80 B written a point; no list of neighbours in memory.
"""

from ..lang import array, float64, func, int32, int64, kernel, tid, vec3
from ..memory import empty
from ..search.group_search import GroupScratch, pick_within
from ..search.neighbor_limits import gather_group, key_of, reach_within, widest_reach
from ..search.point_tree import (
    BUCKET,
    INDEX_MASK,
    LEAF,
    PointTree,
    points_in_reach,
    square_distance,
)
from .normals import moments


@func
def add_difference(total: moments, p: vec3, q: vec3) -> moments:
    """Add the count, the components and the products of q - p, which is exact in float64."""
    x = float64(q[0]) - float64(p[0])
    y = float64(q[1]) - float64(p[1])
    z = float64(q[2]) - float64(p[2])
    return total + moments(float64(1.0), x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)


@func
def sum_listed(
    p: vec3, points: array(dtype=vec3), keys: array(dtype=int64), base: int, held: int, limit: int64
) -> moments:
    """The moments of the points that the keys up to a limit stand for."""
    total = moments(float64(0.0))
    for j in range(base, base + held):
        if keys[j] <= limit:
            total = add_difference(total, p, points[int(keys[j] & int64(INDEX_MASK))])
    return total


@func
def sum_walked(
    rank: int,
    limit: int64,
    tree: PointTree,
) -> moments:
    """The moments of the points up to a limit, by a walk through the tree."""
    p = tree.points[rank]
    reach = reach_within(limit)
    total = moments(float64(0.0))
    for j in points_in_reach(rank // BUCKET, p, reach, tree):
        if key_of(square_distance(p, tree.points[j]), j) <= limit:
            total = add_difference(total, p, tree.points[j])
    return total


@kernel
def sum_moments_walking_kernel(
    ranks: array(dtype=int32),
    tree: PointTree,
    limits: array(dtype=int64),
    sums: array(dtype=moments),
):
    """The moments of each point's neighbours, a walk a point."""
    i = tid()
    rank = ranks[i]
    sums[rank] = sum_walked(rank, limits[rank], tree)


@kernel
def sum_moments_kernel(
    ranks: array(dtype=int32),
    query_count: int,
    first: int,
    last: int,
    run: int,
    tree: PointTree,
    places: array(dtype=int32),
    scratch: GroupScratch,
    limits: array(dtype=int64),
    sums: array(dtype=moments),
):
    """The moments of each point's neighbours, their candidates gathered for a group."""
    i = tid()
    base = i * (scratch.room + scratch.k)
    listing = i * scratch.gather
    for group in range(first + i * run, min(first + (i + 1) * run, last)):
        head = group * LEAF
        tail = min((group + 1) * LEAF, query_count)
        reach = widest_reach(ranks, head, tail, limits)
        gathered = gather_group(ranks, head, tail, reach, tree, places, scratch, listing)
        for j in range(head, tail):
            rank = ranks[j]
            p = tree.points[rank]
            limit = limits[rank]
            total = moments(float64(0.0))
            if gathered <= scratch.gather:
                held = pick_within(p, scratch, listing, gathered, base, reach_within(limit))
                total = sum_listed(p, tree.points, scratch.keys, base, held, limit)
            else:
                total = sum_walked(rank, limit, tree)
            sums[rank] = total


def sum_neighbor_moments(neighborhood):
    """The moments of each point's neighbours about the point, by place on the curve; see normals.covariance_of."""
    tree = neighborhood.tree
    sums = empty(tree.count, moments, tree.device)
    neighborhood.visit(sum_moments_kernel, sum_moments_walking_kernel, neighborhood.places, [sums])
    return sums
