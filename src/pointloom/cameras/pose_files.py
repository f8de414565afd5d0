"""Write poses: a single matrix, or a trajectory by extension."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..core.atomic import atomic_write
from ..core.errors import FilePath
from ..core.outputs import check_output
from .trajectory import Trajectory, write_trajectory
from .trajectory_formats import NUMBERED


def check_trajectory_output(path: FilePath, *, overwrite: bool) -> str:
    """The trajectory format of an extension, after checking that the file can be written."""
    check_output(path, NUMBERED, what="poses", overwrite=overwrite)
    return NUMBERED[Path(path).suffix.lower()]


def write_poses(path: FilePath, trajectory: Trajectory, *, overwrite: bool) -> None:
    write_trajectory(path, trajectory, format=check_trajectory_output(path, overwrite=overwrite), overwrite=overwrite)


def trajectory_of(
    poses: Sequence[NDArray[np.float64]] | NDArray[np.float64],
    numbers: Sequence[int],
    timestamps: Sequence[float | None],
) -> Trajectory:
    """The trajectory of frames with poses T_world_camera (4, 4), frame numbers, and times [s] or None.
    Timestamps are kept only if all frames have one."""
    times = np.array(timestamps, np.float64) if all(time is not None for time in timestamps) else None
    order = np.array(numbers, np.int64).reshape(-1, 1)
    ids = np.hstack([order, order, order + 1])
    return Trajectory(np.array(poses, np.float64).reshape(-1, 4, 4), timestamps=times, ids=ids)


def write_pose(path: FilePath, T: NDArray[np.float64], *, overwrite: bool = True) -> None:
    """Write a 4x4 pose as text with all digits, atomically."""
    text = "".join(" ".join(repr(float(value)) for value in row) + "\n" for row in T)
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(text.encode("ascii"))
