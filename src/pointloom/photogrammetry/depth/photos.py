"""Network input images: upright, 8 bit, RGB; and their EXIF focal length."""

from __future__ import annotations

import dataclasses
import math
import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import JpegImagePlugin, PngImagePlugin

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_numeric, shown
from ...core.errors import FilePath
from ...core.paths import input_path
from ...io.images.image_files import PIXEL_LIMIT, read_color, read_depth, read_image_header
from ...io.optional_imports import ignored_errors

FIELD_OF_VIEW = 60.0  # [degrees] across the longer side: phone main cameras have 60 to 70

_ORIENTATION_TAG, _EXIF_IFD = 0x0112, 0x8769
_FOCAL_35MM, _FOCAL_MM, _PLANE_X, _PLANE_UNIT, _PIXELS_X = 0xA405, 0x920A, 0xA20E, 0xA210, 0xA002
_DIAGONAL_35MM = math.hypot(36.0, 24.0)  # [mm] 35 mm film, for equivalent focal lengths
_MILLIMETERS_PER_UNIT = {2: 25.4, 3: 10.0, 4: 1.0, 5: 0.001}  # unit of focal plane resolutions

# EXIF orientations as (mirror left to right, quarter turns).
_EXIF_ROTATIONS = {2: (True, 0), 3: (False, 2), 4: (True, 2), 5: (True, 1), 6: (False, 3), 7: (True, 3), 8: (False, 1)}


@dataclasses.dataclass(frozen=True, eq=False)
class Photo:
    """An upright image, uint8 [h, w, 3], with its EXIF focal length [px]; `is_rotated`: rows and columns swapped."""

    color: NDArray[np.uint8]
    name: str | None = None
    focal: float | None = None
    is_rotated: bool = False


def take_photo(image: Any) -> Photo:
    """Load an image from a file or an array. Drops transparency, and converts 16 bits to 8 over their full range."""
    if isinstance(image, str | os.PathLike):
        return _read_photo(image)
    array = check_numeric("image", image)
    if array.dtype.newbyteorder("=") not in (np.uint8, np.uint16):
        raise TypeError(f"image: expected a path or an array of uint8 or uint16, got {_kind(image, array)}")
    if array.ndim not in (2, 3) or 0 in array.shape or (array.ndim == 3 and array.shape[2] not in (1, 3, 4)):
        raise ValueError(f"image: expected shape [h, w], [h, w, 3] or [h, w, 4], got {list(array.shape)}")
    if array.shape[0] * array.shape[1] > PIXEL_LIMIT:
        raise ValueError(f"image: expected at most {PIXEL_LIMIT} pixels, got shape {list(array.shape)}")
    return Photo(_three_colors(array))


def _kind(image: Any, array: NDArray[Any]) -> str:
    return f"an array of {array.dtype}" if isinstance(image, np.ndarray) else shown(image)


def _three_colors(array: NDArray[Any]) -> NDArray[np.uint8]:
    if array.dtype.itemsize == 2:
        array = (array.astype(np.uint32) + 128) // 257
    if array.ndim == 2:
        array = array[..., None]
    color = array[..., :3] if array.shape[2] > 1 else np.repeat(array, 3, axis=2)
    return np.ascontiguousarray(color, np.uint8)


def _read_photo(path: FilePath) -> Photo:
    header = read_image_header(path)
    is_deep_gray = header.channels == 1 and header.bits == 16
    color = _three_colors(read_depth(path)) if is_deep_gray else read_color(path)
    tags = _exif_tags(path, header.kind)
    mirror, rotations = _EXIF_ROTATIONS.get(tags.get(_ORIENTATION_TAG, 1), (False, 0))
    height, width = color.shape[:2]
    upright = np.rot90(color[:, ::-1] if mirror else color, rotations)
    focal = _exif_focal(tags, width, height)
    return Photo(np.ascontiguousarray(upright), Path(path).name, focal, rotations % 2 == 1)


def _exif_tags(path: FilePath, kind: str) -> dict[int, Any]:
    """EXIF tags. Empty if damaged, since the pixels are still valid."""
    plugin = PngImagePlugin.PngImageFile if kind == "png" else JpegImagePlugin.JpegImageFile
    with ignored_errors(), input_path(path).open("rb") as file, plugin(file) as image:
        exif = image.getexif()
        return {**exif, **exif.get_ifd(_EXIF_IFD)}
    return {}


def _exif_focal(tags: dict[int, Any], width: int, height: int) -> float | None:
    """Focal length [px] by the 35 mm equivalent and the diagonal, else by the pixel pitch (at original size)."""
    equivalent = _positive(tags.get(_FOCAL_35MM))
    if equivalent is not None:
        return equivalent / _DIAGONAL_35MM * math.hypot(width, height)
    focal, density = _positive(tags.get(_FOCAL_MM)), _positive(tags.get(_PLANE_X))
    unit = _MILLIMETERS_PER_UNIT.get(tags.get(_PLANE_UNIT, 2))
    if focal is None or density is None or unit is None or tags.get(_PIXELS_X) != width:
        return None
    return focal * density / unit


def _positive(value: Any) -> float | None:
    try:
        number = float(value)
    except (TypeError, ValueError, ZeroDivisionError, OverflowError):
        return None
    return number if math.isfinite(number) and number > 0 else None


def camera_of(photo: Photo) -> tuple[PinholeCameraIntrinsic, str]:
    height, width = photo.color.shape[:2]
    focal, source = photo.focal, "EXIF"
    if focal is None or not 0.2 < focal / max(width, height) < 50:  # 136 and 1 degrees: implausible otherwise
        focal = max(width, height) / 2 / math.tan(math.radians(FIELD_OF_VIEW / 2))
        source = f"assumed {FIELD_OF_VIEW:g} degrees"
    return PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2), source
