"""What is told of a camera's path: how long it is, and how far it lies from the true one where that is known."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...cameras.trajectory import Trajectory
from ...registration.trajectories.trajectory_error import TrajectoryError, evaluate_trajectory

FEWEST = 2  # poses with a truth below which there is no error to tell


def error_against_truth(
    poses: Sequence[NDArray[np.float64]] | NDArray[np.float64], true_poses: Sequence[NDArray[np.float64] | None]
) -> TrajectoryError | None:
    """ATE and RPE of the poses whose truth is known, aligned by a rigid motion.

    Args:
        poses: T_world_camera of each frame, [4, 4].
        true_poses: The true one of each, or None where nobody knows it.

    Returns:
        None where fewer than two have a truth.
    """
    pairs = [(T, truth) for T, truth in zip(poses, true_poses, strict=True) if truth is not None]
    if len(pairs) < FEWEST:
        return None
    estimate, truth = (Trajectory(np.array(side)) for side in zip(*pairs, strict=True))
    return evaluate_trajectory(estimate, truth, align=True)


def path_length(poses: NDArray[np.float64]) -> float:
    """The length of a path [m], poses [n, 4, 4]."""
    return float(np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1).sum())
