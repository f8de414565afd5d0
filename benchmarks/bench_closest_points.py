"""Closest points on a mesh of 76k triangles for points in its box and near its surface, beside Open3D's Embree."""

from __future__ import annotations

from functools import cache, partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed
from mesh_scenes import Arrays, scene_in_open3d, scene_in_pointloom, wavy_mesh
from numpy.typing import NDArray

Scene = tuple[Arrays, NDArray[np.float32]]


@cache
def box_scene(cells: int = 128, count: int = 200_000) -> Scene:
    """Random points in the mesh's bounding box."""
    vertices, triangles = wavy_mesh(cells)
    rng = np.random.default_rng(0)
    queries = rng.uniform(vertices.min(axis=0), vertices.max(axis=0), (count, 3))
    return (vertices, triangles), queries.astype(np.float32)


@cache
def near_scene(cells: int = 128, count: int = 200_000) -> Scene:
    """Points on the surface, moved by a thousandth of the mesh's size."""
    vertices, triangles = wavy_mesh(cells)
    rng = np.random.default_rng(0)
    corners, weights = vertices[triangles[rng.integers(0, len(triangles), count)]], rng.dirichlet([1, 1, 1], count)
    noise = rng.normal(size=(count, 3)) * np.ptp(vertices, axis=0).max() / 1000
    return (vertices, triangles), (np.einsum("nk,nkd->nd", weights, corners) + noise).astype(np.float32)


def prepare_pointloom(scene: Scene, device: str) -> Any:
    arrays, queries = scene
    return partial(scene_in_pointloom(arrays, device).compute_closest_points, queries)  # the result is on the host


def prepare_open3d(scene: Scene, device: str) -> Any:
    arrays, queries = scene
    return partial(scene_in_open3d(arrays).compute_closest_points, load_open3d().core.Tensor(queries))


def facts(result: Any) -> NDArray[np.float32]:
    points = result["points"]
    return np.asarray(points if isinstance(points, np.ndarray) else points.numpy())


def check(actual: NDArray[np.float32], reference: NDArray[np.float32], peer: str) -> None:
    """Check for the same points, except where two surface points are equally near."""
    close = np.linalg.norm(actual - reference, axis=1) < 1e-3 * np.ptp(actual, axis=0).max()
    assert close.mean() > 0.99, peer


CLOSEST_POINTS = Operation(
    name="closest_points",
    scenes={"box 1k": partial(box_scene, 16, 1000), "box 200k": box_scene, "near 200k": near_scene},
    quick={"box": partial(box_scene, 24, 2000)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, facts, ("cpu", "cuda")),
        Contestant("open3d-tensor", prepare_open3d, facts),
    ),
    check=check,
    targets={"box 200k": 4, "near 200k": 3},
    reasons={
        "near 200k": ("Of the CPU time, 65 % is the search for the nearest triangle and 18 % the closest point on it.")
    },
)
OPERATIONS = (CLOSEST_POINTS,)


@timed(CLOSEST_POINTS)
def test_closest_points(time_lap) -> None:
    time_lap()
