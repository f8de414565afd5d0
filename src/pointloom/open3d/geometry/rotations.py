"""Rotation matrices from angles, axes and quaternions, by scipy in Open3D's orders."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation

from ..wrapper import column

Matrix = NDArray[np.float64]


def _from_angles(axes: str) -> Callable[[ArrayLike], Matrix]:
    """A function of three angles [rad] that multiplies rotations about the axes in this order."""

    def rotation_matrix(rotation: ArrayLike) -> Matrix:
        return Rotation.from_euler(axes, column("rotation", rotation)).as_matrix()

    rotation_matrix.__name__ = rotation_matrix.__qualname__ = f"get_rotation_matrix_from_{axes.lower()}"
    rotation_matrix.__doc__ = f"R{axes[0].lower()}(a) R{axes[1].lower()}(b) R{axes[2].lower()}(c), angles in [rad]."
    return rotation_matrix


get_rotation_matrix_from_xyz = _from_angles("XYZ")
get_rotation_matrix_from_yzx = _from_angles("YZX")
get_rotation_matrix_from_zxy = _from_angles("ZXY")
get_rotation_matrix_from_xzy = _from_angles("XZY")
get_rotation_matrix_from_zyx = _from_angles("ZYX")
get_rotation_matrix_from_yxz = _from_angles("YXZ")


def get_rotation_matrix_from_axis_angle(rotation: ArrayLike) -> Matrix:
    """From an axis whose length is the angle [rad]."""
    return Rotation.from_rotvec(column("rotation", rotation)).as_matrix()


def get_rotation_matrix_from_quaternion(rotation: ArrayLike) -> Matrix:
    """From a quaternion (w, x, y, z)."""
    w, x, y, z = column("rotation", rotation, 4)
    return Rotation.from_quat([x, y, z, w]).as_matrix()
