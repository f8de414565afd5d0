"""Split a batch recursively until it fits into GPU memory."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

MIN_ROWS = 4096  # rows: smaller batches are not worth their launches


def in_batches(count: int, work: Callable[[int, int], tuple[NDArray[Any], ...]]) -> tuple[NDArray[Any], ...]:
    """Results of independent rows 0 to `count`, computed at once or in as few parts as fit.
    `work(begin, end)` returns NumPy arrays with rows first. Raises `MemoryError` if `MIN_ROWS` rows do not fit."""
    parts, pending = [], [(0, count)]
    while pending:
        begin, end = pending.pop()
        result = _attempt(work, begin, end)
        if result is not None:
            parts.append(result)
            continue
        middle = (begin + end) // 2
        pending += [(middle, end), (begin, middle)]
    return parts[0] if len(parts) == 1 else tuple(np.concatenate(arrays) for arrays in zip(*parts, strict=True))


def _attempt(work: Callable[[int, int], Any], begin: int, end: int) -> Any:
    try:
        return work(begin, end)
    except MemoryError:
        if end - begin <= MIN_ROWS:
            raise
        return None  # what the error references must be released first
