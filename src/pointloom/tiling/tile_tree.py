"""Octree over the points of many LAZ files in bounded memory; io/points/copc_writer.py writes its nodes as COPC.

The tree equals that of `write_copc` over all points in file order. The cube is halved until each cell fits in memory.
Levels are computed per cell, along the Morton curve, with one open node per level. Cells smaller than a voxel of the
coarsest level (1/128 of the cube) first compare their representative points. Two passes over the files. 150 B per point
of a cell, 256 MiB of chunks.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..core.errors import FileError
from ..core.progress import ReportProgress, ignore_progress
from ..io.points.laz_chunks import LazChunks, is_alike
from ..kernels.lang import vec3d
from ..kernels.lru_cache import LruCache
from ..kernels.memory import download, upload
from ..kernels.sampling.detail_levels import (
    LAST_CELL,
    LEVEL_COUNT,
    MAX_DEPTH,
    NODE_BITS,
    Cube,
    find_levels,
    sort_by_cell,
)
from ..pcd.detail_nodes import NodeTable, cells_of, make_nodes
from .processes import Processes

# Points of a cell. In larger cells, their own level takes at most 128^3 voxels, so more points are deeper than may be
# merged into the parent (pcd/detail_nodes.py): no node ends above the cells.
MAX_POINTS = 2_800_000
GRID_DEPTH = 14  # halvings to the counted cells, fewer if too many have points
MAX_CELLS = 1 << 20
MIN_POINTS = 8192  # deeper points merged into the parent, as in write_copc
_POINTS_PER_BATCH = 1 << 20  # points read at a time
_CACHE_BYTES = 1 << 28
_AXES = ("X", "Y", "Z")


class Node(NamedTuple):
    """Octree cell: level, cell coordinates, rows in file order, and the `chunk` made by `pack`, if given."""

    level: int
    cell: tuple[int, int, int]
    rows: NDArray[Any]
    chunk: bytes | None = None


Above = dict[int, tuple[NDArray[Any], NDArray[np.int64]]]  # by level, the rows above a cell and their numbers
Pack = Callable[[list[NDArray[Any]]], list[bytes]]


class Leaf(NamedTuple):
    """Cell processed at once: number of halvings, Morton code, points."""

    depth: int
    code: int
    points: int


@dataclass
class _Chunks:
    """All chunks: file, chunk index, first point, box in finest cells."""

    files: NDArray[np.int64]
    chunks: NDArray[np.int64]
    firsts: NDArray[np.int64]
    lows: NDArray[np.int64]
    highs: NDArray[np.int64]


class TileTree:
    """Octree over LAZ files of one format, scale and offset. FileError if a file changed or too many points coincide.
    `counts` are the points per file; `report` is called with "points" and progress of twice the points; `pool` reads
    and packs. `corner`, `side`, `low` and `high` are the cube and the bounds; `leaves` the cells in Morton order."""

    def __init__(self, paths: list[Path], counts: list[int], report: ReportProgress, pool: Processes | None = None):
        self._pool, self._min_points = pool or Processes(0, paths[0]), MIN_POINTS
        self._report, self.files = report, [LazChunks(path) for path in paths]
        first = self.files[0].header
        for file, count in zip(self.files, counts, strict=True):
            if file.header.point_count != count or not is_alike(file.header, first):
                reason = f"is not the tile that was written: {file.header.point_count} points, not {count}"
                raise FileError(file.path, reason, remedy="Call retry_tiles, or plan it again")
        self.scales, self.offsets = np.array(first.scales), np.array(first.offsets)
        self.low = np.min([file.header.bounds[0] for file in self.files], axis=0)
        self.high = np.max([file.header.bounds[1] for file in self.files], axis=0)
        self.corner = self.low
        self.side = max(float((self.high - self.corner).max()), float(self.scales.max()))
        self.count = sum(counts)
        self._cache: LruCache[NDArray[Any]] = LruCache(_CACHE_BYTES)
        depth, cells, cell_counts = self._survey()
        self.leaves = self._split(depth, cells, cell_counts)

    def positions(self, rows: NDArray[Any]) -> NDArray[np.float64]:
        """Coordinates of rows, float64 (n, 3)."""
        return _positions(rows, self.scales, self.offsets)

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"_pool": None, "_report": ignore_progress, "_kept": LruCache(_CACHE_BYTES)}

    def _survey(self) -> tuple[int, NDArray[np.int64], NDArray[np.int64]]:
        """(halvings, codes, counts) of cells with points. Also stores chunk boxes."""
        grid, at = _Grid(), 0
        boxes: list[list[NDArray[Any]]] = []
        tasks = [(file, which) for file in self.files for which in _runs(file.counts, _POINTS_PER_BATCH)]
        firsts = np.concatenate([np.cumsum(file.counts) - file.counts for file in self.files])
        numbers = {id(file): number for number, file in enumerate(self.files)}
        look = _FirstPass(self.scales, self.offsets, self.corner, self.side)
        begin = 0
        for (file, which), (codes, counts, lows, highs) in zip(tasks, self._pool.map(look, tasks), strict=True):
            chunks = slice(begin, begin + len(which))
            begin += len(which)
            base = at - int(firsts[chunks][0])
            boxes.append([np.full(len(which), numbers[id(file)]), which, base + firsts[chunks], lows, highs])
            grid.add(codes, counts)
            at += int(file.counts[which].sum())
            self._report("points", at, 2 * self.count)
        numbers, chunks, starts, low_steps, high_steps = (np.concatenate(column) for column in zip(*boxes, strict=True))
        lows, highs = self._cells_of(low_steps), self._cells_of(high_steps)
        outside = np.flatnonzero((lows < 0).any(axis=1) | (highs > LAST_CELL + 2).any(axis=1))
        if len(outside):
            path = self.files[int(numbers[outside[0]])].path
            raise FileError(path, "has points outside the bounds of its header", remedy="Write it again")
        lows, highs = np.minimum(lows, LAST_CELL), np.minimum(highs, LAST_CELL)
        self._chunks = _Chunks(numbers, chunks, starts, lows, highs)
        return grid.finish()

    def _cells_of(self, steps: NDArray[Any]) -> NDArray[np.int64]:
        """Finest cells of integer coordinates (n, 3)."""
        positions = steps * self.scales + self.offsets
        return np.floor((positions - self.corner) * Cube(self.corner, self.side).scale).astype(np.int64)

    def _split(self, depth: int, codes: NDArray[np.int64], counts: NDArray[np.int64]) -> list[Leaf]:
        ends = np.concatenate([[0], np.cumsum(counts)])
        leaves, stack = [], [(0, 0)]
        while stack:
            at, code = stack.pop()
            shift = 3 * (depth - at)
            low, high = np.searchsorted(codes, [code << shift, (code + 1) << shift]).tolist()
            count = int(ends[high] - ends[low])
            if not count:
                continue
            if count <= MAX_POINTS:
                leaves.append(Leaf(at, code, count))
                continue
            if at == min(depth, LEVEL_COUNT - 1):
                position = self.corner + cells_of(np.array([code]))[0] * (self.side / 2**at)
                size = f"{self.side / 2**at:g}"
                reason = f"expected at most {MAX_POINTS:,} points within {size} of {position.tolist()}, got {count:,}"
                raise FileError(self.files[0].path.parent, reason, remedy="Add a step voxel_down_sample")
            stack += [(at + 1, code * 8 + octant) for octant in range(7, -1, -1)]
        return leaves

    def nodes(self, pack: Pack | None = None) -> Iterator[Node]:
        """Yield nodes with points, children before parents; `pack` makes their chunks."""
        representatives = self._representatives()
        pending: dict[int, list[tuple[NDArray[Any], NDArray[np.int64]]]] = {}
        done = 0
        tasks = ((leaf, representatives.get(leaf), pack) for leaf in self.leaves)
        for k, (nodes, above) in enumerate(self._pool.map(self.cell, tasks)):
            leaf = self.leaves[k]
            for level, chosen in above.items():
                pending.setdefault(level, []).append(chosen)
            yield from nodes
            done += leaf.points
            self._report("points", self.count + done, 2 * self.count)
            following = self.leaves[k + 1] if k + 1 < len(self.leaves) else None
            shared = -1 if following is None else _shared_depth(leaf, following)
            for level in sorted((level for level in pending if level > shared), reverse=True):
                node = _joined(level, leaf.code >> 3 * (leaf.depth - level), pending.pop(level))
                yield from _packed([node], pack)

    def cell(self, leaf: Leaf, level_of_representative: int | None, pack: Pack | None) -> tuple[list[Node], Above]:
        """Nodes in a cell, and points for levels above; `level_of_representative` is a value of `_representatives`."""
        rows, numbers = self._gather(leaf)
        keys, order, levels = self._levels_of(leaf, rows, numbers)
        if level_of_representative is not None:
            levels[levels < leaf.depth - NODE_BITS + 1] = level_of_representative
        table = make_nodes(keys, order, levels, max_points=self.count, min_points=self._min_points, depth=leaf.depth)
        above: Above = {}
        for level in range(leaf.depth):
            chosen = np.sort(order[levels == level])
            if len(chosen):
                above[level] = rows[chosen], numbers[chosen]
        return _packed([*_nodes_of(table, rows)], pack), above

    def _levels_of(self, leaf: Leaf, rows: NDArray[Any], numbers: NDArray[np.int64]) -> Any:
        points = upload(self.positions(rows), vec3d, "cpu")
        keys, order, levels = find_levels(points, self.corner, self.side, numbers)
        if len(rows) != leaf.points or ((keys >> 3 * (MAX_DEPTH - leaf.depth)) != leaf.code).any():
            raise FileError(self.files[0].path.parent, "the tiles changed while they were read")
        return keys, order, levels

    def _representatives(self) -> dict[Leaf, int]:
        """Level of the representative point of cells smaller than a voxel of the coarsest level."""
        ranked = []
        for leaf in self.leaves:
            if leaf.depth <= NODE_BITS:
                continue
            rows, numbers = self._gather(leaf)
            _, order, levels = self._levels_of(leaf, rows, numbers)
            (best,) = order[levels == 0].tolist()
            ranked.append((priority_of(int(numbers[best])), leaf))
        result: dict[Leaf, int] = {}
        for rank, leaf in ranked:
            depths = [_shared_depth(leaf, other) for other_rank, other in ranked if other_rank < rank]
            result[leaf] = max([NODE_BITS - 1, *depths]) - (NODE_BITS - 1)
        return result

    def _gather(self, leaf: Leaf) -> tuple[NDArray[Any], NDArray[np.int64]]:
        shift = MAX_DEPTH - leaf.depth
        low = cells_of(np.array([leaf.code]))[0] << shift
        high = low + (1 << shift) - 1
        low_steps, high_steps = self._steps_from(low), self._steps_from(high + 1) - 1
        high_steps[high >= LAST_CELL] = np.iinfo(np.int32).max
        chunks = self._chunks
        meets = (chunks.lows <= high).all(axis=1) & (chunks.highs >= low).all(axis=1)
        rows: list[NDArray[Any]] = [np.empty(0, self.files[0].row)]
        numbers: list[NDArray[np.int64]] = [np.empty(0, np.int64)]
        for k in np.flatnonzero(meets).tolist():
            read = self._chunk(k)
            keep = np.ones(len(read), bool)
            for axis, name in enumerate(_AXES):
                if chunks.lows[k, axis] < low[axis] or chunks.highs[k, axis] > high[axis]:
                    keep &= (read[name] >= low_steps[axis]) & (read[name] <= high_steps[axis])
            chosen = np.flatnonzero(keep)
            rows.append(read[chosen])
            numbers.append(chosen + chunks.firsts[k])
        return np.concatenate(rows), np.concatenate(numbers)

    def _steps_from(self, cells: NDArray[np.int64]) -> NDArray[np.int64]:
        """First integer coordinate along each axis in or after a finest cell."""
        low, high = np.full(3, -(1 << 31)), np.full(3, (1 << 31) - 1)
        for _ in range(33):
            middle = (low + high) // 2
            is_in = self._cells_of(middle) >= cells
            low, high = np.where(is_in, low, np.minimum(middle + 1, high)), np.where(is_in, middle, high)
        return high

    def _chunk(self, k: int) -> NDArray[Any]:
        rows = self._cache.find(k)
        if rows is None:
            chunks = self._chunks
            rows = self.files[int(chunks.files[k])].rows(chunks.chunks[k : k + 1])
            self._cache.put(k, rows, rows.nbytes)
        return rows


@dataclass
class _FirstPass:
    """First pass over chunks of a file: points by cell, and chunk boxes in steps."""

    scales: NDArray[np.float64]
    offsets: NDArray[np.float64]
    corner: NDArray[np.float64]
    side: float

    def __call__(self, file: LazChunks, which: NDArray[np.int64]) -> tuple[NDArray[Any], ...]:
        """(cells after GRID_DEPTH halvings, point counts, lows, highs)."""
        rows, starts = file.rows(which), np.cumsum(file.counts[which]) - file.counts[which]
        lows, highs = (
            np.column_stack([extreme.reduceat(rows[name], starts) for name in _AXES])
            for extreme in (np.minimum, np.maximum)
        )
        points = upload(_positions(rows, self.scales, self.offsets), vec3d, "cpu")
        keys = download(sort_by_cell(points, Cube(self.corner, self.side))[0])
        return *_counted(keys >> 3 * (MAX_DEPTH - GRID_DEPTH), None), lows, highs


def _positions(rows: NDArray[Any], scales: Any, offsets: Any) -> NDArray[np.float64]:
    return np.column_stack([rows[name] * scales[k] + offsets[k] for k, name in enumerate(_AXES)])


def _packed(nodes: list[Node], pack: Pack | None) -> list[Node]:
    if pack is None or not nodes:
        return nodes
    chunks = pack([node.rows for node in nodes])
    return [node._replace(chunk=chunk) for node, chunk in zip(nodes, chunks, strict=True)]


class _Grid:
    """Points by cell, with limited resolution."""

    def __init__(self) -> None:
        self.depth, self._parts = GRID_DEPTH, [(np.empty(0, np.int64), np.empty(0, np.int64))]

    def add(self, codes: NDArray[np.int64], counts: NDArray[np.int64]) -> None:
        """Add counts of ascending cells after GRID_DEPTH halvings."""
        self._parts.append(_counted(codes >> 3 * (GRID_DEPTH - self.depth), counts))
        if sum(len(codes) for codes, _ in self._parts[1:]) > MAX_CELLS:
            self._join()

    def _join(self) -> None:
        codes, counts = (np.concatenate(column) for column in zip(*self._parts, strict=True))
        order = np.argsort(codes, kind="stable")
        joined = _counted(codes[order], counts[order])
        while len(joined[0]) > MAX_CELLS:
            self.depth -= 1
            joined = _counted(joined[0] >> 3, joined[1])
        self._parts = [joined]

    def finish(self) -> tuple[int, NDArray[np.int64], NDArray[np.int64]]:
        self._join()
        codes, counts = self._parts[0]
        return self.depth, codes, counts


def _counted(codes: NDArray[np.int64], counts: NDArray[np.int64] | None) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Unique ascending codes and their point counts."""
    starts = np.flatnonzero(np.diff(codes, prepend=-1))
    if counts is None:
        return codes[starts], np.diff(np.append(starts, len(codes)))
    return codes[starts], np.add.reduceat(counts, starts) if len(starts) else counts


def _runs(counts: NDArray[np.int64], max_points: int) -> Iterator[NDArray[np.int64]]:
    """Consecutive chunk numbers with at most `max_points` points, unless a single chunk has more."""
    ends, begin = np.cumsum(counts), 0
    while begin < len(counts):
        before = int(ends[begin - 1]) if begin else 0
        end = max(int(np.searchsorted(ends, before + max_points, side="right")), begin + 1)
        yield np.arange(begin, end)
        begin = end


def _nodes_of(table: NodeTable, rows: NDArray[Any]) -> Iterator[Node]:
    for first, count, level, cell in zip(
        table.firsts.tolist(), table.counts.tolist(), table.depths.tolist(), table.cells.tolist(), strict=True
    ):
        yield Node(level, tuple(cell), rows[np.sort(table.order[first : first + count])])


def _joined(level: int, code: int, parts: list[tuple[NDArray[Any], NDArray[np.int64]]]) -> Node:
    rows, numbers = (np.concatenate(column) for column in zip(*parts, strict=True))
    return Node(level, tuple(cells_of(np.array([code]))[0].tolist()), rows[np.argsort(numbers)])


def _shared_depth(leaf: Leaf, other: Leaf) -> int:
    """Halvings to the smallest common cell of two leaves."""
    depth = min(leaf.depth, other.depth)
    differing = (leaf.code >> 3 * (leaf.depth - depth)) ^ (other.code >> 3 * (other.depth - depth))
    return depth - -(-differing.bit_length() // 3)


def priority_of(number: int) -> int:
    """As `kernels.sampling.detail_levels.priority`, of a number's lower 32 bits."""
    x = number & 0xFFFFFFFF
    x ^= x >> 16
    x = x * 0x7FEB352D & 0xFFFFFFFF
    x ^= (x >> 15) & 0x1FFFF
    x = x * -0x7B935975 & 0xFFFFFFFF
    x ^= (x >> 16) & 0xFFFF
    return x - (1 << 32) if x >> 31 else x
