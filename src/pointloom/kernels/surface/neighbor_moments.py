"""Count, mean and covariance of each point's neighbors, in one pass after their limits are known.

Float64 sums of differences to the point, in search order: points with the same neighbors agree up to 1e-15 of the
radius squared. `moments_within` sums integers and is independent of the order.
"""

from typing import Any

from ..algebra.moments import (
    MAX_EXACT_POINTS,
    add_difference,
    in_meters,
    integer_moments,
    integer_steps,
    moments,
    steps_for,
)
from ..array_types import Array1
from ..arrays.packed_keys import key_index
from ..lang import array, float32, func, int32, int64, kernel, tid, vec3, vector
from ..memory import empty
from ..search.bucket_walk import leaves_within
from ..search.group_scratch import GroupScratch, LaunchPart, stored_key
from ..search.neighbor_limits import Neighborhood, members_of, neighbors_of
from ..search.point_tree import LEAF, PointTree

lane_numbers = vector(8, float32)


@func
def integer_moments_within(start: int, p: vec3, max_sqdist: float, steps: float, tree: PointTree) -> integer_moments:
    """Sums of `add_integer_moments` over the points within `max_sqdist` of p, a leaf at once: numbers without branches,
    since a vector would be copied for each point.
    """
    n = int64(0)
    sx = int64(0)
    sy = int64(0)
    sz = int64(0)
    xx = int64(0)
    xy = int64(0)
    xz = int64(0)
    yy = int64(0)
    yz = int64(0)
    zz = int64(0)
    xs = lane_numbers(0.0)
    ys = lane_numbers(0.0)
    zs = lane_numbers(0.0)
    for first in leaves_within(start, p, p, max_sqdist, tree):
        for j in range(LEAF):  # missing points are infinite
            q = tree.points[first + j]
            xs[j] = q[0] - p[0]
            ys[j] = q[1] - p[1]
            zs[j] = q[2] - p[2]
        for j in range(LEAF):
            inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist
            x = integer_steps(xs[j] if inside else 0.0, steps)
            y = integer_steps(ys[j] if inside else 0.0, steps)
            z = integer_steps(zs[j] if inside else 0.0, steps)
            n += int64(1 if inside else 0)
            sx += x
            sy += y
            sz += z
            xx += x * x
            xy += x * y
            xz += x * z
            yy += y * y
            yz += y * z
            zz += z * z
    return integer_moments(n, sx, sy, sz, xx, xy, xz, yy, yz, zz)


@func
def moments_within(start: int, p: vec3, max_sqdist: float, widest: float, tree: PointTree) -> moments:
    """Moments of the points within `max_sqdist` of p in integer steps, starting at a bucket; `widest` bounds it."""
    steps = steps_for(widest, 0)
    total = integer_moments_within(start, p, max_sqdist, steps, tree)
    if total[0] > int64(MAX_EXACT_POINTS):  # too many for these steps. Testing in the loop would take 50 % longer
        steps = steps_for(widest, int(total[0]))
        total = integer_moments_within(start, p, max_sqdist, steps, tree)
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
