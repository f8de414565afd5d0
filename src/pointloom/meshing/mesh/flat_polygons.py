"""Triangulation of flat outlines without additional points."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul

LIBRARY = "manifold3d"


def load_manifold(name: str) -> Any:
    """Import manifold3d for a function. ImportError if it is not installed."""
    try:
        import manifold3d
    except ImportError as error:
        raise ImportError(f'{name} needs the package {LIBRARY}: pip install "pointloom[mesh]"') from error
    return manifold3d


def fill_loops(name: str, loops: list[NDArray[np.float64]]) -> NDArray[np.int64]:
    """Triangulate outlines (k, 2), inside to their left. Returns point numbers (t, 3). Each inner edge runs both ways,
    each outline edge once, also where outlines intersect. Triangles overlap there."""
    if not loops:
        return np.zeros((0, 3), np.int64)
    triangles = load_manifold(name).triangulate([np.ascontiguousarray(loop, np.float64) for loop in loops])
    return np.asarray(triangles, np.int64).reshape(-1, 3)


def loops_to_reverse(loops: list[NDArray[np.float64]]) -> list[bool]:
    """True for outlines to reverse so that those inside an even number of others are counterclockwise."""
    is_reversed = []
    for k, loop in enumerate(loops):
        depth = sum(encloses(other, loop[0]) for j, other in enumerate(loops) if j != k)
        is_reversed.append(bool((signed_area(loop) > 0) == (depth % 2 == 1)))
    return is_reversed


def signed_area(loop: NDArray[np.float64]) -> float:
    """Area of an outline, negative if clockwise."""
    x, y = (loop - loop[0]).T
    return float(matmul(x, np.roll(y, -1)) - matmul(y, np.roll(x, -1))) / 2


def encloses(loop: NDArray[np.float64], point: NDArray[np.float64]) -> bool:
    """True if a point is inside an outline (ray crossing)."""
    x, y = (loop - point).T
    x2, y2 = np.roll(x, -1), np.roll(y, -1)
    crosses = (y > 0) != (y2 > 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        at = x + (x2 - x) * (-y / (y2 - y))
    return bool((crosses & (at > 0)).sum() % 2)
