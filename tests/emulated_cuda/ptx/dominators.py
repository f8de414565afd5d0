"""Blocks that every way to a block passes.

Cooper, Harvey and Kennedy, "A simple, fast dominance algorithm", 2001.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping


def dominators(ways: Mapping[int, Collection[int]], start: int) -> dict[int, int]:
    """The immediate dominator of each block that is reached from the start, which is its own.

    Args:
        ways: Where each block leads; a block that leads nowhere need not be there.
        start: Where all ways begin.
    """
    order, seen, stack = [], {start}, [(start, iter(ways.get(start, [])))]
    while stack:  # depth first
        block, rest = stack[-1]
        step = next((to for to in rest if to not in seen), None)
        if step is None:
            order.append(block)
            stack.pop()
        else:
            seen.add(step)
            stack.append((step, iter(ways.get(step, []))))
    place = {block: k for k, block in enumerate(order)}
    before: dict[int, list[int]] = {}
    for block in order:
        for to in ways.get(block, []):
            before.setdefault(to, []).append(block)
    found, changed = {start: start}, True
    while changed:
        changed = False
        for block in reversed(order[:-1]):
            new = None
            for other in (b for b in before[block] if b in found):
                new = other if new is None else _meet(other, new, found, place)
            if new is not None and found.get(block) != new:
                found[block], changed = new, True
    return found


def _meet(a: int, b: int, found: dict[int, int], place: dict[int, int]) -> int:
    while a != b:
        while place[a] < place[b]:
            a = found[a]
        while place[b] < place[a]:
            b = found[b]
    return a
