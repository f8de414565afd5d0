"""Nesting of closed mesh parts, and the orientation that follows."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...kernels.array_types import Points, Triangles
from ...kernels.arrays.select import gather_rows
from ...kernels.arrays.sort import positions
from ...kernels.lang import float64, int32, vec3
from ...kernels.memory import download, upload, zeros
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.rays.winding_numbers import Dipoles, add_winding_numbers

PROBES_PER_PART = 3  # points of a part. Most must be inside another
PROBE_DEPTH = 1.0e-4  # of a triangle's size: depth of its test point behind it, so that parts may touch


@dataclass(frozen=True)
class Parts:
    """p parts: label of each triangle (t,), `closed` (no border, orientable), `sides` (signed volume)."""

    labels: NDArray[np.int64]
    closed: NDArray[np.bool_]
    sides: NDArray[np.float64]


def find_enclosing(vertices: Points, triangles: Triangles, parts: Parts) -> dict[int, list[int]]:
    """Closed parts that enclose each closed part, ascending. Outermost parts are omitted. A part is inside another if
    its box is, and two of three points behind its largest triangles have winding number > 0.5."""
    inner = np.flatnonzero(parts.closed & (parts.sides != 0))
    if len(inner) < 2:
        return {}
    points, corners = download(vertices).reshape(-1, 3), download(triangles).reshape(-1, 3)  # sync
    order = np.argsort(parts.labels, kind="stable")
    starts = np.searchsorted(parts.labels[order], np.arange(len(parts.closed) + 1))
    low, high = (pick.reduceat(pick.reduce(points[corners], axis=1)[order], starts[:-1]) for pick in
                 (np.minimum, np.maximum))  # fmt: skip
    by_x = inner[np.argsort(low[inner, 0], kind="stable")]
    enclosing: dict[int, list[int]] = {}
    for outer in inner.tolist():
        begin, end = np.searchsorted(low[by_x, 0], [low[outer, 0], high[outer, 0]], side="left")
        near = by_x[begin : max(begin, end)]
        near = near[(near != outer) & (low[near] >= low[outer]).all(axis=1) & (high[near] <= high[outer]).all(axis=1)]
        if not len(near):
            continue
        rows = [order[starts[part] : starts[part + 1]] for part in near.tolist()]
        queries = np.concatenate([
            _points_behind(points, corners[part_rows], float(parts.sides[part]))
            for part, part_rows in zip(near, rows, strict=True)
        ])  # fmt: skip
        part_rows = upload(order[starts[outer] : starts[outer + 1]].astype(np.int32), int32, triangles.device)
        numbers = _winding_numbers(vertices, gather_rows(triangles, part_rows), queries)
        within = (np.abs(numbers) > 0.5).reshape(-1, PROBES_PER_PART).sum(axis=1) * 2 > PROBES_PER_PART
        for part in near[within].tolist():
            enclosing.setdefault(part, []).append(outer)
    return enclosing


def choose_sides(parts: Parts, enclosing: dict[int, list[int]], is_fixed: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Parts to be flipped, bool (p,). Outermost parts face outward. Nested parts that were oriented (`is_fixed`) keep
    their side relative to the enclosing part, unless the winding number would become negative. Others alternate by
    depth."""
    flipped, signs = np.zeros(len(parts.closed), np.bool_), np.sign(parts.sides)
    depths = {part: len(enclosing.get(part, ())) for part in np.flatnonzero(parts.closed).tolist()}
    for part in sorted(depths, key=lambda p: (depths[p], p)):
        around = enclosing.get(part, [])
        if not around:
            flip = signs[part] < 0
        elif not is_fixed[part]:
            flip = signs[part] * (-1) ** depths[part] < 0
        else:
            next_one = max(around, key=lambda p: (depths.get(p, 0), -p))
            flip = bool(flipped[next_one] and is_fixed[next_one])
            behind = sum(signs[p] * (-1 if flipped[p] else 1) for p in around) + signs[part] * (-1 if flip else 1)
            flip = not flip if behind < 0 else flip
        flipped[part] = flip
    return flipped


def _points_behind(points: NDArray[np.float32], corners: NDArray[np.int32], side: float) -> NDArray[np.float64]:
    """Points behind the largest triangles of a part if it faces outward, else before them; (SAMPLES, 3)."""
    a, b, c = points[corners].astype(np.float64).transpose(1, 0, 2)
    cross = np.cross(b - a, c - a)
    sizes = np.linalg.norm(cross, axis=1)
    rows = np.resize(np.argsort(-sizes, kind="stable")[:PROBES_PER_PART], PROBES_PER_PART)
    normals = cross[rows] / np.maximum(sizes[rows], np.finfo(float).tiny)[:, None]
    offset = np.sqrt(sizes[rows])[:, None] * (PROBE_DEPTH if side > 0 else -PROBE_DEPTH)
    return (a[rows] + b[rows] + c[rows]) / 3 - normals * offset


def _winding_numbers(vertices: Points, triangles: Triangles, queries: NDArray[np.float64]) -> NDArray[np.float64]:
    device = vertices.device
    dipoles, numbers = Dipoles(TriangleTree(vertices, triangles)), zeros(len(queries), float64, device)
    points = upload(queries.astype(np.float32), vec3, device)
    add_winding_numbers(dipoles, points, positions(len(queries), device), numbers)
    return download(numbers).copy()  # sync
