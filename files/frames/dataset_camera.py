"""The camera of a folder of frames: where it was found, and what speaks against it."""

from __future__ import annotations

import dataclasses
import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic, read_pinhole_camera_intrinsic
from ...cameras.pose_text import parse_floats, read_lines
from ...core.checks import check_positive
from ...core.errors import DatasetError, FileError
from ...core.json_files import read_json_object

# Names under which a folder may bring its camera; Open3D's recorders write the last two.
INTRINSIC_NAMES = ("camera-intrinsics.json", "camera.json", "camera_intrinsic.json", "intrinsic.json")

# The same as a 3x3 matrix in text: 7-Scenes and 3DMatch have the first.
MATRIX_NAMES = ("camera-intrinsics.txt", "intrinsics.K.txt", "intrinsics.txt", "K.txt")

# What else may hold a camera, by its name.
_LIKE_A_CAMERA = re.compile(r"(.*intrinsic.*|.*calib.*|.*camera.*|.*\bK)\.(txt|json|ya?ml|xml)", re.I)

# Real depth cameras have their principal point within 5 % of the size from the middle; one that is farther off than
# this is likely that of a picture of another size.
_FARTHEST_FROM_MIDDLE = 0.15

_FIELDS_OF_VIEW = (10.0, 150.0)  # [degrees] of pictures that a pinhole camera takes


@dataclasses.dataclass(frozen=True)
class FoundCamera:
    """A camera and how it came.

    Args:
        intrinsic: The camera.
        source: Where it was found.
        depth_scale: Stored depth of one metre, which some recorders store with it.
        doubt: Why it may be another camera's; empty where nothing speaks against it.
    """

    intrinsic: PinholeCameraIntrinsic
    source: str
    depth_scale: float
    doubt: str = ""


def find_camera(folder: Path, layout: str, size: tuple[int, int], depth_scale: float) -> FoundCamera:
    """The camera of a folder: a JSON file, a matrix (also above a folder seq-NN), or the default of the layout.

    Args:
        folder: The folder.
        layout: Its layout.
        size: Width and height of the pictures, which a matrix does not tell.
        depth_scale: Of the layout.

    Raises:
        DatasetError: Several files that say what the camera is, a size other than the pictures', or none where the
            layout has no default.
        FileError: A file that cannot be read.
    """
    present = [folder / name for name in INTRINSIC_NAMES if (folder / name).is_file()]
    if len(present) > 1:
        raise DatasetError(present[1], f"is there beside {present[0].name}", remedy="Keep one, or give intrinsic=")
    if present:
        scale = _read_depth_scale(present[0], depth_scale)
        return doubted(FoundCamera(read_pinhole_camera_intrinsic(present[0]), present[0].name, scale))
    for place in [folder] + ([folder.parent] if re.fullmatch(r"seq-\d+", folder.name) else []):
        matrices = {path: _read_matrix(path) for name in MATRIX_NAMES if (path := place / name).is_file()}
        if not matrices:
            continue
        path, K = next(iter(matrices.items()))
        other = next((p for p, matrix in matrices.items() if not np.array_equal(matrix, K)), None)
        if other is not None:
            reason = f"says otherwise than {path.name} beside it"
            raise DatasetError(other, reason, remedy="Keep one, or give intrinsic=")
        try:
            return doubted(FoundCamera(PinholeCameraIntrinsic.from_matrix(K, *size), str(path), depth_scale))
        except ValueError as error:
            raise FileError(path, str(error)) from error
    if layout == "pictures":
        remedy = "Give intrinsic=, or put a camera-intrinsics.json beside them"
        raise DatasetError(folder, "nothing tells the camera of its pictures", remedy=remedy)
    intrinsic, source = PinholeCameraIntrinsic.prime_sense_default(), f"the default of {layout}"
    if layout == "7scenes":
        intrinsic, source = PinholeCameraIntrinsic(640, 480, 585.0, 585.0, 320.0, 240.0), "the default of 7-Scenes"
    unread = sorted(path.name for path in folder.iterdir() if _LIKE_A_CAMERA.fullmatch(path.name) and path.is_file())
    doubt = f"{unread[0]} lies beside the frames and was not read; give it with intrinsic=" if unread else ""
    return FoundCamera(intrinsic, source, depth_scale, doubt)


def doubted(found: FoundCamera) -> FoundCamera:
    """The same camera, with what speaks against its being that of the pictures."""
    camera = found.intrinsic
    for name, length, middle, focal in (
        ("width", camera.width, camera.cx, camera.fx),
        ("height", camera.height, camera.cy, camera.fy),
    ):
        off = abs(middle - (length - 1) / 2) / length
        if off > _FARTHEST_FROM_MIDDLE:
            reason = f"its principal point ({camera.cx:g}, {camera.cy:g}) lies far from the middle of pictures of"
            likely = f"it may be that of {2 * camera.cx:.0f} x {2 * camera.cy:.0f}"
            return dataclasses.replace(found, doubt=f"{reason} {camera.width} x {camera.height}; {likely}")
        view = 2 * np.degrees(np.arctan(length / (2 * focal)))
        if not _FIELDS_OF_VIEW[0] <= view <= _FIELDS_OF_VIEW[1]:
            reason = f"its focal length {focal:g} makes a field of view of {view:.3g} degrees of a {name} of {length}"
            return dataclasses.replace(found, doubt=reason)
    return found


def _read_matrix(path: Path) -> NDArray[np.float64]:
    lines = read_lines(path)
    if len(lines) != 3:
        raise FileError(path, f"expected 3 rows of a matrix, got {len(lines)}")
    return np.array([parse_floats(path, line, 3) for line in lines])


def _read_depth_scale(path: Path, default: float) -> float:
    """The depth scale that Open3D's RealSense recorder stores with the camera, if there is one."""
    content = read_json_object(path)
    if "depth_scale" not in content:
        return default
    try:
        return check_positive("depth_scale", content["depth_scale"])
    except (TypeError, ValueError) as error:
        raise FileError(path, str(error), where="key depth_scale") from error
