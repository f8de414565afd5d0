"""What the time stamps of a stream of frames tell."""

from __future__ import annotations

import math
from collections import deque
from statistics import median

# A step in time this many times the usual one is a gap: one dropped frame makes 2, a camera that hangs far more.
GAP = 5.0

MOST_REMARKS = 100  # kept of a stream that never ends; further ones are counted


class TimeWatch:
    """Notices time stamps that stand still, go back or jump.

    Attributes:
        notes: What was noticed, each naming its frame; the first 100.
        count: How often something was noticed.
    """

    def __init__(self) -> None:
        self.notes: list[str] = []
        self.count = 0
        self._last: float | None = None
        self._steps: deque[float] = deque(maxlen=31)

    def see(self, name: str, time: float | None) -> None:
        """Take the time of the next frame [s]."""
        if time is None:
            return
        if self._last is not None:
            step = time - self._last
            usual = median(self._steps) if len(self._steps) >= 5 else math.inf
            if step <= 0:
                back = f"{-step:.3f} s before" if step else "equal to"
                self.remark(f"{name}: its time stamp is {back} that of the frame before it")
            elif step > GAP * usual:
                self.remark(f"{name}: comes {step:.3f} s after the frame before it, where {usual:.3f} s are usual")
            if step > 0:
                self._steps.append(step)
        self._last = time

    def remark(self, text: str) -> None:
        """Note something; what exceeds the list is counted."""
        self.count += 1
        if len(self.notes) < MOST_REMARKS:
            self.notes.append(text)
