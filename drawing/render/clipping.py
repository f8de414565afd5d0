"""Lines cut off at the edges of a box: `clip_segments`."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

FARTHEST = 1e12  # [px] beyond it the arithmetic of a cut would lose its digits; no place of a picture is so far

Ends = NDArray[np.float64]
Pair = tuple[float, float]


def clip_segments(segments: Ends, low: Pair, high: Pair) -> tuple[Ends, NDArray[np.int64]]:
    """The parts of segments inside a box (Liang and Barsky, "A new concept and method for line clipping", 1984).

    Args:
        segments: Rows (x, y, x, y), shape [n, 4]; those that are not finite are left out.
        low, high: Corners (x, y) of the box.

    Returns:
        (parts, rows): shape [m, 4], and which segments they are of, ascending.

    Example:
        >>> clip_segments(np.array([[-1.0, 0.5, 3.0, 0.5], [5.0, 5.0, 6.0, 6.0]]), (0, 0), (1, 1))[0].tolist()
        [[0.0, 0.5, 1.0, 0.5]]
    """
    rows = np.flatnonzero((np.abs(segments) < FARTHEST).all(axis=1))
    ends = segments[rows]
    start, way = ends[:, :2], ends[:, 2:] - ends[:, :2]
    enter, leave, is_inside = np.zeros(len(ends)), np.ones(len(ends)), np.ones(len(ends), bool)
    for axis in (0, 1):
        moves = way[:, axis] != 0
        to_low = np.divide(low[axis] - start[:, axis], way[:, axis], out=np.zeros(len(ends)), where=moves)
        to_high = np.divide(high[axis] - start[:, axis], way[:, axis], out=np.ones(len(ends)), where=moves)
        enter = np.maximum(enter, np.where(moves, np.minimum(to_low, to_high), 0.0))
        leave = np.minimum(leave, np.where(moves, np.maximum(to_low, to_high), 1.0))
        is_inside &= moves | ((start[:, axis] >= low[axis]) & (start[:, axis] <= high[axis]))
    is_inside &= enter <= leave
    first = start + enter[:, None] * way
    last = np.where(leave[:, None] < 1, start + leave[:, None] * way, ends[:, 2:])
    return np.hstack([first, last])[is_inside], rows[is_inside]
