"""Ball pivoting of a surface with noise, with normals there beforehand and the search structure included.

One radius of twice the spacing, and three that begin at it and double. Open3D's triangles have to be among ours but for
some that share an edge with another.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import scenes
from contest import OURS, Contestant, Operation, Trial, anew, load_open3d, timed, waiting

SHARE = 0.9  # of Open3D's triangles; with noise it takes others where several want an edge


@dataclass(frozen=True)
class Surface:
    """Points, the normal that is near all of theirs, and the radii [m]."""

    points: np.ndarray
    radii: list[float]

    @property
    def normals(self) -> np.ndarray:
        """The same for all points."""
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


def check(ours: np.ndarray, theirs: np.ndarray, peer: str) -> None:
    mine = set(map(tuple, ours.tolist()))
    common = sum(tuple(t) in mine for t in theirs.tolist())
    assert len(ours) >= 0.99 * len(theirs), f"{len(ours)} triangles, {peer} has {len(theirs)}"
    assert common >= SHARE * len(theirs), f"of {peer}'s {len(theirs)} triangles only {common} are there"


def operation(name: str, factors: tuple[float, ...]) -> Operation:
    return Operation(
        name=name,
        scenes={"60k": surface(60_000, factors), "1M": surface(1_000_000, factors)},
        quick={"20k": surface(20_000, factors)},
        contestants=(
            Contestant(OURS, prepare_pointloom, triangles_of, ("cpu", "cuda")),
            Contestant("open3d-legacy", prepare_open3d, triangles_of),
        ),
        check=check,
        memory_size="1M",
    )


ONE = operation("ball_pivoting", (2.0,))
THREE = operation("ball_pivoting_3", (1.0, 2.0, 4.0))
OPERATIONS = (ONE, THREE)


@timed(ONE)
def test_ball_pivoting(turn) -> None:
    turn()


@timed(THREE)
def test_ball_pivoting_3(turn) -> None:
    turn()
