"""A tree of boxes over points in Hilbert order: one exact search structure for every radius, count and density.

Leaves are runs of LEAF points of the order, buckets are runs of FAN leaves, and above them each node has FAN children.
Nothing depends on the density of the cloud, there is no cell size to guess, and the tree need not be built again for
another radius. Build: the Hilbert sort, then 12 B of points and 3.4 B of boxes written a point. A query walks up from
the bucket where it lies on the curve, and at each step down into the other children that reach into the ball of the
best points so far; what is left to visit is one byte a level, so there is no stack. The boxes of a node's children lie
side by side and are measured together, in vector registers on the CPU: a binary tree took twice as long.

Exactness: the distance of a box is computed by the same operations as the distance of a point, and none are fused.
Rounding is monotonic, so a box is never farther than a point in it, and nothing that belongs to the result is left out,
ties included.

A result is kept as one packed key a neighbour, its squared distance above its index: keys in ascending order are
neighbours by distance, ties by index.
"""

import numpy as np

from ..algebra.plain_min_max import larger
from ..arrays.packed_keys import key_limit, key_number, pack_key
from ..lang import (
    INFINITY,
    array,
    bit_count,
    callback,
    float32,
    func,
    int32,
    int64,
    kernel,
    launch,
    loop,
    partial,
    struct,
    tid,
    vec3,
    vector,
)
from ..memory import empty, upload, zeros
from .hilbert_order import HilbertCurve, HilbertOrder, locate_on_curve
from .neighbor_keys import BOUNDLESS, keep_nearest, thin_keys

LEAF = 8  # points a leaf
FAN = 8  # leaves a bucket
BUCKET = LEAF * FAN  # points a bucket
SIDES = 6 * FAN  # numbers of a node's boxes: low x, y, z, high x, y, z of all its children
BYTE = 255
box_distances = vector(8, float32)
walk = vector(4, int64)  # height, level, node, and what is left to visit: a byte a level


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
        launch(gather_points_kernel, self.count, [points, self.order, self.points])
        sizes = [max(1, -(-self.count // BUCKET))]
        self.codes = zeros(sizes[0], int64, self.device)
        while sizes[-1] > 1:
            sizes.append(-(-sizes[-1] // FAN))
        first = np.concatenate([[0], np.cumsum(sizes)])
        self.root = len(sizes) - 1
        self.levels = upload(first.astype(np.int32), int32, self.device)
        # Children that are not there stay empty boxes, which no finite bound reaches; a walk without a bound looks into
        # them, beyond the last record too.
        sides = np.repeat(np.array([np.inf, -np.inf], np.float32), 3 * FAN)
        self.boxes = upload(np.tile(sides, int(first[-1]) + FAN), float32, self.device)
        leaves = [self.points, self.count, found.codes, self.codes, self.boxes]
        launch(bound_leaves_kernel, sizes[0] * FAN, leaves)
        for level in range(1, len(sizes)):
            launch(bound_nodes_kernel, sizes[level - 1], [int(first[level - 1]), int(first[level]), self.boxes])


@kernel
def gather_points_kernel(points: array(dtype=vec3), order: array(dtype=int32), sorted_points: array(dtype=vec3)):
    """sorted_points[i] = points[order[i]]."""
    i = tid()
    sorted_points[i] = points[order[i]]


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
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    for j in range(i * LEAF, min((i + 1) * LEAF, count)):
        p = points[j]
        a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
        b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
    at = (i // FAN) * SIDES + i % FAN
    for axis in range(3):
        boxes[at + axis * FAN] = a[axis]
        boxes[at + (axis + 3) * FAN] = b[axis]


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


@func
def offer_bucket(
    bucket: int,
    p: vec3,
    tree: PointTree,
    labels: array(dtype=int32),
    keys: array(dtype=int64),
    base: int,
    held: int,
    reach: float,
    limit: int64,
) -> int:
    """Append the keys up to `limit` of the points of a bucket, none beyond the squared distance `reach`; how many keys
    are then held.

    Every key of a leaf is stored and the count moves on only for those up to the limit: no branch to mispredict.
    """
    size = held + 0
    distances = measure_boxes(tree.boxes, bucket, p, p)
    for leaf in range(FAN):
        first = bucket * BUCKET + leaf * LEAF
        wanted = int(0)
        if first < tree.count and distances[leaf] <= reach:
            wanted = 1
            nearest = pack_key(distances[leaf], labels[first])
            if nearest > limit:
                # As far as the last key. Of points at one place the order is that of their labels, so none is wanted.
                wanted = 1 - is_one_place(tree.boxes, bucket, leaf)
        if wanted == 1:
            for j in range(first, min(first + LEAF, tree.count)):
                key = pack_key(square_distance(p, tree.points[j]), labels[j])
                keys[base + size] = key
                if key <= limit:
                    size += 1
    return size


@func
def children_within(boxes: array(dtype=float32), node: int, a: vec3, b: vec3, bound: float) -> int:
    """A byte: bit j is set where the box of child j lies within the squared distance `bound` of the box (a, b)."""
    distances = measure_boxes(boxes, node, a, b)
    found = int(0)
    for j in range(FAN):
        if distances[j] <= bound:
            found = found | (1 << j)
    return found


@func
def byte_place(level: int) -> int64:
    """Where a level's byte begins in what is left to visit; buckets (level 0) need none."""
    return int64(FAN * max(level - 1, 0))


@func
def start_walk(bucket: int) -> walk:
    """A walk that stands at a bucket."""
    return walk(int64(0), int64(0), int64(bucket), int64(0))


@func
def next_step(step: walk, root: int, children: callback) -> walk:
    """Go on to the next bucket; `children(level, node)` is a byte, a bit for each child to look into.

    Up from the first bucket, and at each height down into the ancestor's other children. The walk stands at bucket
    step[2], or has ended where its height exceeds `root`. What is looked into may shrink between the steps.
    """
    height = int(step[0])
    level = int(step[1])
    node = int(step[2])
    pending = step[3]
    if level == 0 and height > 0:
        level = 1
        node = node // FAN
    searching = int(1)
    while searching == 1:
        left = int(pending >> byte_place(level)) & BYTE
        if left != 0:
            lowest = left & (-left)
            pending = pending ^ (int64(lowest) << byte_place(level))
            node = node * FAN + bit_count(lowest - 1)
            level = level - 1
            if level == 0:
                searching = 0
            else:
                inside = children(level, node)
                pending = pending | (int64(inside) << byte_place(level))
        else:
            if level == height:
                height = height + 1
                if height > root:
                    searching = 0
                else:
                    own = 1 << (node % FAN)
                    node = node // FAN
                    level = level + 1
                    others = children(level, node) & (BYTE - own)
                    pending = pending | (int64(others) << byte_place(level))
            else:
                node = node // FAN
                level = level + 1
    return walk(int64(height), int64(level), int64(node), pending)


@func
def children_in_reach(
    levels: array(dtype=int32),
    first: int,
    boxes: array(dtype=float32),
    a: vec3,
    b: vec3,
    bound: float,
    level: int,
    node: int,
) -> int:
    """`children_within` for a node given by its level; the levels of its tree stand from `first` on."""
    return children_within(boxes, levels[first + level] + node, a, b, bound)


@func
def next_bucket(step: walk, a: vec3, b: vec3, bound: float, tree: PointTree) -> walk:
    """Go on to the next bucket whose box lies within the squared distance `bound` of the box (a, b)."""
    return next_step(step, tree.root, partial(children_in_reach, tree.levels, 0, tree.boxes, a, b, bound))


@loop
def leaves_in_reach(start: int, a: vec3, b: vec3, reach: float, tree: PointTree) -> int:
    """The first places of the leaves within the squared distance `reach` of the box (a, b), from a bucket on."""
    step = start_walk(start)
    while int(step[0]) <= tree.root:
        bucket = int(step[2])
        distances = measure_boxes(tree.boxes, bucket, a, b)
        for leaf in range(FAN):
            if distances[leaf] <= reach:
                first = bucket * BUCKET + leaf * LEAF
                yield first
        step = next_bucket(step, a, b, reach, tree)


@loop
def points_in_reach(start: int, p: vec3, reach: float, tree: PointTree) -> tuple[int, float]:
    """The places and squared distances [m^2] of the points within the squared distance `reach`, from a bucket on."""
    for first in leaves_in_reach(start, p, p, reach, tree):
        for j in range(first, min(first + LEAF, tree.count)):
            sqdist = square_distance(p, tree.points[j])
            if sqdist <= reach:
                yield j, sqdist


@func
def pass_over_equal(step: walk, a: vec3, b: vec3, limit: int64, tree: PointTree, labels: array(dtype=int32)) -> walk:
    """The walk without the nodes ahead whose points all lie at one place and have keys beyond the limit.

    Without it each of n points at one place would visit all the others' buckets.
    """
    pending = step[3]
    node = int(step[2])
    buckets = int(1)  # of a child
    for above in range(int(step[0])):
        node = node // FAN
        left = int(pending >> byte_place(above + 1)) & BYTE
        if left != 0:
            record = tree.levels[above + 1] + node
            distances = measure_boxes(tree.boxes, record, a, b)
            for j in range(FAN):
                if ((left >> j) & 1) == 1:
                    first = (node * FAN + j) * buckets * BUCKET
                    if is_one_place(tree.boxes, record, j) == 1 and first < labels.shape[0]:
                        # equal points stand by index, so the first has the smallest key
                        if pack_key(distances[j], labels[first]) > limit:
                            pending = pending ^ (int64(1 << j) << byte_place(above + 1))
        buckets = buckets * FAN
    return walk(step[0], step[1], step[2], pending)


@func
def search_tree(
    p: vec3,
    start: int,
    tree: PointTree,
    labels: array(dtype=int32),
    keys: array(dtype=int64),
    base: int,
    k: int,
    room: int,
    reach: float,
) -> int:
    """Leave the k nearest points with squared distance <= reach as sorted keys in keys[base : base + k]; how many."""
    bound = reach + 0.0
    # The last key that may still belong to the result: of many points at one distance only those of low index.
    limit = key_limit(reach)
    crowd = min(room - BUCKET, 3 * k + BUCKET)  # picking is quadratic in what is held
    size = int(0)
    step = start_walk(start)
    while int(step[0]) <= tree.root:
        bucket = int(step[2])
        held = size + 0
        size = offer_bucket(bucket, p, tree, labels, keys, base, size, bound, limit)
        if size == held:
            if is_one_place(tree.boxes, bucket, 0) == 1:
                step = pass_over_equal(step, p, p, limit, tree, labels)
        if size > crowd or (size >= k and bound >= BOUNDLESS):
            size = keep_nearest(keys, base, size, k, room)
            if size == k:
                limit = min(limit, keys[base + k - 1])
                bound = key_number(limit)
        step = next_bucket(step, p, p, bound, tree)
    return keep_nearest(keys, base, thin_keys(keys, base, size, k, bound), k, room)
