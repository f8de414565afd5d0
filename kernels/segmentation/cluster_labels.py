"""Labels of clusters from disjoint sets of cores: numbers, the points at their borders, sizes.

Numbers are those of the first core of each cluster in the cloud's order. A border point, within reach of a core but
none itself, takes the lowest label of those cores. The walk of a leaf's border points enters only nodes that hold a
lower label than the worst found, and takes the lowest label of a node that lies wholly within reach as it stands.
"""

from ..arrays.select import positions_of
from ..arrays.sort import argsort_keys
from ..lang import (
    INFINITY,
    array,
    atomic_add,
    atomic_min,
    func,
    int32,
    int64,
    kernel,
    launch,
    tid,
    uint8,
    vec3,
)
from ..memory import empty, full, zeros
from ..search.point_tree import BYTE, FAN, LEAF, PointTree, measure_boxes
from ..search.tree_search import reach_of
from ..search.tree_walk import (
    FAN_BITS,
    NO_NUMBER,
    NodeNumbers,
    begin_walk,
    bits_within,
    lanes,
    lowest_bit,
    measure_farthest,
    next_node,
    numbers,
    own_child,
    put_off,
    record_of,
)

NOISE = -1
RUN = 64  # labels a thread counts; those of neighbours on the curve are mostly equal, so a run is one atomic


@kernel
def find_first_kernel(order: array(dtype=int32), parents: array(dtype=int32), firsts: array(dtype=int32)):
    """The lowest index in the cloud of each set's cores, at its root."""
    i = tid()
    root = parents[i]
    if root >= 0:
        if order[i] < firsts[root]:
            atomic_min(firsts, root, order[i])  # settles which of a set's cores comes first in the cloud


@kernel
def mark_first_kernel(parents: array(dtype=int32), firsts: array(dtype=int32), marks: array(dtype=uint8)):
    """1 at the first core of each set, in the order of the cloud."""
    i = tid()
    if parents[i] == i:
        marks[firsts[i]] = uint8(1)


@kernel
def number_clusters_kernel(heads: array(dtype=int32), labels: array(dtype=int32)):
    """The cluster's number at its first core."""
    i = tid()
    labels[heads[i]] = i


@kernel
def label_cores_kernel(
    count: int,
    order: array(dtype=int32),
    firsts: array(dtype=int32),
    parents: array(dtype=int32),
    labels: array(dtype=int32),
    lowest: array(dtype=int32),
):
    """The label of each core of a leaf, in the cloud's order and, in place of its root, in the tree's.

    `lowest` gets the lowest label of the leaf. The label of a set's first core is there already.
    """
    leaf = tid()
    least = int(NO_NUMBER)
    for rank in range(leaf * LEAF, min((leaf + 1) * LEAF, count)):
        root = parents[rank]
        if root >= 0:
            first = firsts[root]
            label = labels[first]
            if order[rank] != first:
                labels[order[rank]] = label
            parents[rank] = label
            least = min(least, label)
    lowest[leaf] = least


@func
def lower_lanes(best: numbers, value: int) -> numbers:
    """The lower of each lane's number and a value."""
    lower = numbers(0)
    for j in range(LEAF):
        lower[j] = min(best[j], value)
    return lower


@func
def largest_of(values: numbers) -> int:
    """The largest of eight numbers."""
    largest = values[0]
    for j in range(1, LEAF):
        largest = max(largest, values[j])
    return largest


@func
def follow_leaf(
    best: numbers,
    xs: lanes,
    ys: lanes,
    zs: lanes,
    first: int,
    last: int,
    points: array(dtype=vec3),
    ranked: array(dtype=int32),
    reach: float,
) -> numbers:
    """The lower of each lane's label and those of the cores first..last - 1 within its reach."""
    lower = best + numbers(0)
    for r in range(first, last):
        label = ranked[r]
        if label >= 0:
            q = points[r]
            for j in range(LEAF):
                x = q[0] - xs[j]
                y = q[1] - ys[j]
                z = q[2] - zs[j]
                lower[j] = min(lower[j], label if x * x + y * y + z * z <= reach else NO_NUMBER)
    return lower


@func
def lower_children(lowest: array(dtype=int32), record: int, label: int) -> int:
    """A byte: bit j is set where child j of a node holds a label below this one."""
    found = int(0)
    for j in range(FAN):
        found = found | ((1 << j) if lowest[record * FAN + j] < label else 0)
    return found


@func
def follow_cores(
    best: numbers,
    xs: lanes,
    ys: lanes,
    zs: lanes,
    a: vec3,
    b: vec3,
    leaf: int,
    tree: PointTree,
    reach: float,
    lowest: array(dtype=int32),
    ranked: array(dtype=int32),
) -> numbers:
    """The lowest label of the cores within reach of each lane; (a, b) is the box of those that search."""
    lower = best + numbers(0)
    worst = largest_of(lower)
    step = begin_walk(1, leaf >> FAN_BITS)
    while int(step[0]) <= tree.root + 1 and worst > 0:
        level = int(step[1])
        node = int(step[2])
        record = record_of(tree.levels, level, node)
        near = lower_children(lowest, record, worst)
        if level > 1 and level == int(step[0]):
            near = near & (BYTE - (1 << own_child(leaf, level)))
        if near != 0:
            near = near & bits_within(measure_boxes(tree.boxes, record, a, b), reach)
        if near != 0:
            inside = near & bits_within(measure_farthest(tree.boxes, record, a, b), reach)
            near = near ^ inside
            while inside != 0:
                lower = lower_lanes(lower, lowest[record * FAN + lowest_bit(inside)])
                inside = inside & (inside - 1)
            if level > 1:
                step = put_off(step, near)
            else:
                while near != 0:
                    first = (node * FAN + lowest_bit(near)) * LEAF
                    lower = follow_leaf(
                        lower, xs, ys, zs, first, min(first + LEAF, tree.count), tree.points, ranked, reach
                    )
                    near = near & (near - 1)
            worst = largest_of(lower)
        step = next_node(step, tree.root + 1)
    return lower


@kernel
def label_borders_kernel(
    tree: PointTree,
    reach: float,
    ranked: array(dtype=int32),
    lowest: array(dtype=int32),
    labels: array(dtype=int32),
):
    """The labels of the points of a leaf that are no cores."""
    leaf = tid()
    head = leaf * LEAF
    xs = lanes(INFINITY)
    ys = lanes(0.0)
    zs = lanes(0.0)
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    best = numbers(NOISE)  # no label is lower, so lanes without a border point neither change nor wait
    searching = int(0)
    for j in range(LEAF):
        if head + j < tree.count:
            if ranked[head + j] < 0:
                p = tree.points[head + j]
                xs[j] = p[0]
                ys[j] = p[1]
                zs[j] = p[2]
                a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
                b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
                best[j] = NO_NUMBER
                searching = 1
    if searching == 1:
        best = follow_cores(best, xs, ys, zs, a, b, leaf, tree, reach, lowest, ranked)
        for j in range(LEAF):
            if best[j] >= 0 and best[j] < NO_NUMBER:
                labels[tree.order[head + j]] = best[j]


# ------------------------------------------------------------------------------------------------ sizes


@kernel
def count_labels_kernel(run: int, labels: array(dtype=int32), counts: array(dtype=int32)):
    """How often each label occurs; whole numbers, so the order of the atomics does not matter."""
    i = tid()
    label = int(NOISE)
    held = int(0)
    for j in range(i * run, min((i + 1) * run, labels.shape[0])):
        if labels[j] == label:
            held += 1
        else:
            if label >= 0:
                atomic_add(counts, label, held)
            label = labels[j]
            held = 1
    if label >= 0:
        atomic_add(counts, label, held)


@kernel
def rank_sizes_kernel(counts: array(dtype=int32), least: int, most: int, keys: array(dtype=int64)):
    """Keys in whose order the largest clusters come first, and those of other sizes last."""
    i = tid()
    key = int(NO_NUMBER)
    if counts[i] >= least and counts[i] <= most:
        key = NO_NUMBER - counts[i]
    keys[i] = int64(key)


@kernel
def renumber_clusters_kernel(keys: array(dtype=int64), order: array(dtype=int32), renamed: array(dtype=int32)):
    """The new number of each cluster; NOISE for those of other sizes."""
    i = tid()
    label = int(NOISE)
    if int(keys[i]) < NO_NUMBER:
        label = i
    renamed[order[i]] = label


@kernel
def rename_labels_kernel(renamed: array(dtype=int32), labels: array(dtype=int32)):
    """Each label's new number, in place."""
    i = tid()
    if labels[i] >= 0:
        labels[i] = renamed[labels[i]]


# ------------------------------------------------------------------------------------------------ host


def label_cores(tree, parents, labels):
    """Number the clusters and label their cores.

    Args:
        tree: A PointTree.
        parents: int32 device array in the tree's order: the lowest core of each core's set, NOISE for other points.
            Gets the labels in its place.
        labels: int32 device array in the cloud's order, filled with NOISE; gets the labels.

    Returns:
        (lowest labels of the tree's nodes, number of clusters); one sync.
    """
    firsts, marks = full(tree.count, NO_NUMBER, int32, tree.device), zeros(labels.size, uint8, tree.device)
    launch(find_first_kernel, tree.count, [tree.order, parents, firsts])
    launch(mark_first_kernel, tree.count, [parents, firsts, marks])
    heads = positions_of(marks)
    launch(number_clusters_kernel, heads.size, [heads, labels])
    lowest = NodeNumbers(tree)
    arguments = [tree.count, tree.order, firsts, parents, labels, lowest.values]
    launch(label_cores_kernel, lowest.leaf_count, arguments)
    return lowest, heads.size


def label_borders(tree, eps, ranked, lowest, labels):
    """Label the points within `eps` of a core that are none themselves.

    Args:
        tree: A PointTree.
        eps: Points closer than this are neighbours [m].
        ranked: int32 device array in the tree's order: the labels of cores, NOISE for other points.
        lowest: The lowest labels of the tree's leaves.
        labels: int32 device array in the cloud's order; gets the labels.
    """
    lowest.lower()
    launch(label_borders_kernel, lowest.leaf_count, [tree, reach_of(eps), ranked, lowest.values, labels])


def rank_by_size(labels, cluster_count, least, most):
    """Number clusters by size, the largest first, ties in their order, in place; NOISE for those of other sizes.

    Args:
        labels: int32 device array of labels 0..cluster_count - 1, or below zero.
        cluster_count: Clusters.
        least, most: The sizes that are kept.
    """
    device = labels.device
    counts, keys = zeros(cluster_count, int32, device), empty(cluster_count, int64, device)
    launch(count_labels_kernel, -(-labels.size // RUN), [RUN, labels, counts])
    launch(rank_sizes_kernel, cluster_count, [counts, least, most, keys])
    ranked, order = argsort_keys(keys, 31)
    renamed = empty(cluster_count, int32, device)
    launch(renumber_clusters_kernel, cluster_count, [ranked, order, renamed])
    launch(rename_labels_kernel, labels.size, [renamed, labels])
