"""Contour lines of gridded heights by marching squares, in float64 on the host."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .line_set import LineSet

Rows = NDArray[np.float64]


def trace_contours(heights: Rows, corner: Rows, cell: float, levels: Rows) -> LineSet:
    """Contour lines of heights (rows, columns) at the nodes of a grid, southernmost row first.

    A line ends where one of four neighbors is not finite. In a saddle, the mean of the four decides. Lorensen and
    Cline, "Marching cubes", 1987, in two dimensions.
    """
    rows, columns = heights.shape
    positions, lines, count = [np.empty((0, 3))], [np.empty((0, 2), np.int64)], 0
    if min(rows, columns) > 1:
        parts = np.stack([heights[:-1, :-1], heights[:-1, 1:], heights[1:, 1:], heights[1:, :-1]])
        is_known = np.logical_and.reduce(np.isfinite(parts))
        for level in levels.tolist():
            edges = _segments(heights, parts, is_known, level)
            ends, indices = np.unique(_merged(edges, heights, level), return_inverse=True)
            indices = indices.reshape(-1, 2)
            positions.append(_positions(ends, heights, corner, cell, level))
            lines.append(count + indices[indices[:, 0] != indices[:, 1]])
            count += len(ends)
    return LineSet(np.concatenate(positions), np.concatenate(lines).astype(np.int32))


def _segments(heights: Rows, parts: Rows, is_known: NDArray[np.bool_], level: float) -> NDArray[np.int64]:
    """Pairs of crossed grid edges. Edge 2 k leads from node k to the east, edge 2 k + 1 to the north."""
    columns = heights.shape[1]
    y, x = np.nonzero(is_known & ((parts > level).any(axis=0) != (parts > level).all(axis=0)))
    corners = parts[:, y, x]
    a, b, c, d = corners > level
    node = y * columns + x
    bottom, left, right, top = 2 * node, 2 * node + 1, 2 * (node + 1) + 1, 2 * (node + columns)
    saddle = (a == c) & (b == d)
    around_b = saddle & ((corners.mean(axis=0) > level) == a)  # lines around b and d, otherwise around a and c
    crossed = [a != b, b != c, c != d, d != a]
    pairs = []
    names = (bottom, right, top, left)
    for first in range(4):
        for second in range(first + 1, 4):
            chosen = ~saddle & crossed[first] & crossed[second]
            if (first, second) in ((0, 1), (2, 3)):
                chosen = chosen | around_b
            if (first, second) in ((0, 3), (1, 2)):
                chosen = chosen | (saddle & ~around_b)
            pairs.append(np.column_stack([names[first][chosen], names[second][chosen]]))
    return np.concatenate(pairs)


def _ends_of(edges: NDArray[np.int64], columns: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    first = edges // 2
    return first, first + np.where(edges % 2, columns, 1)


def _merged(edges: NDArray[np.int64], heights: Rows, level: float) -> NDArray[np.int64]:
    """Edges, or -1 - node if a node is at the level, so that lines through it share their point."""
    flat = heights.ravel()
    first, second = _ends_of(edges, heights.shape[1])
    return np.where(flat[first] == level, -1 - first, np.where(flat[second] == level, -1 - second, edges))


def _positions(ends: NDArray[np.int64], heights: Rows, corner: Rows, cell: float, level: float) -> Rows:
    flat, columns = heights.ravel(), heights.shape[1]
    first, second = _ends_of(np.maximum(ends, 0), columns)
    first = np.where(ends < 0, -1 - ends, first)
    second = np.where(ends < 0, first, second)
    rise = flat[second] - flat[first]
    fraction = np.divide(level - flat[first], rise, out=np.zeros(len(ends)), where=rise != 0)
    x = first % columns + fraction * (second % columns - first % columns)
    y = first // columns + fraction * (second // columns - first // columns)
    return np.column_stack([corner[0] + cell * x, corner[1] + cell * y, np.full(len(ends), level)])
