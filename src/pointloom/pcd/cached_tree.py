"""Search tree cached with the points, built on demand and shared."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp

from ..core.checks import shown
from ..kernels.arrays.fingerprint import fingerprint
from ..kernels.memory import download
from ..kernels.search.many_clouds import ManyClouds
from ..kernels.search.point_forest import PointForest
from ..kernels.search.point_tree import PointTree

# Squared distances are float32, with full precision from 1.2e-38 to 3.4e38.
SMALLEST_EXTENT = 1e-13  # [m] a millionth is 1e-19, whose square is the smallest normal number
LARGEST_EXTENT = 1e19  # [m] the squared diagonal of such a box is finite


class CachedTree:
    """An array of points and its search tree, shared by all clouds over the same points. If the array `is_shared` with
    other code, the tree is rebuilt when the points changed, unless they are `frozen`: the caller never writes to them.
    """

    def __init__(self, points: wp.array, *, is_shared: bool = False, frozen: bool = False):
        if not isinstance(frozen, bool | np.bool_):
            raise TypeError(f"frozen: expected True or False, got {shown(frozen)}. Use another name for an attribute")
        self.points, self._is_shared, self._is_frozen = points, is_shared and not frozen, frozen
        self._tree: PointTree | None = None
        self._order: ManyClouds | None = None
        self._forest: PointForest | None = None
        self._mark: int | None = None  # fingerprint of the points that these were built from

    def adopt(self, tree: PointTree) -> None:
        if self._tree is None and not self._is_shared and tree.source is self.points:
            self._tree = tree

    def share(self) -> wp.array:
        """The points, for code that may write to them."""
        if not self._is_shared and not self._is_frozen:
            is_empty = self._tree is None and self._order is None
            self._mark = None if is_empty else fingerprint(self.points)
            self._is_shared = True
        return self.points

    def _drop_outdated(self) -> None:
        """Drop what was built if the points, which are shared, have changed."""
        if (mark := fingerprint(self.points)) != self._mark:
            self._tree = self._order = self._forest = None
            self._mark = mark

    @property
    def known(self) -> PointTree | None:
        """The cached tree if the points are unchanged, else None."""
        if self._is_shared and self._tree is not None:
            self._drop_outdated()
        return self._tree

    def tree(self) -> PointTree:
        """Search tree of the current points: 20 B per point, 12 B of them a copy of the points."""
        if self._is_shared:
            self._drop_outdated()
        tree = self._tree
        if tree is None:
            tree = PointTree(self.points)
            check_extent("points", tree.low, tree.high, self.points)
            self._tree = tree
        return tree

    def order(self) -> ManyClouds:
        """Current points along the curve, as the source of registrations: 16 B per point."""
        if self._is_shared:
            self._drop_outdated()
        order = self._order
        if order is None:
            order = self._order = ManyClouds([self.points], self._tree)
        return order

    def forest(self) -> PointForest:
        """Search tree of the current points as the target of registrations: tree and order."""
        tree, forest = self.tree(), self._forest
        if forest is None:
            forest = self._forest = PointForest([self.points], tree, order=self._order or self.order())
        return forest


def check_extent(name: str, low: Any, high: Any, points: wp.array) -> None:
    """Raise ValueError if squared distances exceed float32: an extent below 1e-13 m, or mostly above 1e19 m. Single
    distant points are allowed. They have no neighbors. `points` is read only if the box is too large."""
    extent = float((np.asarray(high, np.float64) - low).max(initial=0.0))
    if 0 < extent < SMALLEST_EXTENT:
        raise ValueError(
            f"{name}: expected an extent of at least {SMALLEST_EXTENT:g} m, got {extent:.3g} m: squared distances "
            f"underflow float32. Use a smaller unit of length, such as cloud.scale({1 / extent:.0e}, "
            "cloud.get_center())"
        )
    if extent > LARGEST_EXTENT:
        rows = download(points).astype(np.float64)
        rows = rows[np.isfinite(rows).all(axis=1)]
        near = np.abs(rows - np.median(rows, axis=0)).max(axis=1) <= LARGEST_EXTENT / 2
        if near.sum() <= len(rows) / 2:
            raise ValueError(
                f"{name}: expected most points within {LARGEST_EXTENT / 2:g} m of their center, got larger distances: "
                f"their squares overflow float32. Use a larger unit of length, such as cloud.scale({1 / extent:.0e}, "
                "cloud.get_center())"
            )
