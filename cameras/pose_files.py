"""Poses to files: one as four rows of numbers, the path of a camera in the format that the extension names."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..core.atomic import atomic_write
from ..core.errors import FilePath
from ..core.outputs import check_output
from .trajectory import Trajectory, write_trajectory

FORMATS = {".txt": "tum", ".tum": "tum", ".log": "log"}  # those that hold the number or the time of each pose


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


def write_pose(path: FilePath, T: NDArray[np.float64], *, overwrite: bool = True) -> None:
    """Write a pose as four rows of four numbers with all digits, whole or not at all.

    Raises:
        FileError: The place cannot be written.
    """
    text = "".join(" ".join(repr(float(value)) for value in row) + "\n" for row in T)
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(text.encode("ascii"))
