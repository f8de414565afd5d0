"""Check of a model's focal lengths, given or estimated, against the images."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping
from typing import Any

from .colmap_cameras import FLAT, GIVEN_WORSE, LEVEL, MAX_SPREAD, MUCH_BETTER, is_open

GIVEN_OFF = 1.02  # factor: calibrations of one lens differ by less
EXIF_OFF = 0.05  # error of EXIF's focal length: rounded 35 mm equivalents

_REMEDY = "give the camera (intrinsic), or take pictures with the camera turned and tilted, from several sides"


@dataclasses.dataclass(frozen=True)
class CameraCheck:
    """Errors of adjustments with other focal lengths. NaN if not computed.

    Args:
        found: Focal length preferred by the images, of the first camera [px].
        rise: Minimum relative rise of the error with a focal length fixed 15% shorter or 18% longer.
        spread: Relative standard error over image subsets and a richer lens model; computed if the rise is small.
        given: Given focal length [px].
        exif: EXIF focal length of the first camera that has one, if the images determine none [px].
        error: Root mean square reprojection error [px].
        freed_error: The error with a free focal length, or fixed at EXIF's [px].
        own_error: The error with a focal length per image [px].
        parted: Number of cameras if one did not suffice. Else 0.
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
        known = {field.name: told.get(field.name) for field in dataclasses.fields(cls)}
        return cls(**{name: value for name, value in known.items() if value is not None})

    def to_dict(self) -> dict[str, Any]:
        return {key: None if value != value else value for key, value in dataclasses.asdict(self).items()}

    @property
    def is_open(self) -> bool:
        return math.isnan(self.given) and is_open(self.rise, self.spread)

    @property
    def is_exif_kept(self) -> bool:
        return self.is_open and not math.isnan(self.exif) and self.freed_error < (1 + FLAT) * self.error

    @property
    def is_given_wrong(self) -> bool:
        off = abs(math.log(self.found / self.given))
        if self.freed_error < GIVEN_WORSE * self.error:
            return off > math.log(GIVEN_OFF)
        return self.spread <= MAX_SPREAD and off > 2 * MAX_SPREAD and self.error > (1 + FLAT) * self.freed_error

    def reasons(self) -> list[str]:
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
        said = []
        if self.parted:
            said.append(f"one camera does not explain the pictures, {self.parted} of other focal lengths do")
        if self.is_exif_kept:
            off = f"lengths along and across the view may differ by {100 * EXIF_OFF:.0f} %"
            said.append(f"the pictures do not fix the focal length; it is EXIF's, {self.exif:.4g} px: {off}")
        return said
