"""Normals of points from lists of neighbors, for batches of clouds. One thread per point reads 24 B per neighbor."""

from ..algebra.eigen import smallest_eigenvector
from ..algebra.moments import covariance_of, moments
from ..array_types import Array1, Array2
from ..lang import array, float64, int64, kernel, launch, tid, vec3d
from ..memory import empty
from .normals import MIN_NEIGHBORS


@kernel
def fit_listed_normals_kernel(
    points: array(dtype=vec3d), neighbors: array(dtype=int64, ndim=2), normals: array(dtype=vec3d)
):
    """Unit normal of the plane through the listed neighbors, (0, 0, 1) for fewer than three. Rows below 0 are none."""
    i = tid()
    p = points[i]
    total = moments(float64(0.0))
    for j in range(neighbors.shape[1]):
        row = neighbors[i, j]
        if row >= int64(0):
            d = points[row] - p
            total = total + moments(
                float64(1.0), d[0], d[1], d[2], d[0] * d[0], d[0] * d[1], d[0] * d[2], d[1] * d[1], d[1] * d[2],
                d[2] * d[2],
            )  # fmt: skip
    n = vec3d(0.0, 0.0, 1.0)
    if total[0] >= float64(MIN_NEIGHBORS):
        n = smallest_eigenvector(covariance_of(total))
    normals[i] = n


def fit_listed_normals(points: Array1[vec3d], neighbors: Array2[int64]) -> Array1[vec3d]:
    """Normals (n) of points from neighbor rows (n, k)."""
    normals = empty(points.size, vec3d, points.device)
    launch(fit_listed_normals_kernel, points.size, [points, neighbors, normals])
    return normals
