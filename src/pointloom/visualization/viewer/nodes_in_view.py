"""Selection of nodes of a point tree for a view, and their projected point spacing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_finite, check_indices, check_numeric, check_positive
from ..render.view import View, check_view

# Minimum distance of a node over its half width, so that nodes around the camera are ordered, too:
# 200 pixels per spacing are enough to come first.
_MIN_DISTANCE_RATIO = 0.1


class NodesInView:
    """Nodes from coarse to fine with view selection. Base class of level-of-detail trees.

    Attributes:
        counts: Number of points of each node, int64 (m,).
        spacings: Point spacing of each node's level [m], float64 (m,).
        levels: Level of each node, 0 is the coarsest.
        middles, halves: Center and half side of each node's cube [m], float64 (m, 3) and (m,).
    """

    _internal = ("are_refined",)

    counts: NDArray[np.int64]
    spacings: NDArray[np.float64]
    levels: NDArray[Any]
    middles: NDArray[np.float64]
    halves: NDArray[np.float64]
    _level_middles: NDArray[np.float64]
    _level_halves: NDArray[np.float64]
    _names: NDArray[np.int64]

    def __len__(self) -> int:
        """Number of nodes."""
        return len(self.counts)

    def select(
        self, view: View, budget: int, *, counts: NDArray[np.int64] | None = None, finest: float = 0.5
    ) -> list[int]:
        """Select the nodes that matter most for a view, coarse before fine.

        Args:
            view: View in world coordinates.
            budget: Maximum number of points. The first node is always selected.
            counts: Number of visible points of each node, shape (m,), if some are hidden.
            finest: Projected spacing [px] below which finer nodes are not needed.

        Returns:
            Nodes inside the image by descending projected spacing. A node follows its parent.

        Raises:
            TypeError, ValueError: Not a View or not numbers, values out of range, or a wrong number of counts.
        """
        budget = check_count("budget", budget, minimum=0)
        counts = self.counts if counts is None else self._check_counts(counts)
        finest = check_positive("finest", finest, allow_zero=True)
        gaps = self.pixels(view, self.spacings)
        seen = np.flatnonzero(self._in_view(view) & (counts > 0))
        # omit nodes that the parent already resolves: its spacing is twice as large
        seen = seen[(2 * gaps[seen] > finest) | (self.levels[seen] == 0)]
        ranked = seen[np.argsort(-gaps[seen], kind="stable")]
        taken = int(np.searchsorted(np.cumsum(counts[ranked]), budget, side="right"))
        return ranked[: max(taken, min(1, budget))].tolist()

    def pixels(self, view: View, lengths: ArrayLike) -> NDArray[np.float64]:
        """Maximum projected size of lengths in a view, where each node's cell is nearest to the camera.

        Args:
            view: View in world coordinates.
            lengths: One per node, shape (m,), or one for all [m].

        Returns:
            Sizes [px], shape (m,).

        Raises:
            TypeError, ValueError: Not a View or not numbers, a wrong number of lengths, or non-finite lengths.
        """
        T, halves = check_view(view).T_world_camera, self._level_halves
        lengths = check_finite("lengths", check_numeric("lengths", lengths))
        if lengths.shape not in ((), (len(self),)):
            raise ValueError(f"lengths: expected shape [{len(self)}], one per node, got {list(lengths.shape)}")
        beyond = np.maximum(np.abs(self._level_middles - T[:3, 3]) - halves[:, None], 0.0)
        distances = np.maximum(np.sqrt((beyond * beyond).sum(axis=1)), _MIN_DISTANCE_RATIO * halves)
        return max(view.intrinsic.fx, view.intrinsic.fy) * lengths / distances

    def are_refined(self, nodes: Sequence[int]) -> NDArray[np.bool_]:
        """For each drawn node, True if the next level within it is drawn, too; bool (k,)."""
        names = self._names[self._check_nodes(nodes)]
        return np.isin(names, names >> 3)

    def _check_nodes(self, nodes: ArrayLike) -> NDArray[Any]:
        return check_indices("nodes", nodes, len(self), of=f"tree of {len(self)} nodes")

    def _check_counts(self, counts: ArrayLike) -> NDArray[np.int64]:
        numbers = check_numeric("counts", counts)
        if numbers.shape != self.counts.shape:
            raise ValueError(f"counts: expected shape [{len(self)}], one per node, got {list(numbers.shape)}")
        if numbers.dtype.kind not in "iu" and numbers.size:
            raise TypeError(f"counts: expected whole numbers, got {numbers.dtype}")
        if (numbers < 0).any() or (numbers > self.counts).any():
            raise ValueError("counts: expected 0 up to the points of each node")
        return numbers.astype(np.int64, copy=False)

    def _in_view(self, view: View) -> NDArray[np.bool_]:
        """True for nodes whose cubes intersect the view pyramid."""
        normals = inward(view)
        heights = (self.middles - view.T_world_camera[:3, 3]) @ normals.T
        return (heights + self.halves[:, None] * np.abs(normals).sum(axis=1) >= 0).all(axis=1)


def inward(view: View) -> NDArray[np.float64]:
    """Inward normals of the 5 planes of the view pyramid, shape (5, 3)."""
    camera, R = view.intrinsic, view.T_world_camera[:3, :3]
    right, left = (camera.width - 0.5 - camera.cx) / camera.fx, (camera.cx + 0.5) / camera.fx
    down, up = (camera.height - 0.5 - camera.cy) / camera.fy, (camera.cy + 0.5) / camera.fy
    return np.array([[1, 0, left], [-1, 0, right], [0, 1, up], [0, -1, down], [0, 0, 1]]) @ R.T
