"""Rotations as quaternions."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def quaternions_of(R: Array) -> Array:
    """Quaternions (x, y, z, w), w >= 0, [n, 4], of rotations [n, 3, 3].

    Of the four rows of 4 q q^T, which are linear in R, the longest is taken (Shepperd 1978): exact at any angle.
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
