"""The tree of the pairs that are borne out most, and poses along it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul
from ..rigid import invert_pose

Array = NDArray[np.float64]


class Pair(Protocol):
    """A pose T_target_source between two of some clouds."""

    @property
    def source(self) -> int:
        """The cloud that is moved."""
        ...

    @property
    def target(self) -> int:
        """The cloud that stays."""
        ...

    @property
    def transformation(self) -> Array:
        """T_target_source, [4, 4]."""
        ...


def spanning_tree(
    pairs: Sequence[Pair], support: Array | Sequence[float], count: int
) -> tuple[list[int], NDArray[np.int64]]:
    """The pairs of the tree of most support, by their places, and the group of each cloud, its lowest (Kruskal 1956).

    Of pairs of equal support the first comes first.
    """
    groups = np.arange(count)
    tree = []
    for k in np.argsort(-np.asarray(support), kind="stable").tolist():
        a, b = groups[pairs[k].source], groups[pairs[k].target]
        if a != b:
            groups[groups == max(a, b)] = min(a, b)
            tree.append(k)
    return tree, groups.astype(np.int64)


def chain(first: Array, roots: Iterable[int], pairs: Sequence[Pair], tree: Sequence[int]) -> Array:
    """Poses along the tree from roots, which stay where they are, as do those that it does not lead to.

    Args:
        first: Poses to begin from, [n, 4, 4].
        roots: Clouds.
        pairs: All of them.
        tree: The places of the tree's.
    """
    poses, reached, waiting = first.copy(), set(roots), list(tree)
    while waiting:
        rest = []
        for k in waiting:
            pair = pairs[k]
            if pair.target in reached:
                poses[pair.source] = matmul(poses[pair.target], pair.transformation)
                reached.add(pair.source)
            elif pair.source in reached:
                poses[pair.target] = matmul(poses[pair.source], invert_pose(pair.transformation))
                reached.add(pair.target)
            else:
                rest.append(k)
        if len(rest) == len(waiting):
            break  # the pairs that are left belong to other groups
        waiting = rest
    return poses
