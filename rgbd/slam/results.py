"""What tracking says of a frame."""

from __future__ import annotations

import dataclasses
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import eigvalsh

Verdict = Literal["tracked", "uncertain", "lost"]


@dataclasses.dataclass(frozen=True, eq=False)
class TrackingResult:
    """Pose of a frame and its status.

    Attributes:
        pose: T_world_camera, float64 [4, 4] [m]; None for a lost frame.
        verdict: "tracked", "uncertain" (a pose that the model speaks for, not firmly: nothing is fused there, but where
            `has_drifted`), "lost".
        reason: Why it is not tracked; empty where it is.
        fitness: Share of the frame's pixels with depth that lie on the model's surface.
        overlap: Share of the frame's pixels with depth for which the model shows depth.
        inlier_rmse: Distance from the model's surface [m], root of the mean square.
        intensity_rmse: Difference of brightness, 0..1; NaN without colours.
        smallest_eigenvalue: How well the frame determines its motion: the ratio of the least to the greatest eigenvalue
            of the normal equations.
        iterations: Steps of the alignment that was taken.
        relocalized: Whether the pose was found anew, from a keyframe or by shape, not from the frames before.
        index: Number of the frame, from 0 on, in the order of tracking.
        name: The frame's name, where it has one.
        timestamp: The frame's time [s], where it has one.
        fused: Whether the frame went into the model.
        covariance: Of the pose about the camera, in the world's directions, rotation first [rad, m], float64 [6, 6]:
            what was open on the way from the first frame adds up, until the camera sees what is surer. Zero for the
            first frame and lost ones.
        has_drifted: Whether that is the only reason: the frame lies on the model, and is fused.
        map: The map that the pose is of, by number: poses of two maps do not lie relative to each other.
    """

    pose: NDArray[np.float64] | None
    verdict: Verdict
    reason: str = ""
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
        """True if the status is "tracked"."""
        return self.verdict == "tracked"

    @property
    def position_deviation(self) -> float:
        """The standard deviation of the position along its most open direction [m]."""
        return float(np.sqrt(max(eigvalsh(self.covariance[3:, 3:])[-1], 0.0)))
