"""Rotation matrices from angles, axes and quaternions, by scipy in Open3D's orders."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation

from ..wrapper import column

Matrix = NDArray[np.float64]


def _euler(order: str, rotation: ArrayLike) -> Matrix:
    return Rotation.from_euler(order, column("rotation", rotation)).as_matrix()


def get_rotation_matrix_from_xyz(rotation: ArrayLike) -> Matrix:
    """Rx(a) Ry(b) Rz(c), angles in [rad]."""
    return _euler("XYZ", rotation)


def get_rotation_matrix_from_yzx(rotation: ArrayLike) -> Matrix:
    """Ry(a) Rz(b) Rx(c), angles in [rad]."""
    return _euler("YZX", rotation)


def get_rotation_matrix_from_zxy(rotation: ArrayLike) -> Matrix:
    """Rz(a) Rx(b) Ry(c), angles in [rad]."""
    return _euler("ZXY", rotation)


def get_rotation_matrix_from_xzy(rotation: ArrayLike) -> Matrix:
    """Rx(a) Rz(b) Ry(c), angles in [rad]."""
    return _euler("XZY", rotation)


def get_rotation_matrix_from_zyx(rotation: ArrayLike) -> Matrix:
    """Rz(a) Ry(b) Rx(c), angles in [rad]."""
    return _euler("ZYX", rotation)


def get_rotation_matrix_from_yxz(rotation: ArrayLike) -> Matrix:
    """Ry(a) Rx(b) Rz(c), angles in [rad]."""
    return _euler("YXZ", rotation)


def get_rotation_matrix_from_axis_angle(rotation: ArrayLike) -> Matrix:
    """From an axis whose length is the angle [rad]."""
    return Rotation.from_rotvec(column("rotation", rotation)).as_matrix()


def get_rotation_matrix_from_quaternion(rotation: ArrayLike) -> Matrix:
    """From a quaternion (w, x, y, z)."""
    w, x, y, z = column("rotation", rotation, 4)
    return Rotation.from_quat([x, y, z, w]).as_matrix()
