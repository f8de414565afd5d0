"""Tracking result of a frame."""

from __future__ import annotations

import dataclasses
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ...core.reports import AssessedRecord
from ...kernels.linear_algebra import eigvalsh

Status = Literal["tracked", "uncertain", "lost"]


@dataclasses.dataclass(frozen=True, eq=False)
class TrackingResult(AssessedRecord):
    """Pose of a frame and its status.

    Attributes:
        pose: T_world_camera, float64 [4, 4] [m]. None if lost.
        status: "tracked", "uncertain" (not fused, except with `has_drifted`), "lost".
        warnings: Why it is not tracked. Empty if it is.
        fitness: Fraction of the frame's depth pixels on the model surface.
        overlap: Fraction of the frame's depth pixels where the model has depth.
        inlier_rmse: Root mean square distance from the surface [m].
        intensity_rmse: Brightness difference, 0..1. NaN without color.
        smallest_eigenvalue: Ratio of the smallest to the largest eigenvalue of the normal equations.
        iterations: Steps of the alignment.
        relocalized: True if the pose is from a keyframe or by shape, not from the previous frames.
        index: Frame number in tracking order, from 0.
        name: Frame name, if any.
        timestamp: Frame time [s], if any.
        fused: True if the frame was fused.
        covariance: Of the pose about the camera, in world axes, rotation first [rad, m], float64 [6, 6], accumulated
            since the first frame. Zero for the first frame and lost ones.
        has_drifted: True if the accumulated uncertainty is the only problem. The frame is fused.
        map: Number of the map that the pose refers to.
    """

    pose: NDArray[np.float64] | None
    status: Status
    warnings: tuple[str, ...] = ()
    fitness: float = 0.0
    overlap: float = 0.0
    inlier_rmse: float = 0.0
    intensity_rmse: float = float("nan")
    smallest_eigenvalue: float = 0.0
    iterations: int = 0
    relocalized: bool = False
    index: int = 0
    name: str = ""
    timestamp: float | None = None
    fused: bool = False
    covariance: NDArray[np.float64] = dataclasses.field(default_factory=lambda: np.zeros((6, 6)))
    has_drifted: bool = False
    map: int = 0

    @property
    def is_tracked(self) -> bool:
        return self.status == "tracked"

    @property
    def position_deviation(self) -> float:
        """Standard deviation of the position along its least determined direction [m]."""
        return float(np.sqrt(max(eigvalsh(self.covariance[3:, 3:])[-1], 0.0)))
