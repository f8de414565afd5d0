"""The parts of a mesh: triangles that hang together by edges, how many each part has, and their areas.

Half-edges are sorted by their two vertices, so the triangles at an edge follow each other and are united; an edge of
three triangles or more joins them all, whatever their directions. Parts are numbered by their first triangles. Areas
are summed in float64 by ascending triangle, in blocks of 1024 whatever the device: the same bits everywhere. About 60 B
of memory a triangle beside the sort.
"""

import numpy as np

from ..array_types import Doubles, Indices, Integers, LongIntegers, Mask, Points, Triangles
from ..arrays.key_starts import find_key_starts
from ..arrays.prefix_sum import offsets_of
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.select import positions_of
from ..arrays.side_by_side import read_together
from ..arrays.sort import argsort_keys, positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..lang import BLOCK, array, float64, int32, int64, kernel, launch, struct, tid, uint8
from ..memory import download, empty, full, rows_of, zeros
from .mesh_topology import sorted_edges
from .surface_samples import measure_areas

MOST = 2**31 - 1  # triangles


@kernel
def mark_roots_kernel(parents: array(dtype=int32), marks: array(dtype=uint8)):
    """1 at the first triangle of each set."""
    i = tid()
    mark = 0
    if parents[i] == i:
        mark = 1
    marks[i] = uint8(mark)


@kernel
def number_roots_kernel(roots: array(dtype=int32), labels: array(dtype=int64)):
    """The number of each part at its first triangle."""
    i = tid()
    labels[roots[i]] = int64(i)


@kernel
def spread_labels_kernel(parents: array(dtype=int32), labels: array(dtype=int64)):
    """The number of its part at each other triangle."""
    i = tid()
    if parents[i] != i:
        labels[i] = labels[parents[i]]


@kernel
def sum_blocks_kernel(
    values: array(dtype=float64),
    order: array(dtype=int32),
    firsts: array(dtype=int32),
    lasts: array(dtype=int32),
    sums: array(dtype=float64),
):
    """The sum over the triangles of each block."""
    i = tid()
    total = float64(0.0)
    for j in range(firsts[i], lasts[i]):
        total += values[order[j]]
    sums[i] = total


@kernel
def fold_blocks_kernel(sums: array(dtype=float64), starts: array(dtype=int32), totals: array(dtype=float64)):
    """The sum of the blocks of each part."""
    i = tid()
    total = float64(0.0)
    for j in range(starts[i], starts[i + 1]):
        total += sums[j]
    totals[i] = total


@kernel
def find_marked_kernel(labels: array(dtype=int64), marks: array(dtype=uint8), held: array(dtype=uint8)):
    """1 for parts with a marked triangle; all threads write the same."""
    i = tid()
    if marks[i] != 0:
        held[int(labels[i])] = uint8(1)


def holds_marked(labels: LongIntegers, marks: Mask, count: int) -> np.ndarray:
    """Whether parts hold a marked triangle, bool NumPy array [count]; marks are of the first triangles. One sync."""
    held = zeros(count, uint8, labels.device)
    launch(find_marked_kernel, marks.size, [labels, marks, held])
    return download(held) != 0  # sync


def number_parts(parents: Indices) -> tuple[LongIntegers, int]:
    """(labels int64 [t], count): parts by their first triangles, which `parents` gives for each; one sync."""
    device = parents.device
    marks, labels = empty(parents.size, uint8, device), empty(parents.size, int64, device)
    launch(mark_roots_kernel, parents.size, [parents, marks])
    roots = positions_of(marks)  # sync
    launch(number_roots_kernel, roots.size, [roots, labels])
    launch(spread_labels_kernel, parents.size, [parents, labels])
    return labels, roots.size


class PartOrder:
    """Triangles by part.

    Args:
        labels: Of `number_parts`.
        count: Parts.

    Attributes:
        order: int32 [t], the triangles by part, those of one ascending.
        starts: int32 [count + 1], where each part begins.
    """

    def __init__(self, labels: LongIntegers, count: int) -> None:
        keys, self.order = argsort_keys(labels, max(1, count.bit_length()))
        self.count, self.starts = count, empty(count + 1, int32, labels.device)
        find_key_starts(keys, self.starts)

    def counts(self) -> np.ndarray:
        """The triangles of each part, int32 NumPy array [count]; one sync."""
        return np.diff(download(self.starts))  # sync

    def sum(self, values: Doubles, counts: np.ndarray) -> Doubles:
        """Sums over parts, float64 device array [count]: by ascending triangle, in blocks of 1024.

        Args:
            values: float64 device array [t].
            counts: Triangles of each part, NumPy array [count].
        """
        device = values.device
        blocks = SegmentBlocks(np.cumsum([0, *counts[:-1]])[: len(counts)], counts, device)
        sums, totals = empty(blocks.count, float64, device), empty(self.count, float64, device)
        launch(sum_blocks_kernel, blocks.count, [values, self.order, blocks.firsts, blocks.lasts, sums])
        launch(fold_blocks_kernel, self.count, [sums, blocks.starts, totals])
        return totals


@kernel
def unite_chosen_kernel(
    keys: array(dtype=int64), order: array(dtype=int32), chosen: array(dtype=uint8), parents: array(dtype=int32)
):
    """Make one set of the chosen triangles at each edge."""
    i = tid()
    own = order[i] // 3
    if i > 0 and chosen[own] != 0:
        j = i - 1
        while j > 0 and keys[max(j, 0)] == keys[i] and chosen[order[max(j, 0)] // 3] == 0:
            j -= 1
        other = order[j] // 3
        if keys[j] == keys[i] and chosen[other] != 0:
            unite(parents, own, other)


@kernel
def count_roots_kernel(parents: array(dtype=int32), chosen: array(dtype=uint8), counts: array(dtype=int32)):
    """1 at the first triangle of each set of chosen ones."""
    i = tid()
    counts[i] = 1 if parents[i] == i and chosen[i] != 0 else 0


@kernel
def label_chosen_kernel(
    parents: array(dtype=int32), chosen: array(dtype=uint8), numbers: array(dtype=int32), labels: array(dtype=int64)
):
    """The number of its set at each chosen triangle, at others a number above all."""
    i = tid()
    label = int64(labels.shape[0])
    if chosen[i] != 0:
        label = int64(numbers[parents[i]])
    labels[i] = label


@kernel
def start_parts_kernel(keys: array(dtype=int64), starts: array(dtype=int32)):
    """Where the triangles of each part begin, whose labels leave none out, and where those of the last end."""
    i = tid()
    before = -1
    if i > 0:
        before = int(keys[i - 1])
    if int(keys[i]) != before:
        starts[before + 1] = i
    if i + 1 == keys.shape[0] and int(keys[i]) < keys.shape[0]:
        starts[int(keys[i]) + 1] = i + 1


@kernel
def sum_part_blocks_kernel(
    values: array(dtype=float64),
    keys: array(dtype=int64),
    order: array(dtype=int32),
    starts: array(dtype=int32),
    sums: array(dtype=float64),
):
    """The sum over the triangles of a block, by the thread of its first one."""
    i = tid()
    part = int(keys[i])
    if part < keys.shape[0]:
        if (i - starts[part]) % BLOCK == 0:
            total = float64(0.0)
            for j in range(i, min(i + BLOCK, starts[part + 1])):
                total += values[order[j]]
            sums[i] = total


@kernel
def fold_part_blocks_kernel(
    sums: array(dtype=float64), starts: array(dtype=int32), count: array(dtype=int32), totals: array(dtype=float64)
):
    """The sum of the blocks of each part, 0 of those that are not there."""
    i = tid()
    total = float64(0.0)
    if i < count[0]:
        first = starts[i]
        for block in range((starts[i + 1] - first + BLOCK - 1) // BLOCK):
            total += sums[first + block * BLOCK]
    totals[i] = total


def label_parts(
    edges: tuple[LongIntegers, Integers], count: int, chosen: Mask | None = None
) -> tuple[LongIntegers, Indices]:
    """(labels int64 [t], how many parts there are, int32 [1]) of `count` triangles, by their first ones; no sync.

    Args:
        edges: Of `sorted_edges`.
        count: Triangles t.
        chosen: uint8 [t], 1 for those that count, None for all; the others have the label t.
    """
    keys, order = edges
    device, chosen = keys.device, full(count, 1, uint8, keys.device) if chosen is None else chosen
    parents, roots, labels = positions(count, device), empty(count, int32, device), empty(count, int64, device)
    launch(unite_chosen_kernel, keys.size, [keys, order, chosen, parents])
    launch(flatten_sets_kernel, count, [parents])
    launch(count_roots_kernel, count, [parents, chosen, roots])
    numbers = offsets_of(roots)
    launch(label_chosen_kernel, count, [parents, chosen, numbers, labels])
    return labels, rows_of(numbers, count, count + 1)


@struct
class Parts:
    """The parts of a mesh that hang together by edges, or of some of its triangles: all of it where the mesh is.

    Args:
        vertices: vec3 [m].
        triangles: vec3i [t].
        chosen: uint8 [t], 1 for the triangles that count; None for all.
        edges: The half-edges of all triangles in order, as `sorted_edges` gives them, where they are known.

    Attributes:
        labels: int64 [t], the part of each triangle; t for those that do not count.
        count: int32 [1], how many parts there are.
        starts: int32 [t + 2], where the triangles of each part begin among those in order, and where the last end.
        doubled: float64 [t], twice the area of each part, 0 behind the last.
    """

    labels: array(dtype=int64)
    starts: array(dtype=int32)
    doubled: array(dtype=float64)

    def __init__(
        self,
        vertices: Points,
        triangles: Triangles,
        chosen: Mask | None = None,
        edges: tuple[LongIntegers, Integers] | None = None,
    ) -> None:
        device, count = triangles.device, triangles.size
        edges = edges or sorted_edges(triangles, vertices.size)
        self.labels, self.count = label_parts(edges, count, chosen)
        keys, order = argsort_keys(self.labels, max(1, count.bit_length()))
        self.starts, self.doubled = zeros(count + 2, int32, device), empty(count, float64, device)
        launch(start_parts_kernel, count, [keys, self.starts])
        sums, areas = empty(count, float64, device), measure_areas(vertices, triangles)
        launch(sum_part_blocks_kernel, count, [areas, keys, order, self.starts, sums])
        launch(fold_part_blocks_kernel, count, [sums, self.starts, self.count, self.doubled])

    def read(self) -> tuple[np.ndarray, np.ndarray]:
        """(triangles of each part, their areas): int32 and float64 NumPy arrays; two syncs."""
        count = int(download(self.count)[0])  # sync
        starts, doubled = read_together([self.starts[: count + 1], self.doubled[:count]]) if count else ([0], [])
        return np.diff(np.asarray(starts, np.int32)), np.asarray(doubled, np.float64) / 2

    def mask_large(self, least_count: int, least_area: float) -> Mask:
        """uint8 [t]: 1 for the triangles of parts that have as many triangles, and as large an area."""
        mask = empty(self.labels.size, uint8, self.labels.device)
        launch(mask_large_parts_kernel, mask.size, [self, min(least_count, MOST), least_area, mask])
        return mask


@kernel
def mask_large_parts_kernel(parts: Parts, least_count: int, least_area: float64, mask: array(dtype=uint8)):
    """1 for the triangles of parts that have as many and as large an area."""
    i = tid()
    part = int(parts.labels[i])
    mask[i] = uint8(0)
    if part < parts.labels.shape[0]:
        count = parts.starts[part + 1] - parts.starts[part]
        if count >= least_count and parts.doubled[part] / 2.0 >= least_area:
            mask[i] = uint8(1)
