"""Leveling of poses by gravity."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_direction, check_rigid
from ...kernels.linear_algebra import matmul, norm
from ..rigid import nearest_rotation, rotation_of

MIN_SINE = 1e-9  # sine: nearly opposite directions have no shortest rotation


def leveled(
    init: ArrayLike | None, up_in_source: ArrayLike, up_in_target: ArrayLike = (0.0, 0.0, 1.0)
) -> NDArray[np.float64]:
    """Rotate a pose by the smallest angle that aligns the up directions, as known from an IMU at rest.

    ICP with four degrees of freedom keeps it level: Constraint(("x", "y", "z", "yaw")).

    Args:
        init: The pose T_target_source, 4x4; None: the identity.
        up_in_source: Up in source coordinates, any length: the mean accelerometer reading at rest, not the gravity
            direction.
        up_in_target: Up in target coordinates.

    Returns:
        The pose, float64 [4, 4], rotated about the source's origin (the sensor of a scan), with the heading of `init`
        as far as possible.

    Raises:
        ValueError: The pose is not rigid, a direction is invalid, or the source is upside down.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.registration.icp.leveling import leveled
        >>> T = leveled(None, up_in_source=[0.0, 0.5, 9.8])
        >>> up = T[:3, :3] @ [0.0, 0.5, 9.8]
        >>> bool(np.abs(up[:2]).max() < 1e-12), np.degrees(np.arccos(T[2, 2])).round(2)
        (True, np.float64(2.92))
    """
    T = np.eye(4) if init is None else np.array(check_rigid("init", init))
    T[:3, :3] = nearest_rotation(T[:3, :3])
    up = matmul(T[:3, :3], check_direction("up_in_source", up_in_source))
    up, wanted = up / norm(up), check_direction("up_in_target", up_in_target)
    axis = np.cross(up, wanted)
    sine, cosine = float(norm(axis)), float(matmul(up, wanted))
    if sine > MIN_SINE:
        T[:3, :3] = matmul(rotation_of(axis * (math.atan2(sine, cosine) / sine)), T[:3, :3])
    elif cosine < 0:
        raise ValueError("up_in_source: points down under init, so the shortest rotation is ambiguous; is it gravity?")
    return T
