"""View files of Open3D's viewer (Ctrl+C) and its PinholeCameraParameters."""

from __future__ import annotations

import json
import os
from typing import Any

import numpy as np

from ...cameras.camera import (
    LARGEST_NUMBER,
    check_keys,
    read_json_matrix,
    read_json_object,
    read_pinhole_camera_intrinsic,
)
from ...core.atomic import atomic_write
from ...core.checks import check_count
from ...core.errors import FileError
from ...core.paths import path_of
from .open3d_parameters import Bounds
from .view import View, check_view

OPEN3D_KEYS = ("zoom", "front", "lookat", "up", "field_of_view")
_ENTRY = frozenset(("boundingbox_max", "boundingbox_min", "field_of_view", "front", "lookat", "up", "zoom"))
_FILE = frozenset(("interval", "is_loop", "version_major", "version_minor"))


def read_view(path: str | os.PathLike[str], *, width: int = 1280, height: int = 960) -> View:
    """Read a view that Open3D's viewer copied with Ctrl+C, or its PinholeCameraParameters (key P).

    Args:
        path: A JSON file with a ViewTrajectory of length 1, or with PinholeCameraParameters, which define the size.
        width, height: Size of the image [px].

    Returns:
        The view. An `up` not perpendicular to `front` is orthogonalized (Open3D shears the image).

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
        given = f"{len(entries)} entries" if isinstance(entries, list) else f"a {type(entries).__name__}"
        raise FileError(path, f"expected a list with one view, got {given}", where="key trajectory")
    check_keys(path, entries[0], required=_ENTRY, where="trajectory[0].")
    values = {key: _read_numbers(path, key, value) for key, value in entries[0].items()}
    bounds = values.pop("boundingbox_min"), values.pop("boundingbox_max")
    try:
        return View.from_open3d(bounds, width=width, height=height, **values)
    except (TypeError, ValueError) as error:
        raise FileError(path, str(error), where="key trajectory[0]") from error


def write_view(path: str | os.PathLike[str], view: View, bounds: Bounds) -> None:
    """Write a view that Open3D's viewer accepts with Ctrl+V. An existing file is replaced.

    Args:
        path: A .json file.
        view: View with square pixels and a centered principal point.
        bounds: Lowest and highest corner of the scene [m], shape (3,) each.

    Raises:
        FileError, ValueError: The file cannot be written, or Open3D's parameters cannot describe the view.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[0, 0, 0], [1, 1, 2]])
        >>> bounds = cloud.get_min_bound(), cloud.get_max_bound()
        >>> loom.write_view("view.json", loom.View.from_open3d(bounds), bounds)
    """
    path = path_of(path)
    check_view(view)
    entry = view.to_open3d(bounds)
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
    """The view of PinholeCameraParameters, whose extrinsic is world to camera."""
    intrinsic = read_pinhole_camera_intrinsic(path)
    if "extrinsic" not in content:
        raise FileError(path, "missing", where="key extrinsic")
    extrinsic = read_json_matrix(path, content["extrinsic"], 4, where="key extrinsic")
    try:
        return View(intrinsic, np.asarray(np.linalg.inv(extrinsic), np.float64))
    except (ValueError, np.linalg.LinAlgError) as error:
        raise FileError(path, str(error), where="key extrinsic") from error


def _read_numbers(path: Any, key: str, value: Any) -> Any:
    numbers = value if isinstance(value, list) else [value]
    count = 1 if key in ("zoom", "field_of_view") else 3
    for number in numbers:
        if isinstance(number, bool) or not isinstance(number, int | float) or abs(number) > LARGEST_NUMBER:
            raise FileError(path, f"expected numbers, got {str(number)[:40]!r}", where=f"key trajectory[0].{key}")
    if len(numbers) != count or isinstance(value, list) != (count == 3):
        expected = "a list of three numbers" if count == 3 else "a number"
        raise FileError(path, f"expected {expected}, got {str(value)[:40]}", where=f"key trajectory[0].{key}")
    return value
