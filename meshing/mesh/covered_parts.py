"""Parts of a mesh that lie on others of it, triangle for triangle: the second side of a surface, a part given twice."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.meshes.sheets import FLAT
from .mesh_nesting import Parts, find_enclosing

BULGE = 0.02  # the same for an open part: a fifth of a ball's


class Copies:
    """The triangles that have copies, by class.

    Args:
        classes: Of all triangles, int [t]: one number for those of the same three vertices.
        corners: Those vertices, int [t, 3].

    Attributes:
        rows: The triangles with a copy, int [n], ascending.
        classes: Their classes, 0 .. c-1.
        ways: Which of the two ways round each is, 0 or 1.
    """

    def __init__(self, classes: NDArray[np.int32], corners: NDArray[np.int32]) -> None:
        self.rows = np.flatnonzero(np.bincount(classes)[classes] > 1)
        self.classes = np.unique(classes[self.rows], return_inverse=True)[1]
        a, b, c = corners[self.rows].T
        self.ways = ((a > b).astype(int) + (b > c) + (a > c)) % 2
        self.flat = (a == b) | (b == c) | (a == c)


def find_doubled(copies: Copies, names: NDArray[np.int32], loose: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Whether each triangle belongs to a loose part that holds an opposite copy of all of its triangles, bool [t].

    Args:
        copies: The copies.
        names: The first triangle of each one's part, int [t].
        loose: Whether it was no part of a closed surface, bool [t].
    """
    own = names[copies.rows]
    keys = (copies.classes.astype(np.int64) * len(names) + own) * 2 + copies.ways
    opposite = np.isin(keys ^ 1, keys) & ~copies.flat
    sizes = np.bincount(names, minlength=len(names))
    doubled = np.bincount(own[opposite], minlength=len(names)) == sizes
    return doubled[names] & loose


def find_covered(mesh: Any, copies: Copies, names: NDArray[np.int32], twins: NDArray[np.int32]) -> NDArray[np.bool_]:
    """Which triangles belong to parts that others cover, bool [t]: one of each pair of sides stays.

    A part is covered where all of its triangles have copies in parts that stay. A closed part that looks outwards is a
    solid: only copies that look the same way cover it, so one that fills the room between others stays. One that looks
    inwards and lies within another is the wall of a hollow, and the same holds. Open parts go first, then those that
    look inwards, then later ones: of an open sheet the side stays that is listed first, of a vault the outer one.

    Args:
        mesh: The mesh.
        copies: The copies among its triangles.
        names: The first triangle of each one's part, int [t].
        twins: The other half-edge of each one's pair or -1, int [3 t].
    """
    firsts, labels, sizes = np.unique(names, return_inverse=True, return_counts=True)
    part_of = labels[copies.rows]
    whole = np.flatnonzero(np.bincount(part_of[~copies.flat], minlength=len(firsts)) == sizes)
    gone = np.zeros(len(firsts), np.bool_)
    if not len(whole):
        return gone[labels]
    closed = np.bincount(labels[np.flatnonzero(twins < 0) // 3], minlength=len(firsts)) == 0
    sides = _sides_of(mesh, labels, closed, whole)
    solid = _are_solid(mesh, Parts(labels, closed, sides), part_of, copies)
    keys = copies.classes * 2 + copies.ways
    left = np.bincount(keys, minlength=2 * (copies.classes.max() + 1)).tolist()
    order = np.argsort(part_of, kind="stable")
    starts = np.searchsorted(part_of[order], np.arange(len(firsts) + 1))
    for part in sorted(whole.tolist(), key=lambda p: (closed[p], sides[p], -p)):
        own = keys[order[starts[part] : starts[part + 1]]].tolist()
        for key in own:
            left[key] -= 1
        gone[part] = all(left[key] > 0 or (not solid[part] and left[key ^ 1] > 0) for key in own)
        if not gone[part]:
            for key in own:
                left[key] += 1
    return gone[labels]


def _sides_of(
    mesh: Any, labels: NDArray[np.int64], closed: NDArray[np.bool_], chosen: NDArray[np.int64]
) -> NDArray[np.float64]:
    """The volume between each chosen part and the middle of its vertices, 0 where it looks neither way; float64 [p]."""
    count = len(closed)
    rows = np.flatnonzero(np.isin(labels, chosen))
    corners, own = mesh.vertices[mesh.triangles[rows]] - mesh.origin, labels[rows]
    counts = np.maximum(np.bincount(own, minlength=count), 1)[:, None]
    middles = np.column_stack([np.bincount(own, x, count) for x in corners.mean(axis=1).T]) / counts
    a, b, c = (corners - middles[own][:, None]).transpose(1, 0, 2)
    volumes = np.bincount(own, np.einsum("ij,ij->i", a, np.cross(b, c)), count) / 6
    areas = np.bincount(own, np.linalg.norm(np.cross(b - a, c - a), axis=1), count) / 2
    return np.where(np.abs(volumes) > np.where(closed, FLAT, BULGE) * areas**1.5, volumes, 0.0)


def _are_solid(mesh: Any, parts: Parts, part_of: NDArray[np.int64], copies: Copies) -> NDArray[np.bool_]:
    """Whether each part is the skin of a solid, so that its other side does not stand for it, bool [p].

    A closed part is that looks outwards, and one that looks inwards as the wall of a hollow: within an odd number of
    parts that it shares no triangle with. Where all of the mesh has two sides, what lies so and looks outwards is none.
    """
    solid = parts.closed & (parts.sides > 0)
    if not (parts.closed & (parts.sides < 0)).any():
        return solid
    arrays = mesh._device_arrays
    whole = Parts(parts.labels, parts.closed, _all_sides(mesh, parts))
    enclosing = find_enclosing(arrays["vertices"], arrays["triangles"], whole)
    is_two_sided = len(copies.rows) == len(parts.labels)
    for part, around in enclosing.items():
        shared = set(part_of[np.isin(copies.classes, copies.classes[part_of == part])].tolist())
        is_odd = sum(whole.sides[outer] > 0 for outer in around if outer not in shared) % 2 == 1
        if is_odd and (parts.sides[part] < 0 or is_two_sided):
            solid[part] = parts.sides[part] < 0
    return solid


def _all_sides(mesh: Any, parts: Parts) -> NDArray[np.float64]:
    return _sides_of(mesh, parts.labels, parts.closed, np.flatnonzero(parts.closed))
