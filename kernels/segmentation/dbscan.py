"""DBSCAN in O(n) memory: which points are cores, which cores belong together, whom the other points follow.

Ester et al., "A density-based algorithm for discovering clusters in large spatial databases with noise", KDD 1996. No
neighbour is listed and no distance stored: three walks through the tree for each leaf (tree_walk.py), two here and one
for the borders (cluster_labels.py), and a forest of disjoint sets (union_find.py), after Prokopenko et al., "Fast
tree-based algorithms for DBSCAN for low-dimensional data on GPUs", ICPP 2023. The time stays bounded where a ball holds
most of the cloud:

- Counting stops once all points of a leaf are cores, and takes nodes that lie wholly within reach by their size.
- A node whose diagonal is within reach holds cores of one set only, whatever lies around it. One link to it is enough,
  and none is needed where it shares the leaf's set already; nor is an edge between two leaves of one set measured.
- The lowest label wins at a border, so only nodes that hold a lower one than those found are entered.

All work is done in the order of the tree. A set's root is its lowest rank there; a cluster's number is that of its
first core in the cloud, so labels do not depend on the tree. 14 B a point beside the tree, 22 B on CUDA.
"""

from ..array_types import Integers
from ..lang import INFINITY, array, func, int32, kernel, launch, tid, vec3
from ..memory import full
from ..search.point_tree import LEAF, PointTree, measure_boxes
from ..search.tree_walk import (
    NO_NUMBER,
    bits_within,
    box_corner,
    lanes,
    leaves_of,
    lowest_bit,
    measure_farthest,
    nodes_after,
    numbers,
    other_children,
    point_sum,
    points_of,
    record_of,
)
from .cluster_labels import NOISE, label_borders, label_cores
from .core_sets import Cores, unite_cores

MANY = 2**30  # counts end here; a sum that saturates is left to the lanes, a plain one LLVM spreads over the points


@func
def count_leaf(
    counts: numbers, xs: lanes, ys: lanes, zs: lanes, first: int, last: int, points: array(dtype=vec3), reach: float
) -> numbers:
    """The counts with the points first..last - 1 that lie within reach of each lane."""
    total = counts
    for r in range(first, last):
        q = points[r]
        for j in range(LEAF):
            x = q[0] - xs[j]
            y = q[1] - ys[j]
            z = q[2] - zs[j]
            total[j] = min(total[j] + (1 if x * x + y * y + z * z <= reach else 0), MANY)
    return total


@func
def join_lanes(xs: lanes, ys: lanes, zs: lanes, reach: float) -> numbers:
    """The lowest lane, as a bit, that each lane hangs together with by steps within reach; lanes at infinity are alone.

    Lane by lane and without branches: the sets of all lanes within its reach become one.
    """
    heads = numbers(0)
    for j in range(LEAF):
        heads[j] = 1 << j
    for k in range(LEAF):
        touched = 0
        for j in range(LEAF):
            x = xs[k] - xs[j]
            y = ys[k] - ys[j]
            z = zs[k] - zs[j]
            touched = touched | (heads[j] if x * x + y * y + z * z <= reach else 0)
        lowest = touched & (-touched)
        for j in range(LEAF):
            heads[j] = lowest if (heads[j] & touched) != 0 else heads[j]
    return heads


@func
def least_of(values: numbers) -> int:
    """The least of eight numbers."""
    least = values[0]
    for j in range(1, LEAF):
        least = min(least, values[j])
    return least


@func
def count_group(counts: numbers, xs: lanes, ys: lanes, zs: lanes, leaf: int, tree: PointTree, reach: float) -> numbers:
    """The counts with the points within reach of each point of a leaf; once none is negative the rest is left out."""
    total = counts
    a = box_corner(tree.boxes, leaf, 0)
    b = box_corner(tree.boxes, leaf, 1)
    near = 0
    for height, level, node in nodes_after(0, leaf, near, tree):
        if least_of(total) >= 0:
            break
        record = record_of(tree.levels, level, node)
        near = bits_within(measure_boxes(tree.boxes, record, a, b), reach) & other_children(leaf, height, level)
        if near != 0:
            inside = near & bits_within(measure_farthest(tree.boxes, record, a, b), reach)
            if inside != 0:
                total += numbers(point_sum(inside, level, node, tree.count))
                near = near ^ inside
            if level == 1:
                for first, last in leaves_of(node, near, tree):
                    total = count_leaf(total, xs, ys, zs, first, last, tree.points, reach)
    return total


@kernel(most_registers=80)
def find_cores_kernel(cores: Cores, needed: int):
    """Link each core of a leaf to the lowest core that it hangs together with there; other points to NOISE.

    A core has `needed` points within reach. The leaf's lowest core goes to `cores.lowest`.
    """
    leaf = tid()
    head = leaf * LEAF
    xs = lanes(INFINITY)
    ys = lanes(0.0)
    zs = lanes(0.0)
    counts = numbers(0)
    for j, p in points_of(leaf, cores.tree):
        xs[j] = p[0]
        ys[j] = p[1]
        zs[j] = p[2]
        counts[j] = -needed
    counts = count_group(counts, xs, ys, zs, leaf, cores.tree, cores.reach)
    for j in range(LEAF):
        if counts[j] < 0:
            xs[j] = INFINITY
    heads = join_lanes(xs, ys, zs, cores.reach)
    least = int(NO_NUMBER)
    for j in range(LEAF):
        if head + j < cores.tree.count:
            owner = int(NOISE)
            if counts[j] >= 0:
                owner = head + lowest_bit(heads[j])
                least = min(least, head + j)
            cores.owners[head + j] = owner
    cores.lowest[leaf] = least


def join_cores(tree: PointTree, eps: float, min_points: int) -> Cores:
    """The Cores of a cloud, each with the lowest core of its set.

    Args:
        tree: A PointTree with at least one finite point.
        eps: Points closer than this are neighbours [m].
        min_points: Neighbours that make a point a core, itself included.
    """
    cores = Cores(tree, eps)
    needed = 0 if min_points == 1 else min(min_points, tree.count + 1)  # every point is its own neighbour
    launch(find_cores_kernel, cores.leaf_count, [cores, needed])
    cores.lower()
    unite_cores(cores)
    return cores


def cluster_cores(tree: PointTree, eps: float, min_points: int, labels: Integers) -> tuple[Cores, int]:
    """The labels of DBSCAN's cores, without the points at their borders.

    Args:
        tree: A PointTree with at least one finite point.
        eps: Points closer than this are neighbours [m].
        min_points: Neighbours that make a point a core, itself included.
        labels: int32 device array in the cloud's order, filled with NOISE; gets the labels.

    Returns:
        (cores with their labels, number of clusters), from which `label_borders` goes on.
    """
    cores = join_cores(tree, eps, min_points)
    return cores, label_cores(cores, labels)


def cluster_points(tree: PointTree, point_count: int, eps: float, min_points: int) -> tuple[Integers, int]:
    """The labels of DBSCAN.

    Args:
        tree: A PointTree.
        point_count: Points of the cloud, those that are not finite included.
        eps: Points closer than this are neighbours [m].
        min_points: Neighbours that make a point a core, itself included.

    Returns:
        (labels, number of clusters): int32 device array in the cloud's order, shape [point_count]; NOISE for points of
        no cluster.
    """
    labels = full(point_count, NOISE, int32, tree.device)
    if tree.count == 0:
        return labels, 0
    cores, cluster_count = cluster_cores(tree, eps, min_points, labels)
    if cluster_count and min_points > 1:
        label_borders(cores, labels)
    return labels, cluster_count
