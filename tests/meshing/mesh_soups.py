"""Meshes that tests of clean-up, topology and repair share: soups, one-sided surfaces, solids."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from pointloom import TriangleMesh, marching_cubes

BOX = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
BOX_SIDES = np.array(
    [
        *([0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1]),
        *([2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]),
    ]
)
FAR = np.array([5.0e5, 5.4e6, 100.0])
# Corners that name a vertex twice, copies, turned and opposite ones, edges of many triangles: all are likely.
SOUPS = st.lists(st.tuples(*[st.integers(0, 6)] * 3), max_size=14)
GOOD_SOUPS = st.lists(st.permutations(range(7)).map(lambda p: tuple(p[:3])), max_size=14)


def fixed_soups(count: int = 40, *, good: bool = False) -> list[TriangleMesh]:
    """Meshes such as SOUPS or GOOD_SOUPS make, the same in each run."""
    rng, meshes = np.random.default_rng(7), []
    for _ in range(count):
        size, used = int(rng.integers(0, 15)), int(rng.integers(3, 8))
        rows = rng.permuted(np.tile(np.arange(used), (size, 1)), axis=1) if good else rng.integers(0, used, (size, 3))
        meshes.append(soup(rows[:, :3].reshape(-1, 3)))
    return meshes


def soup(triangles: Any, device: Any = None) -> TriangleMesh:
    """Seven vertices in general position."""
    return TriangleMesh(np.random.default_rng(0).random((7, 3)), triangles, device=device)


def grid(rows: int, columns: int, *, wrap: bool = False, twist: bool = False, close: bool = False) -> NDArray[np.int32]:
    """Triangles over rows x columns vertices; `wrap` joins the first row to the last, mirrored with `twist`, and
    `close` the first column to the last: with all a Klein bottle."""
    triangles = []
    for r in range(rows if wrap else rows - 1):
        for c in range(columns if close else columns - 1):
            d, last = (c + 1) % columns, r == rows - 1
            below = [r * columns + c, r * columns + d]
            above = [((r + 1) % rows) * columns + (-k % columns if close else columns - 1 - k) if last and twist
                     else ((r + 1) % rows) * columns + k for k in (c, d)]  # fmt: skip
            triangles += [[below[0], below[1], above[1]], [below[0], above[1], above[0]]]
    return np.array(triangles, np.int32)


def surface(rows: int, columns: int, **joined: bool) -> TriangleMesh:
    """A `grid` with vertices anywhere."""
    return TriangleMesh(np.random.default_rng(0).random((rows * columns, 3)), grid(rows, columns, **joined))


def ball(device: Any = None, cells: int = 16) -> TriangleMesh:
    x = np.mgrid[-1 : 1 : cells * 1j, -1 : 1 : cells * 1j, -1 : 1 : cells * 1j]
    return marching_cubes(np.linalg.norm(x, axis=0) - 0.7, device=device)
