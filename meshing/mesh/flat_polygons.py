"""Flat outlines filled with triangles that use all their points and no others."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul

LIBRARY = "manifold3d"


def load_manifold(name: str) -> Any:
    """The library of booleans and polygons, for the function of some name.

    Raises:
        ImportError: It is not installed.
    """
    try:
        import manifold3d
    except ImportError as error:
        raise ImportError(f'{name} needs the package {LIBRARY}: pip install "pointloom[mesh]"') from error
    return manifold3d


def fill_loops(name: str, loops: list[NDArray[np.float64]]) -> NDArray[np.int64]:
    """Triangles between outlines, whose edges they have as these run: what lies to the left is inside.

    Args:
        name: Of the function, for the message.
        loops: float64 [k, 2] each, k at least 3.

    Returns:
        [t, 3] numbers of the points of all loops in their order. Each edge between two triangles runs both ways, and
        each edge of an outline once, also where outlines cross each other or themselves; triangles overlap there.
    """
    if not loops:
        return np.zeros((0, 3), np.int64)
    found = load_manifold(name).triangulate([np.ascontiguousarray(loop, np.float64) for loop in loops])
    return np.asarray(found, np.int64).reshape(-1, 3)


def turn_by_depth(loops: list[NDArray[np.float64]]) -> list[bool]:
    """Which of some outlines have to be turned, so that those within an even number of others run to the left."""
    turns = []
    for k, loop in enumerate(loops):
        depth = sum(encloses(other, loop[0]) for j, other in enumerate(loops) if j != k)
        turns.append(bool((signed_area(loop) > 0) == (depth % 2 == 1)))
    return turns


def signed_area(loop: NDArray[np.float64]) -> float:
    """The area of an outline, below zero where it runs clockwise."""
    x, y = (loop - loop[0]).T
    return float(matmul(x, np.roll(y, -1)) - matmul(y, np.roll(x, -1))) / 2


def encloses(loop: NDArray[np.float64], point: NDArray[np.float64]) -> bool:
    """Whether a point lies in an outline, by the number of times that a ray to the right crosses it."""
    x, y = (loop - point).T
    x2, y2 = np.roll(x, -1), np.roll(y, -1)
    crosses = (y > 0) != (y2 > 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        at = x + (x2 - x) * (-y / (y2 - y))
    return bool((crosses & (at > 0)).sum() % 2)
