"""Points at the boundary of a sampled surface."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ....pcd.cloud import PointCloud
from ....pcd.search import NearestNeighborSearch


def boundary_rows(cloud: PointCloud, radius: float, max_nn: int, angle_threshold: float) -> NDArray[np.int64]:
    """Rows of the points whose neighbors leave a gap of more than `angle_threshold` degrees around the normal.

    Neighbors are projected into the tangent plane. Points without other neighbors are no boundary.
    """
    cloud = cloud.to("cpu", arrays="numpy")
    points, normals = cloud.points, cloud.normals.astype(np.float64)
    found = NearestNeighborSearch(cloud).hybrid_search(cloud, radius, max_nn).indices[:, 1:]
    side = np.cross(normals, np.eye(3)[np.abs(normals).argmin(axis=1)])
    up = np.cross(normals, side)
    steps = points[found] - points[:, None]
    angles = np.arctan2(np.einsum("nki,ni->nk", steps, up), np.einsum("nki,ni->nk", steps, side))
    has_others = (found >= 0).any(axis=1)
    angles = np.sort(np.where(found < 0, np.inf, angles)[has_others], axis=1)  # missing ones at the end
    around = angles[:, :1] + 2 * np.pi
    gaps = np.diff(np.minimum(angles, around), axis=1, append=around).max(axis=1, initial=0)
    return np.flatnonzero(has_others)[gaps > np.radians(angle_threshold)]
