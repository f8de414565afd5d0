"""Covariance of the pose errors of LiDAR odometry, accumulated along the path."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import eigh, matmul
from ...kernels.odometry.patch_errors import PatchNumbers, fit_patches
from ..assessment_constants import SUSPECT_FRACTION, TO_SIGMA, WEIGHT_WIDTH
from ..pose_errors import PoseCovariance

Matrix = NDArray[np.float64]

# Constants chosen on 30 drives through synthetic streets, halls, woods, corridors and open ground, with other seeds
# than those of benchmarks/trust/calibration.py.
MODEL_ERROR = 0.02  # relative to the residuals: an error common to all points
STEP_FACTOR = 1.0  # of the mean squared distance from the pose that the surfaces alone determine
SHIFT_FACTOR = 4.0  # of the outer product of the motion to that pose
RENEWED_FRACTION = 0.3  # renewed fraction of the map, relative to the ratio of new voxels and points of a scan
PLANE_PRIOR_PATCHES = 0.2  # number of surface patches that count as much as all planes, which beams form too
REWEIGHTED_SOLUTIONS = 3  # reweighted solutions
MOTION_RIDGE = 1e-4  # relative to the normal matrix of a row: undetermined motions
SMALLEST_WIDTH = 1e-4  # voxels


@dataclass(frozen=True, eq=False)
class MatchError:
    """Covariance of the error of a scan's pose in the map, about the sensor along the map's axes, float64 [6, 6].

    Attributes:
        matrix: Of rotation [rad] and translation [m].
        lasting: The part along motions that the map's surfaces hardly determine. The surfaces of the scan define the
            map along them, so later scans have the same error.
    """

    matrix: Matrix = field(default_factory=lambda: np.zeros((6, 6)))
    lasting: Matrix = field(default_factory=lambda: np.zeros((6, 6)))

    def plus_lasting(self, matrix: Matrix) -> MatchError:
        return MatchError(self.matrix + matrix, self.lasting + matrix)


def match_error(information: Matrix, rows: Matrix, residual: float, size: float) -> MatchError:
    """The error of a match from `information` of planes [6, 6], rows of surface patches [n, 7], and residuals [m].

    A robust step to the surface patches alone gives the distance of the pose from the one that they determine. Planes
    count little, since the rings and columns of a scan form some that move along with the sensor. `size`: voxel edge.
    """
    planes = max(float(information[3, 3] + information[4, 4] + information[5, 5]), 1e-9)
    turning = float(information[0, 0] + information[1, 1] + information[2, 2])
    lever = max(math.sqrt(turning / planes), size)
    scale = np.array([lever] * 3 + [1.0] * 3)
    squares = scale[:, None] * scale
    numbers = PatchNumbers(
        row_count=len(rows), lever=lever, prior=PLANE_PRIOR_PATCHES, ridge=MOTION_RIDGE, width=WEIGHT_WIDTH * TO_SIGMA,
        min_width=SMALLEST_WIDTH * size / TO_SIGMA, rounds=REWEIGHTED_SOLUTIONS,
        variance=(MODEL_ERROR * residual) ** 2, step_factor=STEP_FACTOR, shift_factor=SHIFT_FACTOR,
        limit=SUSPECT_FRACTION,
    )  # fmt: skip
    of_planes = information / squares / planes + MOTION_RIDGE * np.eye(6)
    matrix, normal, variance, is_weak = fit_patches(rows, of_planes, numbers)
    lasting = np.zeros((6, 6))
    if is_weak:
        values, vectors = eigh(normal)
        weak = vectors[:, values < SUSPECT_FRACTION]
        lasting = variance * matmul(weak / values[values < SUSPECT_FRACTION], weak.T)
    return MatchError((matrix + matrix.T) / 2 / squares, lasting / squares)


def prediction_error(deviation: float, max_range: float) -> Matrix:
    """Covariance of a predicted motion that displaces the sensor and points at maximum range by a deviation [m]."""
    return np.diag([(deviation / max_range) ** 2] * 3 + [deviation**2] * 3)


@dataclass(frozen=True, eq=False)
class MapError:
    """Error of the map around the sensor relative to the first scan, before its `last` scan was added.

    `voxels` is the number of voxels before that, `points` the number of points of the scan.
    """

    covariance: PoseCovariance = field(default_factory=lambda: PoseCovariance(np.zeros((6, 6)), np.zeros(3)))
    last: MatchError = field(default_factory=MatchError)
    voxels: int = 0
    points: int = 1

    def with_last(self, voxels: int) -> PoseCovariance:
        """Covariance with the last scan, when the map has `voxels` voxels.

        The error of a scan counts as much as it renews the map: errors common to the scans that see a surface are
        those of the surface, and errors of different surfaces are independent.
        """
        fraction = min(RENEWED_FRACTION * max(voxels - self.voxels, 0) / self.points, 1.0)
        last = self.last
        matrix = self.covariance.matrix + fraction * (last.matrix - last.lasting) + last.lasting
        return PoseCovariance(matrix, self.covariance.center)

    def of_pose(self, voxels: int, position: NDArray[np.float64], error: MatchError) -> PoseCovariance:
        """Covariance of the pose of the next scan, about its position."""
        matrix = self.with_last(voxels).about(position).matrix + error.matrix
        return PoseCovariance((matrix + matrix.T) / 2, position.copy())

    def after(self, voxels: int, points: int, position: NDArray[np.float64], error: MatchError) -> MapError:
        """The error of the map with one more scan."""
        return MapError(self.with_last(voxels).about(position), error, voxels, max(points, 1))

    def without_voxels(self, count: int) -> MapError:
        """The same after `count` voxels far away were removed."""
        return replace(self, voxels=self.voxels - count)
