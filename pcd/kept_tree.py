"""The search tree that clouds keep with their points: built when it is first asked for, shared by all that follows."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp

from ..kernels.arrays.fingerprint import fingerprint
from ..kernels.memory import download
from ..kernels.search.point_tree import PointTree

# Squares of distances are float32, and those between 1.2e-38 and 3.4e38 are normal numbers of full precision.
SMALLEST_EXTENT = 1e-13  # [m] a millionth of it is 1e-19, whose square is the least normal number
LARGEST_EXTENT = 1e19  # [m] the diagonal of a box as wide still has a square


class KeptTree:
    """An array of points, and the tree over them once there is one.

    All clouds over the same points hold the same KeptTree, so the tree goes when the last of them does. An array that
    was lent to other code may be written there: its tree is built anew where the points are no longer what they were.

    Args:
        points: Device array of vec3.
        lent: Other code can write to it.
    """

    def __init__(self, points: wp.array, *, lent: bool = False):
        self.points, self._lent = points, lent
        self._tree: PointTree | None = None
        self._mark: int | None = None

    def adopt(self, tree: PointTree) -> None:
        """Keep a tree over these very points that was built elsewhere."""
        if self._tree is None and not self._lent and tree.source is self.points:
            self._tree = tree

    def lend(self) -> wp.array:
        """The points, for code that may write to them."""
        if not self._lent:
            self._lent = True
            self._mark = fingerprint(self.points) if self._tree is not None else None
        return self.points

    @property
    def known(self) -> PointTree | None:
        """The search tree where it is built already and the points are still the same."""
        if self._tree is not None and self._lent and fingerprint(self.points) != self._mark:
            self._tree = None
        return self._tree

    def tree(self) -> PointTree:
        """The search tree over the points as they are now: 20 B a point, 12 of them a copy of the points."""
        tree = self.known
        if tree is None:
            tree = PointTree(self.points)
            check_extent("points", tree.low, tree.high, self.points)
            self._tree = tree
            self._mark = fingerprint(self.points) if self._lent else None
        return tree


def check_extent(name: str, low: Any, high: Any, points: wp.array) -> None:
    """Refuse points whose squared distances are no numbers of float32: all of them would count as zero, or as infinite.

    Single points that lie beyond the others' reach are let through: they are nobody's neighbours.

    Args:
        name: What the user's argument is called.
        low, high: The box of the finite points, float32 [3].
        points: Device array of vec3, looked at only where the box is too large.

    Raises:
        ValueError: The points span less than 1e-13 m, other than none, or most of them more than 1e19 m.
    """
    extent = float((np.asarray(high, np.float64) - low).max(initial=0.0))
    if 0 < extent < SMALLEST_EXTENT:
        raise ValueError(
            f"{name}: they span {extent:.3g} m, and distances within less than {SMALLEST_EXTENT:g} m have squares "
            f"below float32; take a smaller unit of length, such as cloud.scale({1 / extent:.0e}, cloud.get_center())"
        )
    if extent > LARGEST_EXTENT:
        rows = download(points).astype(np.float64)
        rows = rows[np.isfinite(rows).all(axis=1)]
        near = np.abs(rows - np.median(rows, axis=0)).max(axis=1) <= LARGEST_EXTENT / 2
        if near.sum() <= len(rows) / 2:
            raise ValueError(
                f"{name}: most lie more than {LARGEST_EXTENT / 2:g} m from their middle, and distances as large have "
                f"squares beyond float32; take a larger unit of length, such as cloud.scale({1 / extent:.0e}, "
                "cloud.get_center())"
            )
