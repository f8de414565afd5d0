"""Outlines in a plane: joined from the lines of a section, and triangulated without additional points."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul

Ends = NDArray[np.int64]
SIDE_ABOVE, SIDE_BELOW = 1, -1
LIBRARY = "manifold3d"


def lines_in_plane(half_edges: NDArray[np.int32], first_new: int) -> Ends:
    """Lines along which a mesh crosses a plane, (n, 2), each once, ordered by vertices. Half-edges are (tail, head,
    side of the piece, number). Vertices from `first_new` on come from the cut. Includes mesh edges in the plane where
    the mesh continues below or in it, or ends; excludes ridges that touch from above."""
    rows = np.asarray(half_edges, np.int64)
    low, high = rows[:, :2].min(axis=1), rows[:, :2].max(axis=1)
    key = low * (int(high.max(initial=0)) + 1) + high
    _, first, group = np.unique(key, return_index=True, return_inverse=True)
    count, group = len(first), group.reshape(-1)
    above = np.bincount(group[rows[:, 2] == SIDE_ABOVE], minlength=count)
    others = np.bincount(group[rows[:, 2] != SIDE_ABOVE], minlength=count)
    is_line = (above > 0) & ((others > 0) | (above % 2 == 1) | (high[first] >= first_new))
    direction = np.where(rows[:, 2] == SIDE_ABOVE, np.where(rows[:, 0] == low, 1, -1), 0)
    is_back = np.bincount(group, direction, minlength=count) < 0
    ends = np.where(is_back[:, None], np.c_[high[first], low[first]], np.c_[low[first], high[first]])
    return ends[is_line]


def outline(half_edges: NDArray[np.int32]) -> Ends:
    """Half-edges shared by an odd number of pieces, (n, 2), in their direction."""
    rows = np.asarray(half_edges, np.int64)
    low, high = rows[:, :2].min(axis=1), rows[:, :2].max(axis=1)
    key = low * (int(high.max(initial=0)) + 1) + high
    _, first, group, counts = np.unique(key, return_index=True, return_inverse=True, return_counts=True)
    direction = np.bincount(group.reshape(-1), np.where(rows[:, 0] == low, 1, -1), minlength=len(first))
    ends = np.where((direction < 0)[:, None], np.c_[high[first], low[first]], np.c_[low[first], high[first]])
    return ends[counts % 2 == 1]


def join_lines(ends: Ends, positions: dict[int, NDArray[np.float64]]) -> tuple[list[list[int]], list[list[int]]]:
    """(loops, paths): lines joined at their ends, each used once. A loop does not repeat its first vertex. Keeps
    directions if consistent. At branches the leftmost turn is taken, so loops touch but do not cross."""
    balance: dict[int, int] = {}
    for a, b in ends.tolist():
        balance[a], balance[b] = balance.get(a, 0) + 1, balance.get(b, 0) - 1
    if any(balance.values()):
        return _trace_paths(ends, positions, directed=_is_path_like(balance))
    return _trace_paths(ends, positions, directed=True)


def run_alike(loops: list[list[int]], ends: Ends) -> bool:
    lines = set(map(tuple, ends.tolist()))
    return all((a, b) in lines for loop in loops for a, b in zip(loop, [*loop[1:], loop[0]], strict=True))


def _is_path_like(balance: dict[int, int]) -> bool:
    """True if unbalanced vertices may be ends of directed paths."""
    return all(abs(value) <= 1 for value in balance.values())


def _trace_paths(
    ends: Ends, positions: dict[int, NDArray[np.float64]], *, directed: bool
) -> tuple[list[list[int]], list[list[int]]]:
    leaving: dict[int, list[tuple[int, int]]] = {}  # of each vertex: (line, other end)
    degree: dict[int, int] = {}
    for line, (a, b) in enumerate(ends.tolist()):
        leaving.setdefault(a, []).append((line, b))
        if not directed:
            leaving.setdefault(b, []).append((line, a))
        for v in (a, b):
            degree[v] = degree.get(v, 0) + (1 if not directed or v == a else -1)
    ragged = [v for v, d in degree.items() if (d > 0 if directed else d % 2 == 1)]
    used = np.zeros(len(ends), bool)
    loops, paths = [], []
    for start in [*ragged, *leaving]:
        while (path := _follow(start, leaving, used, positions)) is not None:
            if path[0] == path[-1]:
                loops.extend(_simple(path[:-1]))
            else:
                paths.append(path)
            if start in ragged and path[0] != path[-1]:
                break
    return loops, paths


def _follow(
    start: int, leaving: dict[int, list[tuple[int, int]]], used: NDArray[np.bool_], positions
) -> list[int] | None:
    """Follow lines from a vertex until closed or stuck. None if there is no line."""
    path, at = [start], start
    while True:
        open_lines = [(line, to) for line, to in leaving.get(at, ()) if not used[line]]
        if not open_lines:
            return path if len(path) > 1 else None
        line, to = open_lines[0] if len(open_lines) == 1 else _leftmost(path, open_lines, positions)
        used[line] = True
        path.append(to)
        at = to
        if at == start:
            return path


def _leftmost(path: list[int], lines: Iterable[tuple[int, int]], positions) -> tuple[int, int]:
    here = positions[path[-1]]
    back = positions[path[-2]] - here if len(path) > 1 else np.array([-1.0, 0.0])

    def clockwise_angle(line: tuple[int, int]) -> float:
        direction = positions[line[1]] - here
        angle = math.atan2(back[0] * direction[1] - back[1] * direction[0], matmul(back, direction))
        return float(-angle % (2 * np.pi)) or 2 * np.pi  # clockwise from the previous line

    return min(lines, key=clockwise_angle)


def _simple(loop: list[int]) -> list[list[int]]:
    """Split a loop at repeated vertices."""
    seen: dict[int, int] = {}
    current: list[int] = []
    parts: list[list[int]] = []
    for v in loop:
        if v in seen:
            start = seen[v]
            parts.append(current[start:])
            for removed in current[start + 1 :]:
                del seen[removed]
            current = current[: start + 1]
        else:
            seen[v] = len(current)
            current.append(v)
    return [*parts, current]


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
