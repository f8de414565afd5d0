"""Up axes and directions of fitted views."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.up_axis import AXES, UP, transform_up_vector
from ...kernels.meshes.facing_areas import DIRECTION_COUNT, facing_areas
from ...meshing.mesh.mesh_arrays import MeshArrays
from .camera_frame import is_in_camera_frame
from .parts import Triple

VIEW_DIRECTION: Triple = (-0.65, 0.7, -0.75)  # down from the front right
Look = tuple[Triple, Triple]  # direction and up axis of a fitted view
DEFAULT_LOOK: Look = (VIEW_DIRECTION, UP)
CAMERA_UP: Triple = (0.0, -1.0, 0.0)  # in the frame of a camera, y is down
# Decrease of the fraction of backs among the triangles for which a view is rotated. Closed meshes have equal fractions
# from everywhere, up to holes and noise.
MIN_BACK_GAIN = 0.1
MIN_TOTAL_AREA = 1e-300  # [m^2] against division by zero


def up_of(geometries: Iterable[tuple[Any, Any]]) -> Triple:
    """Up axis of the first geometry (with 4x4 pose or None) that defines one, else z."""
    return next(filter(None, (up_of_geometry(geometry, pose) for geometry, pose in geometries)), UP)


def up_of_geometry(geometry: object, pose: Any = None) -> Triple | None:
    """Up axis of a geometry under its 4x4 pose. None if undefined."""
    up = geometry.up if isinstance(geometry, MeshArrays) else None
    if is_in_camera_frame(geometry):
        up = CAMERA_UP
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


def look_of(geometries: Iterable[tuple[Any, Any]], up: Triple | None = None) -> Look:
    """Direction and up axis of a fitted view of geometries (with 4x4 pose or None); `up` None: that of `up_of`."""
    placed = list(geometries)
    axis = up_of(placed) if up is None else up
    return _direction_of(placed, axis), axis


def _direction_of(geometries: Iterable[tuple[Any, Any]], up: Triple) -> Triple:
    """The default direction, or a quarter turn of it about `up` that shows more of open meshes from the front."""
    default = direction_under(up)
    direction, axis = np.array(default), np.array(up) / np.linalg.norm(up)
    along, side = axis * (axis @ direction), np.cross(axis, direction)
    level = direction - along
    directions = np.stack([along + way for way in (level, side, -side, -level)])
    front, back = np.zeros(DIRECTION_COUNT), np.zeros(DIRECTION_COUNT)
    for geometry, pose in geometries:
        if isinstance(geometry, MeshArrays) and len(geometry):
            ways = directions if pose is None else directions @ pose[:3, :3]
            areas = facing_areas(geometry.arrays["vertices"], geometry.arrays["triangles"], ways)  # sync
            front, back = front + areas[0], back + areas[1]
    fractions = back / np.maximum(front + back, MIN_TOTAL_AREA)
    best = int(fractions.argmin())
    if not fractions[best] < fractions[0] - MIN_BACK_GAIN:
        return default
    x, y, z = directions[best].tolist()
    return x, y, z


def level_up(right: NDArray[np.float64], up: NDArray[np.float64]) -> NDArray[np.float64]:
    """Up axis for camera rotations: the axis the camera is level to, z before y and x, else its own up direction."""
    for name in ("z", "y", "x"):
        axis = np.array(AXES[name])
        if abs(right @ axis) < 1e-6 and up @ axis > 0.05:
            return axis
    return up
