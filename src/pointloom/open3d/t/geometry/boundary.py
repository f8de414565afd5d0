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
    angles = np.sort(np.where(found < 0, np.nan, angles), axis=1)  # NaN at the end
    around = np.nanmin(angles, axis=1, keepdims=True, initial=np.inf) + 2 * np.pi
    gaps = np.diff(np.where(np.isnan(angles), around, angles), axis=1, append=around)
    has_others = (found >= 0).any(axis=1)
    return np.flatnonzero(has_others & (np.max(gaps, axis=1, initial=0) > np.radians(angle_threshold)))
