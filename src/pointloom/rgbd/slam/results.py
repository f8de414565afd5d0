"""Tracking result of a frame."""

from __future__ import annotations

import dataclasses
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from ...core.reports import AssessedRecord
from ...kernels.linear_algebra import eigvalsh, matmul
from ...registration.pose_errors import PoseCovariance

Status = Literal["tracked", "uncertain", "lost"]


@dataclasses.dataclass(frozen=True, eq=False)
class TrackingResult(AssessedRecord):
    """Pose of a frame and its status.

    Attributes:
        pose: T_world_camera, float64 [4, 4] [m]. None if lost.
        status: "tracked", "uncertain", "lost". Uncertain frames are not fused, except with `has_drifted`, and except
            frames that became uncertain too late to be removed, which have a warning.
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
            since the first frame, as assumed by the checks. Zero for the first frame and lost ones.
        error_covariance: Likewise, calibrated: of the error of the pose. See `PoseCovariance`.
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
    error_covariance: NDArray[np.float64] = dataclasses.field(default_factory=lambda: np.zeros((6, 6)))

    @property
    def is_tracked(self) -> bool:
        """True if the frame has a pose."""
        return self.status == "tracked"

    @property
    def pose_covariance(self) -> PoseCovariance | None:
        """Covariance of the error of the pose relative to the first pose of the map, about the camera. None if lost."""
        return None if self.pose is None else PoseCovariance(self.error_covariance, self.pose[:3, 3].copy())

    @property
    def position_deviation(self) -> float:
        """Standard deviation of the position along its least determined direction [m]."""
        return float(np.sqrt(max(eigvalsh(self.covariance[3:, 3:])[-1], 0.0)))


def rotated_covariance(
    covariance: NDArray[np.float64], pose: NDArray[np.float64], corrected: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The covariance about a camera, in world axes, after its pose was corrected."""
    rotation = np.kron(np.eye(2), matmul(corrected[:3, :3], pose[:3, :3].T))
    return matmul(rotation, covariance, rotation.T)


def with_pose(
    result: TrackingResult, pose: NDArray[np.float64], added: NDArray[np.float64] | None = None
) -> TrackingResult:
    """The result with a corrected pose, and with its covariances rotated alike, plus that of the correction."""
    assert result.pose is not None
    covariances = [
        rotated_covariance(matrix, result.pose, pose) + (0.0 if added is None else added)
        for matrix in (result.covariance, result.error_covariance)
    ]
    return dataclasses.replace(result, pose=pose, covariance=covariances[0], error_covariance=covariances[1])
