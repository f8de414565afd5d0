"""Comparison of two clouds: Chamfer distance, Hausdorff distance, F-score."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_numeric, check_positive
from ..kernels.extent.distance_sums import summarize_distances
from .bounds import measure_to
from .cloud import PointCloud
from .point_arrays import check_cloud


class CloudMetrics(NamedTuple):
    """Distances between two clouds.

    Attributes:
        chamfer: Sum of the mean distances in both directions [m].
        hausdorff: Maximum distance of a point to the other cloud [m].
        fscore: Harmonic mean of the percentages of points within each radius, 0..100, float64.
    """

    chamfer: float
    hausdorff: float
    fscore: NDArray[np.float64]


def compute_metrics(source: PointCloud, target: PointCloud, fscore_radius: Sequence[float] = (0.01,)) -> CloudMetrics:
    """Compute Chamfer distance, Hausdorff distance and F-scores of two clouds, as Open3D's tensor implementation.

    O(n + m) memory, float64 sums in fixed order. F-score: Knapitsch et al., "Tanks and Temples", SIGGRAPH 2017.

    Args:
        source, target: The clouds, on one device. Points that are not finite are ignored.
        fscore_radius: Exclusive radii of the F-scores [m].

    Raises:
        TypeError: If an argument is not a cloud.
        ValueError: If a cloud has no finite points or is 1.8e19 m away, or a radius is not positive.
        DeviceError: If the clouds are on different devices.

    Example:
        >>> import pointloom as loom
        >>> a, b = loom.PointCloud([[0, 0, 0], [1, 0, 0]]), loom.PointCloud([[0, 0, 0], [1, 0, 1]])
        >>> chamfer, hausdorff, fscore = loom.compute_metrics(a, b, fscore_radius=[0.5, 2])
        >>> chamfer, hausdorff, fscore.tolist()
        (1.0, 1.0, [50.0, 100.0])
    """
    given = check_numeric("fscore_radius", fscore_radius).reshape(-1).tolist()
    radii = [check_positive("fscore_radius", radius) for radius in given]
    clouds = (("source", source), ("target", target))
    for name, cloud in clouds:
        check_cloud(name, cloud)
    finite = [cloud.search_tree().count for _, cloud in clouds]
    for (name, _), count in zip(clouds, finite, strict=True):
        if not count:
            raise ValueError(f"{name}: expected at least one finite point, got none")
    sides = []
    for one, other, points in ((source, target, finite[0]), (target, source, finite[1])):
        count, total, farthest, within = summarize_distances(measure_to(one, other), radii)
        if count < points:
            raise ValueError("source, target: expected points less than 1.8e19 m apart. Crop outliers")
        sides.append((total / count, farthest, 100 * within / count))
    (forward, far, precision), (backward, away, recall) = sides
    both = precision + recall
    fscore = np.divide(2 * precision * recall, both, out=np.zeros_like(both), where=both > 0)
    return CloudMetrics(forward + backward, max(far, away), fscore)
