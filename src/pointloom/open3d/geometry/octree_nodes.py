"""Nodes of an `Octree` as plain Python objects."""

from __future__ import annotations

import copy
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.attribute_hints import KnownNames
from ..wrapper import column

CHILD_COUNT = 8
CHILD_OFFSETS = np.array([[k & 1, k >> 1 & 1, k >> 2] for k in range(CHILD_COUNT)])  # in halves of an edge
COLOR_TOLERANCE = 1e-12  # relative, as in Open3D


def made(kind: type[Any], **fields: Any) -> Any:
    """An object with the given fields. Faster than its constructor."""
    node = object.__new__(kind)
    vars(node).update(fields)
    return node


class OctreeNodeInfo(KnownNames):
    """Corner `origin`, edge length `size`, `depth` and `child_index` of a node, computed during a traversal."""

    origin: NDArray[np.float64]
    size: float
    depth: int
    child_index: int

    def __init__(self, origin: ArrayLike, size: float, depth: int, child_index: int):
        self.origin, self.size, self.depth, self.child_index = column("origin", origin), size, depth, child_index

    def children(self) -> list[OctreeNodeInfo]:
        """Positions of the 8 children."""
        half, depth = self.size / 2, self.depth + 1
        corners = self.origin + CHILD_OFFSETS * half
        return [
            made(OctreeNodeInfo, origin=corners[index], size=half, depth=depth, child_index=index)
            for index in range(CHILD_COUNT)
        ]

    def __repr__(self) -> str:
        return (
            f"OctreeNodeInfo with origin [{_listed(self.origin)}], size {self.size:g}, depth {self.depth}, "
            f"child_index {self.child_index}"
        )


class OctreeNode(KnownNames):
    """Base class of nodes."""

    def __init__(self, other: Self | None = None):
        self._clear()
        if other is not None:
            vars(self).update(vars(copy.deepcopy(other)))

    def _clear(self) -> None:
        """Set the fields of an empty node."""


class OctreeInternalNode(OctreeNode):
    """A node with 8 `children`, of which some are None."""

    children: list[Any]

    def _clear(self) -> None:
        self.children = [None] * CHILD_COUNT

    def __repr__(self) -> str:
        return f"OctreeInternalNode with {_count(self)} non-empty child nodes"


class OctreeInternalPointNode(OctreeInternalNode):
    """An internal node with the `indices` of the points below it."""

    indices: list[int]

    def _clear(self) -> None:
        self.children, self.indices = [None] * CHILD_COUNT, []

    def __repr__(self) -> str:
        return f"OctreeInternalPointNode with {_count(self)} non-empty child nodes and {len(self.indices)} points"


class OctreeLeafNode(OctreeNode):
    """Base class of leaves."""

    def clone(self) -> Self:
        return copy.deepcopy(self)

    def __repr__(self) -> str:
        return "OctreeLeafNode base class"


class OctreeColorLeafNode(OctreeLeafNode):
    """A leaf with a `color`."""

    def _clear(self) -> None:
        self._color = np.zeros(3)

    @property
    def color(self) -> NDArray[np.float64]:
        return self._color

    @color.setter
    def color(self, value: ArrayLike) -> None:
        self._color = column("color", value).astype(np.float64)

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and _same_color(self.color, other.color)

    __hash__ = OctreeLeafNode.__hash__

    def __repr__(self) -> str:
        return f"OctreeColorLeafNode with color [{_listed(self.color)}]"


class OctreePointColorLeafNode(OctreeLeafNode):
    """A leaf with a `color` and the `indices` of its points."""

    indices: list[int]
    color = OctreeColorLeafNode.color

    def _clear(self) -> None:
        self._color, self.indices = np.zeros(3), []

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self) or self.indices != other.indices:
            return False
        return _same_color(self.color, other.color)

    __hash__ = OctreeLeafNode.__hash__

    def __repr__(self) -> str:
        return f"OctreePointColorLeafNode with color [{_listed(self.color)}] containing {len(self.indices)} points."


def _same_color(color: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    return np.allclose(color, other, rtol=COLOR_TOLERANCE, atol=COLOR_TOLERANCE)


def _listed(values: NDArray[np.float64]) -> str:
    return ", ".join(f"{value:g}" for value in values)


def _count(node: OctreeInternalNode) -> int:
    return sum(child is not None for child in node.children)
