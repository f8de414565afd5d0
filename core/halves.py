"""Work that a GPU has no room for at once, done in halves where nothing but its answers is kept of it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

LEAST = 4096  # rows: below it halves save nothing worth their launches


def in_halves(count: int, work: Callable[[int, int], tuple[NDArray[Any], ...]]) -> tuple[NDArray[Any], ...]:
    """The answers of rows 0 to `count`, each independent of the others, asked for at once or in as few parts as fit.

    Args:
        count: Of the rows.
        work: The answers of rows from one number to another, as NumPy arrays that begin with an axis of rows.

    Returns:
        Each of the answers of all rows.

    Raises:
        MemoryError: There is no room for `LEAST` rows either.
    """
    parts, left = [], [(0, count)]
    while left:
        begin, end = left.pop()
        found = _attempt(work, begin, end)
        if found is not None:
            parts.append(found)
            continue
        middle = (begin + end) // 2
        left += [(middle, end), (begin, middle)]
    return parts[0] if len(parts) == 1 else tuple(np.concatenate(answers) for answers in zip(*parts, strict=True))


def _attempt(work: Callable[[int, int], Any], begin: int, end: int) -> Any:
    """The answers; None where there is no room for them and fewer rows may have it."""
    try:
        return work(begin, end)
    except MemoryError:
        if end - begin <= LEAST:
            raise
        return None  # what the error holds on to is released first
