"""What the XMP of drones says: altitudes, how well GNSS was fixed, and how the camera hung.

XMP is looked through for attributes and elements by name, not parsed as XML: no entity of it is ever expanded.

Names as they are found in files of DJI (`drone-dji:`), Parrot (`drone-parrot:`), and in the `Camera:` namespace of
Pix4D, which senseFly and Parrot write: there a pitch of 0 looks straight down, in the others -90 does.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

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
