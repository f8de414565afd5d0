"""Consistency of EXIF: focal lengths and orientations that contradict other tags are rejected."""

from __future__ import annotations

import math
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from ...core.errors import FilePath
from ...io.images.photo_files import plain_number, read_exif
from ...io.optional_imports import ignored_errors
from .image_folder import ORIENTATION_TAG, read_header
from .image_writing import counted, some_of

# Plausible focal lengths over the longer side: a hemispherical fisheye has 0.3, mapping accepts up to 10 (360 mm on 35
# mm film).
MIN_RELATIVE_FOCAL, MAX_RELATIVE_FOCAL = 0.2, 10.0
SMALLEST_SENSOR, LARGEST_SENSOR = 2.0, 60.0  # [mm] across
MAX_APART = 1.6  # maximum factor between two tags: crops and 35 mm conventions differ by less
FILM_DIAGONAL = math.hypot(36.0, 24.0)  # [mm]

_EXIF_IFD, _FOCAL_TAG, _FOCAL_35_TAG, _DIGITAL_ZOOM_TAG = 0x8769, 0x920A, 0xA405, 0xA404
_X_RESOLUTION_TAG, _RESOLUTION_UNIT_TAG, _WIDTH_TAG, _HEIGHT_TAG = 0xA20E, 0xA210, 0xA002, 0xA003
_MILLIMETERS_PER_UNIT = {2: 25.4, 3: 10.0, 4: 1.0, 5: 0.001}  # resolution units: inch, cm, mm, um
_TRANSPOSED_ORIENTATIONS = range(5, 9)  # orientations that swap width and height


def focal_problem(path: FilePath, size: tuple[int, int]) -> str | None:
    """Why EXIF's focal length is rejected for an image of this size [px]. None if accepted or missing."""
    inner = _inner(path)
    focal, film, zoom = (_number(inner, tag) for tag in (_FOCAL_TAG, _FOCAL_35_TAG, _DIGITAL_ZOOM_TAG))
    longer, diagonal = max(size), math.hypot(*size)
    by_film = None if film is None else film / FILM_DIAGONAL * diagonal
    sensor = _sensor_of(inner)
    if by_film is not None and not MIN_RELATIVE_FOCAL <= by_film / longer <= MAX_RELATIVE_FOCAL:
        return f"its 35 mm equivalent of {film:g} mm is {by_film:.0f} px, which no lens has"
    if focal is None or sensor is None:
        return None
    is_sensor = SMALLEST_SENSOR <= sensor <= LARGEST_SENSOR
    if not is_sensor:  # the 35 mm equivalent suffices
        return None if by_film is not None else f"the sensor would be {sensor:.3g} mm wide"
    by_sensor = focal / sensor * longer
    if by_film is None:
        is_plausible = MIN_RELATIVE_FOCAL <= by_sensor / longer <= MAX_RELATIVE_FOCAL
        return None if is_plausible else f"{focal:g} mm over a sensor of {sensor:.3g} mm"
    apart = by_film / (by_sensor * max(zoom or 1.0, 1.0))
    if not 1 / MAX_APART <= apart <= MAX_APART:
        return f"its 35 mm equivalent is {by_film:.0f} px, but by the sensor size it is {by_sensor:.0f} px"
    return None


def _sensor_of(inner: dict[int, Any]) -> float | None:
    across, width, unit = (_number(inner, tag) for tag in (_X_RESOLUTION_TAG, _WIDTH_TAG, _RESOLUTION_UNIT_TAG))
    step = _MILLIMETERS_PER_UNIT.get(int(unit)) if unit is not None else 25.4
    return None if across is None or width is None or step is None else width / across * step


def orientation_warnings(paths: Iterable[Path]) -> list[str]:
    unknown, swapped = [], []
    for path in paths:
        exif = read_exif(path)
        value: Any = exif.get(ORIENTATION_TAG, 1)
        if not isinstance(value, int) or not 0 <= value <= 8:
            unknown.append(path.name)
        elif value in _TRANSPOSED_ORIENTATIONS:
            with ignored_errors():
                inner, header = _inner(path), read_header(path)
                stated_size = _number(inner, _WIDTH_TAG), _number(inner, _HEIGHT_TAG)
                if stated_size == (header.height, header.width) and header.width != header.height:
                    swapped.append(path.name)
    notes = []
    if unknown:
        message = f"EXIF of {counted(len(unknown), 'image')} contains an invalid orientation"
        notes.append(f"{message}, so they are used as stored: {some_of(unknown)}")
    if swapped:
        message = "rotated as stated by EXIF, although its image size suggests that they were rotated before"
        notes.append(f"{counted(len(swapped), 'image')} {message}: {some_of(swapped)}")
    return notes


def _inner(path: FilePath) -> dict[int, Any]:
    with ignored_errors():
        return dict(read_exif(path).get_ifd(_EXIF_IFD))
    return {}


def _number(inner: dict[int, Any], tag: int) -> float | None:
    text = plain_number(inner.get(tag))
    return float(text) if text else None
