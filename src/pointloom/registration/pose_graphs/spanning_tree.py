"""Maximum spanning tree of pairs, and poses along it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul
from ..rigid import invert_pose

Array = NDArray[np.float64]


class Pair(Protocol):
    @property
    def source(self) -> int: ...

    @property
    def target(self) -> int: ...

    @property
    def transformation(self) -> Array: ...


def spanning_tree(
    pairs: Sequence[Pair], support: Array | Sequence[float], count: int
) -> tuple[list[int], NDArray[np.int64]]:
    """Maximum spanning tree (Kruskal 1956), and each cloud's lowest group member; ties: the first pair."""
    groups = np.arange(count)
    tree = []
    for k in np.argsort(-np.asarray(support), kind="stable").tolist():
        a, b = groups[pairs[k].source], groups[pairs[k].target]
        if a != b:
            groups[groups == max(a, b)] = min(a, b)
            tree.append(k)
    return tree, groups.astype(np.int64)


def chain(first: Array, roots: Iterable[int], pairs: Sequence[Pair], tree: Sequence[int]) -> Array:
    """Propagate poses [n, 4, 4] along the tree from the roots. Unreached ones are unchanged."""
    poses, visited, waiting = first.copy(), set(roots), list(tree)
    while waiting:
        rest = []
        for k in waiting:
            pair = pairs[k]
            if pair.target in visited:
                poses[pair.source] = matmul(poses[pair.target], pair.transformation)
                visited.add(pair.source)
            elif pair.source in visited:
                poses[pair.target] = matmul(poses[pair.source], invert_pose(pair.transformation))
                visited.add(pair.target)
            else:
                rest.append(k)
        if len(rest) == len(waiting):
            break  # the remaining pairs belong to other groups
        waiting = rest
    return poses
