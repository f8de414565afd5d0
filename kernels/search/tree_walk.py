"""Walks through a PointTree that choose at every node which children to enter, count or leave out.

Level 0 is the leaves, level 1 the buckets, the highest is `top`. A walk begins at a node and comes to each node above
it in turn, always after what was entered of the one before; `own_child` says where it came from. A caller that takes
the `other_children` sees every point once, one that takes the `later_children` those behind it. What is left to visit
is one byte a level above the buckets.

A node's number, and its box, stand beside its siblings' in its parent's record: `record_of` of the parent, at the
place of the child. LEAF queries are one box to the tree and eight lanes to a leaf's points: a point is loaded once and
measured against all of them in a vector register.
"""

from ..algebra.plain_min_max import larger
from ..lang import array, bit_count, float32, func, int32, int64, kernel, launch, loop, tid, vec3, vector
from ..memory import download, empty, fill
from .bucket_walk import BYTE, byte_place, walk
from .point_tree import FAN, LEAF, SIDES, PointTree, box_distances

FAN_BITS = 3  # FAN is 2^3, LEAF too
NO_NUMBER = 2**31 - 1  # the number of a node without one: no minimum chooses it
lanes = vector(8, float32)  # a number for each point of a leaf
numbers = vector(8, int32)


@func
def lowest_bit(bits: int) -> int:
    """The place of the lowest bit that is set."""
    return bit_count((bits & (-bits)) - 1)


@loop
def bits_of(byte: int) -> int:
    """The places of the bits that are set, the lowest first."""
    left = byte
    while left != 0:
        place = lowest_bit(left)
        left = left & (left - 1)
        yield place


@func
def record_of(levels: array(dtype=int32), level: int, node: int) -> int:
    """The record of a node above the leaves, which holds the boxes of its children."""
    return levels[level - 1] + node


@func
def walk_place(level: int) -> int64:
    """Where a level's byte begins in what is left to visit; leaves and buckets need none."""
    return byte_place(level - 1)


@func
def begin_walk(level: int, node: int) -> walk:
    """A walk that stands at a node: height, level, node, and what is left to visit."""
    return walk(int64(level), int64(level), int64(node), 0)


@func
def put_off(step: walk, children: int) -> walk:
    """The walk, its node's children whose bits are set yet to visit; for nodes above the buckets."""
    return walk(step[0], step[1], step[2], step[3] | (int64(children) << walk_place(int(step[1]))))


@func
def next_node(step: walk, top: int) -> walk:
    """Go on to the next node to open; the walk has ended where its height exceeds `top`."""
    height = int(step[0])
    level = int(step[1])
    node = int(step[2])
    pending = step[3]
    searching = 1
    while searching == 1:
        left = 0
        if level > 1:
            left = int(pending >> walk_place(level)) & BYTE
        if left != 0:
            child = lowest_bit(left)
            pending = pending ^ (1 << (walk_place(level) + int64(child)))
            node = node * FAN + child
            level = level - 1
            searching = 0
        else:
            node = node >> FAN_BITS
            level = level + 1
            if level > height:
                height = height + 1
                searching = 0
    return walk(int64(height), int64(level), int64(node), pending)


@func
def own_child(leaf: int, level: int) -> int:
    """Which child of its ancestor at a level a leaf lies in."""
    return (leaf >> (FAN_BITS * (level - 1))) & (FAN - 1)


@func
def other_children(leaf: int, height: int, level: int) -> int:
    """The children of a node that a leaf's walk did not come from, as a byte; of its own bucket all, the leaf too."""
    others = int(BYTE)
    if level > 1 and level == height:
        others = BYTE - (1 << own_child(leaf, level))
    return others


@func
def later_children(leaf: int, height: int, level: int) -> int:
    """The children of a node, as a byte, whose points all come after those that a leaf's walk began with."""
    later = int(BYTE)
    if level == height:
        later = BYTE - ((2 << own_child(leaf, level)) - 1)
    return later


@loop
def nodes_after(start: int, leaf: int, near: int, tree: PointTree) -> tuple[int, int, int]:
    """The nodes of a walk from a leaf's ancestor at level `start` on, that one left out, as (height, level, node).

    `near` is a variable in which the body leaves a byte: the children of the node to enter. The children of a bucket
    are leaves, with which the body does itself what there is to do.
    """
    step = next_node(begin_walk(start, leaf >> (FAN_BITS * start)), tree.root + 1)
    while int(step[0]) <= tree.root + 1:
        height = int(step[0])
        level = int(step[1])
        node = int(step[2])
        yield height, level, node
        if level > 1:
            step = put_off(step, near)
        step = next_node(step, tree.root + 1)


@loop
def leaves_of(bucket: int, children: int, tree: PointTree) -> tuple[int, int]:
    """Where the points of some leaves of a bucket, given as a byte, begin and end."""
    for child in bits_of(children):
        first = (bucket * FAN + child) * LEAF
        last = min(first + LEAF, tree.count)
        yield first, last


@loop
def points_of(leaf: int, tree: PointTree) -> tuple[int, vec3]:
    """The points of a leaf, each with its lane; the last leaf may hold fewer than LEAF."""
    for lane in range(LEAF):
        if leaf * LEAF + lane < tree.count:
            p = tree.points[leaf * LEAF + lane]
            yield lane, p


@func
def point_sum(children: int, level: int, node: int, count: int) -> int:
    """How many of the first `count` points lie in some children of a node."""
    total = 0
    size = LEAF << (FAN_BITS * (level - 1))
    for child in bits_of(children):
        total += min(size, count - (node * FAN + child) * size)
    return total


@func
def measure_farthest(boxes: array(dtype=float32), record: int, a: vec3, b: vec3) -> box_distances:
    """The most that the squared distance [m^2] of a point of the box (a, b) and one of a child's box can be.

    By the operations of point distances, whose rounding is monotonic: no pair's is larger. Infinite for empty boxes.
    """
    at = record * SIDES
    distances = box_distances(0.0)
    for j in range(FAN):
        x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])
        y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])
        z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])
        distances[j] = x * x + y * y + z * z
    return distances


@func
def measure_diagonals(boxes: array(dtype=float32), record: int) -> box_distances:
    """The squared diagonals [m^2] of the boxes of a node's children: no two points of a child are farther apart."""
    at = record * SIDES
    distances = box_distances(0.0)
    for j in range(FAN):
        x = boxes[at + j + 3 * FAN] - boxes[at + j]
        y = boxes[at + j + 4 * FAN] - boxes[at + j + FAN]
        z = boxes[at + j + 5 * FAN] - boxes[at + j + 2 * FAN]
        distances[j] = x * x + y * y + z * z
    return distances


@func
def bits_within(distances: box_distances, reach: float) -> int:
    """A byte: bit j is set where distance j is no more than `reach`."""
    found = 0
    for j in range(FAN):
        found = found | ((1 << j) if distances[j] <= reach else 0)
    return found


@func
def box_corner(boxes: array(dtype=float32), leaf: int, side: int) -> vec3:
    """The low (0) or high (1) corner of a leaf's box."""
    at = (leaf >> FAN_BITS) * SIDES + (leaf & (FAN - 1)) + 3 * side * FAN
    return vec3(boxes[at], boxes[at + FAN], boxes[at + 2 * FAN])


@kernel
def lower_numbers_kernel(below: int, first: int, lowest: array(dtype=int32)):
    """The lowest number of each node's children, into the record of its parent."""
    i = tid()
    least = int(NO_NUMBER)
    for j in range(FAN):
        least = min(least, lowest[(below + i) * FAN + j])
    lowest[first * FAN + i] = least


class NodeNumbers:
    """A number for each node of a tree, the lowest of its leaves' numbers; the host's half of a walk.

    Attributes:
        values: int32, leaves first; a child's number stands at record * FAN + child. NO_NUMBER where there is no leaf.
        top: The highest level.
    """

    def __init__(self, tree: PointTree) -> None:
        self.tree, self.top = tree, tree.root + 1
        self.leaf_count = -(-tree.count // LEAF)
        firsts = download(tree.levels)  # sync; ten numbers
        self.records = [int(first) for first in firsts]
        self.values = empty(self.records[-1] * FAN, int32, tree.device)
        fill(self.values, NO_NUMBER)

    def lower(self) -> None:
        """Bring the leaves' numbers up to the nodes above."""
        for level in range(1, self.top):
            below, first = self.records[level - 1], self.records[level]
            launch(lower_numbers_kernel, first - below, [below, first, self.values])
