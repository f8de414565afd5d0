"""Poses that an inertial sensor has levelled."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_direction, check_rigid
from ...kernels.linear_algebra import matmul, norm
from ..rigid import nearest_rotation, rotation_of

OPPOSITE = 1e-9  # of the sine: directions as near to opposite have no shortest turn


def levelled(
    init: ArrayLike | None, up_in_source: ArrayLike, up_in_target: ArrayLike = (0.0, 0.0, 1.0)
) -> NDArray[np.float64]:
    """A pose turned by the least angle so that the source's up is the target's, as an IMU at rest tells it.

    ICP of four degrees of freedom then holds what gravity has said: free=("x", "y", "z", "yaw").

    Args:
        init: The pose T_target_source to turn, 4x4; None: the identity.
        up_in_source: Up in the source's coordinates, of any length: what an accelerometer at rest measures (it points
            away from the ground), not the direction of gravity, which is its opposite. The mean of many readings.
        up_in_target: Up in the target's coordinates.

    Returns:
        The pose, float64 [4, 4]. It turns about the source's own zero, whose image stays: the sensor, for a scan in its
        sensor's frame. The heading is that of `init` as nearly as a level pose can have it.

    Raises:
        ValueError: No rigid motion, no direction, or a source upside down, whose way back is any.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.registration.icp.levelling import levelled
        >>> T = levelled(None, up_in_source=[0.0, 0.5, 9.8])
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
    if sine > OPPOSITE:
        T[:3, :3] = matmul(rotation_of(axis * (math.atan2(sine, cosine) / sine)), T[:3, :3])
    elif cosine < 0:
        raise ValueError("up_in_source: upside down under init, so every way to turn it is as short; is it gravity?")
    return T
