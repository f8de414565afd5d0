"""Bounding-box tree over points in Hilbert order, for exact searches with any radius, count and density.

Leaves are runs of LEAF points, buckets of FAN leaves, and higher nodes have FAN children, whose boxes are tested
together. Queries start at their bucket on the curve and go up (bucket_walk.py). Build: Hilbert sort, 15.4 B written per
point. Box distances use the same unfused operations as point distances and monotonic rounding, so results are exact.
"""

import functools
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..algebra.plain_min_max import larger
from ..array_types import Indices, Integers, Points, Scalars
from ..arrays.bounds import Box, bound_each
from ..arrays.duplicates import same_point
from ..arrays.sort import SortKeys, positions
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
from ..memory import empty, host_view, upload
from .hilbert_order import (
    FEW_BITS,
    MAX_FEW_POINTS,
    HilbertCurve,
    HilbertOrder,
    few_keys,
    few_positions,
    index_of_few,
    is_few,
    levels_for,
    locate_on_curve,
    scale_of_box,
    sort_few,
)

LEAF = 8  # points per leaf
FAN = 8  # leaves per bucket
BUCKET = LEAF * FAN  # points per bucket
COPY_WINDOW = 5  # points along the curve searched for copies: a cell of it may contain several positions
ROUNDED_UP = 1.000001  # factor above the float32 rounding of a square
LARGEST_SQDIST = 3.4028234663852886e38  # [m^2] the largest float32: limit of a traversal without a radius
SIDES = 6 * FAN  # numbers per node: low x, y, z, high x, y, z of all its children
box_distances = vector(8, float32)


@struct
class PointTree:
    """Search structure over the `count` finite points of `source`, which is kept alive so that its address is not
    reused. `root`: top level (buckets are level 0); `boxes`: SIDES numbers per node (its children's boxes); `points` in
    tree order, padded with infinity; `order`: cloud rows, non-finite points last; `codes` of first points.
    """

    count: int
    root: int
    levels: array(dtype=int32)
    boxes: array(dtype=float32)
    points: array(dtype=vec3)
    order: array(dtype=int32)
    codes: array(dtype=int64)
    curve: HilbertCurve

    def __init__(self, points: Points, curve: HilbertCurve | None = None, box: Box | None = None) -> None:
        """One sync, or none with the known `box` of `bound_points`."""
        self.source, self.device = points, points.device
        self.is_searched_for_copies = False
        self.copies: Any = None  # as are `distinct`, of distinct_points.py
        self.distinct: Any = None
        if is_few(points) and self._is_built_of_few(points, curve):
            return
        hilbert = HilbertOrder(points, curve, box)
        self.low, self.high = hilbert.low, hilbert.high
        self.count, self.order, self.curve = hilbert.finite_count, hilbert.order, hilbert.curve
        sizes, first = level_sizes(-(-self.count // BUCKET))
        self.root = len(sizes) - 1
        self.levels = upload(first, int32, self.device)
        self.points = empty(-(-self.count // LEAF) * LEAF, vec3, self.device)
        self.codes = empty(sizes[0], int64, self.device)
        self.boxes = empty(int(first[-1]) * SIDES, float32, self.device)
        if self.device.is_cuda:
            buckets = sizes[1] * FAN if self.root else 1
            launch(store_leaves_kernel, buckets * WARP, [points, hilbert.codes, self])
        else:
            launch(store_leaves_kernel, sizes[0] * FAN, [points, hilbert.codes, self])
        bound_levels(self.levels, sizes, self.boxes, known=1 if self.device.is_cuda else 0)

    def _is_built_of_few(self, points: Points, curve: HilbertCurve | None) -> bool:
        """Build the tree of few points in one launch. False if a point is not finite."""
        count, device, levels = points.size, self.device, levels_for(points.size)
        sizes, _ = level_sizes(-(-count // BUCKET))
        self.count, self.root = count, len(sizes) - 1
        self.levels, self.order = empty(len(sizes) + 1, int32, device), empty(count, int32, device)
        self.points, self.codes = empty(-(-count // LEAF) * LEAF, vec3, device), empty(sizes[0], int64, device)
        self.boxes, found = empty(sum(sizes) * SIDES, float32, device), empty(8, float32, device)
        launch(build_few_kernel, 1, [points, levels, curve or _OWN_CURVE, few_keys(points), self, found])
        box = host_view(found)
        if box[6] == 0:
            return False
        self.low, self.high = box[:3] + _ZERO, box[3:6] + _ZERO  # as `box_of`: + 0 normalizes minus zero
        self.curve = curve or HilbertCurve(self.low, self.high, levels)
        self.is_searched_for_copies = bool(box[7] == 0)
        return True


def trees_of(clouds: Sequence[Points]) -> list[PointTree]:
    """The tree of each array. All are on one device. One sync on a GPU."""
    if not clouds or clouds[0].device.is_cpu:
        return [PointTree(points) for points in clouds]
    return [PointTree(points, box=box) for points, box in zip(clouds, bound_each(clouds), strict=True)]  # sync


_ZERO = np.zeros(3, np.float32)
_OWN_CURVE = HilbertCurve(_ZERO, _ZERO, 0)  # stands for the curve through the points' box


def positions_in(tree: PointTree) -> Indices:
    """0 .. count - 1, read only: int32 (count)."""
    is_small = tree.device.is_cpu and 0 < tree.count <= MAX_FEW_POINTS
    return few_positions(tree.count, tree.device) if is_small else positions(tree.count, tree.device)


def widest_square(tree: PointTree, max_sqdist: float) -> float:
    """Squared distance [m^2] that bounds both the tree's diameter and `max_sqdist`."""
    diagonal = tree.high.astype(np.float64) - tree.low if tree.count else np.zeros(3)
    return float(np.float32(min(max_sqdist, float((diagonal**2).sum()) * ROUNDED_UP)))


@functools.lru_cache(1024)
def level_sizes(count: int) -> tuple[tuple[int, ...], np.ndarray]:
    """Node counts and int32 offsets (read-only) of each level over `count` lowest nodes."""
    sizes = [max(1, count)]
    while sizes[-1] > 1:
        sizes.append(-(-sizes[-1] // FAN))
    firsts = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int32)
    firsts.flags.writeable = False
    return tuple(sizes), firsts


def bound_levels(levels: Integers, sizes: Sequence[int], boxes: Scalars, known: int) -> None:
    """Copy node boxes into the level above, from level `known` upwards. Two levels per launch on CUDA."""
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
    """Write the box of a leaf's finite points. An empty one, which no query reaches, if there are none."""
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
def store_leaves_kernel(source: array(dtype=vec3), codes: array(dtype=int64), tree: PointTree):
    """Store and bound the points of a leaf, with unreachable padding. The first of a bucket stores its code."""
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
    """Minimum over lanes whose numbers differ only in these bits."""
    a = p + vec3(0.0, 0.0, 0.0)
    for bit in range(first, last):
        x = shuffle_xor(a[0], 1 << bit)
        y = shuffle_xor(a[1], 1 << bit)
        z = shuffle_xor(a[2], 1 << bit)
        a = vec3(min(a[0], x), min(a[1], y), min(a[2], z))
    return a


@cuda_func
def write_side(lane: int, low: vec3, high: vec3, at: int, boxes: array(dtype=float32)):
    """Write a box, one number per lane. An indexed vector would be in local memory."""
    x = high[0] if lane == 3 else low[0]
    y = high[1] if lane == 4 else low[1]
    z = high[2] if lane == 5 else low[2]
    side = x if lane % 3 == 0 else y if lane % 3 == 1 else z
    if lane < 6:
        boxes[at + lane * FAN] = side


@store_leaves_kernel.on_cuda
def store_buckets_kernel(source: array(dtype=vec3), codes: array(dtype=int64), tree: PointTree):
    """CUDA variant: one warp per bucket, two points per lane, coalesced. Also bounds the bucket."""
    i = tid()
    bucket = i // WARP
    lane = i % WARP
    if lane == 0 and bucket < tree.codes.shape[0]:
        tree.codes[bucket] = codes[bucket * BUCKET] if bucket * BUCKET < tree.count else 0
    low = vec3(INFINITY, INFINITY, INFINITY)
    high = vec3(INFINITY, INFINITY, INFINITY)  # of the negated coordinates
    for half in range(2):
        position = bucket * BUCKET + half * WARP + lane
        a = vec3(INFINITY, INFINITY, INFINITY)
        b = vec3(INFINITY, INFINITY, INFINITY)
        if position < tree.count:
            p = source[tree.order[position]]
            tree.points[position] = p
            if isfinite(p):
                a = p
                b = -p
        elif position < tree.points.shape[0]:
            tree.points[position] = a
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
    a = vec3(INFINITY, INFINITY, INFINITY)
    for j in range(node * SIDES, node * SIDES + FAN):
        a = vec3(min(a[0], boxes[j]), min(a[1], boxes[j + FAN]), min(a[2], boxes[j + 2 * FAN]))
    return a


@func
def highest_corner(node: int, boxes: array(dtype=float32)) -> vec3:
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    for j in range(node * SIDES + 3 * FAN, node * SIDES + 4 * FAN):
        b = vec3(max(b[0], boxes[j]), max(b[1], boxes[j + FAN]), max(b[2], boxes[j + 2 * FAN]))
    return b


@func
def bound_node(i: int, level: int, levels: array(dtype=int32), boxes: array(dtype=float32)):
    """Copy the box of node i of the level below into its parent. A missing node gets an empty box."""
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


@kernel
def bound_nodes_kernel(level: int, levels: array(dtype=int32), boxes: array(dtype=float32)):
    """Copy the node boxes of the level below into their parents."""
    i = tid()
    bound_node(i, level, levels, boxes)


@bound_nodes_kernel.on_cuda
def bound_two_levels_kernel(level: int, levels: array(dtype=int32), boxes: array(dtype=float32)):
    """CUDA variant that also bounds the parent."""
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
def copies_after(i: int, tree: PointTree) -> int:
    """How many of the next points along the curve equal point i."""
    p = tree.points[i]
    copies = 0
    for j in range(i + 1, min(i + COPY_WINDOW, tree.count)):
        if tree.points[j][0] == p[0]:
            copies += same_point(p, tree.points[j])
    return copies


@kernel(for_cpu=True)
def build_few_kernel(
    points: array(dtype=vec3),
    own_levels: int,
    given: HilbertCurve,
    keys: SortKeys,
    tree: PointTree,
    found: array(dtype=float32),
):
    """Build the tree of up to FEW points by one thread, on a given curve unless that has no levels. `found`: box, 1 if
    all are finite (else the tree is not built), 1 if adjacent points are equal."""
    i = tid()
    low = vec3(INFINITY, INFINITY, INFINITY)
    high = vec3(-INFINITY, -INFINITY, -INFINITY)
    found[6] = 1.0
    found[7] = 0.0
    for j in range(i, tree.count):
        p = points[j]
        if not isfinite(p):
            found[6] = 0.0
        low = vec3(min(low[0], p[0]), min(low[1], p[1]), min(low[2], p[2]))
        high = vec3(max(high[0], p[0]), max(high[1], p[1]), max(high[2], p[2]))
    for axis in range(3):
        found[axis] = low[axis]
        found[axis + 3] = high[axis]
    if found[6] == 1.0:
        levels = given.levels
        scale = given.scale
        start = given.low
        if levels == 0:
            levels = own_levels
            scale = scale_of_box(low, high, levels)
            start = low + vec3(0.0, 0.0, 0.0)
        first = sort_few(points, start, scale, levels, keys)
        buckets = tree.codes.shape[0]
        for j in range(buckets):
            tree.codes[j] = keys.keys[first + j * BUCKET] >> int64(FEW_BITS)
        for j in range(tree.count):
            tree.order[j] = index_of_few(keys.keys[first + j])
            tree.points[j] = points[tree.order[j]]
        for j in range(tree.count, tree.points.shape[0]):
            tree.points[j] = vec3(INFINITY, INFINITY, INFINITY)
        for j in range(buckets * FAN):
            bound_leaf(j, tree.points, tree.count, tree.boxes)
        size = buckets + 0
        node = 0
        for level in range(tree.root + 1):
            tree.levels[level] = node
            node += size
            tree.levels[level + 1] = node
            if level > 0:
                for j in range(size * FAN):
                    bound_node(j, level, tree.levels, tree.boxes)
            size = (size + FAN - 1) // FAN
        copies = 0
        for j in range(tree.count):
            copies += copies_after(j, tree)
        if copies > 0:
            found[7] = 1.0


@func
def square_distance(p: vec3, q: vec3) -> float:
    """|p - q|^2 [m^2], summed in the order of the box distance."""
    x = q[0] - p[0]
    y = q[1] - p[1]
    z = q[2] - p[2]
    return x * x + y * y + z * z


@func
def measure_boxes(boxes: array(dtype=float32), node: int, a: vec3, b: vec3) -> box_distances:
    """Squared distances [m^2] from the box (a, b), or point (p, p), to a node's child boxes, infinite if empty."""
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
    at = node * SIDES + child
    x = larger(larger(boxes[at] - b[0], a[0] - boxes[at + 3 * FAN]), 0.0)
    y = larger(larger(boxes[at + FAN] - b[1], a[1] - boxes[at + 4 * FAN]), 0.0)
    z = larger(larger(boxes[at + 2 * FAN] - b[2], a[2] - boxes[at + 5 * FAN]), 0.0)
    return x * x + y * y + z * z


@func
def find_run(codes: array(dtype=int64), first: int, count: int, code: int64) -> int:
    """Index of the run that contains a code, by bisection over `count` first codes from `first` on."""
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
    return find_run(tree.codes, 0, (tree.count + BUCKET - 1) // BUCKET, locate_on_curve(p, tree.curve))


@func
def is_one_point(boxes: array(dtype=float32), node: int, child: int) -> int:
    at = node * SIDES + child
    equal = 1
    for axis in range(3):
        if boxes[at + axis * FAN] != boxes[at + (axis + 3) * FAN]:
            equal = 0
    return equal
