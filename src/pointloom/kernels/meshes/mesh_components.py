"""Edge-connected components of a mesh, their triangle counts and areas.

Triangles at an edge of any number are united. Components are numbered by first triangle. Areas are float64 sums in
blocks of 1024 by ascending triangle: bitwise reproducible. About 60 B per triangle.
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
from ..lang import ELEMENTS_PER_BLOCK, array, float64, int32, int64, kernel, launch, struct, tid, uint8
from ..memory import download, empty, full, rows_of, zeros
from .mesh_topology import sorted_edges
from .surface_samples import measure_areas

MAX_TRIANGLES = 2**31 - 1  # triangles


@kernel
def mark_roots_kernel(parents: array(dtype=int32), marks: array(dtype=uint8)):
    i = tid()
    mark = 0
    if parents[i] == i:
        mark = 1
    marks[i] = uint8(mark)


@kernel
def number_roots_kernel(roots: array(dtype=int32), labels: array(dtype=int64)):
    i = tid()
    labels[roots[i]] = int64(i)


@kernel
def spread_labels_kernel(parents: array(dtype=int32), labels: array(dtype=int64)):
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
    i = tid()
    total = float64(0.0)
    for j in range(firsts[i], lasts[i]):
        total += values[order[j]]
    sums[i] = total


@kernel
def fold_blocks_kernel(sums: array(dtype=float64), starts: array(dtype=int32), totals: array(dtype=float64)):
    i = tid()
    total = float64(0.0)
    for j in range(starts[i], starts[i + 1]):
        total += sums[j]
    totals[i] = total


@kernel
def find_marked_kernel(labels: array(dtype=int64), marks: array(dtype=uint8), has_mark: array(dtype=uint8)):
    """1 for components with a marked triangle. All threads write the same value."""
    i = tid()
    if marks[i] != 0:
        has_mark[int(labels[i])] = uint8(1)


def has_marked(labels: LongIntegers, marks: Mask, count: int) -> np.ndarray:
    """True for components with a marked triangle, NumPy [count]. Marks are those of first triangles. One sync."""
    has_mark = zeros(count, uint8, labels.device)
    launch(find_marked_kernel, marks.size, [labels, marks, has_mark])
    return download(has_mark) != 0  # sync


def number_parts(parents: Indices) -> tuple[LongIntegers, int]:
    """(labels int64 [t], count) from the first triangle of each component. One sync."""
    device = parents.device
    marks, labels = empty(parents.size, uint8, device), empty(parents.size, int64, device)
    launch(mark_roots_kernel, parents.size, [parents, marks])
    roots = positions_of(marks)  # sync
    launch(number_roots_kernel, roots.size, [roots, labels])
    launch(spread_labels_kernel, parents.size, [parents, labels])
    return labels, roots.size


class PartOrder:
    """Triangles by component: `order` int32 [t] ascending within each, `starts` int32 [count + 1]."""

    def __init__(self, labels: LongIntegers, count: int) -> None:
        keys, self.order = argsort_keys(labels, max(1, count.bit_length()))
        self.count, self.starts = count, empty(count + 1, int32, labels.device)
        find_key_starts(keys, self.starts)

    def counts(self) -> np.ndarray:
        """Number of triangles of each component, int32 NumPy [count]. One sync."""
        return np.diff(download(self.starts))  # sync

    def sum(self, values: Doubles, counts: np.ndarray) -> Doubles:
        """Sum float64 values [t] over components in blocks of 1024, given their triangle counts (NumPy)."""
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
    i = tid()
    triangle = order[i] // 3
    if i > 0 and chosen[triangle] != 0:
        j = i - 1
        while j > 0 and keys[max(j, 0)] == keys[i] and chosen[order[max(j, 0)] // 3] == 0:
            j -= 1
        other = order[j] // 3
        if keys[j] == keys[i] and chosen[other] != 0:
            unite(parents, triangle, other)


@kernel
def count_roots_kernel(parents: array(dtype=int32), chosen: array(dtype=uint8), counts: array(dtype=int32)):
    """1 at the first triangle of each set of selected ones."""
    i = tid()
    counts[i] = 1 if parents[i] == i and chosen[i] != 0 else 0


@kernel
def label_chosen_kernel(
    parents: array(dtype=int32), chosen: array(dtype=uint8), numbers: array(dtype=int32), labels: array(dtype=int64)
):
    i = tid()
    label = int64(labels.shape[0])
    if chosen[i] != 0:
        label = int64(numbers[parents[i]])
    labels[i] = label


@kernel
def start_parts_kernel(keys: array(dtype=int64), starts: array(dtype=int32)):
    """First triangle of each component, and the end of the last. Labels have no gaps."""
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
    i = tid()
    part = int(keys[i])
    if part < keys.shape[0]:
        if (i - starts[part]) % ELEMENTS_PER_BLOCK == 0:
            total = float64(0.0)
            for j in range(i, min(i + ELEMENTS_PER_BLOCK, starts[part + 1])):
                total += values[order[j]]
            sums[i] = total


@kernel
def fold_part_blocks_kernel(
    sums: array(dtype=float64), starts: array(dtype=int32), count: array(dtype=int32), totals: array(dtype=float64)
):
    """Sum of the blocks of each component, 0 beyond the last."""
    i = tid()
    total = float64(0.0)
    if i < count[0]:
        first = starts[i]
        for block in range((starts[i + 1] - first + ELEMENTS_PER_BLOCK - 1) // ELEMENTS_PER_BLOCK):
            total += sums[first + block * ELEMENTS_PER_BLOCK]
    totals[i] = total


def label_parts(
    edges: tuple[LongIntegers, Integers], count: int, chosen: Mask | None = None
) -> tuple[LongIntegers, Indices]:
    """(labels int64 [t], count int32 [1]) by first triangle. Unselected triangles get the label t. No sync."""
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
    """Edge-connected components of a mesh or of `chosen` triangles (uint8 [t]). `labels` int64 [t] (t if unselected),
    `count` int32 [1], `starts` int32 [t + 2], `doubled` float64 [t] twice the areas."""

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
        """(triangle counts, areas): int32 and float64 NumPy arrays. Two syncs."""
        count = int(download(self.count)[0])  # sync
        starts, doubled = read_together([self.starts[: count + 1], self.doubled[:count]]) if count else ([0], [])
        return np.diff(np.asarray(starts, np.int32)), np.asarray(doubled, np.float64) / 2

    def mask_large(self, min_count: int, min_area: float) -> Mask:
        mask = empty(self.labels.size, uint8, self.labels.device)
        launch(mask_large_parts_kernel, mask.size, [self, min(min_count, MAX_TRIANGLES), min_area, mask])
        return mask


@kernel
def mask_large_parts_kernel(parts: Parts, min_count: int, min_area: float64, mask: array(dtype=uint8)):
    i = tid()
    part = int(parts.labels[i])
    mask[i] = uint8(0)
    if part < parts.labels.shape[0]:
        count = parts.starts[part + 1] - parts.starts[part]
        if count >= min_count and parts.doubled[part] / 2.0 >= min_area:
            mask[i] = uint8(1)
