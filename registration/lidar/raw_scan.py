"""A scan as the scanner gave it, and straightened by a motion."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...kernels.linear_algebra import elementwise
from ...kernels.memory import clone, contiguous, download
from ...kernels.odometry.deskewing import bound_times, deskew_points
from ...kernels.odometry.odometry_sampling import shift_points
from .deskewing import MIN_TIMES, twist_of, warn_of_coarse_times

Matrix = NDArray[np.float64]
SAMPLE = 4096  # points that a sweep is estimated from
BINS = 32  # of the time of a scan
LEAST_SWEEP = np.radians(20)  # of a spinning sensor
WHOLE_TURN = np.radians(345)


@dataclass(frozen=True, eq=False)
class RawScan:
    """The points of a scan about an origin, and their times where it is to be straightened.

    `part` is the fraction of the time between two scans that the times span.
    """

    points: wp.array
    origin: NDArray[np.float64]
    times: wp.array | None
    part: float = 1.0

    def kept(self) -> RawScan:
        """The scan in arrays of its own: a sensor's driver may write the next one over this."""
        times = None if self.times is None else clone(self.times)
        return RawScan(clone(self.points), self.origin, times, self.part)

    def straightened(self, motion: Matrix) -> wp.array:
        """The points about the sensor at the end of the scan; `motion` is that from scan to scan (eqs. 2 to 4)."""
        if self.times is not None and not np.array_equal(motion, np.eye(4)):
            span = bound_times(self.points, self.times)
            return deskew_points(self.points, self.times, self.origin, span, self.part * twist_of(motion))
        return shift_points(self.points, self.origin)


def part_of_interval(points: wp.array, times: wp.array, origin: NDArray[np.float64], interval: float | None) -> float:
    """The fraction of the time between two scans that the times of a scan span.

    Args:
        points: Device array of vec3 about `origin`.
        times: float64 device array.
        origin: float64 [3].
        interval: The time between two scans in the unit of the times; None estimates it from the sweep of a spinning
            sensor, which is the same part of a turn: 1 if the azimuth does not grow steadily with time.
    """
    if interval is not None:
        first, last = download(bound_times(points, times))  # sync
        return float(last - first) / interval if last > first else 1.0
    step = points.size // SAMPLE | 1
    p, t = (download(contiguous(values[::step])) for values in (points, times))  # sync
    p = p.astype(np.float64) + origin
    seen = np.isfinite(p).all(axis=1) & np.isfinite(t) & p.any(axis=1)
    p, t = p[seen], t[seen]
    length = np.sqrt(p[:, 0] * p[:, 0] + p[:, 1] * p[:, 1])
    span = float(np.ptp(t)) if len(t) else 0.0
    if len(t) > MIN_TIMES and len(np.unique(t)) < MIN_TIMES:
        warn_of_coarse_times(len(np.unique(t)), len(t))
    if not span > 0:
        return 1.0
    places = np.minimum(((t - t.min()) / span * BINS).astype(np.int64), BINS - 1)
    x, y = (np.bincount(places, column / np.where(length > 0, length, 1), BINS) for column in p.T[:2])
    known = (x != 0) | (y != 0)
    turns = np.diff(elementwise(math.atan2, y[known], x[known]))
    turns = (turns + np.pi) % (2 * np.pi) - np.pi
    sweep = abs(float(turns.sum())) * BINS / max(int(known.sum()) - 1, 1)  # of the bins' middles, from end to end
    is_steady = known.all() and ((turns > 0).all() or (turns < 0).all())
    return sweep / (2 * np.pi) if is_steady and LEAST_SWEEP < sweep < WHOLE_TURN else 1.0


@dataclass(frozen=True, eq=False)
class Thinned:
    """A scan about the sensor, thinned in turn: for the map, to be registered, and to try many starts with."""

    kept: wp.array
    sparse: wp.array
    few: wp.array
