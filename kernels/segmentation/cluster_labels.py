"""Cluster labels from disjoint sets of core points: numbering, border points, sizes.

Clusters are numbered by their first core in cloud order. A border point, within the radius of a core, takes the lowest
label of those cores. The tree traversal skips nodes without a lower label.
"""

from ..array_types import Integers
from ..arrays.select import number_rows_kernel, positions_of
from ..arrays.sort import argsort_keys
from ..lang import INFINITY, array, atomic_add, atomic_min, func, int32, int64, kernel, launch, tid, uint8, vec3
from ..memory import empty, full, zeros
from ..search.point_tree import FAN, LEAF, measure_boxes
from ..search.tree_walk import (
    NO_NUMBER,
    bits_of,
    bits_within,
    lanes,
    leaves_of,
    measure_farthest,
    nodes_after,
    numbers,
    other_children,
    points_of,
    record_of,
)
from .core_sets import Cores

NOISE = -1
RUN = 64  # labels per thread. Neighbors on the curve mostly have equal ones, so a run needs one atomic


@kernel
def find_first_kernel(cores: Cores, firsts: array(dtype=int32)):
    i = tid()
    root = cores.owners[i]
    if root >= 0:
        row = cores.tree.order[i]
        if row < firsts[root]:
            atomic_min(firsts, root, row)  # the minimum selects the first core of a set in the cloud


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
    """Relabel the cores of a leaf in cloud and tree order (NOISE removes them), and store its lowest label."""
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


@func
def lower_lanes(best: numbers, value: int) -> numbers:
    lower = numbers(0)
    for j in range(LEAF):
        lower[j] = min(best[j], value)
    return lower


@func
def largest_of(values: numbers) -> int:
    largest = values[0]
    for j in range(1, LEAF):
        largest = max(largest, values[j])
    return largest


@func
def follow_leaf(best: numbers, xs: lanes, ys: lanes, zs: lanes, first: int, last: int, cores: Cores) -> numbers:
    """Lower each lane's label to those of cores first..last - 1 within the radius."""
    lower = best
    for r in range(first, last):
        label = cores.owners[r]
        if label >= 0:
            q = cores.tree.points[r]
            for j in range(LEAF):
                x = q[0] - xs[j]
                y = q[1] - ys[j]
                z = q[2] - zs[j]
                lower[j] = min(lower[j], label if x * x + y * y + z * z <= cores.max_sqdist else NO_NUMBER)
    return lower


@func
def lower_children(lowest: array(dtype=int32), record: int, label: int) -> int:
    """Bit mask of the children that contain a label below this one."""
    bits = 0
    for j in range(FAN):
        bits = bits | ((1 << j) if lowest[record * FAN + j] < label else 0)
    return bits


@func
def follow_cores(best: numbers, xs: lanes, ys: lanes, zs: lanes, a: vec3, b: vec3, leaf: int, cores: Cores) -> numbers:
    """Lowest label of the cores within the radius of each lane; (a, b) is the lanes' bounding box."""
    lower = best
    worst = largest_of(lower)
    near = 0
    for height, level, node in nodes_after(0, leaf, near, cores.tree):
        if worst <= 0:
            break
        record = record_of(cores.tree.levels, level, node)
        near = lower_children(cores.lowest, record, worst) & other_children(leaf, height, level)
        if near != 0:
            near = near & bits_within(measure_boxes(cores.tree.boxes, record, a, b), cores.max_sqdist)
        if near != 0:
            inside = near & bits_within(measure_farthest(cores.tree.boxes, record, a, b), cores.max_sqdist)
            near = near ^ inside
            for child in bits_of(inside):
                lower = lower_lanes(lower, cores.lowest[record * FAN + child])
            if level == 1:
                for first, last in leaves_of(node, near, cores.tree):
                    lower = follow_leaf(lower, xs, ys, zs, first, last, cores)
            worst = largest_of(lower)
    return lower


@kernel
def label_borders_kernel(cores: Cores, labels: array(dtype=int32)):
    leaf = tid()
    head = leaf * LEAF
    xs = lanes(INFINITY)
    ys = lanes(0.0)
    zs = lanes(0.0)
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    best = numbers(NOISE)  # no label is lower, so lanes without a border point have no effect
    searching = 0
    for j, p in points_of(leaf, cores.tree):
        if cores.owners[head + j] < 0:
            xs[j] = p[0]
            ys[j] = p[1]
            zs[j] = p[2]
            a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
            b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
            best[j] = NO_NUMBER
            searching = 1
    if searching == 1:
        best = follow_cores(best, xs, ys, zs, a, b, leaf, cores)
        for j in range(LEAF):
            if best[j] >= 0 and best[j] < NO_NUMBER:
                labels[cores.tree.order[head + j]] = best[j]


@kernel
def count_labels_kernel(run: int, labels: array(dtype=int32), counts: array(dtype=int32)):
    """Count each label. Integers, so the order of the atomics does not matter."""
    i = tid()
    label = int(NOISE)
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
    label = int(NOISE)
    if int(keys[i]) < NO_NUMBER:
        label = i
    renamed[order[i]] = label


@kernel
def rename_labels_kernel(renamed: array(dtype=int32), labels: array(dtype=int32)):
    i = tid()
    if labels[i] >= 0:
        labels[i] = renamed[labels[i]]


def label_cores(cores: Cores, labels: Integers) -> int:
    """Number the clusters and label their cores in `labels` (int32, NOISE before). Return their number. One sync."""
    count, device = cores.tree.count, cores.tree.device
    firsts, marks = full(count, NO_NUMBER, int32, device), zeros(labels.size, uint8, device)
    launch(find_first_kernel, count, [cores, firsts])
    launch(mark_first_kernel, count, [cores, firsts, marks])
    heads = positions_of(marks)
    launch(number_rows_kernel, heads.size, [heads, labels])
    launch(label_cores_kernel, cores.leaf_count, [cores, firsts, labels])
    return heads.size


def rename_cores(cores: Cores, renamed: Integers, labels: Integers) -> None:
    """Relabel cores by `renamed` (NOISE removes them); borders then choose by the new order."""
    launch(rename_cores_kernel, cores.leaf_count, [renamed, cores, labels])


def label_borders(cores: Cores, labels: Integers) -> None:
    cores.lower()
    launch(label_borders_kernel, cores.leaf_count, [cores, labels])


def rank_by_size(labels: Integers, cluster_count: int, min_size: int, max_size: int) -> None:
    """Renumber clusters by decreasing size in place, ties in order. NOISE for sizes outside `min_size`..`max_size`."""
    device = labels.device
    counts, keys = zeros(cluster_count, int32, device), empty(cluster_count, int64, device)
    launch(count_labels_kernel, -(-labels.size // RUN), [RUN, labels, counts])
    launch(rank_sizes_kernel, cluster_count, [counts, min_size, max_size, keys])
    ranked, order = argsort_keys(keys, 31)
    renamed = empty(cluster_count, int32, device)
    launch(renumber_rows_kernel, cluster_count, [ranked, order, renamed])
    launch(rename_labels_kernel, labels.size, [renamed, labels])
