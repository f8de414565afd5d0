"""Test of a pose for a displacement of the surfaces of two clouds."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..core.reports import AssessedRecord
from ..kernels.linear_algebra import eigh, eigvalsh, matmul, solve
from ..kernels.poses.overlap_evidence import weigh_overlaps
from ..kernels.surface.hollow_side import Surface
from . import assessment_constants as constants
from .evidence import limits_of
from .pose_errors import Step
from .rigid import invert_pose, make_pose, rotation_of, symmetric_matrices, to_world

Matrix = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Alignment(AssessedRecord):
    """How far a pose is from the pose at which two surfaces match.

    Attributes:
        correction: float64 [4, 4]: `correction @ transformation` is a better pose. One step, so it is approximate if
            the displacement is large.
        displacement: RMS distance [m] by which the correction moves the overlap.
        sigma: Standard deviation of the displacement [m].
        distance: Mahalanobis distance of the correction from zero, in standard deviations. Its covariance has errors
            common to all points, of lenses and of motion, that the covariance of a registration excludes.
        noise: Standard deviation of the distances between the surfaces, along the normals, after the correction [m].
        matches: Number of pairs of points.
        support: Constraint by matches after the correction, relative to that by all points near the other cloud, 0..1,
            along the motion for which it is smallest.
    """

    correction: Matrix
    displacement: float
    sigma: float
    distance: float
    noise: float
    matches: int
    support: float

    @property
    def aligned(self) -> bool:
        """True if no displacement of the surfaces was detected."""
        return not self.warnings

    @property
    def is_supported(self) -> bool:
        """True if the surfaces match after the correction, along each motion."""
        return self.matches >= constants.MIN_MATCHES and self.support >= constants.MIN_SUPPORT

    @property
    def warnings(self) -> tuple[str, ...]:
        if not self.is_supported:
            return ("the surfaces do not match near this pose. Register the clouds with register_globally",)
        if self.distance > constants.MAX_DISTANCE:
            size = f"{self.displacement:.2g} m with a standard deviation of {self.sigma:.1g} m"
            return (f"the source is off by {size}. Use alignment.correction @ transformation, or registration_icp",)
        return ()


def alignment_of(step: Step | None, origin: NDArray[np.float64]) -> Alignment:
    """The displacement by a step, and its test. `origin` [m]: of the target."""
    if step is None or not step.is_solved:
        matches = 0 if step is None else len(step.rows)
        return Alignment(np.eye(4), math.nan, math.inf, math.nan, math.nan, matches, 0.0)
    rows, motion, noise = step.rows, step.motion, step.noise
    covariance = step.scatter + (constants.COMMON_ERROR * noise) ** 2 * step.unit
    rotation = rotation_of(motion[:3] / rows.lever)
    correction = make_pose(rotation, rows.middle + motion[3:] - matmul(rotation, rows.middle))
    return Alignment(
        to_world(correction, origin, origin),
        math.sqrt(_mean_square(np.outer(motion, motion), rows.spread)),
        math.sqrt(_mean_square(covariance, rows.spread)),
        math.sqrt(float(matmul(motion, solve(covariance, motion)))),
        noise,
        len(rows),
        _support(step.source, step.target, matmul(correction, step.pose), step.distance),
    )


def _support(source: Surface, target: Surface, pose: Matrix, distance: float) -> float:
    """Smallest eigenvalue of the matches' normal matrix relative to that of all near points, of the weaker way."""
    pairs, supports = [(source, target, pose), (target, source, invert_pose(pose))], []
    for sums in weigh_overlaps(pairs, *limits_of(distance)).plain:  # sync
        near, matched = symmetric_matrices(sums[:42].reshape(2, 21))
        ridge = constants.SUPPORT_RIDGE * np.trace(near) / 6 * np.eye(6)
        values, vectors = eigh(near + ridge)
        whitened = vectors / np.sqrt(np.maximum(values, 1e-300))
        supports.append(float(eigvalsh(matmul(whitened.T, matched + ridge, whitened))[0]))
    return max(min(supports), 0.0)


def _mean_square(covariance: Matrix, spread: Matrix) -> float:
    """Mean squared displacement [m2] of the overlap by motions (rotation times lever, translation) with a covariance.

    `spread`: covariance of the positions in levers.
    """
    lever = np.trace(spread) * np.eye(3) - spread
    return float((covariance[:3, :3] * lever).sum() + np.trace(covariance[3:, 3:]))
