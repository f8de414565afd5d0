"""Nodes of a multi-resolution tree over points with known levels (kernels/sampling/detail_levels.py).

A node contains a cell's points of one level. Few deeper points are merged into it. Too many are split.
"""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..kernels.sampling.detail_levels import LEVEL_COUNT, MAX_DEPTH

# Deeper points merged into their parent: this many, or a quarter of its own. An unmerged cell beside it is then at most
# a quarter thinner, which is not visible. Smaller nodes cost more to address than to send.
MIN_POINTS = 2048
CHILD_FRACTION = 4

MAX_POINTS = 49_152  # points of a node: half a megabyte, under a second on a slow connection

_KEY_BITS = 3 * MAX_DEPTH


@dataclasses.dataclass(frozen=True, eq=False)
class NodeTable:
    """Nodes sorted by level, then Morton order. `levels` uint8 (k,): a node of level L has 128 voxels of side / 2^L /
    128 per axis. `firsts`, `counts` int64 (k,): range in `order`. `depths` uint8 (k,), `cells` int64 (k, 3): octree
    cell of the points. `names` int64 (k,): cell of the level as a one followed by three bits per halving. The parent is
    `name >> 3`. `order` int32 (n,): points."""

    levels: NDArray[np.uint8]
    firsts: NDArray[np.int64]
    counts: NDArray[np.int64]
    depths: NDArray[np.uint8]
    cells: NDArray[np.int64]
    names: NDArray[np.int64]
    order: NDArray[np.int32]


class _Rows:
    """Rows of points in Morton order, by level."""

    def __init__(self, levels: NDArray[np.uint8]):
        self.ends = np.cumsum(np.bincount(levels, minlength=LEVEL_COUNT)).tolist()
        self.indices = np.empty(len(levels), np.int32)
        for level in range(LEVEL_COUNT):
            self.indices[self.begin(level) : self.ends[level]] = np.flatnonzero(levels == level)

    def begin(self, level: int) -> int:
        return self.ends[level - 1] if level else 0

    def count_before(self, level: int, indices: NDArray[np.int64]) -> NDArray[np.int64]:
        """Number of rows of a level or above, before given rows."""
        part = self.indices[self.begin(level) : self.ends[level]]
        return np.searchsorted(part, indices.astype(np.int32)) + self.begin(level)


@dataclasses.dataclass
class _Node:
    level: int
    code: int
    depth: int
    runs: list[tuple[int, int]]  # in _Rows.places

    @property
    def count(self) -> int:
        return sum(end - begin for begin, end in self.runs)


def make_nodes(
    keys: NDArray[np.int64],
    order: NDArray[np.int32],
    levels: NDArray[np.uint8],
    *,
    max_points: int,
    min_points: int = MIN_POINTS,
    depth: int = 0,
) -> NodeTable:
    """Build nodes from ascending Morton keys. 8 B per point. Nodes of more than `max_points` are split. Up to
    `min_points` deeper points are merged into their parent. `depth` is the number of halvings to the common cell.
    Points of coarser levels are omitted."""
    rows = _Rows(levels)
    nodes: list[_Node] = []
    codes = keys[:1] >> (_KEY_BITS - 3 * depth)
    begins, ends = np.zeros(1, np.int64), np.full(1, len(keys), np.int64)
    for level in range(depth, LEVEL_COUNT if len(keys) else 0):
        bounds = [(rows.count_before(j, begins), rows.count_before(j, ends)) for j in range(LEVEL_COUNT)]
        counts = np.stack([last - first for first, last in bounds])
        level_counts, deeper = counts[level], counts[level + 1 :].sum(axis=0)
        closed = deeper <= np.maximum(min_points, level_counts // CHILD_FRACTION)
        for k in np.flatnonzero((level_counts > 0) | closed).tolist():
            span = bounds[level:] if closed[k] else bounds[level : level + 1]
            runs = [(int(first[k]), int(last[k])) for first, last in span if last[k] > first[k]]
            if runs:
                nodes += _parts(_Node(level, int(codes[k]), level, runs), keys, rows, max_points)
        codes = (codes[~closed, None] * 8 + np.arange(8)).ravel()
        begins, ends = _runs_of(keys, codes, level + 1)
        codes, begins, ends = codes[ends > begins], begins[ends > begins], ends[ends > begins]
    return _table(nodes, order, rows)


def _runs_of(keys: NDArray[np.int64], codes: NDArray[Any], depth: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Row ranges of cells in Morton order."""
    shift = _KEY_BITS - 3 * depth
    lows = np.asarray(codes, np.int64) << shift
    return np.searchsorted(keys, lows), np.searchsorted(keys, lows | ((1 << shift) - 1), side="right")


def _parts(node: _Node, keys: NDArray[np.int64], rows: _Rows, max_points: int) -> list[_Node]:
    """Split a node that is too large, by octants, or by count if its points coincide."""
    if node.count <= max_points:
        return [node]
    if node.depth == MAX_DEPTH:
        cuts = [(at, min(at + max_points, end)) for begin, end in node.runs for at in range(begin, end, max_points)]
        return [dataclasses.replace(node, runs=[cut]) for cut in cuts]
    codes = node.code * 8 + np.arange(8)
    begins, ends = _runs_of(keys, codes, node.depth + 1)
    edges = np.append(begins, ends[-1:])
    cuts = [first + np.searchsorted(rows.indices[first:last], edges.astype(np.int32)) for first, last in node.runs]
    parts = []
    for k, code in enumerate(codes.tolist()):
        runs = [(int(cut[k]), int(cut[k + 1])) for cut in cuts if cut[k + 1] > cut[k]]
        if runs:
            parts += _parts(_Node(node.level, code, node.depth + 1, runs), keys, rows, max_points)
    return parts


def _table(nodes: list[_Node], order: NDArray[np.int32], rows: _Rows) -> NodeTable:
    counts = np.array([node.count for node in nodes], np.int64)
    firsts = np.cumsum(counts) - counts
    by_node = np.empty(int(counts.sum()), np.int32)
    at = 0
    for node in nodes:
        for begin, end in node.runs:
            by_node[at : at + end - begin] = order[rows.indices[begin:end]]
            at += end - begin
    codes = np.array([node.code for node in nodes], np.int64)
    levels, depths = (np.array([getattr(node, name) for node in nodes], np.uint8) for name in ("level", "depth"))
    ones = np.int64(1) << (3 * levels.astype(np.int64))
    names = ones | (codes >> (3 * (depths - levels).astype(np.int64)))
    return NodeTable(levels, firsts, counts, depths, cells_of(codes), names, by_node)


def cells_of(codes: NDArray[np.int64]) -> NDArray[np.int64]:
    """Cell coordinates of Morton codes, (k, 3)."""
    return np.stack([_gather_bits(codes >> axis) for axis in (2, 1, 0)], axis=-1).reshape(-1, 3)


def _gather_bits(codes: NDArray[np.int64]) -> NDArray[np.int64]:
    """Compact every third bit."""
    out = np.zeros_like(codes)
    for bit in range(MAX_DEPTH):
        out |= ((codes >> (3 * bit)) & 1) << bit
    return out
