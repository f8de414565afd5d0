"""Covariance of the error of a registered pose, from the surfaces of the two clouds."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_positive, check_rigid, check_shape
from ..kernels.linear_algebra import eigvalsh, inv, matmul, solve
from ..kernels.poses.alignment_rows import AlignmentRows, PairedSurfaces
from ..kernels.surface.hollow_side import Surface
from ..pcd.cloud import PointCloud
from .correspondence_input import check_clouds
from .rigid import invert_pose, nearest_rotation, skew, symmetric_matrices, to_local
from .surfaces import COSINE, ENOUGH, FINER, VOXELS, surface_for
from .unobservable_motions import SUSPECT_SHARE, judge_motions
from .voxel_size import choose_voxel_size

Matrix = NDArray[np.float64]
FINE = 0.5  # voxels of the compared surfaces, relative to those of the registration
REACH = 3.0  # [voxels] distance up to which nearest points are pairs
BLOCK = 10.0  # [voxels] edge of the blocks within which errors may be correlated
ROUNDS = 5  # reweighted solutions
TO_SIGMA = 1.4826  # standard deviation of a normal distribution from its median absolute deviation
WIDTH = 2.0  # standard deviations of the residuals at which a row has a quarter of its weight
RIDGE = 1e-6  # relative to the normal matrix of a row: undetermined motions
# Error of the surfaces that more points do not reduce, relative to the residuals. The second part grows with the
# residuals in voxels, since these bias the normals. Chosen on 24 rooms, 60 sites, 40 streets and 40 divided real scans,
# generated like those of benchmarks/trust/calibration.py from other seeds.
MODEL_ERROR, NORMAL_ERROR = 0.005, 0.35
# Factor of the mean squared distance from the step. If the error is this distance in a random one of six directions,
# 66 % and 99 % of its components are within one and two standard deviations, with a factor of one 64 % and 97 %.
STEP_FACTOR = 1.1


@dataclass(frozen=True, eq=False)
class PoseCovariance:
    """Covariance of the error of a pose T_target_source.

    The error is the motion that moves the pose onto the true one: `rotation` is a rotation vector [rad] along the
    target's axes, `translation` [m] is the displacement of the point `center` along the target's axes.

    Attributes:
        matrix: float64 [6, 6] of rotation and translation, in this order. Infinite if the surfaces do not match.
        center: The point [m] in the target's world, the center of the overlap. Far from it, at a world origin for
            example, rotations and translations are strongly correlated.
    """

    matrix: Matrix
    center: NDArray[np.float64]

    @property
    def sigmas(self) -> NDArray[np.float64]:
        """Standard deviations of the rotation [rad] about x, y, z and of the translation [m], float64 [6]."""
        return np.sqrt(np.diag(self.matrix))

    def about(self, point: ArrayLike) -> PoseCovariance:
        """The same covariance, with the translation of another point [m] of the target's world, shape (3,)."""
        position = check_shape("point", point, (3,)).astype(np.float64)
        if not np.isfinite(self.matrix).all():
            return PoseCovariance(self.matrix, position)
        A = np.eye(6)
        A[3:, :3] = -skew(position - self.center)
        return PoseCovariance(matmul(A, self.matrix, A.T), position)


def pose_covariance(
    source: PointCloud, target: PointCloud, transformation: ArrayLike, max_correspondence_distance: float | None = None
) -> PoseCovariance:
    """Estimate the covariance of the error of a registered pose.

    Args:
        source: The moved cloud.
        target: The fixed cloud, on the same device.
        transformation: T_target_source, 4x4, near the pose at which the surfaces match.
        max_correspondence_distance: Match distance [m] of the registration, 1.5 voxels. None: of `choose_voxel_size`.

    Returns:
        The covariance. Motions that the surfaces do not determine have standard deviations of the size of the overlap.
        Infinite if the surfaces hardly match.

    Raises:
        ValueError: A distance that is not positive or too small, or a pose that is not rigid.
        TypeError: Not a PointCloud.
        DeviceError: Clouds on different devices.

    Notes:
        Sum of three parts. Noise and density: the scatter of the gradients of a robust point-to-plane step, by blocks
        of space. Model error: a part of the residuals that is common to all points. Error of the estimate: the mean
        squared distance of the pose from that of the step. Priors are not used, and errors that both clouds share, of a
        lens for example, are not included. The coverage is in docs/trust.md. Memory O(n). Bitwise reproducible. Liang
        and Zeger, "Longitudinal data analysis using generalized linear models", 1986 (covariance by blocks). Censi,
        "An accurate closed-form estimate of ICP's covariance", 2007.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-2, 2, (2, 20000))
        >>> surface = np.column_stack([x, y, 0.3 * np.sin(3 * x) * np.cos(2 * y) + 0.1 * np.sin(5 * y + x)])
        >>> source, target = loom.PointCloud(surface[:12000]), loom.PointCloud(surface[8000:])
        >>> found = loom.registration.pose_covariance(source, target, np.eye(4), 0.15)
        >>> found.sigmas.shape, bool(found.sigmas.max() < 0.01)
        ((6,), True)
    """
    check_clouds(source, target)
    T = np.array(check_rigid("transformation", transformation))
    T[:3, :3] = nearest_rotation(T[:3, :3])
    distance = match_distance(source, target, max_correspondence_distance)
    step = measure_step(source, target, T, distance)
    if step is None or not step.is_solved:
        return PoseCovariance(np.full((6, 6), math.inf), target.origin.copy())
    apart = float(matmul(step.motion, solve(step.unit, step.motion))) / 6
    model = step.noise * (MODEL_ERROR + NORMAL_ERROR * step.noise * VOXELS / distance)
    matrix = step.scatter + (model**2 + STEP_FACTOR * apart) * step.unit
    matrix = matrix + _open_motions(source, target, distance, step)
    to_radians = np.repeat([1 / step.rows.lever, 1.0], 3)
    matrix = matrix * np.outer(to_radians, to_radians)
    return PoseCovariance((matrix + matrix.T) / 2, step.rows.middle + target.origin)


class Step(NamedTuple):
    """A robust point-to-plane step of the surfaces at a pose: rotations times the lever of the rows, translations."""

    rows: AlignmentRows
    source: Surface
    target: Surface
    pose: Matrix
    motion: NDArray[np.float64]
    scatter: Matrix  # covariance of the motion by the scatter of the gradients
    unit: Matrix  # covariance of the motion by an error [1 m] that is common to all points
    shares: NDArray[np.float64]  # constraint along the eigenvectors of the rows, 0..1
    noise: float

    @property
    def is_solved(self) -> bool:
        return len(self.rows) >= ENOUGH


def match_distance(source: PointCloud, target: PointCloud, given: float | None) -> float:
    """The given match distance [m], or that of `choose_voxel_size`."""
    if given is None:
        return VOXELS * choose_voxel_size(source, target)
    return check_positive("max_correspondence_distance", given)


def measure_step(source: PointCloud, target: PointCloud, T: Matrix, distance: float) -> Step | None:
    """The step at a pose in the clouds' worlds. None without a surface."""
    voxel = distance / VOXELS
    left, right = surface_for(source, FINER * FINE * voxel, distance), surface_for(target, FINE * voxel, distance)
    pose = to_local(T, source.origin, target.origin)
    if not (len(left) and len(right)):
        return None
    rows = AlignmentRows(PairedSurfaces(left, right, pose, invert_pose(pose), REACH * voxel, COSINE))
    if len(rows) < ENOUGH:
        return Step(rows, left, right, pose, np.zeros(6), np.eye(6), np.eye(6), np.zeros(6), math.nan)
    return Step(rows, left, right, pose, *_solve(rows, BLOCK * voxel))


def _solve(
    rows: AlignmentRows, block_size: float
) -> tuple[NDArray[np.float64], Matrix, Matrix, NDArray[np.float64], float]:
    motion = np.zeros(6)
    for _ in range(ROUNDS):
        _, matrix, right, _ = _normal_equations(rows, motion)
        motion = -solve(matrix, right)
    weight, matrix, _, width = _normal_equations(rows, motion)
    scores = rows.block_scores(motion, width, block_size)
    inverse = inv(matrix)
    scatter = matmul(inverse, matmul(scores.T, scores), inverse) * (len(scores) / max(len(scores) - 6, 1))
    unit = weight * (inverse + inverse.T) / 2
    return motion, (scatter + scatter.T) / 2, unit, eigvalsh(matrix / weight), width / WIDTH


def _normal_equations(
    rows: AlignmentRows, motion: NDArray[np.float64]
) -> tuple[float, Matrix, NDArray[np.float64], float]:
    """Sum of the weights at a motion, normal matrix with a ridge, right side, and width of the weights [m]."""
    width = WIDTH * TO_SIGMA * max(rows.median_residual(motion), 1e-9)
    weight, triangle, right = rows.system(motion, width)
    (matrix,) = symmetric_matrices(triangle[None])
    return weight, matrix + RIDGE * weight * np.eye(6), right, width


def _open_motions(source: PointCloud, target: PointCloud, distance: float, step: Step) -> Matrix:
    """Covariance of the undetermined motions: as large as the overlap, where the surfaces still match."""
    total = np.zeros((6, 6))
    if step.shares[0] >= SUSPECT_SHARE:
        return total
    size = distance / VOXELS
    surfaces = surface_for(source, FINER * size, distance), surface_for(target, size, distance)
    judged = judge_motions(*surfaces, step.pose, distance)
    if judged is None:
        return total
    lever = step.rows.lever
    for motion, kind in zip(judged.motions, judged.kinds, strict=True):
        if kind == "none":
            rotation = motion[:3] / judged.lever
            shift = motion[3:] + matmul(skew(rotation), step.rows.middle - judged.middle)
            ray = np.concatenate([rotation * lever, shift])
            total += np.outer(ray, ray) * lever**2
    return total
