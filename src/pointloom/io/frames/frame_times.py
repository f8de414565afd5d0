"""Detect irregular timestamps in a stream of frames."""

from __future__ import annotations

import math
from collections import deque
from statistics import median

# A gap is a time step this many times the usual one: one dropped frame makes 2, a hanging camera far more.
GAP_FACTOR = 5.0

MAX_REMARKS = 100  # stored notes. Further ones are only counted


class TimeWatch:
    """Detects timestamps that repeat, decrease or jump: the first 100 `notes`, and their `count`."""

    def __init__(self) -> None:
        self.notes: list[str] = []
        self.count = 0
        self._last: float | None = None
        self._steps: deque[float] = deque(maxlen=31)

    def see(self, name: str, time: float | None) -> None:
        if time is None:
            return
        if self._last is not None:
            step = time - self._last
            usual = median(self._steps) if len(self._steps) >= 5 else math.inf
            if step <= 0:
                back = f"{-step:.3f} s before" if step else "equal to"
                self.remark(f"{name}: its time stamp is {back} that of the frame before it")
            elif step > GAP_FACTOR * usual:
                self.remark(f"{name}: comes {step:.3f} s after the frame before it, instead of the usual {usual:.3f} s")
            if step > 0:
                self._steps.append(step)
        self._last = time

    def remark(self, text: str) -> None:
        """Add a note, or only count it if the list is full."""
        self.count += 1
        if len(self.notes) < MAX_REMARKS:
            self.notes.append(text)
