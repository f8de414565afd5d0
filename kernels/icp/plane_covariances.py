"""Covariances of small planes, one a point: what generalised ICP takes a surface to be near each of its points.

Segal, Haehnel and Thrun, "Generalized-ICP", RSS 2009, section III: spread 1 along the surface and epsilon across it,
whatever the neighbours' true spread. With a unit normal n that is I + (epsilon - 1) n n^T, for every n; a rotation
that takes the first axis to n, as the paper has it, is not needed and not unique. 12 B read and 36 B written a point.
"""

from typing import TYPE_CHECKING

from ..algebra.transform import widen
from ..array_types import Array2, Vectors
from ..lang import (
    INFINITY,
    NAN,
    array,
    dot,
    float32,
    float64,
    func,
    isfinite,
    kernel,
    launch,
    mat33d,
    outer,
    tid,
    vec3,
    vec3d,
)
from ..memory import empty
from ..surface.normals import estimate_normals

if TYPE_CHECKING:
    from ..search.point_tree import PointTree

MIN_NEIGHBORS = 5  # fewer tell nothing certain of a plane: the identity then, as small_gicp has it


@func
def identity() -> mat33d:
    """The 3x3 identity."""
    one = float64(1.0)
    zero = float64(0.0)
    return mat33d(one, zero, zero, zero, one, zero, zero, zero, one)


@func
def plane_covariance(n: vec3d, epsilon: float64) -> mat33d:
    """Spread 1 along the plane with normal n, epsilon across it; the identity of a zero normal."""
    sqlength = dot(n, n)
    C = identity()
    if sqlength > 0.0:
        C = C + outer(n, n) * ((epsilon - 1.0) / sqlength)
    return C


@kernel
def cover_planes_kernel(
    normals: array(dtype=vec3), known: int, epsilon: float64, covariances: array(dtype=float32, ndim=2)
):
    """The covariance of each normal's plane; the identity where none is known, NaN where the normal is not finite."""
    i = tid()
    n = normals[i]
    C = identity()
    if known == 1:
        C = plane_covariance(widen(n), epsilon)
    for row in range(3):
        for column in range(3):
            value = float(NAN)
            if isfinite(n):
                value = float(C[row, column])
            covariances[i, 3 * row + column] = value


def plane_covariances_from_normals(normals: Vectors, epsilon: float) -> Array2[float32]:
    """Covariances of the planes that normals stand for.

    Args:
        normals: Device array of vec3, shape [n], of any length.
        epsilon: Variance across the plane; 1 along it.

    Returns:
        float32 device array of shape [n, 9], row by row; the identity of zero normals, NaN of those not finite. Open3D
        gives normals within 8 degrees of -x the plane of x itself, which is up to 8 degrees off; here all are exact.
    """
    covariances = empty((normals.size, 9), float32, normals.device)
    launch(cover_planes_kernel, normals.size, [normals, 1, epsilon, covariances])
    return covariances


def plane_covariances(tree: "PointTree", k: int = 20, epsilon: float = 1e-3) -> Array2[float32]:
    """Covariances of the planes fitted to the k nearest points of each point.

    Args:
        tree: The PointTree of n points.
        k: Neighbours a fit, the point itself included.
        epsilon: Variance across the plane; 1 along it.

    Returns:
        float32 device array of shape [n, 9], row by row: the eigenvalues of the neighbours' covariance replaced by
        (epsilon, 1, 1). The identity where fewer than 5 neighbours are found, NaN for points that are not finite.
    """
    points = tree.source
    normals = estimate_normals(tree, points, k, INFINITY)
    covariances = empty((points.size, 9), float32, points.device)
    known = min(k, tree.count) >= MIN_NEIGHBORS
    launch(cover_planes_kernel, points.size, [normals, int(known), epsilon, covariances])
    return covariances
