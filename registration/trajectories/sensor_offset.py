"""Detection of two trajectories that belong to two sensors on one body, such as a LiDAR and a camera of a car.

Relative motions of two rigidly joined sensors are conjugates: A X = X B with a fixed pose X, the hand-eye equation.

Source: Shiu and Ahmad 1989, "Calibration of wrist-mounted robotic sensors by solving homogeneous transform equations of
the form AX = XB".
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import eigh, matmul, norm, solve
from ..rigid import make_pose, nearest_rotation, rotation_vector

Matrix = NDArray[np.float64]

MIN_MOTIONS = 10  # fewer determine the six numbers of an offset by chance
MAX_MOTIONS = 200
ITERATIONS = 10
LEAST_ERROR = 0.01  # of the length of a motion: below it the motions agree as they are
MOST_LEFT = 0.25  # of the error, where the offset explains it
DETERMINED = 0.05  # of the largest singular value: along other directions no rotation determines the lever arm
MAX_ARM = 50.0  # [m] no body has sensors farther apart
MIN_ROTATION = 0.05  # [rad] a smaller rotation has less weight than the translations


class SensorOffset(NamedTuple):
    """An offset between two sensors that explains most of the relative errors.

    Attributes:
        T_estimate_truth: Pose of the truth's sensor in that of the estimate.
        before, after: Median of the relative translation errors without and with it [m].
    """

    T_estimate_truth: Matrix
    before: float
    after: float


def find_sensor_offset(P: Matrix, Q: Matrix) -> SensorOffset | None:
    """The fixed offset of the sensor that makes the motions of two paths agree.

    Args:
        P: Estimated poses, float64 [n, 4, 4].
        Q: True poses of the same times.

    Returns:
        None if there are too few motions, if they agree without an offset, or if none explains the difference.
    """
    step = max(1, len(P) // MAX_MOTIONS)
    A, B = motions(P, step), motions(Q, step)
    if len(A) < MIN_MOTIONS:
        return None
    length = float(np.median(np.linalg.norm(B[:, :3, 3], axis=1)))
    before = _translation_error(A, B, np.eye(4))
    if not before > LEAST_ERROR * length:
        return None
    X = _solve(A, B)
    after = _translation_error(A, B, X)
    explains = after < MOST_LEFT * before and norm(X[:3, 3]) < MAX_ARM
    return SensorOffset(X, before, after) if explains else None


def motions(poses: Matrix, step: int) -> Matrix:
    """The motion from each pose to the one `step` later, in the frame of the first."""
    return matmul(inverse_poses(poses[:-step]), poses[step:])


def inverse_poses(T: Matrix) -> Matrix:
    """The inverses of poses [n, 4, 4]."""
    inverse = np.tile(np.eye(4), (len(T), 1, 1))
    inverse[:, :3, :3] = T[:, :3, :3].transpose(0, 2, 1)
    inverse[:, :3, 3] = -np.einsum("nij,nj->ni", inverse[:, :3, :3], T[:, :3, 3])
    return inverse


def _translation_error(A: Matrix, B: Matrix, X: Matrix) -> float:
    """Median length of the translations of B^-1 X^-1 A X: an offset acts on all motions, a jump on one."""
    moved = matmul(matmul(inverse_poses(X[None])[0], A), X)
    return float(np.median(np.linalg.norm(matmul(inverse_poses(B), moved)[:, :3, 3], axis=1)))


def _solve(A: Matrix, B: Matrix) -> Matrix:
    """X of A X = X B in least squares: rotation and lever arm in turns."""
    a, b = (np.array([rotation_vector(T[:3, :3]) for T in motions]) for motions in (A, B))
    angle = max(float(norm(a)) / np.sqrt(len(a)), MIN_ROTATION)
    weight = (float(norm(A[:, :3, 3])) / np.sqrt(len(A)) / angle) ** 2  # [m^2] of a rotation vector
    turns = matmul(a.T, b) * weight
    turned = A[:, :3, :3] - np.eye(3)
    normal = np.einsum("nki,nkj->ij", turned, turned)
    values, vectors = eigh(normal)
    known = vectors[:, values > max(DETERMINED**2 * values[-1], 1e-12)]
    arm, R = np.zeros(3), np.eye(3)
    for _ in range(ITERATIONS):
        shifted = A[:, :3, 3] + matmul(turned, arm)
        R = nearest_rotation(turns + matmul(shifted.T, B[:, :3, 3]))
        wanted = matmul(B[:, :3, 3], R.T) - A[:, :3, 3]
        gradient = matmul(known.T, np.einsum("nki,nk->i", turned, wanted))
        inner = matmul(matmul(known.T, normal), known)
        arm = matmul(known, solve(inner, gradient)) if known.shape[1] else arm
    return make_pose(R, arm)
