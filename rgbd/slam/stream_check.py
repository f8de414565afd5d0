"""Whether the pictures of a depth camera are of one moment: a depth picture that came twice, colours that came late.

A stalled stream hands out its last depth picture again, bit for bit, beside colours that go on; a sensor that measures
never does so, since its noise differs. Where the colours stand still too, nothing is wrong: so do made-up frames.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import norm
from ...kernels.memory import download
from ...kernels.rgbd import stream_views as at
from ...kernels.rgbd.stream_views import StreamView, compare_views, view_stream
from .frames import SensorFrame
from .stream_lag import StreamLag

STALE = "its depth picture is the last one's"
STALLED = 3  # frames: cameras repeat one now and then, as real recordings show, and a tenth of a second costs little
STALLED_SECONDS = 0.12  # the same where the times are known
LEAST_CELLS = 0.02  # share of the cells that are measured, below which a depth picture says nothing
MOVED = 0.1  # [cells] the colours went since the depth came: a tenth of a degree; noise alone some 0.01
CHANGED = 0.03  # or this, the root mean square of what differs in a cell's brightness: noise of a camera 0.01


class StreamCheck:
    """What the frames so far say of the camera's two streams.

    Attributes:
        stalled: Frames in a row, up to the last, whose depth picture is an older one's and whose colours moved since.
        lag: The StreamLag.
        view: The StreamView of the last frame; None before the first.
    """

    def __init__(self) -> None:
        self.stalled, self.lag = 0, StreamLag()
        self.view: StreamView | None = None
        self._fresh: tuple[StreamView | None, float | None] = None, None

    def look(self, frame: SensorFrame) -> str:
        """What speaks against a frame; empty where nothing does. One wait for the device, two where depth is repeated.

        Args:
            frame: The next one of the stream.
        """
        view = view_stream(frame.depth, frame.pixels, frame.intrinsic.width, frame.intrinsic.height)
        last, self.view = self.view, view
        if last is None or frame.pixels is None:
            self._fresh, self.stalled = (view, frame.timestamp), 0
            return ""
        sums = motion_between(view, last)
        is_repeated = sums[at.OTHER] == 0 and sums[at.MEASURED] > LEAST_CELLS * view.columns * view.rows
        if not is_repeated:
            self._fresh, self.stalled = (view, frame.timestamp), 0
            self.lag.add(shift_of(sums, at.BRIGHT), shift_of(sums, at.NEAR), frame.timestamp)
            return self.problem or ""
        self.lag.add(shift_of(sums, at.BRIGHT), np.full(2, math.nan), frame.timestamp)
        fresh, since = self._fresh
        assert fresh is not None
        if has_moved(motion_between(view, fresh), view):
            self.stalled += 1
        age = frame.seconds_since(since)
        is_old = self.stalled > STALLED if math.isnan(age) else age > STALLED_SECONDS
        return STALE if self.stalled and is_old else self.problem or ""

    @property
    def problem(self) -> str | None:
        """Why color and depth do not belong together; None if they do."""
        if self.lag.frames is None:
            return None
        apart = f"{self.lag.seconds:.1f} s" if not math.isnan(self.lag.seconds) else f"{abs(self.lag.frames)} frames"
        return f"color and depth seem to be {apart} apart"


def motion_between(now: StreamView, before: StreamView) -> NDArray[np.float64]:
    """The sums of two views, float64 [13]."""
    sums: Any = download(compare_views(now, before))  # sync
    return np.asarray(sums, np.float64).reshape(-1)


def shift_of(sums: NDArray[np.float64], first: int) -> NDArray[np.float64]:
    """The shift of a picture [cells], float64 [2]; NaN where its slopes do not fix it."""
    a, b, c, d, e = sums[first : first + 5]
    determinant = a * c - b * b
    if determinant <= 1e-6 * (a + c) ** 2 or a + c <= 0.0:
        return np.full(2, math.nan)
    return np.array([b * e - c * d, b * d - a * e]) / determinant


def has_moved(sums: NDArray[np.float64], view: StreamView) -> bool:
    """Whether the colours of two views differ by more than noise."""
    shift = shift_of(sums, at.BRIGHT)
    changed = math.sqrt(sums[at.SHADES] / (view.columns * view.rows))
    return bool(norm(shift) > MOVED) or changed > CHANGED
