"""Poses that keep clouds level: what of a search in six degrees of freedom is left of two clouds whose up is known."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul
from ..icp.constraint import MOTIONS, check_free
from ..rigid import about_up, make_pose

LEVEL = ("x", "y", "z", "yaw")
MOST_TILT = np.radians(15.0)  # of a pose that features found: normals of thinned clouds turn it by a few degrees


def check_level(free: Any) -> tuple[str, ...] | None:
    """What a search may leave free: None for all six motions, or LEVEL.

    Raises:
        TypeError, ValueError: No motions, or others.
    """
    if free is None:
        return None
    names = check_free(free)
    if len(names) == len(MOTIONS):
        return None
    if set(names) != set(LEVEL):
        raise ValueError(
            f"free: a search is of all six motions or of {', '.join(LEVEL)}, got {', '.join(names)}; "
            "registration_icp(init=, free=) takes any"
        )
    return LEVEL


def level_poses(
    poses: NDArray[np.float64], middle: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
    """The level poses nearest to some poses, [k, 4, 4], and which they are: those that tilt by more are left out.

    Args:
        poses: [n, 4, 4].
        middle: A place of the source whose image stays, [3].
    """
    R = poses[:, :3, :3]
    kept = np.flatnonzero(np.arccos(np.clip(R[:, 2, 2], -1, 1)) <= MOST_TILT)
    level = []
    for T in poses[kept]:
        yaw = math.atan2(T[1, 0] - T[0, 1], T[0, 0] + T[1, 1])  # that of the largest trace of R^T Rz
        turn = about_up(yaw)
        level.append(make_pose(turn, matmul(T[:3, :3], middle) + T[:3, 3] - matmul(turn, middle)))
    return np.array(level).reshape(-1, 4, 4), kept
