"""Folders of photographs: listing, order, orientation, and conversion to 8-bit RGB."""

from __future__ import annotations

import contextlib
import os
import unicodedata
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import restore_folder
from ...core.checks import shown
from ...core.errors import DatasetError, FileError, FilePath
from ...core.paths import path_of
from ...io.images.image_files import ImageHeader, read_color, read_depth, read_image_header
from ...io.images.image_formats import IMAGES, PHOTOS
from ...io.images.photo_files import is_photo, orientation_of, plain_number, read_exif, read_photo, read_photo_header
from ...io.optional_imports import ignored_errors
from ...io.points.scan_files import natural_key

SUFFIXES = IMAGES  # formats for COLMAP
PHOTO_SUFFIXES = (*SUFFIXES, *PHOTOS)  # accepted input formats
# Formats that must be converted first; reported instead of ignored.
OTHER_SUFFIXES = (".bmp", ".gif", ".jp2", ".avif", ".cr2", ".cr3", ".nef", ".arw", ".raf", ".orf", ".rw2")

ORIENTATION_TAG = 0x0112  # EXIF tag
EXIF_UPRIGHT = 1
_MAKE_TAG, _MODEL_TAG, _EXIF_IFD, _FOCAL_TAG, _FOCAL_35, _DIGITAL_ZOOM = 0x010F, 0x0110, 0x8769, 0x920A, 0xA405, 0xA404
_LARGEST_12_BIT = 4095
_LARGEST_8_BIT = 255


def check_path(name: str, value: Any) -> Path:
    path = path_of(value, name)
    if not os.fspath(value) or "\0" in str(path):
        raise ValueError(f"{name}: expected the path of a file or folder, got {shown(value)}")
    return path


def list_images(folder: FilePath, suffixes: Sequence[str] = SUFFIXES) -> list[Path]:
    directory = path_of(folder, "folder")
    restore_folder(directory)
    if not directory.is_dir():
        reason = "is not a folder" if directory.exists() else "does not exist"
        raise DatasetError(folder, reason, remedy="Give a folder of images")
    files = [path for path in directory.iterdir() if not path.name.startswith(".") and path.is_file()]
    images = [path for path in files if path.suffix.lower() in suffixes]
    if not images:
        others = Counter(path.suffix.lower() for path in files if path.suffix.lower() in (*PHOTOS, *OTHER_SUFFIXES))
        others_note = f"; it contains {_counted(others)}, which are not read" if others else ""
        converted = (
            "; photogrammetry.choose_frames does that" if suffixes == SUFFIXES and set(others) & set(PHOTOS) else ""
        )
        remedy = f"Convert them to {', '.join(SUFFIXES)}{converted}"
        raise DatasetError(folder, f"contains no image{others_note}", remedy=remedy)
    return sorted(images, key=natural_key)


def list_photographs(folder: FilePath) -> tuple[list[Path], list[Path]]:
    """The photographs of a folder in natural order, and the second files of others (IMG_1.DNG of IMG_1.JPG)."""
    paths = list_images(folder, PHOTO_SUFFIXES)
    plain = {path.stem.casefold() for path in paths if not is_photo(path)}
    second = [path for path in paths if is_photo(path) and path.stem.casefold() in plain]
    return [path for path in paths if path not in set(second)], second


def read_header(path: FilePath) -> ImageHeader:
    return read_photo_header(path) if is_photo(path) else read_image_header(path)


def unread_images(folder: FilePath) -> list[str]:
    return sorted(path.name for path in path_of(folder, "folder").iterdir() if path.suffix.lower() in OTHER_SUFFIXES)


def _counted(kinds: Counter[str]) -> str:
    return ", ".join(f"{count} of {kind}" for kind, count in sorted(kinds.items()))


def read_orientation(path: FilePath) -> int:
    """EXIF orientation: 1 upright (or unknown), 6 to be rotated right by 90 degrees, and so on."""
    return orientation_of(read_exif(path))


def read_lens(path: FilePath) -> tuple[str, ...]:
    """EXIF's make, model, focal length, 35 mm equivalent, digital zoom ("" if missing), which identify a camera."""
    exif = read_exif(path)
    with ignored_errors():  # invalid EXIF is ignored
        inner = exif.get_ifd(_EXIF_IFD)
        names = [str(exif.get(tag, "")).strip("\0 ") for tag in (_MAKE_TAG, _MODEL_TAG)]
        return (*names, *(plain_number(inner.get(tag)) for tag in (_FOCAL_TAG, _FOCAL_35, _DIGITAL_ZOOM)))
    return ("",) * 5


def upright(pixels: NDArray, orientation: int) -> NDArray:
    rotations = {3: 2, 4: 2, 5: 3, 6: 3, 7: 1, 8: 1}.get(orientation, 0)  # quarter turns to the left
    rotated = np.rot90(pixels, rotations)
    return np.ascontiguousarray(rotated[:, ::-1] if orientation in (2, 4, 5, 7) else rotated)


def is_gray_16(header: ImageHeader) -> bool:
    return header.channels == 1 and header.bits == 16


def read_image(path: FilePath, header: ImageHeader, *, white: int = 65535) -> NDArray[np.uint8]:
    """Read an image as upright 8-bit RGB [h, w, 3]; `white` of 16-bit gray becomes 255."""
    if is_photo(path):
        pixels, orientation = read_photo(path)
    else:
        pixels, orientation = read_depth(path) if is_gray_16(header) else read_color(path), read_orientation(path)
    if pixels.ndim == 2:
        gray = np.minimum(pixels.astype(np.float32) * (_LARGEST_8_BIT / white) + 0.5, _LARGEST_8_BIT)
        pixels = np.repeat(gray.astype(np.uint8)[..., None], 3, axis=2)
    return upright(pixels, orientation)


def read_stored(path: FilePath) -> NDArray[np.uint8]:
    """Read a color image in stored orientation, except HEIC and TIFF, whose decoders rotate."""
    if not is_photo(path):
        return read_color(path)
    pixels, _ = read_photo(path)
    if pixels.dtype != np.uint8:
        raise FileError(path, "expected a color image, got 16-bit gray", remedy="Convert it to 8 bits")
    return np.asarray(pixels, np.uint8)


def white_of(paths: Sequence[Path], headers: Sequence[ImageHeader]) -> int:
    """White level of a set of 16-bit gray images: that of 12 bits if none is brighter."""
    max_value = 0
    for path, header in zip(paths, headers, strict=True):
        if is_gray_16(header):
            with contextlib.suppress(FileError):  # reported when the file is read
                max_value = max(max_value, int((read_photo(path)[0] if is_photo(path) else read_depth(path)).max()))
    return _LARGEST_12_BIT if 0 < max_value <= _LARGEST_12_BIT else 65535


def scaled_size(size: tuple[int, int], max_size: int | None) -> tuple[int, int]:
    longest = max(size)
    if max_size is None or longest <= max_size:
        return size
    width, height = (max(1, round(side * max_size / longest)) for side in size)
    return width, height


def ordered_names(paths: Sequence[Path]) -> list[str]:
    """Unique names that sort in this order, as COLMAP requires. Numbers are prepended if necessary."""
    names = [unicodedata.normalize("NFC", path.stem) for path in paths]
    plain = [name if name.isprintable() and _is_text(name) else "" for name in names]
    in_order = names == sorted(names, key=lambda name: f"{name}.")  # sorted with suffixes
    if all(plain) and in_order and len({name.casefold() for name in names}) == len(names):
        return names
    digits = max(4, len(str(len(names))))
    return [f"{number:0{digits}d}_{name}".rstrip("_") for number, name in enumerate(plain)]


def _is_text(name: str) -> bool:
    try:
        name.encode()
    except UnicodeEncodeError:  # not UTF-8
        return False
    return True
