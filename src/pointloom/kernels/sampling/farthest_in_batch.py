"""Farthest point samples of each cloud of a batch, in one launch: one block per cloud on CUDA, one thread on the CPU.

As farthest_points.py, without a tree: each choice measures all points of its cloud, 20 B per point.
"""

from ..array_types import Array2, Points
from ..arrays.blocks import WARPS, block_threads
from ..arrays.packed_keys import INDEX_MASK
from ..lang import BLOCK_THREADS, array, float_bits, func, int64, isfinite, kernel, launch, tid, vec3
from ..memory import empty, full
from ..search.cloud_batch import CloudRows
from ..search.point_tree import square_distance
from .farthest_points import UNREACHED_KEY, index_of, largest_of_block

CHOSEN_KEY = -1  # key of a chosen point, and of one that is not finite


@func
def first_key(j: int, p: vec3) -> int64:
    """Key of point j of a cloud before the first choice: infinite distance, the lowest index first."""
    return int64(UNREACHED_KEY) | (int64(INDEX_MASK) - int64(j)) if isfinite(p) else int64(CHOSEN_KEY)


@func
def nearer_key(key: int64, p: vec3, q: vec3) -> int64:
    """Key of a point p after the choice of q."""
    near = (int64(float_bits(square_distance(q, p))) << 32) | (key & int64(INDEX_MASK))
    return near if near < key else key


@kernel
def choose_in_clouds_kernel(
    points: array(dtype=vec3),
    clouds: CloudRows,
    keys: array(dtype=int64),
    tops: array(dtype=int64),
    chosen: array(dtype=int64, ndim=2),
):
    """The choices of a cloud: indices within it, -1 once all finite points are chosen."""
    i = tid()
    start = clouds.starts[i]
    size = clouds.sizes[i]
    top = int64(CHOSEN_KEY)
    for j in range(size):
        key = first_key(j, points[start + j])
        keys[start + j] = key
        top = max(top, key)
    for choice in range(chosen.shape[1]):
        row = int64(-1)
        if top >= int64(0):
            at = index_of(top)
            row = int64(at)
            q = points[start + at]
            keys[start + at] = int64(CHOSEN_KEY)
            top = int64(CHOSEN_KEY)
            for j in range(start, start + size):
                key = keys[j]
                if key >= int64(0):
                    key = nearer_key(key, points[j], q)
                    keys[j] = key
                    top = max(top, key)
        chosen[i, choice] = row


@choose_in_clouds_kernel.on_cuda
def choose_in_blocks_kernel(
    points: array(dtype=vec3),
    clouds: CloudRows,
    keys: array(dtype=int64),
    tops: array(dtype=int64),
    chosen: array(dtype=int64, ndim=2),
):
    """CUDA variant, one block per cloud: a thread has every 256th point."""
    i = tid()
    cloud = i // BLOCK_THREADS
    thread = i % BLOCK_THREADS
    start = clouds.starts[cloud]
    size = clouds.sizes[cloud]
    top = int64(CHOSEN_KEY)
    j = thread + 0
    while j < size:
        key = first_key(j, points[start + j])
        keys[start + j] = key
        top = max(top, key)
        j += BLOCK_THREADS
    top = largest_of_block(i, top, cloud * WARPS, tops)
    for choice in range(chosen.shape[1]):
        row = int64(-1)
        if top >= int64(0):
            at = index_of(top)
            row = int64(at)
            q = points[start + at]
            own = int64(CHOSEN_KEY)
            j = thread + 0
            while j < size:
                key = keys[start + j]
                if j == at:
                    key = int64(CHOSEN_KEY)
                if key >= int64(0):
                    key = nearer_key(key, points[start + j], q)
                keys[start + j] = key
                own = max(own, key)
                j += BLOCK_THREADS
            top = own
        top = largest_of_block(i, top, cloud * WARPS, tops)
        if thread == 0:
            chosen[cloud, choice] = row


def choose_in_batch(points: Points, clouds: CloudRows, sample_count: int) -> Array2[int64]:
    """Farthest point samples of each cloud from its first finite point on, int64 (clouds, samples): rows within the
    cloud in order of choice, -1 after the last. No wait for the device.
    """
    device, count = points.device, clouds.starts.size
    if not points.size:
        return full((count, sample_count), -1, int64, device)
    chosen = empty((count, sample_count), int64, device)
    threads = block_threads(device)
    tops = empty(count * WARPS if threads > 1 else 1, int64, device)
    keys = empty(points.size, int64, device)
    launch(choose_in_clouds_kernel, count * threads, [points, clouds, keys, tops, chosen])
    return chosen
