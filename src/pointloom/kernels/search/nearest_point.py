"""The nearest point of each query: groups of eight queries share one tree traversal on the CPU.

Results are keys, squared distance bits above the index, so ties go to the lower index. Twice as fast as the k-search
with k = 1. On CUDA, and for queries much sparser than the cloud, each query searches alone with the same result.
"""

import math

from ..algebra.plain_min_max import larger
from ..array_types import Indices, LongIntegers, Points
from ..arrays.packed_keys import key_index, pack_bits, pack_key
from ..lang import (
    array,
    bit_count,
    bits_float,
    compute,
    float32,
    float_bits,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    launch,
    tid,
    vec3,
    vector,
)
from ..memory import empty
from .bucket_walk import next_bucket, pass_over_equal, start_traversal
from .point_tree import (
    BUCKET,
    FAN,
    LEAF,
    SIDES,
    PointTree,
    find_bucket,
    is_one_point,
    measure_box,
    measure_boxes,
    square_distance,
)
from .tree_search import order_along_curve, search_nearest, squared_radius

lane_numbers = vector(8, float32)
lane_labels = vector(8, int32)
lane_results = vector(16, int32)  # bits of eight squared distances, then eight indices
MAX_POINTS_PER_QUERY = 16  # cloud points per query, above which groups are too wide
NO_POINT = -1  # key without a result
NO_LABEL = -1  # label without a point


@func
def measure_leaf(
    first: int,
    last: int,
    points: array(dtype=vec3),
    order: array(dtype=int32),
    xs: lane_numbers,
    ys: lane_numbers,
    zs: lane_numbers,
    own: lane_labels,
    best: lane_results,
) -> lane_results:
    """Update the lanes (distance bits compare as distances) with points first..last - 1, except a lane's own."""
    nearest = best
    for i in range(first, last):
        p = points[i]
        label = order[i]
        for j in range(LEAF):
            x = p[0] - xs[j]
            y = p[1] - ys[j]
            z = p[2] - zs[j]
            bits = float_bits(x * x + y * y + z * z)
            current = nearest[j]
            less = 1 if bits < current else 0
            tied = 1 if bits == current else 0
            lower = 1 if label < nearest[LEAF + j] else 0
            other = 1 if label != own[j] else 0
            closer = (less | (tied & lower)) & other
            nearest[j] = bits if closer == 1 else current
            nearest[LEAF + j] = label if closer == 1 else nearest[LEAF + j]
    return nearest


@func
def lane_distances(
    node: int, child: int, boxes: array(dtype=float32), xs: lane_numbers, ys: lane_numbers, zs: lane_numbers
) -> lane_numbers:
    """Squared distances [m^2] of the lanes from a child's box."""
    at = node * SIDES + child
    x0 = boxes[at]
    y0 = boxes[at + FAN]
    z0 = boxes[at + 2 * FAN]
    x1 = boxes[at + 3 * FAN]
    y1 = boxes[at + 4 * FAN]
    z1 = boxes[at + 5 * FAN]
    distances = lane_numbers(0.0)
    for j in range(LEAF):
        x = larger(larger(x0 - xs[j], xs[j] - x1), 0.0)
        y = larger(larger(y0 - ys[j], ys[j] - y1), 0.0)
        z = larger(larger(z0 - zs[j], zs[j] - z1), 0.0)
        distances[j] = x * x + y * y + z * z
    return distances


@func
def lanes_reaching(
    node: int,
    child: int,
    boxes: array(dtype=float32),
    xs: lane_numbers,
    ys: lane_numbers,
    zs: lane_numbers,
    best: lane_results,
) -> int:
    """Count of lanes not farther from a child's box than from their current result."""
    distances = lane_distances(node, child, boxes, xs, ys, zs)
    count = 0
    for j in range(LEAF):
        count += 1 if float_bits(distances[j]) <= best[j] else 0
    return count


@func
def largest_of(values: lane_results, first: int) -> int:
    largest = values[first]
    for j in range(1, LEAF):
        largest = max(largest, values[first + j])
    return largest


@func
def closest_leaf(bucket: int, a: vec3, b: vec3, boxes: array(dtype=float32)) -> int:
    distances = measure_boxes(boxes, bucket, a, b)
    nearest = 0
    for leaf in range(1, FAN):
        if distances[leaf] < distances[nearest]:
            nearest = leaf
    return bucket * FAN + nearest


@kernel(for_cpu=True)
def find_nearest_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    others: int,
    tree: PointTree,
    max_sqdist: float,
    nearest: array(dtype=int64),
):
    """Key of the nearest point of each of LEAF queries, NO_POINT if none is within `max_sqdist`."""
    i = tid()
    head = i * LEAF
    tail = min(head + LEAF, query_order.shape[0])
    none = float_bits(max_sqdist) + 1
    best = lane_results(none)
    a = queries[query_order[head]]
    if tree.count > 0 and isfinite(a):  # non-finite queries are last
        b = a + vec3(0.0, 0.0, 0.0)
        xs = lane_numbers(a[0])
        ys = lane_numbers(a[1])
        zs = lane_numbers(a[2])
        own = lane_labels(NO_LABEL)
        for rank in range(head, tail):
            row = query_order[rank]
            q = queries[row]
            if others == 1:
                own[rank - head] = row
            if isfinite(q):
                xs[rank - head] = q[0]
                ys[rank - head] = q[1]
                zs[rank - head] = q[2]
                a = vec3(min(a[0], q[0]), min(a[1], q[1]), min(a[2], q[2]))
                b = vec3(max(b[0], q[0]), max(b[1], q[1]), max(b[2], q[2]))
        start = find_bucket(queries[query_order[head]], tree)
        seed = closest_leaf(start, a, b, tree.boxes)  # its points bound the search from the start
        best = measure_leaf(
            seed * LEAF, min((seed + 1) * LEAF, tree.count), tree.points, tree.order, xs, ys, zs, own, best
        )
        farthest = largest_of(best, 0)
        bound = min(max_sqdist, bits_float(farthest))  # above infinity the bits are NaN
        step = start_traversal(start)
        while int(step[0]) <= tree.root:
            bucket = int(step[2])
            distances = measure_boxes(tree.boxes, bucket, a, b)
            is_measured = 0
            for leaf in range(FAN):
                first = bucket * BUCKET + leaf * LEAF
                if distances[leaf] <= bound and bucket * FAN + leaf != seed:
                    # up to the farthest: of coincident points only lower indices matter
                    wanted = 1
                    if float_bits(distances[leaf]) == farthest:
                        if is_one_point(tree.boxes, bucket, leaf) == 1 and tree.order[first] > largest_of(best, LEAF):
                            wanted = 0
                    if wanted == 1:
                        wanted = lanes_reaching(bucket, leaf, tree.boxes, xs, ys, zs, best)
                    if wanted > 0:
                        best = measure_leaf(
                            first, min(first + LEAF, tree.count), tree.points, tree.order, xs, ys, zs, own, best
                        )
                        farthest = largest_of(best, 0)
                        bound = min(max_sqdist, bits_float(farthest))
                        is_measured = 1
            if is_measured == 0:
                if is_one_point(tree.boxes, bucket, 0) == 1:
                    limit = pack_bits(farthest, largest_of(best, LEAF))
                    step = pass_over_equal(step, a, b, limit, tree, tree.order)
            step = next_bucket(step, a, b, bound, tree)
    for rank in range(head, tail):
        row = query_order[rank]
        q = queries[row]
        key = int64(NO_POINT)
        if best[rank - head] < none and isfinite(q):
            key = pack_bits(best[rank - head], best[LEAF + rank - head])
        nearest[row] = key


@kernel(max_registers=128)  # for two blocks per SM
def find_separately_kernel(
    queries: array(dtype=vec3),
    query_order: array(dtype=int32),
    others: int,
    tree: PointTree,
    max_sqdist: float,
    nearest: array(dtype=int64),
):
    i = tid()
    row = query_order[i]
    q = queries[row]
    none = float_bits(max_sqdist) + 1
    best = none
    label = none
    if tree.count > 0 and isfinite(q):
        own = row if others == 1 else NO_LABEL
        step = start_traversal(find_bucket(q, tree))
        bound = min(max_sqdist, bits_float(best))
        while int(step[0]) <= tree.root:
            bucket = int(step[2])
            distances = measure_boxes(tree.boxes, bucket, q, q)
            within = 0
            for leaf in range(FAN):
                within = within | ((1 if distances[leaf] <= bound else 0) << leaf)
            is_measured = 0
            while within != 0:  # one body for all leaves, to save registers
                lowest = within & (-within)
                within = within ^ lowest
                leaf = bit_count(lowest - 1)
                first = bucket * BUCKET + leaf * LEAF
                distance = float_bits(measure_box(tree.boxes, bucket, leaf, q, q))
                wanted = 1 if distance <= float_bits(bound) else 0
                if wanted == 1 and distance == best:  # of coincident points only the lower index
                    if is_one_point(tree.boxes, bucket, leaf) == 1 and tree.order[first] > label:
                        wanted = 0
                if wanted == 1:
                    for j in range(first, min(first + LEAF, tree.count)):
                        bits = float_bits(square_distance(q, tree.points[j]))
                        if bits <= best:
                            other = tree.order[j]
                            if (bits < best or other < label) and other != own:
                                best = bits
                                label = other
                    bound = min(max_sqdist, bits_float(best))
                    is_measured = 1
            if is_measured == 0:
                if is_one_point(tree.boxes, bucket, 0) == 1:
                    step = pass_over_equal(step, q, q, pack_bits(best, label), tree, tree.order)
            step = next_bucket(step, q, q, bound, tree)
    key = int64(NO_POINT)
    if best < none:
        key = pack_bits(best, label)
    nearest[row] = key


@kernel(for_cpu=True)
def pack_neighbor_kernel(
    indices: array(dtype=int32, ndim=2),
    sqdists: array(dtype=float32, ndim=2),
    counts: array(dtype=int32),
    others: int,
    nearest: array(dtype=int64),
):
    """Key of one column of a k-search: the first, or the first that is not the query itself."""
    i = tid()
    column = 0
    if others == 1 and indices[i, 0] == i:
        column = 1
    key = int64(NO_POINT)
    if counts[i] > column:
        key = pack_key(sqdists[i, column], indices[i, column])
    nearest[i] = key


def find_nearest(
    tree: PointTree,
    queries: Points,
    *,
    radius: float = math.inf,
    others: bool = False,
    order: Indices | None = None,
    nearest: LongIntegers | None = None,
) -> LongIntegers:
    """Nearest point of each query closer than a radius [m] (exclusive), int64 (m): squared distance bits above the
    index, or NO_POINT. `others`: the queries are the tree's own points. `order`: rows of the queries, neighbors near
    each other and non-finite ones last, such as the order of a tree over the queries before a rigid motion.
    """
    nearest = empty(queries.size, int64, queries.device) if nearest is None else nearest
    is_separate = queries.device.is_cuda
    if tree.count > MAX_POINTS_PER_QUERY * queries.size and not is_separate:
        result = search_nearest(tree, queries, 2 if others else 1, radius)
        launch(pack_neighbor_kernel, queries.size, [*result, int(others), nearest])
        return nearest
    if order is None:
        order = tree.order if tree.source.ptr == queries.ptr else order_along_curve(tree, queries)
    search = [tree, squared_radius(radius), nearest]
    if is_separate:
        launch(find_separately_kernel, queries.size, [queries, order, int(others), *search])
    else:
        launch(find_nearest_kernel, -(-queries.size // LEAF), [queries, order, int(others), *search])
    return nearest


@kernel
def unpack_rows_kernel(nearest: array(dtype=int64), rows: array(dtype=int32)):
    i = tid()
    rows[i] = key_index(nearest[i])


def find_nearest_rows(tree: PointTree, queries: Points) -> Indices:
    """Row of the nearest point of each query, int32 (m), or -1."""
    return compute(unpack_rows_kernel, queries.size, [find_nearest(tree, queries)], int32, queries.device)
