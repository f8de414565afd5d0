"""Mean distance to the k nearest points, and distance to the nearest point of another cloud (float32)."""

import math

from ..array_types import Doubles, Mask, Points
from ..arrays.packed_keys import key_number
from ..lang import (
    INFINITY,
    NAN,
    array,
    compute,
    float64,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    reduce,
    reduction,
    sqrt,
    tid,
    uint8,
    vec3,
    vector,
)
from ..memory import download, empty, full
from .distinct_points import by_distinct_points
from .group_scratch import GroupScratch, LaunchPart, stored_key
from .group_search import launch_over_leaves, nearest_of_leaves
from .nearest_point import find_nearest
from .point_tree import LARGEST_SQDIST, PointTree

count_sum = vector(2, float64)


@kernel(max_registers=80)
def average_distances_kernel(
    part: LaunchPart, tree: PointTree, labels: array(dtype=int32), scratch: GroupScratch, means: array(dtype=float64)
):
    """Mean distance of the k nearest points including the point itself, infinite for fewer than k."""
    i = tid()
    for rank, base, size in nearest_of_leaves(i, part, tree, labels, scratch, LARGEST_SQDIST, 0):
        total = float64(0.0)
        if size < scratch.k:
            total = float64(INFINITY)
        for j in range(size):
            total += float64(sqrt(key_number(stored_key(scratch, base, j))))
        means[tree.order[rank]] = total / float64(size)


@reduction
def sum_finite(values: array(dtype=float64)) -> count_sum:
    i = tid()
    value = values[i]
    part = count_sum(0.0, 0.0)
    if isfinite(value):
        part = count_sum(1.0, value)
    return part


@reduction
def sum_deviations(values: array(dtype=float64), mean: float64) -> count_sum:
    """Count of finite values and the sum of their squared deviations from the mean."""
    i = tid()
    value = values[i]
    part = count_sum(0.0, 0.0)
    if isfinite(value):
        part = count_sum(1.0, (value - mean) * (value - mean))
    return part


@kernel
def mask_up_to_kernel(values: array(dtype=float64), threshold: float64, mask: array(dtype=uint8)):
    """1 where a value is at most the threshold. 0 for NaN."""
    i = tid()
    is_selected = 0
    if values[i] <= threshold:
        is_selected = 1
    mask[i] = uint8(is_selected)


@kernel
def root_distances_kernel(
    nearest: array(dtype=int64), queries: array(dtype=vec3), missing: float, distances: array(dtype=float64)
):
    """Distance to each query's nearest point; `missing` if there is none, NaN for a non-finite query."""
    i = tid()
    q = queries[i]
    distance = float64(missing)
    if nearest[i] >= 0:
        distance = sqrt(float64(key_number(nearest[i])))
    if not isfinite(q):
        distance = float64(NAN)
    distances[i] = distance


def average_distances(tree: PointTree, k: int) -> Doubles:
    """Mean distance [m] to the k nearest points including itself, float64 (n). NaN for non-finite points.

    Copies of a position count once where the `k` nearest points are copies, whose mean distance would be 0.
    """
    (means,) = by_distinct_points(tree, k, INFINITY, lambda tree: [_average_distances(tree, k)], most=k - 1)
    return means


def _average_distances(tree: PointTree, k: int) -> Doubles:
    points, device = tree.source, tree.device
    means = full(points.size, NAN, float64, device)
    if tree.count == 0:
        return means
    launch_over_leaves(average_distances_kernel, tree, k, [means])
    return means


def nearest_distances(tree: PointTree, queries: Points, *, others: bool = False, missing: float = INFINITY) -> Doubles:
    """Distance [m] to each query's nearest point, excluding itself with `others`; `missing` if there is none."""
    distances = empty(queries.size, float64, queries.device)
    nearest = find_nearest(tree, queries, others=others)
    launch(root_distances_kernel, queries.size, [nearest, queries, float(missing), distances])
    return distances


def mean_and_deviation(values: Doubles) -> tuple[int, float, float]:
    """(count, mean, sample deviation) of the finite values of a float64 device array. Two syncs."""
    n, total = download(reduce(sum_finite, values.size, [values]))[0].tolist()  # sync
    if n == 0:
        return 0, NAN, NAN
    _, squares = download(reduce(sum_deviations, values.size, [values, total / n]))[0].tolist()  # sync
    return int(n), total / n, math.sqrt(squares / (n - 1)) if n > 1 else 0.0


def mask_up_to(values: Doubles, threshold: float) -> Mask:
    return compute(mask_up_to_kernel, values.size, [values, threshold], uint8, values.device)
