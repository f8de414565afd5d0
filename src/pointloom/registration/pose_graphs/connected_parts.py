"""Connected components of a graph."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def connected_parts(source: NDArray[np.int64], target: NDArray[np.int64], count: int) -> NDArray[np.int32]:
    """The component of each node, [count], numbered by first node. Edges are undirected, [m]."""
    first = np.arange(count)  # lowest known node of the component
    while (first[source] != first[target]).any():
        at_source, at_target = first[source], first[target]
        np.minimum.at(first, at_source, at_target)
        np.minimum.at(first, at_target, at_source)
        while (first != first[first]).any():
            first = first[first]
    return np.unique(first, return_inverse=True)[1].astype(np.int32)
