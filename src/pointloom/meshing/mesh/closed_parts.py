"""Closed parts of a mesh: nesting and the orientation that follows, and parts that duplicate others."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.array_types import Points, Triangles
from ...kernels.arrays.select import gather_rows
from ...kernels.arrays.sort import positions
from ...kernels.lang import float64, int32, vec3
from ...kernels.memory import download, upload, zeros
from ...kernels.meshes.sheets import MIN_VOLUME_RATIO
from ...kernels.rays.triangle_tree import TriangleTree
from ...kernels.rays.winding_numbers import Dipoles, add_winding_numbers
from .mesh_arrays import MeshArrays

PROBES_PER_PART = 3  # points of a part. Most must be inside another
PROBE_DEPTH = 1.0e-4  # of a triangle's size: depth of its test point behind it, so that parts may touch
MIN_OPEN_BULGE = 0.02  # the same for an open part: a fifth of a sphere's


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


class Copies:
    """Triangles that have copies. `rows` are these triangles, ascending, with their `classes` (same vertices) and
    orientations `ways` (0 or 1)."""

    def __init__(self, classes: NDArray[np.int32], corners: NDArray[np.int32]) -> None:
        self.rows = np.flatnonzero(np.bincount(classes)[classes] > 1)
        self.classes = np.unique(classes[self.rows], return_inverse=True)[1]
        a, b, c = corners[self.rows].T
        self.ways = ((a > b).astype(int) + (b > c) + (a > c)) % 2
        self.flat = (a == b) | (b == c) | (a == c)


def find_doubled(copies: Copies, names: NDArray[np.int32], loose: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Triangles of loose parts that contain an opposite copy of all their triangles, bool (t,)."""
    part_names = names[copies.rows]
    keys = (copies.classes.astype(np.int64) * len(names) + part_names) * 2 + copies.ways
    opposite = np.isin(keys ^ 1, keys) & ~copies.flat
    sizes = np.bincount(names, minlength=len(names))
    doubled = np.bincount(part_names[opposite], minlength=len(names)) == sizes
    return doubled[names] & loose


def find_covered(
    mesh: MeshArrays, copies: Copies, names: NDArray[np.int32], twins: NDArray[np.int32]
) -> NDArray[np.bool_]:
    """Triangles of parts covered by others, bool (t,). One of each pair of sides stays. A part is covered if all its
    triangles have copies in kept parts. Solids and walls of hollows are covered only by copies of the same orientation.
    Open parts are dropped first, then inward ones, then later ones. `names` are the first triangles of parts, `twins`
    the paired half-edges or -1."""
    firsts, labels, sizes = np.unique(names, return_inverse=True, return_counts=True)
    part_of = labels[copies.rows]
    fully_copied = np.flatnonzero(np.bincount(part_of[~copies.flat], minlength=len(firsts)) == sizes)
    covered = np.zeros(len(firsts), np.bool_)
    if not len(fully_copied):
        return covered[labels]
    closed = np.bincount(labels[np.flatnonzero(twins < 0) // 3], minlength=len(firsts)) == 0
    sides = _sides_of(mesh, labels, closed, fully_copied)
    solid = _are_solid(mesh, Parts(labels, closed, sides), part_of, copies)
    keys = copies.classes * 2 + copies.ways
    left = np.bincount(keys, minlength=2 * (copies.classes.max() + 1)).tolist()
    order = np.argsort(part_of, kind="stable")
    starts = np.searchsorted(part_of[order], np.arange(len(firsts) + 1))
    for part in sorted(fully_copied.tolist(), key=lambda p: (closed[p], sides[p], -p)):
        part_keys = keys[order[starts[part] : starts[part + 1]]].tolist()
        for key in part_keys:
            left[key] -= 1
        covered[part] = all(left[key] > 0 or (not solid[part] and left[key ^ 1] > 0) for key in part_keys)
        if not covered[part]:
            for key in part_keys:
                left[key] += 1
    return covered[labels]


def _sides_of(
    mesh: Any, labels: NDArray[np.int64], closed: NDArray[np.bool_], chosen: NDArray[np.int64]
) -> NDArray[np.float64]:
    """Signed volume of each chosen part, 0 without orientation; float64 (p,)."""
    count = len(closed)
    rows = np.flatnonzero(np.isin(labels, chosen))
    corners, part_labels = mesh.vertices[mesh.triangles[rows]] - mesh.origin, labels[rows]
    counts = np.maximum(np.bincount(part_labels, minlength=count), 1)[:, None]
    middles = np.column_stack([np.bincount(part_labels, x, count) for x in corners.mean(axis=1).T]) / counts
    a, b, c = (corners - middles[part_labels][:, None]).transpose(1, 0, 2)
    volumes = np.bincount(part_labels, np.einsum("ij,ij->i", a, np.cross(b, c)), count) / 6
    areas = np.bincount(part_labels, np.linalg.norm(np.cross(b - a, c - a), axis=1), count) / 2
    return np.where(np.abs(volumes) > np.where(closed, MIN_VOLUME_RATIO, MIN_OPEN_BULGE) * areas**1.5, volumes, 0.0)


def _are_solid(mesh: Any, parts: Parts, part_of: NDArray[np.int64], copies: Copies) -> NDArray[np.bool_]:
    """True for parts that bound a solid, so that their other side does not cover them, bool (p,). Closed outward parts
    do, and inward ones inside an odd number of parts without common triangles. If the complete mesh is two-sided,
    outward parts inside others do not."""
    solid = parts.closed & (parts.sides > 0)
    if not (parts.closed & (parts.sides < 0)).any():
        return solid
    arrays = mesh.arrays
    sides = _sides_of(mesh, parts.labels, parts.closed, np.flatnonzero(parts.closed))
    all_parts = Parts(parts.labels, parts.closed, sides)
    enclosing = find_enclosing(arrays["vertices"], arrays["triangles"], all_parts)
    is_two_sided = len(copies.rows) == len(parts.labels)
    for part, around in enclosing.items():
        shared = set(part_of[np.isin(copies.classes, copies.classes[part_of == part])].tolist())
        is_odd = sum(all_parts.sides[outer] > 0 for outer in around if outer not in shared) % 2 == 1
        if is_odd and (parts.sides[part] < 0 or is_two_sided):
            solid[part] = parts.sides[part] < 0
    return solid
