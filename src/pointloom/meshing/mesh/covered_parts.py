"""Parts of a mesh that duplicate others: second sides of surfaces, repeated parts."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.meshes.sheets import MIN_VOLUME_RATIO
from .mesh_nesting import Parts, find_enclosing

if TYPE_CHECKING:
    from .mesh_arrays import MeshArrays


MIN_OPEN_BULGE = 0.02  # the same for an open part: a fifth of a sphere's


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
