"""Columns that grow with the delivered data, as a header's count is not trusted with memory.

Memory: at most twice the delivered data and never more than the count. Arrays are reallocated in place.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

# Memory allocated on the header's count alone, about a million typical rows.
_FIRST_BYTES = 1 << 26


class GrowingColumns:
    """Named arrays of common length, filled by block; `is_proven` allocates all `count` rows at once."""

    def __init__(self, count: int, *, is_proven: bool):
        self._count, self._is_proven = count, is_proven
        self._capacity = count
        self._arrays: dict[str, NDArray[Any]] = {}
        self._filled = 0

    def append(self, block: dict[str, NDArray[Any]]) -> None:
        """Add rows. The first block, possibly empty, defines the types."""
        added = len(next(iter(block.values())))
        if not (self._arrays or self._is_proven):
            width = sum(values.dtype.itemsize * math.prod(values.shape[1:]) for values in block.values())
            self._capacity = min(self._count, max(added, _FIRST_BYTES // max(width, 1)))
        if self._filled + added > self._capacity:
            self._resize(max(self._filled + added, min(self._count, 2 * self._capacity)))
        for name, values in block.items():
            if name not in self._arrays:
                self._arrays[name] = np.empty((self._capacity, *values.shape[1:]), values.dtype)
            self._arrays[name][self._filled : self._filled + added] = values
        self._filled += added

    def finish(self) -> dict[str, NDArray[Any]]:
        if self._filled != self._capacity:
            self._resize(self._filled)
        return self._arrays

    def _resize(self, rows: int) -> None:
        self._capacity = rows
        for array in self._arrays.values():
            array.resize((rows, *array.shape[1:]), refcheck=False)  # no other reference exists yet
