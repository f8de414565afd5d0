"""Keys of neighbours in scratch memory: sorting them, keeping the k smallest, dropping far ones early.

Key j of a row that begins at `base` stands at `base` + j * `stride`: side by side on the CPU, whose vector registers
take several; a launch's rows interleaved on CUDA, where the lanes of a warp take theirs at once.

A key (packed_keys) is a squared distance above the index of the neighbour, so keys in ascending order are neighbours by
distance, ties by index, and no two are equal.
"""

from ..arrays.packed_keys import key_limit, key_number
from ..lang import array, bits_float, float_bits, func, int64

CLOSE = 1.05  # times the expected squared distance of the k-th neighbour: holds k in more than half of the cases
MIDDLE = 1.15  # ... in most
WIDE = 1.3  # ... in nearly all
MANY = 400  # keys that a heap sorts in the time of comparing all with all
SLIGHT = 8  # an eighth more than k is not worth a pass
GUESSES = 6  # before the search for a limit halves its interval: interpolation needs about four
BOUNDLESS = 3.0e38  # [m^2] a squared reach from here on is none


@func
def sift_down(keys: array(dtype=int64), base: int, stride: int, start: int, size: int):
    """Restore the heap property (largest first) below one slot."""
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
    """Sort `size` keys in place: heap sort, O(n log n) for any order and without scratch."""
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
    """Sort `size` keys by Batcher's network for any number of them (Knuth 5.2.2 M).

    All lanes of a warp compare the same places, O(n log^2 n) times.
    """
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
def count_up_to(keys: array(dtype=int64), base: int, stride: int, held: int, limit: int64) -> int:
    """How many of the keys held lie up to a limit."""
    count = int64(0)  # as wide as the keys, so that both share vector registers
    for j in range(held):
        if keys[base + j * stride] <= limit:
            count += 1
    return int(count)


@func
def limit_nearest(keys: array(dtype=int64), base: int, stride: int, held: int, k: int, reach: float) -> int64:
    """A limit that the k smallest of the keys lie up to and no other; the limit of `reach` where they are no more.

    Points within a squared radius grow in proportion to it on a surface, so interpolation finds one in a few passes.
    Where distances are tied or the guesses go wrong the interval is halved: keys differ, so at most 64 times.
    """
    low = int64(-1)
    high = key_limit(reach)
    below = 0
    above = held
    turn = 0
    while above > k:
        guess = low + (high - low) // 2
        if turn < GUESSES:
            near = key_number(max(low, 0))
            share = (float(k - below) + 0.5) / float(above - below)
            likely = key_limit(near + (key_number(high) - near) * share)
            if likely > low and likely < high:
                guess = likely
        found = count_up_to(keys, base, stride, held, guess)
        if found < k:
            low = guess
            below = found
        else:
            high = guess
            above = found
        turn += 1
    return high


@limit_nearest.on_cuda
def limit_between(keys: array(dtype=int64), base: int, stride: int, held: int, k: int, reach: float) -> int64:
    """The same, by passes that also find the distances beside the guess: three or four are enough for all lanes.

    The k-th distance lies in [least, largest]; ties with it are told apart by halving.
    """
    low = 0.0
    least = 0.0
    largest = reach
    below = 0
    above = held
    while above > k and least < largest:
        guess = low + (largest - low) * ((float(k - below) + 0.5) / float(above - below))
        guess = max(min(guess, bits_float(float_bits(largest) - 1)), least)
        count = 0
        up_to = 0.0
        beyond = largest
        at = base + 0
        for _ in range(held):
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
            least = beyond
            low = guess
            below = count
    limit = key_limit(largest)
    if above > k:
        behind = key_limit(largest)
        limit = (int64(float_bits(largest)) << 32) - 1
        while behind - limit > 1 and above > k:
            middle = limit + (behind - limit) // 2
            count = count_up_to(keys, base, stride, held, middle)
            if count < k:
                limit = middle
            else:
                behind = middle
                above = count
        limit = behind
    return limit


@func
def keep_up_to(keys: array(dtype=int64), base: int, stride: int, held: int, limit: int64) -> int:
    """Move the keys up to a limit to the front, in their order; how many."""
    size = 0
    for j in range(held):
        key = keys[base + j * stride]
        if key <= limit:
            keys[base + size * stride] = key
            size += 1
    return size


@func
def keep_nearest(keys: array(dtype=int64), base: int, stride: int, held: int, k: int, room: int) -> int:
    """Sort the keys held at `base` and keep the k smallest; how many are left.

    Each key's place is the number of smaller keys. That is quadratic, yet up to MANY faster than a sort: the inner loop
    has no branch and runs in vector registers. Keys differ, since each holds the index of its point.
    """
    left = min(held, k)
    if held > MANY:
        sort_keys(keys, base, stride, held)
    else:
        for a in range(held):
            key = keys[base + a * stride]
            place = int64(0)  # as wide as the keys, so that both share vector registers
            for b in range(held):
                if keys[base + b * stride] < key:
                    place += 1
            if int(place) < k:
                keys[base + (room + int(place)) * stride] = key
        for a in range(left):
            keys[base + a * stride] = keys[base + (room + a) * stride]
    return left


@keep_nearest.on_cuda
def pick_nearest(keys: array(dtype=int64), base: int, stride: int, held: int, k: int, room: int) -> int:
    """Sort the keys held at `base` and keep the k smallest, without a quadratic pass; how many are left."""
    left = held
    if held > k:
        largest = keys[base]
        for j in range(1, held):
            largest = max(largest, keys[base + j * stride])
        limit = limit_nearest(keys, base, stride, held, k, key_number(largest))
        left = keep_up_to(keys, base, stride, held, limit)
    sort_keys(keys, base, stride, left)
    return left


@func
def thin_keys(keys: array(dtype=int64), base: int, stride: int, held: int, k: int, reach: float) -> int:
    """Drop far keys while at least k are left, by three guesses at the k-th distance; how many are left.

    Points within a squared radius grow in proportion to it on a surface, so k of `held` lie within about k / held of
    the reach. A wrong guess only leaves more keys to sort.
    """
    left = held
    if held > k + k // SLIGHT and reach < BOUNDLESS:
        share = reach * (float(k) / float(held))
        close = (int64(float_bits(share * CLOSE)) + 1) << 32
        middle = (int64(float_bits(share * MIDDLE)) + 1) << 32
        wide = (int64(float_bits(share * WIDE)) + 1) << 32
        in_close = 0
        in_middle = 0
        in_wide = 0
        for j in range(held):
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
            for j in range(held):
                key = keys[base + j * stride]
                keys[base + left * stride] = key
                if key < limit:
                    left += 1
    return left
