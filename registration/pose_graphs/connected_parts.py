"""The connected parts of a graph."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def connected_parts(source: NDArray[np.int64], target: NDArray[np.int64], count: int) -> NDArray[np.int32]:
    """The part that each node belongs to, [count], numbered in the order of the parts' first nodes.

    Args:
        source: Where edges begin, [m].
        target: Where they end; to which side they point does not matter.
        count: Nodes.
    """
    first = np.arange(count)  # of the nodes that each is known to be joined to
    while (first[source] != first[target]).any():
        at_source, at_target = first[source], first[target]
        np.minimum.at(first, at_source, at_target)
        np.minimum.at(first, at_target, at_source)
        while (first != first[first]).any():
            first = first[first]
    return np.unique(first, return_inverse=True)[1].astype(np.int32)
