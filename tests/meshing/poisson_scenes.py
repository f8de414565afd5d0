"""Oriented samples of surfaces that are known exactly, and what a mesh's edges are by plain NumPy."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import pointloom as loom

Points = NDArray[np.float64]


def sphere(count: int, seed: int = 0) -> Points:
    """Points of the unit sphere, which are their own normals."""
    points = np.random.default_rng(seed).normal(size=(count, 3))
    return points / np.linalg.norm(points, axis=1, keepdims=True)


def clustered_sphere(count: int, share: float = 0.01, seed: int = 0) -> Points:
    """The upper cap of a sphere, and below it a hundredth as many points an area: cells of several levels."""
    points = sphere(count, seed)
    return points[np.random.default_rng(seed + 1).random(count) < np.where(points[:, 2] > 0.6, 1, share)]


def torus(count: int, seed: int = 0) -> tuple[Points, Points]:
    """Points, evenly by area, and normals of a torus of radii 1 and 0.4."""
    u, v, chance = np.random.default_rng(seed).random((3, 3 * count))
    kept = chance * 1.4 < 1 + 0.4 * np.cos(2 * np.pi * v)
    u, v = 2 * np.pi * u[kept][:count], 2 * np.pi * v[kept][:count]
    normals = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], axis=1)
    return np.stack([np.cos(u), np.sin(u), 0 * u], axis=1) + 0.4 * normals, normals


def sphere_distance(places: Points) -> NDArray[np.float64]:
    return np.abs(np.linalg.norm(places, axis=1) - 1)


def torus_distance(places: Points) -> NDArray[np.float64]:
    return np.abs(np.hypot(np.hypot(places[:, 0], places[:, 1]) - 1, places[:, 2]) - 0.4)


def poisson(points: Any, normals: Any = None, depth: int = 5, *, device: Any = None, **options: Any):
    """(mesh, densities) of points, by default as their own normals."""
    normals = points if normals is None else normals
    cloud = loom.PointCloud(points, normals=normals, device=device)
    return loom.TriangleMesh.create_from_point_cloud_poisson(cloud, depth, **options)


def bits(result: Any) -> tuple[bytes, ...]:
    """Every bit of (mesh, densities)."""
    mesh, densities = result
    arrays = (mesh.array(name).numpy() for name in ("vertices", "triangles", "vertex_normals"))
    return (*(values.tobytes() for values in arrays), densities.tobytes())


def cube_around(points: Points, scale: float = 1.1) -> tuple[Points, float]:
    """(lowest corner, edge) of the cube that the octree halves."""
    points = points.astype(np.float32).astype(np.float64)
    low, high = points.min(axis=0), points.max(axis=0)
    side = (high - low).max() * scale
    return (low + high) / 2 - side / 2, side


def edges_by_use(triangles: NDArray[np.int32]) -> tuple[NDArray[np.int32], NDArray[np.int64], int]:
    """(edges as pairs, triangles at each, directed edges that come twice)."""
    directed = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    edges, counts = np.unique(np.sort(directed, axis=1), axis=0, return_counts=True)
    return edges, counts, len(directed) - len(np.unique(directed, axis=0))


def assert_only_the_cube_cuts(mesh: Any, points: Points, scale: float = 1.1) -> int:
    """No edge of more than two triangles or of one direction twice, and each open one lies in a side of the cube.

    Returns:
        How many open edges there are.
    """
    edges, counts, twisted = edges_by_use(mesh.triangles)
    assert counts.max() == 2 and twisted == 0
    corner, side = cube_around(points, scale)
    shares = (mesh.vertices[edges[counts == 1]] - corner) / side  # [open edges, 2, 3]
    on_side = (np.abs(shares) < 1e-5).all(axis=1) | (np.abs(shares - 1) < 1e-5).all(axis=1)
    assert on_side.any(axis=1).all(), "an edge within the cube is open: a crack"
    return len(shares)
