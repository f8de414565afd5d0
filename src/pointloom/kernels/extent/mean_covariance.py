"""Mean, covariance and Mahalanobis distances of a cloud: two float64 passes in fixed order."""

import numpy as np

from ..algebra.transform import widen
from ..array_types import Doubles, Points
from ..lang import (
    NAN,
    array,
    dot,
    float64,
    isfinite,
    kernel,
    launch,
    mat33d,
    reduce,
    reduction,
    sqrt,
    tid,
    vec3,
    vec3d,
    vector,
)
from ..memory import download, empty

count_position = vector(4, float64)
products = vector(9, float64)  # x, y, z, then xx, xy, xz, yy, yz, zz


@reduction
def sum_positions(points: array(dtype=vec3)) -> count_position:
    i = tid()
    p = points[i]
    part = count_position(0.0)
    if isfinite(p):
        part = count_position(1.0, float64(p[0]), float64(p[1]), float64(p[2]))
    return part


@reduction
def sum_products(points: array(dtype=vec3), mean: vec3d) -> products:
    """Sums and products of the finite points' differences from a mean."""
    i = tid()
    p = points[i]
    part = products(0.0)
    if isfinite(p):
        d = widen(p) - mean
        x = d[0]
        y = d[1]
        z = d[2]
        part = products(x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)
    return part


@kernel
def measure_mahalanobis_kernel(
    points: array(dtype=vec3), mean: vec3d, inverse: mat33d, distances: array(dtype=float64)
):
    """sqrt((p - mean)^T inverse (p - mean)). NaN for non-finite points."""
    i = tid()
    p = points[i]
    distance = float64(NAN)
    if isfinite(p):
        d = widen(p) - mean
        distance = sqrt(max(dot(d, inverse @ d), 0.0))
    distances[i] = distance


def mean_and_covariance(points: Points) -> tuple[int, np.ndarray, np.ndarray]:
    """(count, mean (3), population covariance (3, 3)) of the finite points. NaN without any. Two syncs."""
    count, *total = download(reduce(sum_positions, points.size, [points]))[0].tolist()  # sync
    if count == 0:
        return 0, np.full(3, np.nan), np.full((3, 3), np.nan)
    mean = np.array(total) / count
    sums = download(reduce(sum_products, points.size, [points, vec3d(*mean)]))[0] / count  # sync
    rest, (xx, xy, xz, yy, yz, zz) = sums[:3], sums[3:]
    covariance = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) - np.outer(rest, rest)
    return int(count), mean + rest, covariance


def mahalanobis_distances(points: Points, mean: np.ndarray, inverse: np.ndarray) -> Doubles:
    """float64 (n) for a mean (3) and an inverse covariance (3, 3)."""
    distances = empty(points.size, float64, points.device)
    launch(measure_mahalanobis_kernel, points.size, [points, vec3d(*mean), mat33d(*inverse.ravel()), distances])
    return distances
