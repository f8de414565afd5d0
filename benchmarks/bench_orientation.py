"""orient_normals_consistent_tangent_plane, graph construction included; the normals are given with random signs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, Trial, anew, load_open3d, timed, waiting

K = 15


@dataclass(frozen=True)
class Surface:
    """Points, and normals with random signs."""

    points: np.ndarray
    normals: np.ndarray


def surface(count: int) -> Any:
    def make() -> Surface:
        points = scenes.bumpy_surface(count)
        x, y = points[:, 0], points[:, 1]
        slope_x = 0.45 * np.cos(3 * x) * np.cos(2 * y) + 0.33 * np.cos(11 * x + 5 * y)
        slope_y = -0.3 * np.sin(3 * x) * np.sin(2 * y) + 0.15 * np.cos(11 * x + 5 * y)
        normals = np.stack([-slope_x, -slope_y, np.ones(count)], axis=1)
        signs = np.random.default_rng(1).choice([-1, 1], count)
        normals *= (signs / np.linalg.norm(normals, axis=1))[:, None]
        return Surface(points, normals.astype(np.float32).astype(np.float64))

    return make


def prepare_pointloom(scene: Surface, device: str) -> Any:
    import pointloom as loom

    cloud = loom.PointCloud(scene.points, normals=scene.normals, device=device)
    orient = waiting(lambda c: c.orient_normals_consistent_tangent_plane(K), device, "warp")
    return Trial(orient, setup=lambda: anew(cloud))


def prepare_open3d(scene: Surface, device: str) -> Any:
    o3d = load_open3d()
    points, normals = (o3d.utility.Vector3dVector(a) for a in (scene.points, scene.normals))

    def make() -> Any:
        cloud = o3d.geometry.PointCloud(points)
        cloud.normals = normals
        return cloud

    def orient(cloud: Any) -> Any:
        cloud.orient_normals_consistent_tangent_plane(K)
        return cloud

    return Trial(orient, setup=make)


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same orientation everywhere; the lowest point's normal determines it."""
    same = np.einsum("ij,ij->i", actual, reference) > 0
    assert same.mean() > 0.999, f"{1 - same.mean():.2%} of the normals are oriented differently from {peer}'s"
    assert (actual[:, 2] < 0).mean() > 0.999


ORIENTATION = Operation(
    name="orient_consistently",
    scenes={"1k": surface(1000), "200k": surface(200_000), "1M": surface(1_000_000)},
    quick={"20k": surface(20_000)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, lambda cloud: cloud.normals, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, lambda cloud: np.asarray(cloud.normals)),
    ),
    check=check,
    memory_size="200k",
    long=("1M",),
    targets={"200k": 3},
)
OPERATIONS = (ORIENTATION,)


@timed(ORIENTATION)
def test_orient_consistently(time_lap) -> None:
    time_lap()
