"""Level-of-detail tree of a cloud or a file of points: `DetailTree`."""

from __future__ import annotations

import dataclasses
import functools
import math
import os
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_indices, check_list, check_name, check_progress
from ...core.devices import DeviceLike, resolve_device
from ...core.progress import ReportProgress
from ...io.growing_columns import GrowingColumns
from ...io.points.in_parts import open_in_parts
from ...io.points.point_cloud import read_point_cloud
from ...kernels.arrays.bounds import bound_points
from ...kernels.lang import vec3
from ...kernels.memory import download, upload
from ...kernels.sampling.detail_levels import NODE_BITS, find_levels
from ...pcd.cloud import PointCloud
from ...pcd.detail_nodes import MAX_POINTS, NodeTable, make_nodes
from ...pcd.point_arrays import check_cloud
from ..render.view import View, check_view
from .detail_files import bytes_at, columns_of, no_attribute, sample_file
from .nodes_in_view import NodesInView, inward

Points = NDArray[np.float32]

_POINTS_PER_PART = 1 << 19  # points read at a time: about 50 MB while they are decoded
_READING_PERCENT = 50  # of the progress

_PROBES_PER_NODE = 64  # points per node that estimate its visible fraction

_SMALLEST_SIDE = 1e-30  # [m] of the cube: halving a smaller one would underflow float32


@dataclasses.dataclass(frozen=True, eq=False)
class Node:
    """Points of a node: float32 (k, 3) relative to the center of its cube [m], with their indices and colors."""

    positions: Points
    middle: NDArray[np.float64]
    half: float
    indices: NDArray[np.int64]
    colors: NDArray[np.uint8] | None


class DetailTree(NodesInView):
    """Points in nodes from coarse to fine. Each finite point is in one node. Deeper nodes add points.

    No two points of the nodes down to level L share a voxel of size side / 2^L / 128, except for the few points of
    missing deeper nodes, which join their parent.

    Attributes:
        origin: Origin of the float32 positions [m], float64 (3,).
        count: Number of points in nodes.
        low, high: Bounds of the points [m], float64 (3,). Zero for an empty cloud.
        spacings: Voxel size of each node's level [m], float64 (m,).
        counts: Number of points of each node, int64 (m,).
        middles, halves: Center and half side of each node's bounding cube [m], float64 (m, 3) and (m,).
        attributes: Additional values of the points of a file by name, in file order.

    Notes:
        The nodes are identical from run to run and on every device. Memory: 4 B per point beside a cloud. 16 B per
        point of a file plus 3 B for colors. 20 B more during construction.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> cloud = loom.PointCloud(np.random.default_rng(0).random((20_000, 3)) * (1, 1, 0))
        >>> tree = loom.DetailTree.from_cloud(cloud)
        >>> tree.count, sum(len(tree.node(i).indices) for i in range(len(tree)))
        (20000, 20000)
        >>> view = loom.View.fit(cloud.points, width=64, height=48)
        >>> nodes = tree.select(view, budget=15_000)
        >>> nodes[0], int(tree.counts[nodes].sum()) <= 15_000
        (0, True)
    """

    def __init__(
        self,
        positions: Any,
        origin: NDArray[np.float64],
        colors: Callable[[NDArray[np.int64]], NDArray[np.uint8]] | None,
        attributes: dict[str, NDArray[Any]] | None = None,
    ):
        """Use `from_cloud` or `from_file` instead. Positions are vec3 on a device."""
        self.origin, self._colors = np.asarray(origin, np.float64), colors
        self.attributes: dict[str, NDArray[Any]] = attributes or {}
        low, high, count = bound_points(positions)
        self._corner, self._side = _cube(low, high) if count else (np.zeros(3), 1.0)
        self.low, self.high = (ends.astype(np.float64) + self.origin if count else np.zeros(3) for ends in (low, high))
        table = make_nodes(*find_levels(positions, self._corner, self._side), max_points=MAX_POINTS)
        self._positions: Points = download(positions).reshape(-1, 3)
        self.count = len(table.order)
        self._locate_nodes(table)

    def _locate_nodes(self, table: NodeTable) -> None:
        self._order, self._firsts, self.counts = table.order, table.firsts, table.counts
        corner = self._corner + self.origin
        sides = self._side / 2.0 ** table.depths.astype(np.float64)
        self.halves, self.middles = sides / 2, corner + (table.cells + 0.5) * sides[:, None]
        self.levels, self._names = table.levels, table.names
        self.spacings = self._side / 2.0 ** (table.levels.astype(np.float64) + NODE_BITS)
        # The complete cell of the level, shared by its parts: a child never counts as nearer than its parent.
        widths = self._side / 2.0 ** table.levels.astype(np.float64)
        cells = table.cells >> (table.depths - table.levels).astype(np.int64)[:, None]
        self._level_halves, self._level_middles = widths / 2, corner + (cells + 0.5) * widths[:, None]

    @classmethod
    def from_cloud(cls, cloud: PointCloud) -> DetailTree:
        """Build the tree of a cloud on its device. The arrays are shared. Raises `TypeError` for other types."""
        check_cloud("cloud", cloud)
        colors: Any = None
        if cloud.has_colors:
            colors = functools.partial(bytes_at, download(cloud.arrays["colors"]))
        return cls(cloud.arrays["points"], cloud.origin, colors)

    @staticmethod
    def sample(path: str | os.PathLike[str], count: int) -> PointCloud | None:
        """Read an even sample of a file, to show while its tree is built.

        Args:
            path: The file.
            count: Maximum number of points, at least 1.

        Returns:
            The cloud. None if the format can only be read completely.

        Raises:
            FileError, TypeError, ValueError: The file cannot be read, or `count` is not an integer >= 1.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> loom.write_point_cloud("scan.ply", loom.PointCloud(np.random.default_rng(0).random((1000, 3))))
            >>> loom.DetailTree.sample("scan.ply", 10)
            PointCloud(10 points, no attributes, cpu)
        """
        return sample_file(path, count)

    @classmethod
    def from_file(
        cls,
        path: str | os.PathLike[str],
        *,
        attributes: Sequence[str] = (),
        device: DeviceLike = None,
        progress: ReportProgress | None = None,
    ) -> DetailTree:
        """Build the tree of a file. Binary PLY and PCD, LAS and LAZ are read in parts, other formats at once.

        Args:
            path: A file that `read_point_cloud` reads.
            attributes: Names of additional values to keep.
            device: Device for the construction. The tree is stored in host memory.
            progress: Called with "reading", the progress in percent, and 100.

        Raises:
            FileError: The file cannot be read, or an attribute is missing.
            TypeError, DeviceError: `attributes` is not a list of names, or the device is unknown.

        Notes:
            Peak memory: 40 B per point, 19 B afterward, plus attributes.
        """
        where, report_progress = resolve_device(device), check_progress(progress)
        attributes = [
            check_name(f"attributes[{k}]", name) for k, name in enumerate(check_list("attributes", attributes, "names"))
        ]
        report_progress("reading", 0, 100)
        file = open_in_parts(path)
        if file is None:
            cloud = read_point_cloud(path, device=where)
            missing = [name for name in attributes if name not in cloud.attributes]
            if missing:
                raise no_attribute(path, missing[0], list(cloud.attributes))
            report_progress("reading", _READING_PERCENT, 100)
            tree = cls.from_cloud(cloud)
            tree.attributes = {name: cloud[name] for name in attributes}
        else:
            columns, origin, done = GrowingColumns(file.count, is_proven=file.is_proven), file.origin(), 0
            for part in file.parts(_POINTS_PER_PART):
                columns.append(columns_of(path, part, origin, attributes))
                done += len(part.points)
                report_progress("reading", round(_READING_PERCENT * done / max(file.count, 1)), 100)
            arrays = columns.finish()
            colors = arrays.pop("colors", None)
            positions = upload(arrays.pop("positions"), vec3, where, copied=False)
            point_attributes = {name[1:]: values for name, values in arrays.items()}
            tree = cls(positions, origin, None if colors is None else colors.__getitem__, point_attributes)
        report_progress("reading", 100, 100)
        return tree

    @property
    def positions(self) -> Points:
        """All points in index order relative to `origin` [m], float32 (n, 3), including non-finite ones. Not copied."""
        return self._positions

    def points_of(self, i: int) -> NDArray[np.float64]:
        """World coordinates of the points of node `i` [m], float64 (k, 3). Order and errors as in `indices_of`."""
        return self._positions[self._rows_of(i)] + self.origin

    def indices_of(self, i: int) -> NDArray[np.int64]:
        """Indices of the points of node `i` in the cloud or file, int64 (k,).

        Raises:
            TypeError, ValueError, IndexError: Not an integer, negative, or no such node.
        """
        return self._rows_of(i).astype(np.int64)

    def colors_of(self, indices: NDArray[np.int64]) -> NDArray[np.uint8] | None:
        """Colors of points by index, uint8 (k, 3). None if the cloud has no colors.

        Raises:
            TypeError, IndexError: Not integers, or an index is out of range.
        """
        rows = check_indices("indices", indices, len(self._positions), of=f"tree of {len(self._positions)} points")
        return None if self._colors is None else self._colors(rows)

    def node(self, i: int) -> Node:
        """Points of node `i` relative to its center. Errors as in `indices_of`."""
        indices = self.indices_of(i)
        shift = self.origin - self.middles[i]
        positions = (self._positions[indices] + shift).astype(np.float32)
        return Node(positions, self.middles[i], float(self.halves[i]), indices, self.colors_of(indices))

    def _rows_of(self, i: int) -> NDArray[np.int32]:
        if check_count("i", i, minimum=0) >= len(self):
            raise IndexError(f"i: there is no node {i}: expected 0..{len(self) - 1}")
        first = int(self._firsts[i])
        return self._order[first : first + int(self.counts[i])]

    def fractions_in_view(self, view: View, nodes: Sequence[int]) -> NDArray[np.float64]:
        """Fraction of the points of each node inside a view, 0 to 1, estimated from a few points; float64 (k,).

        Args:
            view: View in world coordinates.
            nodes: Node indices, for example of `select`.

        Raises:
            TypeError, IndexError: Not a View, not integers, or no such node.
        """
        check_view(view)
        rows = self._check_nodes(nodes)
        normals, eye = inward(view), view.T_world_camera[:3, 3] - self.origin
        steps = np.arange(_PROBES_PER_NODE) / _PROBES_PER_NODE
        samples = self._firsts[rows, None] + (self.counts[rows, None] * steps).astype(np.int64)
        heights = (self._positions[self._order[samples]] - eye) @ normals.T
        return (heights >= 0).all(axis=2).mean(axis=1)


def _cube(low: NDArray[np.float32], high: NDArray[np.float32]) -> tuple[NDArray[np.float64], float]:
    """Corner and side of a cube around a box. The side is a power of 2, so that cells are exact."""
    corner = low.astype(np.float64)
    extent = max(float((high - corner).max()), _SMALLEST_SIDE)
    return corner, 2.0 ** math.ceil(math.log2(extent))
