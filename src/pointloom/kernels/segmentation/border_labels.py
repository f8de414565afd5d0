"""Labels of the border points of DBSCAN: the lowest label of the cores within the radius.

The tree traversal skips nodes without a lower label than those found.
"""

from ..array_types import Integers
from ..arrays.lanes import max_int_of_eight, min_int_of_eight
from ..lang import INFINITY, array, ballot, cuda_func, func, int32, kernel, lane, launch, load_eight, shuffle, tid, vec3
from ..search.lane_boxes import boxes_of_eight, flags_of_any_eight, is_child_inside, is_child_near
from ..search.lane_search import sqdist_of
from ..search.point_tree import BUCKET, FAN, LEAF, measure_boxes
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
from .cluster_labels import NOISE_LABEL
from .core_sets import Cores


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
    best = numbers(NOISE_LABEL)  # no label is lower, so lanes without a border point have no effect
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


@cuda_func
def lower_by_leaf(best: int, p: vec3, first: int, cores: Cores) -> int:
    """`follow_leaf` for the lanes."""
    at = first + (lane() & (LEAF - 1))
    label = -1
    if at < cores.tree.count:
        label = cores.owners[at]
    leaf = load_eight(cores.tree.points, first)
    lower = int(best)
    for j in range(LEAF):
        other = shuffle(label, j)
        is_linked = 1 if other >= 0 and sqdist_of(leaf, j, p) <= cores.max_sqdist else 0
        lower = min(lower, other if is_linked == 1 else NO_NUMBER)
    return lower


@cuda_func
def follow_cores_of_lanes(best: int, p: vec3, bucket: int, cores: Cores) -> int:
    """`follow_cores` for the lanes: lowest label of the cores within the radius of each lane's point."""
    lower = int(best)
    worst = max_int_of_eight(lower)
    around = boxes_of_eight(p, 1 if best == NO_NUMBER else 0)
    own = lane() & (FAN - 1)
    near = 0
    for height, level, node in nodes_after(0, bucket * FAN, near, cores.tree):
        if ballot(1 if worst > 0 else 0) == 0:
            break
        record = record_of(cores.tree.levels, level, node)
        label = cores.lowest[record * FAN + own]
        is_other = (other_children(bucket * FAN, height, level) >> own) & 1
        is_lower = is_other if label < worst else 0
        is_near = is_lower & is_child_near(cores.tree.boxes, record, around, cores.max_sqdist)
        is_inside = is_near & is_child_inside(cores.tree.boxes, record, around, cores.max_sqdist)
        near = flags_of_any_eight(is_near ^ is_inside)
        lower = min(lower, min_int_of_eight(label if is_inside == 1 else NO_NUMBER))
        if level == 1:
            for first, _ in leaves_of(node, near, cores.tree):
                lower = lower_by_leaf(lower, p, first, cores)
        worst = max_int_of_eight(lower)
    return lower


@label_borders_kernel.on_cuda
def label_borders_of_lanes_kernel(cores: Cores, labels: array(dtype=int32)):
    """CUDA variant: a point per lane."""
    i = tid()
    p = cores.tree.points[min(i, cores.tree.count - 1)]
    best = int(NOISE_LABEL)  # no label is lower, so lanes without a border point have no effect
    if i < cores.tree.count:
        if cores.owners[i] < 0:
            best = NO_NUMBER
    best = follow_cores_of_lanes(best, p, i // BUCKET, cores)
    if best >= 0 and best < NO_NUMBER:
        labels[cores.tree.order[i]] = best


def label_borders(cores: Cores, labels: Integers) -> None:
    cores.lower()
    launch(label_borders_kernel, cores.threads, [cores, labels])
