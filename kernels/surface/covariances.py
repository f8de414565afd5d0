"""Covariances of the neighbours of each point, about their mean.

Moments are those of normals.py: differences to the point in float64, so coordinates of any size do no harm. With a
count the neighbours are listed a part at a time (4 B each, a part of 64 MB); without one the moments are summed as the
points are found. 36 B written a point.
"""

from ..lang import NAN, array, float32, float64, func, int32, isfinite, kernel, launch, tid, vec3
from ..memory import empty
from ..search.neighbor_lists import list_neighbors
from ..search.point_tree import (
    BUCKET,
    PointTree,
    points_in_reach,
    square_distance,
)
from ..search.tree_search import reach_of
from .normals import MIN_NEIGHBORS, add_moments, covariance_of, moments

LIST_ENTRIES = 2**24  # of the lists held at a time


@func
def write_covariance(m: moments, row: int, covariances: array(dtype=float32, ndim=2)) -> int:
    """Store the nine entries; the identity where fewer than three points were summed. The row."""
    C = covariance_of(m)
    few = m[0] < float64(MIN_NEIGHBORS)
    for a in range(3):
        for b in range(3):
            value = float(C[a, b])
            if few:
                value = 0.0
                if a == b:
                    value = 1.0
            covariances[row, 3 * a + b] = value
    return row


@kernel
def fit_covariances_nearest_kernel(
    points: array(dtype=vec3),
    order: array(dtype=int32),
    begin: int,
    k: int,
    lists: array(dtype=int32),
    covariances: array(dtype=float32, ndim=2),
):
    """Covariances of listed neighbours."""
    i = tid()
    p = points[begin + i]
    total = moments(float64(0.0))
    for j in range(i * k, (i + 1) * k):
        if lists[j] >= 0:
            total = add_moments(total, p, points[lists[j]])
    write_covariance(total, order[begin + i], covariances)


@kernel
def fit_covariances_within_kernel(
    tree: PointTree,
    order: array(dtype=int32),
    reach: float,
    covariances: array(dtype=float32, ndim=2),
):
    """Covariances of all points within reach."""
    i = tid()
    p = tree.points[i]
    total = moments(float64(0.0))
    for j in points_in_reach(i // BUCKET, p, reach, tree):
        if square_distance(p, tree.points[j]) <= reach:
            total = add_moments(total, p, tree.points[j])
    write_covariance(total, order[i], covariances)


@kernel
def fill_missing_covariances_kernel(points: array(dtype=vec3), covariances: array(dtype=float32, ndim=2)):
    """NaN for points that are not finite."""
    i = tid()
    p = points[i]
    if not isfinite(p):
        for j in range(9):
            covariances[i, j] = NAN


def estimate_covariances(tree, points, max_nn, radius):
    """Covariances [m^2] of the neighbours of the points that the tree was built from.

    Args:
        tree: A PointTree over `points`.
        points: Device array of vec3, shape [n].
        max_nn: Neighbours, the point itself included; None takes all within the radius.
        radius: Upper limit of the distance [m], excluded; infinity for none.

    Returns:
        float32 device array of shape [n, 9], row by row.
    """
    covariances = empty((points.size, 9), float32, points.device)
    if max_nn is None:
        search = [tree, tree.order, reach_of(radius), covariances]
        launch(fit_covariances_within_kernel, tree.count, search)
    else:
        k = min(max_nn, max(1, tree.count))
        for begin, lists in list_neighbors(tree, k, radius, most=LIST_ENTRIES):
            fit = [tree.points, tree.order, begin, k, lists, covariances]
            launch(fit_covariances_nearest_kernel, lists.size // k, fit)
    if tree.count < points.size:
        launch(fill_missing_covariances_kernel, points.size, [points, covariances])
    return covariances
