"""The 20 nearest neighbors of every point of a cloud, including itself, with the index given or built in the timed
call.

On the GPU the baseline is Open3D's brute force, and both copy their results to the host.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, anew, load_open3d, open3d_device, thread_count, timed, waiting
from reasons import CALL, SPREAD

K = 20

# A contestant is (points, device) -> (build: () -> index, query: index -> result).
Searcher = Callable[[np.ndarray, str], tuple[Callable[[], Any], Callable[[Any], Any]]]


def search_pointloom(points: np.ndarray, device: str) -> Any:
    import pointloom as loom

    cloud = loom.PointCloud(points, device=device)
    build = waiting(lambda: loom.NearestNeighborSearch(anew(cloud)), device, "warp")
    return build, lambda index: index.knn_search(cloud, K)


def search_small_gicp(points: np.ndarray, device: str) -> Any:
    import small_gicp

    threads = thread_count()
    return (
        lambda: small_gicp.KdTree(points, num_threads=threads),
        lambda index: index.batch_knn_search(points, K, num_threads=threads),
    )


def search_pykdtree(points: np.ndarray, device: str) -> Any:
    from pykdtree.kdtree import KDTree

    points = points.astype(np.float32)
    return lambda: KDTree(points), lambda index: index.query(points, k=K, sqr_dists=True)


def search_scipy(points: np.ndarray, device: str) -> Any:
    from scipy.spatial import cKDTree

    return lambda: cKDTree(points), lambda index: index.query(points, k=K, workers=thread_count())


def search_open3d_tensor(points: np.ndarray, device: str) -> Any:
    o3d = load_open3d()
    tensor = o3d.core.Tensor(points.astype(np.float32), device=open3d_device(device))

    def build() -> Any:
        index = o3d.core.nns.NearestNeighborSearch(tensor)
        index.knn_index()
        return index

    def query(index: Any) -> Any:
        indices, sqdists = index.knn_search(tensor, K)
        return indices.cpu().numpy(), sqdists.cpu().numpy()

    return build, query


def prebuilt(searcher: Searcher, points: np.ndarray, device: str) -> Any:
    build, query = searcher(points, device)
    index = build()
    return lambda: query(index)


def with_build(searcher: Searcher, points: np.ndarray, device: str) -> Any:
    build, query = searcher(points, device)
    return lambda: query(build())


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same distances. Coordinates are bitwise equal, so only arithmetic rounding differs."""
    assert actual.shape == reference.shape, f"{actual.shape}, {peer} {reference.shape}"
    rounding = 1e-3 if peer.startswith("open3d-tensor") else 1e-5  # [m] brute force expands (a - b)^2
    worst = np.abs(actual - reference).max()
    assert worst < rounding, f"distances differ from {peer}'s by up to {worst:.2g} m"


def contestants(kind: Callable) -> tuple[Contestant, ...]:
    def root(result: Any) -> np.ndarray:
        return np.sqrt(np.asarray(result[1], np.float64))

    def distances(result: Any) -> np.ndarray:
        return result[0]

    return (
        Contestant(POINTLOOM, partial(kind, search_pointloom), root, ("cpu", "cuda")),
        Contestant("small_gicp", partial(kind, search_small_gicp), root),
        Contestant("pykdtree", partial(kind, search_pykdtree), lambda result: np.sqrt(result[0].astype(np.float64))),
        Contestant("scipy", partial(kind, search_scipy), distances),
        Contestant("open3d-tensor", partial(kind, search_open3d_tensor), root, ("cuda",)),
    )


SCENES: dict[str, Callable[[], Any]] = {
    "surface 1k": partial(scenes.bumpy_surface, 1000),
    "surface 200k": partial(scenes.bumpy_surface, 200_000),
    "lidar synthetic": scenes.spinning_scan,
    "lidar real": scenes.real_scan,
    "lidar returns": partial(scenes.real_scan, zeros=False),
}
QUICK = {"surface 20k": partial(scenes.bumpy_surface, 20_000), "lidar 20k": partial(scenes.spinning_scan, 20_000)}
QUERY = Operation(
    name="knn20_query",
    scenes=SCENES,
    quick=QUICK,
    contestants=contestants(prebuilt),
    check=check,
    memory_size="surface 200k",
    targets={"surface 200k": 2, "lidar synthetic": 2, "lidar real": 1.5, "lidar returns": 2},
    reasons={"surface 1k": CALL, "lidar returns": SPREAD.format(2.06)},
)
BUILD_AND_QUERY = Operation(
    name="knn20_with_build",
    scenes=SCENES,
    quick=QUICK,
    contestants=contestants(with_build),
    check=check,
    memory_size="surface 200k",
    reasons={"surface 1k": CALL},
)
OPERATIONS = (QUERY, BUILD_AND_QUERY)


@timed(QUERY)
def test_knn_query(time_lap) -> None:
    time_lap()


@timed(BUILD_AND_QUERY)
def test_knn_with_build(time_lap) -> None:
    time_lap()
