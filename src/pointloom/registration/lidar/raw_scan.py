"""A scan before it is downsampled: points with times, and how much of the scan interval they span."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...kernels.linear_algebra import elementwise
from ...kernels.memory import Readback, clone, contiguous, download
from ...kernels.odometry.deskewing import bound_times, deskew_along_path, deskew_points
from ...kernels.odometry.odometry_sampling import shift_points
from ...pcd.search import NearestNeighborSearch
from .deskewing import MIN_TIMES, check_resolution, twist_of, warn_of_coarse_times
from .inertial import InertialMotion

Matrix = NDArray[np.float64]

SWEEP_SAMPLE = 4096  # points for the estimate of a sweep
SWEEP_BINS = 32  # time bins of a scan
MIN_SWEEP = np.radians(20)  # minimum sweep of a spinning sensor
FULL_SWEEP = np.radians(345)
NOISE_SAMPLE = 1024  # neighborhoods of the estimate of the noise
NOISE_NEIGHBORS = 9  # points of a neighborhood, of two or three rings. Planes have three parameters
# Quantile of the residuals: planes, as edges and leaves have larger ones. Their ratio to the noise is 0.76 if all are
# planes, and was 0.8 to 0.95 in synthetic streets and villages with trees (16 to 64 beams, 1 to 10 cm). 2026-11-30.
PLANE_QUANTILE, QUANTILE_RATIO = 0.25, 0.8
MIN_SPREAD = 1e-5  # [rad] of directions: float32 resolves 1e-7
MAX_NOISE = 0.2  # [m] ranges of scanners have up to 0.1; accumulated clouds have several ranges per direction


@dataclass(frozen=True, eq=False)
class RawScan:
    """Points of a scan about an origin with optional times, which span the fraction `part` of the scan interval."""

    points: wp.array
    origin: NDArray[np.float64]
    times: wp.array | None
    part: float = 1.0
    path: Matrix | None = None

    def with_imu(self, inertial: InertialMotion) -> RawScan:
        """The scan with the rotation during it by an IMU, and the fraction of the interval by its clock."""
        if self.times is None:
            return self
        return replace(self, path=inertial.path, part=inertial.part or self.part)

    def copy(self) -> RawScan:
        """A copy of the scan: a sensor driver may reuse its buffer."""
        times = None if self.times is None else clone(self.times)
        return replace(self, points=clone(self.points), times=times)

    def deskewed(self, motion: Matrix) -> wp.array:
        """The points about the sensor at the end of the scan, deskewed by the motion between scans (eqs. 2 to 4)."""
        if self.path is not None and self.times is not None and self._span is not None:
            velocity = self.part * twist_of(motion)[3:]
            return deskew_along_path(self.points, self.times, self.origin, self._span, self.path, velocity)
        if not np.array_equal(motion, np.eye(4)) and self.times is not None and self._span is not None:
            return deskew_points(self.points, self.times, self.origin, self._span, self.part * twist_of(motion))
        return shift_points(self.points, self.origin)

    def sent_span(self) -> Readback | None:
        """The first and the last time, being copied to the host; None without times."""
        if self._span is None:
            return None
        readback = Readback(self._span)
        readback.send()
        return readback

    @cached_property
    def _span(self) -> wp.array | None:
        """The first and the last time, on the device; None without times."""
        return None if self.times is None else bound_times(self.points, self.times)


def part_of_interval(
    points: wp.array, times: wp.array, origin: NDArray[np.float64], interval: float | None, are_single: bool = False
) -> float:
    """The fraction of the scan interval that the times span; None: of a revolution if the azimuth is steady, else 1.
    Raises ValueError if the times are float32 numbers (`are_single`) that do not resolve the scan."""
    if interval is not None:
        first, last = download(bound_times(points, times))  # sync
        check_resolution(times, first, last, are_single)
        return float(last - first) / interval if last > first else 1.0
    step = points.size // SWEEP_SAMPLE | 1
    p, t = (download(contiguous(values[::step])) for values in (points, times))  # sync
    p = p.astype(np.float64) + origin
    is_valid = np.isfinite(p).all(axis=1) & np.isfinite(t) & p.any(axis=1)
    p, t = p[is_valid], t[is_valid]
    length = np.sqrt(p[:, 0] * p[:, 0] + p[:, 1] * p[:, 1])
    span = float(np.ptp(t)) if len(t) else 0.0
    if len(t):
        check_resolution(times, float(t.min()), float(t.max()), are_single)
    if len(t) > MIN_TIMES and len(np.unique(t)) < MIN_TIMES:
        warn_of_coarse_times(len(np.unique(t)), len(t))
    if not span > 0:
        return 1.0
    bins = np.minimum(((t - t.min()) / span * SWEEP_BINS).astype(np.int64), SWEEP_BINS - 1)
    x, y = (np.bincount(bins, column / np.where(length > 0, length, 1), SWEEP_BINS) for column in p.T[:2])
    known = (x != 0) | (y != 0)
    angles = np.diff(elementwise(math.atan2, y[known], x[known]))
    angles = (angles + np.pi) % (2 * np.pi) - np.pi
    sweep = abs(float(angles.sum())) * SWEEP_BINS / max(int(known.sum()) - 1, 1)  # between the outer bin centers
    is_steady = known.all() and ((angles > 0).all() or (angles < 0).all())
    return sweep / (2 * np.pi) if is_steady and MIN_SWEEP < sweep < FULL_SWEEP else 1.0


def range_noise(points: wp.array, min_range: float, max_range: float) -> float:
    """Standard deviation [m] of the ranges of a scan about its sensor. 0 if it is unknown.

    The inverse range of points on a plane is linear in their unit direction, however sparse the beams are. The
    residuals of neighborhoods that are planes are noise.
    """
    p = download(points).astype(np.float64)
    ranges = np.sqrt((p * p).sum(axis=1))
    near = (ranges > min_range) & (ranges < max_range)  # False for NaN
    p, ranges = p[near], ranges[near]
    if len(p) < NOISE_SAMPLE:
        return 0.0
    directions = p / ranges[:, None]
    rows = slice(None, None, -(-len(p) // NOISE_SAMPLE))
    search = NearestNeighborSearch(directions, device=points.device)
    neighbors = search.knn_search(directions[rows], NOISE_NEIGHBORS).indices
    rest = 1 / ranges[neighbors]
    axes: list[Matrix] = []
    for axis in np.moveaxis(directions[neighbors], 2, 0):  # modified Gram-Schmidt
        for unit in axes:
            axis = axis - (axis * unit).sum(axis=1, keepdims=True) * unit
        length = np.sqrt((axis * axis).sum(axis=1, keepdims=True))
        axes.append(axis / np.where(length > MIN_SPREAD, length, np.inf))
        rest = rest - (rest * axes[-1]).sum(axis=1, keepdims=True) * axes[-1]
    residuals = np.sqrt((rest * rest).sum(axis=1) / (NOISE_NEIGHBORS - 3)) * ranges[rows] ** 2
    noise = float(np.quantile(residuals, PLANE_QUANTILE)) / QUANTILE_RATIO
    return noise if noise < MAX_NOISE else 0.0
