"""What a map is aligned to: sparse points of a model, a sensor's depth map, or distances that somebody measured."""

from __future__ import annotations

import dataclasses
import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.camera_models import CameraModel
from ...core.checks import check_name, check_numeric, check_positive, shown
from ...core.errors import FileError
from ...core.paths import path_of
from ...core.wording import few_of
from ...files.models.colmap import read_colmap_model
from ...files.models.sfm_model import SfmModel
from ...files.pictures.image_files import read_depth
from .inputs import Map

SPARSE = "the sparse model"
AXIS = 1e-3  # [rad] about the axis, where a lens bends nothing
NO_DEPTH = 65535  # of maps in whole numbers, beside 0: 7-Scenes' and others'
FORMS = "a sparse model, a depth map [h, w], or distances [n, 3] of u, v and metres; or the path of one"


@dataclasses.dataclass(frozen=True, eq=False)
class References:
    """Depths that are known.

    Args:
        pixels: Where, columns and rows, shape [n, 2] [px].
        depths: Shape [n].
        are_few: Distances measured by hand, of which two may be all there are.
        unit: Of the depths: "m", or "the sparse model's".
        camera: The camera of the picture, where they tell one.
        source: What tells it.
    """

    pixels: NDArray[np.float64]
    depths: NDArray[np.float64]
    are_few: bool = False
    unit: str = "m"
    camera: PinholeCameraIntrinsic | None = None
    source: str = ""


def find_references(align: Any, name: str | None, size: tuple[int, int], depth_scale: float) -> References:
    """The references in a picture.

    Args:
        align: As of `estimate_depth`.
        name: The picture's own, by which a sparse model knows it; None of an array.
        size: Rows and columns of the picture.
        depth_scale: Units a metre of depth maps in whole numbers.

    Raises:
        FileError: A file that cannot be read.
        TypeError, ValueError: None of the forms, or one that does not fit the picture.
    """
    scale = check_positive("depth_scale", depth_scale)
    if isinstance(align, str | os.PathLike):
        align = _read(Path(align))
    if isinstance(align, tuple) and len(align) == 2 and isinstance(align[0], SfmModel):
        align, name = align[0], check_name("align", align[1])
    if isinstance(align, SfmModel):
        return _of_model(align, name, size)
    array = check_numeric("align", align)
    if array.ndim != 2 or 0 in array.shape:
        raise ValueError(f"align: expected {FORMS}, got {shown(align)} of shape {list(array.shape)}")
    return _of_distances(array, size) if array.shape[1] == 3 else _of_sensor(array, size, scale)


def _read(path: Path) -> Any:
    if path.is_dir():
        return read_colmap_model(path)
    suffix = path.suffix.lower()
    if suffix in (".png", ".npy"):
        return read_depth(path)
    if suffix in (".txt", ".csv"):
        return read_distances(path)
    remedy = "Use .png or .npy (a depth map), .txt or .csv (u v metres), or the folder of a COLMAP model"
    raise FileError(path, f"unknown extension {suffix!r}", remedy=remedy)


def read_distances(path: str | os.PathLike[str]) -> NDArray[np.float64]:
    """Lines of column, row and metres, apart by spaces or commas; a first line of names and # comments are passed over.

    Raises:
        FileError: Unreadable, or a line of something else.
    """
    try:
        lines = path_of(path).read_text("utf-8").splitlines()
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    except UnicodeDecodeError as error:
        raise FileError(path, "no text", where=f"byte {error.start}") from error
    rows: list[list[float]] = []
    for number, line in enumerate(lines, 1):
        words = line.split("#", 1)[0].replace(",", " ").split()
        if not words or (not rows and [word.lower() for word in words] in _HEADS):
            continue
        try:
            rows.append([float(word) for word in words])
        except ValueError:
            rows.append([])
        if len(rows[-1]) != 3:
            raise FileError(path, f"expected u v metres, got {line[:60]!r}", where=f"line {number}")
    if not rows:
        raise FileError(path, "holds no distances", remedy="Write a line of u v metres for each")
    return np.array(rows)


_HEADS = (["u", "v", "metres"], ["u", "v", "meters"], ["u", "v", "m"], ["x", "y", "metres"], ["u", "v", "depth"])


def _of_distances(array: NDArray[Any], size: tuple[int, int]) -> References:
    rows = array.astype(np.float64)
    if not (np.isfinite(rows).all() and (rows[:, 2] > 0).all() and (rows[:, 2] < 1e30).all()):
        raise ValueError("align: expected finite pixels and distances above 0, one row of u, v and metres each")
    outside = ~_inside(rows[:, :2], size)
    if outside.any():
        u, v, _ = rows[outside][0]
        raise ValueError(f"align: pixel ({u:g}, {v:g}) lies outside the picture of {size[1]} x {size[0]}")
    return References(rows[:, :2], rows[:, 2], are_few=True)


def _of_sensor(array: NDArray[Any], size: tuple[int, int], depth_scale: float) -> References:
    _check_shape("the depth map", array.shape[1], array.shape[0], size)
    depth = array.astype(np.float64) / (1.0 if array.dtype.kind == "f" else depth_scale)
    if array.dtype.kind != "f":
        depth[array == NO_DEPTH] = 0
    with np.errstate(invalid="ignore"):
        rows, columns = np.nonzero(np.isfinite(depth) & (depth > 1e-30) & (depth < 1e30))
    pixels = _scaled(np.stack([columns, rows], 1).astype(np.float64), array.shape[1], array.shape[0], size)
    return References(pixels, depth[rows, columns])


def _of_model(model: SfmModel, name: str | None, size: tuple[int, int]) -> References:
    """The points that a picture of a sparse model observes, where they lie in it."""
    if name is None:
        raise ValueError("align: a sparse model knows pictures by name; give the picture's path, or (model, name)")
    number = _number_of(model, name)
    camera, T = model.cameras[number], model.T_camera_world[number]
    _check_shape("the model's picture", camera.width, camera.height, size)
    seen = np.unique(model.observations[model.observations[:, 0] == number, 1])
    points = model.points[seen] @ T[:3, :3].T + T[:3, 3]
    pixels = _scaled(camera.project(points), camera.width, camera.height, size)
    kept = np.isfinite(pixels).all(1) & _inside(pixels, size)
    source = SPARSE if camera.is_pinhole else f"{SPARSE}, its distortion left out"
    return References(
        pixels[kept], points[kept, 2], unit=f"{SPARSE}'s", camera=_pinhole_of(camera, size), source=source
    )


def _number_of(model: SfmModel, name: str) -> int:
    if name in model.names:
        return model.index_of(name)
    matches = [number for number, other in enumerate(model.names) if Path(other).name == name]
    if len(matches) != 1:
        raise ValueError(
            f"align: the model has {len(matches) or 'no'} pictures {name!r}; it has {few_of(model.names, 3) or 'none'}"
        )
    return matches[0]


def _pinhole_of(camera: CameraModel, size: tuple[int, int]) -> PinholeCameraIntrinsic:
    ahead, right, left, below, above = camera.project(
        [[0, 0, 1], [AXIS, 0, 1], [-AXIS, 0, 1], [0, AXIS, 1], [0, -AXIS, 1]]
    )
    focal = np.array([right[0] - left[0], below[1] - above[1]]) / (2 * AXIS)
    if camera.is_pinhole:
        exact = camera.intrinsic
        focal = np.array([exact.fx, exact.fy])
    fx, fy = focal * (size[1] / camera.width, size[0] / camera.height)
    cx, cy = _scaled(ahead[None], camera.width, camera.height, size)[0]
    return PinholeCameraIntrinsic(size[1], size[0], fx, fy, cx, cy)


def _check_shape(what: str, width: int, height: int, size: tuple[int, int]) -> None:
    if abs(width * size[0] - height * size[1]) > max(width, height, *size):
        is_turned = (width - height) * (size[1] - size[0]) < 0
        turned = "; if EXIF turned the picture upright, turn this too" if is_turned else ""
        raise ValueError(
            f"align: {what} is {width} x {height}, of another shape than the picture, {size[1]} x {size[0]}{turned}"
        )


def _scaled(pixels: NDArray[np.float64], width: int, height: int, size: tuple[int, int]) -> NDArray[np.float64]:
    return (pixels + 0.5) * (size[1] / width, size[0] / height) - 0.5


def _inside(pixels: NDArray[np.float64], size: tuple[int, int]) -> NDArray[np.bool_]:
    return (pixels >= -0.5).all(1) & (pixels[:, 0] <= size[1] - 0.5) & (pixels[:, 1] <= size[0] - 0.5)


def sample(values: Map, pixels: NDArray[np.float64]) -> NDArray[np.float64]:
    """A map between its pixels, linearly; beyond the outer ones it goes on as they are."""
    height, width = values.shape
    u, v = np.clip(pixels[:, 0], 0, width - 1), np.clip(pixels[:, 1], 0, height - 1)
    left, top = np.minimum(u.astype(np.int64), max(width - 2, 0)), np.minimum(v.astype(np.int64), max(height - 2, 0))
    right, bottom = np.minimum(left + 1, width - 1), np.minimum(top + 1, height - 1)
    a, b = u - left, v - top
    upper = values[top, left] * (1 - a) + values[top, right] * a
    return upper * (1 - b) + (values[bottom, left] * (1 - a) + values[bottom, right] * a) * b
