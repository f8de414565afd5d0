"""Plane covariances of generalized ICP: Segal, Haehnel and Thrun, "Generalized-ICP", RSS 2009, section III. Variance 1
along the surface and epsilon across it: I + (epsilon - 1) n n^T.
"""

from typing import TYPE_CHECKING

from ..algebra.eigen import values_and_smallest_vector
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
from ..search.distinct_points import distinct_points
from ..surface.normals import estimate_normals

if TYPE_CHECKING:
    from ..search.point_tree import PointTree

MIN_SEPARATION = 1e-6  # of the two smallest variances, relative to the largest: below it float32 determines no plane
MIN_NEIGHBORS = 5  # fewer do not determine a plane: the identity then, as in small_gicp


@func
def identity() -> mat33d:
    one = float64(1.0)
    zero = float64(0.0)
    return mat33d(one, zero, zero, zero, one, zero, zero, zero, one)


@func
def plane_covariance(n: vec3d, epsilon: float64) -> mat33d:
    """Covariance I + (epsilon - 1) n n^T. The identity for a zero normal."""
    sqlength = dot(n, n)
    C = identity()
    if sqlength > 0.0:
        C = C + outer(n, n) * ((epsilon - 1.0) / sqlength)
    return C


@func
def write_covariance(covariances: array(dtype=float32, ndim=2), i: int, C: mat33d, known: float64):
    """Write a row of covariances, NaN if `known` is not finite."""
    for row in range(3):
        for column in range(3):
            value = float(NAN)
            if isfinite(known):
                value = float(C[row, column])
            covariances[i, 3 * row + column] = value


@kernel
def cover_planes_kernel(
    normals: array(dtype=vec3), known: int, epsilon: float64, covariances: array(dtype=float32, ndim=2)
):
    """Covariance of each normal's plane. The identity if unknown, NaN for non-finite normals."""
    i = tid()
    n = widen(normals[i])
    C = identity()
    if known == 1:
        C = plane_covariance(n, epsilon)
    write_covariance(covariances, i, C, dot(n, n))


@kernel
def flatten_covariances_kernel(
    given: array(dtype=float32, ndim=2), epsilon: float64, covariances: array(dtype=float32, ndim=2)
):
    """Covariance of the plane across the smallest variance. The identity if there is no plane, NaN for non-finite."""
    i = tid()
    C = identity()
    total = float64(0.0)
    for row in range(3):
        for column in range(3):
            C[row, column] = (float64(given[i, 3 * row + column]) + float64(given[i, 3 * column + row])) * 0.5
            total += C[row, column]
    flat = identity()
    if isfinite(total):
        values = values_and_smallest_vector(C)
        if values[1] - values[0] > float64(MIN_SEPARATION) * values[2]:
            flat = plane_covariance(vec3d(values[3], values[4], values[5]), epsilon)
    write_covariance(covariances, i, flat, total)


def flatten_covariances(given: Array2[float32], epsilon: float) -> Array2[float32]:
    """Plane covariances (n, 9) of covariances (n, 9), as small_gicp regularizes them."""
    covariances = empty(given.shape, float32, given.device)
    launch(flatten_covariances_kernel, len(given), [given, epsilon, covariances])
    return covariances


def plane_covariances_from_normals(normals: Vectors, epsilon: float) -> Array2[float32]:
    """Plane covariances (n, 9) of normals of any length, or identity for zero, NaN for non-finite."""
    covariances = empty((normals.size, 9), float32, normals.device)
    launch(cover_planes_kernel, normals.size, [normals, 1, epsilon, covariances])
    return covariances


def plane_covariances(tree: "PointTree", k: int = 20, epsilon: float = 1e-3) -> Array2[float32]:
    """Covariances (n, 9) of planes fitted to the k nearest points, or identity for fewer than 5 neighbors."""
    points, normals = tree.source, estimate_normals(tree, k, INFINITY)
    distinct = distinct_points(tree, k)
    covariances = empty((points.size, 9), float32, points.device)
    known = min(k, tree.count if distinct is None else distinct.tree.count) >= MIN_NEIGHBORS
    launch(cover_planes_kernel, points.size, [normals, int(known), epsilon, covariances])
    return covariances
