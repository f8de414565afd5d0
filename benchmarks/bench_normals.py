"""estimate_normals, search structure included: hybrid (radius and 30 nearest) and 30 nearest."""

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
    load_open3d,
    open3d_device,
    thread_count,
    timed,
    waiting,
)
from reasons import SPREAD

MAX_NN = 30


@dataclass(frozen=True)
class Surface:
    """Points and the radius [m] that contains about 35 of them; None searches by count alone."""

    points: np.ndarray
    radius: float | None


def surface(count: int, radius: float | None) -> Any:
    return lambda: Surface(scenes.bumpy_surface(count), radius)


def prepare_pointloom(scene: Surface, device: str) -> Any:
    import pointloom as loom

    cloud = loom.PointCloud(scene.points, device=device)
    estimate = waiting(lambda c: c.estimate_normals(radius=scene.radius, max_nn=MAX_NN), device, "warp")
    return Trial(estimate, setup=lambda: anew(cloud))


def prepare_open3d_legacy(scene: Surface, device: str) -> Any:
    o3d = load_open3d()
    points = o3d.utility.Vector3dVector(scene.points)
    search = o3d.geometry.KDTreeSearchParamKNN(MAX_NN)
    if scene.radius is not None:
        search = o3d.geometry.KDTreeSearchParamHybrid(scene.radius, MAX_NN)

    def estimate(cloud: Any) -> Any:
        cloud.estimate_normals(search)
        return cloud

    return Trial(estimate, setup=lambda: o3d.geometry.PointCloud(points))


def prepare_open3d_tensor(scene: Surface, device: str) -> Any:
    o3d = load_open3d()
    points = o3d.core.Tensor(scene.points.astype(np.float32), device=open3d_device(device))

    def estimate(cloud: Any) -> Any:
        cloud.estimate_normals(max_nn=MAX_NN, radius=scene.radius)
        return cloud

    return Trial(waiting(estimate, device, "open3d"), setup=lambda: o3d.t.geometry.PointCloud(points))


def prepare_small_gicp(scene: Surface, device: str) -> Any:
    import small_gicp

    def estimate(cloud: Any) -> Any:
        tree = small_gicp.KdTree(cloud, num_threads=thread_count())
        small_gicp.estimate_normals(cloud, tree, num_neighbors=MAX_NN, num_threads=thread_count())
        return cloud

    return Trial(estimate, setup=lambda: small_gicp.PointCloud(scene.points))


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same unsigned normals at nearly all points; ties and neighbors on the radius may differ."""
    aligned = np.abs(np.einsum("ij,ij->i", actual, reference)) > 0.999
    assert aligned.mean() > 0.995, f"{1 - aligned.mean():.2%} of the normals are not {peer}'s"


CONTESTANTS = (
    Contestant(POINTLOOM, prepare_pointloom, lambda cloud: cloud.normals, ("cpu", "cuda")),
    Contestant("open3d-legacy", prepare_open3d_legacy, lambda cloud: np.asarray(cloud.normals)),
    Contestant(
        "open3d-tensor", prepare_open3d_tensor, lambda cloud: cloud.point.normals.cpu().numpy(), ("cpu", "cuda")
    ),
    Contestant("small_gicp", prepare_small_gicp, lambda cloud: cloud.normals()[:, :3]),
)
HYBRID = Operation(
    name="normals_hybrid",
    scenes={"1k": surface(1000, 0.42), "200k": surface(200_000, 0.03), "1M": surface(1_000_000, 0.0135)},
    quick={"50k": surface(50_000, 0.06)},
    contestants=CONTESTANTS[:3],
    check=check,
    memory_size="200k",
    targets={"200k": 5, "1M": 5},
    reasons={"200k": SPREAD.format(5.3)},
    slow={"1M": ("open3d-legacy",)},
)
KNN = Operation(
    name="normals_knn30",
    scenes={"1k": surface(1000, None), "200k": surface(200_000, None)},
    quick={"50k": surface(50_000, None)},
    contestants=(CONTESTANTS[0], CONTESTANTS[3]),
    check=check,
)
OPERATIONS = (HYBRID, KNN)


@timed(HYBRID)
def test_normals_hybrid(time_lap) -> None:
    time_lap()


@timed(KNN)
def test_normals_knn(time_lap) -> None:
    time_lap()
