"""Search trees over the clouds of a batch, built without a wait for the device, in as many launches as for one cloud.

As point_forest.py, for clouds whose sizes are only on the device. Each cloud has its own Hilbert curve. Its nodes start
at a record that follows from its first row: n points have less than n / NODE_POINTS nodes and one per level more. A
launch has a slot for each run of points and one more for each cloud, of which few are unused.
"""

from ..array_types import Indices, Points, Scalars
from ..arrays.sort import SortKeys, put_key
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
    loop,
    partial,
    struct,
    tid,
    vec3,
)
from ..memory import empty
from .bucket_walk import level_children_within, next_step, start_traversal
from .hilbert_order import VECTOR_LANES, cell_on_axis, hilbert_codes, lanes, scale_of_box
from .point_tree import BUCKET, FAN, LEAF, SIDES, highest_corner, lowest_corner, measure_boxes

NODE_POINTS = BUCKET * (FAN - 1) // FAN  # points per node of a large tree: the sum of 1 / (BUCKET * FAN^level)
MIN_RUN = 64  # points of a thread that bounds a cloud
KEY_BITS = 62  # of a key: cloud, code and, on the CPU, row
MAX_LEVELS = 12  # of the curve: 4,096 cells per axis


@func
def owner_of_row(starts: array(dtype=int32), row: int) -> int:
    """Last cloud whose first row is not above a row. Clouds without points own none."""
    low = 0
    high = starts.shape[0]
    while high - low > 1:
        middle = (low + high) // 2
        if starts[middle] <= row:
            low = middle
        else:
            high = middle
    return low


@func
def owner_of_slot(starts: array(dtype=int32), run: int, slot: int) -> int:
    """The cloud of a slot. The first of cloud c is `starts[c] // run + c`."""
    low = 0
    high = starts.shape[0]
    while high - low > 1:
        middle = (low + high) // 2
        if starts[middle] // run + middle <= slot:
            low = middle
        else:
            high = middle
    return low


@struct
class CloudRows:
    """Rows of clouds in one array: first row and number of points of each, int32 (clouds). Rows that follow the points
    of a cloud are padding.
    """

    starts: array(dtype=int32)
    sizes: array(dtype=int32)

    def __init__(self, starts: Indices, sizes: Indices, largest: int) -> None:
        """`largest`: a bound of the sizes."""
        self.starts, self.sizes, self.largest = starts, sizes, largest

    def slots(self, rows: int, run: int) -> int:
        return rows // run + self.starts.size + 1


@kernel
def bound_runs_kernel(points: array(dtype=vec3), clouds: CloudRows, run: int, boxes: array(dtype=float32)):
    """Box of the finite points of a slot: low corner, high corner."""
    i = tid()
    cloud = owner_of_slot(clouds.starts, run, i)
    first = (i - clouds.starts[cloud] // run - cloud) * run
    low = vec3(INFINITY, INFINITY, INFINITY)
    high = vec3(-INFINITY, -INFINITY, -INFINITY)
    for j in range(first, min(first + run, clouds.sizes[cloud])):
        p = points[clouds.starts[cloud] + j]
        if isfinite(p):
            low = vec3(min(low[0], p[0]), min(low[1], p[1]), min(low[2], p[2]))
            high = vec3(max(high[0], p[0]), max(high[1], p[1]), max(high[2], p[2]))
    for axis in range(3):
        boxes[6 * i + axis] = low[axis]
        boxes[6 * i + 3 + axis] = high[axis]


@kernel
def bound_clouds_kernel(runs: array(dtype=float32), clouds: CloudRows, run: int, boxes: array(dtype=float32)):
    i = tid()
    first = clouds.starts[i] // run + i
    low = vec3(INFINITY, INFINITY, INFINITY)
    high = vec3(-INFINITY, -INFINITY, -INFINITY)
    for j in range(first, first + (clouds.sizes[i] + run - 1) // run):
        low = vec3(min(low[0], runs[6 * j]), min(low[1], runs[6 * j + 1]), min(low[2], runs[6 * j + 2]))
        high = vec3(max(high[0], runs[6 * j + 3]), max(high[1], runs[6 * j + 4]), max(high[2], runs[6 * j + 5]))
    for axis in range(3):
        boxes[6 * i + axis] = low[axis]
        boxes[6 * i + 3 + axis] = high[axis]


def bound_clouds(points: Points, clouds: CloudRows) -> Scalars:
    """Boxes of the finite points of each cloud, float32 (6 clouds): low and high corner, infinite without points."""
    run = MIN_RUN
    while run * run < clouds.largest:
        run *= 2
    slots = clouds.slots(points.size, run)
    runs = empty(6 * slots, float32, points.device)
    launch(bound_runs_kernel, slots, [points, clouds, run, runs])
    boxes = empty(6 * clouds.starts.size, float32, points.device)
    launch(bound_clouds_kernel, clouds.starts.size, [runs, clouds, run, boxes])
    return boxes


@kernel
def encode_rows_kernel(
    points: array(dtype=vec3), clouds: CloudRows, boxes: array(dtype=float32), levels: int, codes: SortKeys
):
    """Keys of eight rows: the cloud above the code on its curve. Padding and non-finite points are last in a cloud."""
    i = tid()
    last = points.shape[0] - 1
    x = lanes(0)
    y = lanes(0)
    z = lanes(0)
    for j in range(VECTOR_LANES):
        row = min(i * VECTOR_LANES + j, last)
        box = 6 * owner_of_row(clouds.starts, row)
        low = vec3(boxes[box], boxes[box + 1], boxes[box + 2])
        scale = 0.0
        if low[0] <= boxes[box + 3]:
            scale = scale_of_box(low, vec3(boxes[box + 3], boxes[box + 4], boxes[box + 5]), levels)
        p = points[row]
        x[j] = cell_on_axis(p[0], low[0], scale, levels)
        y[j] = cell_on_axis(p[1], low[1], scale, levels)
        z[j] = cell_on_axis(p[2], low[2], scale, levels)
    found = hilbert_codes(x, y, z, levels)
    for j in range(VECTOR_LANES):
        row = i * VECTOR_LANES + j
        if row <= last:
            cloud = owner_of_row(clouds.starts, row)
            code = 1 << int64(3 * levels)
            if row < clouds.starts[cloud] + clouds.sizes[cloud] and isfinite(points[row]):
                code = found[j]
            put_key(row, (int64(cloud) << int64(3 * levels + 1)) | code, codes)


@struct
class SortedRows:
    """Rows of a batch along the curves of its clouds: `keys`: the cloud above the code, ascending; `order`: rows."""

    clouds: CloudRows
    keys: array(dtype=int64)
    order: array(dtype=int32)
    levels: int

    def __init__(self, points: Points, clouds: CloudRows, boxes: Scalars) -> None:
        """`boxes`: of the curves."""
        cloud_bits = (clouds.starts.size - 1).bit_length()
        self.clouds = clouds
        self.levels = min(MAX_LEVELS, (KEY_BITS - max(1, (points.size - 1).bit_length()) - cloud_bits) // 3)
        keys = SortKeys(points.size, points.device)
        launch(encode_rows_kernel, -(-points.size // VECTOR_LANES), [points, clouds, boxes, self.levels, keys])
        self.keys, self.order = keys.sort(3 * self.levels + 1 + cloud_bits)


@func
def cloud_of_rank(rank: int, rows: SortedRows) -> int:
    return int(rows.keys[rank] >> int64(3 * rows.levels + 1))


@struct
class CloudBatch:
    """A search tree over each cloud: `points` along the curves, infinite if not finite; the children's boxes of each
    node; first records of the levels of each tree, `height` numbers each; `roots`: its top level, -1 without points.
    """

    rows: SortedRows
    points: array(dtype=vec3)
    boxes: array(dtype=float32)
    levels: array(dtype=int32)
    roots: array(dtype=int32)
    cloud_boxes: array(dtype=float32)
    height: int

    def __init__(self, points: Points, clouds: CloudRows) -> None:
        device, count, total = points.device, clouds.starts.size, points.size
        self.cloud_boxes = bound_clouds(points, clouds)
        self.rows = SortedRows(points, clouds, self.cloud_boxes)
        sizes = [max(1, -(-clouds.largest // BUCKET))]
        while sizes[-1] > 1:
            sizes.append(-(-sizes[-1] // FAN))
        self.height = len(sizes)
        self.points = empty(total, vec3, device)
        self.boxes = empty((total // NODE_POINTS + (self.height + 1) * count + 1) * SIDES, float32, device)
        self.levels, self.roots = empty(self.height * count, int32, device), empty(count, int32, device)
        launch(number_nodes_kernel, count, [self])
        launch(bound_batch_leaves_kernel, clouds.slots(total, BUCKET) * FAN, [points, self])
        run = BUCKET * FAN
        for level in range(1, self.height):
            launch(bound_batch_nodes_kernel, clouds.slots(total, run) * FAN, [level, run, self])
            run *= FAN


@kernel
def number_nodes_kernel(batch: CloudBatch):
    i = tid()
    record = batch.rows.clouds.starts[i] // NODE_POINTS + i * (batch.height + 1)
    nodes = (batch.rows.clouds.sizes[i] + BUCKET - 1) // BUCKET
    root = -1
    for level in range(batch.height):
        batch.levels[i * batch.height + level] = record
        if nodes > 0:
            record += nodes
            root += 1
            nodes = (nodes + FAN - 1) // FAN if nodes > 1 else 0
    batch.roots[i] = root


@kernel
def bound_batch_leaves_kernel(source: array(dtype=vec3), batch: CloudBatch):
    """Store and bound the points of a leaf."""
    i = tid()
    slot = i // FAN
    cloud = owner_of_slot(batch.rows.clouds.starts, BUCKET, slot)
    start = batch.rows.clouds.starts[cloud]
    size = batch.rows.clouds.sizes[cloud]
    bucket = slot - start // BUCKET - cloud
    first = bucket * BUCKET + (i % FAN) * LEAF
    if bucket * BUCKET < size:
        a = vec3(INFINITY, INFINITY, INFINITY)
        b = vec3(-INFINITY, -INFINITY, -INFINITY)
        for j in range(first, min(first + LEAF, size)):
            p = source[batch.rows.order[start + j]]
            if isfinite(p):
                a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))
                b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))
            else:
                p = vec3(INFINITY, INFINITY, INFINITY)
            batch.points[start + j] = p
        at = (batch.levels[cloud * batch.height] + bucket) * SIDES + i % FAN
        for axis in range(3):
            batch.boxes[at + axis * FAN] = a[axis]
            batch.boxes[at + (axis + 3) * FAN] = b[axis]


@kernel
def bound_batch_nodes_kernel(level: int, run: int, batch: CloudBatch):
    """Copy the box of a node of the level below into its parent, a node over `run` points."""
    i = tid()
    slot = i // FAN
    cloud = owner_of_slot(batch.rows.clouds.starts, run, slot)
    parent = slot - batch.rows.clouds.starts[cloud] // run - cloud
    size = batch.rows.clouds.sizes[cloud]
    if parent * run < size and level <= batch.roots[cloud]:
        child = parent * FAN + i % FAN
        low = vec3(INFINITY, INFINITY, INFINITY)
        high = vec3(-INFINITY, -INFINITY, -INFINITY)
        if child * (run // FAN) < size:
            record = batch.levels[cloud * batch.height + level - 1] + child
            low = lowest_corner(record, batch.boxes)
            high = highest_corner(record, batch.boxes)
        at = (batch.levels[cloud * batch.height + level] + parent) * SIDES + i % FAN
        for axis in range(3):
            batch.boxes[at + axis * FAN] = low[axis]
            batch.boxes[at + (axis + 3) * FAN] = high[axis]


@func
def find_start(rank: int, cloud: int, queries: SortedRows, batch: CloudBatch) -> int:
    """The bucket of the cloud whose interval of the curve has a query."""
    key = queries.keys[rank]
    start = batch.rows.clouds.starts[cloud]
    low = 0
    high = (batch.rows.clouds.sizes[cloud] + BUCKET - 1) // BUCKET
    while high - low > 1:
        middle = (low + high) // 2
        if batch.rows.keys[start + middle * BUCKET] <= key:
            low = middle
        else:
            high = middle
    return low


@loop
def leaves_of_cloud(
    cloud: int, start: int, a: vec3, b: vec3, max_sqdist: float, batch: CloudBatch
) -> tuple[int, int, float]:
    """First and end position of the leaves of a cloud within a squared distance of the box (a, b), and their squared
    distance [m^2]. `max_sqdist` may shrink.
    """
    root = batch.roots[cloud]
    nodes = cloud * batch.height
    base = batch.rows.clouds.starts[cloud]
    end = base + batch.rows.clouds.sizes[cloud]
    step = start_traversal(start)
    while int(step[0]) <= root:
        bucket = int(step[2])
        distances = measure_boxes(batch.boxes, batch.levels[nodes] + bucket, a, b)
        for leaf in range(FAN):
            if distances[leaf] <= max_sqdist:
                first = base + bucket * BUCKET + leaf * LEAF
                last = min(first + LEAF, end)
                sqdist = distances[leaf]
                yield first, last, sqdist
        step = next_step(step, root, partial(level_children_within, batch.levels, nodes, batch.boxes, a, b, max_sqdist))
