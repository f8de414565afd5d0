"""What a model of structure from motion holds: COLMAP's folders and Metashape's files, for `pointloom info`."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera_models import CameraModel
from ...core.coordinates import describe_bounds
from ...files.models.colmap import find_colmap_model, read_colmap_model
from ...files.models.metashape import read_metashape_cameras
from ...files.models.sfm_model import SfmModel

SHOWN = 20  # cameras, and pictures without a pose, that are listed


def describe_colmap_model(folder: Path) -> dict[str, Any]:
    """A model of COLMAP in a folder, or below it, in JSON's types.

    Raises:
        FileError: Damaged, or several models.
    """
    place, form = find_colmap_model(folder)
    model = read_colmap_model(place)
    below = str(place.relative_to(folder))
    return {
        "kind": "COLMAP model",
        "folder": None if below == "." else below,
        "form": {"bin": "binary", "txt": "text"}[form],
        **_describe_cameras(model),
        "points": len(model.points),
        "observations": len(model.observations),
        "mean_views": float(model.view_counts.mean()) if len(model.points) else None,
        "mean_error_px": _mean(model.errors),
        "bounds": describe_bounds(model.points),
        "unit": "arbitrary, unless the model was scaled",
    }


def describe_metashape_file(path: Path) -> dict[str, Any]:
    """Cameras that Metashape exported, in JSON's types.

    Raises:
        FileError: No such file.
    """
    model = read_metashape_cameras(path)
    left_out = _cut(list(model.left_out))
    return {"kind": "Metashape cameras", **_describe_cameras(model), "left_out": left_out or None}


def _describe_cameras(model: SfmModel) -> dict[str, Any]:
    counts = Counter(model.cameras)
    return {
        "pictures": len(model),
        "cameras": _cut([_camera_line(camera, count) for camera, count in counts.items()]),
        "camera_bounds": describe_bounds(model.centers),
    }


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
