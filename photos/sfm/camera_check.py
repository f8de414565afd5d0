"""What the pictures of a model say of its cameras: whether they bear out a focal length that was given or found."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping
from typing import Any

from .colmap_cameras import FLAT, GIVEN_WORSE, LEVEL, MOST_SPREAD, MUCH_BETTER, is_open

GIVEN_OFF = 1.02  # times the focal length that was given: calibrations of one lens differ by less
EXIF_OFF = 0.05  # what EXIF's focal length may be off by: whole millimetres in terms of 35 mm film, round figures

_REMEDY = "give the camera (intrinsic), or take pictures with the camera turned and tilted, from several sides"


@dataclasses.dataclass(frozen=True)
class CameraCheck:
    """What adjustments with other focal lengths gave; NaN where one was not made.

    Args:
        found: The focal length that the pictures ask for, of the first camera [px].
        rise: By which share the error rises at least where the focal length is held 15 % shorter, and 18 % longer.
        spread: By which share it is off by what parts of the pictures and a lens with more distortion say (standard
            error); asked where the error rises little.
        given: The focal length that was given [px].
        exif: The focal length that EXIF tells, of the first camera that has one, where the pictures fix none [px].
        error: Root mean square error with the cameras as they were given, or are found [px].
        freed_error: The same with the focal length freed of what was given, or held at EXIF's [px].
        own_error: The same with a focal length of its own for each picture, poses and points adjusted to it [px].
        parted: Cameras of the model where one alone did not explain the pictures; else 0.
    """

    found: float = math.nan
    rise: float = math.nan
    spread: float = math.nan
    given: float = math.nan
    exif: float = math.nan
    error: float = math.nan
    freed_error: float = math.nan
    own_error: float = math.nan
    parted: int = 0

    @classmethod
    def from_json(cls, told: Mapping[str, Any]) -> CameraCheck:
        """What `to_dict` gave, or COLMAP's process said, read again; what is missing was not tried."""
        known = {field.name: told.get(field.name) for field in dataclasses.fields(cls)}
        return cls(**{name: value for name, value in known.items() if value is not None})

    def to_dict(self) -> dict[str, Any]:
        """The same in JSON's types; NaN becomes None."""
        return {key: None if value != value else value for key, value in dataclasses.asdict(self).items()}

    @property
    def is_open(self) -> bool:
        """Whether the pictures fix no focal length."""
        return math.isnan(self.given) and is_open(self.rise, self.spread)

    @property
    def is_exif_kept(self) -> bool:
        """Whether the model has EXIF's focal length, as the pictures fix none and bear that one out as well."""
        return self.is_open and not math.isnan(self.exif) and self.freed_error < (1 + FLAT) * self.error

    @property
    def is_given_wrong(self) -> bool:
        """Whether the pictures ask for another focal length than was given: by the error, or in all of their parts."""
        off = abs(math.log(self.found / self.given))
        if self.freed_error < GIVEN_WORSE * self.error:
            return off > math.log(GIVEN_OFF)
        return self.spread <= MOST_SPREAD and off > 2 * MOST_SPREAD and self.error > (1 + FLAT) * self.freed_error

    def reasons(self) -> list[str]:
        """Failed checks of the cameras, with the remedy."""
        best = self.error if math.isnan(self.given) else min(self.error, self.freed_error)
        if self.own_error < MUCH_BETTER * best and not self.parted:
            off = f"with one for each the error falls from {best:.2g} to {self.own_error:.2g} px"
            return [f"the pictures were taken with several focal lengths ({off}): do not zoom, and keep to one lens"]
        if self.is_given_wrong:
            off = f"the error falls from {self.error:.2g} to {self.freed_error:.2g} px"
            said = f"the pictures ask for a focal length of {self.found:.4g} px, {self.given:.4g} px were given ({off})"
            return [f"{said}: check the camera that was given, or leave it out"]
        if not self.is_open or self.is_exif_kept:
            return []
        if not math.isnan(self.exif):
            off = f"EXIF says {self.exif:.4g} px, with which they fit worse"
            return [f"the pictures do not fix the focal length, and {off} than with {self.found:.4g} px: {_REMEDY}"]
        rises = f"held 15 % off {self.found:.4g} px, the error rises by {100 * max(self.rise, 0):.1f} %"
        if not self.rise < LEVEL:
            others = "parts of the pictures, or a lens with more distortion, ask for others"
            rises += f", and {others}, by {100 * self.spread:.0f} %"
        off = "lengths along and across the view may be off by as much, one against the other"
        return [f"the pictures do not fix the focal length ({rises}), so that {off}: {_REMEDY}"]

    def notes(self) -> list[str]:
        """Remarks on cameras that passed the checks."""
        said = []
        if self.parted:
            said.append(f"one camera does not explain the pictures, {self.parted} of other focal lengths do")
        if self.is_exif_kept:
            off = f"lengths along and across the view may differ by {100 * EXIF_OFF:.0f} %"
            said.append(f"the pictures do not fix the focal length; it is EXIF's, {self.exif:.4g} px: {off}")
        return said
