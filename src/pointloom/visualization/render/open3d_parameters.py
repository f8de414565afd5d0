"""Conversion of Open3D's view parameters: front, lookat, up, zoom and field of view.

Open3D (0.20, ViewControl) places the eye at lookat + front d with d = zoom s / tan(f / 2), where s is the longest side
of the scene's bounds and f the vertical field of view. Pixel centers have integer coordinates there, too.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count, check_direction, check_finite, check_number, check_positive, check_shape

Bounds = tuple[Any, Any]

FIELD_OF_VIEW, DEFAULT_ZOOM = 60.0, 0.7  # defaults of Open3D's viewer, which looks along -z with y up
MIN_ZOOM, MAX_ZOOM = 0.02, 2.0  # limits of the wheel in Open3D
MIN_ANGLE, LARGEST_ZOOM = 1e-6, 1e30  # minimum field of view [degrees] and maximum zoom: beyond them numbers overflow

MIN_UP_SINE = 1e-9  # sine of the angle below which `up` is parallel to the view direction


def view_from_open3d(
    bounds: Bounds,
    *,
    zoom: float = DEFAULT_ZOOM,
    front: Sequence[float] = (0.0, 0.0, 1.0),
    lookat: Sequence[float] | None = None,
    up: Sequence[float] = (0.0, 1.0, 0.0),
    field_of_view: float = FIELD_OF_VIEW,
    width: int = 1280,
    height: int = 960,
) -> tuple[PinholeCameraIntrinsic, NDArray[np.float64]]:
    low, high = (check_finite("bounds", check_shape("bounds", end, (3,))) for end in _pair(bounds))
    middle = (low + high) / 2 if lookat is None else check_finite("lookat", check_shape("lookat", lookat, (3,)))
    backward = check_direction("front", front)
    right = cross_product(check_direction("up", up), backward)
    if not np.linalg.norm(right) > MIN_UP_SINE:
        raise ValueError(f"up: expected a direction that is not along front, got {up!r} and {front!r}")
    right = right / np.linalg.norm(right)
    zoom = check_positive("zoom", zoom, maximum=LARGEST_ZOOM)
    angle = check_number("field_of_view", field_of_view)
    if not MIN_ANGLE <= angle <= 180 - MIN_ANGLE:
        raise ValueError(f"field_of_view: expected an angle between 0 and 180 degrees, got {field_of_view!r}")
    width, height = check_count("width", width), check_count("height", height)
    tan = math.tan(math.radians(angle / 2))
    focal = height / 2 / tan
    T = np.eye(4)
    T[:3, :3] = np.column_stack([right, cross_product(right, backward), -backward])
    T[:3, 3] = middle + backward * (zoom * _longest_side(low, high) / tan)
    return PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2), T


def view_to_open3d(camera: PinholeCameraIntrinsic, T: NDArray[np.float64], bounds: Bounds) -> dict[str, Any]:
    low, high = (check_finite("bounds", check_shape("bounds", end, (3,))) for end in _pair(bounds))
    centered = abs(camera.cx - (camera.width - 1) / 2) < 1e-6 and abs(camera.cy - (camera.height - 1) / 2) < 1e-6
    if not centered or abs(camera.fx - camera.fy) > 1e-9 * camera.fy:
        raise ValueError(
            "view: expected square pixels and a centered principal point, as in Open3D's viewer; got "
            f"fx {camera.fx:g}, fy {camera.fy:g}, cx {camera.cx:g}, cy {camera.cy:g}"
        )
    tan, side = camera.height / 2 / camera.fy, _longest_side(low, high)
    ahead = float(((low + high) / 2 - T[:3, 3]) @ T[:3, 2])
    zoom = min(max(ahead * tan / side, MIN_ZOOM), MAX_ZOOM)
    return {
        "zoom": zoom,
        "front": (-T[:3, 2]).tolist(),
        "lookat": (T[:3, 3] + T[:3, 2] * (zoom * side / tan)).tolist(),
        "up": (-T[:3, 1]).tolist(),
        "field_of_view": math.degrees(2 * math.atan(tan)),
    }


def cross_product(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """`np.cross` of two vectors (3,), bitwise identical, without its 30 us of axis handling."""
    (ax, ay, az), (bx, by, bz) = a.tolist(), b.tolist()
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])


def _pair(bounds: Any) -> tuple[Any, Any]:
    try:
        low, high = bounds
    except (TypeError, ValueError) as error:
        raise ValueError(f"bounds: expected the lowest and the highest corner, got {str(bounds)[:60]}") from error
    return low, high


def _longest_side(low: NDArray[np.float64], high: NDArray[np.float64]) -> float:
    """The longest side of a box. 1 if it is a point."""
    return float(np.abs(high - low).max()) or 1.0
