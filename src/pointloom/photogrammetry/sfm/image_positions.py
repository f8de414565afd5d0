"""Camera positions and attitudes from EXIF (2.32, section 4.6.6) and the XMP of drones. Implausible values are
rejected.

XMP is searched by name, not parsed as XML, so no entity is expanded. Namespaces: `drone-dji:`, `drone-parrot:`, and
Pix4D's `Camera:`, where a pitch of 0 looks straight down (in the others -90).
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterable
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from ...core.checks import check_list
from ...core.errors import FileError, FilePath
from ...io.optional_imports import ignored_errors
from ...pcd.geodesy import WorldFrame
from .image_folder import EXIF_UPRIGHT, ORIENTATION_TAG, check_path, list_images
from .image_writing import counted, some_of

MAX_BYTES = 1 << 20  # searched part of XMP
_ENTRY = re.compile(
    r"(?:drone-dji|drone-parrot|Camera):(?P<name>\w+)\s*(?:=\s*[\"'](?P<a>[^\"'<>]{1,40})[\"']|>\s*(?P<b>[^<>]{1,40})<)"
)
_PREFIX = re.compile(r"(drone-dji|drone-parrot|Camera):")
_NUMBER = re.compile(r"[+-]?\d+(?:\.\d*)?(?:[eE][+-]?\d+)?")
_RTK_FLAGS = {50: "fixed", 34: "float", 16: "single", 0: "none"}  # DJI's RtkFlag


@dataclass(frozen=True)
class Xmp:
    """Values of XMP, None if missing: altitudes and sigmas [m], (yaw, pitch, roll) and aircraft heading [degrees]."""

    altitude: float | None = None
    relative_altitude: float | None = None
    horizontal_sigma: float | None = None
    vertical_sigma: float | None = None
    rtk: str | None = None
    attitude: tuple[float, float, float] | None = None
    heading: float | None = None


def parse_xmp(data: bytes | str | None) -> Xmp:
    if not data:
        return Xmp()
    text = data if isinstance(data, str) else data[:MAX_BYTES].decode("utf-8", "replace")
    fields: dict[str, float] = {}
    for match in _ENTRY.finditer(text[:MAX_BYTES]):
        number = _NUMBER.match((match["a"] or match["b"]).strip())
        space = _PREFIX.match(match[0])
        assert space is not None
        if number is not None and math.isfinite(float(number[0])):
            fields.setdefault(f"{space[1]}:{match['name']}", float(number[0]))
    dji = {key.partition(":")[2]: value for key, value in fields.items() if key.startswith("drone-dji:")}
    flag = dji.get("RtkFlag")
    return Xmp(
        altitude=dji.get("AbsoluteAltitude"),
        relative_altitude=dji.get("RelativeAltitude"),
        horizontal_sigma=_sigma(*(dji.get(name) for name in ("RtkStdLon", "RtkStdLat"))),
        vertical_sigma=_sigma(dji.get("RtkStdHgt")),
        rtk=None if flag is None else _RTK_FLAGS.get(int(flag), "none"),
        attitude=_attitude(fields),
        heading=dji.get("FlightYawDegree"),
    )


def _sigma(*values: float | None) -> float | None:
    """The largest standard deviation if all are given and positive."""
    valid = [value for value in values if value is not None and 0 < value < 1e4]
    return max(valid) if len(valid) == len(values) else None


def _attitude(values: dict[str, float]) -> tuple[float, float, float] | None:
    for names, down in (
        ([f"drone-dji:Gimbal{what}Degree" for what in ("Yaw", "Pitch", "Roll")], 0.0),
        ([f"drone-parrot:Camera{what}Degree" for what in ("Yaw", "Pitch", "Roll")], 0.0),
        ([f"Camera:{what}" for what in ("Yaw", "Pitch", "Roll")], 90.0),
    ):
        if all(name in values for name in names):
            yaw, pitch, roll = (values[name] for name in names)
            pitch -= down
            if all(abs(angle) <= 360 for angle in (yaw, pitch, roll)):
                return yaw, pitch, roll
    return None


MAX_MEDIAN_DISTANCE = 1e5  # [m] maximum distance from the median
MIN_ALTITUDE, MAX_ALTITUDE = -500.0, 20000.0  # [m] accepted altitudes
WORST_SIGMA = 1000.0  # [m] maximum standard deviation

_GPS_IFD, _XMP_KEYS = 0x8825, ("xmp", "XML:com.adobe.xmp")
_LATITUDE_REF, _LATITUDE_TAG, _LONGITUDE_REF, _LONGITUDE_TAG, _ALTITUDE_REF, _ALTITUDE_TAG = range(1, 7)
_STATUS_TAG, _DIRECTION_FROM, _DIRECTION_TAG, _ERROR_TAG = 9, 16, 17, 31
_NO_FIX = "V"  # GPSStatus: measurement void


@dataclass(frozen=True)
class ImagePosition:
    """Position of an image from its metadata.

    Attributes:
        name: File name.
        latitude, longitude: WGS 84 [degrees].
        altitude: Above sea or ellipsoid, depending on the camera [m]. None if missing.
        relative_altitude: Above the take-off point [m] (DJI).
        horizontal_sigma, vertical_sigma: Standard deviations [m]. None if missing.
        rtk: "fixed", "float", "single" or "none" (DJI).
        attitude: Yaw clockwise from north, pitch up, roll to the right of the camera [degrees] (XMP).
        direction: Viewing direction, clockwise from true north [degrees] (EXIF).
        heading: Aircraft heading [degrees] (DJI).
    """

    name: str
    latitude: float
    longitude: float
    altitude: float | None = None
    relative_altitude: float | None = None
    horizontal_sigma: float | None = None
    vertical_sigma: float | None = None
    rtk: str | None = None
    attitude: tuple[float, float, float] | None = None
    direction: float | None = None
    heading: float | None = None


@dataclass(frozen=True)
class ImagePositions:
    """Positions of a set of images.

    Attributes:
        places: Valid positions, in image order.
        attitudes: Yaw, pitch and roll by name, also of images without a position.
        refused: Reason of each rejected position, by image name.
        image_count: Number of images.
        altitudes_refused: Rejected altitudes [m], by name. The position is used without.
    """

    places: tuple[ImagePosition, ...]
    attitudes: dict[str, tuple[float, float, float]] = field(default_factory=dict)
    refused: dict[str, str] = field(default_factory=dict)
    image_count: int = 0
    altitudes_refused: dict[str, float] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.places)

    def __repr__(self) -> str:
        wrong = f", {len(self.refused)} refused" if self.refused else ""
        return f"ImagePositions({len(self)} of {counted(self.image_count, 'image')}{wrong})"

    @property
    def frame(self) -> WorldFrame:
        """Local frame [m] at the median position and the median known altitude. Raises ValueError without positions."""
        if not self.places:
            raise ValueError("places: no image has a GPS position")
        longitudes = _unwrapped([position.longitude for position in self.places])
        altitudes = [position.altitude for position in self.places if position.altitude is not None]
        longitude = (float(np.median(longitudes)) + 180) % 360 - 180
        latitude = float(np.median([position.latitude for position in self.places]))
        return WorldFrame(latitude, longitude, float(np.median(altitudes)) if altitudes else 0.0)

    def notes(self) -> list[str]:
        parts = [f"{name} ({reason})" for name, reason in self.refused.items()]
        notes = [f"GPS of {counted(len(parts), 'image')} is rejected: {some_of(parts)}"] if parts else []
        parts = [f"{name} ({meters:g} m)" for name, meters in self.altitudes_refused.items()]
        if parts:
            notes.append(f"the altitude of {counted(len(parts), 'image')} is rejected: {some_of(parts)}")
        return notes

    def to_dict(self) -> dict[str, Any]:
        return {
            "places": [asdict(position) for position in self.places],
            "attitudes": {name: list(angles) for name, angles in self.attitudes.items()},
            "refused": dict(self.refused),
            "image_count": self.image_count,
            "altitudes_refused": dict(self.altitudes_refused),
        }


def read_image_positions(source: FilePath | Iterable[FilePath]) -> ImagePositions:
    """Read the positions of photographs from EXIF and XMP.

    Args:
        source: A folder of images, or the files.

    Returns:
        The positions, and the reason for each rejected one: latitude beyond 90 degrees, division by zero, the 0, 0 of
        cameras without a fix, missing hemispheres, or more than 100 km from the median.

    Raises:
        TypeError: Not a path or a list of paths.
        DatasetError, FileError: No such folder, no image in it, or a missing file.

    Notes:
        Only headers are read. Attitudes of images with an EXIF rotation are ignored.

    Example:
        >>> import pointloom as loom
        >>> from PIL import Image
        >>> exif = Image.Exif()
        >>> exif.get_ifd(0x8825).update({1: "N", 2: (47.0, 30.0, 0.0), 3: "E", 4: (8.0, 15.0, 0.0), 6: 430.0})
        >>> Image.new("RGB", (8, 8)).save("a.jpg", exif=exif)
        >>> position = loom.photogrammetry.read_image_positions(["a.jpg"]).places[0]
        >>> position.latitude, position.longitude, position.altitude
        (47.5, 8.25, 430.0)
    """
    if isinstance(source, str | os.PathLike):
        paths = list_images(check_path("source", source))
    else:
        paths = [check_path(f"source[{k}]", path) for k, path in enumerate(check_list("source", source, "paths"))]
    positions, attitudes, refused, heights = [], {}, {}, {}
    for path in paths:
        gps, xmp, is_rotated = _read_head(path)
        if xmp.attitude is not None and not is_rotated:
            attitudes[path.name] = xmp.attitude
        try:
            position = _position_of(path.name, gps, xmp, is_rotated=is_rotated)
        except ValueError as error:
            refused[path.name] = str(error)
            continue
        if position is not None:
            if position.altitude is not None and not MIN_ALTITUDE <= position.altitude <= MAX_ALTITUDE:
                heights[path.name] = position.altitude
                position = replace(position, altitude=None)
            positions.append(position)
    remaining = _without_far(positions, refused)
    return ImagePositions(tuple(remaining), attitudes, refused, len(paths), heights)


def _read_head(path: Path) -> tuple[dict[int, Any], Xmp, bool]:
    """EXIF's GPS tags, XMP, and whether EXIF rotates the image."""
    if not path.is_file():
        raise FileError(path, "does not exist")
    with ignored_errors(), Image.open(path) as image:  # unreadable metadata is ignored
        xmp = next((image.info[key] for key in _XMP_KEYS if image.info.get(key)), None)
        exif = image.getexif()
        gps: dict[int, Any] = {}
        with ignored_errors():
            gps = dict(exif.get_ifd(_GPS_IFD))
        return gps, parse_xmp(xmp), exif.get(ORIENTATION_TAG, EXIF_UPRIGHT) not in (EXIF_UPRIGHT, 0, None)
    return {}, Xmp(), False


def _position_of(name: str, gps: dict[int, Any], xmp: Xmp, *, is_rotated: bool) -> ImagePosition | None:
    if _LATITUDE_TAG not in gps and _LONGITUDE_TAG not in gps:
        return None
    if _text(gps.get(_STATUS_TAG)) == _NO_FIX:
        raise ValueError("GPSStatus reports no fix")
    latitude = _degrees(gps, _LATITUDE_TAG, _LATITUDE_REF, "NS", "latitude", 90.0)
    longitude = _degrees(gps, _LONGITUDE_TAG, _LONGITUDE_REF, "EW", "longitude", 180.0)
    if latitude == 0 and longitude == 0:
        raise ValueError("its position is 0, 0, as written without a fix")
    direction = _number(gps.get(_DIRECTION_TAG)) if _text(gps.get(_DIRECTION_FROM, "T")) == "T" else None
    error = xmp.horizontal_sigma or _number(gps.get(_ERROR_TAG))
    return ImagePosition(
        name=name,
        latitude=latitude,
        longitude=longitude,
        altitude=_altitude(gps, xmp),
        relative_altitude=xmp.relative_altitude,
        horizontal_sigma=error if error is not None and 0 < error <= WORST_SIGMA else None,
        vertical_sigma=xmp.vertical_sigma,
        rtk=xmp.rtk,
        attitude=None if is_rotated else xmp.attitude,
        direction=direction if direction is not None and 0 <= direction <= 360 else None,
        heading=xmp.heading,
    )


def _degrees(gps: dict[int, Any], tag: int, sign_tag: int, signs: str, what: str, maximum: float) -> float:
    raw = gps.get(tag)
    parts = list(raw) if isinstance(raw, tuple | list) else [raw]
    numbers = [_number(part) for part in parts]
    if raw is None or not 1 <= len(numbers) <= 3 or any(number is None for number in numbers):
        raise ValueError(f"its {what} is not a number")
    valid = [number for number in numbers if number is not None]
    if any(number < 0 for number in valid) or any(number > 60 for number in valid[1:]):
        raise ValueError(
            f"its {what} has invalid degrees, minutes, seconds: {' '.join(f'{number:g}' for number in valid)}"
        )
    value = sum(number / 60**k for k, number in enumerate(valid))
    if value > maximum:
        raise ValueError(f"its {what} is {value:g} degrees")
    sign = _text(gps.get(sign_tag))
    if sign not in signs:
        raise ValueError(f"its {what} lacks {signs[0]} or {signs[1]}")
    return -value if sign == signs[1] else value


def _altitude(gps: dict[int, Any], xmp: Xmp) -> float | None:
    value = _number(gps.get(_ALTITUDE_TAG))
    if value is None:
        value = xmp.altitude
    else:
        below = gps.get(_ALTITUDE_REF, b"\0")
        code = below[0] if isinstance(below, bytes) and below else _number(below)
        value = -abs(value) if code in (1, ord("1")) else value
    return value


def _number(value: Any) -> float | None:
    try:
        number = float(value)
    except (TypeError, ValueError, ZeroDivisionError, OverflowError):
        return None
    return number if math.isfinite(number) else None


def _text(value: object) -> str:
    text = value.decode("ascii", "replace") if isinstance(value, bytes) else str(value or "")
    return text.strip("\0 ").upper()[:1] or "?"


def _without_far(positions: list[ImagePosition], refused: dict[str, str]) -> list[ImagePosition]:
    if len(positions) < 3:
        return positions
    meters = meters_about_median(positions)
    far = np.linalg.norm(meters, axis=1)
    for position, distance in zip(positions, far.tolist(), strict=True):
        if distance > MAX_MEDIAN_DISTANCE:
            refused[position.name] = f"is {distance / 1000:,.0f} km from the median of the others"
    return [position for position in positions if position.name not in refused]


def meters_about_median(positions: list[ImagePosition]) -> NDArray[np.float64]:
    """Approximate positions about their median, [n, 2] [m]."""
    degrees = np.array([[position.latitude, position.longitude] for position in positions])
    degrees[:, 1] = _unwrapped(degrees[:, 1].tolist())
    middle = np.median(degrees, axis=0)
    across = math.cos(math.radians(float(middle[0])))
    return (degrees - middle) * (111_320.0, 111_320.0 * across)


def _unwrapped(longitudes: list[float]) -> NDArray[np.float64]:
    """Longitudes about the first, continuous across the 180th meridian."""
    values = np.array(longitudes)
    return values[0] + (values - values[0] + 180) % 360 - 180
