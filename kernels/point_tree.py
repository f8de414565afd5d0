"""A tree of boxes over points in Hilbert order: one exact search structure for every radius, count and density.

Leaves are runs of LEAF points of the order; node j of a level is the box of nodes 2j and 2j+1 below. Nothing depends
on the density of the cloud, there is no cell size to guess, and the tree need not be built again for another radius.
Build: the Hilbert sort, then 24 B written a node. A query walks up from the leaf where it lies on the curve, and at
each step down into the sibling's boxes that reach into the ball of the best points so far, without a stack.

Exactness: the distance of a box is computed by the same operations as the distance of a point. Rounding is monotonic,
so a box is never farther than a point in it, and nothing that belongs to the result is left out, ties included.

A result is kept as one 64-bit key a neighbour, the bits of its squared distance above its index: keys in ascending
order are neighbours by distance, ties by index.
"""

import math

import numpy as np

from .lang import (
    array,
    bits_float,
    float_bits,
    func,
    int32,
    int64,
    kernel,
    launch,
    tid,
    vec3,
    vec4i,
)
from .memory import empty, upload
from .spatial_order import SpatialOrder, locate_on_curve

LEAF = 8  # points a leaf; 4 and 16 were 10 to 20 % slower for 20 neighbours on surfaces
INFINITY = math.inf
FAR = 3.0e38  # [m^2] a bound beyond this is none
INDEX_MASK = 0xFFFF_FFFF  # the half of a key that holds the index


@kernel
def gather_points_kernel(points: array(dtype=vec3), order: array(dtype=int32), sorted_points: array(dtype=vec3)):
    """sorted_points[i] = points[order[i]]."""
    i = tid()
    sorted_points[i] = points[order[i]]


@kernel
def bound_leaves_kernel(points: array(dtype=vec3), count: int, low: array(dtype=vec3), high: array(dtype=vec3)):
    """The boxes of the leaves; leaves beyond the last point are empty boxes, which no query reaches."""
    i = tid()
    a = vec3(INFINITY, INFINITY, INFINITY)
    b = vec3(-INFINITY, -INFINITY, -INFINITY)
    for j in range(i * LEAF, min((i + 1) * LEAF, count)):
        p = points[j]
        a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
        b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
    low[i] = a
    high[i] = b


@kernel
def bound_nodes_kernel(below: int, first: int, low: array(dtype=vec3), high: array(dtype=vec3)):
    """The boxes of one level from the level below."""
    i = tid()
    j = below + 2 * i
    a = low[j]
    b = low[j + 1]
    c = high[j]
    d = high[j + 1]
    low[first + i] = vec3(min(a[0], b[0]), min(a[1], b[1]), min(a[2], b[2]))
    high[first + i] = vec3(max(c[0], d[0]), max(c[1], d[1]), max(c[2], d[2]))


@func
def square_distance(p: vec3, q: vec3) -> float:
    """|p - q|^2 [m^2], summed as the box distance is."""
    x = q[0] - p[0]
    y = q[1] - p[1]
    z = q[2] - p[2]
    return x * x + y * y + z * z


@func
def box_square_distance(a: vec3, b: vec3, low: vec3, high: vec3) -> float:
    """Squared distance [m^2] between the boxes (a, b) and (low, high); a point is the box (p, p).

    Infinite for an empty box.
    """
    x = max(max(low[0] - b[0], a[0] - high[0]), 0.0)
    y = max(max(low[1] - b[1], a[1] - high[1]), 0.0)
    z = max(max(low[2] - b[2], a[2] - high[2]), 0.0)
    return x * x + y * y + z * z


@func
def find_leaf(codes: array(dtype=int64), count: int, code: int64) -> int:
    """The leaf whose run on the curve holds a code, by bisection over the first codes of the leaves."""
    a = int(0)
    b = (count + LEAF - 1) // LEAF
    while b - a > 1:
        middle = (a + b) // 2
        if codes[middle * LEAF] <= code:
            a = middle
        else:
            b = middle
    return a


@func
def offer_leaf(
    leaf: int,
    p: vec3,
    count: int,
    points: array(dtype=vec3),
    order: array(dtype=int32),
    keys: array(dtype=int64),
    base: int,
    held: int,
    reach: float,
) -> int:
    """Append the keys of the points of a leaf with squared distance <= reach; how many keys are then held.

    Every key is stored and the count moves on only for those within reach: no branch to mispredict.
    """
    size = held + 0
    for j in range(leaf * LEAF, min((leaf + 1) * LEAF, count)):
        d = square_distance(p, points[j])
        keys[base + size] = (int64(float_bits(d)) << int64(32)) | int64(order[j])
        if d <= reach:
            size += 1
    return size


@func
def keep_nearest(keys: array(dtype=int64), base: int, held: int, k: int, room: int) -> int:
    """Sort the keys held at `base` and keep the k smallest; how many are left.

    Each key's place is the number of smaller keys. That is quadratic, yet at these sizes faster than a sort: the inner
    loop has no branch and runs in vector registers. Keys differ, since each holds the index of its point.
    """
    for a in range(held):
        key = keys[base + a]
        place = int64(0)  # as wide as the keys, so that both share vector registers
        for b in range(held):
            if keys[base + b] < key:
                place += int64(1)
        if int(place) < k:
            keys[base + room + int(place)] = key
    left = min(held, k)
    for a in range(left):
        keys[base + a] = keys[base + room + a]
    return left


@func
def thin_keys(keys: array(dtype=int64), base: int, held: int, k: int, reach: float) -> int:
    """Drop far keys while at least k are left, by a guess at the k-th distance on a surface; how many are left.

    Points within a squared radius grow in proportion to it on a surface, so k of `held` lie within about k / held of
    the reach. A wrong guess only leaves more keys to sort.
    """
    left = held + 0
    if held > k + k // 4 and reach < FAR:
        guess = reach * (float(k) / float(held)) * 1.25
        limit = (int64(float_bits(guess)) + int64(1)) << int64(32)
        near = int(0)
        for j in range(base, base + held):
            if keys[j] < limit:
                near += 1
        if near >= k:
            left = int(0)
            for j in range(base, base + held):
                key = keys[j]
                keys[base + left] = key
                if key < limit:
                    left += 1
    return left


@func
def next_leaf(
    cursor: vec4i,
    a: vec3,
    b: vec3,
    bound: float,
    root: int,
    levels: array(dtype=int32),
    low: array(dtype=vec3),
    high: array(dtype=vec3),
) -> vec4i:
    """Move a cursor (ancestor, height, level, node) to the next leaf whose box lies within `bound` of the box (a, b).

    The walk begins at (start leaf, -1, -1, 0), goes up from there, and at each height down into the sibling of the
    ancestor. It ends with height == root; else node is the leaf. The bound may shrink between the steps.
    """
    ancestor = cursor[0]
    height = cursor[1]
    level = cursor[2]
    node = cursor[3]
    searching = int(1)
    down = int(0)
    while searching == 1:
        if down == 1:
            level = level - 1
            node = node * 2
        else:
            while level < height and (node & 1) == 1:
                node = node // 2
                level = level + 1
            if level == height:
                if height >= 0:
                    ancestor = ancestor // 2
                height = height + 1
                level = height
                node = ancestor ^ 1
            else:
                node = node + 1
        down = 0
        if height >= root:
            searching = 0
        else:
            at = levels[level] + node
            if box_square_distance(a, b, low[at], high[at]) <= bound:
                if level == 0:
                    searching = 0
                else:
                    down = 1
    return vec4i(ancestor, height, level, node)


@func
def search_tree(
    p: vec3,
    start: int,
    count: int,
    root: int,
    levels: array(dtype=int32),
    low: array(dtype=vec3),
    high: array(dtype=vec3),
    points: array(dtype=vec3),
    order: array(dtype=int32),
    keys: array(dtype=int64),
    base: int,
    k: int,
    room: int,
    reach: float,
) -> int:
    """Leave the k nearest points with squared distance <= reach as sorted keys in keys[base : base + k]; how many."""
    bound = reach + 0.0
    size = int(0)
    leaf = start + 0
    cursor = vec4i(start, -1, -1, 0)
    while cursor[1] < root:
        size = offer_leaf(leaf, p, count, points, order, keys, base, size, bound)
        if size > room - LEAF or (size >= k and bound >= FAR):
            size = keep_nearest(keys, base, size, k, room)
            if size == k:
                bound = min(bound, bits_float(int(keys[base + k - 1] >> int64(32))))
        cursor = next_leaf(cursor, p, p, bound, root, levels, low, high)
        leaf = cursor[3]
    return keep_nearest(keys, base, thin_keys(keys, base, size, k, bound), k, room)


class PointTree:
    """The search structure over the finite points of a device array."""

    def __init__(self, points):
        self.source = points  # kept alive, so that no other array can take its address
        self.curve = SpatialOrder(points)
        self.count, self.device = self.curve.finite_count, points.device
        self.order = self.curve.order
        self.points = empty(self.count, vec3, self.device)
        launch(gather_points_kernel, self.count, [points, self.order, self.points])
        sizes, first = [], [0]
        width = max(1, -(-self.count // LEAF))
        while True:
            padded = width if width == 1 else width + width % 2
            sizes.append(padded)
            first.append(first[-1] + padded)
            if width == 1:
                break
            width = padded // 2
        self.root = len(sizes) - 1
        self.levels = upload(np.array(first, np.int32), int32, self.device)
        self.low, self.high = empty(first[-1], vec3, self.device), empty(first[-1], vec3, self.device)
        launch(bound_leaves_kernel, sizes[0], [self.points, self.count, self.low, self.high])
        for level in range(1, len(sizes)):
            launch(bound_nodes_kernel, sizes[level - 1] // 2, [first[level - 1], first[level], self.low, self.high])
        curve = self.curve
        low = vec3(*curve.low) if self.count else vec3(0.0)
        self.curve_arguments = [curve.codes, low, curve.scale, curve.levels]
        self.tree_arguments = [self.count, self.root, self.levels, self.low, self.high, self.points]
