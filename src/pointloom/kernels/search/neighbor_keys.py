"""Sorting and selection of neighbor keys in scratch memory.

Key j of a row is at `base` + j * `stride`: contiguous on the CPU, interleaved across threads on CUDA. A key
(packed_keys) is a squared distance above the neighbor's index, so keys are unique and ordered by distance, then index.
"""

from ..arrays.packed_keys import key_limit, key_number
from ..lang import array, bits_float, float_bits, func, int64, vector

VECTOR_LANES = 8  # keys ranked together, in vector registers
key_lanes = vector(8, int64)
LOADED = 4  # keys that CUDA loads before it stores the first
loaded_keys = vector(4, int64)

FIRST_SQDIST_FACTOR = (
    1.05  # times the expected squared distance of the k-th neighbor: sufficient in more than half of the cases
)
SECOND_SQDIST_FACTOR = 1.15  # ... in most
THIRD_SQDIST_FACTOR = 1.3  # ... in nearly all
BY_INSERTION = 96  # keys up to which insertion is faster than a heap: a fifth at 80 (CPU, 2026-11-28)
MAX_COMPARED_KEYS = 400  # keys up to which comparing all pairs beats a heap sort
MIN_EXCESS_DIVISOR = 8  # an excess of up to k / 8 is not worth a pass
MAX_INTERPOLATIONS = 6  # interpolations before bisection: about four are needed
UNLIMITED_SQRADIUS = 3.0e38  # [m^2] larger squared radii are unlimited


@func
def sift_down(keys: array(dtype=int64), base: int, stride: int, start: int, size: int):
    slot = start
    key = keys[base + slot * stride]
    child = 2 * slot + 1
    while child < size:
        if child + 1 < size:
            if keys[base + (child + 1) * stride] > keys[base + child * stride]:
                child = child + 1
        if keys[base + child * stride] > key:
            keys[base + slot * stride] = keys[base + child * stride]
            slot = child
            child = 2 * slot + 1
        else:
            child = size
    keys[base + slot * stride] = key


@func
def sort_keys(keys: array(dtype=int64), base: int, stride: int, size: int):
    """Sort `size` keys in place: by insertion, or many by a heap."""
    if size <= BY_INSERTION:
        for j in range(1, size):
            key = keys[base + j * stride]
            slot = j + 0
            while slot > 0 and keys[base + (slot - 1) * stride] > key:
                keys[base + slot * stride] = keys[base + (slot - 1) * stride]
                slot -= 1
            keys[base + slot * stride] = key
    else:
        for j in range(size // 2):
            sift_down(keys, base, stride, size // 2 - 1 - j, size)
        for j in range(size - 1):
            last = size - 1 - j
            largest = keys[base]
            keys[base] = keys[base + last * stride]
            keys[base + last * stride] = largest
            sift_down(keys, base, stride, 0, last)


@sort_keys.on_cuda
def sort_by_network(keys: array(dtype=int64), base: int, stride: int, size: int):
    """Sort `size` keys by Batcher's merge exchange (Knuth 5.2.2 M): O(n log^2 n), uniform over a warp."""
    top = 1
    while top * 2 < size:
        top = top * 2
    p = top
    while p > 0:
        q = top
        r = 0
        d = p
        while d > 0:
            for i in range(size - d):
                if (i & p) == r:
                    x = keys[base + i * stride]
                    y = keys[base + (i + d) * stride]
                    if x > y:
                        keys[base + i * stride] = y
                        keys[base + (i + d) * stride] = x
            d = q - p
            q = q // 2
            r = p
        p = p // 2


@func
def count_up_to(keys: array(dtype=int64), base: int, stride: int, key_count: int, limit: int64) -> int:
    count = int64(0)  # as wide as the keys, to share vector registers
    for j in range(key_count):
        if keys[base + j * stride] <= limit:
            count += 1
    return int(count)


@func
def limit_nearest(keys: array(dtype=int64), base: int, stride: int, key_count: int, k: int, max_sqdist: float) -> int64:
    """A limit of exactly the k smallest keys, or that of `max_sqdist`. Interpolates, assuming counts proportional to
    the squared radius; bisection (at most 64 steps) for ties and failures.
    """
    low = int64(-1)
    high = key_limit(max_sqdist)
    below = 0
    above = key_count
    iteration = 0
    while above > k:
        guess = low + (high - low) // 2
        if iteration < MAX_INTERPOLATIONS:
            near = key_number(max(low, 0))
            fraction = (float(k - below) + 0.5) / float(above - below)
            likely = key_limit(near + (key_number(high) - near) * fraction)
            if likely > low and likely < high:
                guess = likely
        count = count_up_to(keys, base, stride, key_count, guess)
        if count < k:
            low = guess
            below = count
        else:
            high = guess
            above = count
        iteration += 1
    return high


@limit_nearest.on_cuda
def limit_between(keys: array(dtype=int64), base: int, stride: int, key_count: int, k: int, max_sqdist: float) -> int64:
    """CUDA variant in three or four passes. The k-th distance is in [smallest, largest], ties by bisection."""
    low = 0.0
    smallest = 0.0
    largest = max_sqdist
    below = 0
    above = key_count
    while above > k and smallest < largest:
        guess = low + (largest - low) * ((float(k - below) + 0.5) / float(above - below))
        guess = max(min(guess, bits_float(float_bits(largest) - 1)), smallest)
        count = 0
        up_to = 0.0
        beyond = largest
        at = base + 0
        for _ in range(key_count):
            sqdist = key_number(keys[at])
            inside = sqdist <= guess
            count += 1 if inside else 0
            up_to = max(up_to, sqdist if inside else 0.0)
            beyond = min(beyond, largest if inside else sqdist)
            at += stride
        if count >= k:
            largest = up_to
            above = count
        else:
            smallest = beyond
            low = guess
            below = count
    limit = key_limit(largest)
    if above > k:
        behind = key_limit(largest)
        limit = (int64(float_bits(largest)) << 32) - 1
        while behind - limit > 1 and above > k:
            middle = limit + (behind - limit) // 2
            count = count_up_to(keys, base, stride, key_count, middle)
            if count < k:
                limit = middle
            else:
                behind = middle
                above = count
        limit = behind
    return limit


@func
def keep_up_to(keys: array(dtype=int64), base: int, stride: int, key_count: int, limit: int64) -> int:
    """Move the keys up to a limit to the front in their order. Return the count."""
    size = 0
    for j in range(key_count):
        key = keys[base + j * stride]
        if key <= limit:
            keys[base + size * stride] = key
            size += 1
    return size


@keep_up_to.on_cuda
def keep_up_to_by_four(keys: array(dtype=int64), base: int, stride: int, key_count: int, limit: int64) -> int:
    """CUDA variant: loads four keys before it stores the first. A load after a store waits for it."""
    at = base + 0
    to = base + 0
    for _ in range(key_count // LOADED):
        loaded = loaded_keys(0)
        for j in range(LOADED):
            loaded[j] = keys[at + j * stride]
        at += LOADED * stride
        for j in range(LOADED):
            kept = 1 if loaded[j] <= limit else 0
            if kept == 1:
                keys[to] = loaded[j]
            to += stride * kept
    for _ in range(key_count % LOADED):
        key = keys[at]
        at += stride
        kept = 1 if key <= limit else 0
        if kept == 1:
            keys[to] = key
        to += stride * kept
    return (to - base) // stride


@func
def keep_nearest(keys: array(dtype=int64), base: int, stride: int, key_count: int, k: int, room: int) -> int:
    """Sort and keep the k smallest keys by counting smaller ones, fast up to MAX_COMPARED_KEYS. Return the count."""
    left = min(key_count, k)
    if key_count > MAX_COMPARED_KEYS:
        sort_keys(keys, base, stride, key_count)
    else:
        for block in range((key_count + VECTOR_LANES - 1) // VECTOR_LANES):
            own = key_lanes(0)
            ranks = key_lanes(0)  # as wide as the keys, to share vector registers
            for j in range(VECTOR_LANES):
                own[j] = keys[base + min(block * VECTOR_LANES + j, key_count - 1) * stride]
            for b in range(key_count):
                key = keys[base + b * stride]
                for j in range(VECTOR_LANES):
                    ranks[j] = ranks[j] + (int64(1) if key < own[j] else int64(0))
            for j in range(min(VECTOR_LANES, key_count - block * VECTOR_LANES)):
                if int(ranks[j]) < k:
                    keys[base + (room + int(ranks[j])) * stride] = own[j]
        for a in range(left):
            keys[base + a * stride] = keys[base + (room + a) * stride]
    return left


@keep_nearest.on_cuda
def pick_nearest(keys: array(dtype=int64), base: int, stride: int, key_count: int, k: int, room: int) -> int:
    """CUDA variant without a quadratic pass."""
    left = key_count
    if key_count > k:
        largest = keys[base]
        for j in range(1, key_count):
            largest = max(largest, keys[base + j * stride])
        limit = limit_nearest(keys, base, stride, key_count, k, key_number(largest))
        left = keep_up_to(keys, base, stride, key_count, limit)
    sort_keys(keys, base, stride, left)
    return left


@func
def thin_keys(keys: array(dtype=int64), base: int, stride: int, key_count: int, k: int, max_sqdist: float) -> int:
    """Drop far keys, keeping at least k, by three guesses of the k-th distance. Return the count."""
    left = key_count
    if key_count > k + k // MIN_EXCESS_DIVISOR and max_sqdist < UNLIMITED_SQRADIUS:
        fraction = max_sqdist * (float(k) / float(key_count))
        close = (int64(float_bits(fraction * FIRST_SQDIST_FACTOR)) + 1) << 32
        middle = (int64(float_bits(fraction * SECOND_SQDIST_FACTOR)) + 1) << 32
        wide = (int64(float_bits(fraction * THIRD_SQDIST_FACTOR)) + 1) << 32
        in_close = 0
        in_middle = 0
        in_wide = 0
        for j in range(key_count):
            key = keys[base + j * stride]
            if key < close:
                in_close += 1
            if key < middle:
                in_middle += 1
            if key < wide:
                in_wide += 1
        limit = wide
        if in_middle >= k:
            limit = middle
        if in_close >= k:
            limit = close
        if in_wide >= k:
            left = 0
            for j in range(key_count):
                key = keys[base + j * stride]
                keys[base + left * stride] = key
                if key < limit:
                    left += 1
    return left
