"""Agreement of depth maps: when two of them show the same surface."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ...core.checks import check_fraction, check_positive


@dataclass(frozen=True)
class DepthAgreement:
    """Limits within which pixels of two depth maps show the same surface.

    Attributes:
        max_pixels: Maximum forward-backward reprojection error [px].
        max_relative: Maximum relative difference of inverse depths. Effect: see docs/mvs.md.
        max_angle: Maximum angle between normals [degrees], up to 180; zero normals match any. None: any angle. Only
            `fuse_depth_maps` compares normals.

    Raises:
        TypeError, ValueError: A number is out of range; named in the message.

    Example:
        >>> import pointloom as loom
        >>> loom.photogrammetry.DepthAgreement(max_relative=0.02)
        DepthAgreement(max_pixels=1.0, max_relative=0.02, max_angle=None)
    """

    max_pixels: float = 1.0
    max_relative: float = 0.01
    max_angle: float | None = None

    def __post_init__(self):
        check_positive("max_pixels", self.max_pixels)
        check_fraction("max_relative", self.max_relative)
        if self.max_angle is not None:
            check_positive("max_angle", self.max_angle, allow_zero=True, maximum=180.0)


def check_agreement(agreement: Any) -> DepthAgreement:
    if not isinstance(agreement, DepthAgreement):
        raise TypeError(f"agreement: expected a DepthAgreement, got {type(agreement).__name__}")
    return agreement
