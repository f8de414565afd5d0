"""Columns that grow with what a file delivers, where its header's count is not to be trusted with memory.

Memory: at most twice what was delivered, and never more than the count itself; growing reallocates in place, so no two
copies of a large column are held (the system moves its pages).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

# Memory that is taken on the header's word alone, some million rows of usual ones.
_FIRST_BYTES = 1 << 26


class GrowingColumns:
    """Arrays of a common length by name, filled block by block.

    Args:
        count: Rows that the header says will come.
        is_proven: Whether the file was found large enough for them; then all memory is taken at once.
    """

    def __init__(self, count: int, *, is_proven: bool):
        self._count, self._is_proven = count, is_proven
        self._capacity = count
        self._arrays: dict[str, NDArray[Any]] = {}
        self._filled = 0

    def append(self, block: dict[str, NDArray[Any]]) -> None:
        """Add rows; every block has the same columns, the first of them (which may be empty) says their types."""
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
        """The columns, as long as what was added."""
        if self._filled != self._capacity:
            self._resize(self._filled)
        return self._arrays

    def _resize(self, rows: int) -> None:
        self._capacity = rows
        for array in self._arrays.values():
            array.resize((rows, *array.shape[1:]), refcheck=False)  # nobody else has seen it yet
