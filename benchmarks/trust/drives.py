"""Coverage of the covariances of LiDAR odometry: rows of `calibration.py --only drives`.

Errors of the poses of accepted paths relative to the first scan, along the eigenvectors of their covariances, in
standard deviations.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parents[1])]

import lidar  # noqa: E402
import lidar_scenes as made  # noqa: E402
import numpy as np  # noqa: E402
import places  # noqa: E402
import sensors  # noqa: E402
from numpy.typing import NDArray  # noqa: E402

Array = NDArray[np.float64]
OBSERVED = (4, 12, -1)  # scans
COUNT = 20  # drives of each kind
FITTED, HELD_OUT = 500, 2000  # first seeds


def placed(kind: str, seed: int) -> made.Run:
    """A drive of 32 scans through a site of `places`, starting at rest."""
    truth, scanner = sensors.drive(32, 0.8), sensors.Scanner(places.KINDS[kind](seed), seed=seed)
    return made.Run([scanner.scan(T, k) for k, T in enumerate(truth)], np.array(truth))


def street(seed: int) -> tuple[made.Run, float]:
    speed = float(np.random.default_rng([seed, 3]).uniform(0.2, 1.2))
    return lidar.street_run(seed, speed=speed), 60.0


def hall(seed: int) -> tuple[made.Run, float]:
    if seed % 2:
        return placed("hall", seed), 40.0
    return lidar.far(seed, made.hall(seed=seed), 0.3, start=5), 60.0


def wood(seed: int) -> tuple[made.Run, float]:
    return (placed("forest", seed), 40.0) if seed % 2 else (lidar.far(seed, made.forest(seed=seed), 0.5), 60.0)


KINDS: dict[str, Callable[[int], tuple[made.Run, float]]] = {
    "LiDAR path, streets": street,
    "LiDAR path, halls": hall,
    "LiDAR path, woods": wood,
    "LiDAR path, open ground": lambda seed: (placed("outdoors", seed), 40.0),
    "LiDAR path, rough tunnels": lambda seed: (placed("tunnel", seed), 40.0),
    "LiDAR path, handheld": lambda seed: (lidar.hand_run(seed, 12.0), 100.0),
}


def components(
    first: int, count: int, whitened: Callable[[Array, Array, Array], Array]
) -> Iterator[tuple[str, list[Array]]]:
    """Kind of scenes, and errors of the observed poses of accepted paths, [6] each."""
    import pointloom as loom

    for kind, make in KINDS.items():
        found = []
        for seed in range(first, first + count):
            run, max_range = make(seed)
            odometry = loom.registration.LidarOdometry(max_range=max_range, min_range=0.5)
            for scan in run.scans:
                odometry.register(loom.PointCloud(scan))
            if odometry.summary.reliable:
                truth = np.linalg.inv(run.poses[0]) @ run.poses
                for number in OBSERVED:
                    step = odometry.steps[number]
                    error = truth[number] @ np.linalg.inv(step.pose)
                    found.append(whitened(error, step.covariance.matrix, step.covariance.center))
        yield kind, found
