"""Open3D's views, both ways: front, lookat, up, zoom and field of view, and the JSON that Ctrl+C copies in its viewer.

Open3D (0.20, ViewControl) places the eye at lookat + front d with d = zoom s / tan(f / 2), where s is the longest side
of the box around what is drawn and f the vertical field of view. Pixel centres have whole coordinates there too.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...pcd.camera import (
    LARGEST_NUMBER,
    PinholeCameraIntrinsic,
    check_keys,
    read_json_matrix,
    read_json_object,
    read_pinhole_camera_intrinsic,
)
from ...pcd.checks import check_count, check_finite, check_number, check_positive, check_shape
from ...pcd.errors import FileError
from ...pcd.io.atomic import atomic_write
from .view import View, unit

Bounds = tuple[Any, Any]

FIELD_OF_VIEW, ZOOM = 60.0, 0.7  # what Open3D's viewer begins with; it looks along -z there, with y up
LEAST_ZOOM, MOST_ZOOM = 0.02, 2.0  # as far as the wheel goes in Open3D
LEAST_ANGLE, MOST = 1e-6, 1e30  # [degrees] of a field of view, and a zoom: beyond them numbers overflow
ALONG = 1e-9  # sine of the angle below which `up` lies along the direction of view

OPEN3D_KEYS = ("zoom", "front", "lookat", "up", "field_of_view")
_ENTRY = frozenset(("boundingbox_max", "boundingbox_min", "field_of_view", "front", "lookat", "up", "zoom"))
_FILE = frozenset(("interval", "is_loop", "version_major", "version_minor"))


def view_from_open3d(
    bounds: Bounds,
    *,
    zoom: float = ZOOM,
    front: Sequence[float] = (0.0, 0.0, 1.0),
    lookat: Sequence[float] | None = None,
    up: Sequence[float] = (0.0, 1.0, 0.0),
    field_of_view: float = FIELD_OF_VIEW,
    width: int = 1280,
    height: int = 960,
) -> View:
    """The view with Open3D's parameters; see `View.from_open3d`."""
    low, high = (check_finite("bounds", check_shape("bounds", end, (3,))) for end in _pair(bounds))
    middle = (low + high) / 2 if lookat is None else check_finite("lookat", check_shape("lookat", lookat, (3,)))
    backward = unit("front", front)
    right = np.cross(unit("up", up), backward)
    if not np.linalg.norm(right) > ALONG:
        raise ValueError(f"up: expected a direction that is not along front, got {up!r} and {front!r}")
    right = right / np.linalg.norm(right)
    zoom = check_positive("zoom", zoom, maximum=MOST)
    angle = check_number("field_of_view", field_of_view)
    if not LEAST_ANGLE <= angle <= 180 - LEAST_ANGLE:
        raise ValueError(f"field_of_view: expected an angle between 0 and 180 degrees, got {field_of_view!r}")
    width, height = check_count("width", width), check_count("height", height)
    tan = math.tan(math.radians(angle / 2))
    focal = height / 2 / tan
    T = np.eye(4)
    T[:3, :3] = np.column_stack([right, np.cross(right, backward), -backward])
    T[:3, 3] = middle + backward * (zoom * _longest_side(low, high) / tan)
    return View(PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2), T)


def view_to_open3d(view: View, bounds: Bounds) -> dict[str, Any]:
    """Open3D's parameters of a view; see `View.to_open3d`."""
    low, high = (check_finite("bounds", check_shape("bounds", end, (3,))) for end in _pair(bounds))
    camera, T = view.intrinsic, view.T_world_camera
    centered = abs(camera.cx - (camera.width - 1) / 2) < 1e-6 and abs(camera.cy - (camera.height - 1) / 2) < 1e-6
    if not centered or abs(camera.fx - camera.fy) > 1e-9 * camera.fy:
        raise ValueError(
            "view: Open3D's viewer has square pixels and the principal point in the middle; got "
            f"fx {camera.fx:g}, fy {camera.fy:g}, cx {camera.cx:g}, cy {camera.cy:g}"
        )
    tan, side = camera.height / 2 / camera.fy, _longest_side(low, high)
    ahead = float(((low + high) / 2 - T[:3, 3]) @ T[:3, 2])
    zoom = min(max(ahead * tan / side, LEAST_ZOOM), MOST_ZOOM)
    return {
        "zoom": zoom,
        "front": (-T[:3, 2]).tolist(),
        "lookat": (T[:3, 3] + T[:3, 2] * (zoom * side / tan)).tolist(),
        "up": (-T[:3, 1]).tolist(),
        "field_of_view": math.degrees(2 * math.atan(tan)),
    }


def read_view(path: str | os.PathLike[str], *, width: int = 1280, height: int = 960) -> View:
    """Read a view as Open3D's viewer copies it with Ctrl+C, or its PinholeCameraParameters (P).

    Args:
        path: A JSON file with one view: a ViewTrajectory of length 1, or a PinholeCameraParameters object, which brings
            its own size.
        width: Columns of the picture [px].
        height: Rows [px].

    Returns:
        The view; of an `up` that is not at a right angle to `front`, the part that is. (Open3D shears the picture.)

    Raises:
        FileError: Unreadable, not JSON, not one view, or a key that is missing, unknown or out of range.

    Example:
        >>> import pointloom as loom
        >>> view = loom.View.from_open3d(([0, 0, 0], [1, 1, 2]), zoom=0.5, front=[1, 0, 0], up=[0, 0, 1])
        >>> loom.write_view("view.json", view, ([0, 0, 0], [1, 1, 2]))
        >>> loom.read_view("view.json").T_world_camera[:3, 3].round(6).tolist()
        [2.232051, 0.5, 1.0]
    """
    width, height = check_count("width", width), check_count("height", height)
    content = read_json_object(path)
    if "intrinsic" in content:
        return _read_camera(path, content)
    check_keys(path, content, required={"class_name", "trajectory"}, optional=_FILE)
    if content["class_name"] != "ViewTrajectory":
        raise FileError(path, f"expected 'ViewTrajectory', got {str(content['class_name'])[:40]!r}", where="class_name")
    entries = content["trajectory"]
    if not isinstance(entries, list) or len(entries) != 1 or not isinstance(entries[0], dict):
        found = f"{len(entries)} entries" if isinstance(entries, list) else f"a {type(entries).__name__}"
        raise FileError(path, f"expected a list with one view, got {found}", where="key trajectory")
    check_keys(path, entries[0], required=_ENTRY, where="trajectory[0].")
    values = {key: _read_numbers(path, key, value) for key, value in entries[0].items()}
    bounds = values.pop("boundingbox_min"), values.pop("boundingbox_max")
    try:
        return view_from_open3d(bounds, width=width, height=height, **values)
    except (TypeError, ValueError) as error:
        raise FileError(path, str(error), where="key trajectory[0]") from error


def write_view(path: str | os.PathLike[str], view: View, bounds: Bounds) -> None:
    """Write a view as Open3D's viewer takes it with Ctrl+V; an existing file is replaced.

    Args:
        path: A .json file.
        view: The view, with square pixels and the principal point in the middle.
        bounds: The lowest and highest corner [m] of the box around what is drawn, shape [3] each.

    Raises:
        FileError: The place cannot be written.
        ValueError: A view that Open3D's parameters cannot say.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[0, 0, 0], [1, 1, 2]])
        >>> bounds = cloud.get_min_bound(), cloud.get_max_bound()
        >>> loom.write_view("view.json", loom.View.from_open3d(bounds), bounds)
    """
    if not isinstance(view, View):
        raise TypeError(f"view: expected a View, got {type(view).__name__}")
    entry = view_to_open3d(view, bounds)
    low, high = (np.asarray(end, np.float64).tolist() for end in bounds)
    content = {
        "class_name": "ViewTrajectory",
        "interval": 29,
        "is_loop": False,
        "trajectory": [{"boundingbox_max": high, "boundingbox_min": low, **entry}],
        "version_major": 1,
        "version_minor": 0,
    }
    with atomic_write(path) as file:
        file.write(json.dumps(content, indent="\t").encode() + b"\n")


def _read_camera(path: Any, content: dict[str, Any]) -> View:
    """The view of Open3D's PinholeCameraParameters, whose extrinsic is world to camera."""
    intrinsic = read_pinhole_camera_intrinsic(path)
    if "extrinsic" not in content:
        raise FileError(path, "missing", where="key extrinsic")
    extrinsic = read_json_matrix(path, content["extrinsic"], 4, where="key extrinsic")
    try:
        return View(intrinsic, np.asarray(np.linalg.inv(extrinsic), np.float64))
    except (ValueError, np.linalg.LinAlgError) as error:
        raise FileError(path, str(error), where="key extrinsic") from error


def _read_numbers(path: Any, key: str, value: Any) -> Any:
    """The number or the three numbers of a key."""
    numbers = value if isinstance(value, list) else [value]
    count = 1 if key in ("zoom", "field_of_view") else 3
    for number in numbers:
        if isinstance(number, bool) or not isinstance(number, int | float) or abs(number) > LARGEST_NUMBER:
            raise FileError(path, f"expected numbers, got {str(number)[:40]!r}", where=f"key trajectory[0].{key}")
    if len(numbers) != count or isinstance(value, list) != (count == 3):
        expected = "a list of three numbers" if count == 3 else "a number"
        raise FileError(path, f"expected {expected}, got {str(value)[:40]}", where=f"key trajectory[0].{key}")
    return value


def _pair(bounds: Any) -> tuple[Any, Any]:
    try:
        low, high = bounds
    except (TypeError, ValueError) as error:
        raise ValueError(f"bounds: expected the lowest and the highest corner, got {str(bounds)[:60]}") from error
    return low, high


def _longest_side(low: NDArray[np.float64], high: NDArray[np.float64]) -> float:
    """The longest side of a box; 1 where it is a point."""
    return float(np.abs(high - low).max()) or 1.0
