"""The octree of a COPC file as levels of detail, read on demand: `CopcTree`."""

from __future__ import annotations

import logging
import os
import threading
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_indices
from ...core.coordinates import choose_origin
from ...core.errors import FileError
from ...io.points.copc_nodes import CACHE_BYTES, CopcNodes
from ...io.table import PointTable
from ...pcd.cloud import PointCloud
from ..render.view import View
from .detail_files import to_bytes
from .detail_tree import Node
from .nodes_in_view import NodesInView, inward

log = logging.getLogger("pointloom.viewer")

FIRST_POINTS = 250_000  # of the levels read at once, unless the coarsest has more
_MAX_LEVEL = 20  # maximum level whose cell numbers fit into 63 bits
_PROBES_PER_SIDE = 4  # samples along each side of a cell that estimate its visible fraction


class CopcTree(NodesInView):
    """Nodes of a COPC file, with the interface of a DetailTree for `CloudStream`. Raises FileError.

    The coarse levels are read at once into the `head` (at most `first` points, or the coarsest level), whose points
    have the first indices. Other nodes are read on demand and cached in `memory` bytes. A damaged node causes one
    warning and then has no points.

    Attributes:
        nodes: Reader of the file.
        head: Points of the coarse levels with all attributes.
        origin: Origin of positions [m], float64 (3,).
        count: Number of points in nodes.
        low, high: Bounds of the non-empty octree nodes [m], float64 (3,).
        lost: Errors of unreadable nodes of the coarse levels, which are not in the tree.
        damaged: Errors of other unreadable nodes, by node.
    """

    is_in_parts = True

    def __init__(self, path: str | os.PathLike[str], *, memory: int = CACHE_BYTES, first: int = FIRST_POINTS):
        first = check_count("first", first)
        self.nodes = CopcNodes(path, memory=memory)
        self.damaged: dict[int, FileError] = {}
        self._last: tuple[int, PointTable] | None = None
        self._lock = threading.Lock()
        octree = self.nodes.octree
        self._rows = np.arange(len(octree.nodes))  # index of each node in the file's octree
        self._full = 65535
        self._locate_nodes()
        head, end = self._read_head(first)
        self.lost, self.damaged = list(self.damaged.values()), {}
        if not head:
            raise (
                self.lost[0]
                if self.lost
                else FileError(path, "has an octree without points", remedy="Read the complete file")
            )
        self._rows = np.concatenate([head, np.arange(end, len(self))]).astype(np.int64)
        self._full, self._last, heads = self.nodes.full_of(np.array(head)), None, len(head)
        self._locate_nodes()
        tables = [self._table(i) for i in range(heads)]
        points = np.concatenate([table.points for table in tables])
        steps = np.array(octree.file.header.scales, np.float64)
        self.origin: NDArray[np.float64] = choose_origin(points, steps)
        self.head = self._cloud(_joined(tables))

    def _read_head(self, first: int) -> tuple[list[int], int]:
        """Read the coarse levels. Returns the readable nodes and the number of nodes."""
        readable: list[int] = []
        points = end = 0
        for level in np.unique(self.levels).tolist():
            of_level = np.flatnonzero(self.levels == level)
            if readable and points + int(self.counts[of_level].sum()) > first:
                break
            for k in of_level.tolist():
                try:
                    self._checked(k)
                except FileError as error:
                    log.warning("%s; the other points are shown", error)
                    self.damaged[k] = error
                    continue
                readable.append(k)
                points += int(self.counts[k])
            end = int(of_level[-1]) + 1
        return readable, end

    def _locate_nodes(self) -> None:
        octree, entries = self.nodes.octree, self.nodes.octree.nodes[self._rows]
        levels, cells = entries["level"].astype(np.int64), entries["cell"].astype(np.int64)
        widths = octree.side / 2.0**levels
        self.levels, self.counts = levels, entries["count"].astype(np.int64)
        self.halves, self.middles = widths / 2, octree.corner + (cells + 0.5) * widths[:, None]
        self._level_halves, self._level_middles = self.halves, self.middles
        self.spacings = np.asarray(octree.spacing / 2.0**levels, np.float64)
        self._names = _names(levels, cells)
        self._firsts = np.cumsum(self.counts) - self.counts
        self.count = int(self.counts.sum())
        self.low = (self.middles - self.halves[:, None]).min(axis=0)
        self.high = (self.middles + self.halves[:, None]).max(axis=0)

    @property
    def has_colors(self) -> bool:
        return bool(self.head.has_colors)

    def points_of(self, i: int) -> NDArray[np.float64]:
        """World coordinates of a node's points [m], float64 (k, 3). Empty if damaged."""
        return self._table(i).points

    def indices_of(self, i: int) -> NDArray[np.int64]:
        """Indices of a node's points, int64 (k,). Empty if damaged."""
        count = len(self._table(i).points)
        return np.arange(count) + int(self._firsts[i])

    def node(self, i: int) -> Node:
        """Points of a node relative to its center. Empty if damaged."""
        table = self._table(i)
        middle, half = self.middles[i], float(self.halves[i])
        positions = (table.points - middle).astype(np.float32)
        colors = None if table.colors is None else to_bytes(table.colors)
        return Node(positions, middle, half, self.indices_of(i), colors)

    def colors_of(self, indices: ArrayLike) -> NDArray[np.uint8] | None:
        """Colors of points in the file, uint8 (k, 3), or None."""
        if not self.has_colors:
            return None
        return self.paint(indices, lambda cloud: np.asarray(to_bytes(np.asarray(cloud.colors))))

    def paint(self, indices: ArrayLike, paint: Callable[[PointCloud], NDArray[Any]]) -> NDArray[Any]:
        """Apply `paint` (cloud to rows) to the nodes of points, whose indices (k,) are grouped by node."""
        indices = np.asarray(indices, np.int64)
        if not len(indices):
            return paint(self.cloud_at(indices))
        ends = np.flatnonzero(np.diff(self._nodes_at(indices))) + 1
        return np.concatenate([paint(self.cloud_at(some)) for some in np.split(indices, ends)])

    def cloud_at(self, indices: NDArray[np.int64]) -> PointCloud:
        if not len(indices):
            return self.head.select_by_index(indices)
        i = int(self._nodes_at(indices[:1])[0])
        table, rows = self._table(i), indices - self._firsts[i]
        every = len(rows) == len(table.points) and bool((rows == np.arange(len(rows))).all())
        return self._cloud(table if every else _rows_of(table, rows))

    def fractions_in_view(self, view: View, nodes: Sequence[int]) -> NDArray[np.float64]:
        """Fraction of each node's cube inside a view, 0 to 1, from sample positions; float64 (k,)."""
        rows = self._check_nodes(nodes)
        steps = (np.arange(_PROBES_PER_SIDE) + 0.5) / _PROBES_PER_SIDE * 2 - 1
        grid = np.stack(np.meshgrid(steps, steps, steps), axis=-1).reshape(-1, 3)
        positions = self.middles[rows, None] + grid * self.halves[rows, None, None]
        heights = (positions - view.T_world_camera[:3, 3]) @ inward(view).T
        return (heights >= 0).all(axis=2).mean(axis=1)

    def _nodes_at(self, indices: NDArray[np.int64]) -> NDArray[np.int64]:
        check_indices("indices", indices, self.count, of=f"tree of {self.count} points")
        return np.searchsorted(self._firsts, indices, side="right") - 1

    def _table(self, i: int) -> PointTable:
        if check_count("i", i, minimum=0) >= len(self):
            raise IndexError(f"i: there is no node {i}: expected 0..{len(self) - 1}")
        with self._lock:
            if self._last is not None and self._last[0] == i:
                return self._last[1]
            is_damaged = i in self.damaged
        try:
            table = self._empty() if is_damaged else self._checked(i)
        except FileError as error:
            with self._lock:
                is_new = self.damaged.setdefault(i, error) is error
            if is_new:
                log.warning("%s; the other points are shown", error)
            table = self._empty()
        with self._lock:
            self._last = i, table
        return table

    def _checked(self, i: int) -> PointTable:
        table = self.nodes.table(int(self._rows[i]), self._full)
        slack = self.halves[i] * 1e-6 + 2 * float(np.max(self.nodes.octree.file.header.scales))
        off = np.abs(table.points - self.middles[i]).max(initial=0.0)
        if not off <= self.halves[i] + slack:
            raise FileError(self.nodes.path, f"{self.nodes.name_of(int(self._rows[i]))}, has points outside its cube")
        return table

    def _empty(self) -> PointTable:
        colors = np.empty((0, 3), np.float32) if "red" in (self.nodes.row.names or ()) else None
        return PointTable(np.empty((0, 3)), None, colors, {})

    def _cloud(self, table: PointTable) -> PointCloud:
        how: dict[str, Any] = {"device": "cpu", "origin": self.origin, "unit": self.nodes.unit}
        cloud = PointCloud(table.points, normals=table.normals, colors=table.colors, **how)
        for name, values in table.attributes.items():
            cloud[name] = values
        return cloud


def _rows_of(table: PointTable, rows: NDArray[np.int64]) -> PointTable:
    normals, colors = (None if one is None else one[rows] for one in (table.normals, table.colors))
    return PointTable(table.points[rows], normals, colors, {name: v[rows] for name, v in table.attributes.items()})


def _joined(tables: list[PointTable]) -> PointTable:
    first = tables[0]
    normals = None if first.normals is None else np.concatenate([one.normals for one in tables])  # type: ignore[misc]
    colors = None if first.colors is None else np.concatenate([one.colors for one in tables])  # type: ignore[misc]
    attributes = {name: np.concatenate([one.attributes[name] for one in tables]) for name in first.attributes}
    return PointTable(np.concatenate([one.points for one in tables]), normals, colors, attributes)


def _names(levels: NDArray[np.int64], cells: NDArray[np.int64]) -> NDArray[np.int64]:
    """A number for each cell; that of its parent is an eighth of it. 0 for cells that are too deep."""
    names = np.ones(len(levels), np.int64)
    for bit in range(int(min(levels.max(initial=0), _MAX_LEVEL)) - 1, -1, -1):
        deeper = levels > bit
        bits = (cells >> bit) & 1
        octant = bits[:, 0] << 2 | bits[:, 1] << 1 | bits[:, 2]
        names = np.where(deeper, names << 3 | octant, names)
    return np.where(levels > _MAX_LEVEL, 0, names)
