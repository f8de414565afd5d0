"""Fitted views for other up axes than z."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.up_axis import AXES, UP, transform_up_vector
from ...meshing.mesh.mesh_arrays import MeshArrays
from .parts import Triple

VIEW_DIRECTION: Triple = (-0.65, 0.7, -0.75)  # down from the front right


def up_of(geometries: Iterable[tuple[Any, Any]]) -> Triple:
    """Up axis of the first geometry (with 4x4 pose or None) that defines one, else z."""
    return next(filter(None, (up_of_geometry(geometry, pose) for geometry, pose in geometries)), UP)


def up_of_geometry(geometry: object, pose: Any = None) -> Triple | None:
    """Up axis of a geometry under its 4x4 pose. None if undefined."""
    up = geometry.up if isinstance(geometry, MeshArrays) else None
    return up if pose is None else transform_up_vector(up, pose[:3, :3])


def direction_under(up: Triple) -> Triple:
    """Direction of a fitted view for an up axis: the default for z, rotated by the smallest angle.

    For y this is glTF's front, z, seen from its right.

    Example:
        >>> direction_under((0.0, 0.0, 1.0)), direction_under((0.0, 1.0, 0.0))
        ((-0.65, 0.7, -0.75), (-0.65, -0.75, -0.7))
    """
    toward = np.array(up) / np.linalg.norm(up)
    cosine = float(toward[2])
    if cosine < -1 + 1e-9:  # upside down: half a rotation about x
        return VIEW_DIRECTION[0], -VIEW_DIRECTION[1], -VIEW_DIRECTION[2]
    axis, way = np.cross(UP, toward), np.array(VIEW_DIRECTION)
    rotated = way + np.cross(axis, way) + np.cross(axis, np.cross(axis, way)) / (1 + cosine)  # Rodrigues
    x, y, z = rotated.tolist()
    return x, y, z


def level_up(right: NDArray[np.float64], up: NDArray[np.float64]) -> NDArray[np.float64]:
    """Up axis for camera rotations: the axis the camera is level to, z before y and x, else its own up direction."""
    for name in ("z", "y", "x"):
        axis = np.array(AXES[name])
        if abs(right @ axis) < 1e-6 and up @ axis > 0.05:
            return axis
    return up
