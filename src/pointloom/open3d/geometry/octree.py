"""Octree, a structure of Python nodes as in Open3D."""

from __future__ import annotations

import copy
import itertools
from collections.abc import Callable, Iterator
from typing import Any, NoReturn, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_number, check_positive
from ...kernels.language.lazy_property import without_collections
from ..argument_types import CloudLike
from ..wrapper import PlainWrapper, column, unwrap
from .boxes import AxisAlignedBoundingBox, OrientedBoundingBox
from .geometry import Geometry3D
from .octree_nodes import (
    CHILD_COUNT,
    OctreeColorLeafNode,
    OctreeInternalNode,
    OctreeInternalPointNode,
    OctreeNodeInfo,
    OctreePointColorLeafNode,
    made,
)
from .point_cloud import PointCloud
from .voxel_grid import VoxelGrid

Rows = NDArray[np.intp]


class Octree(PlainWrapper, Geometry3D):
    """A cube `size` wide from `origin`, halved `max_depth` times. It contains points with origin <= p < origin + size.

    `root_node` is None before the first point.
    """

    max_depth: int
    size: float
    root_node: Any

    def __init__(self, max_depth: object = 0, origin: ArrayLike = (0.0, 0.0, 0.0), size: float = 0.0):
        self._shared = {}
        if isinstance(max_depth, Octree):
            vars(self).update(vars(max_depth.__copy__()))
            return
        self.max_depth = check_count("max_depth", max_depth, minimum=0)
        self.origin, self.size = column("origin", origin), check_positive("size", size, allow_zero=True)
        self.root_node = None

    @property
    def origin(self) -> NDArray[np.float64]:
        return self._origin

    @origin.setter
    def origin(self, value: ArrayLike) -> None:
        self._origin = column("origin", value).astype(np.float64)

    @property
    def native(self) -> Any:
        """The leaves as a `loom.VoxelGrid`, for drawing."""
        return self.to_voxel_grid().native

    def convert_from_point_cloud(self, point_cloud: CloudLike, size_expand: float = 0.01) -> None:
        """Replace the nodes by those of a cloud. The cube around it is enlarged by the fraction `size_expand` (0..1).

        A leaf has the color of its last point. Non-finite points are ignored.
        """
        expand = check_number("size_expand", size_expand)
        if not 0 <= expand <= 1:
            raise ValueError(f"size_expand: expected a number in 0..1, got {expand:g}")
        ours = unwrap(point_cloud, PointCloud, "point_cloud")
        points = np.array(point_cloud.points if isinstance(point_cloud, PointCloud) else ours.points)
        self.clear()
        finite = points[np.isfinite(points).all(axis=1)]
        if not len(finite):
            return
        low, high = finite.min(axis=0), finite.max(axis=0)
        half = ((low + high) / 2 - low).max()
        self.origin = np.minimum(low, (low + high) / 2 - half)
        self.size = float(half * 2 * (1 + expand)) if half > 0 else expand
        colors = ours.colors.astype(np.float64) if ours.has_colors else np.zeros((len(points), 3))

        def leaf_of(rows: Rows) -> Any:
            return made(OctreePointColorLeafNode, _color=colors[rows[-1]], indices=rows.tolist())

        def internal_of(rows: Rows) -> Any:
            return made(OctreeInternalPointNode, children=[None] * CHILD_COUNT, indices=sorted(rows.tolist()))

        self._fill(points, leaf_of, internal_of)

    def _fill(
        self, points: NDArray[np.float64], leaf_of: Callable[[Rows], Any], internal_of: Callable[[Rows], Any]
    ) -> None:
        """Replace the nodes by those of points. Both functions make a node of the points `rows`."""
        rows = np.flatnonzero(((self.origin <= points) & (points < self.origin + self.size)).all(axis=1))
        children = self._children_of(points[rows])
        order = np.lexsort(children.T[::-1]) if self.max_depth else np.arange(len(rows))
        with without_collections():  # two thirds of the time while a large tree grows
            self.root_node = _grow(rows[order], children[order], 0, leaf_of, internal_of) if len(rows) else None

    def _children_of(self, points: NDArray[np.float64]) -> NDArray[np.int8]:
        """Index of the child that contains a point at each depth, shape (n, max_depth)."""
        corners, half = np.tile(self.origin, (len(points), 1)), self.size / 2
        children = np.empty((len(points), self.max_depth), np.int8)
        for depth in range(self.max_depth):
            upper = points >= corners + half
            corners += upper * half
            children[:, depth] = upper @ np.array([1, 2, 4])
            half /= 2
        return children

    def _path(self, point: NDArray[np.float64]) -> Iterator[tuple[int, list[float], float]]:
        """Index, corner and size of the children that contain a point, without end."""
        values, corner, size = point.tolist(), self.origin.tolist(), self.size
        while True:
            index, size = 0, size / 2
            for axis in range(3):
                if values[axis] >= corner[axis] + size:
                    corner[axis] += size
                    index += 1 << axis
            yield index, corner, size

    def traverse(self, f: Callable[[Any, OctreeNodeInfo], Any]) -> None:
        """Call `f(node, node_info)` from the root on, depth first. If it returns True, children are skipped."""
        pending = [(self.root_node, OctreeNodeInfo(self.origin, self.size, 0, 0))] if self.root_node is not None else []
        while pending:
            node, info = pending.pop()
            if not f(node, info) and isinstance(node, OctreeInternalNode):
                pairs = zip(node.children, info.children(), strict=True)
                pending += [pair for pair in pairs if pair[0] is not None][::-1]

    def locate_leaf_node(self, point: ArrayLike) -> tuple[Any, OctreeNodeInfo | None]:
        """Leaf that contains a point, and its position. (None, None) without one."""
        place, node = column("point", point), self.root_node
        if node is None or not self.is_point_in_bound(place, self.origin, self.size):
            return None, None
        info = OctreeNodeInfo(self.origin, self.size, 0, 0)
        for index, corner, size in self._path(place):
            if not isinstance(node, OctreeInternalNode):
                break
            node, info = node.children[index], OctreeNodeInfo(corner, size, info.depth + 1, index)
        return (None, None) if node is None else (node, info)

    @staticmethod
    def is_point_in_bound(point: ArrayLike, origin: ArrayLike, size: float) -> bool:
        p, low = column("point", point), column("origin", origin)
        return bool((low <= p).all() and (p < low + size).all())

    def to_voxel_grid(self) -> VoxelGrid:
        """The leaves as voxels."""
        leaves: list[tuple[Any, int, int, int, int]] = []  # node, cell and depth
        pending = [(self.root_node, 0, 0, 0, 0)]
        while pending:
            node, x, y, z, depth = pending.pop()
            if isinstance(node, OctreeInternalNode):
                for k, child in enumerate(node.children):
                    if child is not None:
                        pending.append((child, 2 * x + (k & 1), 2 * y + (k >> 1 & 1), 2 * z + (k >> 2), depth + 1))
            elif node is not None:
                leaves.append((node, x, y, z, depth))
        if not leaves:
            return VoxelGrid()
        deepest = max(leaf[4] for leaf in leaves)
        cells = np.array([[(2 * i + 1 << deepest - leaf[4]) >> 1 for i in leaf[1:4]] for leaf in leaves], np.int32)
        order = np.lexsort(cells.T[::-1])
        colors = np.array([getattr(leaf[0], "color", np.zeros(3)) for leaf in leaves], np.float64)
        return VoxelGrid.from_cells(self.origin, self.size / 2**deepest, cells[order], colors[order])

    def create_from_voxel_grid(self, voxel_grid: object) -> None:
        """Insert the voxels of a grid as colored leaves, in a cube from the origin of the grid."""
        if not isinstance(voxel_grid, VoxelGrid):
            raise TypeError(f"voxel_grid: expected a VoxelGrid, got {type(voxel_grid).__name__}")
        self.origin = voxel_grid.origin
        self.size = float((voxel_grid.get_max_bound() - voxel_grid.origin).max())
        cells, colors = voxel_grid.cells_and_colors()
        centers = voxel_grid.origin + (cells + 0.5) * voxel_grid.voxel_size
        self._fill(
            centers,
            lambda rows: made(OctreeColorLeafNode, _color=colors[rows[-1]]),
            lambda rows: made(OctreeInternalNode, children=[None] * CHILD_COUNT),
        )

    def clear(self) -> Self:
        """Remove all nodes and set `origin` and `size` to zero."""
        self.root_node, self.origin, self.size = None, (0, 0, 0), 0.0
        return self

    def is_empty(self) -> bool:
        return self.root_node is None

    def get_min_bound(self) -> NDArray[np.float64]:
        return np.zeros(3) if self.is_empty() else self.origin.copy()

    def get_max_bound(self) -> NDArray[np.float64]:
        return np.zeros(3) if self.is_empty() else self.origin + self.size

    def get_center(self) -> NDArray[np.float64]:
        return self.origin + self.size / 2

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        return AxisAlignedBoundingBox(self.get_min_bound(), self.get_max_bound())

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        return OrientedBoundingBox.create_from_axis_aligned_bounding_box(self.get_axis_aligned_bounding_box())

    get_minimal_oriented_bounding_box = get_oriented_bounding_box

    def _reject_motion(self, *args: Any, **kwargs: Any) -> NoReturn:
        """Always raises RuntimeError, as in Open3D."""
        raise RuntimeError("Octree: cannot be moved; move the cloud, then call octree.convert_from_point_cloud(cloud)")

    transform = translate = scale = rotate = _reject_motion

    def __copy__(self) -> Self:
        other = type(self)(self.max_depth, self.origin, self.size)
        other.root_node = copy.deepcopy(self.root_node)
        return other

    def __repr__(self) -> str:
        corner = ", ".join(f"{value:g}" for value in self.origin)
        return f"Octree with origin: [{corner}], size: {self.size:g}, max_depth: {self.max_depth}"


def _grow(
    rows: Rows,
    children: NDArray[np.int8],
    depth: int,
    leaf_of: Callable[[Rows], Any],
    internal_of: Callable[[Rows], Any],
) -> Any:
    """Node of the points `rows`, sorted by their child indices at all depths, then by row."""
    if depth == children.shape[1]:
        return leaf_of(rows)
    node = internal_of(rows)
    if len(rows) == 1:
        node.children[children[0, depth]] = _grow(rows, children, depth + 1, leaf_of, internal_of)
        return node
    ends = np.searchsorted(children[:, depth], np.arange(CHILD_COUNT + 1)).tolist()
    for index, (begin, end) in enumerate(itertools.pairwise(ends)):
        if end > begin:
            node.children[index] = _grow(rows[begin:end], children[begin:end], depth + 1, leaf_of, internal_of)
    return node
