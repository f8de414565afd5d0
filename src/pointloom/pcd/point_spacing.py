"""Point spacing of a cloud from a sample, for hints about lengths."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .length_checks import rounded_up as rounded_up
from .search import NearestNeighborSearch

# Number of sample points, evenly spread over the file.
_PROBE_COUNT = 1000

# Maximum neighbors of all probes, 8 B each.
_MAX_NEIGHBORS = 1000


def probe_points(cloud: Any) -> NDArray[np.float64]:
    """Sample of the finite points, (m, 3). Empty if there are none."""
    points = cloud.points
    points = points[np.isfinite(points).all(axis=1)]
    return points[:: max(1, len(points) // _PROBE_COUNT)]


def distance_of_nearest(
    search: NearestNeighborSearch, probes: NDArray[np.float64], count: int, fraction: float = 0.5
) -> float | None:
    """Distance [m] within which this fraction of the probes have `count` points, themselves included. None if there are
    too few or too many points, or no probe."""
    if not len(probes) or count > _MAX_NEIGHBORS:
        return None
    neighbors = search.knn_search(probes, count)
    if (neighbors.counts < count).any():
        return None
    return float(np.sqrt(np.quantile(neighbors.sqdists[:, -1].astype(np.float64), fraction)))
