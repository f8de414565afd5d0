"""Stable order of pairs of small numbers, of which few share the first: edges by their vertices, corners by theirs.

On the CPU the pairs are put into runs by their first numbers and each run is ordered by insertion, one thread a run: a
third of the time of a sort of all keys. In which order threads fill a run does not matter, since it is ordered then. On
CUDA, where there are few, and where many share a first number, `argsort_keys` does it; the result is the same. 16 B of
memory a pair and 12 B a first number.
"""

from ..array_types import Integers, Keys, LongIntegers
from ..lang import array, atomic_add, int32, int64, kernel, launch, tid
from ..memory import download, empty, zeros
from .prefix_sum import exclusive_scan
from .sort import argsort_keys

FEWEST = 1 << 15  # pairs: below that launches cost more than the sort
LONGEST = 64  # pairs of a run: insertion takes the square of them


@kernel(for_cpu=True)
def count_runs_of_pairs_kernel(keys: array(dtype=int64), bits: int, counts: array(dtype=int32)):
    """How many pairs have each first number; whole numbers add up to the same in any order."""
    i = tid()
    atomic_add(counts, int(keys[i] >> int64(bits)), 1)


@kernel(for_cpu=True)
def fill_runs_kernel(
    keys: array(dtype=int64),
    bits: int,
    starts: array(dtype=int32),
    filled: array(dtype=int32),
    order: array(dtype=int32),
):
    """Put each pair into the run of its first number; where in the run is for the next kernel to settle."""
    i = tid()
    first = int(keys[i] >> int64(bits))
    place = atomic_add(filled, first, 1)
    order[starts[first] + place] = i


@kernel(for_cpu=True)
def order_runs_kernel(
    keys: array(dtype=int64), starts: array(dtype=int32), order: array(dtype=int32), ordered: array(dtype=int64)
):
    """Order each run by key, then by number."""
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
    """The stable order of keys (first << bits) | second.

    Args:
        keys: int64 device array of shape [n]; left as it is.
        bits: Bits of the second number; 0 where there is none.
        count: First numbers are below this.

    Returns:
        (sorted keys, order), as of `argsort_keys`.
    """
    device = keys.device
    if device.is_cuda or keys.size < FEWEST:
        return argsort_keys(keys, bits + max(1, count.bit_length()))
    counts = zeros(count + 1, int32, device)
    launch(count_runs_of_pairs_kernel, keys.size, [keys, bits, counts])
    if download(counts).max() > LONGEST:
        return argsort_keys(keys, bits + max(1, count.bit_length()))
    starts, _ = exclusive_scan(counts)
    order, ordered = empty(keys.size, int32, device), empty(keys.size, int64, device)
    launch(fill_runs_kernel, keys.size, [keys, bits, starts, zeros(count, int32, device), order])
    launch(order_runs_kernel, count, [keys, starts, order, ordered])
    return ordered, order
