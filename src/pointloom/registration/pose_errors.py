"""Covariance of the error of a registered pose, from the surfaces of the two clouds."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_positive, check_rigid, check_shape
from ..kernels.array_types import LongIntegers
from ..kernels.linear_algebra import eigh, eigvalsh, inv, matmul, solve
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
# residuals in voxels of the registration, 1 / FINE of those of the surfaces, since these bias the normals. Chosen on 24
# rooms, 60 sites, 40 streets and 40 divided real scans, generated like those of benchmarks/trust/calibration.py from
# other seeds.
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
    matrix = step.scatter + common_covariance(step, lambda: judged_surfaces(source, target, distance))
    to_radians = np.repeat([1 / step.rows.lever, 1.0], 3)
    matrix = matrix * np.outer(to_radians, to_radians)
    return PoseCovariance((matrix + matrix.T) / 2, step.rows.middle + target.origin)


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
    shares: NDArray[np.float64]  # constraint along the eigenvectors of the rows, 0..1
    noise: float

    @property
    def is_solved(self) -> bool:
        return len(self.rows) >= ENOUGH

    @property
    def scatter(self) -> Matrix:
        """Covariance of the motion by the scatter of the gradients of the blocks."""
        covariance = matmul(self.influences.T, self.influences)
        return (covariance + covariance.T) / 2


def match_distance(source: PointCloud, target: PointCloud, given: float | None) -> float:
    """The given match distance [m], or that of `choose_voxel_size`."""
    if given is None:
        return VOXELS * choose_voxel_size(source, target)
    return check_positive("max_correspondence_distance", given)


def measure_step(source: PointCloud, target: PointCloud, T: Matrix, distance: float) -> Step | None:
    """The step at a pose in the clouds' worlds. None without a surface."""
    size = FINE * distance / VOXELS
    left, right = surface_for(source, FINER * size, distance), surface_for(target, size, distance)
    return step_between(left, right, to_local(T, source.origin, target.origin), distance, size)


def judged_surfaces(source: PointCloud, target: PointCloud, distance: float) -> tuple[Surface, Surface]:
    """The surfaces of two clouds that `judge_motions` compares."""
    size = distance / VOXELS
    return surface_for(source, FINER * size, distance), surface_for(target, size, distance)


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
    voxel, axes = distance / VOXELS, list(free)
    rows = AlignmentRows(PairedSurfaces(source, target, pose, invert_pose(pose), REACH * voxel, COSINE))
    parts = rows, source, target, pose, distance, size, axes
    if len(rows) < ENOUGH:
        d = len(axes)
        return Step(*parts, np.zeros(d), np.zeros((0, d)), None, np.eye(d), np.zeros(d), math.nan)
    return Step(*parts, *_solve(rows, axes, BLOCK * voxel, np.eye(4) if frame is None else frame))


def common_covariance(step: Step, coarse: Callable[[], tuple[Surface, Surface]]) -> Matrix:
    """Covariance of the motion by errors common to all points: of the model, of the estimate, undetermined motions.

    `coarse` returns the surfaces that are compared if a motion may be undetermined.
    """
    apart = float(matmul(step.motion, solve(step.unit, step.motion))) / len(step.free)
    model = step.noise * (MODEL_ERROR + NORMAL_ERROR * step.noise * FINE / step.voxel)
    covariance = (model**2 + STEP_FACTOR * apart) * step.unit
    if step.shares[0] < SUSPECT_SHARE:
        covariance = covariance + _open_motions(step, coarse())
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
) -> tuple[NDArray[np.float64], Matrix, LongIntegers, Matrix, NDArray[np.float64], float]:
    motion = np.zeros(6)
    for _ in range(ROUNDS):
        _, matrix, right, _ = _normal_equations(rows, motion, free)
        motion[free] = -solve(matrix, right)
    weight, matrix, _, width = _normal_equations(rows, motion, free)
    blocks, scores = rows.block_scores(motion, width, block_size, frame)
    inverse, count = inv(matrix), len(scores)
    influences = -matmul(scores[:, free], inverse.T) * math.sqrt(count / max(count - len(free), 1))
    unit = weight * (inverse + inverse.T) / 2
    return motion[free], influences, blocks, unit, eigvalsh(matrix / weight), width / WIDTH


def _normal_equations(
    rows: AlignmentRows, motion: NDArray[np.float64], free: list[int]
) -> tuple[float, Matrix, NDArray[np.float64], float]:
    """Sum of the weights at a motion, normal matrix with a ridge, right side, and width of the weights [m]."""
    width = WIDTH * TO_SIGMA * max(rows.median_residual(motion), 1e-9)
    weight, triangle, right = rows.system(motion, width)
    (matrix,) = symmetric_matrices(triangle[None])
    return weight, (matrix + RIDGE * weight * np.eye(6))[np.ix_(free, free)], right[free], width


def _open_motions(step: Step, surfaces: tuple[Surface, Surface]) -> Matrix:
    """Covariance of the undetermined motions: as large as the overlap, where the surfaces still match."""
    total = np.zeros((6, 6))
    judged = judge_motions(*surfaces, step.pose, step.distance, step.free)
    if judged is not None:
        lever = step.rows.lever
        for motion, kind in zip(judged.motions, judged.kinds, strict=True):
            if kind == "none":
                rotation = motion[:3] / judged.lever
                shift = motion[3:] + matmul(skew(rotation), step.rows.middle - judged.middle)
                ray = np.concatenate([rotation * lever, shift])
                total += np.outer(ray, ray) * lever**2
    return total[np.ix_(step.free, step.free)]
