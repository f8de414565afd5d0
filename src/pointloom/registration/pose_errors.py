"""Covariance of the error of a registered pose, from the surfaces of the two clouds."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_shape
from ..kernels.array_types import LongIntegers
from ..kernels.linear_algebra import eigh, eigvalsh, inv, matmul, solve
from ..kernels.poses.alignment_rows import AlignmentRows, PairedSurfaces
from ..kernels.surface.hollow_side import Surface
from . import assessment_constants as constants
from .rigid import invert_pose, make_pose, skew, symmetric_matrices
from .surfaces import SurfacePair
from .unobservable_motions import Localizability

Matrix = NDArray[np.float64]
# T_blocks_frame. Along the axes of the frame, a face of blocks would divide the points of a floor or wall by the sign
# of their noise, as if both parts had an error in common.
BLOCK_AXES = make_pose(np.array([[2.0, -1.0, 2.0], [2.0, 2.0, -1.0], [-1.0, 2.0, 2.0]]) / 3, np.zeros(3))


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


class Step(NamedTuple):
    """A robust point-to-plane step of the surfaces at a pose: rotations times the lever of the rows, translations.

    Vectors and matrices are of the `free` ones of the six motions.
    """

    rows: AlignmentRows
    source: Surface
    target: Surface
    pose: Matrix
    distance: float  # [m] match distance of the registration
    voxel: float  # [m] of the surfaces
    free: list[int]
    motion: NDArray[np.float64]
    influences: Matrix  # error of the motion by each block of space, [blocks, free]
    blocks: LongIntegers | None  # keys of the blocks
    unit: Matrix  # covariance of the motion by an error [1 m] that is common to all points
    fractions: NDArray[np.float64]  # constraint along the eigenvectors of the rows, 0..1
    noise: float
    bias: float  # [m] standard deviation of errors common to a block, beyond the noise of its points

    @property
    def is_solved(self) -> bool:
        return len(self.rows) >= constants.MIN_MATCHES

    @property
    def scatter(self) -> Matrix:
        """Covariance of the motion by the scatter of the gradients of the blocks."""
        covariance = matmul(self.influences.T, self.influences)
        return (covariance + covariance.T) / 2


def step_of(surfaces: SurfacePair, pose: Matrix) -> Step | None:
    """The step of the fine surfaces at a pose T_target_source about the clouds' origins. None without a surface."""
    return step_between(*surfaces.fine, pose, surfaces.distance, constants.FINE_VOXEL_FACTOR * surfaces.voxel_size)


def covariance_of(
    step: Step | None, origin: NDArray[np.float64], motions: Callable[[], Localizability | None]
) -> PoseCovariance:
    """The covariance of the error of a pose. `origin` [m]: of the target. `motions`: as of `common_covariance`."""
    if step is None or not step.is_solved:
        return PoseCovariance(np.full((6, 6), math.inf), origin.copy())
    to_radians = np.repeat([1 / step.rows.lever, 1.0], 3)
    matrix = (step.scatter + common_covariance(step, motions)) * np.outer(to_radians, to_radians)
    return PoseCovariance((matrix + matrix.T) / 2, step.rows.middle + origin)


def step_between(
    source: Surface,
    target: Surface,
    pose: Matrix,
    distance: float,
    size: float,
    free: Sequence[int] = range(6),
    frame: Matrix | None = None,
) -> Step | None:
    """The step of surfaces in voxels of a size [m] at a pose T_target_source about their origins. None if one is empty.

    `frame`: T_frame_target, in which space is divided into blocks.
    """
    if not (len(source) and len(target)):
        return None
    voxel, axes = distance / constants.MATCH_VOXELS, list(free)
    reach = constants.PAIR_RADIUS * voxel
    rows = AlignmentRows(PairedSurfaces(source, target, pose, invert_pose(pose), reach, constants.MIN_NORMAL_COSINE))
    parts = rows, source, target, pose, distance, size, axes
    if len(rows) < constants.MIN_MATCHES:
        d = len(axes)
        return Step(*parts, np.zeros(d), np.zeros((0, d)), None, np.eye(d), np.zeros(d), math.nan, math.nan)
    return Step(*parts, *_solve(rows, axes, constants.BLOCK_VOXELS * voxel, np.eye(4) if frame is None else frame))


def common_covariance(step: Step, motions: Callable[[], Localizability | None]) -> Matrix:
    """Covariance of the motion by errors common to all points: of the model, the sensor, the estimate, undetermined
    motions.

    `motions` returns the result of `judge_motions` at the pose of the step. It is called if one may be undetermined.
    """
    apart = float(matmul(step.motion, solve(step.unit, step.motion))) / len(step.free)
    model = step.noise * (
        constants.MODEL_ERROR + constants.NORMAL_ERROR * step.noise * constants.FINE_VOXEL_FACTOR / step.voxel
    )
    sensor = constants.SENSOR_FACTOR * step.bias
    covariance = (model**2 + sensor**2 + constants.STEP_FACTOR * apart) * step.unit
    if step.fractions[0] < constants.SUSPECT_FRACTION and (found := motions()) is not None:
        covariance = covariance + _open_motions(step, found)
    return covariance


def motions_of_source(step: Step, origin: NDArray[np.float64]) -> Matrix:
    """Matrix from motions of a step, in the target's axes, to motions of the source in its own frame.

    `origin` [m]: the source's origin in this frame.
    """
    R, lever = step.pose[:3, :3], step.rows.lever
    center = step.pose[:3, 3] - matmul(R, origin)  # the source's zero
    A = np.zeros((6, 6))
    A[:3, :3], A[3:, 3:] = R.T / lever, R.T
    A[3:, :3] = -matmul(R.T, skew(center - step.rows.middle)) / lever
    return A[np.ix_(step.free, step.free)]


def root_of_covariance(covariance: Matrix) -> Matrix:
    """W with W^T W = covariance."""
    values, vectors = eigh((covariance + covariance.T) / 2)
    return np.sqrt(np.maximum(values, 0.0))[:, None] * vectors.T


def _solve(
    rows: AlignmentRows, free: list[int], block_size: float, frame: Matrix
) -> tuple[NDArray[np.float64], Matrix, LongIntegers, Matrix, NDArray[np.float64], float, float]:
    motion = np.zeros(6)
    for _ in range(constants.REWEIGHTING_ITERATIONS):
        _, matrix, right, _ = _normal_equations(rows, motion, free)
        motion[free] = -solve(matrix, right)
    weight, matrix, _, width = _normal_equations(rows, motion, free)
    blocks, scores = rows.block_scores(motion, width, block_size, matmul(BLOCK_AXES, frame))
    inverse, count = inv(matrix), len(scores)
    influences = -matmul(scores[:, free], inverse.T) * math.sqrt(count / max(count - len(free), 1))
    unit, noise = weight * (inverse + inverse.T) / 2, width / constants.WEIGHT_WIDTH
    # Variance of the motion in that of an error common to all points, by all errors, and by the noise alone
    variance = float((matmul(influences, matrix) * influences).sum()) / weight / len(free)
    by_noise = constants.SHARED_POINTS * noise**2 / weight
    bias = math.sqrt(max(variance - by_noise, 0.0) * count)
    return motion[free], influences, blocks, unit, eigvalsh(matrix / weight), noise, bias


def _normal_equations(
    rows: AlignmentRows, motion: NDArray[np.float64], free: list[int]
) -> tuple[float, Matrix, NDArray[np.float64], float]:
    """Sum of the weights at a motion, normal matrix with a ridge, right side, and width of the weights [m]."""
    width = constants.WEIGHT_WIDTH * constants.TO_SIGMA * max(rows.median_residual(motion), 1e-9)
    weight, triangle, right = rows.system(motion, width)
    (matrix,) = symmetric_matrices(triangle[None])
    return weight, (matrix + constants.MOTION_RIDGE * weight * np.eye(6))[np.ix_(free, free)], right[free], width


def _open_motions(step: Step, motions: Localizability) -> Matrix:
    """Covariance of the undetermined motions: as large as the overlap, where the surfaces still match."""
    total, lever = np.zeros((6, 6)), step.rows.lever
    for motion in motions.open_motions:
        rotation = motion[:3] / motions.lever
        shift = motion[3:] + matmul(skew(rotation), step.rows.middle - motions.middle)
        ray = np.concatenate([rotation * lever, shift])
        total += np.outer(ray, ray) * lever**2
    return total[np.ix_(step.free, step.free)]
