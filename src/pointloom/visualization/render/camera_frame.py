"""Detect data in the frame of a camera: x right, y down, z forward."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...kernels.arrays.select import gather_rows
from ...kernels.lang import int32
from ...kernels.memory import download, upload
from ...pcd.cloud import PointCloud
from .frustum import CameraFrustum

MAX_TESTED_POINTS = 20_000  # evenly spaced: at least 20 points per row of a depth image of 1000 rows
FIRST_TESTED_POINTS = 200  # which other clouds fail, so that few bytes are downloaded
MIN_ROWS = 8  # tested pixel rows and points per row: fewer may be in this order by chance
MIN_COSINE = 0.9  # axes of the first camera within 26 degrees of those of the scene
SAME_ROW = 2e-6  # relative difference of y / z in a pixel row: 20 roundings of float32. Rows differ by about 2e-3
MIN_DEPTH_RANGE = 1e-3  # relative depth variation in a row: a flat grid of points is no depth image


def is_in_camera_frame(geometry: object) -> bool:
    """True if the frame of a geometry is that of a camera: a cloud of a depth image in its order, or a first camera."""
    if isinstance(geometry, CameraFrustum):
        axes = geometry.T_world_camera[:3, :3]
        return bool(axes[1, 1] > MIN_COSINE and axes[2, 2] > MIN_COSINE)
    if not isinstance(geometry, PointCloud) or geometry.origin.any() or len(geometry) < MIN_ROWS**2:
        return False
    return _is_raster(_sample(geometry, FIRST_TESTED_POINTS), 1) and _is_raster(_sample(geometry, MAX_TESTED_POINTS))


def _sample(cloud: PointCloud, count: int) -> NDArray[np.float64]:
    """Evenly spaced finite points."""
    rows = np.linspace(0, len(cloud) - 1, min(len(cloud), count)).astype(np.int32)
    points = cloud.arrays["points"]
    sample = download(gather_rows(points, upload(rows, int32, points.device))).astype(np.float64)  # sync
    return sample[np.isfinite(sample).all(axis=1)]


def _is_raster(points: NDArray[np.float64], min_rows: int = MIN_ROWS) -> bool:
    """True if points (n, 3) are in the order of pixels: y / z constant in a row and increasing, x / z increasing.

    With `min_rows` 1, only the order is tested.
    """
    if len(points) < min_rows**2 or not (points[:, 2] > 0).all():
        return False
    column, row = points[:, 0] / points[:, 2], points[:, 1] / points[:, 2]
    size = max(float(np.abs(row).max()), 1.0)
    steps = np.diff(row)
    is_new = steps > SAME_ROW * size
    if (steps < -SAME_ROW * size).any() or (np.diff(column)[~is_new] <= 0).any():
        return False
    if min_rows == 1:
        return True
    starts = np.concatenate([[0], np.flatnonzero(is_new) + 1])
    counts = np.diff(np.append(starts, len(points)))
    depths = np.maximum.reduceat(points[:, 2], starts) / np.minimum.reduceat(points[:, 2], starts) - 1
    return bool(len(starts) >= MIN_ROWS and np.median(counts) >= MIN_ROWS and depths.max() > MIN_DEPTH_RANGE)
