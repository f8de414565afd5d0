"""Stable sort of pairs of small numbers of which few share the first. On the CPU pairs are bucketed and each bucket is
insertion-sorted, three times faster than a full sort. CUDA uses `argsort_keys`.
"""

from ..array_types import Integers, Keys, LongIntegers
from ..lang import array, atomic_add, int32, int64, kernel, launch, tid
from ..memory import download, empty, zeros
from .prefix_sum import offsets_of
from .sort import argsort_keys

MIN_PAIRS = 1 << 15  # pairs: below, launches cost more than the sort
MAX_BUCKET_PAIRS = 64  # pairs of a bucket: insertion sort is quadratic


@kernel(for_cpu=True)
def count_runs_of_pairs_kernel(keys: array(dtype=int64), bits: int, counts: array(dtype=int32)):
    i = tid()
    atomic_add(counts, int(keys[i] >> int64(bits)), 1)  # integer sum: order-independent


@kernel(for_cpu=True)
def fill_runs_kernel(
    keys: array(dtype=int64),
    bits: int,
    starts: array(dtype=int32),
    filled: array(dtype=int32),
    order: array(dtype=int32),
):
    """Put each pair into its bucket, in any order."""
    i = tid()
    first = int(keys[i] >> int64(bits))
    offset = atomic_add(filled, first, 1)
    order[starts[first] + offset] = i


@kernel(for_cpu=True)
def order_runs_kernel(
    keys: array(dtype=int64), starts: array(dtype=int32), order: array(dtype=int32), ordered: array(dtype=int64)
):
    i = tid()
    head = starts[i]
    for p in range(head, starts[i + 1]):
        entry = order[p]
        key = keys[entry]
        q = p
        searching = 1
        while q > head and searching == 1:
            before = ordered[q - 1]
            searching = 0
            if before > key or (before == key and order[q - 1] > entry):
                ordered[q] = before
                order[q] = order[q - 1]
                q -= 1
                searching = 1
        ordered[q] = key
        order[q] = entry


def argsort_pairs(keys: Keys, bits: int, count: int) -> tuple[LongIntegers, Integers]:
    """Stable order of keys (first << bits) | second, with first < count: (sorted keys, order) as of `argsort_keys`."""
    device = keys.device
    if device.is_cuda or keys.size < MIN_PAIRS:
        return argsort_keys(keys, bits + max(1, count.bit_length()))
    counts = zeros(count + 1, int32, device)
    launch(count_runs_of_pairs_kernel, keys.size, [keys, bits, counts])
    if download(counts).max() > MAX_BUCKET_PAIRS:
        return argsort_keys(keys, bits + max(1, count.bit_length()))
    starts = offsets_of(counts)
    order, ordered = empty(keys.size, int32, device), empty(keys.size, int64, device)
    launch(fill_runs_kernel, keys.size, [keys, bits, starts, zeros(count, int32, device), order])
    launch(order_runs_kernel, count, [keys, starts, order, ordered])
    return ordered, order
