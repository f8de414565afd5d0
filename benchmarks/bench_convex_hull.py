"""compute_convex_hull of a surface with noise."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed, waiting
from reasons import CALL


def surface(count: int) -> Callable[[], np.ndarray]:
    return lambda: scenes.bumpy_surface(count)


def prepare_pointloom(points: np.ndarray, device: str) -> Any:
    import pointloom as loom

    cloud = loom.PointCloud(points, device=device)
    return waiting(lambda: cloud.compute_convex_hull()[1], device, "warp")


def prepare_open3d(points: np.ndarray, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    return lambda: cloud.compute_convex_hull()[1]


def prepare_scipy(points: np.ndarray, device: str) -> Any:
    from scipy.spatial import ConvexHull

    return lambda: ConvexHull(points).vertices


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    np.testing.assert_array_equal(actual, reference, err_msg=f"the vertices are not {peer}'s")


HULL = Operation(
    name="convex_hull",
    scenes={"1k": surface(1000), "200k": surface(200_000), "1M": surface(1_000_000)},
    quick={"50k": surface(50_000)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, np.sort, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, np.sort),
        Contestant("scipy", prepare_scipy, np.sort),
    ),
    check=check,
    memory_size="1M",
    targets={"1M": 1},
    reasons={"1k": CALL},
)
OPERATIONS = (HULL,)


@timed(HULL)
def test_convex_hull(time_lap) -> None:
    time_lap()
