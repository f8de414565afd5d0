"""Rotations as unit quaternions (x, y, z, w), and back; the rotations nearest to matrices that are none."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray


def quaternions_to_rotations(quaternions: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rotations, shape [n, 3, 3], of unit quaternions (x, y, z, w), shape [n, 4]."""
    x, y, z, w = quaternions.T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)


def rotations_to_quaternions(R: NDArray[np.float64]) -> NDArray[np.float64]:
    """Unit quaternions (x, y, z, w), w >= 0, shape [n, 4], of rotations, shape [n, 3, 3].

    Of the four rows of 4 q q^T, which are linear in R, the longest is taken (Shepperd 1978): exact at any angle.
    Matrices of few digits, as files hold them, go through `nearest_rotations` first.
    """
    products = np.empty((len(R), 4, 4))
    across, twist = R + R.transpose(0, 2, 1), R - R.transpose(0, 2, 1)
    products[:, :3, :3] = across
    trace = np.trace(R, axis1=1, axis2=2)
    for axis in range(3):
        products[:, axis, axis] = 1 - trace + 2 * R[:, axis, axis]
    products[:, 3, :3] = products[:, :3, 3] = np.stack([twist[:, 2, 1], twist[:, 0, 2], twist[:, 1, 0]], axis=1)
    products[:, 3, 3] = 1 + trace
    every = np.arange(len(R))
    rows = products[every, np.argmax(products[:, range(4), range(4)], axis=1)]
    rows /= np.sqrt((rows * rows).sum(axis=1))[:, None]
    return np.where(rows[:, 3:] < 0, -rows, rows)


def nearest_rotations(M: NDArray[np.float64]) -> NDArray[np.float64]:
    """The rotations nearest to matrices, shape [n, 3, 3], in the Frobenius norm."""
    U, _, Vt = np.linalg.svd(M)
    signs = np.ones((len(M), 1, 3))
    signs[:, 0, 2] = np.sign(np.linalg.det(U @ Vt))
    return (U * signs) @ Vt
