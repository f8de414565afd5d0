"""Where photographs were taken, as EXIF and the XMP of drones say: latitude, longitude, altitude, attitude.

What makes no sense is left out and named, with the reason; nothing is guessed. Source: EXIF 2.32, section 4.6.6 (GPS).

What the XMP of drones says: altitudes, how well GNSS was fixed, and how the camera hung. XMP is looked through for
attributes and elements by name, not parsed as XML: no entity of it is ever expanded.

Names as they are found in files of DJI (`drone-dji:`), Parrot (`drone-parrot:`), and in the `Camera:` namespace of
Pix4D, which senseFly and Parrot write: there a pitch of 0 looks straight down, in the others -90 does.
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
from ...files.foreign import ignored_errors
from ...pcd.geodesy import WorldFrame
from .picture_folder import ORIENTATION, UPRIGHT, check_place, list_pictures
from .picture_writing import counted, some_of

MOST_BYTES = 1 << 20  # of XMP that is looked through
_ENTRY = re.compile(
    r"(?:drone-dji|drone-parrot|Camera):(?P<name>\w+)\s*(?:=\s*[\"'](?P<a>[^\"'<>]{1,40})[\"']|>\s*(?P<b>[^<>]{1,40})<)"
)
_PREFIX = re.compile(r"(drone-dji|drone-parrot|Camera):")
_NUMBER = re.compile(r"[+-]?\d+(?:\.\d*)?(?:[eE][+-]?\d+)?")
_RTK = {50: "fixed", 34: "float", 16: "single", 0: "none"}  # DJI's RtkFlag


@dataclass(frozen=True)
class Xmp:
    """What XMP says; None where it is silent.

    Attributes:
        altitude, relative_altitude: Absolute, and above the place of take-off [m].
        horizontal_sigma, vertical_sigma: Of the position [m].
        rtk: "fixed", "float", "single" or "none".
        attitude: Yaw clockwise from north, pitch up from level and roll to the right of the camera [degrees].
        heading: Of the aircraft, clockwise from north [degrees].
    """

    altitude: float | None = None
    relative_altitude: float | None = None
    horizontal_sigma: float | None = None
    vertical_sigma: float | None = None
    rtk: str | None = None
    attitude: tuple[float, float, float] | None = None
    heading: float | None = None


def parse_xmp(data: bytes | str | None) -> Xmp:
    """What XMP says of the place and the attitude of a camera; numbers that make no sense say nothing."""
    if not data:
        return Xmp()
    text = data if isinstance(data, str) else data[:MOST_BYTES].decode("utf-8", "replace")
    found: dict[str, float] = {}
    for match in _ENTRY.finditer(text[:MOST_BYTES]):
        number = _NUMBER.match((match["a"] or match["b"]).strip())
        space = _PREFIX.match(match[0])
        assert space is not None
        if number is not None and math.isfinite(float(number[0])):
            found.setdefault(f"{space[1]}:{match['name']}", float(number[0]))
    dji = {key.partition(":")[2]: value for key, value in found.items() if key.startswith("drone-dji:")}
    flag = dji.get("RtkFlag")
    return Xmp(
        altitude=dji.get("AbsoluteAltitude"),
        relative_altitude=dji.get("RelativeAltitude"),
        horizontal_sigma=_sigma(*(dji.get(name) for name in ("RtkStdLon", "RtkStdLat"))),
        vertical_sigma=_sigma(dji.get("RtkStdHgt")),
        rtk=None if flag is None else _RTK.get(int(flag), "none"),
        attitude=_attitude(found),
        heading=dji.get("FlightYawDegree"),
    )


def _sigma(*values: float | None) -> float | None:
    """The largest of standard deviations, where all are told and above 0."""
    kept = [value for value in values if value is not None and 0 < value < 1e4]
    return max(kept) if len(kept) == len(values) else None


def _attitude(found: dict[str, float]) -> tuple[float, float, float] | None:
    for names, down in (
        ([f"drone-dji:Gimbal{what}Degree" for what in ("Yaw", "Pitch", "Roll")], 0.0),
        ([f"drone-parrot:Camera{what}Degree" for what in ("Yaw", "Pitch", "Roll")], 0.0),
        ([f"Camera:{what}" for what in ("Yaw", "Pitch", "Roll")], 90.0),
    ):
        if all(name in found for name in names):
            yaw, pitch, roll = (found[name] for name in names)
            pitch -= down
            if all(abs(angle) <= 360 for angle in (yaw, pitch, roll)):
                return yaw, pitch, roll
    return None


FARTHEST = 1e5  # [m] from the middle of the others: no set of pictures that show one thing is larger
LOWEST, HIGHEST = -500.0, 20000.0  # [m] altitudes that are accepted
WORST_SIGMA = 1000.0  # [m] of a position that says anything

_GPS, _XMP_KEYS = 0x8825, ("xmp", "XML:com.adobe.xmp")
_NS, _LATITUDE, _EW, _LONGITUDE, _BELOW, _ALTITUDE = range(1, 7)
_STATUS, _DIRECTION_FROM, _DIRECTION, _ERROR = 9, 16, 17, 31
_NO_FIX = "V"  # of GPSStatus: measurement void


@dataclass(frozen=True)
class PicturePlace:
    """Where a picture was taken, as the picture says.

    Attributes:
        name: Of its file.
        latitude, longitude: [degrees] of WGS 84.
        altitude: [m], from the sea or the ellipsoid as the camera counts; None where it is not told.
        relative_altitude: Above the place of take-off [m], of DJI.
        horizontal_sigma, vertical_sigma: How sure that is [m]; None where it is not told.
        rtk: "fixed", "float", "single" or "none", of DJI.
        attitude: Yaw clockwise from north, pitch up from level and roll to the right of the camera [degrees], of XMP.
        direction: The way that the picture looks, clockwise from true north [degrees], of EXIF.
        heading: Of the aircraft [degrees], of DJI.
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
class PicturePlaces:
    """Where the pictures of a set were taken.

    Attributes:
        places: Of the pictures that say so sensibly, in their order.
        attitudes: Yaw, pitch and roll by name, of pictures without a place too.
        refused: Why the position of an image is rejected, by its name.
        picture_count: How many pictures there are.
        altitudes_refused: Altitudes that are rejected [m], by name; the place of such a picture counts without.
    """

    places: tuple[PicturePlace, ...]
    attitudes: dict[str, tuple[float, float, float]] = field(default_factory=dict)
    refused: dict[str, str] = field(default_factory=dict)
    picture_count: int = 0
    altitudes_refused: dict[str, float] = field(default_factory=dict)

    def __len__(self) -> int:
        """How many pictures say where they were taken."""
        return len(self.places)

    def __repr__(self) -> str:
        wrong = f", {len(self.refused)} refused" if self.refused else ""
        return f"PicturePlaces({len(self)} of {counted(self.picture_count, 'picture')}{wrong})"

    @property
    def frame(self) -> WorldFrame:
        """Metres about the median place; its altitude is the median of those that are told.

        Raises:
            ValueError: No picture says where it was taken.
        """
        if not self.places:
            raise ValueError("places: no picture says where it was taken")
        turns = _unwrapped([place.longitude for place in self.places])
        altitudes = [place.altitude for place in self.places if place.altitude is not None]
        longitude = (float(np.median(turns)) + 180) % 360 - 180
        latitude = float(np.median([place.latitude for place in self.places]))
        return WorldFrame(latitude, longitude, float(np.median(altitudes)) if altitudes else 0.0)

    def notes(self) -> list[str]:
        """Remarks on images whose position is rejected."""
        said = [f"{name} ({reason})" for name, reason in self.refused.items()]
        notes = [f"GPS of {counted(len(said), 'picture')} is rejected: {some_of(said)}"] if said else []
        said = [f"{name} ({metres:g} m)" for name, metres in self.altitudes_refused.items()]
        if said:
            notes.append(f"the altitude of {counted(len(said), 'picture')} is rejected: {some_of(said)}")
        return notes

    def to_dict(self) -> dict[str, Any]:
        """The same in JSON's types."""
        return {
            "places": [asdict(place) for place in self.places],
            "attitudes": {name: list(angles) for name, angles in self.attitudes.items()},
            "refused": dict(self.refused),
            "picture_count": self.picture_count,
            "altitudes_refused": dict(self.altitudes_refused),
        }


def read_picture_places(source: FilePath | Iterable[FilePath]) -> PicturePlaces:
    """Where photographs were taken, as EXIF and XMP say.

    Args:
        source: A folder of pictures, or the files.

    Returns:
        The places, and why those of other pictures are rejected: latitudes beyond 90 degrees, numbers over zero,
        the 0, 0 of cameras without a fix, hemispheres that are not told, a place 100 km from the median of the others.

    Raises:
        TypeError: No path, and no list of them.
        DatasetError: No folder, or no picture in it.
        FileError: A file that is not there.

    Notes:
        Headers alone are read. Which way EXIF says that a picture lies decides nothing about its place; attitudes of
        pictures that EXIF turns are left out.

    Example:
        >>> import pointloom as loom
        >>> from PIL import Image
        >>> exif = Image.Exif()
        >>> exif.get_ifd(0x8825).update({1: "N", 2: (47.0, 30.0, 0.0), 3: "E", 4: (8.0, 15.0, 0.0), 6: 430.0})
        >>> Image.new("RGB", (8, 8)).save("a.jpg", exif=exif)
        >>> place = loom.sfm.read_picture_places(["a.jpg"]).places[0]
        >>> place.latitude, place.longitude, place.altitude
        (47.5, 8.25, 430.0)
    """
    if isinstance(source, str | os.PathLike):
        paths = list_pictures(check_place("source", source))
    else:
        paths = [check_place(f"source[{k}]", path) for k, path in enumerate(check_list("source", source, "paths"))]
    places, attitudes, refused, heights = [], {}, {}, {}
    for path in paths:
        gps, xmp, turned = _read_head(path)
        if xmp.attitude is not None and not turned:
            attitudes[path.name] = xmp.attitude
        try:
            place = _place_of(path.name, gps, xmp, turned=turned)
        except ValueError as error:
            refused[path.name] = str(error)
            continue
        if place is not None:
            if place.altitude is not None and not LOWEST <= place.altitude <= HIGHEST:
                heights[path.name] = place.altitude
                place = replace(place, altitude=None)
            places.append(place)
    kept = _without_far(places, refused)
    return PicturePlaces(tuple(kept), attitudes, refused, len(paths), heights)


def _read_head(path: Path) -> tuple[dict[int, Any], Xmp, bool]:
    """GPS of EXIF, XMP, and whether EXIF says that the picture is to be turned."""
    if not path.is_file():
        raise FileError(path, "does not exist")
    with ignored_errors(), Image.open(path) as picture:  # what cannot be read says nothing
        xmp = next((picture.info[key] for key in _XMP_KEYS if picture.info.get(key)), None)
        exif = picture.getexif()
        gps: dict[int, Any] = {}
        with ignored_errors():
            gps = dict(exif.get_ifd(_GPS))
        return gps, parse_xmp(xmp), exif.get(ORIENTATION, UPRIGHT) not in (UPRIGHT, 0, None)
    return {}, Xmp(), False


def _place_of(name: str, gps: dict[int, Any], xmp: Xmp, *, turned: bool) -> PicturePlace | None:
    """The place of a picture; None where it says none.

    Raises:
        ValueError: It says one that makes no sense.
    """
    if _LATITUDE not in gps and _LONGITUDE not in gps:
        return None
    if _text(gps.get(_STATUS)) == _NO_FIX:
        raise ValueError("GPSStatus says that there was no fix")
    latitude = _degrees(gps, _LATITUDE, _NS, "NS", "latitude", 90.0)
    longitude = _degrees(gps, _LONGITUDE, _EW, "EW", "longitude", 180.0)
    if latitude == 0 and longitude == 0:
        raise ValueError("0, 0 is what cameras without a fix write")
    direction = _number(gps.get(_DIRECTION)) if _text(gps.get(_DIRECTION_FROM, "T")) == "T" else None
    error = xmp.horizontal_sigma or _number(gps.get(_ERROR))
    return PicturePlace(
        name=name,
        latitude=latitude,
        longitude=longitude,
        altitude=_altitude(gps, xmp),
        relative_altitude=xmp.relative_altitude,
        horizontal_sigma=error if error is not None and 0 < error <= WORST_SIGMA else None,
        vertical_sigma=xmp.vertical_sigma,
        rtk=xmp.rtk,
        attitude=None if turned else xmp.attitude,
        direction=direction if direction is not None and 0 <= direction <= 360 else None,
        heading=xmp.heading,
    )


def _degrees(gps: dict[int, Any], tag: int, sign_tag: int, signs: str, what: str, most: float) -> float:
    raw = gps.get(tag)
    parts = list(raw) if isinstance(raw, tuple | list) else [raw]
    numbers = [_number(part) for part in parts]
    if raw is None or not 1 <= len(numbers) <= 3 or any(number is None for number in numbers):
        raise ValueError(f"its {what} is no number")
    whole = [number for number in numbers if number is not None]
    if any(number < 0 for number in whole) or any(number > 60 for number in whole[1:]):
        raise ValueError(f"its {what} has {' '.join(f'{number:g}' for number in whole)} for degrees, minutes, seconds")
    value = sum(number / 60**k for k, number in enumerate(whole))
    if value > most:
        raise ValueError(f"its {what} is {value:g} degrees")
    sign = _text(gps.get(sign_tag))
    if sign not in signs:
        raise ValueError(f"its {what} does not say {signs[0]} or {signs[1]}")
    return -value if sign == signs[1] else value


def _altitude(gps: dict[int, Any], xmp: Xmp) -> float | None:
    value = _number(gps.get(_ALTITUDE))
    if value is None:
        value = xmp.altitude
    else:
        below = gps.get(_BELOW, b"\0")
        code = below[0] if isinstance(below, bytes) and below else _number(below)
        value = -abs(value) if code in (1, ord("1")) else value
    return value


def _number(value: Any) -> float | None:
    """A number of EXIF; None where it is none, such as 0 over 0."""
    try:
        number = float(value)
    except (TypeError, ValueError, ZeroDivisionError, OverflowError):
        return None
    return number if math.isfinite(number) else None


def _text(value: Any) -> str:
    """One letter of EXIF; "?" where there is none."""
    text = value.decode("ascii", "replace") if isinstance(value, bytes) else str(value or "")
    return text.strip("\0 ").upper()[:1] or "?"


def _without_far(places: list[PicturePlace], refused: dict[str, str]) -> list[PicturePlace]:
    """The places near the median of all; the others are told."""
    if len(places) < 3:
        return places
    metres = metres_about_median(places)
    far = np.linalg.norm(metres, axis=1)
    for place, distance in zip(places, far.tolist(), strict=True):
        if distance > FARTHEST:
            refused[place.name] = f"lies {distance / 1000:,.0f} km from the median of the others"
    return [place for place in places if place.name not in refused]


def metres_about_median(places: list[PicturePlace]) -> NDArray[np.float64]:
    """Roughly where places lie about their median, [n, 2] [m]."""
    degrees = np.array([[place.latitude, place.longitude] for place in places])
    degrees[:, 1] = _unwrapped(degrees[:, 1].tolist())
    middle = np.median(degrees, axis=0)
    across = math.cos(math.radians(float(middle[0])))
    return (degrees - middle) * (111_320.0, 111_320.0 * across)


def _unwrapped(longitudes: list[float]) -> NDArray[np.float64]:
    """Longitudes about the first, so that a set over the 180th meridian is no wide one."""
    values = np.array(longitudes)
    return values[0] + (values - values[0] + 180) % 360 - 180
