"""Covariance of the pose errors of LiDAR odometry, accumulated along the path."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import eigh, matmul
from ...kernels.odometry.patch_errors import PatchNumbers, fit_patches
from ..assessment_constants import SUSPECT_FRACTION, TO_SIGMA, WEIGHT_WIDTH
from ..pose_errors import PoseCovariance
from ..rigid import skew

Matrix = NDArray[np.float64]

# | constant | error |
# |---|---|
# | MODEL_ERROR | surfaces that are no planes, relative to the residuals: an error common to all points |
# | STEP_FACTOR | noise: of the mean squared distance from the pose that the surface patches alone determine. They are |
# |             | few and far apart, so that errors that neighboring points share are part of that distance |
# | SHIFT_FACTOR | bias: of the outer product of the motion to that pose |
# | RANGE_SCALE | of the sensor, an error common to all scans: data sheets state 2 cm at 20 m |
# Chosen on 2026-11-29 so that each kind has at least 65 and 93 % within one and two sigma: on 30 synthetic drives
# (seeds 500 to 504 of benchmarks/trust/drives.py) and on two recordings, forward and backward. These are scans 0 to 87
# of a handheld scanner with 64 beams (hku-mars/BALM), and a car with 64 beams (udacity/SFND_Lidar_Obstacle_Detection,
# data_2). Coverage on other seeds and recordings: docs/trust.md.
MODEL_ERROR = 0.02
STEP_FACTOR = 0.5
SHIFT_FACTOR = 0.7
RANGE_SCALE = 0.001
PLANE_PRIOR_PATCHES = 0.2  # number of surface patches that count as much as all planes, which beams form too
REWEIGHTED_SOLUTIONS = 3  # reweighted solutions
MOTION_RIDGE = 1e-4  # relative to the normal matrix of a row: undetermined motions
SMALLEST_WIDTH = 1e-4  # voxels
SMALLEST_VARIANCE = 1e-20  # [rad^2], [m^2]: of no match


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

    `voxels` is the number of voxels before that, `points` the number of points of the scan. `shared` [6, 6] is the
    covariance of the error with those of the matches, in standard deviations of these.
    """

    covariance: PoseCovariance = field(default_factory=lambda: PoseCovariance(np.zeros((6, 6)), np.zeros(3)))
    last: MatchError = field(default_factory=MatchError)
    voxels: int = 0
    points: int = 1
    shared: Matrix = field(default_factory=lambda: np.zeros((6, 6)))

    @cached_property
    def _spread(self) -> Matrix:
        """Square root of the covariance of the last match, without its lasting part."""
        matrix = self.last.matrix - self.last.lasting
        sigmas = np.sqrt(np.maximum(np.diag(matrix), SMALLEST_VARIANCE))
        values, vectors = eigh(matrix / sigmas / sigmas[:, None])
        return sigmas[:, None] * matmul(vectors * np.sqrt(np.maximum(values, 0)), vectors.T)

    def with_last(self, voxels: int) -> tuple[Matrix, Matrix]:
        """Covariance and `shared` with the last scan, when the map has `voxels` voxels.

        The error of a scan counts as much as it renews the map: errors common to the scans that see a surface are
        those of the surface. Errors of matches are correlated until the map is renewed: rings on the ground move along
        with the sensor, and pitch and height drift at a constant rate.
        """
        fraction = min(max(voxels - self.voxels, 0) / self.points, 1.0)
        added = fraction * self._spread
        half = matmul(self.shared + added / 2, added.T)
        matrix = self.covariance.matrix + half + half.T + self.last.lasting
        return matrix, (1 - fraction) * (self.shared + added)

    def of_pose(self, voxels: int, position: NDArray[np.float64], error: MatchError) -> PoseCovariance:
        """Covariance of the pose of the next scan, about its position, which is relative to the first scan."""
        of_map = PoseCovariance(self.with_last(voxels)[0], self.covariance.center)
        matrix = of_map.about(position).matrix + error.matrix
        matrix = (matrix + matrix.T) / 2
        matrix[3:, 3:] += RANGE_SCALE**2 * position[:, None] * position
        return PoseCovariance(matrix, position.copy())

    def after(self, voxels: int, points: int, position: NDArray[np.float64], error: MatchError) -> MapError:
        """The error of the map with one more scan."""
        matrix, shared = self.with_last(voxels)
        A = np.eye(6)
        A[3:, :3] = -skew(position - self.covariance.center)
        covariance = PoseCovariance(matmul(A, matrix, A.T), position.copy())
        return MapError(covariance, error, voxels, max(points, 1), matmul(A, shared))

    def without_voxels(self, count: int) -> MapError:
        """The same after `count` voxels far away were removed."""
        return replace(self, voxels=self.voxels - count)
