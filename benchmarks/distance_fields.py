"""Distance fields beside scipy and, if installed, edt: times on one core, and whether all results are equal.

    python benchmarks/distance_fields.py [--size 256] [--scan FILE --voxel-size 0.1 --max-distance 2]

Dense boxes of `size`^3 voxels: a random fraction occupied, walls, one voxel. edt (Silversmith, 2018) uses float32 and
returns no nearest voxel; scipy returns it here, as pointloom does. A scan is measured in its own blocks, and compared
with scipy's transform of the dense box around it if that fits into memory. Times are the thread's CPU time, the best of
three.
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

MAX_VOXELS = 2**27  # maximum size of a dense box for scipy: 5 GB
QUERIES = 500_000


def best_of(work: Callable[[], Any], times: int = 3) -> tuple[float, Any]:
    """The best time of some runs, and the last result."""
    result, best = None, math.inf
    for _ in range(times):
        begin = time.thread_time()
        result = work()
        best = min(best, time.thread_time() - begin)
    return best, result


def boxes(size: int) -> dict[str, NDArray[np.bool_]]:
    """The measured boxes."""
    rng = np.random.default_rng(0)
    walls, one = np.zeros((size,) * 3, bool), np.zeros((size,) * 3, bool)
    walls[:, :, 0], walls[0], walls[:, size // 3, : size // 2] = True, True, True
    one[size // 3, size // 5, size // 2] = True
    return {"1 % at random": rng.random((size,) * 3) < 0.01, "walls": walls, "one voxel": one}


def measure_boxes(size: int) -> None:
    """Print the times of dense boxes."""
    peer: Any = importlib.import_module("edt") if importlib.util.find_spec("edt") else None
    print(f"{'dense ' + str(size) + '^3':24}{'pointloom':>10}{'scipy':>10}{'edt':>10}   squared distances equal")
    for name, occupied in boxes(size).items():
        loom.DistanceField.from_array(occupied[:8, :8, :8])
        seconds, field = best_of(lambda: loom.DistanceField.from_array(occupied))  # noqa: B023  at once
        scipy_seconds, expected = best_of(lambda: ndimage.distance_transform_edt(~occupied, return_indices=True)[0], 1)  # noqa: B023
        other, edt_field = best_of(lambda: peer.edt(~occupied, parallel=1)) if peer else (math.nan, None)  # noqa: B023
        squared = field.to_array(values="squared")
        same = [bool((squared == np.rint(expected**2)).all())]
        same += [bool((squared == np.rint(edt_field.astype(np.float64) ** 2)).all())] if edt_field is not None else []
        print(f"{name:24}{seconds:10.3f}{scipy_seconds:10.3f}{other:10.3f}   {same}")


def measure_scan(path: str, voxel_size: float, max_distance: float) -> None:
    """Print the times of the field of a scan, and of its queries."""
    cloud = loom.read_point_cloud(path)
    seconds, field = best_of(lambda: loom.DistanceField.from_point_cloud(cloud, voxel_size, max_distance))
    low, high = field.bounds
    size = np.rint((high - low) / voxel_size).astype(int)
    print(f"{path}: {field}, {field.memory_bytes / 1e6:.0f} MB, {seconds:.3f} s; dense {' x '.join(map(str, size))}")
    if math.prod(size.tolist()) <= MAX_VOXELS:
        occupied = field.to_array() == 0
        scipy_seconds, expected = best_of(lambda: ndimage.distance_transform_edt(~occupied, return_indices=True)[0], 1)
        expected = np.rint(expected**2)
        squared = field.to_array(values="squared")
        limit = math.floor((max_distance / voxel_size) ** 2)
        same = np.array_equal(squared, np.where(expected <= limit, expected, 2**31 - 1))
        ratio = scipy_seconds / seconds
        print(f"  scipy on the dense box: {scipy_seconds:.3f} s, {ratio:.0f} times as slow; equal: {same}")
    points = np.random.default_rng(0).uniform(low, high, (QUERIES, 3))
    body = np.column_stack([np.linspace(-0.4, 0.4, 20), np.zeros((20, 2)), np.full(20, 0.1)])
    poses = np.tile(np.eye(4), (QUERIES // 20, 1, 1))
    poses[:, :3, 3] = points[: len(poses)]
    queries = {
        "distances": lambda: field.distances(points),
        "interpolated": lambda: field.distances(points, interpolate=True),
        "gradients": lambda: field.gradients(points),
        "nearest obstacles": lambda: field.nearest_obstacles(points),
        "spheres": lambda: field.collides(points, 0.1),
        "spheres of bodies": lambda: field.collides_bodies(body, poses),
    }
    for name, work in queries.items():
        work()
        print(f"  {name:20}{best_of(work)[0] / QUERIES * 1e9:8.0f} ns each")


def main() -> None:
    """Run the requested measurements."""
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
