"""PointTree traversals that choose at each node which children to enter, count or skip.

Level 0 is the leaves, level 1 the buckets, `top` the highest. A traversal visits a node's ancestors one by one;
`other_children` covers every point once, `following_children` those behind the start. One pending byte per level above
the buckets. A node's box and number are in its parent's record (`record_of`).
"""

from ..algebra.plain_min_max import larger
from ..arrays.packed_keys import BYTE_MASK
from ..lang import WARP, array, bit_count, float32, func, int32, int64, kernel, launch, loop, tid, vec3, vector
from ..memory import download, empty, fill
from .bucket_walk import byte_shift, traversal
from .point_tree import FAN, LEAF, SIDES, PointTree, box_distances

FAN_BITS = 3  # FAN and LEAF are 2^3
NO_NUMBER = 2**31 - 1  # number of a node without one: never the minimum
lanes = vector(8, float32)  # one number per point of a leaf
numbers = vector(8, int32)


@func
def lowest_bit(bits: int) -> int:
    return bit_count((bits & (-bits)) - 1)


@loop
def bits_of(byte: int) -> int:
    left = byte
    while left != 0:
        bit = lowest_bit(left)
        left = left & (left - 1)
        yield bit


@func
def record_of(levels: array(dtype=int32), level: int, node: int) -> int:
    """Record of a node above the leaves, with its children's boxes."""
    return levels[level - 1] + node


@func
def pending_shift(level: int) -> int64:
    """Shift of a level's byte in the pending mask. Leaves and buckets need none."""
    return byte_shift(level - 1)


@func
def begin_traversal(level: int, node: int) -> traversal:
    """Traversal state at a node: height, level, node, pending mask."""
    return traversal(int64(level), int64(level), int64(node), 0)


@func
def put_off(step: traversal, children: int) -> traversal:
    """Mark children as pending. For nodes above the buckets."""
    return traversal(step[0], step[1], step[2], step[3] | (int64(children) << pending_shift(int(step[1]))))


@func
def next_node(step: traversal, top: int) -> traversal:
    """Advance to the next node to open; ends when the height exceeds `top`."""
    height = int(step[0])
    level = int(step[1])
    node = int(step[2])
    pending = step[3]
    searching = 1
    while searching == 1:
        left = 0
        if level > 1:
            left = int(pending >> pending_shift(level)) & BYTE_MASK
        if left != 0:
            child = lowest_bit(left)
            pending = pending ^ (1 << (pending_shift(level) + int64(child)))
            node = node * FAN + child
            level = level - 1
            searching = 0
        else:
            node = node >> FAN_BITS
            level = level + 1
            if level > height:
                height = height + 1
                searching = 0
    return traversal(int64(height), int64(level), int64(node), pending)


@func
def own_child(leaf: int, level: int) -> int:
    """The child of its ancestor at a level that contains a leaf."""
    return (leaf >> (FAN_BITS * (level - 1))) & (FAN - 1)


@func
def other_children(leaf: int, height: int, level: int) -> int:
    """Bit mask of the children of a node that the traversal did not come from. For its own bucket all."""
    others = int(BYTE_MASK)
    if level > 1 and level == height:
        others = BYTE_MASK - (1 << own_child(leaf, level))
    return others


@func
def following_children(leaf: int, height: int, level: int) -> int:
    """Bit mask of the children of a node whose points come after the start of the traversal."""
    children = int(BYTE_MASK)
    if level == height:
        children = BYTE_MASK - ((2 << own_child(leaf, level)) - 1)
    return children


@loop
def nodes_after(start: int, leaf: int, near: int, tree: PointTree) -> tuple[int, int, int]:
    """Nodes after a leaf's ancestor at level `start`. The body sets the children `near` and processes buckets."""
    step = next_node(begin_traversal(start, leaf >> (FAN_BITS * start)), tree.root + 1)
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
    """Start and end of the points of some leaves of a bucket, given as a bit mask."""
    for child in bits_of(children):
        first = (bucket * FAN + child) * LEAF
        last = min(first + LEAF, tree.count)
        yield first, last


@loop
def points_of(leaf: int, tree: PointTree) -> tuple[int, vec3]:
    """Points of a leaf with their lanes. The last leaf may be short."""
    for lane in range(LEAF):
        if leaf * LEAF + lane < tree.count:
            p = tree.points[leaf * LEAF + lane]
            yield lane, p


@func
def point_sum(children: int, level: int, node: int, count: int) -> int:
    """How many of the first `count` points are in some children of a node."""
    total = 0
    size = LEAF << (FAN_BITS * (level - 1))
    for child in bits_of(children):
        total += min(size, count - (node * FAN + child) * size)
    return total


@func
def measure_farthest(boxes: array(dtype=float32), record: int, a: vec3, b: vec3) -> box_distances:
    """Maximum squared distances [m^2] from the box (a, b) to child boxes, rounded monotonically; infinite if empty."""
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
    """Squared diagonals [m^2] of the boxes of a node's children."""
    at = record * SIDES
    distances = box_distances(0.0)
    for j in range(FAN):
        x = boxes[at + j + 3 * FAN] - boxes[at + j]
        y = boxes[at + j + 4 * FAN] - boxes[at + j + FAN]
        z = boxes[at + j + 5 * FAN] - boxes[at + j + 2 * FAN]
        distances[j] = x * x + y * y + z * z
    return distances


@func
def measure_diagonal(boxes: array(dtype=float32), record: int, child: int) -> float:
    at = record * SIDES + child
    x = boxes[at + 3 * FAN] - boxes[at]
    y = boxes[at + 4 * FAN] - boxes[at + FAN]
    z = boxes[at + 5 * FAN] - boxes[at + 2 * FAN]
    return x * x + y * y + z * z


@func
def bits_within(distances: box_distances, max_sqdist: float) -> int:
    bits = 0
    for j in range(FAN):
        bits = bits | ((1 << j) if distances[j] <= max_sqdist else 0)
    return bits


@func
def box_corner(boxes: array(dtype=float32), leaf: int, side: int) -> vec3:
    at = (leaf >> FAN_BITS) * SIDES + (leaf & (FAN - 1)) + 3 * side * FAN
    return vec3(boxes[at], boxes[at + FAN], boxes[at + 2 * FAN])


@kernel
def lower_numbers_kernel(below: int, first: int, lowest: array(dtype=int32)):
    """The lowest number of each node's children, into the record of its parent."""
    i = tid()
    minimum = int(NO_NUMBER)
    for j in range(FAN):
        minimum = min(minimum, lowest[(below + i) * FAN + j])
    lowest[first * FAN + i] = minimum


def leaf_threads(tree: PointTree) -> int:
    """Threads of a launch over the leaves of a tree: one per leaf, on CUDA a warp per four."""
    return -(-tree.count // WARP) * WARP if tree.device.is_cuda else -(-tree.count // LEAF)


class NodeNumbers:
    """Minimum over leaves of a number, for each tree node, at record * FAN + child. NO_NUMBER if none."""

    def __init__(self, tree: PointTree) -> None:
        self.tree, self.top = tree, tree.root + 1
        self.leaf_count = -(-tree.count // LEAF)
        firsts = download(tree.levels)  # sync; ten numbers
        self.records = [int(first) for first in firsts]
        self.values = empty(self.records[-1] * FAN, int32, tree.device)
        fill(self.values, NO_NUMBER)

    def lower(self) -> None:
        for level in range(1, self.top):
            below, first = self.records[level - 1], self.records[level]
            launch(lower_numbers_kernel, first - below, [below, first, self.values])
