"""The up axis: `check_up`, `transform_up_vector`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..kernels.linear_algebra import matmul, norm
from .checks import check_direction, shown

Direction = tuple[float, float, float]

UP: Direction = (0.0, 0.0, 1.0)  # default
AXES: dict[str, Direction] = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": UP}


def check_up(up: object) -> Direction:
    """The up direction as a unit vector, from "x", "y", "z" or a vector."""
    if isinstance(up, str):
        if up not in AXES:
            raise ValueError(f"up: expected x, y, z or a direction, got {shown(up)}")
        return AXES[up]
    x, y, z = check_direction("up", up).tolist()
    return x, y, z


def transform_up_vector(up: Direction | None, A: NDArray[Any]) -> Direction | None:
    """The up direction after a map with the 3x3 part A.

    Example:
        >>> transform_up_vector((0.0, 1.0, 0.0), np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]]))
        (0.0, 0.0, 1.0)
    """
    if up is None:
        return None
    rotated = matmul(np.asarray(A, np.float64), np.array(up))
    length = float(norm(rotated))
    if not 0 < length < np.inf:
        return None
    x, y, z = (rotated / length + 0.0).tolist()  # no -0
    return x, y, z


def rotation_between(start: Direction, end: Direction) -> NDArray[np.float64]:
    """The smallest rotation [3, 3] of one unit vector to another, exact for axes. Opposite ones about x, or z."""
    a, b = np.array(start), np.array(end)
    sine, cosine = np.cross(a, b), float((a * b).sum())
    if not sine.any() and cosine < 0:
        return np.diag([1.0, -1.0, -1.0]) if not a[0] else np.diag([-1.0, -1.0, 1.0])
    cross = np.array([[0, -sine[2], sine[1]], [sine[2], 0, -sine[0]], [-sine[1], sine[0], 0]])
    return np.eye(3) + cross + matmul(cross, cross) / (1 + cosine)


def up_of_camera(T_world_camera: NDArray[np.float64]) -> Direction:
    """Axis nearest to the up direction of a camera, -y, which is level in most frames."""
    up = -T_world_camera[:3, 1]
    axis = np.zeros(3)
    axis[np.abs(up).argmax()] = np.sign(up[np.abs(up).argmax()])
    x, y, z = (axis + 0.0).tolist()
    return x, y, z
