"""Cameras as JSON with lens and pose per image: transforms.json (nerfstudio, instant-ngp), Polycam, 3D Scanner App.

Poses are camera to world in OpenGL axes (x right, y up, z back), converted to world to camera in x right, y down, z
forward. Principal points are measured from the image corner, as in COLMAP.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera_models import CameraModel
from ...core.checks import check_rigid
from ...core.errors import FileError, FilePath
from ...core.json_files import read_json_object
from ...kernels.linear_algebra import inv
from ..images.image_files import read_image_header
from ..images.image_formats import IMAGES
from .colmap_records import camera_of
from .sfm_model import SfmModel

OPENGL_AXES = np.diag([1.0, -1.0, -1.0, 1.0])  # from x right, y down, z forward to x right, y up, z back
LENSES = ("OPENCV", "PINHOLE", "SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV_FISHEYE")
DISTORTION = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")
POLYCAM_KEYS = [f"t_{row}{column}" for row in range(3) for column in range(4)]
SCANNER_APP = "cameraPoseARFrame"

_EXPORTED = "Give transforms.json, Polycam's keyframes/cameras, or the folder of frames of the 3D Scanner App"


def read_transforms(path: FilePath) -> SfmModel:
    """Read the transforms.json of nerfstudio or instant-ngp as a model without points.
    Without `w` and `h` the size is that of the image. `camera_angle_x` and `camera_angle_y` [rad] replace missing focal
    lengths. `is_fisheye` without `camera_model` is OPENCV_FISHEYE, as in instant-ngp."""
    path, content = Path(path), read_json_object(path)
    frames = content.get("frames")
    if not isinstance(frames, list) or not frames:
        raise FileError(path, "expected a list of at least one frame", where="key frames", remedy=_EXPORTED)
    names, cameras, poses = [], [], []
    for i, frame in enumerate(frames):
        where = f"frames[{i}]"
        if not isinstance(frame, dict) or not isinstance(frame.get("file_path"), str) or not frame["file_path"]:
            raise FileError(path, "expected an object with the image's file_path", where=where)
        values, name = {**content, **frame}, frame["file_path"]
        if "w" not in values or "h" not in values:
            image = _image_of(path, where, name)
            header = read_image_header(image)
            values = {"w": header.width, "h": header.height} | values
            name += image.name.removeprefix(Path(name).name)
        names.append(os.path.normpath(name))
        cameras.append(_lens_of(path, where, values))
        rows = _numbers(path, where, frame, "transform_matrix", None)
        if rows.shape not in ((4, 4), (3, 4)):
            raise FileError(path, "transform_matrix: expected 4 rows of 4 numbers", where=where)
        poses.append(_pose(path, where, rows))
    return _model(path, names, cameras, poses)


def read_frame_cameras(folder: FilePath) -> SfmModel:
    """Read the cameras of Polycam (keyframes/cameras or corrected_cameras) or the 3D Scanner App, without points.
    Image sizes are read from the images. Frames without an image are listed in `left_out`."""
    folder = Path(folder)
    names, cameras, poses, left_out = [], [], [], []
    for path, content in _camera_files(folder):
        if SCANNER_APP in content:
            image = next((p for p in map(path.with_suffix, IMAGES) if p.is_file()), None)
            if image is None:
                left_out.append(f"{path.stem}: no image")
                continue
            header = read_image_header(image)
            width, height = header.width, header.height
            K = _numbers(path, "", content, "intrinsics", 9).reshape(3, 3)
            params, rows = (
                (K[0, 0], K[1, 1], K[0, 2], K[1, 2]),
                _numbers(path, "", content, SCANNER_APP, 16).reshape(4, 4),
            )
        else:
            width, height = (_side(path, "", content, name) for name in ("width", "height"))
            params = tuple(_number(path, "", content, name) for name in ("fx", "fy", "cx", "cy"))
            rows = np.array([_number(path, "", content, name) for name in POLYCAM_KEYS]).reshape(3, 4)
        names.append(path.stem)
        cameras.append(camera_of(path, "", "PINHOLE", width, height, [float(value) for value in params]))
        poses.append(_pose(path, "", rows))
    if not names:
        reason = "contains no camera of Polycam or of the 3D Scanner App"
        reason += f" with an image beside it ({len(left_out)} have none)" if left_out else ""
        raise FileError(folder, reason, remedy=_EXPORTED)
    return _model(folder, names, cameras, poses, left_out)


def contains_frame_cameras(folder: FilePath) -> bool:
    return any(True for _ in _camera_files(Path(folder)))


def _camera_files(folder: Path) -> Iterator[tuple[Path, dict[str, Any]]]:
    for path in sorted(folder.glob("*.json")):
        content = read_json_object(path)
        if SCANNER_APP in content or "t_00" in content:
            yield path, content


def _image_of(path: Path, where: str, name: str) -> Path:
    base = path.parent / name
    beside = (base.with_name(base.name + suffix) for ending in IMAGES for suffix in (ending, ending.upper()))
    image = next((p for p in (base, *beside) if p.is_file()), None)
    if image is None:
        reason = f"w and h are missing, and there is no image {name} to read them from"
        raise FileError(path, reason, where=where, remedy="Put the images there, or add w and h in pixels")
    return image


def _lens_of(path: Path, where: str, values: Mapping[str, Any]) -> CameraModel:
    is_fisheye = values.get("is_fisheye") is True
    kind = values.get("camera_model", "OPENCV_FISHEYE" if is_fisheye else "OPENCV")
    if kind not in LENSES:
        remedy = f"Supported are {', '.join(LENSES)}; undistort the images of others first"
        raise FileError(path, f"camera_model is {str(kind)[:40]!r}", where=where, remedy=remedy)
    if is_fisheye and kind != "OPENCV_FISHEYE":
        reason = f"is_fisheye is true, but camera_model is {kind!r}"
        raise FileError(path, reason, where=where, remedy="Remove one of them; the fisheye is OPENCV_FISHEYE")
    width, height = (_side(path, where, values, name) for name in ("w", "h"))
    fx = _focal_length(path, where, values, "x", width)
    fy = _focal_length(path, where, values, "y", height)
    if fx is None and fy is None:
        reason = "the focal length is missing: none of fl_x, camera_angle_x, fl_y, camera_angle_y"
        raise FileError(path, reason, where=where, remedy=_EXPORTED)
    fx, fy = (fy if fx is None else fx), (fx if fy is None else fy)
    assert fx is not None and fy is not None
    cx = _number(path, where, values, "cx") if "cx" in values else width / 2
    cy = _number(path, where, values, "cy") if "cy" in values else height / 2
    k = {name: _number(path, where, values, name) if name in values else 0.0 for name in DISTORTION}
    if kind == "OPENCV_FISHEYE":
        return camera_of(path, where, kind, width, height, [fx, fy, cx, cy, k["k1"], k["k2"], k["k3"], k["k4"]])
    if not any(k.values()):
        return camera_of(path, where, "PINHOLE", width, height, [fx, fy, cx, cy])
    numbers = [fx, fy, cx, cy, k["k1"], k["k2"], k["p1"], k["p2"]]
    if not (k["k3"] or k["k4"] or k["k5"] or k["k6"]):
        return camera_of(path, where, "OPENCV", width, height, numbers)
    if k["k4"] or k["k5"] or k["k6"]:
        raise FileError(
            path, "k4 to k6 of a lens that is not a fisheye are not supported", where=where, remedy="Undistort first"
        )
    return camera_of(path, where, "FULL_OPENCV", width, height, [*numbers, k["k3"], 0.0, 0.0, 0.0])


def _focal_length(path: Path, where: str, values: Mapping[str, Any], axis: str, side: int) -> float | None:
    """Focal length of an axis [px], stored or from the field of view, or None."""
    if f"fl_{axis}" in values:
        return _number(path, where, values, f"fl_{axis}")
    name = f"camera_angle_{axis}"
    if name not in values:
        return None
    angle = _number(path, where, values, name)
    if not 0 < angle < np.pi:
        raise FileError(path, f"{name}: expected an angle of view above 0 and below pi, got {angle:g}", where=where)
    return float(0.5 * side / np.tan(0.5 * angle))


def _pose(path: Path, where: str, rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """T_camera_world from a camera-to-world matrix with y up and z back."""
    T = np.eye(4)
    T[: len(rows)] = rows
    try:
        T = check_rigid("the pose", T) @ OPENGL_AXES
    except ValueError as error:
        raise FileError(path, str(error), where=where) from error
    return inv(T)


def _model(
    path: Path,
    names: list[str],
    cameras: list[CameraModel],
    poses: list[NDArray[np.float64]],
    left_out: Sequence[str] = (),
) -> SfmModel:
    try:
        return SfmModel(tuple(names), tuple(cameras), np.array(poses), left_out=tuple(left_out))
    except ValueError as error:
        raise FileError(path, str(error)) from error


def _number(path: Path, where: str, values: Mapping[str, Any], name: str) -> float:
    return float(_numbers(path, where, values, name, 1)[0])


def _side(path: Path, where: str, values: Mapping[str, Any], name: str) -> int:
    value = _number(path, where, values, name)
    if value != round(value):
        raise FileError(path, f"{name}: expected whole pixels, got {value:g}", where=where)
    return int(value)


def _numbers(path: Path, where: str, values: Mapping[str, Any], name: str, count: int | None) -> NDArray[np.float64]:
    """`count` finite numbers of a key, or as stored if None."""
    if name not in values:
        raise FileError(path, f"missing key {name}", where=where, remedy=_EXPORTED)
    try:
        array = np.array(values[name], np.float64)
    except (TypeError, ValueError, OverflowError):
        array = np.full(1, np.nan)
    if isinstance(values[name], str | bool) or not (np.abs(array) <= 1e100).all() or count not in (None, array.size):
        wanted = "numbers" if count is None else f"{count} finite number{'s' * (count != 1)}"
        raise FileError(path, f"{name}: expected {wanted}, got {str(values[name])[:80]}", where=where)
    return array if count is None else array.reshape(-1)
