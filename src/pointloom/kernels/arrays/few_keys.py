"""Stable sort of a few keys on one CPU thread: less than the launches and waits of a parallel sort."""

from ..array_types import Device, Indices, Integers
from ..lang import array, func, int32, int64, struct
from ..memory import empty, host_view, rows_of

MAX_FEW = 4096  # keys that one thread sorts: 3,000 points take 0.15 ms, 0.25 ms in parallel (2 cores, 2026-11-28)
DIGIT_BITS = 8  # bits of a radix pass
DIGIT_VALUES = 256


@struct
class FewKeys:
    """Keys to sort. Then `order`: their positions by key, stable; `starts`: starts of equal keys in it, then the end;
    `counts[0]`: the number of distinct keys. `others` and `positions` are scratch.
    """

    keys: array(dtype=int64)
    others: array(dtype=int64)
    order: array(dtype=int32)
    positions: array(dtype=int32)
    starts: array(dtype=int32)
    counts: array(dtype=int32)

    def __init__(self) -> None:
        self.keys, self.others = (empty(MAX_FEW, int64, "cpu") for _ in range(2))
        self.positions, self.counts = empty(MAX_FEW, int32, "cpu"), empty(DIGIT_VALUES, int32, "cpu")
        self.count_view = host_view(self.counts)

    def taken(self) -> tuple[Indices, Integers, int]:
        """The results: order, starts, and the number of distinct keys. The scratch is kept for the next call."""
        count, order, starts = int(self.count_view[0]), self.order, self.starts
        del self.order, self.starts  # these arrays are the caller's
        _idle.append(self)
        return order, rows_of(starts, 0, count + 1), count


_idle: list[FewKeys] = []  # for the next call: their allocation would take longer than the kernel


def few_keys(count: int, device: Device) -> FewKeys:
    """Room for some keys, with results allocated. A second thread, or a signal handler, gets other arrays."""
    try:
        few = _idle.pop()
    except IndexError:
        few = FewKeys()
    results = empty(2 * count + 1, int32, device)
    few.order, few.starts = rows_of(results, 0, count), rows_of(results, count, 2 * count + 1)
    return few


@func
def pass_few(n: int, shift: int, few: FewKeys) -> int:
    """One radix pass from `keys`, `order` to `others`, `positions`, copied back. Returns the nonempty buckets."""
    for digit in range(DIGIT_VALUES):
        few.counts[digit] = 0
    for i in range(n):
        digit = int((few.keys[i] >> int64(shift)) & int64(DIGIT_VALUES - 1))
        few.counts[digit] = few.counts[digit] + 1
    begin = int(0)
    nonempty = int(0)
    for digit in range(DIGIT_VALUES):
        size = few.counts[digit]
        few.counts[digit] = begin
        begin += size
        nonempty += min(size, 1)
    if nonempty > 1:
        for i in range(n):
            digit = int((few.keys[i] >> int64(shift)) & int64(DIGIT_VALUES - 1))
            at = few.counts[digit]
            few.counts[digit] = at + 1
            few.others[at] = few.keys[i]
            few.positions[at] = few.order[i]
        for i in range(n):
            few.keys[i] = few.others[i]
            few.order[i] = few.positions[i]
    return nonempty


@func
def sort_few(n: int, bit_count: int, few: FewKeys):
    """Sort non-negative keys of some bits, and their positions by them."""
    for i in range(n):
        few.order[i] = i
    passes = (bit_count + DIGIT_BITS - 1) // DIGIT_BITS
    for k in range(passes):
        _ = pass_few(n, DIGIT_BITS * k, few)


@func
def group_few(n: int, skipped: int64, few: FewKeys):
    """Starts of equal sorted keys. Those of `skipped`, which must be the last, are left out."""
    count = int(0)
    end = int(0)
    for i in range(n):
        if few.keys[i] != skipped:
            end = i + 1
            is_first = i == 0
            if i > 0:
                is_first = few.keys[i] != few.keys[i - 1]
            if is_first:
                few.starts[count] = i
                count += 1
    few.starts[count] = end
    few.counts[0] = count
