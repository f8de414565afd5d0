"""Oriented samples of surfaces with known geometry, and edge statistics of a mesh in NumPy."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

import pointloom as loom

Points = NDArray[np.float64]


def sphere(count: int, seed: int = 0) -> Points:
    """Points of the unit sphere, equal to their normals."""
    points = np.random.default_rng(seed).normal(size=(count, 3))
    return points / np.linalg.norm(points, axis=1, keepdims=True)


def clustered_sphere(count: int, fraction: float = 0.01, seed: int = 0) -> Points:
    """The upper cap of a sphere, and a hundredth of its point density below: octree cells of several levels."""
    points = sphere(count, seed)
    return points[np.random.default_rng(seed + 1).random(count) < np.where(points[:, 2] > 0.6, 1, fraction)]


def torus(count: int, seed: int = 0) -> tuple[Points, Points]:
    """Uniform points and normals of a torus with radii 1 and 0.4."""
    u, v, chance = np.random.default_rng(seed).random((3, 3 * count))
    accepted = chance * 1.4 < 1 + 0.4 * np.cos(2 * np.pi * v)
    u, v = 2 * np.pi * u[accepted][:count], 2 * np.pi * v[accepted][:count]
    normals = np.stack([np.cos(v) * np.cos(u), np.cos(v) * np.sin(u), np.sin(v)], axis=1)
    return np.stack([np.cos(u), np.sin(u), 0 * u], axis=1) + 0.4 * normals, normals


def sphere_distance(positions: Points) -> NDArray[np.float64]:
    return np.abs(np.linalg.norm(positions, axis=1) - 1)


def torus_distance(positions: Points) -> NDArray[np.float64]:
    return np.abs(np.hypot(np.hypot(positions[:, 0], positions[:, 1]) - 1, positions[:, 2]) - 0.4)


def poisson(points: Any, normals: Any = None, depth: int = 5, *, device: Any = None, **options: Any):
    """(mesh, densities) of points, with the points as default normals."""
    normals = points if normals is None else normals
    cloud = loom.PointCloud(points, normals=normals, device=device)
    return loom.TriangleMesh.create_from_point_cloud_poisson(cloud, depth, **options)


def bits(result: Any) -> tuple[bytes, ...]:
    mesh, densities = result
    arrays = (mesh.arrays[name].numpy() for name in ("vertices", "triangles", "vertex_normals"))
    return (*(values.tobytes() for values in arrays), densities.tobytes())


def cube_around(points: Points, scale: float = 1.1) -> tuple[Points, float]:
    """(lowest corner, edge length) of the octree's root cube."""
    points = points.astype(np.float32).astype(np.float64)
    low, high = points.min(axis=0), points.max(axis=0)
    side = (high - low).max() * scale
    return (low + high) / 2 - side / 2, side


def edges_by_use(triangles: NDArray[np.int32]) -> tuple[NDArray[np.int32], NDArray[np.int64], int]:
    """(edges as pairs, triangle count of each, duplicate directed edges)."""
    directed = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    edges, counts = np.unique(np.sort(directed, axis=1), axis=0, return_counts=True)
    return edges, counts, len(directed) - len(np.unique(directed, axis=0))


def assert_only_the_cube_cuts(mesh: Any, points: Points, scale: float = 1.1) -> int:
    """No edge has more than two triangles or a duplicate direction, and each open edge lies in a side of the cube.

    Returns:
        The number of open edges.
    """
    edges, counts, twisted = edges_by_use(mesh.triangles)
    assert counts.max() == 2 and twisted == 0
    corner, side = cube_around(points, scale)
    fractions = (mesh.vertices[edges[counts == 1]] - corner) / side  # [open edges, 2, 3]
    on_side = (np.abs(fractions) < 1e-5).all(axis=1) | (np.abs(fractions - 1) < 1e-5).all(axis=1)
    assert on_side.any(axis=1).all(), "an edge within the cube is open: a crack"
    return len(fractions)
