"""A scan as the scanner gave it, and straightened by a motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...kernels.memory import clone
from ...kernels.odometry.deskewing import bound_times, deskew_points
from ...kernels.odometry.odometry_sampling import shift_points
from .deskewing import twist_of

Matrix = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class RawScan:
    """The points of a scan about an origin, and their times where it is to be straightened."""

    points: wp.array
    origin: NDArray[np.float64]
    times: wp.array | None

    def kept(self) -> RawScan:
        """The scan in arrays of its own: a sensor's driver may write the next one over this."""
        return RawScan(clone(self.points), self.origin, None if self.times is None else clone(self.times))

    def straightened(self, motion: Matrix) -> wp.array:
        """The points about the sensor at the end of the scan, which it reached by this motion (eqs. 2 to 4)."""
        if self.times is not None and not np.array_equal(motion, np.eye(4)):
            span = bound_times(self.points, self.times)
            return deskew_points(self.points, self.times, self.origin, span, twist_of(motion))
        return shift_points(self.points, self.origin)


@dataclass(frozen=True, eq=False)
class Thinned:
    """A scan about the sensor, thinned in turn: for the map, to be registered, and to try many starts with."""

    kept: wp.array
    sparse: wp.array
    few: wp.array
