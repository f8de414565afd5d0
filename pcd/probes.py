"""How far apart the points of a cloud lie, by a sample of them: for hints where a length was chosen badly."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .search import NearestNeighborSearch

# A length is judged by the neighbours of this many points, evenly spread over the file.
_PROBES = 1000

# Hints are not worth a search for more: 8 B a neighbour of each probe, and time that grows faster than that.
_MOST_NEIGHBORS = 1000


def probe_points(cloud: Any) -> NDArray[np.float64]:
    """Some of the finite points of a cloud, shape [m, 3]; empty where there is none."""
    points = cloud.points
    points = points[np.isfinite(points).all(axis=1)]
    return points[:: max(1, len(points) // _PROBES)]


def distance_of_nearest(
    search: NearestNeighborSearch, probes: NDArray[np.float64], count: int, share: float = 0.5
) -> float | None:
    """The distance [m] up to which this share of the probes have `count` points, themselves included.

    None where a probe has not so many at all, where they are too many to search for, or where there is no probe.
    """
    if not len(probes) or count > _MOST_NEIGHBORS:
        return None
    found = search.knn_search(probes, count)
    if (found.counts < count).any():
        return None
    return float(np.sqrt(np.quantile(found.sqdists[:, -1].astype(np.float64), share)))


def rounded_up(length: float) -> float:
    """A length above 0 to two digits, not below it: what a hint proposes reaches as far as it says."""
    step = 10.0 ** (math.floor(math.log10(length)) - 1)
    return float(f"{math.floor(length / step + 1) * step:.2g}")
