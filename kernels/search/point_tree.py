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

import numpy as np

from ..algebra.plain_min_max import larger
from ..arrays.select import gather_vec3_kernel
from ..lang import (
    INFINITY,
    array,
    float32,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    struct,
    tid,
    vec3,
    vector,
)
from ..memory import empty, upload, zeros
from .hilbert_order import HilbertCurve, HilbertOrder, locate_on_curve

LEAF = 8  # points a leaf
FAN = 8  # leaves a bucket
BUCKET = LEAF * FAN  # points a bucket
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
        points: By place on the curve.
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

    def __init__(self, points):
        found = HilbertOrder(points)
        self.source, self.device = points, points.device
        self.low, self.high = found.low, found.high
        self.count, self.order, self.curve = found.finite_count, found.order, found.curve
        self.points = empty(self.count, vec3, self.device)
        launch(gather_vec3_kernel, self.count, [points, self.order, self.points])
        sizes = [max(1, -(-self.count // BUCKET))]
        self.codes = zeros(sizes[0], int64, self.device)
        while sizes[-1] > 1:
            sizes.append(-(-sizes[-1] // FAN))
        first = np.concatenate([[0], np.cumsum(sizes)])
        self.root = len(sizes) - 1
        self.levels = upload(first.astype(np.int32), int32, self.device)
        # Children that are not there stay empty boxes. They are infinitely far, and every reach is finite: a walk that
        # entered one would read beyond the last record.
        sides = np.repeat(np.array([np.inf, -np.inf], np.float32), 3 * FAN)
        self.boxes = upload(np.tile(sides, int(first[-1])), float32, self.device)
        leaves = [self.points, self.count, found.codes, self.codes, self.boxes]
        launch(bound_leaves_kernel, sizes[0] * FAN, leaves)
        for level in range(1, len(sizes)):
            launch(bound_nodes_kernel, sizes[level - 1], [int(first[level - 1]), int(first[level]), self.boxes])


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
def bound_leaves_kernel(
    points: array(dtype=vec3),
    count: int,
    codes: array(dtype=int64),
    first_codes: array(dtype=int64),
    boxes: array(dtype=float32),
):
    """The boxes of the leaves; leaves beyond the last point are empty boxes, which no query reaches.

    The first leaf of a bucket takes its first point's code along.
    """
    i = tid()
    if i % FAN == 0 and i * LEAF < count:
        first_codes[i // FAN] = codes[i * LEAF]
    bound_leaf(i, points, count, boxes)


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
def bound_nodes_kernel(below: int, first: int, boxes: array(dtype=float32)):
    """Put the box of each node of one level beside its siblings', where its parent holds them."""
    i = tid()
    a = lowest_corner(below + i, boxes)
    b = highest_corner(below + i, boxes)
    at = (first + i // FAN) * SIDES + i % FAN
    for axis in range(3):
        boxes[at + axis * FAN] = a[axis]
        boxes[at + (axis + 3) * FAN] = b[axis]


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
def find_run(codes: array(dtype=int64), first: int, count: int, code: int64) -> int:
    """Which of `count` runs holds a code, by bisection over their first codes, which stand from `first` on."""
    a = int(0)
    b = count + 0
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
    equal = int(1)
    for axis in range(3):
        if boxes[at + axis * FAN] != boxes[at + (axis + 3) * FAN]:
            equal = 0
    return equal
