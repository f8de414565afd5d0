"""Start of each number in sorted keys, by bisection."""

from ..array_types import Indices, Keys
from ..lang import array, int32, int64, kernel, launch, tid


@kernel
def find_key_starts_kernel(keys: array(dtype=int64), starts: array(dtype=int32)):
    i = tid()
    low = 0
    high = int(keys.shape[0])
    while low < high:
        middle = (low + high) // 2
        if keys[middle] < int64(i):
            low = middle + 1
        else:
            high = middle
    starts[i] = low


def find_key_starts(keys: Keys, starts: Indices) -> None:
    """Fill `starts`, int32 (n + 1): rows of the sorted int64 keys with key k are starts[k] .. starts[k + 1]."""
    launch(find_key_starts_kernel, starts.size, [keys, starts])
