"""cluster_dbscan with about 16 neighbors per point, beside Open3D's two point clouds and scikit-learn.

The search structure is built in the timed call. The size of 5M points is for the peak memory: the baselines store a
list
of neighbors for each point.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import scenes
from contest import (
    POINTLOOM,
    Contestant,
    Operation,
    Trial,
    anew,
    kept_on,
    load_open3d,
    on_host,
    open3d_device,
    thread_count,
    timed,
    waiting,
)
from reasons import CALL

MIN_POINTS = 10


@dataclass(frozen=True)
class Surface:
    """Points and the neighbor distance [m]."""

    points: np.ndarray
    eps: float


def surface(count: int, eps: float) -> Any:
    return lambda: Surface(scenes.bumpy_surface(count), eps)


def prepare_pointloom(scene: Surface, device: str) -> Any:
    import pointloom as loom

    cloud = kept_on(loom.PointCloud(scene.points, device=device), device)
    cluster = waiting(lambda c: c.cluster_dbscan(scene.eps, MIN_POINTS), device, "warp")
    return Trial(cluster, setup=lambda: anew(cloud))


def prepare_open3d_legacy(scene: Surface, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(scene.points))
    return lambda: cloud.cluster_dbscan(scene.eps, MIN_POINTS)


def prepare_open3d_tensor(scene: Surface, device: str) -> Any:
    o3d = load_open3d()
    points = o3d.core.Tensor(scene.points.astype(np.float32), device=open3d_device(device))
    cloud = o3d.t.geometry.PointCloud(points)
    return waiting(lambda: cloud.cluster_dbscan(scene.eps, MIN_POINTS), device, "open3d")


def prepare_scikit_learn(scene: Surface, device: str) -> Any:
    from sklearn.cluster import DBSCAN

    model = DBSCAN(eps=scene.eps, min_samples=MIN_POINTS, algorithm="kd_tree", n_jobs=thread_count())
    return lambda: model.fit_predict(scene.points)


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same noise and the same clusters, except for a few points.

    float32 and float64 may round a distance to different sides of eps. One small cluster more or less shifts the
    following
    labels, so clusters are compared, not labels.
    """
    assert len(actual) == len(reference)
    both = (actual >= 0) & (reference >= 0)
    differ = np.mean(both != ((actual >= 0) | (reference >= 0)))
    assert differ < 1e-4, f"{differ:.3%} of the points are noise in only one of the results of pointloom and {peer}"
    group_count = int(actual.max()) + 1
    pair_count = np.unique(actual[both].astype(np.int64) * len(actual) + reference[both]).size
    few = 1 + group_count // 1000
    assert abs(group_count - (int(reference.max()) + 1)) <= few, f"{group_count} clusters, {peer} {reference.max() + 1}"
    assert abs(pair_count - group_count) <= few, f"{peer}'s clusters and pointloom's overlap in {pair_count} pairs"


DBSCAN = Operation(
    name="dbscan",
    scenes={
        "1k": surface(1000, 0.28),
        "200k": surface(200_000, 0.02),
        "1M": surface(1_000_000, 0.009),
        "5M": surface(5_000_000, 0.0045),
    },
    quick={"50k": surface(50_000, 0.04)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, on_host, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d_legacy, np.asarray),
        Contestant("open3d-tensor", prepare_open3d_tensor, lambda labels: labels.cpu().numpy(), ("cpu", "cuda")),
        Contestant("scikit-learn", prepare_scikit_learn, lambda labels: labels),
    ),
    check=check,
    memory_size="200k",
    long=("5M",),
    targets={"200k": 4, "1M": 4},
    reasons={"1k": CALL},
    slow={"1M": ("scikit-learn",)},
)
OPERATIONS = (DBSCAN,)


@timed(DBSCAN)
def test_dbscan(time_lap) -> None:
    time_lap()
