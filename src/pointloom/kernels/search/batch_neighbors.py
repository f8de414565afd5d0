"""The k nearest points of each query in its cloud of a batch, in one launch for all clouds.

Float32 on the CPU in groups of eight queries as in group_search.py, else each query alone. Float64 points are sorted
and bounded in float32 about the first point of their cloud, with a margin for rounding, and measured in float64.
"""

from ..array_types import AnyArray, Array2
from ..arrays.packed_keys import key_index, key_limit, key_number, pack_key
from ..lang import (
    INFINITY,
    WARP,
    array,
    compute,
    float32,
    float64,
    func,
    int32,
    int64,
    isfinite,
    kernel,
    lane,
    launch,
    sqrt,
    struct,
    tid,
    vec3,
    vec3d,
)
from ..memory import empty, fill, flat
from .cloud_batch import CloudBatch, CloudRows, SortedRows, cloud_of_rank, find_start, leaves_of_cloud, owner_of_row
from .group_scratch import GroupScratch, LaunchPart
from .group_search import SQDIST_GROWTH, grown_sqradius, is_repeated, pick_within
from .neighbor_keys import UNLIMITED_SQRADIUS, keep_nearest, thin_keys
from .point_tree import BUCKET, LARGEST_SQDIST, LEAF, square_distance
from .tree_search import squared_radius

FLOAT32_ROUNDING = 1.2e-7  # relative: above 2^-23, for the rounding of a query and of a point on three axes
FLOAT32_MARGIN = 1.000001  # factor above the rounding of a sum of squares and of its conversion


@func
def is_searched(rank: int, cloud: int, queries: array(dtype=vec3), rows: SortedRows) -> int:
    """1 if a query is finite and not padding."""
    row = rows.order[rank]
    end = rows.clouds.starts[cloud] + rows.clouds.sizes[cloud]
    return 1 if row < end and isfinite(queries[row]) else 0


@func
def gather_of_cloud(
    cloud: int, start: int, a: vec3, b: vec3, max_sqdist: float, batch: CloudBatch, scratch: GroupScratch, base: int
) -> int:
    """As `gather_candidates` of group_search.py."""
    size = 0
    near = max_sqdist
    for first, last, _ in leaves_of_cloud(cloud, start, a, b, near, batch):
        if size + LEAF > scratch.gather:
            size = scratch.gather + 1
            near = -1.0
        else:
            for j in range(first, last):
                p = batch.points[j]
                scratch.xs[base + size] = p[0]
                scratch.ys[base + size] = p[1]
                scratch.zs[base + size] = p[2]
                scratch.ids[base + size] = batch.rows.order[j]
                size += 1
    return size


@func
def search_cloud(
    p: vec3,
    cloud: int,
    start: int,
    batch: CloudBatch,
    keys: array(dtype=int64),
    base: int,
    stride: int,
    k: int,
    room: int,
    max_sqdist: float,
) -> int:
    """Write the k nearest points of a cloud within `max_sqdist` as sorted keys from `base` on. Return the count."""
    bound = max_sqdist
    limit = key_limit(max_sqdist)
    crowd = min(room - BUCKET, 3 * k + BUCKET)
    size = 0
    for first, last, _ in leaves_of_cloud(cloud, start, p, p, bound, batch):
        for j in range(first, last):
            key = pack_key(square_distance(p, batch.points[j]), batch.rows.order[j])
            keys[base + size * stride] = key
            if key <= limit:
                size += 1
        if size > crowd or (size >= k and bound >= UNLIMITED_SQRADIUS):
            size = keep_nearest(keys, base, stride, size, k, room)
            if size == k:
                limit = min(limit, keys[base + (k - 1) * stride])
                bound = key_number(limit)
    return keep_nearest(keys, base, stride, thin_keys(keys, base, stride, size, k, bound), k, room)


@func
def search_of_group(
    p: vec3,
    cloud: int,
    start: int,
    gathered: int,
    covered: float,
    batch: CloudBatch,
    scratch: GroupScratch,
    first: int,
    base: int,
    max_sqdist: float,
) -> int:
    """As `search_member` of group_search.py."""
    size = -1
    if gathered <= scratch.gather:
        near = min(max_sqdist, covered)
        size = pick_within(p, scratch, first, gathered, base, near)
        if size < scratch.k and near < max_sqdist:
            size = -1
        else:
            size = thin_keys(scratch.keys, base, 1, size, scratch.k, near)
            size = keep_nearest(scratch.keys, base, 1, size, scratch.k, scratch.room)
    if size < 0:
        size = search_cloud(p, cloud, start, batch, scratch.keys, base, 1, scratch.k, scratch.room, max_sqdist)
    return size


@struct
class NeighborRows:
    """Results, int64 and float32 (queries * k). `is_local`: 1 for indices within the cloud, else within all rows."""

    is_local: int
    indices: array(dtype=int64)
    sqdists: array(dtype=float32)

    def __init__(self, indices: Array2[int64], sqdists: AnyArray, is_local: bool) -> None:
        self.is_local, self.indices, self.sqdists = int(is_local), flat(indices), flat(sqdists)


@func
def write_neighbors(
    row: int, first_row: int, size: int, base: int, stride: int, scratch: GroupScratch, found: NeighborRows
):
    """Write the sorted keys of a query. Missing neighbors are -1 at infinite distance."""
    first = row * scratch.k
    shift = int64(first_row * found.is_local)
    for j in range(size):
        key = scratch.keys[base + j * stride]
        found.indices[first + j] = int64(key_index(key)) - shift
        found.sqdists[first + j] = key_number(key)
    for j in range(size, scratch.k):
        found.indices[first + j] = int64(-1)
        found.sqdists[first + j] = INFINITY


@kernel
def search_batch_kernel(
    queries: array(dtype=vec3),
    rows: SortedRows,
    part: LaunchPart,
    batch: CloudBatch,
    scratch: GroupScratch,
    max_sqdist: float,
    found: NeighborRows,
):
    i = tid()
    base = i * (scratch.room + scratch.k)
    listing = i * scratch.gather
    before = vec3(0.0, 0.0, 0.0)
    bound = float(INFINITY)
    widest = float(INFINITY)
    cloud = -1
    count = queries.shape[0]
    for group in range(part.first + i * part.run, min(part.first + (i + 1) * part.run, part.last)):
        head = group * LEAF
        while head < min((group + 1) * LEAF, count):
            here = cloud_of_rank(head, rows)
            if here != cloud:
                cloud = here
                bound = float(INFINITY)
                widest = float(INFINITY)
            tail = head + 1
            a = queries[rows.order[head]]
            b = a + vec3(0.0, 0.0, 0.0)
            searching = 1
            while searching == 1:  # up to the next cloud
                if tail < min((group + 1) * LEAF, count):
                    q = queries[rows.order[tail]]
                    if cloud_of_rank(tail, rows) != cloud:
                        searching = 0
                    else:
                        if is_searched(tail, cloud, queries, rows) == 1:
                            a = vec3(min(a[0], q[0]), min(a[1], q[1]), min(a[2], q[2]))
                            b = vec3(max(b[0], q[0]), max(b[1], q[1]), max(b[2], q[2]))
                        tail += 1
                else:
                    searching = 0
            gathered = scratch.gather + 1
            start = 0
            covered = min(max_sqdist, widest * SQDIST_GROWTH)
            widest = 0.0
            is_open = is_searched(head, cloud, queries, rows)  # those that are not are last
            if batch.roots[cloud] < 0:
                is_open = 0
            if is_open == 1:
                start = find_start(head, cloud, rows, batch)
                if scratch.gather > 0 and covered < UNLIMITED_SQRADIUS:
                    gathered = gather_of_cloud(cloud, start, a, b, covered, batch, scratch, listing)
            for rank in range(head, tail):
                row = rows.order[rank]
                p = queries[row]
                size = 0
                if is_open * is_searched(rank, cloud, queries, rows) == 1:
                    if is_repeated(p, before, bound) == 1:
                        size = scratch.k
                    else:
                        near = min(max_sqdist, grown_sqradius(bound, square_distance(before, p)))
                        size = search_of_group(p, cloud, start, gathered, covered, batch, scratch, listing, base, near)
                        before = p
                        bound = float(INFINITY)
                        if size == scratch.k:
                            bound = key_number(scratch.keys[base + scratch.k - 1])
                    widest = max(widest, bound)
                write_neighbors(row, batch.rows.clouds.starts[cloud], size, base, 1, scratch, found)
            head = tail + 0


@search_batch_kernel.on_cuda
def search_batch_alone_kernel(
    queries: array(dtype=vec3),
    rows: SortedRows,
    part: LaunchPart,
    batch: CloudBatch,
    scratch: GroupScratch,
    max_sqdist: float,
    found: NeighborRows,
):
    """CUDA variant, one query per lane."""
    i = tid()
    first = part.first + (i // WARP) * part.run
    for group in range(first, min(first + part.run, part.last)):
        rank = group * WARP + lane()
        if rank < queries.shape[0]:
            cloud = cloud_of_rank(rank, rows)
            row = rows.order[rank]
            size = 0
            if is_searched(rank, cloud, queries, rows) == 1 and batch.roots[cloud] >= 0:
                start = find_start(rank, cloud, rows, batch)
                size = search_cloud(
                    queries[row],
                    cloud,
                    start,
                    batch,
                    scratch.keys,
                    i,
                    scratch.stride,
                    scratch.k,
                    scratch.room,
                    max_sqdist,
                )
            write_neighbors(row, batch.rows.clouds.starts[cloud], size, i, scratch.stride, scratch, found)


def search_batch(
    queries: AnyArray,
    query_clouds: CloudRows,
    points: AnyArray,
    clouds: CloudRows,
    k: int,
    radius: float,
    is_local: bool,
) -> tuple[Array2[int64], AnyArray]:
    """(indices int64 (m, k), sqdists (m, k)) of the nearest points closer than a radius [m] of each query in its cloud,
    by distance, ties by index; missing ones are -1 and infinite. vec3 or vec3d. No wait for the device.
    """
    device, count, is_wide = queries.device, queries.size, points.dtype == vec3d
    indices = empty((count, k), int64, device)
    sqdists = empty((count, k), float64 if is_wide else float32, device)
    if not count:
        return indices, sqdists
    if not points.size:
        fill(indices, -1)
        fill(sqdists, INFINITY)
        return indices, sqdists
    is_self = queries.ptr == points.ptr and queries.size == points.size and query_clouds is clouds
    near_queries, near_points = queries, points
    if is_wide:
        near_points = compute(shift_rows_kernel, points.size, [points, points, clouds, clouds.starts], vec3, device)
        near_queries = near_points
        if not is_self:
            shifting = [queries, points, query_clouds, clouds.starts]
            near_queries = compute(shift_rows_kernel, count, shifting, vec3, device)
    batch = CloudBatch(near_points, clouds)
    rows = batch.rows if is_self else SortedRows(near_queries, query_clouds, batch.cloud_boxes)
    if is_wide:
        arguments = [queries, near_queries, rows, batch, points, k, float(radius), int(is_local)]
        launch(search_wide_kernel, count, [*arguments, flat(indices), flat(sqdists)])
        return indices, sqdists
    scratch, found = GroupScratch(device, count, k), NeighborRows(indices, sqdists, is_local)
    for part in scratch.parts():
        launch(search_batch_kernel, part.threads, [queries, rows, part, batch, scratch, squared_radius(radius), found])
    return indices, sqdists


@kernel
def shift_rows_kernel(
    queries: array(dtype=vec3d),
    points: array(dtype=vec3d),
    clouds: CloudRows,
    starts: array(dtype=int32),
    shifted: array(dtype=vec3),
):
    """Rows in float32 about the first point of the other batch's cloud, which starts at `starts`."""
    i = tid()
    origin = points[min(starts[owner_of_row(clouds.starts, i)], points.shape[0] - 1)]
    p = queries[i]
    if isfinite(origin):
        p = p - origin
    shifted[i] = vec3(float(p[0]), float(p[1]), float(p[2]))


@func
def largest_coordinate(cloud: int, boxes: array(dtype=float32)) -> float:
    largest = 0.0
    for side in range(6 * cloud, 6 * cloud + 6):
        largest = max(largest, abs(boxes[side]))
    return largest


@func
def widened_square(distance: float64, margin: float) -> float:
    """Squared distance [m^2] in float32 within which the boxes of all points at a distance are. Finite."""
    reach = distance + float64(margin)
    return float(min(reach * reach * float64(FLOAT32_MARGIN), float64(LARGEST_SQDIST)))


@kernel
def search_wide_kernel(
    queries: array(dtype=vec3d),
    near_queries: array(dtype=vec3),
    rows: SortedRows,
    batch: CloudBatch,
    points: array(dtype=vec3d),
    k: int,
    radius: float64,
    is_local: int,
    indices: array(dtype=int64),
    sqdists: array(dtype=float64),
):
    """The nearest points in float64, by insertion into the results."""
    i = tid()
    cloud = cloud_of_rank(i, rows)
    row = rows.order[i]
    q = queries[row]
    p = near_queries[row]
    first = row * k
    size = 0
    if is_searched(i, cloud, near_queries, rows) == 1 and batch.roots[cloud] >= 0:
        reach = largest_coordinate(cloud, batch.cloud_boxes) + max(max(abs(p[0]), abs(p[1])), abs(p[2]))
        margin = FLOAT32_ROUNDING * reach
        limit = radius * radius
        bound = widened_square(radius, margin)
        start = find_start(i, cloud, rows, batch)
        for begin, end, _ in leaves_of_cloud(cloud, start, p, p, bound, batch):
            for j in range(begin, end):
                other = int64(batch.rows.order[j])
                d = points[int(other)] - q
                sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
                is_nearer = 1 if sqdist < limit else 0
                if size == k and sqdist == limit and other < indices[first + k - 1]:
                    is_nearer = 1
                if is_nearer == 1:
                    size = min(size + 1, k)
                    slot = first + size - 1
                    searching = 1 if slot > first else 0
                    while searching == 1:
                        before = sqdists[slot - 1]
                        if before > sqdist or (before == sqdist and indices[slot - 1] > other):
                            sqdists[slot] = before
                            indices[slot] = indices[slot - 1]
                            slot -= 1
                            searching = 1 if slot > first else 0
                        else:
                            searching = 0
                    sqdists[slot] = sqdist
                    indices[slot] = other
                    if size == k:
                        limit = sqdists[first + k - 1]
                        bound = widened_square(sqrt(limit), margin)
    shift = int64(batch.rows.clouds.starts[cloud] * is_local)
    for j in range(first, first + size):
        indices[j] = indices[j] - shift
    for j in range(first + size, first + k):
        indices[j] = int64(-1)
        sqdists[j] = float64(INFINITY)
