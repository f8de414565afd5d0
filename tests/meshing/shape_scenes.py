"""Meshes for tests of smoothing, subdivision, deformation and measurements."""

from typing import Any

import numpy as np
from hypothesis import strategies as st

from pointloom import TriangleMesh

UTM = np.array([5.0e5, 5.4e6, 100.0])


def icosphere(rounds: int, radius: float = 1.0) -> tuple[np.ndarray, np.ndarray]:
    """An icosphere with 10 * 4^rounds + 2 vertices and 20 * 4^rounds triangles."""
    golden = (1 + 5**0.5) / 2
    corners = [[-1, golden, 0], [1, golden, 0], [-1, -golden, 0], [1, -golden, 0]]
    corners = np.array([np.roll(c, shift) for shift in range(3) for c in corners], float)
    sides = np.linalg.norm(corners[:, None] - corners, axis=2)
    near = np.isclose(sides, 2)
    faces = [
        (a, b, c)
        for a in range(12) for b in range(a + 1, 12) for c in range(b + 1, 12)
        if near[a, b] and near[b, c] and near[c, a]
    ]  # fmt: skip
    outward = [np.linalg.det(corners[list(face)]) > 0 for face in faces]
    faces = [face if out else face[::-1] for face, out in zip(faces, outward, strict=True)]
    mesh = TriangleMesh(corners, faces).subdivide_midpoint(rounds)
    directions = mesh.vertices / np.linalg.norm(mesh.vertices, axis=1, keepdims=True)
    return radius * directions, mesh.triangles


def shaken_grid(cells: int, shake: float = 0.3) -> tuple[np.ndarray, np.ndarray]:
    """A flat open square of side 1; its inner vertices are shifted randomly in the plane, in fractions of a cell."""
    rng, ticks = np.random.default_rng(1), np.linspace(0, 1, cells + 1)
    positions = np.stack(np.meshgrid(ticks, ticks, indexing="ij"), axis=-1)
    positions[1:-1, 1:-1] += rng.uniform(-shake / cells, shake / cells, (cells - 1, cells - 1, 2))
    rows = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    a, b, c, d = rows[:-1, :-1].ravel(), rows[1:, :-1].ravel(), rows[1:, 1:].ravel(), rows[:-1, 1:].ravel()
    flat = np.c_[positions.reshape(-1, 2), np.zeros(rows.size)]
    return flat, np.concatenate([np.c_[a, b, c], np.c_[a, c, d]])


def torn_ball(device: str, rounds: int = 2, **options: Any) -> TriangleMesh:
    """A bumpy sphere with a hole, loose vertices, normals and colors."""
    rng = np.random.default_rng(0)
    vertices, triangles = icosphere(rounds)
    vertices = vertices * (1 + 0.1 * rng.random((len(vertices), 1)))
    normals, colors = vertices / np.linalg.norm(vertices, axis=1, keepdims=True), rng.random(vertices.shape)
    arrays = {"vertex_normals": normals, "vertex_colors": colors} | options
    return TriangleMesh(vertices, triangles[:-25], device=device, **arrays)


# Triangles over eight vertices: many shared edges and vertices, unreferenced vertices, repeated corners.
hostile_triangles = st.lists(st.tuples(*[st.integers(0, 7)] * 3), min_size=1, max_size=14)
eight_vertices = np.random.default_rng(0).normal(size=(8, 3)).astype(np.float32)


def eight_vertex_meshes(count: int = 25, *, distinct: bool = False) -> list[TriangleMesh]:
    """Meshes as in `hostile_triangles`, or of triangles with distinct corners; the same in each run."""
    rng, meshes = np.random.default_rng(11), []
    for _ in range(count):
        size = int(rng.integers(1, 15))
        rows = rng.permuted(np.tile(np.arange(8), (size, 1)), axis=1) if distinct else rng.integers(0, 8, (size, 3))
        meshes.append(TriangleMesh(eight_vertices, rows[:, :3]))
    return meshes
