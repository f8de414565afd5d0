"""Write posed images as transforms.json for nerfstudio, instant-ngp and gsplat."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from pathlib import PurePosixPath
from typing import Any

from ...cameras.camera_models import MODELS, CameraModel
from ...core.atomic import atomic_write
from ...core.checks import check_name
from ...core.errors import FilePath
from ...core.paths import path_of
from ...pcd.cloud import PointCloud
from ..points.point_cloud import write_point_cloud
from .frame_cameras import OPENGL_AXES
from .sfm_model import SfmModel

POINTS = "sparse_pc.ply"  # as nerfstudio calls it
WRITTEN = ("SIMPLE_PINHOLE", "PINHOLE", "SIMPLE_RADIAL", "RADIAL", "OPENCV", "OPENCV_FISHEYE", "FULL_OPENCV")
_SINGLE = {"f": ("fl_x", "fl_y"), "fx": ("fl_x",), "fy": ("fl_y",), "k": ("k1",)}


def write_transforms(path: FilePath, model: SfmModel, *, images: str = "") -> None:
    """Write a model as nerfstudio's transforms.json, with its points in a PLY file beside it.

    Args:
        path: The file, such as "scene/transforms.json". Points go to `sparse_pc.ply` in the same folder.
        model: At least one image.
        images: Folder of the images relative to the file, such as "images".

    Raises:
        TypeError: No SfmModel, or a folder that is no string.
        ValueError: No image, a camera model that the format does not support, or fisheye cameras beside others.
        FileError: The file cannot be written.

    Notes:
        Poses are camera to world with the camera's y up and z back, in the model's frame and unit, with all digits.
        `read_cameras` returns the same model without points. Each file is written atomically, points first.

    Example:
        >>> import json, pathlib, numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
        >>> model = loom.SfmModel(["a.png"], [camera], np.eye(4)[None])
        >>> loom.write_transforms("transforms.json", model, images="images")
        >>> json.loads(pathlib.Path("transforms.json").read_text())["frames"][0]["file_path"]
        'images/a.png'
    """
    path = path_of(path)
    if not isinstance(model, SfmModel):
        raise TypeError(f"model: expected an SfmModel, got {type(model).__name__}")
    if not len(model):
        raise ValueError("model: expected at least one image, got none")
    if not isinstance(images, str) or images:
        check_name("images", images)
    write_content(path, model, images=images)


def write_content(
    path: FilePath,
    model: SfmModel,
    *,
    images: str,
    masks: Sequence[str] | None = None,
    more: Mapping[str, Any] | None = None,
) -> None:
    """`write_transforms` with validated arguments, mask files per image (`masks`) and further keys (`more`)."""
    file_path = path_of(path)
    lenses = [_lens(camera) for camera in model.cameras]
    kinds = sorted({lens["camera_model"] for lens in lenses})
    if len(kinds) > 1:  # nerfstudio reads the first for all images
        raise ValueError(f"model: transforms.json has one kind of camera, got {' and '.join(kinds)}; write two models")
    frames: list[dict[str, Any]] = []
    for name, lens, T in zip(model.names, lenses, model.T_world_camera, strict=True):
        file = str(PurePosixPath(images, *PurePosixPath(name.replace(os.sep, "/")).parts)) if images else name
        frames.append({"file_path": file, **lens, "transform_matrix": (T @ OPENGL_AXES).tolist()})
    for frame, mask in zip(frames, masks or (), strict=False):
        frame["mask_path"] = mask
    content: dict[str, Any] = {"camera_model": lenses[0]["camera_model"], **(more or {}), "frames": frames}
    if len(model.points):
        cloud = PointCloud(model.points, colors=model.colors)
        write_point_cloud(file_path.with_name(POINTS), cloud)
        content["ply_file_path"] = POINTS
    with atomic_write(file_path) as file:
        file.write(json.dumps(content, indent=1, allow_nan=False).encode())


def _lens(camera: CameraModel) -> dict[str, Any]:
    if camera.model not in WRITTEN:
        reason = f"model: transforms.json has no camera model {camera.model}"
        raise ValueError(f"{reason}; undistort the images first, see loom.undistort_image")
    lens: dict[str, Any] = {}
    for name, value in zip(MODELS[camera.model].params.split(", "), camera.params, strict=True):
        for key in _SINGLE.get(name, (name,)):
            lens[key] = value
    if any(lens.pop(name, 0.0) for name in ("k4", "k5", "k6")) and camera.model == "FULL_OPENCV":
        raise ValueError("model: transforms.json has no k4 to k6 of FULL_OPENCV; undistort the images first")
    kind = "OPENCV"
    if camera.model == "OPENCV_FISHEYE":
        kind, lens["k4"] = camera.model, camera.params[7]
    return {"w": camera.width, "h": camera.height, "camera_model": kind, **lens}
