"""Nodes of a tree of points as a view sees them: which matter to it, and how far apart their points are in it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_finite, check_indices, check_numeric, check_positive
from ..render.view import View, check_view

# No node is taken to be nearer than this share of its half width, so that those that the camera stands in have an order
# among others: 200 pixels a spacing are enough to come first.
_NEAREST = 0.1


class NodesInView:
    """Nodes from coarse to fine, of which a view takes some; what a tree of them has besides is told by its own class.

    Attributes:
        counts: Points of each node, int64 [m].
        spacings: Between the points of each node's level [m], float64 [m].
        levels: Of each node, 0 is the coarsest.
        middles, halves: Cubes that hold the nodes' points [m], float64 [m, 3] and [m].
    """

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
        """The nodes that matter most for a view, coarse before fine.

        Args:
            view: Where it is taken from, in world coordinates.
            budget: Points at most; but the first node is always taken.
            counts: Points that count of each node, shape [m], where some are hidden; 0 up to all of them.
            finest: A spacing [px] below which finer nodes would change nothing.

        Returns:
            Nodes within the picture, those with the widest projected spacing first; a node comes after the node that
            its cell lies in.

        Raises:
            TypeError: No View, or not numbers.
            ValueError: Numbers out of range, or not as many counts as nodes.
        """
        budget = check_count("budget", budget, minimum=0)
        counts = self.counts if counts is None else self._check_counts(counts)
        finest = check_positive("finest", finest, allow_zero=True)
        gaps = self.pixels(view, self.spacings)
        seen = np.flatnonzero(self._in_view(view) & (counts > 0))
        # what the node above already shows finer than that is left out: its own spacing is twice as wide
        seen = seen[(2 * gaps[seen] > finest) | (self.levels[seen] == 0)]
        ranked = seen[np.argsort(-gaps[seen], kind="stable")]
        taken = int(np.searchsorted(np.cumsum(counts[ranked]), budget, side="right"))
        return ranked[: max(taken, min(1, budget))].tolist()

    def pixels(self, view: View, lengths: Any) -> NDArray[np.float64]:
        """How long lengths appear at most in a view, where each node's cell is nearest to it.

        Args:
            view: Where it is taken from, in world coordinates.
            lengths: One a node, shape [m], or one for all [m].

        Returns:
            Shape [m] [px].

        Raises:
            TypeError: No View, or not numbers.
            ValueError: Not as many lengths as nodes, or such as are not finite.
        """
        T, halves = check_view(view).T_world_camera, self._level_halves
        lengths = check_finite("lengths", check_numeric("lengths", lengths))
        if lengths.shape not in ((), (len(self),)):
            raise ValueError(f"lengths: expected shape [{len(self)}], one a node, got {list(lengths.shape)}")
        beyond = np.maximum(np.abs(self._level_middles - T[:3, 3]) - halves[:, None], 0.0)
        distances = np.maximum(np.sqrt((beyond * beyond).sum(axis=1)), _NEAREST * halves)
        return max(view.intrinsic.fx, view.intrinsic.fy) * lengths / distances

    def _are_refined(self, nodes: Sequence[int]) -> NDArray[np.bool_]:
        """Of nodes that are drawn, within which the next level is drawn too, bool [k].

        Args:
            nodes: Those that are drawn, such as `select` gives.

        Raises:
            TypeError: Not whole numbers.
            IndexError: There is no such node.
        """
        names = self._names[self._check_nodes(nodes)]
        return np.isin(names, names >> 3)

    def _check_nodes(self, nodes: Any) -> NDArray[Any]:
        return check_indices("nodes", nodes, len(self), of=f"tree of {len(self)} nodes")

    def _check_counts(self, counts: Any) -> NDArray[np.int64]:
        numbers = check_numeric("counts", counts)
        if numbers.shape != self.counts.shape:
            raise ValueError(f"counts: expected shape [{len(self)}], one a node, got {list(numbers.shape)}")
        if numbers.dtype.kind not in "iu" and numbers.size:
            raise TypeError(f"counts: expected whole numbers, got {numbers.dtype}")
        if (numbers < 0).any() or (numbers > self.counts).any():
            raise ValueError("counts: expected 0 up to the points of each node")
        return numbers.astype(np.int64, copy=False)

    def _in_view(self, view: View) -> NDArray[np.bool_]:
        """Which nodes' cubes reach into the pyramid that a view shows."""
        normals = inward(view)
        heights = (self.middles - view.T_world_camera[:3, 3]) @ normals.T
        return (heights + self.halves[:, None] * np.abs(normals).sum(axis=1) >= 0).all(axis=1)


def inward(view: View) -> NDArray[np.float64]:
    """Normals of the five planes about the pyramid that a view shows, shape [5, 3]; what is inside is above all."""
    camera, R = view.intrinsic, view.T_world_camera[:3, :3]
    right, left = (camera.width - 0.5 - camera.cx) / camera.fx, (camera.cx + 0.5) / camera.fx
    down, up = (camera.height - 0.5 - camera.cy) / camera.fy, (camera.cy + 0.5) / camera.fy
    return np.array([[1, 0, left], [-1, 0, right], [0, 1, up], [0, -1, down], [0, 0, 1]]) @ R.T
