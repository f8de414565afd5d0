"""Nodes of a multi-resolution tree over points whose levels are known (kernels/sampling/detail_levels.py).

A node is a cell of a level with the points of that level in it. Where few deeper points are left in a cell, they join
its node and nothing lies below it; where a node has more points than one message should carry, it is cut along the next
halvings into parts of the same level. So there are neither thousands of nodes of three points nor one of millions.
"""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..kernels.sampling.detail_levels import DEPTH, LEVELS

# Deeper points that join the node above: so many, or a quarter of its own. A cell beside it that is not joined is then
# at most a quarter thinner, which is not seen; a node of fewer points than this costs more to name than to send.
LEAST = 2048
SHARE = 4

MOST = 49_152  # points of a node: half a megabyte, less than a second of a slow line

_KEY_BITS = 3 * DEPTH


@dataclasses.dataclass(frozen=True, eq=False)
class NodeTable:
    """The nodes, coarse levels first, along the Morton order within a level.

    Attributes:
        levels: uint8 [k]; a node of level L has 128 voxels of side / 2^L / 128 along an axis.
        firsts, counts: int64 [k], where the points of each are in `order`, and how many.
        depths: uint8 [k], halvings of the cube to the cell that holds the node's points; its level, or more of a part.
        cells: int64 [k, 3], that cell along each axis.
        names: int64 [k], the cell of the level that a node belongs to, as a one above the three bits of each halving:
            that of the cell around it is `name >> 3`.
        order: int32 [n], points by node; all of them, unless the nodes are those below a cell alone.
    """

    levels: NDArray[np.uint8]
    firsts: NDArray[np.int64]
    counts: NDArray[np.int64]
    depths: NDArray[np.uint8]
    cells: NDArray[np.int64]
    names: NDArray[np.int64]
    order: NDArray[np.int32]


class _Rows:
    """The places of points in Morton order, by level."""

    def __init__(self, levels: NDArray[np.uint8]):
        self.ends = np.cumsum(np.bincount(levels, minlength=LEVELS)).tolist()
        self.places = np.empty(len(levels), np.int32)
        for level in range(LEVELS):
            self.places[self.begin(level) : self.ends[level]] = np.flatnonzero(levels == level)

    def begin(self, level: int) -> int:
        return self.ends[level - 1] if level else 0

    def count_before(self, level: int, places: NDArray[np.int64]) -> NDArray[np.int64]:
        """How many rows are of a level or above, and lie before places; as rows of `places`."""
        part = self.places[self.begin(level) : self.ends[level]]
        return np.searchsorted(part, places.astype(np.int32)) + self.begin(level)


@dataclasses.dataclass
class _Node:
    level: int
    code: int
    depth: int
    runs: list[tuple[int, int]]  # of _Rows.places

    @property
    def count(self) -> int:
        return sum(end - begin for begin, end in self.runs)


def make_nodes(
    keys: NDArray[np.int64],
    order: NDArray[np.int32],
    levels: NDArray[np.uint8],
    *,
    most: int,
    least: int = LEAST,
    depth: int = 0,
) -> NodeTable:
    """The nodes of points in Morton order.

    Args:
        keys: Morton keys, ascending, [n].
        order: The point of each, [n].
        levels: Its level, [n].
        most: Points of a node above which it is cut.
        least: Deeper points that join the node above, if not more.
        depth: Halvings to the cell that holds all of them; points of coarser levels are in none of the nodes.

    Notes:
        Memory: 8 B a point beside the arguments, of which 4 B are the result's.
    """
    rows = _Rows(levels)
    nodes: list[_Node] = []
    codes = keys[:1] >> (_KEY_BITS - 3 * depth)
    begins, ends = np.zeros(1, np.int64), np.full(1, len(keys), np.int64)
    for level in range(depth, LEVELS if len(keys) else 0):
        bounds = [(rows.count_before(j, begins), rows.count_before(j, ends)) for j in range(LEVELS)]
        counts = np.stack([last - first for first, last in bounds])
        own, deeper = counts[level], counts[level + 1 :].sum(axis=0)
        closed = deeper <= np.maximum(least, own // SHARE)
        for k in np.flatnonzero((own > 0) | closed).tolist():
            span = bounds[level:] if closed[k] else bounds[level : level + 1]
            runs = [(int(first[k]), int(last[k])) for first, last in span if last[k] > first[k]]
            if runs:
                nodes += _parts(_Node(level, int(codes[k]), level, runs), keys, rows, most)
        codes = (codes[~closed, None] * 8 + np.arange(8)).ravel()
        begins, ends = _runs_of(keys, codes, level + 1)
        codes, begins, ends = codes[ends > begins], begins[ends > begins], ends[ends > begins]
    return _table(nodes, order, rows)


def _runs_of(keys: NDArray[np.int64], codes: Any, depth: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Where the points of cells begin and end in Morton order."""
    shift = _KEY_BITS - 3 * depth
    lows = np.asarray(codes, np.int64) << shift
    return np.searchsorted(keys, lows), np.searchsorted(keys, lows | ((1 << shift) - 1), side="right")


def _parts(node: _Node, keys: NDArray[np.int64], rows: _Rows, most: int) -> list[_Node]:
    """A node, or the parts of one that is too large: by its cell's octants, or by count where they share one place."""
    if node.count <= most:
        return [node]
    if node.depth == DEPTH:
        cuts = [(at, min(at + most, end)) for begin, end in node.runs for at in range(begin, end, most)]
        return [dataclasses.replace(node, runs=[cut]) for cut in cuts]
    codes = node.code * 8 + np.arange(8)
    begins, ends = _runs_of(keys, codes, node.depth + 1)
    edges = np.append(begins, ends[-1:])
    cuts = [first + np.searchsorted(rows.places[first:last], edges.astype(np.int32)) for first, last in node.runs]
    parts = []
    for k, code in enumerate(codes.tolist()):
        runs = [(int(cut[k]), int(cut[k + 1])) for cut in cuts if cut[k + 1] > cut[k]]
        if runs:
            parts += _parts(_Node(node.level, code, node.depth + 1, runs), keys, rows, most)
    return parts


def _table(nodes: list[_Node], order: NDArray[np.int32], rows: _Rows) -> NodeTable:
    counts = np.array([node.count for node in nodes], np.int64)
    firsts = np.cumsum(counts) - counts
    by_node = np.empty(int(counts.sum()), np.int32)
    at = 0
    for node in nodes:
        for begin, end in node.runs:
            by_node[at : at + end - begin] = order[rows.places[begin:end]]
            at += end - begin
    codes = np.array([node.code for node in nodes], np.int64)
    levels, depths = (np.array([getattr(node, name) for node in nodes], np.uint8) for name in ("level", "depth"))
    ones = np.int64(1) << (3 * levels.astype(np.int64))
    names = ones | (codes >> (3 * (depths - levels).astype(np.int64)))
    return NodeTable(levels, firsts, counts, depths, cells_of(codes), names, by_node)


def cells_of(codes: NDArray[np.int64]) -> NDArray[np.int64]:
    """The cell along each axis of Morton codes, [k, 3]."""
    return np.stack([_gather_bits(codes >> axis) for axis in (2, 1, 0)], axis=-1).reshape(-1, 3)


def _gather_bits(codes: NDArray[np.int64]) -> NDArray[np.int64]:
    """Every third bit, side by side."""
    out = np.zeros_like(codes)
    for bit in range(DEPTH):
        out |= ((codes >> (3 * bit)) & 1) << bit
    return out
