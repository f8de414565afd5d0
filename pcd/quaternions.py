"""Rotations as unit quaternions (x, y, z, w), as files store them."""

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
    """Quaternions (x, y, z, w), w >= 0, shape [n, 4], of the rotations nearest to R, shape [n, 3, 3].

    The eigenvector of the largest eigenvalue of a symmetric 4x4 matrix (Bar-Itzhack 2000): no case distinctions, and
    well conditioned everywhere, since the other eigenvalues of a rotation are all 4/3 away.
    """
    K = np.empty((len(R), 4, 4))
    K[:, :3, :3] = R + R.transpose(0, 2, 1)
    trace = np.trace(R, axis1=1, axis2=2)
    K[:, range(3), range(3)] -= trace[:, None]
    K[:, 3, 0] = K[:, 0, 3] = R[:, 2, 1] - R[:, 1, 2]
    K[:, 3, 1] = K[:, 1, 3] = R[:, 0, 2] - R[:, 2, 0]
    K[:, 3, 2] = K[:, 2, 3] = R[:, 1, 0] - R[:, 0, 1]
    K[:, 3, 3] = trace
    quaternions = np.linalg.eigh(K / 3)[1][:, :, -1]
    return quaternions * np.where(quaternions[:, 3:] < 0, -1.0, 1.0)
