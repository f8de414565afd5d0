"""Covariances of the neighbors of each point about their mean.

Moments are integer sums of quantized differences to the point, so they are independent of the order of neighbors. With
`max_nn`, neighbors are listed in parts of 64 MB.
"""

from ..algebra.moments import add_integer_moments, covariance_of, in_meters, integer_moments, moments, steps_for
from ..array_types import Array2
from ..lang import NAN, array, float32, float64, func, int32, isfinite, kernel, launch, tid, vec3
from ..memory import empty
from ..search.distinct_points import by_distinct_points
from ..search.neighbor_lists import list_neighbors
from ..search.point_tree import BUCKET, PointTree, square_distance, widest_square
from ..search.tree_search import squared_radius
from .neighbor_moments import moments_within
from .normals import MIN_NEIGHBORS

LIST_ENTRIES = 2**24  # list entries in memory


@func
def write_covariance(m: moments, row: int, covariances: array(dtype=float32, ndim=2)):
    """Store the nine entries. The identity for fewer than three points."""
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


@kernel
def fit_covariances_nearest_kernel(
    tree: PointTree, begin: int, k: int, lists: array(dtype=int32), covariances: array(dtype=float32, ndim=2)
):
    i = tid()
    p = tree.points[begin + i]
    farthest = float(0.0)
    for j in range(i * k, (i + 1) * k):
        if lists[j] >= 0:
            farthest = max(farthest, square_distance(p, tree.points[lists[j]]))
    steps = steps_for(farthest, k)
    total = integer_moments(0)
    for j in range(i * k, (i + 1) * k):
        if lists[j] >= 0:
            total = add_integer_moments(total, p, tree.points[lists[j]], steps)
    write_covariance(in_meters(total, steps), tree.order[begin + i], covariances)


@kernel(max_registers=128)
def fit_covariances_within_kernel(
    tree: PointTree, max_sqdist: float, widest: float, covariances: array(dtype=float32, ndim=2)
):
    i = tid()
    write_covariance(moments_within(i // BUCKET, tree.points[i], max_sqdist, widest, tree), tree.order[i], covariances)


@kernel
def fill_missing_covariances_kernel(points: array(dtype=vec3), covariances: array(dtype=float32, ndim=2)):
    """Write NaN for non-finite points."""
    i = tid()
    p = points[i]
    if not isfinite(p):
        for j in range(9):
            covariances[i, j] = NAN


def estimate_covariances(tree: PointTree, max_nn: int | None, radius: float) -> Array2[float32]:
    """Covariances [m^2] of the neighbors of a tree's points, float32 (n, 9). Limits as of `estimate_normals`."""
    (covariances,) = by_distinct_points(tree, max_nn, radius, lambda tree: [_fit_covariances(tree, max_nn, radius)])
    return covariances


def _fit_covariances(tree: PointTree, max_nn: int | None, radius: float) -> Array2[float32]:
    points = tree.source
    covariances = empty((points.size, 9), float32, points.device)
    if max_nn is None:
        max_sqdist = squared_radius(radius)
        launch(
            fit_covariances_within_kernel, tree.count, [tree, max_sqdist, widest_square(tree, max_sqdist), covariances]
        )
    else:
        k = min(max_nn, max(1, tree.count))
        for begin, lists in list_neighbors(tree, k, radius, max_entries=LIST_ENTRIES):
            launch(fit_covariances_nearest_kernel, lists.size // k, [tree, begin, k, lists, covariances])
    if tree.count < points.size:
        launch(fill_missing_covariances_kernel, points.size, [points, covariances])
    return covariances
