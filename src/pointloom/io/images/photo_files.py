"""Photographs as HEIC (pi-heif or pillow-heif), TIFF, WebP (Pillow) and DNG (rawpy): `pip install "pointloom[photos]"`.

Raw decoders fill missing data with black, so the extents of TIFF and DNG strips and tiles are checked first. Color
profiles are not applied. TIFF 6.0 (Adobe 1992). DNG specification, chapter 4 (SubIFDs).
"""

from __future__ import annotations

import contextlib
import importlib
import io
import math
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, TiffImagePlugin, WebPImagePlugin

from ...core.errors import FileError, FilePath
from ...core.paths import input_path
from ..optional_imports import foreign_errors, ignored_errors, import_for
from .image_files import PIXEL_LIMIT, ImageHeader
from .image_formats import PHOTOS

_MAGIC = {b"II*\0": "<", b"MM\0*": ">"}
# Bytes of each type.
_TIFF_SIZES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 6: 1, 7: 1, 8: 2, 9: 4, 10: 8, 11: 4, 12: 8, 13: 4}
_TIFF_INTEGERS = {1: "B", 3: "H", 4: "I", 13: "I"}
_TIFF_PARTS = ((273, 279), (324, 325))  # offsets and lengths of strips, of tiles
_TIFF_SUB_IFDS = 330  # directories below one
_MAX_DIRECTORIES = 64  # directories: a DNG has about five. More, or a cycle, is damage
_AGAIN = "Fetch or write the file again"


def check_extents(path: FilePath, data: bytes) -> None:
    order = _MAGIC.get(data[:4])
    if order is None:
        raise FileError(path, "is not a DNG file", where="byte 0", remedy="Convert it to PNG or JPEG")
    try:
        for entries in _directories(data, order):
            for offsets, lengths in _TIFF_PARTS:
                for start, count in zip(entries.get(offsets, ()), entries.get(lengths, ()), strict=False):
                    if start + count > len(data):
                        raise FileError(path, f"cut off: {len(data)} bytes, of {start + count}", remedy=_AGAIN)
    except (struct.error, IndexError, ValueError) as error:
        if isinstance(error, FileError):
            raise
        raise FileError(path, "cut off or damaged: its directory is invalid", remedy=_AGAIN) from error


def _directories(data: bytes, order: str) -> Iterator[dict[int, tuple[int, ...]]]:
    waiting, seen = [struct.unpack_from(f"{order}I", data, 4)[0]], set[int]()
    while waiting:
        offset = waiting.pop()
        if not offset or offset in seen:
            continue
        seen.add(offset)
        if len(seen) > _MAX_DIRECTORIES:
            raise ValueError("too many directories")
        (count,) = struct.unpack_from(f"{order}H", data, offset)
        entries = dict(_entry(data, order, offset + 2 + 12 * k) for k in range(count))
        waiting += [*struct.unpack_from(f"{order}I", data, offset + 2 + 12 * count), *entries.get(_TIFF_SUB_IFDS, ())]
        yield entries


def _entry(data: bytes, order: str, offset: int) -> tuple[int, tuple[int, ...]]:
    """The tag of an entry and its integers. None for other types."""
    tag, kind, count = struct.unpack_from(f"{order}HHI", data, offset)
    if kind not in _TIFF_INTEGERS or tag not in (_TIFF_SUB_IFDS, *(tag for pair in _TIFF_PARTS for tag in pair)):
        return tag, ()
    size = _TIFF_SIZES[kind] * count
    where = offset + 8 if size <= 4 else struct.unpack_from(f"{order}I", data, offset + 8)[0]
    return tag, struct.unpack_from(f"{order}{count}{_TIFF_INTEGERS[kind]}", data, where)


EXTRA = "photos"

_ORIENTATION_TAG, _EXIF_IFD = 0x0112, 0x8769  # EXIF tags: orientation, offset of further tags
_DEEP_GRAY = ("I;16", "I;16B", "I;16L", "I;16N")
_NUMBERS = ("F", "I", "LAB")  # Pillow modes that are no colors or cannot be converted to RGB


def is_photo(path: FilePath) -> bool:
    return Path(path).suffix.lower() in PHOTOS


def read_photo_header(path: FilePath) -> ImageHeader:
    kind = PHOTOS[Path(path).suffix.lower()]
    if kind == "dng":
        with _opened_raw(path) as raw:
            sizes = raw.sizes
            return _checked(path, ImageHeader(kind, sizes.width, sizes.height, 3, 8))
    with _opened(path, kind) as image:
        return _header_of(path, kind, image)


def read_photo(path: FilePath) -> tuple[NDArray[np.uint8] | NDArray[np.uint16], int]:
    """Pixels, uint8 (h, w, 3) or uint16 gray (h, w), and the remaining EXIF orientation. HEIC is upright."""
    kind = PHOTOS[Path(path).suffix.lower()]
    if kind == "dng":
        return _develop(path), orientation_of(read_exif(path))
    with _opened(path, kind) as image:
        _header_of(path, kind, image)
        with foreign_errors(path, "damaged image"):
            image.load()  # makes a TIFF upright and clears its orientation
        orientation = _stored_orientation(image)
        if image.mode in _DEEP_GRAY:
            return np.array(image).astype(np.uint16), orientation
        image.info.pop("transparency", None)
        return np.array(image.convert("RGB")), orientation


def read_alpha(path: FilePath) -> NDArray[np.uint8] | None:
    """The alpha of a TIFF or WebP image in the layout of `read_photo`, shape (h, w), or None."""
    kind = PHOTOS[Path(path).suffix.lower()]
    if kind == "dng":
        return None
    with _opened(path, kind) as image:
        _header_of(path, kind, image)
        if image.mode not in ("RGBA", "LA", "PA"):
            return None
        with foreign_errors(path, "damaged image"):
            return np.array(image.convert("RGBA"))[..., 3]


def read_exif(path: FilePath) -> Image.Exif:
    """The EXIF data of an image, empty if missing or invalid. Orientation matches `read_photo`, so HEIC is upright."""
    path = input_path(path)
    kind = PHOTOS.get(path.suffix.lower())
    exif = Image.Exif()
    # EXIF is often invalid. Such values are ignored
    with ignored_errors():
        if kind in ("dng", "tiff"):  # EXIF's own types
            exif.load(b"Exif\0\0" + path.read_bytes())
            exif.get_ifd(_EXIF_IFD)
            if kind == "tiff":
                exif.pop(_ORIENTATION_TAG, None)  # Pillow rotates the pixels
        elif kind is None:
            with Image.open(path) as image:
                exif = image.getexif()
                exif.get_ifd(_EXIF_IFD)  # while the file is open
        else:
            with _opened(path, kind) as image:
                exif = image.getexif()
                exif.get_ifd(_EXIF_IFD)
    return exif


def orientation_of(exif: Image.Exif) -> int:
    """The EXIF orientation. 1 if upright or unknown."""
    with ignored_errors():
        orientation = int(exif.get(_ORIENTATION_TAG, 1))
        return orientation if 1 <= orientation <= 8 else 1
    return 1


def _stored_orientation(image: Image.Image) -> int:
    with ignored_errors():  # invalid EXIF is ignored
        return orientation_of(image.getexif())
    return 1


def plain_number(value: Any) -> str:
    """An EXIF number with four digits; "" if invalid or 0 (unknown)."""
    try:
        number = float(value)
    except (TypeError, ValueError, ZeroDivisionError):
        return ""
    return f"{number:.4g}" if 0 < number < math.inf else ""


def _header_of(path: FilePath, kind: str, image: Image.Image) -> ImageHeader:
    if image.mode in _NUMBERS:
        reason = f"expected an image of 8 or 16 bits, got one of mode {image.mode}"
        raise FileError(path, reason, remedy="Convert it to PNG or JPEG")
    is_deep = image.mode in _DEEP_GRAY
    channels = 1 if image.mode in ("L", "1", *_DEEP_GRAY) else 3
    return _checked(path, ImageHeader(kind, *image.size, channels, 16 if is_deep else 8))


def _checked(path: FilePath, header: ImageHeader) -> ImageHeader:
    if not 0 < header.width * header.height <= PIXEL_LIMIT:
        reason = f"expected 1 to {PIXEL_LIMIT} pixels, got {header.width} x {header.height}"
        raise FileError(path, reason, where="header")
    return header


def _opened(path: FilePath, kind: str) -> Any:
    """An image opened by its format class from bytes, for `with`."""
    plugins = {"tiff": TiffImagePlugin.TiffImageFile, "webp": WebPImagePlugin.WebPImageFile}
    plugin = plugins.get(kind) or _heif(path).HeifImageFile
    with foreign_errors(path, "damaged image, or of another type"):
        return plugin(io.BytesIO(_bytes_of(path)))


def _heif(path: FilePath) -> Any:
    for name in ("pi_heif", "pillow_heif"):
        with contextlib.suppress(ImportError):
            return importlib.import_module(name)
    return import_for(path, "pi_heif", EXTRA)


def _bytes_of(path: FilePath) -> bytes:
    try:
        data = input_path(path).read_bytes()
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    if not data:
        raise FileError(path, "empty", where="byte 0", remedy="Fetch or write the file again")
    return data


def _opened_raw(path: FilePath) -> Any:
    rawpy = import_for(path, "rawpy", EXTRA)
    data = _bytes_of(path)
    check_extents(path, data)
    with foreign_errors(path, "damaged image, or of another type"):
        return rawpy.imread(io.BytesIO(data))


def _develop(path: FilePath) -> NDArray[np.uint8]:
    """A raw image as 8-bit colors with the camera's white balance, without auto-brightness, orientation as stored."""
    with _opened_raw(path) as raw, foreign_errors(path, "damaged image"):
        return raw.postprocess(use_camera_wb=True, user_flip=0, no_auto_bright=True, output_bps=8)
