"""A tree of boxes over points in Hilbert order: one exact search structure for every radius, count and density.

Leaves are runs of LEAF points of the order, buckets are runs of FAN leaves, and above them each node has FAN children.
Nothing depends on the density of the cloud, there is no cell size to guess, and the tree need not be built again for
another radius. Build: the Hilbert sort, then 12 B of points and 3.4 B of boxes written a point. A query walks up from
the bucket where it lies on the curve, and at each step down into the other children that reach into the ball of the
best points so far (bucket_walk.py). The boxes of a node's children lie side by side and are measured together, in
vector registers on the CPU: a binary tree took twice as long.

Exactness: the distance of a box is computed by the same operations as the distance of a point, and none are fused.
Rounding is monotonic, so a box is never farther than a point in it, and nothing that belongs to the result is left out,
ties included.
"""

from collections.abc import Sequence

import numpy as np

from ..algebra.plain_min_max import larger
from ..array_types import Integers, Points, Scalars
from ..lang import (
    INFINITY,
    WARP,
    array,
    cuda_func,
    float32,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    shuffle_xor,
    struct,
    tid,
    vec3,
    vector,
)
from ..memory import empty, upload
from .hilbert_order import HilbertCurve, HilbertOrder, locate_on_curve

LEAF = 8  # points a leaf
FAN = 8  # leaves a bucket
BUCKET = LEAF * FAN  # points a bucket
ROUNDED_UP = 1.000001  # times a square: more than float32 rounds it up
LARGEST_SQDIST = 3.4028234663852886e38  # [m^2] the largest float32: a walk without a radius reaches so far, not farther
SIDES = 6 * FAN  # numbers of a node's boxes: low x, y, z, high x, y, z of all its children
box_distances = vector(8, float32)


@struct
class PointTree:
    """The search structure over the finite points of a device array.

    Attributes:
        count: Finite points.
        root: The level of the highest node; buckets are level 0.
        levels: Where the nodes of each level begin, and end.
        boxes: SIDES numbers a node: the boxes of its children.
        points: By place on the curve, and points at infinity up to a whole leaf.
        order: int32 [n], positions in the cloud by place; points that are not finite stand last.
        codes: The code of each bucket's first point.
        curve: The HilbertCurve.
        source: The points that it was built over, kept alive, so that no other array can take their address.
        low, high: The box of the finite points, float32 [3].
    """

    count: int
    root: int
    levels: array(dtype=int32)
    boxes: array(dtype=float32)
    points: array(dtype=vec3)
    order: array(dtype=int32)
    codes: array(dtype=int64)
    curve: HilbertCurve

    def __init__(self, points: Points, curve: HilbertCurve | None = None) -> None:
        found = HilbertOrder(points, curve)
        self.source, self.device = points, points.device
        self.low, self.high = found.low, found.high
        self.count, self.order, self.curve = found.finite_count, found.order, found.curve
        sizes, first = level_sizes(-(-self.count // BUCKET))
        self.root = len(sizes) - 1
        self.levels = upload(first, int32, self.device)
        self.points = empty(-(-self.count // LEAF) * LEAF, vec3, self.device)
        self.codes = empty(sizes[0], int64, self.device)
        self.boxes = empty(int(first[-1]) * SIDES, float32, self.device)
        if self.device.is_cuda:
            buckets = sizes[1] * FAN if self.root else 1
            launch(place_leaves_kernel, buckets * WARP, [points, found.codes, self])
        else:
            launch(place_leaves_kernel, sizes[0] * FAN, [points, found.codes, self])
        bound_levels(self.levels, sizes, self.boxes, known=1 if self.device.is_cuda else 0)


def widest_square(tree: PointTree, reach: float) -> float:
    """The squared distance [m^2] that no two points of a tree exceed, nor a squared reach."""
    diagonal = tree.high.astype(np.float64) - tree.low if tree.count else np.zeros(3)
    return float(np.float32(min(reach, float((diagonal**2).sum()) * ROUNDED_UP)))


def level_sizes(count: int) -> tuple[list[int], np.ndarray]:
    """(nodes of each level, where each begins and the last ends as int32) over `count` nodes of the lowest level."""
    sizes = [max(1, count)]
    while sizes[-1] > 1:
        sizes.append(-(-sizes[-1] // FAN))
    return sizes, np.concatenate([[0], np.cumsum(sizes)]).astype(np.int32)


def bound_levels(levels: Integers, sizes: Sequence[int], boxes: Scalars, known: int) -> None:
    """Put the boxes of the nodes of each level into the level above it, from the level `known` on, which is there.

    On CUDA two levels a launch.
    """
    for level in range(known + 1, len(sizes), 2 if boxes.device.is_cuda else 1):
        if not boxes.device.is_cuda:
            threads = sizes[level] * FAN
        elif level + 1 < len(sizes):
            threads = sizes[level + 1] * FAN * FAN
        else:
            threads = WARP  # for the root's FAN children
        launch(bound_nodes_kernel, threads, [level, levels, boxes])


@func
def bound_leaf(leaf: int, points: array(dtype=vec3), count: int, boxes: array(dtype=float32)):
    """Write the box of the finite points of a leaf; an empty one, which no query reaches, where it has none."""
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    for j in range(leaf * LEAF, min((leaf + 1) * LEAF, count)):
        p = points[j]
        if isfinite(p):
            a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
            b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
    at = (leaf // FAN) * SIDES + leaf % FAN
    for axis in range(3):
        boxes[at + axis * FAN] = a[axis]
        boxes[at + (axis + 3) * FAN] = b[axis]


@kernel
def place_leaves_kernel(source: array(dtype=vec3), codes: array(dtype=int64), tree: PointTree):
    """Put the points of a leaf at their places, and bound it; leaves beyond the last point are empty boxes.

    Behind the last point stands what no query reaches, up to a whole leaf, so that leaves are read without a branch.
    The first leaf of a bucket takes its first point's code along.
    """
    i = tid()
    if i % FAN == 0:
        tree.codes[i // FAN] = codes[i * LEAF] if i * LEAF < tree.count else 0
    for j in range(i * LEAF, min((i + 1) * LEAF, tree.count)):
        tree.points[j] = source[tree.order[j]]
    for j in range(max(i * LEAF, tree.count), min((i + 1) * LEAF, tree.points.shape[0])):
        tree.points[j] = vec3(INFINITY, INFINITY, INFINITY)
    bound_leaf(i, tree.points, tree.count, tree.boxes)


@cuda_func
def lowest_of_lanes(p: vec3, first: int, last: int) -> vec3:
    """The lowest coordinates of lanes whose numbers differ in these bits alone."""
    a = p + vec3(0.0, 0.0, 0.0)
    for bit in range(first, last):
        x = shuffle_xor(a[0], 1 << bit)
        y = shuffle_xor(a[1], 1 << bit)
        z = shuffle_xor(a[2], 1 << bit)
        a = vec3(min(a[0], x), min(a[1], y), min(a[2], z))
    return a


@cuda_func
def write_side(lane: int, low: vec3, high: vec3, at: int, boxes: array(dtype=float32)):
    """Write a box, a number a lane; a vector with a computed index would live in local memory."""
    x = high[0] if lane == 3 else low[0]
    y = high[1] if lane == 4 else low[1]
    z = high[2] if lane == 5 else low[2]
    side = x if lane % 3 == 0 else y if lane % 3 == 1 else z
    if lane < 6:
        boxes[at + lane * FAN] = side


@place_leaves_kernel.on_cuda
def place_buckets_kernel(source: array(dtype=vec3), codes: array(dtype=int64), tree: PointTree):
    """A bucket a warp, two points a lane: reads and writes are side by side, and the bucket's own box comes for free.

    Buckets there are not are empty boxes for the level above.
    """
    i = tid()
    bucket = i // WARP
    lane = i % WARP
    if lane == 0 and bucket < tree.codes.shape[0]:
        tree.codes[bucket] = codes[bucket * BUCKET] if bucket * BUCKET < tree.count else 0
    low = vec3(INFINITY, INFINITY, INFINITY)
    high = vec3(INFINITY, INFINITY, INFINITY)  # of minus the coordinates
    for half in range(2):
        place = bucket * BUCKET + half * WARP + lane
        a = vec3(INFINITY, INFINITY, INFINITY)
        b = vec3(INFINITY, INFINITY, INFINITY)
        if place < tree.count:
            p = source[tree.order[place]]
            tree.points[place] = p
            if isfinite(p):
                a = p
                b = -p
        elif place < tree.points.shape[0]:
            tree.points[place] = a
        a = lowest_of_lanes(a, 0, 3)
        b = lowest_of_lanes(b, 0, 3)
        if bucket < tree.codes.shape[0]:
            write_side(lane % LEAF, a, -b, bucket * SIDES + half * (FAN // 2) + lane // LEAF, tree.boxes)
        low = vec3(min(low[0], a[0]), min(low[1], a[1]), min(low[2], a[2]))
        high = vec3(min(high[0], b[0]), min(high[1], b[1]), min(high[2], b[2]))
    low = lowest_of_lanes(low, 3, 5)
    high = lowest_of_lanes(high, 3, 5)
    if tree.root > 0:
        write_side(lane, low, -high, (tree.levels[1] + bucket // FAN) * SIDES + bucket % FAN, tree.boxes)


@func
def lowest_corner(node: int, boxes: array(dtype=float32)) -> vec3:
    """The lowest coordinates of the boxes of a node's children."""
    a = vec3(INFINITY, INFINITY, INFINITY)
    for j in range(node * SIDES, node * SIDES + FAN):
        a = vec3(min(a[0], boxes[j]), min(a[1], boxes[j + FAN]), min(a[2], boxes[j + 2 * FAN]))
    return a


@func
def highest_corner(node: int, boxes: array(dtype=float32)) -> vec3:
    """The highest coordinates of the boxes of a node's children."""
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    for j in range(node * SIDES + 3 * FAN, node * SIDES + 4 * FAN):
        b = vec3(max(b[0], boxes[j]), max(b[1], boxes[j + FAN]), max(b[2], boxes[j + 2 * FAN]))
    return b


@kernel
def bound_nodes_kernel(level: int, levels: array(dtype=int32), boxes: array(dtype=float32)):
    """Put the box of each node of the level below beside its siblings', where its parent on this one holds them.

    Nodes there are not, behind the last of the level below, are empty boxes.
    """
    i = tid()
    below = levels[level - 1]
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    if below + i < levels[level]:
        a = lowest_corner(below + i, boxes)
        b = highest_corner(below + i, boxes)
    at = (levels[level] + i // FAN) * SIDES + i % FAN
    for axis in range(3):
        boxes[at + axis * FAN] = a[axis]
        boxes[at + (axis + 3) * FAN] = b[axis]


@bound_nodes_kernel.on_cuda
def bound_two_levels_kernel(level: int, levels: array(dtype=int32), boxes: array(dtype=float32)):
    """And the box of their parent where that holds its own: FAN lanes have siblings."""
    i = tid()
    below = levels[level - 1]
    first = levels[level]
    above = levels[level + 1]
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    if below + i < first:
        a = lowest_corner(below + i, boxes)
        b = highest_corner(below + i, boxes)
    parent = i // FAN
    if first + parent < above:
        at = (first + parent) * SIDES + i % FAN
        for axis in range(3):
            boxes[at + axis * FAN] = a[axis]
            boxes[at + (axis + 3) * FAN] = b[axis]
    a = lowest_of_lanes(a, 0, 3)
    b = lowest_of_lanes(-b, 0, 3)
    if level + 2 < levels.shape[0]:
        write_side(i % FAN, a, -b, (above + parent // FAN) * SIDES + parent % FAN, boxes)


@func
def square_distance(p: vec3, q: vec3) -> float:
    """|p - q|^2 [m^2], summed as the box distance is."""
    x = q[0] - p[0]
    y = q[1] - p[1]
    z = q[2] - p[2]
    return x * x + y * y + z * z


@func
def measure_boxes(boxes: array(dtype=float32), node: int, a: vec3, b: vec3) -> box_distances:
    """Squared distances [m^2] between the box (a, b) and those of a node's children; a point is the box (p, p).

    Infinite for empty boxes.
    """
    at = node * SIDES
    distances = box_distances(0.0)
    for j in range(FAN):
        x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)
        y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)
        z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)
        distances[j] = x * x + y * y + z * z
    return distances


@func
def measure_box(boxes: array(dtype=float32), node: int, child: int, a: vec3, b: vec3) -> float:
    """`measure_boxes` for one child."""
    at = node * SIDES + child
    x = larger(larger(boxes[at] - b[0], a[0] - boxes[at + 3 * FAN]), 0.0)
    y = larger(larger(boxes[at + FAN] - b[1], a[1] - boxes[at + 4 * FAN]), 0.0)
    z = larger(larger(boxes[at + 2 * FAN] - b[2], a[2] - boxes[at + 5 * FAN]), 0.0)
    return x * x + y * y + z * z


@func
def find_run(codes: array(dtype=int64), first: int, count: int, code: int64) -> int:
    """Which of `count` runs holds a code, by bisection over their first codes, which stand from `first` on."""
    a = 0
    b = count
    while b - a > 1:
        middle = (a + b) // 2
        if codes[first + middle] <= code:
            a = middle
        else:
            b = middle
    return a


@func
def find_bucket(p: vec3, tree: PointTree) -> int:
    """The bucket whose run on the curve holds a place."""
    return find_run(tree.codes, 0, (tree.count + BUCKET - 1) // BUCKET, locate_on_curve(p, tree.curve))


@func
def is_one_place(boxes: array(dtype=float32), node: int, child: int) -> int:
    """1 where all points of a node's child have the same coordinates."""
    at = node * SIDES + child
    equal = 1
    for axis in range(3):
        if boxes[at + axis * FAN] != boxes[at + (axis + 3) * FAN]:
            equal = 0
    return equal
