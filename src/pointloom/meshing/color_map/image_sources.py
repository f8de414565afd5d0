"""Images for texturing, with cameras and poses in any supported form."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...cameras.camera import is_one_camera
from ...cameras.undistortion import Undistortion
from ...core.checks import check_list, check_name
from ...core.errors import FileError
from ...core.masked_arrays import unmasked
from ...core.progress import ReportProgress
from ...io.images.image_files import read_color
from ...io.models.sfm_model import SfmModel
from ...kernels.array_types import Device
from ..mesh.posed_images import Names, PosedImages, check_images

NAMES = Names("images", "cameras", "extrinsics")


def take_images(
    images: Sequence[Any], cameras: Sequence[Any], poses: ArrayLike | None, device: Device, report: ReportProgress
) -> PosedImages:
    """Upload images with a pinhole camera and a pose each. Accepts the arguments of `texture_from_images`. Images of
    an SfmModel are undistorted if necessary."""
    if isinstance(cameras, SfmModel):
        if poses is not None:
            raise ValueError("extrinsics: expected None, because the model contains the poses")
        return _take_model(images, cameras, device, report)
    listed = check_list("images", images, "images")
    if poses is None:
        known = [] if is_one_camera(cameras) else check_list("cameras", cameras, "cameras")
        if not known or not all(hasattr(c, "T_camera_world") and hasattr(c, "intrinsic") for c in known):
            raise ValueError("extrinsics: expected a pose [4, 4] for each image, world to camera, got None")
        poses, cameras = [c.T_camera_world for c in known], [c.intrinsic for c in known]
    taken = []
    for k, image in enumerate(listed):
        report("images", k, len(listed))
        taken.append(read_color(image) if isinstance(image, str | os.PathLike) else image)
    report("images", len(listed), len(listed))
    given = check_list("extrinsics", getattr(poses, "poses", poses), "poses")
    return check_images(NAMES, taken, cameras, given, device)


def _take_model(images: Sequence[Any], model: SfmModel, device: Device, report: ReportProgress) -> PosedImages:
    if not len(model):
        raise ValueError("cameras: expected a model with images, got an empty one")
    listed = (
        _files_of(images, model)
        if isinstance(images, str | os.PathLike)
        else list(check_list("images", images, "images"))
    )
    if len(listed) != len(model):
        raise ValueError(f"images: expected {len(model)}, one per name of the model, got {len(listed)}")
    lenses = {lens: Undistortion(lens, device=device) for lens in dict.fromkeys(model.cameras) if not _is_plain(lens)}
    taken, cameras = [], []
    for k, (image, lens) in enumerate(zip(listed, model.cameras, strict=True)):
        report("images", k, len(listed))
        is_file = isinstance(image, str | os.PathLike)
        pixels = read_color(image) if is_file else np.asarray(unmasked(f"images[{k}]", image))
        if lens in lenses:
            try:
                pixels = lenses[lens].apply(pixels)
            except (TypeError, ValueError) as error:
                raise type(error)(f"images[{k}] ({model.names[k]}): {error}") from error
            cameras.append(lenses[lens].intrinsic)
        else:
            cameras.append(lens.intrinsic)
        taken.append(pixels)
    report("images", len(listed), len(listed))
    return check_images(NAMES, taken, cameras, list(model.T_camera_world), device)


def _is_plain(lens: Any) -> bool:
    return lens.model in ("PINHOLE", "SIMPLE_PINHOLE")


def _files_of(folder: str | os.PathLike[str], model: SfmModel) -> list[Path]:
    root = Path(check_name("images", os.fspath(folder)))
    files = [root / name for name in model.names]
    missing = [file for file in files if not file.is_file()]
    if missing:
        reason = f"does not exist. {len(missing)} of the {len(files)} images of the model are missing"
        raise FileError(missing[0], reason, remedy="Pass the folder that contains the images of the model")
    return files
