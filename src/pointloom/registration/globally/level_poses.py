"""Restriction of six-degree poses to level ones for clouds with known up."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul
from ..icp.constraint import MOTIONS, check_free
from ..rigid import about_up, make_pose

LEVEL = ("x", "y", "z", "yaw")
MAX_TILT = np.radians(15.0)  # tilt of poses from features: normals of downsampled clouds are off by a few degrees


def check_level(free: object) -> tuple[str, ...] | None:
    if free is None:
        return None
    names = check_free(free)
    if len(names) == len(MOTIONS):
        return None
    if set(names) != set(LEVEL):
        raise ValueError(
            f"free: expected all six motions or {', '.join(LEVEL)}, got {', '.join(names)}. "
            "registration_icp(init=, constraint=) accepts any"
        )
    return LEVEL


def level_poses(
    poses: NDArray[np.float64], middle: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
    """The nearest level poses [k, 4, 4] that keep the image of `middle`, and their indices, without tilted ones."""
    R = poses[:, :3, :3]
    selected = np.flatnonzero(np.arccos(np.clip(R[:, 2, 2], -1, 1)) <= MAX_TILT)
    level = []
    for T in poses[selected]:
        yaw = math.atan2(T[1, 0] - T[0, 1], T[0, 0] + T[1, 1])  # maximizes the trace of R^T Rz
        rotation = about_up(yaw)
        level.append(make_pose(rotation, matmul(T[:3, :3], middle) + T[:3, 3] - matmul(rotation, middle)))
    return np.array(level).reshape(-1, 4, 4), selected
