"""Unite DBSCAN cores within the radius: a tree traversal from each leaf to later leaves.

The cores of a leaf already form one or a few sets (`join_lanes` of dbscan.py), each with its own traversal. Distances
are measured only between cores of different sets, so most of the traversal compares roots. The pairs measured depend on
the thread order, the sets do not.
"""

from ..arrays.union_find import find_root, flatten_sets_kernel, unite
from ..lang import INFINITY, array, func, int32, kernel, launch, struct, tid, vec3
from ..memory import empty
from ..search.point_tree import FAN, LEAF, PointTree, measure_boxes
from ..search.tree_search import squared_radius
from ..search.tree_walk import (
    FAN_BITS,
    NO_NUMBER,
    NodeNumbers,
    bits_of,
    bits_within,
    following_children,
    lanes,
    leaves_of,
    lowest_bit,
    measure_diagonals,
    measure_farthest,
    nodes_after,
    record_of,
)


@struct
class Cores:
    """Core points of a tree. `owners` (int32 by tree index, NOISE for others) are disjoint sets, then the lowest core
    of each set, then labels. `lowest` is the lowest owner below each node at record * FAN + child, or NO_NUMBER."""

    tree: PointTree
    max_sqdist: float
    owners: array(dtype=int32)
    lowest: array(dtype=int32)

    def __init__(self, tree: PointTree, eps: float) -> None:
        self.tree, self.max_sqdist = tree, squared_radius(eps)
        self.owners, self.nodes = empty(tree.count, int32, tree.device), NodeNumbers(tree)
        self.lowest, self.leaf_count = self.nodes.values, self.nodes.leaf_count

    def lower(self) -> None:
        self.nodes.lower()


@func
def dense_ancestor(leaf: int, cores: Cores) -> int:
    """Level of the highest ancestor whose points are all within the radius of each other. 0 if none."""
    level = 0
    climbing = 1
    while climbing == 1 and level < cores.tree.root:
        node = leaf >> (FAN_BITS * (level + 1))
        record = record_of(cores.tree.levels, level + 2, node >> FAN_BITS)
        dense = bits_within(measure_diagonals(cores.tree.boxes, record), cores.max_sqdist)
        if ((dense >> (node & (FAN - 1))) & 1) == 1:
            level += 1
        else:
            climbing = 0
    return level


@func
def unite_leaf(core: int, xs: lanes, ys: lanes, zs: lanes, first: int, last: int, cores: Cores):
    """Unite the set of `core` (the lanes) with the cores first..last - 1 of other sets within the radius."""
    root = find_root(cores.owners, core)
    for r in range(first, last):
        if cores.owners[r] >= 0:
            if find_root(cores.owners, r) != root:
                q = cores.tree.points[r]
                touched = 0
                for j in range(LEAF):
                    x = q[0] - xs[j]
                    y = q[1] - ys[j]
                    z = q[2] - zs[j]
                    touched = touched | (1 if x * x + y * y + z * z <= cores.max_sqdist else 0)
                if touched == 1:
                    root = unite(cores.owners, core, r)


@func
def sift_dense(children: int, core: int, record: int, a: vec3, b: vec3, cores: Cores) -> int:
    """Children of a node to enter in order to unite the set of `core` with all cores within the radius of box (a, b).
    Skips children without cores, and those known to be one set by their size: these are united here if necessary."""
    dense = bits_within(measure_diagonals(cores.tree.boxes, record), cores.max_sqdist)
    inside = bits_within(measure_farthest(cores.tree.boxes, record, a, b), cores.max_sqdist)
    root = find_root(cores.owners, core)
    entered = 0
    for child in bits_of(children):
        first = cores.lowest[record * FAN + child]
        if first != NO_NUMBER:
            wanted = 1
            if ((dense >> child) & 1) == 1:
                if find_root(cores.owners, first) == root:
                    wanted = 0
                else:
                    if ((inside >> child) & 1) == 1:
                        root = unite(cores.owners, core, first)
                        wanted = 0
            entered = entered | (wanted << child)
    return entered


@func
def set_part(candidates: int, head: int, core: int, owners: array(dtype=int32)) -> int:
    """Bit mask of a leaf's cores from rank `head` on in the set of `core`, including itself."""
    root = find_root(owners, core)
    part = 1 << (core - head)
    for j in bits_of(candidates ^ part):
        if find_root(owners, head + j) == root:
            part = part | (1 << j)
    return part


@func
def unite_part(core: int, xs: lanes, ys: lanes, zs: lanes, a: vec3, b: vec3, leaf: int, start: int, cores: Cores):
    """Unite the set of `core` with all later cores within the radius of the lanes (cores of one leaf and set with box
    (a, b)), beyond its ancestor at level `start`. Each pair is visited from its first element."""
    near = 0
    for height, level, node in nodes_after(start, leaf, near, cores.tree):
        record = record_of(cores.tree.levels, level, node)
        near = bits_within(measure_boxes(cores.tree.boxes, record, a, b), cores.max_sqdist)
        near = near & following_children(leaf, height, level)
        if near != 0:
            near = sift_dense(near, core, record, a, b, cores)
            if level == 1:
                for first, last in leaves_of(node, near, cores.tree):
                    unite_leaf(core, xs, ys, zs, first, last, cores)


@kernel(max_registers=80)
def unite_cores_kernel(cores: Cores):
    leaf = tid()
    head = leaf * LEAF
    start = 0
    left = 0
    if cores.lowest[leaf] != NO_NUMBER:
        start = dense_ancestor(leaf, cores)
        if start > 0:
            node = leaf >> (FAN_BITS * start)
            unite(cores.owners, cores.lowest[leaf], cores.lowest[cores.tree.levels[start] * FAN + node])
        for j in range(min(LEAF, cores.tree.count - head)):
            if cores.owners[head + j] >= 0:
                left = left | (1 << j)
    while left != 0:
        core = head + lowest_bit(left)
        part = set_part(left, head, core, cores.owners)
        left = left ^ part
        xs = lanes(INFINITY)
        ys = lanes(0.0)
        zs = lanes(0.0)
        a = cores.tree.points[core]
        b = a + vec3(0.0, 0.0, 0.0)
        for j in range(LEAF):
            if ((part >> j) & 1) == 1:
                p = cores.tree.points[head + j]
                xs[j] = p[0]
                ys[j] = p[1]
                zs[j] = p[2]
                a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
                b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
        unite_part(core, xs, ys, zs, a, b, leaf, start, cores)


def unite_cores(cores: Cores) -> None:
    """Unite all cores within the radius of each other. Each then stores the lowest core of its set."""
    launch(unite_cores_kernel, cores.leaf_count, [cores])
    launch(flatten_sets_kernel, cores.tree.count, [cores.owners])
