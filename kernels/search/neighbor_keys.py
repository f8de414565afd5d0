"""Keys of neighbours in scratch memory: sorting them, keeping the k smallest, dropping far ones early.

A key (packed_keys) is a squared distance above the index of the neighbour, so keys in ascending order are neighbours by
distance, ties by index, and no two are equal.
"""

from ..lang import array, float_bits, func, int64

CLOSE = 1.05  # times the expected squared distance of the k-th neighbour: holds k in more than half of the cases
MIDDLE = 1.15  # ... in most
WIDE = 1.3  # ... in nearly all
MANY = 400  # keys that a heap sorts in the time of comparing all with all
SLIGHT = 8  # an eighth more than k is not worth a pass
BOUNDLESS = 3.0e38  # [m^2] a squared reach from here on is none


@func
def sift_down(keys: array(dtype=int64), base: int, start: int, size: int):
    """Restore the heap property (largest first) below one slot."""
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


@func
def sort_keys(keys: array(dtype=int64), base: int, size: int):
    """Sort keys[base : base + size] in place: heap sort, O(n log n) for any order and without scratch."""
    for j in range(size // 2):
        sift_down(keys, base, size // 2 - 1 - j, size)
    for j in range(size - 1):
        last = size - 1 - j
        largest = keys[base]
        keys[base] = keys[base + last]
        keys[base + last] = largest
        sift_down(keys, base, 0, last)


@func
def keep_nearest(keys: array(dtype=int64), base: int, held: int, k: int, room: int) -> int:
    """Sort the keys held at `base` and keep the k smallest; how many are left.

    Each key's place is the number of smaller keys. That is quadratic, yet up to MANY faster than a sort: the inner loop
    has no branch and runs in vector registers. Keys differ, since each holds the index of its point.
    """
    left = min(held, k)
    if held > MANY:
        sort_keys(keys, base, held)
    else:
        for a in range(held):
            key = keys[base + a]
            place = int64(0)  # as wide as the keys, so that both share vector registers
            for b in range(held):
                if keys[base + b] < key:
                    place += int64(1)
            if int(place) < k:
                keys[base + room + int(place)] = key
        for a in range(left):
            keys[base + a] = keys[base + room + a]
    return left


@func
def thin_keys(keys: array(dtype=int64), base: int, held: int, k: int, reach: float) -> int:
    """Drop far keys while at least k are left, by three guesses at the k-th distance; how many are left.

    Points within a squared radius grow in proportion to it on a surface, so k of `held` lie within about k / held of
    the reach. A wrong guess only leaves more keys to sort.
    """
    left = held + 0
    if held > k + k // SLIGHT and reach < BOUNDLESS:
        share = reach * (float(k) / float(held))
        close = (int64(float_bits(share * CLOSE)) + int64(1)) << int64(32)
        middle = (int64(float_bits(share * MIDDLE)) + int64(1)) << int64(32)
        wide = (int64(float_bits(share * WIDE)) + int64(1)) << int64(32)
        in_close = int(0)
        in_middle = int(0)
        in_wide = int(0)
        for j in range(base, base + held):
            if keys[j] < close:
                in_close += 1
            if keys[j] < middle:
                in_middle += 1
            if keys[j] < wide:
                in_wide += 1
        limit = wide + int64(0)
        if in_middle >= k:
            limit = middle
        if in_close >= k:
            limit = close
        if in_wide >= k:
            left = int(0)
            for j in range(base, base + held):
                key = keys[j]
                keys[base + left] = key
                if key < limit:
                    left += 1
    return left
