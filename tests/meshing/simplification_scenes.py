"""Meshes for simplification, and measures of the result."""

import itertools
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pointloom import RaycastingScene, TriangleMesh

from .open3d_meshes import arrays_of, in_open3d


def grid(count: int) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """A flat square of count x count vertices with unit spacing."""
    x, y = np.meshgrid(np.arange(float(count)), np.arange(float(count)))
    first = (np.arange(count - 1)[:, None] * count + np.arange(count - 1)).ravel()
    lower = np.c_[first, first + 1, first + count]
    upper = np.c_[first + 1, first + count + 1, first + count]
    return np.c_[x.ravel(), y.ravel(), np.zeros(count * count)], np.c_[lower, upper].reshape(-1, 3)


def bumpy_torus(around: int = 40, across: int = 24) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """A closed bumpy surface of genus one; multiples of 2^-20, exact in float32 even far away."""
    u, v = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = 2 * np.pi * u.ravel() / around, 2 * np.pi * v.ravel() / across
    small = 0.4 + 0.05 * np.sin(3 * a) * np.cos(2 * b)
    vertices = np.c_[(1 + small * np.cos(b)) * np.cos(a), (1 + small * np.cos(b)) * np.sin(a), small * np.sin(b)]
    here, right = u * across + v, (u + 1) % around * across + v
    up, both = u * across + (v + 1) % across, (u + 1) % around * across + (v + 1) % across
    lower, upper = (np.stack(c, axis=-1).reshape(-1, 3) for c in ((here, right, up), (right, both, up)))
    vertices += 0.001 * np.random.default_rng(0).normal(size=vertices.shape)
    return np.round(vertices * 2**20) / 2**20, np.r_[lower, upper]


def box(cells: int) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """The closed surface of a unit cube with cells x cells squares per side."""
    corners, triangles = [], []
    flat, faces = grid(cells + 1)
    for axis, side in itertools.product(range(3), (0, 1)):
        positions = np.full((len(flat), 3), float(side * cells))
        positions[:, (axis + 1) % 3], positions[:, (axis + 2) % 3] = flat[:, 0], flat[:, 1]
        triangles.append((faces if side else faces[:, ::-1]) + len(flat) * (2 * axis + side))
        corners.append(positions)
    vertices, numbers = np.unique(np.concatenate(corners), axis=0, return_inverse=True)
    return vertices / cells, numbers.reshape(-1)[np.concatenate(triangles)]


def edge_counts(triangles: NDArray[np.int32]) -> dict[tuple[int, int], int]:
    ends = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    edges, counts = np.unique(ends, axis=0, return_counts=True)
    return {(int(a), int(b)): int(n) for (a, b), n in zip(edges, counts, strict=True)}


def euler(mesh: TriangleMesh) -> int:
    return len(np.unique(mesh.triangles)) - len(edge_counts(mesh.triangles)) + len(mesh)


def rms_from(mesh: TriangleMesh, points: NDArray[np.float64]) -> float:
    """The root mean squared distance of points from a mesh."""
    scene = RaycastingScene(mesh.device)
    scene.add_triangles(mesh)
    return float(np.sqrt((scene.compute_distance(points).astype(np.float64) ** 2).mean()))


def open3d_simplified(o3d: Any, mesh: TriangleMesh, scale: float, method: str, *given: Any) -> Any:
    """(vertices, triangles) of Open3D's mesh in another unit, with vertices scaled back, as 32-bit numbers."""
    options = [getattr(o3d.geometry.SimplificationContraction, v) if isinstance(v, str) else v for v in given]
    vertices, triangles = arrays_of(getattr(in_open3d(o3d, mesh, scale), method)(*options))
    return (vertices / scale).astype(np.float32), triangles.astype(np.int32)
