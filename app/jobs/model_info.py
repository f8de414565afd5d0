"""What a model of structure from motion holds: COLMAP's folders and Metashape's files, for `pointloom info`."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera_models import CameraModel
from ...core.coordinates import describe_bounds
from ...files.models.colmap import find_colmap_model, read_colmap_model
from ...files.models.metashape import read_metashape_cameras
from ...files.models.sfm_model import SfmModel
from .facts import Cameras, ColmapModel, MetashapeCameras

SHOWN = 20  # cameras, and pictures without a pose, that are listed


def describe_colmap_model(folder: Path) -> ColmapModel:
    """A model of COLMAP in a folder, or below it.

    Raises:
        FileError: Damaged, or several models.
    """
    place, form = find_colmap_model(folder)
    model = read_colmap_model(place)
    below = str(place.relative_to(folder))
    return ColmapModel(
        folder=None if below == "." else below,
        form={"bin": "binary", "txt": "text"}[form],
        views=_describe_cameras(model),
        points=len(model.points),
        observations=len(model.observations),
        mean_views=float(model.view_counts.mean()) if len(model.points) else None,
        mean_error_px=_mean(model.errors),
        bounds=describe_bounds(model.points),
    )


def describe_metashape_file(path: Path) -> MetashapeCameras:
    """Cameras that Metashape exported.

    Raises:
        FileError: No such file.
    """
    model = read_metashape_cameras(path)
    return MetashapeCameras(_describe_cameras(model), _cut(list(model.left_out)) or None)


def _describe_cameras(model: SfmModel) -> Cameras:
    lines = [_camera_line(camera, count) for camera, count in Counter(model.cameras).items()]
    return Cameras(len(model), _cut(lines), describe_bounds(model.centers))


def _camera_line(camera: CameraModel, pictures: int) -> str:
    numbers = ", ".join(f"{value:g}" for value in camera.params)
    many = "" if pictures == 1 else "s"
    return f"{camera.model} {camera.width} x {camera.height}, {numbers}; {pictures} picture{many}"


def _cut(lines: list[str]) -> list[str]:
    rest = len(lines) - SHOWN
    return lines if rest <= 0 else [*lines[:SHOWN], f"and {rest} more"]


def _mean(errors: NDArray[np.float64]) -> float | None:
    known = errors[np.isfinite(errors)]
    return float(known.mean()) if len(known) else None
