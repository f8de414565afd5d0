"""Cores within reach of each other become one set: the walk of DBSCAN that goes from each leaf to all that follow it.

Only leaves later in the tree are visited, so a pair is seen once. A leaf's cores are one set already, or a few, each of
which walks alone with a box of its own: `join_lanes` of dbscan.py saw to that. An edge is measured only between cores
whose sets differ at that moment, so most of the walk is a comparison of roots; which edges are measured depends on the
threads, the sets do not.
"""

from ..arrays.union_find import find_root, unite
from ..lang import INFINITY, array, float32, func, int32, kernel, tid, vec3
from ..search.point_tree import BYTE, FAN, LEAF, PointTree, measure_boxes
from ..search.tree_walk import (
    FAN_BITS,
    NO_NUMBER,
    begin_walk,
    bits_within,
    lanes,
    lowest_bit,
    measure_diagonals,
    measure_farthest,
    next_node,
    own_child,
    put_off,
    record_of,
)


@func
def dense_ancestor(leaf: int, tree: PointTree, reach: float) -> int:
    """The level of the highest node above a leaf whose points all lie within reach of each other; 0 where none is."""
    level = int(0)
    climbing = int(1)
    while climbing == 1 and level < tree.root:
        node = leaf >> (FAN_BITS * (level + 1))
        dense = bits_within(measure_diagonals(tree.boxes, record_of(tree.levels, level + 2, node >> FAN_BITS)), reach)
        if ((dense >> (node & (FAN - 1))) & 1) == 1:
            level += 1
        else:
            climbing = 0
    return level


@func
def unite_leaf(
    core: int,
    xs: lanes,
    ys: lanes,
    zs: lanes,
    first: int,
    last: int,
    points: array(dtype=vec3),
    reach: float,
    parents: array(dtype=int32),
) -> int:
    """Unite the set of `core`, some of whose points are the lanes, with those of the cores first..last - 1 in reach.

    Cores that are in the set already are not measured.
    """
    root = find_root(parents, core)
    for r in range(first, last):
        if parents[r] >= 0:
            if find_root(parents, r) != root:
                q = points[r]
                touched = int(0)
                for j in range(LEAF):
                    x = q[0] - xs[j]
                    y = q[1] - ys[j]
                    z = q[2] - zs[j]
                    touched = touched | (1 if x * x + y * y + z * z <= reach else 0)
                if touched == 1:
                    root = unite(parents, core, r)
    return root


@func
def sift_dense(
    children: int,
    core: int,
    record: int,
    a: vec3,
    b: vec3,
    boxes: array(dtype=float32),
    reach: float,
    lowest: array(dtype=int32),
    parents: array(dtype=int32),
) -> int:
    """The children of a node that have to be entered to unite the set of `core` with all in reach of the box (a, b).

    Not those without a core; nor those that are one set by their size, where that is the core's set already, or where
    all of it is in reach: these are united here.
    """
    dense = bits_within(measure_diagonals(boxes, record), reach)
    inside = bits_within(measure_farthest(boxes, record, a, b), reach)
    root = find_root(parents, core)
    entered = int(0)
    left = children + 0
    while left != 0:
        child = lowest_bit(left)
        left = left & (left - 1)
        first = lowest[record * FAN + child]
        if first != NO_NUMBER:
            wanted = int(1)
            if ((dense >> child) & 1) == 1:
                if find_root(parents, first) == root:
                    wanted = 0
                else:
                    if ((inside >> child) & 1) == 1:
                        root = unite(parents, core, first)
                        wanted = 0
            entered = entered | (wanted << child)
    return entered


@func
def set_part(cores: int, head: int, core: int, parents: array(dtype=int32)) -> int:
    """Which of a leaf's cores, given as bits from rank `head` on, share the set of `core`, itself always."""
    root = find_root(parents, core)
    part = 1 << (core - head)
    left = cores ^ part
    while left != 0:
        j = lowest_bit(left)
        left = left & (left - 1)
        if find_root(parents, head + j) == root:
            part = part | (1 << j)
    return part


@func
def unite_part(
    core: int,
    xs: lanes,
    ys: lanes,
    zs: lanes,
    a: vec3,
    b: vec3,
    leaf: int,
    start: int,
    tree: PointTree,
    reach: float,
    lowest: array(dtype=int32),
    parents: array(dtype=int32),
):
    """Unite the set of `core` with those in reach of the lanes, in all that comes after its ancestor at level `start`.

    Each pair is seen from its earlier end. The lanes are cores of one leaf and of one set, (a, b) is their box.
    """
    step = next_node(begin_walk(start, leaf >> (FAN_BITS * start)), tree.root + 1)
    while int(step[0]) <= tree.root + 1:
        level = int(step[1])
        node = int(step[2])
        record = record_of(tree.levels, level, node)
        near = bits_within(measure_boxes(tree.boxes, record, a, b), reach)
        if level == int(step[0]):
            near = near & (BYTE - ((2 << own_child(leaf, level)) - 1))
        if near != 0:
            near = sift_dense(near, core, record, a, b, tree.boxes, reach, lowest, parents)
            if level > 1:
                step = put_off(step, near)
            else:
                while near != 0:
                    first = (node * FAN + lowest_bit(near)) * LEAF
                    unite_leaf(core, xs, ys, zs, first, min(first + LEAF, tree.count), tree.points, reach, parents)
                    near = near & (near - 1)
        step = next_node(step, tree.root + 1)


@kernel
def unite_cores_kernel(
    tree: PointTree,
    reach: float,
    lowest: array(dtype=int32),
    parents: array(dtype=int32),
):
    """Unite the sets of all cores within reach of each other: a leaf's, one of its sets after the other."""
    leaf = tid()
    head = leaf * LEAF
    start = int(0)
    left = int(0)
    if lowest[leaf] != NO_NUMBER:
        start = dense_ancestor(leaf, tree, reach)
        if start > 0:
            node = leaf >> (FAN_BITS * start)
            unite(parents, lowest[leaf], lowest[tree.levels[start] * FAN + node])
        for j in range(min(LEAF, tree.count - head)):
            if parents[head + j] >= 0:
                left = left | (1 << j)
    while left != 0:
        core = head + lowest_bit(left)
        part = set_part(left, head, core, parents)
        left = left ^ part
        xs = lanes(INFINITY)
        ys = lanes(0.0)
        zs = lanes(0.0)
        a = tree.points[core]
        b = a + vec3(0.0, 0.0, 0.0)
        for j in range(LEAF):
            if ((part >> j) & 1) == 1:
                p = tree.points[head + j]
                xs[j] = p[0]
                ys[j] = p[1]
                zs[j] = p[2]
                a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
                b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
        unite_part(core, xs, ys, zs, a, b, leaf, start, tree, reach, lowest, parents)
