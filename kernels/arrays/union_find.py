"""Disjoint sets over numbers 0..n-1, united by many threads at once with atomic_min alone.

Each set is a tree of links to lower numbers, so its root is its lowest number whatever the order of the threads. After
Jaiganesh and Burtscher, "A high-performance connected components implementation for GPUs", HPDC 2018 (ECL-CC), with
the minimum in place of the compare-and-swap: what a minimum pushes aside is carried on, as Rem's algorithm does
(Dijkstra, "A Discipline of Programming", 1976, chapter 23). 4 B a number.

No link is lost. Of all numbers that parents[x] ever holds below x, any two are in one set through links of numbers
below x and through pairs that a thread still has to unite: a minimum that finds `before` and offers `low` carries on
the pair (before, low); a shortened path puts a number there that was linked to the one before. So it does not matter
which of them parents[x] ends with, nor that a thread reads one that is out of date. Each turn lowers the higher number
of the pair, so a thread ends.
"""

from ..lang import array, atomic_min, func, int32, kernel, tid


@func
def find_root(parents: array(dtype=int32), x: int) -> int:
    """The root of x's set. Halves the path that it takes: each number that it passes skips one.

    The stores race with those of other threads; any of them leaves x in its set.
    """
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
    """Make one set of the sets of two numbers that were their roots a moment ago; a root of it, likewise.

    It makes no difference to the sets whether they still are.
    """
    a = x
    b = y
    while a != b:
        high = max(a, b)
        low = min(a, b)
        before = atomic_min(parents, high, low)  # settles which of several sets `high` hangs on: the lowest
        a = low
        b = low
        if before != high:  # another thread was faster: its link or ours was pushed aside, so those two are a pair now
            a = find_root(parents, low)
            b = find_root(parents, before)
    return a


@func
def unite(parents: array(dtype=int32), x: int, y: int) -> int:
    """Make one set of the sets of x and y; a number that was its root when the thread was done."""
    return hook_roots(parents, find_root(parents, x), find_root(parents, y))


@func
def read_root(parents: array(dtype=int32), x: int) -> int:
    """The root of x's set, changing nothing: for threads that store roots themselves."""
    at = x
    while parents[at] != at:
        at = parents[at]
    return at


@kernel
def flatten_sets_kernel(parents: array(dtype=int32)):
    """Link each number to its root; numbers with a negative parent belong to no set."""
    i = tid()
    if parents[i] >= 0:
        parents[i] = read_root(parents, i)
