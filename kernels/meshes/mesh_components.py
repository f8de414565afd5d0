"""The parts of a mesh: triangles that hang together by edges, how many each part has, and their areas.

Half-edges are sorted by their two vertices, so the triangles at an edge follow each other and are united; an edge of
three triangles or more joins them all, whatever their directions. Parts are numbered by their first triangles. Areas
are summed in float64 by ascending triangle, in blocks of 1024 whatever the device: the same bits everywhere. About 60 B
of memory a triangle beside the sort.
"""

import numpy as np

from ..array_types import Doubles, Indices, LongIntegers, Mask, Points, Triangles
from ..arrays.key_starts import find_key_starts
from ..arrays.pair_sort import argsort_pairs
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.select import positions_of
from ..arrays.sort import argsort_keys, positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..lang import array, float64, int32, int64, kernel, launch, tid, uint8
from ..memory import download, empty, upload, zeros
from .mesh_topology import list_edge_keys_kernel
from .surface_samples import measure_areas


@kernel
def unite_at_edges_kernel(keys: array(dtype=int64), order: array(dtype=int32), parents: array(dtype=int32)):
    """Make one set of the triangles at each edge."""
    i = tid()
    if i > 0:
        if keys[i] == keys[i - 1]:
            unite(parents, order[i] // 3, order[i - 1] // 3)


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
def mask_parts_kernel(labels: array(dtype=int64), chosen: array(dtype=uint8), mask: array(dtype=uint8)):
    """1 for the triangles of chosen parts."""
    i = tid()
    mask[i] = chosen[int(labels[i])]


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


class Components:
    """The parts of a mesh that hang together by edges.

    Args:
        vertices: vec3 [m].
        triangles: vec3i [t].

    Attributes:
        labels: int64 device array [t].
        counts: Triangles of each part, int32 NumPy array [c].
        areas: Their areas, float64 NumPy array [c].
    """

    def __init__(self, vertices: Points, triangles: Triangles) -> None:
        device, count = triangles.device, triangles.size
        bits = max(1, vertices.size.bit_length())
        keys, parents = empty(3 * count, int64, device), positions(count, device)
        launch(list_edge_keys_kernel, count, [triangles, bits, keys])
        keys, order = argsort_pairs(keys, bits, vertices.size)
        launch(unite_at_edges_kernel, keys.size, [keys, order, parents])
        launch(flatten_sets_kernel, count, [parents])
        self.labels, part_count = number_parts(parents)  # sync
        parts = PartOrder(self.labels, part_count)
        self.counts = parts.counts()  # sync
        doubled = parts.sum(measure_areas(vertices, triangles), self.counts)
        self.areas = download(doubled) / 2  # sync

    def mask(self, chosen: np.ndarray) -> Mask:
        """The triangles of chosen parts, uint8 device array [t]; `chosen` is a bool NumPy array [c]."""
        device = self.labels.device
        mask = empty(self.labels.size, uint8, device)
        launch(mask_parts_kernel, mask.size, [self.labels, upload(chosen, uint8, device), mask])
        return mask
