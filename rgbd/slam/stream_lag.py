"""Whether colour and depth of a camera were taken at the same time: their motions, one against the other.

What the camera does moves both pictures alike. The shifts of one are held against those of the other some frames
earlier or later; where the two go together then and not when they came together, one of them is late. Slow sweeps go
together at any time, so that what counts is the tremble of a hand, after a running mean is taken away.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

Shifts = NDArray[np.float64]

KEPT = 120  # frames that are held against each other: four seconds at 30 a second
FARTHEST = 45  # frames that one may be late
FEWEST = 25  # pairs that a lag is told from
EVERY = 5  # frames from one look to the next
SWEEP = 4  # frames to either side, whose mean is taken away
CLIPPED = 3.0  # deviations: one jerk is not the whole of a motion
TOGETHER = 0.6  # correlation: right lags of a hand-held camera 0.75 to 0.95 | the best of 90 wrong ones 0.4
BESIDE = 0.3  # by which it is to be above that of no lag: right streams 0 | a second apart 0.55 and more
NO_LAG = 3  # frames: a tenth of a second at 30 a second costs millimetres
SHORT = 0.15  # [s] as NO_LAG where the times are known
AGREED = 2  # looks in a row that tell the same lag, to a frame


class StreamLag:
    """Holds the motion of the colours against that of the depth.

    Attributes:
        frames: How many frames the colours are later than the depth of the same moment, below 0 where the depth is
            later; None while nothing says that they are apart.
        seconds: The same [s]; NaN without times.
        correlation: Of the two motions so.
    """

    def __init__(self) -> None:
        self.frames: int | None = None
        self.seconds, self.correlation = math.nan, 0.0
        self._bright: list[Shifts] = []
        self._near: list[Shifts] = []
        self._times: list[float | None] = []
        self._told: list[int] = []
        self._count = 0

    def add(self, bright: Shifts, near: Shifts, time: float | None) -> None:
        """The shifts [cells] of a frame's two pictures from the frame before, NaN where one has none."""
        self._bright, self._near = [*self._bright[1 - KEPT :], bright], [*self._near[1 - KEPT :], near]
        self._times = [*self._times[1 - KEPT :], time]
        self._count += 1
        if self._count % EVERY == 0 and len(self._bright) > FEWEST:
            self._look()

    def _look(self) -> None:
        bright, near = tremble(np.array(self._bright)), tremble(np.array(self._near))
        farthest = min(FARTHEST, len(bright) - FEWEST)
        lags = np.arange(-farthest, farthest + 1)
        together = correlations(bright, near)[lags + len(bright) - 1]
        step = self._step()
        is_short = abs(lags) <= NO_LAG if math.isnan(step) else (abs(lags) < 2) | (abs(lags) * step < SHORT)
        best, beside = int(np.argmax(together)), float(together[is_short].max())
        lag = int(lags[best])
        if not is_short[best] and together[best] > max(TOGETHER, beside + BESIDE):
            self._told = [*self._told[1 - AGREED :], lag]
            if len(self._told) == AGREED and np.ptp(self._told) <= 1:
                self.frames, self.seconds, self.correlation = lag, abs(lag) * step, float(together[best])
        elif together[best] > TOGETHER:  # they go together as they come; what moves too little tells nothing new
            self._told, self.frames = [], None

    def _step(self) -> float:
        """The usual time from frame to frame [s]; NaN where frames have none."""
        times = [time for time in self._times if time is not None]
        return float(np.median(np.diff(times))) if len(times) == len(self._times) > 1 else math.nan


def tremble(shifts: Shifts) -> Shifts:
    """Shifts [n, 2] less their running mean, in deviations, NaN where they are."""
    known = np.isfinite(shifts)
    sums = np.cumsum(np.vstack([np.zeros((1, 2)), np.where(known, shifts, 0.0)]), axis=0)
    counts = np.cumsum(np.vstack([np.zeros((1, 2)), known]), axis=0)
    at = np.arange(len(shifts))
    low, high = np.maximum(at - SWEEP, 0), np.minimum(at + SWEEP + 1, len(shifts))
    rest = shifts - (sums[high] - sums[low]) / np.maximum(counts[high] - counts[low], 1)
    squares = np.where(known, rest, 0.0) ** 2
    spread = np.sqrt(squares.sum(axis=0) / np.maximum(known.sum(axis=0), 1))
    return np.clip(rest / np.maximum(spread, 1e-9), -CLIPPED, CLIPPED)


def correlations(bright: Shifts, near: Shifts) -> Shifts:
    """The correlations of two trembles [n, 2], both axes together, at all lags from 1 - n to n - 1.

    Returns:
        Of the colours' taken so many frames later, float64 [2 n - 1]; 0 where too few frames have both.
    """
    told: Any = np.isfinite(bright).all(axis=1)
    shown: Any = np.isfinite(near).all(axis=1)
    first_known, second_known = told.astype(np.float64), shown.astype(np.float64)
    a, b = np.where(told[:, None], bright, 0.0), np.where(shown[:, None], near, 0.0)

    def at_lags(x: Any, y: Any) -> Shifts:
        return np.correlate(x, y, "full")

    count = at_lags(first_known, second_known)
    shared, first, second = (np.zeros(2 * len(a) - 1) for _ in range(3))
    for axis in (0, 1):
        x, y = a[:, axis], b[:, axis]
        sums = at_lags(x, second_known), at_lags(first_known, y)
        shared += at_lags(x, y) - sums[0] * sums[1] / np.maximum(count, 1)
        first += at_lags(x * x, second_known) - sums[0] ** 2 / np.maximum(count, 1)
        second += at_lags(first_known, y * y) - sums[1] ** 2 / np.maximum(count, 1)
    scale = np.sqrt(np.maximum(first, 0.0) * np.maximum(second, 0.0))
    return np.where((count > FEWEST - 0.5) & (scale > 1e-9), shared / np.maximum(scale, 1e-9), 0.0)
