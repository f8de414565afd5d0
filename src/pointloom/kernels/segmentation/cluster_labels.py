"""Cluster labels from disjoint sets of core points: numbering, sizes. Border points are in border_labels.py.

Clusters are numbered by their first core in cloud order.
"""

from ..array_types import Integers
from ..arrays.lanes import min_int_of_lanes
from ..arrays.select import number_rows_kernel, positions_of
from ..arrays.sort import argsort_keys
from ..lang import (
    WARP,
    array,
    atomic_add,
    atomic_min,
    ballot,
    compute,
    int32,
    int64,
    kernel,
    lane,
    launch,
    shuffle,
    tid,
    uint8,
)
from ..memory import empty, full, zeros
from ..search.point_tree import LEAF
from ..search.tree_walk import NO_NUMBER, lowest_bit
from .core_sets import Cores

NOISE_LABEL = -1
LABELS_PER_THREAD = 64  # neighbors on the curve mostly have equal ones, so a run needs one atomic


@kernel
def find_first_kernel(cores: Cores, firsts: array(dtype=int32)):
    i = tid()
    root = cores.owners[i]
    if root >= 0:
        row = cores.tree.order[i]
        if row < firsts[root]:
            atomic_min(firsts, root, row)  # the minimum selects the first core of a set in the cloud


@find_first_kernel.on_cuda
def find_first_of_lanes_kernel(cores: Cores, firsts: array(dtype=int32)):
    """CUDA variant: one atomic per set of a warp, whose cores are mostly of one."""
    i = tid()
    root = -1
    row = int(NO_NUMBER)
    if i < cores.tree.count:
        root = cores.owners[i]
        row = cores.tree.order[i]
    searching = ballot(1 if root >= 0 else 0)
    while searching != 0:
        leader = lowest_bit(searching)
        chosen = shuffle(root, leader)
        first = min_int_of_lanes(row if root == chosen else NO_NUMBER)
        if lane() == leader:
            if first < firsts[chosen]:
                atomic_min(firsts, chosen, first)  # as above
        searching = searching & ~ballot(1 if root == chosen else 0)


@kernel
def mark_first_kernel(cores: Cores, firsts: array(dtype=int32), marks: array(dtype=uint8)):
    i = tid()
    if cores.owners[i] == i:
        marks[firsts[i]] = 1


@kernel
def label_cores_kernel(cores: Cores, firsts: array(dtype=int32), labels: array(dtype=int32)):
    """Label the cores of a leaf in cloud and tree order, and store its lowest label. First cores have labels."""
    leaf = tid()
    lowest_label = int(NO_NUMBER)
    for rank in range(leaf * LEAF, min((leaf + 1) * LEAF, cores.tree.count)):
        root = cores.owners[rank]
        if root >= 0:
            first = firsts[root]
            label = labels[first]
            row = cores.tree.order[rank]
            if row != first:
                labels[row] = label
            cores.owners[rank] = label
            lowest_label = min(lowest_label, label)
    cores.lowest[leaf] = lowest_label


@kernel
def rename_cores_kernel(renamed: array(dtype=int32), cores: Cores, labels: array(dtype=int32)):
    """Relabel the cores of a leaf in cloud and tree order (NOISE_LABEL removes them), and store its lowest label."""
    leaf = tid()
    lowest_label = int(NO_NUMBER)
    for rank in range(leaf * LEAF, min((leaf + 1) * LEAF, cores.tree.count)):
        before = cores.owners[rank]
        if before >= 0:
            label = renamed[before]
            cores.owners[rank] = label
            labels[cores.tree.order[rank]] = label
            if label >= 0:
                lowest_label = min(lowest_label, label)
    cores.lowest[leaf] = lowest_label


@kernel
def count_labels_kernel(run: int, labels: array(dtype=int32), counts: array(dtype=int32)):
    """Count each label. Integers, so the order of the atomics does not matter."""
    i = tid()
    label = int(NOISE_LABEL)
    count = 0
    for j in range(i * run, min((i + 1) * run, labels.shape[0])):
        if labels[j] == label:
            count += 1
        else:
            if label >= 0:
                atomic_add(counts, label, count)
            label = labels[j]
            count = 1
    if label >= 0:
        atomic_add(counts, label, count)


@kernel
def rank_sizes_kernel(counts: array(dtype=int32), min_size: int, max_size: int, keys: array(dtype=int64)):
    """Keys that sort clusters by decreasing size, those of other sizes last."""
    i = tid()
    key = int(NO_NUMBER)
    if counts[i] >= min_size and counts[i] <= max_size:
        key = NO_NUMBER - counts[i]
    keys[i] = int64(key)


@kernel
def renumber_rows_kernel(keys: array(dtype=int64), order: array(dtype=int32), renamed: array(dtype=int32)):
    i = tid()
    label = int(NOISE_LABEL)
    if int(keys[i]) < NO_NUMBER:
        label = i
    renamed[order[i]] = label


@kernel
def rename_labels_kernel(renamed: array(dtype=int32), labels: array(dtype=int32)):
    i = tid()
    if labels[i] >= 0:
        labels[i] = renamed[labels[i]]


def label_cores(cores: Cores, labels: Integers) -> int:
    """Number the clusters and label cores in `labels` (int32, NOISE_LABEL before). Returns the count. One sync."""
    count, device = cores.tree.count, cores.tree.device
    firsts, marks = full(count, NO_NUMBER, int32, device), zeros(labels.size, uint8, device)
    launch(find_first_kernel, -(-count // WARP) * WARP if device.is_cuda else count, [cores, firsts])
    launch(mark_first_kernel, count, [cores, firsts, marks])
    heads = positions_of(marks)
    launch(number_rows_kernel, heads.size, [heads, labels])
    launch(label_cores_kernel, cores.leaf_count, [cores, firsts, labels])
    return heads.size


def rename_cores(cores: Cores, renamed: Integers, labels: Integers) -> None:
    """Relabel cores by `renamed` (NOISE_LABEL removes them); borders then choose by the new order."""
    launch(rename_cores_kernel, cores.leaf_count, [renamed, cores, labels])


def rank_by_size(labels: Integers, cluster_count: int, min_size: int, max_size: int) -> None:
    """Renumber clusters by decreasing size, ties in order. NOISE_LABEL for sizes outside `min_size`..`max_size`."""
    device = labels.device
    counts, keys = zeros(cluster_count, int32, device), empty(cluster_count, int64, device)
    launch(count_labels_kernel, -(-labels.size // LABELS_PER_THREAD), [LABELS_PER_THREAD, labels, counts])
    launch(rank_sizes_kernel, cluster_count, [counts, min_size, max_size, keys])
    ranked, order = argsort_keys(keys, 31)
    renamed = compute(renumber_rows_kernel, cluster_count, [ranked, order], int32, device)
    launch(rename_labels_kernel, labels.size, [renamed, labels])
