"""Check of a model's focal lengths, given or estimated, against the images."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping
from typing import Any

from .colmap_cameras import GIVEN_WORSE, MAX_EXIF_RISE, MAX_SPREAD, MIN_ERROR_RISE, MUCH_BETTER, is_open

GIVEN_OFF = 1.02  # factor: calibrations of one lens differ by less
EXIF_OFF = 0.05  # error of EXIF's focal length: rounded 35 mm equivalents

_REMEDY = "give the camera (intrinsic), or take images with the camera rotated and tilted, from several sides"


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
    def from_json(cls, record: Mapping[str, Any]) -> CameraCheck:
        known = {field.name: record.get(field.name) for field in dataclasses.fields(cls)}
        return cls(**{name: value for name, value in known.items() if value is not None})

    def to_dict(self) -> dict[str, Any]:
        return {key: None if value != value else value for key, value in dataclasses.asdict(self).items()}

    @property
    def is_open(self) -> bool:
        return math.isnan(self.given) and is_open(self.rise, self.spread)

    @property
    def uses_exif(self) -> bool:
        return self.is_open and not math.isnan(self.exif) and self.freed_error < (1 + MAX_EXIF_RISE) * self.error

    @property
    def is_given_wrong(self) -> bool:
        off = abs(math.log(self.found / self.given))
        if self.freed_error < GIVEN_WORSE * self.error:
            return off > math.log(GIVEN_OFF)
        improves = self.error > (1 + MAX_EXIF_RISE) * self.freed_error
        return self.spread <= MAX_SPREAD and off > 2 * MAX_SPREAD and improves

    def reasons(self) -> list[str]:
        best = self.error if math.isnan(self.given) else min(self.error, self.freed_error)
        if self.own_error < MUCH_BETTER * best and not self.parted:
            off = f"with one focal length per image the error falls from {best:.2g} to {self.own_error:.2g} px"
            return [f"the images were taken with several focal lengths ({off}): do not zoom, and use one lens"]
        if self.is_given_wrong:
            off = f"the error falls from {self.error:.2g} to {self.freed_error:.2g} px"
            message = (
                f"the given focal length is {self.given:.4g} px, but {self.found:.4g} px fits the images better ({off})"
            )
            return [f"{message}: check the given camera, or leave it out"]
        if not self.is_open or self.uses_exif:
            return []
        if not math.isnan(self.exif):
            off = f"the {self.exif:.4g} px of EXIF fit worse"
            return [f"the images do not determine the focal length, and {off} than {self.found:.4g} px: {_REMEDY}"]
        rises = f"with a focal length 15% off {self.found:.4g} px, the error rises by {100 * max(self.rise, 0):.1f}%"
        if not self.rise < MIN_ERROR_RISE:
            others = "subsets of the images, or a lens with more distortion, change the focal length"
            rises += f", and {others} by {100 * self.spread:.0f}%"
        off = "the ratio of lengths along and across the viewing direction may be off by as much"
        return [f"the images do not determine the focal length ({rises}), so {off}: {_REMEDY}"]

    def notes(self) -> list[str]:
        lines = []
        if self.parted:
            lines.append(f"one camera does not fit the images, {self.parted} cameras with different focal lengths do")
        if self.uses_exif:
            off = f"the ratio of lengths along and across the viewing direction may be off by {100 * EXIF_OFF:.0f}%"
            lines.append(f"the images do not determine the focal length; EXIF's {self.exif:.4g} px are used: {off}")
        return lines
