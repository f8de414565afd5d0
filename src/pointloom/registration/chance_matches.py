"""Whether points match better than unrelated points would by chance, for clouds without surfaces to compare.

The number of false alarms (core/false_alarms.py) of n points and m possible partners of each. An unrelated point is
within a distance r of one of the m points with at most the probability of the union bound for uniform points in their
box. On surfaces and in clusters it is at least the fraction of the m points that are within r of another one. It is a
half at the median of these distances d, times (r / d)^2 below it, as on a grid of a surface.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..core.coordinates import quiet
from ..core.false_alarms import is_chance
from ..kernels.linear_algebra import eigh, matmul
from ..pcd.cloud import PointCloud
from ..pcd.search import NearestNeighborSearch
from .voxel_size import EXTENT_QUANTILE, VOXELS_TO_MIDDLE, extent_of

Points = NDArray[np.float64]
RIGID_SAMPLE, AFFINE_SAMPLE = 3, 4  # points that determine the map

TOO_FEW = (
    "too few points to decide whether the pose is correct: unrelated points as dense as these {} and {} would match as "
    "well by chance. Use more points, or points whose distances are small compared with their spacing"
)
NOT_COMPARED = "the clouds could not be compared: outliers are too far away for a grid of voxels. Remove them"


@quiet()
def find_too_few(source: PointCloud, T: NDArray[np.float64], target: PointCloud, sample: int = RIGID_SAMPLE) -> str:
    """The warning of points that may match by chance under T_target_source; "" if they match better, both ways.

    `sample`: number of points that determine the map. Neighbors within 1/32 of the clouds' size count as one point,
    since they are not independent.
    """
    moved = source.transform(T)
    try:
        size = min(extent_of("source", moved), extent_of("target", target)) / VOXELS_TO_MIDDLE
        sets = _thinned(moved, size), _thinned(target, size)
    except ValueError:  # as in `find_problem`
        return NOT_COMPARED
    counts = [len(cloud) for cloud in sets]
    may_be_chance = any(_match_by_chance(a, b, sample) for a, b in (sets, sets[::-1]))
    return TOO_FEW.format(*(f"{count:,}" for count in counts)) if may_be_chance else ""


def _thinned(cloud: PointCloud, size: float) -> PointCloud:
    thinned = cloud.average_voxels(size, ["points"]) if size > 0 else cloud.remove_duplicated_points()
    return thinned.remove_non_finite_points().to(cloud.device, arrays="numpy")


def _match_by_chance(source: PointCloud, target: PointCloud, sample: int) -> bool:
    n, m = len(source), len(target)
    if min(n, m) <= sample:
        return True
    search = NearestNeighborSearch(target)
    nearest = search.knn_search(source, 1)
    distances, own = (
        np.sort(np.sqrt(sqdists[:, -1].astype(np.float64)))
        for sqdists in (nearest.sqdists, search.knn_search(target, 2).sqdists)
    )
    if sample > RIGID_SAMPLE:  # the distances of points that determine a flexible map are shorter by its mean leverage
        distances /= 1 - sample / n
    chances = _chances(target.points, np.unique(nearest.indices[:, 0]), distances)
    of_own = np.searchsorted(own, distances, side="right") / m
    of_surface = 0.5 * np.minimum(distances / max(float(np.median(own)), np.finfo(np.float64).tiny), 1.0) ** 2
    chances = np.maximum.reduce([chances, of_own, of_surface])
    return is_chance(chances, sample, float(m) ** sample)


def _chances(points: Points, partners: NDArray[np.integer], distances: Points) -> Points:
    """Upper bound of the probability that a point in the box of the partners is within each distance of any point.

    The box has the principal axes of the partners, and the width of a uniform distribution with the same three quarters
    of them, so that outliers do not widen it. A ball is larger than the box along axes shorter than its diameter.
    """
    near = points[partners] - np.median(points[partners], axis=0)
    axes = eigh(matmul(near.T, near))[1]
    half = np.quantile(np.abs(matmul(near, axes)), EXTENT_QUANTILE, axis=0) / EXTENT_QUANTILE
    along = np.abs(matmul(points - np.median(points[partners], axis=0), axes))
    count = int((along <= half + 1e-9 * half.max()).all(axis=1).sum())
    lengths, diameters = 2 * half, 2 * distances[:, None]
    is_inside = diameters < lengths
    fractions = np.divide(diameters, lengths, out=np.ones(is_inside.shape), where=is_inside).prod(axis=1)
    ball = np.array([1.0, 1.0, np.pi / 4, np.pi / 6])[is_inside.sum(axis=1)]  # relative to its box
    return np.minimum(max(count, 1) * ball * fractions, 1.0)
