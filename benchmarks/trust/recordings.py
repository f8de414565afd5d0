"""Coverage of LiDAR odometry on real recordings without ground truth: rows of `calibration.py --only recordings`.

The same scans forward and backward, in two runs: the product of both end poses is the identity but for their errors.
With half the points of each scan forward and the other half backward, the noise of the two runs is independent. Errors
that both directions share, such as a wrong range scale, cancel.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
LENGTH = 10  # scans of a path
PARTS = {  # points of each scan on the way there and back
    "odometry, there and back": (slice(None), slice(None)),
    "odometry, half of the points each": (slice(0, None, 2), slice(1, None, 2)),
}


class Recording(NamedTuple):
    """Scans in `POINTLOOM_DATA/folder`. Constants were chosen on the first `fitted_count` of them."""

    sensor: str
    folder: str
    max_range: float
    min_range: float
    fitted_count: int


RECORDINGS = (
    Recording("64 beams over 90 degrees, handheld", "lidar-balm", 50.0, 1.0, 88),
    Recording("64 beams on a car", "lidar-udacity-2", 100.0, 5.0, 154),
    Recording("64 beams on a car", "lidar-udacity-1", 100.0, 5.0, 0),
    Recording("64 beams on a car, deskewed", "lidar-mulls", 100.0, 5.0, 0),
)


def read_scan(path: Path) -> NDArray[np.float32]:
    """Points [m] of a binary PCD file whose coordinates come first, which may have bytes after its points."""
    head, _, body = path.read_bytes().partition(b"DATA binary")
    fields = {line.split()[0]: line.split()[1:] for line in head.decode().splitlines() if line and line[0] != "#"}
    size = sum(int(a) * int(b) for a, b in zip(fields["SIZE"], fields["COUNT"], strict=True))
    count, start = int(fields["POINTS"][0]), body.index(b"\n") + 1
    rows = np.frombuffer(body, np.uint8, count * size, start).reshape(count, size)
    points = np.ascontiguousarray(rows[:, :12]).view(np.float32)
    return points[np.isfinite(points).all(axis=1) & (np.abs(points).max(axis=1) > 0.3)]


def components(
    is_fitted: bool, count: int, whitened: Callable[[Array, Array, Array], Array]
) -> Iterator[tuple[str, str, Array]]:
    """Sensor, method, and error [6] of each path that is accepted in both directions."""
    for recording in RECORDINGS:
        files = list((Path(os.environ.get("POINTLOOM_DATA", ".")) / recording.folder).glob("*.pcd"))
        files.sort(key=lambda path: int(re.findall(r"\d+", path.stem)[-1]))
        files = files[: recording.fitted_count] if is_fitted else files[recording.fitted_count :]
        for first in range(0, len(files) - LENGTH + 1, LENGTH)[:count]:
            scans = [read_scan(path) for path in files[first : first + LENGTH]]
            for method, parts in PARTS.items():
                error = closure(recording, scans, parts, whitened)
                if error is not None:
                    yield recording.sensor, method, error


def closure(
    recording: Recording,
    scans: list[NDArray[np.float32]],
    parts: tuple[slice, slice],
    whitened: Callable[[Array, Array, Array], Array],
) -> Array | None:
    import pointloom as loom

    ends = []
    for part, way in zip(parts, (1, -1), strict=True):
        odometry = loom.registration.LidarOdometry(max_range=recording.max_range, min_range=recording.min_range)
        for scan in scans[::way]:
            odometry.register(loom.PointCloud(scan[part]))
        if not odometry.summary.reliable:
            return None
        ends.append(odometry.steps[-1])
    there, back = ends
    T, center = there.pose, there.pose[:3, 3]
    axes = np.kron(np.eye(2), T[:3, :3])  # those of the last scan, which is the world of the way back
    of_back = axes @ back.covariance.about(np.zeros(3)).matrix @ axes.T
    return whitened(np.linalg.inv(T @ back.pose), there.covariance.about(center).matrix + of_back, center)
