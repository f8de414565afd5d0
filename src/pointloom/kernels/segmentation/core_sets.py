"""Unite DBSCAN cores within the radius: a tree traversal from each leaf to later leaves.

The cores of a leaf already form one or a few sets (`join_lanes` of dbscan.py), each with its own traversal. Distances
are measured only between cores of different sets, so most of the traversal compares roots. The pairs measured depend on
the thread order, the sets do not.
"""

from ..arrays.lanes import bits_of_lanes
from ..arrays.packed_keys import BYTE_MASK
from ..arrays.union_find import find_root, flatten_sets_kernel, hook_roots, unite
from ..lang import (
    INFINITY,
    array,
    ballot,
    cuda_func,
    func,
    int32,
    kernel,
    lane,
    launch,
    load_eight,
    shuffle,
    struct,
    tid,
    vec2i,
    vec3,
)
from ..memory import empty
from ..search.lane_boxes import boxes_of_eight, flags_of_eight, is_child_inside, is_child_near, two_boxes
from ..search.lane_search import sqdist_of
from ..search.point_tree import BUCKET, FAN, LEAF, PointTree, measure_boxes
from ..search.tree_search import squared_radius
from ..search.tree_walk import (
    FAN_BITS,
    NO_NUMBER,
    NodeNumbers,
    bits_of,
    bits_within,
    following_children,
    lanes,
    leaf_threads,
    leaves_of,
    lowest_bit,
    measure_diagonal,
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
        self.threads = leaf_threads(tree)

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
        if measure_diagonal(cores.tree.boxes, record, node & (FAN - 1)) <= cores.max_sqdist:
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


@cuda_func
def unlike(root: int, others: int) -> int:
    """Which of eight sets, one per lane (-1 for none), differ from the lane's set `root`, as bits. 0 if that is -1."""
    common = shuffle(root, lowest_bit(ballot(1 if root >= 0 else 0)))
    bits = 0
    if ballot(1 if (root >= 0 and root != common) or (others >= 0 and others != common) else 0) != 0:
        for j in range(FAN):
            other = shuffle(others, j)
            bits = bits | ((1 << j) if root >= 0 and other >= 0 and other != root else 0)
    return bits


@cuda_func
def find_other(first: int, owners: array(dtype=int32)) -> int:
    """Root of the set of a core, -1 for NO_NUMBER or no core."""
    root = -1
    if first != NO_NUMBER:
        if owners[first] >= 0:
            root = find_root(owners, first)
    return root


@cuda_func
def unite_touching(root: int, others: int, touching: int, owners: array(dtype=int32)) -> vec2i:
    """Unite each lane's set with those of eight sets whose bits are set in `touching`. Returns recent roots of both.

    One lane at a time, whose result all lanes share, so that a pair of sets needs one atomic instead of one per lane.
    """
    own = int(root)
    theirs = int(others)
    left = touching & unlike(own, theirs)
    searching = ballot(left)
    while searching != 0:
        leader = lowest_bit(searching)
        a = shuffle(own, leader)
        b = shuffle(theirs, shuffle(lowest_bit(left), leader))
        joined = int(a)
        if lane() == leader:
            joined = hook_roots(owners, a, b)
        joined = shuffle(joined, leader)
        own = joined if own == a or own == b else own
        theirs = joined if theirs == a or theirs == b else theirs
        left = left & unlike(own, theirs)
        searching = ballot(left)
    return vec2i(own, theirs)


@cuda_func
def unite_leaf_of_lanes(p: vec3, root: int, first: int, cores: Cores) -> int:
    """Unite each lane's set with those of the cores of a leaf within the radius of its point. Returns a recent root."""
    at = first + (lane() & (LEAF - 1))
    others = find_other(at if at < cores.tree.count else NO_NUMBER, cores.owners)
    touching = unlike(root, others)
    roots = vec2i(root, others)
    if ballot(touching) != 0:
        leaf = load_eight(cores.tree.points, first)
        near = 0
        for j in range(LEAF):
            near = near | ((1 << j) if sqdist_of(leaf, j, p) <= cores.max_sqdist else 0)
        roots = unite_touching(root, others, touching & near, cores.owners)
    return roots[0]


@cuda_func
def sift_children(around: two_boxes, root: int, level: int, record: int, later: int, cores: Cores) -> vec2i:
    """`sift_dense` for the lanes: children to enter, and a recent root. `later`: the lane's bit mask of children after
    its leaf. Leaves are measured even if they are within the radius as a whole, which is faster."""
    child = lane() & (FAN - 1)
    near = flags_of_eight(is_child_near(cores.tree.boxes, record, around, cores.max_sqdist)) & later
    is_dense = 1 if measure_diagonal(cores.tree.boxes, record, child) <= cores.max_sqdist else 0
    first = cores.lowest[record * FAN + child]
    mixed = ballot(1 if first != NO_NUMBER and is_dense == 0 else 0) & BYTE_MASK
    others = find_other(first if is_dense == 1 else NO_NUMBER, cores.owners)
    roots = vec2i(root, others)
    if level > 1:
        inside = flags_of_eight(is_child_inside(cores.tree.boxes, record, around, cores.max_sqdist))
        roots = unite_touching(root, others, near & inside, cores.owners)
    return vec2i(bits_of_lanes(near & (mixed | unlike(roots[0], roots[1]))), roots[0])


@unite_cores_kernel.on_cuda
def unite_cores_of_lanes_kernel(cores: Cores):
    """CUDA variant: a core per lane. The four leaves of a warp are in one bucket, so they have the same ancestors."""
    i = tid()
    leaf = i // LEAF
    bucket = i // BUCKET
    p = cores.tree.points[min(i, cores.tree.count - 1)]
    root = -1
    if i < cores.tree.count:
        root = find_other(i, cores.owners)
    start = dense_ancestor(bucket * FAN, cores)
    joined = int(root)
    if start > 0 and i % LEAF == 0 and cores.lowest[leaf] != NO_NUMBER:
        node = leaf >> (FAN_BITS * start)
        joined = unite(cores.owners, cores.lowest[leaf], cores.lowest[cores.tree.levels[start] * FAN + node])
    joined = shuffle(joined, lane() - i % LEAF)
    if start > 0 and root >= 0:
        root = joined  # the cores of a leaf within a dense node are one set
    around = boxes_of_eight(p, 1 if root >= 0 else 0)
    near = 0
    for height, level, node in nodes_after(start, bucket * FAN, near, cores.tree):
        if root >= 0:
            root = find_root(cores.owners, root)
        record = record_of(cores.tree.levels, level, node)
        sifted = sift_children(around, root, level, record, following_children(leaf, height, level), cores)
        near = sifted[0]
        root = sifted[1]
        if level == 1:
            for first, _ in leaves_of(node, near, cores.tree):
                root = unite_leaf_of_lanes(p, root, first, cores)


def unite_cores(cores: Cores) -> None:
    """Unite all cores within the radius of each other. Each then stores the lowest core of its set."""
    launch(unite_cores_kernel, cores.threads, [cores])
    launch(flatten_sets_kernel, cores.tree.count, [cores.owners])
