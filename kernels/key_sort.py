"""Sorting a run of keys by one thread: a heap, O(n log n) for any order and without scratch."""

from .lang import array, func, int64


@func
def sift_down(keys: array(dtype=int64), base: int, start: int, size: int) -> int:
    """Restore the heap property (largest first) below one slot; the slot where its key came to rest."""
    slot = start + 0
    key = keys[base + slot]
    child = 2 * slot + 1
    while child < size:
        if child + 1 < size:
            if keys[base + child + 1] > keys[base + child]:
                child = child + 1
        if keys[base + child] > key:
            keys[base + slot] = keys[base + child]
            slot = child
            child = 2 * slot + 1
        else:
            child = size
    keys[base + slot] = key
    return slot


@func
def sort_keys(keys: array(dtype=int64), base: int, size: int) -> int:
    """Sort keys[base : base + size] in place: heap sort, O(n log n) for any order and without scratch; the size."""
    for j in range(size // 2):
        sift_down(keys, base, size // 2 - 1 - j, size)
    for j in range(size - 1):
        last = size - 1 - j
        largest = keys[base]
        keys[base] = keys[base + last]
        keys[base + last] = largest
        sift_down(keys, base, 0, last)
    return size
