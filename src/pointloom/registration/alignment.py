"""Check of a given pose: how far the surfaces of two clouds are apart."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_rigid
from ..core.reports import AssessedRecord
from ..kernels.linear_algebra import eigh, eigvalsh, matmul, solve
from ..kernels.poses.overlap_evidence import weigh_overlaps
from ..kernels.surface.hollow_side import Surface
from ..pcd.cloud import PointCloud
from .correspondence_input import check_clouds
from .evidence import TIGHT
from .pose_errors import match_distance, measure_step
from .rigid import invert_pose, make_pose, nearest_rotation, rotation_of, symmetric_matrices, to_world
from .surfaces import COSINE, ENOUGH, NEAR

Matrix = NDArray[np.float64]
# Error of the surfaces that more points do not reduce, relative to the residuals: lenses, distortion by motion, biased
# normals. With 0.085 to 0.1, 4 of the 93 correct poses on which it was chosen are rejected, with 0.08 6
# (benchmarks/trust/alignment.py, the fitted half of the pairs).
COMMON_ERROR = 0.09
# Least constraint by matches along any motion, relative to the attainable one. Ridge relative to the mean eigenvalue
MIN_SUPPORT, SUPPORT_RIDGE = 0.05, 0.01
MAX_DISTANCE = 3.55  # standard deviations: 95 % quantile of the chi distribution with six degrees of freedom


@dataclass(frozen=True, eq=False)
class Alignment(AssessedRecord):
    """How far a pose is from the pose at which two surfaces match.

    Attributes:
        transformation: The given pose, T_target_source.
        correction: float64 [4, 4]: `correction @ transformation` is a better pose. One step, so it is approximate if
            the displacement is large.
        displacement: RMS distance [m] by which the correction moves the overlap.
        sigma: Standard deviation of the displacement [m].
        distance: Mahalanobis distance of the correction from zero, in standard deviations.
        covariance: float64 [6, 6] of the correction: rotation vector [rad] and translation of `middle` [m], along the
            target's axes. Large along motions that the surfaces do not determine.
        middle: Center of the overlap [m] in the target's world.
        noise: Standard deviation of the distances between the surfaces, along the normals, after the correction [m].
        matches: Number of pairs of points.
        support: Constraint by matches after the correction, relative to that by all points near the other cloud, 0..1,
            along the motion for which it is smallest.
    """

    transformation: Matrix
    correction: Matrix
    displacement: float
    sigma: float
    distance: float
    covariance: Matrix
    middle: NDArray[np.float64]
    noise: float
    matches: int
    support: float

    @property
    def aligned(self) -> bool:
        """True if no displacement of the surfaces was detected."""
        return not self.warnings

    @property
    def warnings(self) -> tuple[str, ...]:
        if self.matches < ENOUGH or self.support < MIN_SUPPORT:
            return ("the surfaces do not match near this pose. Register the clouds with register_globally",)
        if self.distance > MAX_DISTANCE:
            size = f"{self.displacement:.2g} m with a standard deviation of {self.sigma:.1g} m"
            return (f"the source is off by {size}. Refine the pose with registration_icp",)
        return ()


def check_alignment(
    source: PointCloud, target: PointCloud, transformation: ArrayLike, max_correspondence_distance: float | None = None
) -> Alignment:
    """Check whether the surfaces of two clouds match under a pose, and measure how far they are apart.

    `rate_registration` decides whether two clouds show the same place, within the match distance. This function decides
    whether the pose is accurate. It solves one robust point-to-plane step and compares it with its covariance: the
    scatter of the gradients between blocks of the overlap, plus an error common to all points of 0.09 of the
    residuals. Displacements that are too large for such a step leave surfaces without a match.

    Args:
        source: The moved cloud.
        target: The fixed cloud, on the same device.
        transformation: T_target_source, 4x4.
        max_correspondence_distance: Match distance [m] of the registration, 1.5 voxels. Displacements up to twice this
            distance are measured. None: of `choose_voxel_size`.

    Returns:
        The displacement with its covariance. `reliable` and `aligned` if no displacement was detected.

    Raises:
        ValueError: A distance that is not positive or too small, or a pose that is not rigid.
        TypeError: Not a PointCloud.
        DeviceError: Clouds on different devices.

    Notes:
        Motions that the surfaces do not determine are not detected; their variance is large. Memory O(n). Bitwise
        reproducible. Chen and Medioni 1991 (rows). Liang and Zeger, "Longitudinal data analysis using generalized
        linear models", 1986 (covariance by blocks).

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-2, 2, (2, 20000))
        >>> surface = np.column_stack([x, y, 0.3 * np.sin(3 * x) * np.cos(2 * y) + 0.1 * np.sin(5 * y + x)])
        >>> source, target = loom.PointCloud(surface[:12000]), loom.PointCloud(surface[8000:])
        >>> shifted = np.eye(4)
        >>> shifted[0, 3] = 0.05
        >>> checks = [loom.registration.check_alignment(source, target, T, 0.15) for T in (np.eye(4), shifted)]
        >>> [check.aligned for check in checks], round(checks[1].displacement, 2)
        ([True, False], 0.05)
    """
    check_clouds(source, target)
    T = np.array(check_rigid("transformation", transformation))
    T[:3, :3] = nearest_rotation(T[:3, :3])
    distance = match_distance(source, target, max_correspondence_distance)
    step = measure_step(source, target, T, distance)
    if step is None:
        return _undetermined(T, target.origin.copy(), 0)
    rows, motion, noise = step.rows, step.motion, step.noise
    middle = rows.middle + target.origin
    if not step.is_solved:
        return _undetermined(T, middle, len(rows))
    covariance = step.scatter + (COMMON_ERROR * noise) ** 2 * step.unit
    to_radians = np.repeat([1 / rows.lever, 1.0], 3)
    rotation = rotation_of(motion[:3] / rows.lever)
    correction = make_pose(rotation, rows.middle + motion[3:] - matmul(rotation, rows.middle))
    return Alignment(
        T,
        to_world(correction, target.origin, target.origin),
        math.sqrt(_mean_square(np.outer(motion, motion), rows.spread)),
        math.sqrt(_mean_square(covariance, rows.spread)),
        math.sqrt(float(matmul(motion, solve(covariance, motion)))),
        covariance * np.outer(to_radians, to_radians),
        middle,
        noise,
        len(rows),
        _support(step.source, step.target, matmul(correction, step.pose), distance),
    )


def _undetermined(T: Matrix, middle: NDArray[np.float64], matches: int) -> Alignment:
    unknown = np.full((6, 6), math.inf)
    return Alignment(T, np.eye(4), math.nan, math.inf, math.nan, unknown, middle, math.nan, matches, 0.0)


def _support(source: Surface, target: Surface, pose: Matrix, distance: float) -> float:
    """Smallest eigenvalue of the matches' normal matrix relative to that of all near points, of the weaker way."""
    pairs, supports = [(source, target, pose), (target, source, invert_pose(pose))], []
    for sums in weigh_overlaps(pairs, distance, NEAR * distance, COSINE, TIGHT * distance):  # sync
        near, matched = symmetric_matrices(sums[:42].reshape(2, 21))
        ridge = SUPPORT_RIDGE * np.trace(near) / 6 * np.eye(6)
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
