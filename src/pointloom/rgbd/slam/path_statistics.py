"""Length and error of camera trajectories."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...registration.trajectories.trajectory_error import TrajectoryError, evaluate_trajectory

MIN_PAIRS = 2  # poses with known truth


def error_against_truth(
    poses: Sequence[NDArray[np.float64]] | NDArray[np.float64], true_poses: Sequence[NDArray[np.float64] | None]
) -> TrajectoryError | None:
    pairs = [(T, truth) for T, truth in zip(poses, true_poses, strict=True) if truth is not None]
    if len(pairs) < MIN_PAIRS:
        return None
    estimate, truth = (Trajectory(np.array(side)) for side in zip(*pairs, strict=True))
    error = evaluate_trajectory(estimate, truth, align=True)
    return dataclasses.replace(error, estimate_count=len(poses), truth_count=len(poses))


def path_length(poses: NDArray[np.float64]) -> float:
    return float(np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1).sum())
