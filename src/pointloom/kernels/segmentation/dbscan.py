"""DBSCAN with O(n) memory by tree traversals per leaf and disjoint sets.

Ester et al., KDD 1996. Prokopenko et al., "Fast tree-based algorithms for DBSCAN for low-dimensional data on GPUs",
ICPP 2023. Counting stops once all points of a leaf are cores. Nodes with a diagonal within the radius contain one set
of cores, so one link suffices. A cluster's number is that of its first core in the cloud. 14 B per point beside the
tree, 22 B on CUDA.
"""

from ..array_types import Integers
from ..arrays.packed_keys import BYTE_MASK
from ..lang import (
    INFINITY,
    array,
    ballot,
    bit_count,
    cuda_func,
    func,
    int32,
    kernel,
    lane,
    launch,
    load_eight,
    shuffle,
    tid,
    vec2i,
    vec3,
)
from ..memory import full
from ..search.lane_boxes import (
    boxes_of_eight,
    flags_of_any_eight,
    flags_of_eight,
    is_child_inside,
    is_child_near,
    point_of_lane,
    two_boxes,
)
from ..search.lane_search import sqdist_of
from ..search.point_tree import BUCKET, FAN, LEAF, PointTree, measure_boxes, square_distance
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
from .border_labels import label_borders
from .cluster_labels import NOISE_LABEL, label_cores
from .core_sets import Cores, unite_cores

MAX_LANE_COUNT = 2**30  # counts saturate here per lane. LLVM would vectorize a plain sum over the points instead


@func
def count_leaf(
    counts: numbers,
    xs: lanes,
    ys: lanes,
    zs: lanes,
    first: int,
    last: int,
    points: array(dtype=vec3),
    max_sqdist: float,
) -> numbers:
    """Add the points first..last - 1 within the radius of each lane to its count."""
    total = counts
    for r in range(first, last):
        q = points[r]
        for j in range(LEAF):
            x = q[0] - xs[j]
            y = q[1] - ys[j]
            z = q[2] - zs[j]
            total[j] = min(total[j] + (1 if x * x + y * y + z * z <= max_sqdist else 0), MAX_LANE_COUNT)
    return total


@func
def join_lanes(xs: lanes, ys: lanes, zs: lanes, max_sqdist: float) -> numbers:
    """Lowest lane, as a bit, connected to each lane by steps within the radius; branch-free. Unused lanes are inf."""
    heads = numbers(0)
    for j in range(LEAF):
        heads[j] = 1 << j
    for k in range(LEAF):
        touched = 0
        for j in range(LEAF):
            x = xs[k] - xs[j]
            y = ys[k] - ys[j]
            z = zs[k] - zs[j]
            touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)
        lowest = touched & (-touched)
        for j in range(LEAF):
            heads[j] = lowest if (heads[j] & touched) != 0 else heads[j]
    return heads


@func
def minimum_of(values: numbers) -> int:
    minimum = values[0]
    for j in range(1, LEAF):
        minimum = min(minimum, values[j])
    return minimum


@func
def count_group(
    counts: numbers, xs: lanes, ys: lanes, zs: lanes, leaf: int, tree: PointTree, max_sqdist: float
) -> numbers:
    """Add all points within the radius of a leaf's points to the counts, until none is negative."""
    total = counts
    a = box_corner(tree.boxes, leaf, 0)
    b = box_corner(tree.boxes, leaf, 1)
    near = 0
    for height, level, node in nodes_after(0, leaf, near, tree):
        if minimum_of(total) >= 0:
            break
        record = record_of(tree.levels, level, node)
        near = bits_within(measure_boxes(tree.boxes, record, a, b), max_sqdist) & other_children(leaf, height, level)
        if near != 0:
            inside = near & bits_within(measure_farthest(tree.boxes, record, a, b), max_sqdist)
            if inside != 0:
                total += numbers(point_sum(inside, level, node, tree.count))
                near = near ^ inside
            if level == 1:
                for first, last in leaves_of(node, near, tree):
                    total = count_leaf(total, xs, ys, zs, first, last, tree.points, max_sqdist)
    return total


@kernel(max_registers=80)
def find_cores_kernel(cores: Cores, needed: int):
    """Link each core of a leaf (`needed` points in the radius) to its lowest connected core, others to NOISE_LABEL."""
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
    counts = count_group(counts, xs, ys, zs, leaf, cores.tree, cores.max_sqdist)
    for j in range(LEAF):
        if counts[j] < 0:
            xs[j] = INFINITY
    heads = join_lanes(xs, ys, zs, cores.max_sqdist)
    lowest = int(NO_NUMBER)
    for j in range(LEAF):
        if head + j < cores.tree.count:
            owner = int(NOISE_LABEL)
            if counts[j] >= 0:
                owner = head + lowest_bit(heads[j])
                lowest = min(lowest, head + j)
            cores.owners[head + j] = owner
    cores.lowest[leaf] = lowest


@cuda_func
def count_lacking(p: vec3, needed: int, bucket: int, tree: PointTree, max_sqdist: float) -> vec2i:
    """(`needed` minus points within the radius of each lane's point, leaves measured by the warp). The points are in a
    bucket. Counting stops once no lane lacks points.

    Nodes near the lanes that still lack points are entered. Nodes within their radius are counted without, unless other
    leaves of the warp enter them.
    """
    lacking = int(needed)
    measured = 0
    searching = 0
    around = two_boxes(0.0)
    near = 0
    for height, level, node in nodes_after(0, bucket * FAN, near, tree):
        left = ballot(1 if lacking > 0 else 0)
        if left == 0:
            break
        if left != searching:
            searching = left + 0
            around = boxes_of_eight(p, 1 if lacking > 0 else 0)
        record = record_of(tree.levels, level, node)
        others = other_children(bucket * FAN, height, level)
        is_near = is_child_near(tree.boxes, record, around, max_sqdist)
        is_inside = is_near & is_child_inside(tree.boxes, record, around, max_sqdist)
        near = flags_of_any_eight(is_near ^ is_inside) & others
        lacking -= point_sum(flags_of_eight(is_inside) & others & (BYTE_MASK - near), level, node, tree.count)
        if level == 1:
            measured += bit_count(near)
            for first, _ in leaves_of(node, near, tree):
                leaf = load_eight(tree.points, first)
                for j in range(LEAF):
                    lacking -= 1 if sqdist_of(leaf, j, p) <= max_sqdist else 0
    return vec2i(lacking, measured)


@cuda_func
def cores_of_set(p: vec3, is_core: int, max_sqdist: float) -> int:
    """The cores among the own eight lanes connected to each by steps within the radius, as bits. 0 for other lanes."""
    first = lane() - (lane() & (LEAF - 1))
    linked = 0
    for j in range(LEAF):
        linked = linked | ((1 << j) if square_distance(p, point_of_lane(p, first + j)) <= max_sqdist else 0)
    cores = flags_of_eight(is_core)
    linked = linked & cores if is_core == 1 else 0
    for j in range(LEAF):  # Warshall, "A theorem on Boolean matrices", 1962
        beyond = shuffle(linked, first + j)
        linked = linked | (beyond if ((linked >> j) & 1) == 1 else 0)
    return linked


@find_cores_kernel.on_cuda
def find_cores_of_lanes_kernel(cores: Cores, needed: int):
    """CUDA variant: a point per lane. A warp has four leaves of one bucket."""
    i = tid()
    p = cores.tree.points[min(i, cores.tree.count - 1)]
    counted = count_lacking(p, needed, i // BUCKET, cores.tree, cores.max_sqdist)
    is_core = 1 if counted[0] <= 0 and i < cores.tree.count else 0
    linked = cores_of_set(p, is_core, cores.max_sqdist)
    cores_of_leaf = flags_of_eight(is_core)
    head = i - i % LEAF
    if i < cores.tree.count:
        cores.owners[i] = head + lowest_bit(linked) if is_core == 1 else NOISE_LABEL
        if i == head:
            cores.lowest[i // LEAF] = head + lowest_bit(cores_of_leaf) if cores_of_leaf != 0 else NO_NUMBER


def join_cores(tree: PointTree, eps: float, min_points: int) -> Cores:
    """Core points (`min_points` within `eps` [m], including itself), each with the lowest core of its set."""
    cores = Cores(tree, eps)
    needed = 0 if min_points == 1 else min(min_points, tree.count + 1)  # every point is its own neighbor
    launch(find_cores_kernel, cores.threads, [cores, needed])
    cores.lower()
    unite_cores(cores)
    return cores


def cluster_cores(tree: PointTree, eps: float, min_points: int, labels: Integers) -> tuple[Cores, int]:
    """Label cores in `labels` (int32, NOISE_LABEL before), not borders. Return (cores, count) for `label_borders`."""
    cores = join_cores(tree, eps, min_points)
    return cores, label_cores(cores, labels)


def cluster_points(tree: PointTree, point_count: int, eps: float, min_points: int) -> tuple[Integers, int]:
    """DBSCAN labels (int32 in cloud order, NOISE_LABEL for none) and the number of clusters."""
    labels = full(point_count, NOISE_LABEL, int32, tree.device)
    if tree.count == 0:
        return labels, 0
    cores, cluster_count = cluster_cores(tree, eps, min_points, labels)
    if cluster_count and min_points > 1:
        label_borders(cores, labels)
    return labels, cluster_count
