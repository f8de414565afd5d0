"""Synthetic scans of a spinning LiDAR that drives along a street (scenes/street.py)."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...core.checks import check_count, check_seed
from ...pcd.cloud import PointCloud
from ..array_cache import Arrays, cached
from ..scenes.drive import SCAN_PERIOD, in_world, pose_at, rotating_rays, sensor_pose
from ..scenes.street import painted_street
from .results import PosedScans

BEAM_ANGLES = np.radians(np.concatenate([np.linspace(-24.0, -4.0, 18), np.linspace(-3.0, 12.0, 14)]))  # 32, dense ahead
AZIMUTH_COUNT = 1024
DRIVE_SPEED = 10.0  # [m/s]
MAX_RANGE, MIN_RANGE = 80.0, 1.0  # [m]
RANGE_NOISE = 0.01  # [m] standard deviation


def street_scans(count: int = 10, *, seed: int = 0) -> PosedScans:
    """Synthetic scans of a LiDAR on a car that drives along a street, with true poses.

    32 rings of 1024 directions at 10 Hz and 10 m/s, so scans are 1 m apart. The motion skews each scan by up to 1 m;
    `deskew_point_cloud` corrects it. Range noise is 1 cm. The range is 1 to 80 m.

    Args:
        count: Number of scans. 10 are one second.
        seed: Seed of the street and the noise.

    Returns:
        `scans`: clouds of about 25,000 points [m], in the frame of the scanner at the end of the rotation (x ahead, y
        left, z up), with `colors` and the attributes `time` (float64 [s] since the start), `ring` (uint8, 0 to 31 from
        the lowest), `intensity` (float32, 0 to 1) and `label` (uint8, ground truth: 1 road, 2 pavement, 3 grass, 4
        house, 5 car, 6 tree, 7 pole, 8 fence). `poses`: T_street_scanner at the end of each rotation, float64 (n, 4, 4)
        [m]. The ground is at z = 0.

    Raises:
        TypeError: A count that is not an integer.
        ValueError: A count below 1.

    Notes:
        Bitwise reproducible. Cached in the user's cache folder if it took long.

    Example:
        >>> import pointloom as loom
        >>> drive = loom.datasets.street_scans(2)
        >>> step = drive.poses[1][:3, 3] - drive.poses[0][:3, 3]
        >>> len(drive.scans), round(float(step @ step) ** 0.5, 1)
        (2, 1.0)
    """
    count, seed = check_count("count", count), check_seed(seed)
    arrays = cached("street_scans", {"count": count, "seed": seed}, lambda: _drive(count, seed))
    ends = np.cumsum(arrays.pop("counts"))[:-1]
    columns: dict[str, Any] = {name: np.split(values, ends) for name, values in arrays.items()}
    scans = [PointCloud(**{name: values[k] for name, values in columns.items()}) for k in range(count)]
    return PosedScans(scans, np.array([sensor_pose(k * DRIVE_SPEED * SCAN_PERIOD) for k in range(count)]))


def _drive(count: int, seed: int) -> Arrays:
    parts = painted_street(count * DRIVE_SPEED * SCAN_PERIOD, seed)
    scene, colors, labels = parts.scene(), parts.colors, parts.labels
    rng, scans = np.random.default_rng([seed, 1]), []
    for k in range(count):
        rays, fraction = rotating_rays(BEAM_ANGLES, AZIMUTH_COUNT, rng)
        positions, headings = pose_at((k + fraction - 1) * DRIVE_SPEED * SCAN_PERIOD, 0.0)
        directions = in_world(rays, headings)
        hits = scene.cast_rays(np.concatenate([positions, directions], axis=1))
        ranges = hits["t_hit"].astype(np.float64) + rng.normal(0, RANGE_NOISE, len(rays))
        seen = np.isfinite(ranges) & (ranges > MIN_RANGE) & (ranges < MAX_RANGE)
        rows = hits["primitive_ids"][seen]
        cosine = np.abs((directions * hits["primitive_normals"]).sum(axis=1))[seen]
        light = (0.25 + 0.75 * cosine) * colors[rows].mean(axis=1)
        scans.append(
            {
                "points": (rays[seen] * ranges[seen, None]).astype(np.float32),
                "colors": colors[rows],
                "time": (k + fraction[seen]) * SCAN_PERIOD,
                "ring": np.tile(np.arange(len(BEAM_ANGLES), dtype=np.uint8), AZIMUTH_COUNT)[seen],
                "intensity": light.astype(np.float32),
                "label": labels[rows],
            }
        )
    columns = {name: np.concatenate([scan[name] for scan in scans]) for name in scans[0]}
    return columns | {"counts": np.array([len(scan["time"]) for scan in scans])}
