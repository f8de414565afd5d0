"""Rigid motions in float64 on the host. Twists are (rotation [rad], translation [m]), T_a_b maps from b to a."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_rigid, check_transformation
from ..core.quaternions import nearest_rotations
from ..kernels.linear_algebra import cube_root, det, inv, matmul, norm

Matrix = NDArray[np.float64]
MAX_FLOAT64_DEVIATION = 1e-12  # deviation of R R^T above which it is rounded to fewer digits than float64
# Entries of a symmetric 6x6 matrix in the row-major upper triangle.
TRIANGLE_INDICES = np.zeros((6, 6), np.int64)
TRIANGLE_INDICES[np.triu_indices(6)] = np.arange(21)
TRIANGLE_INDICES = np.maximum(TRIANGLE_INDICES, TRIANGLE_INDICES.T)
IDENTITY_POSE = np.eye(4)
SMALL_ANGLE = 1e-6  # [rad] below it second-order series are exact in float64


def rotations_of(vectors: NDArray[np.float64]) -> Matrix:
    """Rotations [n, 3, 3] of rotation vectors [n, 3] [rad] (Rodrigues)."""
    angles = np.sqrt((vectors * vectors).sum(axis=1))
    K = skews(vectors)
    first = np.sinc(angles / np.pi)  # sin(a) / a
    second = np.sinc(angles / (2 * np.pi)) ** 2 / 2  # (1 - cos(a)) / a^2
    return np.eye(3) + first[:, None, None] * K + second[:, None, None] * matmul(K, K)


def scale_of(T: Matrix) -> float:
    """Scale of a similarity, negative for a reflection."""
    return cube_root(float(det(T[:3, :3])))


def check_similarity(name: str, matrix: object) -> tuple[Matrix, float]:
    """A copy of a rigid motion with a scale, and the scale. Raises `ValueError` for a shear or a reflection."""
    T = np.array(check_transformation(name, matrix))
    if (scale := scale_of(T)) <= 0:
        raise ValueError(f"{name}: expected a rotation with a scale, got a determinant of {scale**3:.3g}")
    check_rigid(name, np.block([[T[:3, :3] / scale, T[:3, 3:]], [T[3:]]]))
    return T, scale


def rotation_of(vector: NDArray[np.float64]) -> Matrix:
    return rotations_of(vector[None])[0]


def about_up(yaw: float) -> Matrix:
    """Rotation about z [rad]; z is bitwise unchanged."""
    return np.array([[np.cos(yaw), -np.sin(yaw), 0.0], [np.sin(yaw), np.cos(yaw), 0.0], [0.0, 0.0, 1.0]])


def rotation_vector(R: Matrix) -> NDArray[np.float64]:
    """Logarithm of a rotation, length 0..pi [rad]; accurate near 0 and pi, unlike the arc cosine."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = R.tolist()  # a third of the time of NumPy's scalars
    axis = (zy - yz) / 2, (xz - zx) / 2, (yx - xy) / 2  # times the sine
    sine, cosine = math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]), (xx + yy + zz - 1) / 2
    angle = math.atan2(sine, cosine)
    if sine > SMALL_ANGLE or cosine > 0:
        factor = angle / sine if sine > SMALL_ANGLE else 1.0
        return np.array([factor * axis[0], factor * axis[1], factor * axis[2]])
    outer = (R + R.T) / 2 + np.eye(3)  # twice the outer product of the axis, near half a turn
    column = outer[:, int(np.argmax(np.diag(outer)))]
    column = column / norm(column)
    return column * (angle if matmul(column, axis) >= 0 else -angle)


def skews(vectors: NDArray[np.float64]) -> Matrix:
    K = np.zeros((len(vectors), 3, 3))
    K[:, 2, 1], K[:, 0, 2], K[:, 1, 0] = vectors.T
    return K - K.transpose(0, 2, 1)


def skew(v: NDArray[np.float64]) -> Matrix:
    """Matrix of the cross product v x."""
    return skews(v[None])[0]


def pose_of(twist: NDArray[np.float64]) -> Matrix:
    """Exponential of a twist (rotation, translation), [6]: a pose [4, 4]."""
    rotation, K = twist[:3], skew(twist[:3])
    angle = float(norm(rotation))
    if angle < SMALL_ANGLE:
        V = np.eye(3) + K / 2 + matmul(K, K) / 6
    else:
        V = np.eye(3) + (1 - np.cos(angle)) / angle**2 * K + (angle - np.sin(angle)) / angle**3 * matmul(K, K)
    return make_pose(rotation_of(rotation), matmul(V, twist[3:]))


def make_pose(R: Matrix, t: NDArray[np.float64]) -> Matrix:
    T = IDENTITY_POSE.copy()
    T[:3, :3], T[:3, 3] = R, t
    return T


def invert_pose(T: Matrix) -> Matrix:
    """Inverse of a pose. The transpose of a rounded rotation would be meters off far from zero."""
    R = T[:3, :3]
    back = inv(R) if _is_rounded(R) else R.T
    return make_pose(back, matmul(-back, T[:3, 3]))


def _is_rounded(R: Matrix) -> bool:
    """True if R^T R deviates from the identity by more than the rounding of float64."""
    columns = R.T.tolist()
    for i, (x, y, z) in enumerate(columns):
        for j in range(i, 3):
            a, b, c = columns[j]
            if abs(x * a + y * b + z * c - (1.0 if i == j else 0.0)) > MAX_FLOAT64_DEVIATION:
                return True
    return False


def adjoint_of(T: Matrix) -> Matrix:
    """Adjoint of a pose, [6, 6], for twists."""
    R, adjoint = T[:3, :3], np.zeros((6, 6))
    adjoint[:3, :3], adjoint[3:, :3], adjoint[3:, 3:] = R, matmul(skew(T[:3, 3]), R), R
    return adjoint


def symmetric_matrices(triangles: NDArray[np.float64]) -> Matrix:
    """Symmetric 6x6 matrices [n, 6, 6] of row-major upper triangles [n, 21]."""
    return triangles[:, TRIANGLE_INDICES] + 0.0  # no negative zeros


def nearest_rotation(M: Matrix) -> Matrix:
    return nearest_rotations(M[None])[0]


def pose_error(T: Matrix, T_true: Matrix) -> tuple[float, float]:
    angle = float(norm(rotation_vector(matmul(T[:3, :3], T_true[:3, :3].T))))
    return angle, float(norm(T[:3, 3] - T_true[:3, 3]))


def to_local(T: Matrix, source_origin: NDArray[np.float64], target_origin: NDArray[np.float64]) -> Matrix:
    """Convert poses [..., 4, 4] from world coordinates to coordinates about the clouds' origins [..., 3]."""
    local = T.copy()
    local[..., :3, 3] = matmul(T[..., :3, :3], source_origin[..., None])[..., 0] + T[..., :3, 3] - target_origin
    return local


def to_world(T: Matrix, source_origin: NDArray[np.float64], target_origin: NDArray[np.float64]) -> Matrix:
    """Inverse of `to_local`."""
    world = T.copy()
    world[..., :3, 3] = T[..., :3, 3] + target_origin - matmul(T[..., :3, :3], source_origin[..., None])[..., 0]
    return world


def fit_pose(
    source: NDArray[np.float64],
    target: NDArray[np.float64],
    *,
    weights: NDArray[np.float64] | None = None,
    with_scaling: bool = False,
) -> Matrix:
    """Weighted least-squares similarity or rigid motion between points [n, 3] (Umeyama 1991, eqs. 40 to 43)."""
    w = np.full(len(source), 1 / len(source)) if weights is None else weights / weights.sum()
    source_mean, target_mean = matmul(w, source), matmul(w, target)
    s, t = source - source_mean, target - target_mean
    A = fit_moments(matmul((t * w[:, None]).T, s), float(matmul(w, (s * s).sum(axis=1))), with_scaling=with_scaling)
    return make_pose(A, target_mean - matmul(A, source_mean))


def fit_moments(cross: Matrix, spread: float, *, with_scaling: bool = False) -> Matrix:
    """Optimal (scaled) rotation from the sums of t s^T (`cross`) and |s|^2 (`spread`) of centered points."""
    R = nearest_rotation(cross)
    return float((R * cross).sum() / spread) * R if with_scaling else R
