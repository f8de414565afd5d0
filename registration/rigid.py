"""Rigid motions in float64 on the host: exponential and logarithm, angles, frames about origins, the best fit of pairs.

Twists are (rotation [rad], translation [m]), rotation first. Poses T_a_b take coordinates of b to a.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]
SMALL_ANGLE = 1e-6  # [rad] below it series to second order are exact in float64


def rotation_of(vector: NDArray[np.float64]) -> Matrix:
    """The rotation about an axis by the vector's length [rad] (Rodrigues)."""
    angle = float(np.linalg.norm(vector))
    K = skew(vector)
    if angle < SMALL_ANGLE:
        return np.eye(3) + K + K @ K / 2
    return np.eye(3) + np.sin(angle) / angle * K + (1 - np.cos(angle)) / angle**2 * (K @ K)


def rotation_vector(R: Matrix) -> NDArray[np.float64]:
    """The logarithm of a rotation, length 0..pi [rad]; exact near 0 and near pi, where an arc cosine is not."""
    axis = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2  # sine times axis
    sine, cosine = float(np.linalg.norm(axis)), (float(np.trace(R)) - 1) / 2
    angle = float(np.arctan2(sine, cosine))
    if sine > SMALL_ANGLE:
        return axis * (angle / sine)
    if cosine > 0:
        return axis
    outer = (R + R.T) / 2 + np.eye(3)  # twice the axis' outer product, near half a turn
    column = outer[:, int(np.argmax(np.diag(outer)))]
    column = column / np.linalg.norm(column)
    return column * (angle if column @ axis >= 0 else -angle)


def skew(v: NDArray[np.float64]) -> Matrix:
    """The matrix of the cross product v x."""
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def pose_of(twist: NDArray[np.float64]) -> Matrix:
    """The exponential of a twist (rotation, translation), shape [6]: a pose [4, 4]."""
    rotation, K = twist[:3], skew(twist[:3])
    angle = float(np.linalg.norm(rotation))
    if angle < SMALL_ANGLE:
        V = np.eye(3) + K / 2 + K @ K / 6
    else:
        V = np.eye(3) + (1 - np.cos(angle)) / angle**2 * K + (angle - np.sin(angle)) / angle**3 * (K @ K)
    return make_pose(rotation_of(rotation), V @ twist[3:])


def make_pose(R: Matrix, t: NDArray[np.float64]) -> Matrix:
    """The pose with a rotation and a translation."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, t
    return T


def invert_pose(T: Matrix) -> Matrix:
    """The inverse of a pose."""
    return make_pose(T[:3, :3].T, -T[:3, :3].T @ T[:3, 3])


def nearest_rotation(M: Matrix) -> Matrix:
    """The rotation nearest to a matrix in the Frobenius norm."""
    U, _, Vt = np.linalg.svd(M)
    return (U * [1, 1, np.sign(np.linalg.det(U @ Vt))]) @ Vt


def pose_error(T: Matrix, T_true: Matrix) -> tuple[float, float]:
    """How far a pose lies from the true one: (angle [rad] by the logarithm, distance of the translations [m])."""
    angle = float(np.linalg.norm(rotation_vector(T[:3, :3] @ T_true[:3, :3].T)))
    return angle, float(np.linalg.norm(T[:3, 3] - T_true[:3, 3]))


def to_local(T: Matrix, source_origin: NDArray[np.float64], target_origin: NDArray[np.float64]) -> Matrix:
    """A pose between world coordinates as one between coordinates about the clouds' origins."""
    local = T.copy()
    local[:3, 3] = T[:3, :3] @ source_origin + T[:3, 3] - target_origin
    return local


def to_world(T: Matrix, source_origin: NDArray[np.float64], target_origin: NDArray[np.float64]) -> Matrix:
    """The inverse of `to_local`."""
    world = T.copy()
    world[:3, 3] = T[:3, 3] + target_origin - T[:3, :3] @ source_origin
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
    source_mean, target_mean = w @ source, w @ target
    s, t = source - source_mean, target - target_mean
    U, D, Vt = np.linalg.svd((t * w[:, None]).T @ s)
    signs = np.array([1.0, 1.0, np.sign(np.linalg.det(U) * np.linalg.det(Vt))])
    R = (U * signs) @ Vt
    scale = float((D * signs).sum() / (w @ (s * s).sum(axis=1))) if with_scaling else 1.0
    return make_pose(scale * R, target_mean - scale * R @ source_mean)
