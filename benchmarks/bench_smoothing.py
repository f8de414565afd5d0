"""Smoothing, search structure included: planes and bilateral weights over up to 30 neighbors, five iterations over 20.

Normals for the bilateral filter are given.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, Trial, anew, load_open3d, open3d_device, timed, waiting

MAX_NN = 30
KNN = 20
ITERATIONS = 5
SIGMA_R = 0.005  # [m] twice the noise


@dataclass(frozen=True)
class Surface:
    """Points, the radius [m] that contains about 35 of them, and one approximate normal for all of them."""

    points: np.ndarray
    radius: float

    @property
    def normals(self) -> np.ndarray:
        """The normal, repeated for all points."""
        return np.tile(np.array([0.0, 0.0, 1.0]), (len(self.points), 1))


def surface(count: int, radius: float) -> Any:
    return lambda: Surface(scenes.bumpy_surface(count), radius)


def smooth_mls(cloud: Any, scene: Surface, limits: Callable[[], dict[str, Any]]) -> Any:
    return cloud.smooth_mls(**limits())


def smooth_bilateral(cloud: Any, scene: Surface, limits: Callable[[], dict[str, Any]]) -> Any:
    return cloud.smooth_bilateral(**limits(), sigma_s=scene.radius / 2, sigma_r=SIGMA_R)


def smooth_laplacian(cloud: Any, scene: Surface, limits: Callable[[], dict[str, Any]]) -> Any:
    return cloud.smooth_laplacian(ITERATIONS, 0.5, KNN)


def run_pointloom(smooth: Callable, scene: Surface, device: str) -> Any:
    import pointloom as loom

    normals = scene.normals if smooth is smooth_bilateral else None
    cloud = loom.PointCloud(scene.points, normals=normals, device=device)
    limits = {"radius": scene.radius, "max_nn": MAX_NN}
    return Trial(waiting(lambda c: smooth(c, scene, lambda: limits), device, "warp"), setup=lambda: anew(cloud))


def run_open3d_legacy(smooth: Callable, scene: Surface, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(scene.points))
    if smooth is smooth_bilateral:
        cloud.normals = o3d.utility.Vector3dVector(scene.normals)
    search = o3d.geometry.KDTreeSearchParamHybrid(scene.radius, MAX_NN)
    return lambda: smooth(cloud, scene, lambda: {"search_param": search})


def run_open3d_tensor(smooth: Callable, scene: Surface, device: str) -> Any:
    o3d = load_open3d()
    where = open3d_device(device)
    points = o3d.core.Tensor(scene.points.astype(np.float32), device=where)
    normals = o3d.core.Tensor(scene.normals.astype(np.float32), device=where)

    def make() -> Any:
        cloud = o3d.t.geometry.PointCloud(points)
        if smooth is smooth_bilateral:
            cloud.point.normals = normals
        return cloud

    def run(cloud: Any) -> Any:
        return smooth(cloud, scene, lambda: {"radius": scene.radius, "max_nn": MAX_NN})

    return Trial(waiting(run, device, "open3d"), setup=make)


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for nearly the same positions; points with tied neighbors, and their neighbors, may differ."""
    same = np.abs(actual - reference).max(axis=1) < 1e-5
    assert same.mean() > 0.98, f"{1 - same.mean():.2%} of the points are not {peer}'s"


def operation(name: str, smooth: Callable) -> Operation:
    contestants = [
        Contestant(POINTLOOM, partial(run_pointloom, smooth), lambda cloud: cloud.points, ("cpu", "cuda")),
        Contestant("open3d-legacy", partial(run_open3d_legacy, smooth), lambda cloud: np.asarray(cloud.points)),
        Contestant(
            "open3d-tensor",
            partial(run_open3d_tensor, smooth),
            lambda cloud: cloud.point.positions.cpu().numpy(),
            ("cpu", "cuda"),
        ),
    ]
    return Operation(
        name=name,
        scenes={"1k": surface(1000, 0.42), "200k": surface(200_000, 0.03), "1M": surface(1_000_000, 0.0135)},
        quick={"50k": surface(50_000, 0.06)},
        contestants=tuple(contestants),
        check=check,
        memory_size="200k",
    )


MLS = operation("smooth_mls", smooth_mls)
BILATERAL = operation("smooth_bilateral", smooth_bilateral)
LAPLACIAN = operation("smooth_laplacian", smooth_laplacian)
OPERATIONS = (MLS, BILATERAL, LAPLACIAN)


@timed(MLS)
def test_smooth_mls(time_lap) -> None:
    time_lap()


@timed(BILATERAL)
def test_smooth_bilateral(time_lap) -> None:
    time_lap()


@timed(LAPLACIAN)
def test_smooth_laplacian(time_lap) -> None:
    time_lap()
