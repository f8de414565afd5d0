"""Distance fields beside scipy and, where it is installed, edt: times on one core, and whether all say the same.

    python benchmarks/distance_fields.py [--size 256] [--scan FILE --voxel-size 0.1 --max-distance 2]

Dense boxes of `size`^3 voxels: a share of them set at random, walls, one voxel. edt (Silversmith, 2018) has float32 and
gives no nearest voxel; scipy gives it here, as ours keep it. A scan is measured in its own blocks, and beside scipy's
transform of the dense box around it where that has room. Times are of the thread's processor, the best of three.
"""

from __future__ import annotations

import os

os.environ.setdefault("POINTLOOM_CPU_THREADS", "1")

import argparse
import importlib.util
import math
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

import pointloom as loom

MAX_VOXELS = 2**27  # of a dense box that scipy is asked for: 5 GB
QUERIES = 500_000


def best_of(work: Callable[[], Any], times: int = 3) -> tuple[float, Any]:
    """Seconds of the best of some runs, and what the last gave."""
    found, least = None, math.inf
    for _ in range(times):
        begin = time.thread_time()
        found = work()
        least = min(least, time.thread_time() - begin)
    return least, found


def boxes(size: int) -> dict[str, NDArray[np.bool_]]:
    """What is measured."""
    rng = np.random.default_rng(0)
    walls, one = np.zeros((size,) * 3, bool), np.zeros((size,) * 3, bool)
    walls[:, :, 0], walls[0], walls[:, size // 3, : size // 2] = True, True, True
    one[size // 3, size // 5, size // 2] = True
    return {"1 % at random": rng.random((size,) * 3) < 0.01, "walls": walls, "one voxel": one}


def measure_boxes(size: int) -> None:
    """Print the times of dense boxes."""
    peer: Any = importlib.import_module("edt") if importlib.util.find_spec("edt") else None
    print(f"{'dense ' + str(size) + '^3':24}{'ours [s]':>10}{'scipy':>10}{'edt':>10}   squared distances equal")
    for name, occupied in boxes(size).items():
        loom.DistanceField.from_array(occupied[:8, :8, :8])
        ours, field = best_of(lambda: loom.DistanceField.from_array(occupied))  # noqa: B023  at once
        theirs, expected = best_of(lambda: ndimage.distance_transform_edt(~occupied, return_indices=True)[0], 1)  # noqa: B023
        other, found = best_of(lambda: peer.edt(~occupied, parallel=1)) if peer else (math.nan, None)  # noqa: B023
        squared = field.to_array(values="squared")
        same = [bool((squared == np.rint(expected**2)).all())]
        same += [bool((squared == np.rint(found.astype(np.float64) ** 2)).all())] if found is not None else []
        print(f"{name:24}{ours:10.3f}{theirs:10.3f}{other:10.3f}   {same}")


def measure_scan(path: str, voxel_size: float, reach: float) -> None:
    """Print what a scan takes, and its queries."""
    cloud = loom.read_point_cloud(path)
    seconds, field = best_of(lambda: loom.DistanceField.from_point_cloud(cloud, voxel_size, reach))
    low, high = field.bounds
    size = np.rint((high - low) / voxel_size).astype(int)
    print(f"{path}: {field}, {field.memory_bytes / 1e6:.0f} MB, {seconds:.3f} s; dense {' x '.join(map(str, size))}")
    if math.prod(size.tolist()) <= MAX_VOXELS:
        occupied = field.to_array() == 0
        theirs, expected = best_of(lambda: ndimage.distance_transform_edt(~occupied, return_indices=True)[0], 1)
        expected = np.rint(expected**2)
        found = field.to_array(values="squared")
        limit = math.floor((reach / voxel_size) ** 2)
        same = np.array_equal(found, np.where(expected <= limit, expected, 2**31 - 1))
        print(f"  scipy on the dense box: {theirs:.3f} s, {theirs / seconds:.0f} times as long; equal: {same}")
    points = np.random.default_rng(0).uniform(low, high, (QUERIES, 3))
    body = np.column_stack([np.linspace(-0.4, 0.4, 20), np.zeros((20, 2)), np.full(20, 0.1)])
    poses = np.tile(np.eye(4), (QUERIES // 20, 1, 1))
    poses[:, :3, 3] = points[: len(poses)]
    asked = {
        "distances": lambda: field.distances(points),
        "interpolated": lambda: field.distances(points, interpolate=True),
        "gradients": lambda: field.gradients(points),
        "nearest obstacles": lambda: field.nearest_obstacles(points),
        "spheres": lambda: field.collides(points, 0.1),
        "spheres of bodies": lambda: field.collides_bodies(body, poses),
    }
    for name, work in asked.items():
        work()
        print(f"  {name:20}{best_of(work)[0] / QUERIES * 1e9:8.0f} ns each")


def main() -> None:
    """Measure what is asked for."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--scan")
    parser.add_argument("--voxel-size", type=float, default=0.1)
    parser.add_argument("--max-distance", type=float, default=2.0)
    given = parser.parse_args()
    measure_boxes(given.size)
    if given.scan:
        measure_scan(given.scan, given.voxel_size, given.max_distance)


if __name__ == "__main__":
    main()
