"""Parallel disjoint sets over numbers 0..n-1 with atomic_min only. Links go to lower numbers, so the root is the
minimum of the set.

Jaiganesh and Burtscher, "A high-performance connected components implementation for GPUs", HPDC 2018 (ECL-CC), with a
minimum in place of compare-and-swap. A displaced link is carried on as in Rem's algorithm (Dijkstra, "A Discipline of
Programming", 1976, chapter 23).

No link is lost: a minimum that replaces `before` by `low` continues with the pair (before, low), and a shortened path
stores a number linked to the previous one. Each iteration lowers the higher number of the pair, so a thread terminates.
"""

from ..lang import array, atomic_min, func, int32, kernel, tid, uint8


@func
def find_root(parents: array(dtype=int32), x: int) -> int:
    """Root of x's set, with path halving. Racing stores all leave x in its set."""
    at = x
    up = parents[at]
    while up != at:
        above = parents[up]
        if above != up:
            parents[at] = above
        at = above
        up = parents[at]
    return at


@func
def hook_roots(parents: array(dtype=int32), x: int, y: int) -> int:
    """Unite the sets of two recent roots. Returns a recent root. They need not be roots any more."""
    a = x
    b = y
    while a != b:
        high = max(a, b)
        low = min(a, b)
        before = atomic_min(parents, high, low)  # resolves the race: `high` is linked to the lowest candidate
        a = low
        b = low
        if before != high:  # another thread was faster: one of the two links was displaced, so they are a new pair
            a = find_root(parents, low)
            b = find_root(parents, before)
    return a


@func
def unite(parents: array(dtype=int32), x: int, y: int) -> int:
    """Unite the sets of x and y. Returns a number that was its root at the end."""
    return hook_roots(parents, find_root(parents, x), find_root(parents, y))


@func
def read_root(parents: array(dtype=int32), x: int) -> int:
    """Root of x's set without writes, for threads that store roots themselves."""
    at = x
    while parents[at] != at:
        at = parents[at]
    return at


@kernel
def flatten_sets_kernel(parents: array(dtype=int32)):
    """Link each number to its root. Negative parents belong to no set."""
    i = tid()
    if parents[i] >= 0:
        parents[i] = read_root(parents, i)


@kernel
def mask_roots_kernel(parents: array(dtype=int32), mask: array(dtype=uint8)):
    i = tid()
    mask[i] = uint8(1 if parents[i] == i else 0)
