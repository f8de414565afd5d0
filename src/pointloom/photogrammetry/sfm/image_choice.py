"""Preparation of a folder of photographs for structure from motion."""

from __future__ import annotations

import os
from collections import Counter
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from ...core.errors import FileError
from ...core.escaped_text import escaped
from ...core.progress import ReportProgress
from ...core.reports import failed
from ...io.images.image_files import ImageHeader
from ...io.images.photo_files import is_photo, read_exif
from ...io.optional_imports import ignored_errors
from .exif_checks import orientation_warnings
from .frame_choice import FrameChoice
from .frame_picker import is_blank, spaced, thumbnail
from .image_folder import (
    EXIF_UPRIGHT,
    ORIENTATION_TAG,
    list_photographs,
    ordered_names,
    read_header,
    read_image,
    read_lens,
    read_orientation,
    scaled_size,
    unread_images,
    white_of,
)
from .image_writing import Wanted, counted, some_of, write_bytes, write_image

_GRAY_WEIGHTS = np.array([77, 150, 29], np.uint32)  # BT.601 weights, in 256ths
_CHANNEL_BITS = 8
_EXIF_TABLES = (0x8769, 0x8825)  # EXIF tables of lens and GPS
_COPIED_TAGS = (0x010F, 0x0110, 0x0132, *_EXIF_TABLES)  # make, model, time
BLANK = "black, or of one brightness"
_LONGEST_EXIF = 65_000  # bytes. A JPEG segment stores up to 65533
_SUFFIXES = {"jpeg": ".jpg", "png": ".png"}


def choose_images(source: Path, wanted: Wanted, report: ReportProgress) -> FrameChoice:
    paths, second = list_photographs(source)
    chosen = spaced(list(range(len(paths))), wanted.max_count)
    headers, left_out = _headers(paths, chosen)
    usable = [number for number in chosen if number in headers]
    white = white_of([paths[n] for n in usable], [headers[n] for n in usable])
    names, numbers, sizes = [], [], Counter[tuple[int, int]]()
    stems = dict(zip(usable, ordered_names([paths[n] for n in usable]), strict=True))
    for done, number in enumerate(usable):
        report("write", done, len(usable))
        try:
            pixels = read_image(paths[number], headers[number], white=white)
        except FileError as error:
            left_out[paths[number].name] = error.reason
            continue
        if is_blank(thumbnail(_gray(pixels))):
            left_out[paths[number].name] = BLANK
            continue
        name, size = _write(paths[number], headers[number], pixels, stems[number], wanted)
        names.append(name)
        numbers.append(number)
        sizes[size] += 1
    report("write", len(usable), len(usable))
    if not names:
        first, reason = next(iter(left_out.items()))
        raise FileError(source, f"none of {counted(len(paths), 'image')} can be used: {first}: {reason}")
    return FrameChoice(
        source=os.fspath(source),
        kind="images",
        reader="",
        names=tuple(names),
        numbers=tuple(numbers),
        sizes=dict(sizes.most_common()),
        frame_count=len(paths),
        left_out=left_out,
        notes=tuple(
            _notes(source, len(paths), len(chosen), left_out, sizes)
            + duplicate_notes(second)
            + _lenses([paths[n] for n in numbers])
            + orientation_warnings([paths[n] for n in numbers])
        ),
        warnings=failed(_why_unreadable(len(chosen), left_out)),
    )


def _headers(paths: list[Path], numbers: list[int]) -> tuple[dict[int, ImageHeader], dict[str, str]]:
    """The image headers, and the reasons for missing ones. FileError if a package is missing."""
    headers, left_out = {}, {}
    for number in numbers:
        try:
            headers[number] = read_header(paths[number])
        except FileError as error:
            if isinstance(error.__cause__, ImportError):
                raise
            left_out[paths[number].name] = error.reason
    return headers, left_out


def _gray(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    return ((pixels @ _GRAY_WEIGHTS) >> 8).astype(np.uint8)


def _write(
    path: Path, header: ImageHeader, pixels: NDArray[np.uint8], stem: str, wanted: Wanted
) -> tuple[str, tuple[int, int]]:
    before = (pixels.shape[1], pixels.shape[0])
    size = scaled_size(before, wanted.max_size)
    is_plain = not is_photo(path) and header.bits == _CHANNEL_BITS and header.channels in (1, 3)
    if size == before and is_plain and read_orientation(path) == EXIF_UPRIGHT:
        name = stem + _SUFFIXES[header.kind]
        write_bytes(wanted.folder / name, path.read_bytes())
        return name, size
    if size != before:
        pixels = np.asarray(Image.fromarray(pixels).resize(size, Image.Resampling.BOX))
    name = f"{stem}.{wanted.kind}"
    write_image(wanted.folder / name, pixels, _exif_upright(path))
    return name, size


def _exif_upright(path: Path) -> bytes:
    """EXIF data (with the focal length) without the orientation."""
    exif, copied = read_exif(path), Image.Exif()
    exif.pop(ORIENTATION_TAG, None)
    for tag in (
        tag for tag in exif if tag in _COPIED_TAGS or not is_photo(path)
    ):  # other DNG tags describe the pixel layout
        copied[tag] = exif.get_ifd(tag) if tag in _EXIF_TABLES else exif[tag]
    with ignored_errors():  # invalid EXIF is ignored
        data = copied.tobytes() if len(copied) else b""
        return data if len(data) <= _LONGEST_EXIF else b""
    return b""


def duplicate_notes(paths: list[Path]) -> list[str]:
    if not paths:
        return []
    return [f"left out, since the folder also contains a JPEG or PNG of them: {some_of([path.name for path in paths])}"]


def _notes(
    source: Path, count: int, chosen: int, left_out: dict[str, str], sizes: Counter[tuple[int, int]]
) -> list[str]:
    notes = []
    if chosen < count:
        notes.append(f"{chosen} of {count} images are used, evenly spaced in the order of their names (max_frames)")
    if blank := [name for name, reason in left_out.items() if reason == BLANK]:
        notes.append(f"{counted(len(blank), 'image')} {BLANK}, and left out: {some_of(blank)}")
    if others := unread_images(source):
        notes.append(f"left out, since the format is not supported, convert to PNG or JPEG: {some_of(others)}")
    if len(sizes) > 1:
        parts = [f"{number} of {width} x {height}" for (width, height), number in sizes.most_common()]
        notes.append(f"images of {len(sizes)} sizes, each treated as a separate camera: {some_of(parts)}")
    return notes


def _why_unreadable(count: int, left_out: dict[str, str]) -> str | None:
    parts = [f"{name} ({reason})" for name, reason in left_out.items() if reason != BLANK]
    names = escaped(some_of(parts))
    return f"{len(parts)} of {count} images cannot be read and are left out: {names}" if parts else None


def _lenses(paths: list[Path]) -> list[str]:
    count = len({read_lens(path) for path in paths})
    return [f"EXIF contains {count} cameras or focal lengths, each treated as a separate camera"] if count > 1 else []
