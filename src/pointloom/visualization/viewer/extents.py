"""Union of many boxes with constant cost per change: `Extents`."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Bounds = tuple[NDArray[np.float64], NDArray[np.float64]]

_FIRST_ROOM = 16  # initial capacity; doubled when full


class Extents:
    """Boxes by name and their union.

    An added box widens the union at once. After removal of a box at the border, the union is recomputed on next use.
    """

    def __init__(self) -> None:
        self._slots: dict[str, int] = {}
        self._free: list[int] = []
        self._ends = np.full((_FIRST_ROOM, 6), np.inf)  # low and negated high of each box; inf in free slots
        self._union = np.full(6, np.inf)
        self._is_stale = False

    def __len__(self) -> int:
        return len(self._slots)

    def put(self, name: str, bounds: Bounds | None) -> None:
        if bounds is None:
            self.drop(name)
            return
        slot = self._slots.get(name)
        if slot is None:
            slot = self._slots[name] = self._take_slot()
        ends = np.concatenate([bounds[0], -bounds[1]])
        # a side that was at the border and is not anymore
        self._is_stale |= bool(((self._ends[slot] <= self._union) & (ends > self._union)).any())
        self._ends[slot] = ends
        np.minimum(self._union, ends, out=self._union)

    def drop(self, name: str) -> None:
        slot = self._slots.pop(name, None)
        if slot is not None:
            self._is_stale |= bool((self._ends[slot] <= self._union).any())
            self._ends[slot] = np.inf
            self._free.append(slot)

    def union(self) -> Bounds | None:
        if not self._slots:
            self._union[:], self._is_stale = np.inf, False
            return None
        if self._is_stale:
            self._union, self._is_stale = self._ends.min(axis=0), False
        return self._union[:3].copy(), -self._union[3:]

    def corners(self) -> NDArray[np.float64]:
        ends = self._ends[list(self._slots.values())].reshape(-1, 2, 3) * [[1.0], [-1.0]]
        each = [ends[:, [i, j, k], [0, 1, 2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)]
        return np.stack(each, axis=1).reshape(-1, 3)

    def _take_slot(self) -> int:
        if self._free:
            return self._free.pop()
        slot = len(self._slots)
        if slot == len(self._ends):
            self._ends = np.concatenate([self._ends, np.full_like(self._ends, np.inf)])
        return slot
