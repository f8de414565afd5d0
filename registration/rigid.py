"""Rigid motions in float64 on the host: exponential and logarithm, angles, frames about origins, the best fit of pairs.

Twists are (rotation [rad], translation [m]), rotation first. Poses T_a_b take coordinates of b to a.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ..core.quaternions import nearest_rotations
from ..kernels.linear_algebra import cube_root, det, inv, matmul, norm

Matrix = NDArray[np.float64]
ROUNDED = 1e-12  # of a product of a rotation and its transpose: beyond this it is rounded to fewer digits than float64
SMALL_ANGLE = 1e-6  # [rad] below it series to second order are exact in float64


def rotations_of(vectors: NDArray[np.float64]) -> Matrix:
    """The rotations about axes [n, 3] by their lengths [rad], [n, 3, 3] (Rodrigues)."""
    angles = np.sqrt((vectors * vectors).sum(axis=1))
    K = skews(vectors)
    first = np.sinc(angles / np.pi)  # sin(a) / a
    second = np.sinc(angles / (2 * np.pi)) ** 2 / 2  # (1 - cos(a)) / a^2
    return np.eye(3) + first[:, None, None] * K + second[:, None, None] * matmul(K, K)


def scale_of(T: Matrix) -> float:
    """The scale of a similarity; negative of one that mirrors."""
    return cube_root(float(det(T[:3, :3])))


def rotation_of(vector: NDArray[np.float64]) -> Matrix:
    """The rotation about an axis by the vector's length [rad]."""
    return rotations_of(vector[None])[0]


def about_up(yaw: float) -> Matrix:
    """The rotation about z by an angle [rad]; z itself stays to the bit."""
    return np.array([[np.cos(yaw), -np.sin(yaw), 0.0], [np.sin(yaw), np.cos(yaw), 0.0], [0.0, 0.0, 1.0]])


def rotation_vector(R: Matrix) -> NDArray[np.float64]:
    """The logarithm of a rotation, length 0..pi [rad]; exact near 0 and near pi, where an arc cosine is not."""
    axis = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2  # sine times axis
    sine, cosine = float(norm(axis)), (float(np.trace(R)) - 1) / 2
    angle = math.atan2(sine, cosine)
    if sine > SMALL_ANGLE:
        return axis * (angle / sine)
    if cosine > 0:
        return axis
    outer = (R + R.T) / 2 + np.eye(3)  # twice the axis' outer product, near half a turn
    column = outer[:, int(np.argmax(np.diag(outer)))]
    column = column / norm(column)
    return column * (angle if matmul(column, axis) >= 0 else -angle)


def skews(vectors: NDArray[np.float64]) -> Matrix:
    """The matrices of the cross products v x, [n, 3, 3]."""
    K = np.zeros((len(vectors), 3, 3))
    K[:, 2, 1], K[:, 0, 2], K[:, 1, 0] = vectors.T
    return K - K.transpose(0, 2, 1)


def skew(v: NDArray[np.float64]) -> Matrix:
    """The matrix of the cross product v x."""
    return skews(v[None])[0]


def pose_of(twist: NDArray[np.float64]) -> Matrix:
    """The exponential of a twist (rotation, translation), shape [6]: a pose [4, 4]."""
    rotation, K = twist[:3], skew(twist[:3])
    angle = float(norm(rotation))
    if angle < SMALL_ANGLE:
        V = np.eye(3) + K / 2 + matmul(K, K) / 6
    else:
        V = np.eye(3) + (1 - np.cos(angle)) / angle**2 * K + (angle - np.sin(angle)) / angle**3 * matmul(K, K)
    return make_pose(rotation_of(rotation), matmul(V, twist[3:]))


def make_pose(R: Matrix, t: NDArray[np.float64]) -> Matrix:
    """The pose with a rotation and a translation."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, t
    return T


def invert_pose(T: Matrix) -> Matrix:
    """The inverse of a pose, also of one with a rounded rotation, whose transpose is meters off far from zero."""
    R = T[:3, :3]
    rounded = np.abs(matmul(R.T, R) - np.eye(3)).max() > ROUNDED
    back = inv(R) if rounded else R.T
    return make_pose(back, matmul(-back, T[:3, 3]))


def adjoint_of(T: Matrix) -> Matrix:
    """Takes twists of the coordinates that a pose takes to twists of those it takes them to, [6, 6]."""
    R = T[:3, :3]
    return np.block([[R, np.zeros((3, 3))], [matmul(skew(T[:3, 3]), R), R]])


def symmetric_matrices(triangles: NDArray[np.float64]) -> Matrix:
    """The symmetric 6x6 matrices [n, 6, 6] of upper triangles [n, 21], row by row."""
    M = np.zeros((len(triangles), 6, 6))
    M[:, *np.triu_indices(6)] = triangles
    return M + np.triu(M, 1).transpose(0, 2, 1)


def nearest_rotation(M: Matrix) -> Matrix:
    """The rotation nearest to a matrix in the Frobenius norm."""
    return nearest_rotations(M[None])[0]


def pose_error(T: Matrix, T_true: Matrix) -> tuple[float, float]:
    """How far a pose lies from the true one: (angle [rad] by the logarithm, distance of the translations [m])."""
    angle = float(norm(rotation_vector(matmul(T[:3, :3], T_true[:3, :3].T))))
    return angle, float(norm(T[:3, 3] - T_true[:3, 3]))


def to_local(T: Matrix, source_origin: NDArray[np.float64], target_origin: NDArray[np.float64]) -> Matrix:
    """A pose between world coordinates as one between coordinates about the clouds' origins."""
    local = T.copy()
    local[:3, 3] = matmul(T[:3, :3], source_origin) + T[:3, 3] - target_origin
    return local


def to_world(T: Matrix, source_origin: NDArray[np.float64], target_origin: NDArray[np.float64]) -> Matrix:
    """The inverse of `to_local`."""
    world = T.copy()
    world[:3, 3] = T[:3, 3] + target_origin - matmul(T[:3, :3], source_origin)
    return world


def fit_pose(
    source: NDArray[np.float64],
    target: NDArray[np.float64],
    *,
    weights: NDArray[np.float64] | None = None,
    with_scaling: bool = False,
) -> Matrix:
    """The similarity (or rigid motion) that takes points [n, 3] nearest to others in weighted least squares.

    Umeyama 1991, eqs. 40 to 43.
    """
    w = np.full(len(source), 1 / len(source)) if weights is None else weights / weights.sum()
    source_mean, target_mean = matmul(w, source), matmul(w, target)
    s, t = source - source_mean, target - target_mean
    A = fit_moments(matmul((t * w[:, None]).T, s), float(matmul(w, (s * s).sum(axis=1))), with_scaling=with_scaling)
    return make_pose(A, target_mean - matmul(A, source_mean))


def fit_moments(cross: Matrix, spread: float, *, with_scaling: bool = False) -> Matrix:
    """The rotation, or the rotation times a scale, of least squares [3, 3].

    Args:
        cross: Weighted sum of t s^T, with s and t the points of both about their means.
        spread: Weighted sum of |s|^2.
        with_scaling: Whether there is a scale.
    """
    R = nearest_rotation(cross)
    return float((R * cross).sum() / spread) * R if with_scaling else R
