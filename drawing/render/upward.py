"""How a view that is fitted looks where something else than z is up: `up_of`, `direction_under`, `level_up`."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.upward import AXES, UP, up_under
from ...meshing.mesh.mesh_arrays import MeshArrays
from .parts import Triple

DIRECTION: Triple = (-0.65, 0.7, -0.75)  # down from the front right, as onto a doll's house


def up_of(geometries: Iterable[tuple[Any, Any]]) -> Triple:
    """What is up in the first of geometries that says so, each with its 4x4 pose or None; z where none does."""
    return next(filter(None, (told_up(geometry, pose) for geometry, pose in geometries)), UP)


def told_up(geometry: Any, pose: Any = None) -> Triple | None:
    """What is up in a geometry that says so, where its 4x4 pose moves it; None where it does not say."""
    up = geometry.up if isinstance(geometry, MeshArrays) else None
    return up if pose is None else up_under(up, pose[:3, :3])


def direction_under(up: Triple) -> Triple:
    """The way that a fitted view looks where `up` is up: turned from what it is under z by the least turn.

    Under y that is what files of glTF take for the front, z, seen from its right.

    Example:
        >>> direction_under((0.0, 0.0, 1.0)), direction_under((0.0, 1.0, 0.0))
        ((-0.65, 0.7, -0.75), (-0.65, -0.75, -0.7))
    """
    towards = np.array(up) / np.linalg.norm(up)
    cosine = float(towards[2])
    if cosine < -1 + 1e-9:  # upside down: half a turn about x
        return DIRECTION[0], -DIRECTION[1], -DIRECTION[2]
    axis, way = np.cross(UP, towards), np.array(DIRECTION)
    turned = way + np.cross(axis, way) + np.cross(axis, np.cross(axis, way)) / (1 + cosine)  # Rodrigues
    x, y, z = turned.tolist()
    return x, y, z


def level_up(right: NDArray[np.float64], up: NDArray[np.float64]) -> NDArray[np.float64]:
    """What a camera stays level to as it is turned: the axis that it is level to now, z before y and x, else its up.

    Args:
        right, up: Of the camera in the world, of length 1.
    """
    for name in ("z", "y", "x"):
        axis = np.array(AXES[name])
        if abs(right @ axis) < 1e-6 and up @ axis > 0.05:
            return axis
    return up
