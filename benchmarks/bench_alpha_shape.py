"""Alpha shapes of a scanned surface and of one with noise."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import real_scans
import scenes
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed, waiting
from reasons import SPREAD

BUNNY = "reconstruction/bun_zipper{}.ply"
Array = np.ndarray


@dataclass(frozen=True)
class Shape:
    """Points that are distinct in float32, and an alpha [m]."""

    points: Array
    alpha: float


def bunny(name: str, alpha: float) -> Callable[[], Shape]:
    def make() -> Shape:
        points = real_scans.points_of(real_scans.folder() / "reg-bunny-scans" / BUNNY.format(name))
        return Shape(np.unique(points.astype(np.float32), axis=0).astype(np.float64), alpha)

    return make


def surface(count: int, alpha: float) -> Callable[[], Shape]:
    return lambda: Shape(np.unique(scenes.bumpy_surface(count), axis=0), alpha)


def prepare_pointloom(scene: Shape, device: str) -> Any:
    import pointloom as loom

    cloud = loom.PointCloud(scene.points, device=device, origin=(0, 0, 0))
    return waiting(lambda: loom.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, scene.alpha), device, "warp")


def prepare_open3d(scene: Shape, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(scene.points))
    return lambda: o3d.geometry.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, scene.alpha)


def corners(mesh: Any) -> Array:
    """The triangles by ranks of their corners, in sorted order."""
    vertices, triangles = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
    order = np.lexsort(vertices.T)
    ranks = np.empty(len(order), np.int64)
    ranks[order] = np.arange(len(order))
    rows = np.sort(ranks[triangles], axis=1)
    return vertices[order][rows[np.lexsort(rows.T)]]


def check(actual: Array, reference: Array, peer: str) -> None:
    np.testing.assert_array_equal(actual, reference, err_msg=f"the triangles are not {peer}'s")


ALPHA_SHAPE = Operation(
    name="alpha_shape",
    scenes={
        "1k": surface(1000, 0.7),
        "bunny 8k, 6 mm": bunny("_res2", 0.006),
        "bunny 36k, 2 mm": bunny("", 0.002),
        "bunny 36k, 6 mm": bunny("", 0.006),
        "200k": surface(200_000, 0.05),
    },
    quick={"5k": surface(5000, 0.3)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, corners, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, corners),
    ),
    check=check,
    memory_size="200k",
    targets={"bunny 8k, 6 mm": 4, "bunny 36k, 2 mm": 5, "bunny 36k, 6 mm": 4, "200k": 5},
    reasons={"bunny 8k, 6 mm": SPREAD.format(4.3)},
)
OPERATIONS = (ALPHA_SHAPE,)


@timed(ALPHA_SHAPE)
def test_alpha_shape(time_lap) -> None:
    time_lap()
