"""Farthest point sampling: each choice is the point farthest from all points chosen before it.

Eldar, Lindenbaum, Porat and Zeevi, "The farthest point strategy for progressive image sampling", IEEE Transactions on
Image Processing 6(9), 1997. The plain algorithm measures all n points for each of m choices. Here each point keeps its
squared distance to the chosen ones as one 64-bit key, the bits of the distance above its index counted from the end;
each leaf, bucket and node of a PointTree keeps the largest key below it. The largest key of all is then the farthest
point, of points equally far the one of lowest index. A choice can only bring points closer whose box lies nearer to it
than the largest distance in that box: the rest of the tree keeps its keys. On a surface a choice then touches about
n / s points for the s-th of m choices, O(n log m) together, where the plain algorithm takes O(n m).

On the CPU one thread descends from the root, choice after choice. On CUDA a choice is one launch of a thread a bucket,
and the host waits for none of them: the largest key travels through the array of choices. Both give the same bits:
the distance of a box is computed by the same operations as that of a point, so rounding never hides a point, and
minimum and maximum depend on no order. 20 B a point beside the tree.
"""

from ..arrays.packed_keys import INDEX_MASK, key_number
from ..lang import (
    array,
    atomic_max,
    float32,
    float_bits,
    func,
    int32,
    int64,
    kernel,
    launch,
    tid,
    vec3,
    vector,
)
from ..memory import download, empty, full, zeros
from ..search.point_tree import FAN, LEAF, SIDES, box_distances, measure_boxes

leaf_keys = vector(8, int64)
UNREACHED = 0x7F80_0000_0000_0000  # the key of an infinite distance, without its index
APART = 0x1_0000_0000  # keys from here on are of points at some distance from all that are chosen
CHOICES = 4096  # a CPU launch: a fraction of a second, so that an interrupt is heard


@func
def index_of(key: int64) -> int:
    """The index of a key's point."""
    return int(int64(INDEX_MASK) - (key & int64(INDEX_MASK)))


@kernel
def start_keys_kernel(
    points: array(dtype=vec3),
    order: array(dtype=int32),
    count: int,
    xs: array(dtype=float32),
    ys: array(dtype=float32),
    zs: array(dtype=float32),
    keys: array(dtype=int64),
):
    """Coordinates by axis, and keys of points that nothing is near yet; what fills up the last leaf is never chosen."""
    i = tid()
    p = vec3(0.0, 0.0, 0.0)
    key = int64(0)
    if i < count:
        p = points[i]
        key = int64(UNREACHED) | (int64(INDEX_MASK) - int64(order[i]))
    xs[i] = p[0]
    ys[i] = p[1]
    zs[i] = p[2]
    keys[i] = key


@func
def approach_leaf(
    leaf: int,
    p: vec3,
    xs: array(dtype=float32),
    ys: array(dtype=float32),
    zs: array(dtype=float32),
    keys: array(dtype=int64),
) -> int64:
    """Bring the keys of a leaf down to their distance to p; the largest of them.

    In three loops, so that the CPU runs each in vector registers.
    """
    first = leaf * LEAF
    distances = box_distances(0.0)
    for j in range(LEAF):
        x = p[0] - xs[first + j]
        y = p[1] - ys[first + j]
        z = p[2] - zs[first + j]
        distances[j] = x * x + y * y + z * z
    near = leaf_keys(int64(0))
    for j in range(LEAF):
        key = keys[first + j]
        offered = (int64(float_bits(distances[j])) << int64(32)) | (key & int64(INDEX_MASK))
        near[j] = offered if offered < key else key
    top = int64(0)
    for j in range(LEAF):
        keys[first + j] = near[j]
        top = near[j] if near[j] > top else top
    return top


@func
def approach_bucket(
    bucket: int,
    p: vec3,
    leaf_count: int,
    boxes: array(dtype=float32),
    xs: array(dtype=float32),
    ys: array(dtype=float32),
    zs: array(dtype=float32),
    keys: array(dtype=int64),
    leaf_tops: array(dtype=int64),
) -> int64:
    """Bring the keys of a bucket down to their distance to p, leaf by leaf where that may change one; the largest."""
    distances = measure_boxes(boxes, bucket, p, p)
    top = int64(0)
    for j in range(FAN):
        leaf = bucket * FAN + j
        if leaf < leaf_count:
            key = leaf_tops[leaf]
            if distances[j] <= key_number(key):
                key = approach_leaf(leaf, p, xs, ys, zs, keys)
                leaf_tops[leaf] = key
            top = max(top, key)
    return top


@func
def list_buckets_near(
    p: vec3,
    root: int,
    levels: array(dtype=int32),
    boxes: array(dtype=float32),
    tops: array(dtype=int64),
    queue: array(dtype=int32),
) -> int:
    """Queue the nodes that may hold a point closer to p than to all chosen ones, from the root down to the buckets.

    Returns where the buckets end; each level stands behind the one above it.
    """
    begin = int(0)
    end = int(1)
    queue[0] = levels[root]
    for step in range(root):
        above = levels[root - step]
        below = levels[root - step - 1]
        tail = end + 0
        for q in range(begin, end):
            distances = measure_boxes(boxes, queue[q], p, p)
            first = below + (queue[q] - above) * FAN
            for j in range(FAN):
                child = first + j
                if child < above:
                    if distances[j] <= key_number(tops[child]):
                        queue[tail] = child
                        tail += 1
        begin = end
        end = tail
    return end


@func
def approach_tree(
    p: vec3,
    root: int,
    leaf_count: int,
    levels: array(dtype=int32),
    boxes: array(dtype=float32),
    xs: array(dtype=float32),
    ys: array(dtype=float32),
    zs: array(dtype=float32),
    keys: array(dtype=int64),
    leaf_tops: array(dtype=int64),
    tops: array(dtype=int64),
    queue: array(dtype=int32),
) -> int64:
    """Bring all keys down to their distance to p; the largest of them."""
    end = list_buckets_near(p, root, levels, boxes, tops, queue)
    level = int(0)
    for step in range(end):  # from the last bucket back to the root, so that children come before their parents
        node = queue[end - 1 - step]
        if node >= levels[level + 1]:  # no level is left out: the path to p itself is always queued
            level += 1
        if level == 0:
            tops[node] = approach_bucket(node, p, leaf_count, boxes, xs, ys, zs, keys, leaf_tops)
        else:
            first = levels[level - 1] + (node - levels[level]) * FAN
            top = int64(0)
            for child in range(first, min(first + FAN, levels[level])):
                top = max(top, tops[child])
            tops[node] = top
    return tops[levels[root]]


@kernel
def choose_in_turn_kernel(
    first: int,
    last: int,
    points: array(dtype=vec3),
    root: int,
    leaf_count: int,
    levels: array(dtype=int32),
    boxes: array(dtype=float32),
    xs: array(dtype=float32),
    ys: array(dtype=float32),
    zs: array(dtype=float32),
    keys: array(dtype=int64),
    leaf_tops: array(dtype=int64),
    tops: array(dtype=int64),
    queue: array(dtype=int32),
    chosen: array(dtype=int64),
):
    """A run of choices by one thread; chosen[turn + 1] is the farthest point after the choice of that turn."""
    i = tid()
    for turn in range(first + i, last):
        key = chosen[turn]
        farthest = int64(0)
        if key >= int64(APART):
            farthest = approach_tree(
                points[index_of(key)], root, leaf_count, levels, boxes, xs, ys, zs, keys, leaf_tops, tops, queue
            )
        chosen[turn + 1] = farthest


@kernel
def choose_at_once_kernel(
    turn: int,
    points: array(dtype=vec3),
    leaf_count: int,
    boxes: array(dtype=float32),
    xs: array(dtype=float32),
    ys: array(dtype=float32),
    zs: array(dtype=float32),
    keys: array(dtype=int64),
    leaf_tops: array(dtype=int64),
    chosen: array(dtype=int64),
):
    """One choice by a thread a bucket; chosen[turn + 1] must be 0 before."""
    i = tid()
    key = chosen[turn]
    if key >= int64(APART):
        top = approach_bucket(i, points[index_of(key)], leaf_count, boxes, xs, ys, zs, keys, leaf_tops)
        if top > chosen[turn + 1]:  # spares most of the atomics; an old value only lets one more through
            atomic_max(chosen, turn + 1, top)  # settles which bucket has the farthest point: the largest key


def choose_farthest(tree, sample_count, start, at_once=None):
    """Choose points one after the other, each the farthest from all before it.

    Args:
        tree: A PointTree.
        sample_count: How many to choose.
        start: The index of the first; a finite point.
        at_once: Whether a choice is one launch of a thread a bucket, instead of one thread for all choices; None for
            what suits the device.

    Returns:
        Indices in the order of choice, int32 NumPy array; fewer than asked once all finite points coincide with a
        chosen one. One sync.
    """
    device, points = tree.device, tree.source
    leaf_count = -(-tree.count // LEAF)
    bucket_count = -(-leaf_count // FAN)
    xs, ys, zs = (empty(leaf_count * LEAF, float32, device) for _ in range(3))
    keys = empty(leaf_count * LEAF, int64, device)
    launch(start_keys_kernel, leaf_count * LEAF, [tree.points, tree.order, tree.count, xs, ys, zs, keys])
    leaf_tops = full(leaf_count, UNREACHED, int64, device)
    chosen = zeros(sample_count + 1, int64, device)
    chosen[:1].fill_(UNREACHED | (INDEX_MASK - start))
    if device.is_cuda if at_once is None else at_once:
        rest = [points, leaf_count, tree.boxes, xs, ys, zs, keys, leaf_tops, chosen]
        for turn in range(sample_count - 1):
            launch(choose_at_once_kernel, bucket_count, [turn, *rest])
    else:
        node_count = tree.boxes.size // SIDES
        tops = full(node_count, UNREACHED, int64, device)
        queue = empty(node_count, int32, device)
        rest = [
            points,
            tree.root,
            leaf_count,
            tree.levels,
            tree.boxes,
            xs,
            ys,
            zs,
            keys,
            leaf_tops,
            tops,
            queue,
            chosen,
        ]
        for first in range(0, sample_count - 1, CHOICES):
            launch(choose_in_turn_kernel, 1, [first, min(first + CHOICES, sample_count - 1), *rest])
    found = download(chosen)[:sample_count]  # sync
    return (INDEX_MASK - (found[found >= APART] & INDEX_MASK)).astype("int32")
