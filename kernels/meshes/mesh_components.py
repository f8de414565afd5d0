"""The parts of a mesh: triangles that hang together by edges, how many each part has, and their areas.

Half-edges are sorted by their two vertices, so the triangles at an edge follow each other and are united; an edge of
three triangles or more joins them all, whatever their directions. Parts are numbered by their first triangles. Areas
are summed in float64 by ascending triangle, in blocks of 1024 whatever the device: the same bits everywhere. About 60 B
of memory a triangle beside the sort.
"""

import numpy as np

from ..array_types import Doubles, Indices, LongIntegers, Mask, Points, Triangles
from ..arrays.pair_sort import argsort_pairs
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.select import positions_of
from ..arrays.sort import positions
from ..arrays.union_find import flatten_sets_kernel, unite
from ..arrays.unique import UniqueKeys
from ..lang import array, float64, int32, int64, kernel, launch, tid, uint8
from ..memory import download, empty, upload
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


def number_parts(parents: Indices) -> tuple[LongIntegers, int]:
    """(labels int64 [t], count): parts by their first triangles, which `parents` gives for each; one sync."""
    device = parents.device
    marks, labels = empty(parents.size, uint8, device), empty(parents.size, int64, device)
    launch(mark_roots_kernel, parents.size, [parents, marks])
    roots = positions_of(marks)  # sync
    launch(number_roots_kernel, roots.size, [roots, labels])
    launch(spread_labels_kernel, parents.size, [parents, labels])
    return labels, roots.size


def sum_by_part(values: Doubles, groups: UniqueKeys, counts: np.ndarray) -> np.ndarray:
    """Sums over parts, float64 NumPy array [c]: by ascending triangle, in blocks of 1024.

    Args:
        values: float64 device array [t].
        groups: UniqueKeys of the labels of all triangles.
        counts: Triangles of each part, NumPy array [c].
    """
    device = values.device
    blocks = SegmentBlocks(download(groups.starts)[:-1], counts, device)  # sync
    sums, totals = empty(blocks.count, float64, device), empty(groups.count, float64, device)
    launch(sum_blocks_kernel, blocks.count, [values, groups.order, blocks.firsts, blocks.lasts, sums])
    launch(fold_blocks_kernel, groups.count, [sums, blocks.starts, totals])
    return download(totals).copy()  # sync


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
        groups = UniqueKeys(self.labels, max(1, part_count.bit_length()))  # sync
        self.counts = download(groups.counts()).copy()  # sync
        self.areas = sum_by_part(measure_areas(vertices, triangles), groups, self.counts) / 2  # they are twice as large

    def mask(self, chosen: np.ndarray) -> Mask:
        """The triangles of chosen parts, uint8 device array [t]; `chosen` is a bool NumPy array [c]."""
        device = self.labels.device
        mask = empty(self.labels.size, uint8, device)
        launch(mask_parts_kernel, mask.size, [self.labels, upload(chosen, uint8, device), mask])
        return mask
