"""The distance of each point of one sampling of a surface to the nearest of another, search structure included."""

from __future__ import annotations

from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, Trial, anew, load_open3d, thread_count, timed, waiting
from reasons import CALL

Scans = tuple[np.ndarray, np.ndarray]


def samplings(count: int) -> Any:
    return lambda: (scenes.bumpy_surface(count), scenes.bumpy_surface(count, seed=1))


def prepare_pointloom(scans: Scans, device: str) -> Any:
    import pointloom as loom

    source, target = (loom.PointCloud(points, device=device) for points in scans)
    measure = waiting(lambda to: source.compute_point_cloud_distance(to), device, "warp")
    return Trial(measure, setup=lambda: anew(target))


def prepare_open3d(scans: Scans, device: str) -> Any:
    o3d = load_open3d()
    source, target = (o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points)) for points in scans)
    return lambda: source.compute_point_cloud_distance(target)


def prepare_small_gicp(scans: Scans, device: str) -> Any:
    import small_gicp

    source, target = scans
    threads = thread_count()
    return lambda: small_gicp.KdTree(target, num_threads=threads).batch_nearest_neighbor_search(
        source, num_threads=threads
    )


def prepare_pykdtree(scans: Scans, device: str) -> Any:
    from pykdtree.kdtree import KDTree

    source, target = (points.astype(np.float32) for points in scans)
    return lambda: KDTree(target).query(source, k=1)


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    np.testing.assert_allclose(actual, reference, atol=2e-6, err_msg=peer)


DISTANCE = Operation(
    name="cloud_distance",
    scenes={"1k": samplings(1000), "200k": samplings(200_000), "1M": samplings(1_000_000)},
    quick={"50k": samplings(50_000)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, np.asarray, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, np.asarray),
        Contestant("small_gicp", prepare_small_gicp, lambda result: np.sqrt(np.ravel(result[1]))),
        Contestant("pykdtree", prepare_pykdtree, lambda result: result[0]),
    ),
    check=check,
    targets={"200k": 3, "1M": 3},
    reasons={"1k": CALL},
)
OPERATIONS = (DISTANCE,)


@timed(DISTANCE)
def test_cloud_distance(time_lap) -> None:
    time_lap()
