"""What the alignment of two frames found, and why it may not be believed."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclasses.dataclass(frozen=True, eq=False)
class OdometryResult:
    """The motion between two frames. Unpacks as Open3D's (success, transformation, information).

    Attributes:
        success: Whether the motion is to be believed.
        transformation: T_target_source, float64 [4, 4]; where it failed, the latest guess.
        information: Of the pixels that agree, about the target's camera, rotation first, float64 [6, 6], as Open3D's
            pose graphs want it: its last entry counts them, scaled to the full picture.
        reason: Why it failed; empty where it did not.
        inliers: Pixels of the source that lie on the target's surface, at the size that was compared.
        fitness: Their share of the source's pixels with depth.
        overlap: Share of the source's pixels with depth that the target shows with depth.
        inlier_rmse: Distance from the target's surface [m], root of the mean square.
        intensity_rmse: Difference of brightness, 0..1, after the exposures are brought together; NaN without colours.
        smallest_eigenvalue: Of the normal equations a pixel, in units of what determines a motion well: below its
            limit some motion is not determined by the frames.
        iterations: Steps taken in all levels.
    """

    success: bool
    transformation: NDArray[np.float64]
    information: NDArray[np.float64]
    reason: str = ""
    inliers: int = 0
    fitness: float = 0.0
    overlap: float = 0.0
    inlier_rmse: float = 0.0
    intensity_rmse: float = float("nan")
    smallest_eigenvalue: float = 0.0
    iterations: int = 0

    def __iter__(self) -> Iterator[Any]:
        return iter((self.success, self.transformation, self.information))
