"""Ball pivoting of a noisy surface with given normals, search structure included.

Uses one radius of twice the spacing, and three radii that double from there. Open3D's triangles must be among
pointloom's, except for some that share an edge with another one.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, Trial, anew, load_open3d, timed, waiting

FRACTION = 0.9  # of Open3D's triangles; with noise it selects others where several share an edge


@dataclass(frozen=True)
class Surface:
    """Points, one approximate normal for all of them, and the radii [m]."""

    points: np.ndarray
    radii: list[float]

    @property
    def normals(self) -> np.ndarray:
        """The normal, repeated for all points."""
        return np.tile(np.array([0.0, 0.0, 1.0]), (len(self.points), 1))


def surface(count: int, factors: tuple[float, ...]) -> Callable[[], Surface]:
    def make() -> Surface:
        points = scenes.bumpy_surface(count).astype(np.float32).astype(np.float64)
        low, high = points.min(axis=0), points.max(axis=0)
        spacing = float(np.sqrt((high - low)[:2].prod() / count))
        return Surface(points, [factor * spacing for factor in factors])

    return make


def prepare_pointloom(scene: Surface, device: str) -> Any:
    import pointloom as loom

    cloud = loom.PointCloud(scene.points, normals=scene.normals, device=device)
    pivot = loom.TriangleMesh.create_from_point_cloud_ball_pivoting
    return Trial(waiting(lambda c: pivot(c, scene.radii), device, "warp"), setup=lambda: anew(cloud))


def prepare_open3d(scene: Surface, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(scene.points))
    cloud.normals = o3d.utility.Vector3dVector(scene.normals)
    radii = o3d.utility.DoubleVector(scene.radii)
    return lambda: o3d.geometry.TriangleMesh.create_from_point_cloud_ball_pivoting(cloud, radii)


def triangles_of(mesh: Any) -> np.ndarray:
    return np.sort(np.asarray(mesh.triangles), axis=1)


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    triangles = set(map(tuple, actual.tolist()))
    common = sum(tuple(t) in triangles for t in reference.tolist())
    assert len(actual) >= 0.99 * len(reference), f"{len(actual)} triangles, {peer} has {len(reference)}"
    assert common >= FRACTION * len(reference), (
        f"of {peer}'s {len(reference)} triangles only {common} are in the result"
    )


def operation(name: str, factors: tuple[float, ...], long: tuple[str, ...] = ()) -> Operation:
    return Operation(
        name=name,
        scenes={"1k": surface(1000, factors), "60k": surface(60_000, factors), "1M": surface(1_000_000, factors)},
        quick={"20k": surface(20_000, factors)},
        contestants=(
            Contestant(POINTLOOM, prepare_pointloom, triangles_of, ("cpu", "cuda")),
            Contestant("open3d-legacy", prepare_open3d, triangles_of),
        ),
        check=check,
        memory_size="60k",
        long=long,
    )


ONE = operation("ball_pivoting", (2.0,), long=("1M",))
THREE = replace(
    operation("ball_pivoting_3", (1.0, 2.0, 4.0)),
    targets={"1M": 4},
    reasons={
        "1M": ("92 % of the time is the search for triangles: neighbors, directions without a ball, pairs of corners.")
    },
)
OPERATIONS = (ONE, THREE)


@timed(ONE)
def test_ball_pivoting(time_lap) -> None:
    time_lap()


@timed(THREE)
def test_ball_pivoting_3(time_lap) -> None:
    time_lap()
