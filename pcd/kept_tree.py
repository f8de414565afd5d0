"""The search tree that clouds keep with their points: built when it is first asked for, shared by all that follows."""

from __future__ import annotations

import warp as wp

from ..kernels.arrays.fingerprint import fingerprint
from ..kernels.search.point_tree import PointTree


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
            tree = self._tree = PointTree(self.points)
            self._mark = fingerprint(self.points) if self._lent else None
        return tree
