"""Pictures as networks see them: upright, 8 bits, three colours; and the focal length that a camera wrote into them."""

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
from ...core.paths import path_of
from ...files.foreign import ignored_errors
from ...files.pictures.image_files import PIXEL_LIMIT, read_color, read_depth, read_picture_header

SUFFIXES = (".png", ".jpg", ".jpeg")
FIELD_OF_VIEW = 60.0  # [degrees] across the longer side: a telephone's main camera has 60 to 70

_ORIENTATION, _EXIF_IFD = 0x0112, 0x8769
_FOCAL_35MM, _FOCAL_MM, _PLANE_X, _PLANE_UNIT, _PIXELS_X = 0xA405, 0x920A, 0xA20E, 0xA210, 0xA002
_DIAGONAL_35MM = math.hypot(36.0, 24.0)  # [mm] of the film that equivalent focal lengths are told for
_MILLIMETRES = {2: 25.4, 3: 10.0, 4: 1.0, 5: 0.001}  # of the unit of focal plane resolutions

# What turns a picture upright, by EXIF's orientation: first mirrored left to right or not, then quarter turns.
_TURNS = {2: (True, 0), 3: (False, 2), 4: (True, 2), 5: (True, 1), 6: (False, 3), 7: (True, 3), 8: (False, 1)}


@dataclasses.dataclass(frozen=True, eq=False)
class Photo:
    """A picture for a network.

    Args:
        color: Red, green and blue, uint8 [h, w, 3], upright.
        name: Of its file; None of an array.
        focal: Focal length that its file tells [px], or None.
        is_turned: It lay on its side in the file, so that rows and columns are exchanged.
    """

    color: NDArray[np.uint8]
    name: str | None = None
    focal: float | None = None
    is_turned: bool = False


def take_photo(picture: Any) -> Photo:
    """A picture from a file or an array.

    Args:
        picture: The path of a PNG or JPEG file, whose EXIF orientation is applied; or an array, uint8 or uint16, of
            shape [h, w], [h, w, 3] or [h, w, 4]. Transparency is dropped, 16 bits become 8 over their whole range.

    Raises:
        FileError: A file that cannot be read.
        TypeError, ValueError: An array of another type or shape.
    """
    if isinstance(picture, str | os.PathLike):
        return _read_photo(picture)
    array = check_numeric("picture", picture)
    if array.dtype.newbyteorder("=") not in (np.uint8, np.uint16):
        raise TypeError(f"picture: expected a path or an array of uint8 or uint16, got {_kind(picture, array)}")
    if array.ndim not in (2, 3) or 0 in array.shape or (array.ndim == 3 and array.shape[2] not in (1, 3, 4)):
        raise ValueError(f"picture: expected shape [h, w], [h, w, 3] or [h, w, 4], got {list(array.shape)}")
    if array.shape[0] * array.shape[1] > PIXEL_LIMIT:
        raise ValueError(f"picture: expected at most {PIXEL_LIMIT} pixels, got shape {list(array.shape)}")
    return Photo(_three_colors(array))


def _kind(picture: Any, array: NDArray[Any]) -> str:
    return f"an array of {array.dtype}" if isinstance(picture, np.ndarray) else shown(picture)


def _three_colors(array: NDArray[Any]) -> NDArray[np.uint8]:
    if array.dtype.itemsize == 2:
        array = (array.astype(np.uint32) + 128) // 257
    if array.ndim == 2:
        array = array[..., None]
    color = array[..., :3] if array.shape[2] > 1 else np.repeat(array, 3, axis=2)
    return np.ascontiguousarray(color, np.uint8)


def _read_photo(path: str | os.PathLike[str]) -> Photo:
    header = read_picture_header(path)
    is_deep_grey = header.channels == 1 and header.bits == 16
    color = _three_colors(read_depth(path)) if is_deep_grey else read_color(path)
    tags = _exif_tags(path, header.kind)
    mirror, turns = _TURNS.get(tags.get(_ORIENTATION, 1), (False, 0))
    height, width = color.shape[:2]
    upright = np.rot90(color[:, ::-1] if mirror else color, turns)
    focal = _exif_focal(tags, width, height)
    return Photo(np.ascontiguousarray(upright), Path(path).name, focal, turns % 2 == 1)


def _exif_tags(path: Any, kind: str) -> dict[int, Any]:
    """What a camera wrote into a picture; nothing where that is damaged, since the pixels are right without it."""
    plugin = PngImagePlugin.PngImageFile if kind == "png" else JpegImagePlugin.JpegImageFile
    with ignored_errors(), path_of(path).open("rb") as file, plugin(file) as picture:
        exif = picture.getexif()
        return {**exif, **exif.get_ifd(_EXIF_IFD)}
    return {}


def _exif_focal(tags: dict[int, Any], width: int, height: int) -> float | None:
    """The focal length [px]: the equivalent on film by the diagonal, else by the size of the sensor's pixels.

    A picture that was scaled keeps its diagonal's share; the sensor's pixels say something only of the size that the
    camera wrote.
    """
    equivalent = _positive(tags.get(_FOCAL_35MM))
    if equivalent is not None:
        return equivalent / _DIAGONAL_35MM * math.hypot(width, height)
    focal, density = _positive(tags.get(_FOCAL_MM)), _positive(tags.get(_PLANE_X))
    unit = _MILLIMETRES.get(tags.get(_PLANE_UNIT, 2))
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
    """The camera that a picture was taken with as far as it tells, and where that comes from."""
    height, width = photo.color.shape[:2]
    focal, source = photo.focal, "EXIF"
    if focal is None or not 0.2 < focal / max(width, height) < 50:  # 136 and 1 degrees: else somebody made it up
        focal = max(width, height) / 2 / math.tan(math.radians(FIELD_OF_VIEW / 2))
        source = f"assumed {FIELD_OF_VIEW:g} degrees"
    return PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2), source
