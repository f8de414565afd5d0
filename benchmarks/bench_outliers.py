"""Statistical and radius outliers, search structure included."""

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
    timed,
    waiting,
)
from reasons import CALL

NEIGHBORS, RATIO = 20, 2.0
POINTS = 10


@dataclass(frozen=True)
class Surface:
    """Points and the radius [m] that contains about 16 of them."""

    points: np.ndarray
    radius: float


def surface(count: int) -> Any:
    return lambda: Surface(scenes.bumpy_surface(count), 0.02 * (200_000 / count) ** 0.5)


def pointloom_cloud(scene: Surface, device: str) -> Any:
    import pointloom as loom

    return kept_on(loom.PointCloud(scene.points, device=device), device)


def legacy_cloud(scene: Surface) -> Any:
    o3d = load_open3d()
    return o3d.geometry.PointCloud(o3d.utility.Vector3dVector(scene.points))


def tensor_cloud(scene: Surface, device: str) -> Any:
    o3d = load_open3d()
    return o3d.t.geometry.PointCloud(o3d.core.Tensor(scene.points.astype(np.float32), device=open3d_device(device)))


def statistical_pointloom(scene: Surface, device: str) -> Any:
    cloud = pointloom_cloud(scene, device)
    remove = waiting(lambda c: c.remove_statistical_outlier(NEIGHBORS, RATIO), device, "warp")
    return Trial(remove, setup=lambda: anew(cloud))


def statistical_legacy(scene: Surface, device: str) -> Any:
    cloud = legacy_cloud(scene)
    return lambda: cloud.remove_statistical_outlier(NEIGHBORS, RATIO)


def statistical_tensor(scene: Surface, device: str) -> Any:
    cloud = tensor_cloud(scene, device)
    return waiting(lambda: cloud.remove_statistical_outliers(NEIGHBORS, RATIO), device, "open3d")


def radius_pointloom(scene: Surface, device: str) -> Any:
    cloud = pointloom_cloud(scene, device)
    remove = waiting(lambda c: c.remove_radius_outlier(POINTS, scene.radius), device, "warp")
    return Trial(remove, setup=lambda: anew(cloud))


def radius_legacy(scene: Surface, device: str) -> Any:
    cloud = legacy_cloud(scene)
    return lambda: cloud.remove_radius_outlier(POINTS, scene.radius)


def radius_tensor(scene: Surface, device: str) -> Any:
    cloud = tensor_cloud(scene, device)
    # counts the point itself, so the threshold is one larger
    return waiting(lambda: cloud.remove_radius_outliers(POINTS + 1, scene.radius), device, "open3d")


def indices(result: Any) -> np.ndarray:
    return np.sort(np.asarray(on_host(result[1])))


def mask_positions(result: Any) -> np.ndarray:
    return np.flatnonzero(result[1].cpu().numpy())


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same points, except for those at the threshold in float32."""
    differing = len(np.setxor1d(actual, reference))
    assert differing <= 1e-4 * len(actual), f"{differing} of {len(actual)} points are not {peer}'s"


SCENES = {"1k": surface(1000), "200k": surface(200_000), "1M": surface(1_000_000)}
STATISTICAL = Operation(
    name="statistical_outliers",
    scenes=SCENES,
    quick={"50k": surface(50_000)},
    contestants=(
        Contestant(POINTLOOM, statistical_pointloom, indices, ("cpu", "cuda")),
        Contestant("open3d-legacy", statistical_legacy, indices),
        Contestant("open3d-tensor", statistical_tensor, mask_positions, ("cpu", "cuda")),
    ),
    check=check,
    targets={"200k": 4, "1M": 4},
)
RADIUS = Operation(
    name="radius_outliers",
    scenes=SCENES,
    quick={"50k": surface(50_000)},
    contestants=(
        Contestant(POINTLOOM, radius_pointloom, indices, ("cpu", "cuda")),
        Contestant("open3d-legacy", radius_legacy, indices),
        Contestant("open3d-tensor", radius_tensor, mask_positions, ("cpu", "cuda")),
    ),
    check=check,
    targets={"200k": 5, "1M": 5},
    reasons={"1k": CALL},
)
OPERATIONS = (STATISTICAL, RADIUS)


@timed(STATISTICAL)
def test_statistical_outliers(time_lap) -> None:
    time_lap()


@timed(RADIUS)
def test_radius_outliers(time_lap) -> None:
    time_lap()
