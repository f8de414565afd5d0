"""Farthest point sampling (Eldar, Lindenbaum, Porat and Zeevi, "The farthest point strategy for progressive image
sampling", IEEE Transactions on Image Processing 6(9), 1997).

Each point stores its squared distance to the chosen points as a key above its index counted from the end, and each tree
node the largest key below it. A choice updates only boxes nearer than their largest distance: O(n log m) on a surface
instead of O(n m). The CPU uses one thread, CUDA one block for small clouds, else a launch per choice, 32 in a device
loop. All are bitwise identical: box distances round like point distances.
"""

import numpy as np

from ..arrays.blocks import WARPS, block_threads
from ..arrays.lanes import max_long_of_lanes
from ..arrays.packed_keys import INDEX_MASK, key_number
from ..lang import (
    BLOCK_THREADS,
    WARP,
    array,
    atomic_max,
    cuda_func,
    float32,
    float_bits,
    func,
    int32,
    int64,
    kernel,
    launch,
    loop_while,
    struct,
    sync_block,
    tid,
    vec3,
    vector,
)
from ..memory import download, empty, fill, full, zeros
from ..search.point_tree import FAN, LEAF, SIDES, PointTree, box_distances, measure_box, measure_boxes

leaf_keys = vector(8, int64)
MAX_LEAVES = 1024  # of a cloud whose points one block of CUDA chooses: four leaves, about 1.5 us, per thread and choice
UNREACHED_KEY = 0x7F80_0000_0000_0000  # key of an infinite distance, without index
MIN_NONZERO_KEY = 0x1_0000_0000  # keys >= this are at nonzero distance from all chosen points
LAUNCH_CHOICES = 4096  # per CPU launch: a fraction of a second, so that interrupts are handled
STEP_CHOICES = 32  # choices per loop iteration: its end costs as much as one of them
MIN_LOOPED = 2 * STEP_CHOICES  # minimum choices for a loop. Fewer are launched one by one
LOOP_CHOICES = 1 << 16  # choices per loop, a multiple of STEP_CHOICES: a fraction of a second


@func
def index_of(key: int64) -> int:
    return int(int64(INDEX_MASK) - (key & int64(INDEX_MASK)))


@struct
class SampleDistances:
    """Distances of tree points from the chosen ones: `keys` (squared distance [m^2] above the index from the end), 0 in
    padding; `leaf_tops`: largest key per leaf. Without a launch per choice: `tops` of buckets and nodes (on CUDA of
    warps), `queue`.
    """

    tree: PointTree
    points: array(dtype=vec3)
    leaf_count: int
    xs: array(dtype=float32)
    ys: array(dtype=float32)
    zs: array(dtype=float32)
    keys: array(dtype=int64)
    leaf_tops: array(dtype=int64)
    tops: array(dtype=int64)
    queue: array(dtype=int32)
    chosen: array(dtype=int64)
    last: int
    choice: array(dtype=int32)
    running: array(dtype=int32)

    def __init__(self, tree: PointTree, sample_count: int, start: int, is_sequential: bool) -> None:
        """Initialize. The first choice is the point of index `start`."""
        device, node_count = tree.device, 0
        if is_sequential:
            node_count = WARPS if device.is_cuda else tree.boxes.size // SIDES
        self.tree, self.points, self.leaf_count = tree, tree.source, -(-tree.count // LEAF)
        self.xs, self.ys, self.zs = (empty(self.leaf_count * LEAF, float32, device) for _ in range(3))
        self.keys = empty(self.leaf_count * LEAF, int64, device)
        self.leaf_tops = full(self.leaf_count, UNREACHED_KEY, int64, device)
        self.tops, self.queue = full(node_count, UNREACHED_KEY, int64, device), empty(node_count, int32, device)
        self.last, self.choice, self.running = sample_count - 1, zeros(1, int32, device), full(1, 1, int32, device)
        self.chosen = zeros(sample_count + 1, int64, device)
        fill(self.chosen[:1], UNREACHED_KEY | (INDEX_MASK - start))
        launch(start_keys_kernel, self.keys.size, [self])


@kernel
def start_keys_kernel(state: SampleDistances):
    """Coordinates by axis and initial keys. Padding is never chosen."""
    i = tid()
    p = vec3(0.0, 0.0, 0.0)
    key = int64(0)
    if i < state.tree.count:
        p = state.tree.points[i]
        key = int64(UNREACHED_KEY) | (int64(INDEX_MASK) - int64(state.tree.order[i]))
    state.xs[i] = p[0]
    state.ys[i] = p[1]
    state.zs[i] = p[2]
    state.keys[i] = key


@func
def approach_leaf(leaf: int, p: vec3, state: SampleDistances) -> int64:
    """Lower a leaf's keys to their distance to p. Return the largest. Three loops that the CPU vectorizes."""
    first = leaf * LEAF
    distances = box_distances(0.0)
    for j in range(LEAF):
        x = p[0] - state.xs[first + j]
        y = p[1] - state.ys[first + j]
        z = p[2] - state.zs[first + j]
        distances[j] = x * x + y * y + z * z
    near = leaf_keys(0)
    for j in range(LEAF):
        key = state.keys[first + j]
        offered = (int64(float_bits(distances[j])) << 32) | (key & int64(INDEX_MASK))
        near[j] = offered if offered < key else key
    top = int64(0)
    for j in range(LEAF):
        state.keys[first + j] = near[j]
        top = near[j] if near[j] > top else top
    return top


@func
def approach_bucket(bucket: int, p: vec3, state: SampleDistances) -> int64:
    """Lower a bucket's keys to their distance to p where needed. Return the largest."""
    distances = measure_boxes(state.tree.boxes, bucket, p, p)
    top = int64(0)
    for j in range(FAN):
        leaf = bucket * FAN + j
        if leaf < state.leaf_count:
            key = state.leaf_tops[leaf]
            if distances[j] <= key_number(key):
                key = approach_leaf(leaf, p, state)
                state.leaf_tops[leaf] = key
            top = max(top, key)
    return top


@func
def list_buckets_near(p: vec3, state: SampleDistances) -> int:
    """Queue the nodes that may contain a point closer to p than to all chosen ones. Returns the end of the buckets."""
    begin = 0
    end = 1
    state.queue[0] = state.tree.levels[state.tree.root]
    for step in range(state.tree.root):
        above = state.tree.levels[state.tree.root - step]
        below = state.tree.levels[state.tree.root - step - 1]
        tail = end
        for q in range(begin, end):
            distances = measure_boxes(state.tree.boxes, state.queue[q], p, p)
            first = below + (state.queue[q] - above) * FAN
            for j in range(FAN):
                child = first + j
                if child < above:
                    if distances[j] <= key_number(state.tops[child]):
                        state.queue[tail] = child
                        tail += 1
        begin = end
        end = tail
    return end


@func
def approach_tree(p: vec3, state: SampleDistances) -> int64:
    """Lower all keys to their distance to p. Return the largest."""
    end = list_buckets_near(p, state)
    level = 0
    for step in range(end):  # from the last bucket back to the root: children before parents
        node = state.queue[end - 1 - step]
        if node >= state.tree.levels[level + 1]:  # no level is skipped: the path to p is always queued
            level += 1
        if level == 0:
            state.tops[node] = approach_bucket(node, p, state)
        else:
            first = state.tree.levels[level - 1] + (node - state.tree.levels[level]) * FAN
            top = int64(0)
            for child in range(first, min(first + FAN, state.tree.levels[level])):
                top = max(top, state.tops[child])
            state.tops[node] = top
    return state.tops[state.tree.levels[state.tree.root]]


@kernel
def choose_sequentially_kernel(first: int, last: int, state: SampleDistances):
    """Run of choices by one thread; chosen[choice + 1] is the farthest point after that choice."""
    i = tid()
    for choice in range(first + i, last):
        key = state.chosen[choice]
        farthest = int64(0)
        if key >= int64(MIN_NONZERO_KEY):
            farthest = approach_tree(state.points[index_of(key)], state)
        state.chosen[choice + 1] = farthest


@cuda_func
def largest_of_block(i: int, key: int64, first: int, tops: array(dtype=int64)) -> int64:
    """The largest key of the threads of a block, the same for all of them. `tops` is scratch (8) from `first` on."""
    top = max_long_of_lanes(key)
    if i % WARP == 0:
        tops[first + i % BLOCK_THREADS // WARP] = top
    sync_block()
    for warp in range(first, first + WARPS):
        top = max(top, tops[warp])
    sync_block()
    return top


@choose_sequentially_kernel.on_cuda
def choose_in_block_kernel(first: int, last: int, state: SampleDistances):
    """CUDA variant, one block: a thread has every 256th leaf."""
    i = tid()
    key = state.chosen[first]
    for choice in range(first, last):
        top = int64(0)
        if key >= int64(MIN_NONZERO_KEY):
            p = state.points[index_of(key)]
            leaf = i + 0
            while leaf < state.leaf_count:
                near = state.leaf_tops[leaf]
                if measure_box(state.tree.boxes, leaf // FAN, leaf % FAN, p, p) <= key_number(near):
                    near = approach_leaf(leaf, p, state)
                    state.leaf_tops[leaf] = near
                top = max(top, near)
                leaf += BLOCK_THREADS
        key = largest_of_block(i, top, 0, state.tops)
        if i == 0:
            state.chosen[choice + 1] = key


@kernel
def choose_at_once_kernel(step: int, state: SampleDistances):
    """The choice `step` after the iteration's first, one thread per bucket; chosen[choice + 1] must be 0 before."""
    i = tid()
    choice = state.choice[0] + step
    if choice < state.last:
        key = state.chosen[choice]
        if key >= int64(MIN_NONZERO_KEY):
            top = approach_bucket(i, state.points[index_of(key)], state)
            if top > state.chosen[choice + 1]:  # saves most atomics. A stale value only adds one
                atomic_max(state.chosen, choice + 1, top)  # resolves the race: the largest key


@choose_at_once_kernel.on_cuda
def choose_by_leaves_kernel(step: int, state: SampleDistances):
    """CUDA variant, one thread per leaf, coalesced. A warp offers one key."""
    i = tid()
    choice = state.choice[0] + step
    top = int64(0)
    if choice < state.last:
        chosen = state.chosen[choice]
        if chosen >= int64(MIN_NONZERO_KEY) and i < state.leaf_count:
            p = state.points[index_of(chosen)]
            top = state.leaf_tops[i]
            if measure_box(state.tree.boxes, i // FAN, i % FAN, p, p) <= key_number(top):
                top = approach_leaf(i, p, state)
                state.leaf_tops[i] = top
    top = max_long_of_lanes(top)
    if i % WARP == 0 and top > 0:
        if top > state.chosen[choice + 1]:
            atomic_max(state.chosen, choice + 1, top)  # as in the kernel it replaces


@kernel
def end_iteration_kernel(limit: int, state: SampleDistances):
    """Continue after the iteration's choices while below the limit. One thread."""
    i = tid()
    choice = min(state.choice[0] + STEP_CHOICES, state.last) + i
    state.choice[0] = choice
    going = 0
    if choice < limit and state.chosen[choice] >= int64(MIN_NONZERO_KEY):
        going = 1
    state.running[0] = going


def choose_farthest(tree: PointTree, sample_count: int, start: int, at_once: bool | None = None) -> np.ndarray:
    """Farthest point samples, int32 NumPy array in order of choice. One sync. Fewer than `sample_count` once all points
    coincide with chosen ones. `at_once`: one launch per choice. None chooses by device and size.
    """
    is_large = tree.device.is_cuda and tree.count > MAX_LEAVES * LEAF
    is_sequential = not (is_large if at_once is None else at_once)
    state = SampleDistances(tree, sample_count, start, is_sequential)
    threads = block_threads(tree.device)
    if is_sequential:
        for first in range(0, sample_count - 1, LAUNCH_CHOICES):
            launch(choose_sequentially_kernel, threads, [first, min(first + LAUNCH_CHOICES, sample_count - 1), state])
    else:
        _choose_at_once(state)
    keys = download(state.chosen)[:sample_count]  # sync
    return (INDEX_MASK - (keys[keys >= MIN_NONZERO_KEY] & INDEX_MASK)).astype("int32")


def _choose_at_once(state: SampleDistances) -> None:
    on_cuda = state.chosen.device.is_cuda
    threads = -(-state.leaf_count // WARP) * WARP if on_cuda else -(-state.leaf_count // FAN)
    if state.last < MIN_LOOPED:
        for step in range(state.last):
            launch(choose_at_once_kernel, threads, [step, state])
        return

    def choose_some() -> None:
        for step in range(STEP_CHOICES):
            launch(choose_at_once_kernel, threads, [step, state])
        launch(end_iteration_kernel, 1, [limit, state])

    for first in range(0, state.last, LOOP_CHOICES):
        limit = min(first + LOOP_CHOICES, state.last)
        if first:
            download(state.choice)  # sync, so that interrupts are handled
            fill(state.running, 1)
        loop_while(state.running, choose_some)
