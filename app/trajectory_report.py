"""The path of a camera as the commands give it: written to a file, and held against the true one where it is known."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..pcd.io.trajectory import Trajectory, write_trajectory
from ..registration.trajectory_error import evaluate_trajectory
from .evaluate import ALIGNMENTS, describe_errors
from .frames import FilePath
from .tables import check_output

FORMATS = {".txt": "tum", ".tum": "tum", ".log": "log"}  # those that hold the number or the time of each pose
ALIGN = "se3"
FEWEST = 2  # poses with a truth below which there is no error to tell

_SHOWN = 5  # runs of frames, by number


def check_trajectory_output(path: FilePath, *, overwrite: bool) -> str:
    """The format of a file of poses by its extension, once it is sure that it can be written.

    Raises:
        FileError: Another extension, or a place that cannot be written.
    """
    check_output(path, tuple(FORMATS), what="poses", overwrite=overwrite)
    return FORMATS[Path(path).suffix.lower()]


def write_poses(path: FilePath, trajectory: Trajectory, *, overwrite: bool) -> None:
    """Write poses in the format that the extension names.

    Raises:
        FileError: As `check_trajectory_output`.
    """
    write_trajectory(path, trajectory, format=check_trajectory_output(path, overwrite=overwrite), overwrite=overwrite)


def trajectory_of(
    poses: Sequence[NDArray[np.float64]] | NDArray[np.float64],
    numbers: Sequence[int],
    timestamps: Sequence[float | None],
) -> Trajectory:
    """The poses of those frames of a sequence that have one.

    Args:
        poses: T_world_camera of each, [4, 4].
        numbers: The number of each frame in the sequence, which .log files hold.
        timestamps: Its time [s] or None; TUM files hold the times where all have one, else the numbers.
    """
    times = np.array(timestamps, np.float64) if all(time is not None for time in timestamps) else None
    order = np.array(numbers, np.int64).reshape(-1, 1)
    ids = np.hstack([order, order, order + 1])
    return Trajectory(np.array(poses, np.float64).reshape(-1, 4, 4), timestamps=times, ids=ids)


def errors_against_truth(
    poses: Sequence[NDArray[np.float64]], true_poses: Sequence[NDArray[np.float64] | None]
) -> dict[str, Any] | None:
    """ATE and RPE of the poses whose truth is known, aligned by se3, in JSON's types as `evaluate_files` has them.

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
    return {"align": ALIGN, **describe_errors(evaluate_trajectory(estimate, truth, **ALIGNMENTS[ALIGN]))}


def path_length(poses: NDArray[np.float64]) -> float:
    """The length of a path [m], poses [n, 4, 4]."""
    return float(np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1).sum())


def some_frames(numbers: Sequence[int]) -> str:
    """Numbers of frames, from 0, as runs; the first few where there are many: "frame 3, 7-9"."""
    return "frame " + some_runs(numbers)


def some_runs(numbers: Sequence[int]) -> str:
    """Whole numbers in ascending order as runs; the first few where there are many."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][1] + 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    listed = ", ".join(f"{first}" if first == last else f"{first}-{last}" for first, last in runs[:_SHOWN])
    return listed + (" and more" if len(runs) > _SHOWN else "")
