"""Errors of a trajectory file: `evaluate_files`."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.pose_text import kitti_poses, read_lines, read_pose
from ...cameras.trajectory import Trajectory, read_trajectory
from ...core.errors import FileError, FilePath
from ...core.reports import Assessed, Fields, Report, quality
from ...kernels.linear_algebra import inv
from ...registration.trajectories.trajectory_error import TrajectoryError, evaluate_trajectory
from ...visualization.render.picture_files import write_image

KITTI_EXTRINSICS = ("Tr", "Tr_velo_to_cam", "Tr_velo_cam")  # velodyne to camera, in its calibration files

# Alignment of the estimate to the truth: arguments of `evaluate_trajectory`.
ALIGNMENTS: dict[str, dict[str, Any]] = {
    "none": {"align": None},
    "first": {"align": "first"},
    "se3": {"align": True},
    "sim3": {"align": True, "with_scale": True},
}


@dataclass(frozen=True)
class EvaluateReport(Report, Assessed):
    poses: str
    truth: str
    result: TrajectoryError
    files: tuple[str, ...] = ()

    @property
    def warnings(self) -> tuple[str, ...]:
        return self.result.warnings

    def to_dict(self) -> dict[str, Any]:
        read = {"command": "evaluate", "poses": self.poses, "truth": self.truth}
        return read | self.result.to_dict() | {"files": list(self.files), **quality(self)}

    def fields(self) -> Fields:
        return self.result.fields() + [("files", ", ".join(self.files))] * bool(self.files)


def evaluate_files(
    poses: FilePath,
    truth: FilePath,
    *,
    align: str = "se3",
    extrinsic: FilePath | None = None,
    picture: FilePath | None = None,
    overwrite: bool = False,
) -> EvaluateReport:
    """Compute the errors of a trajectory file against the true one. Raises FileError or ValueError.

    Reads the formats of `read_trajectory`. `align` is one of ALIGNMENTS, `extrinsic` a file of T_truth_estimate
    between two sensors: 4 rows of 4 numbers, or KITTI's calib.txt with `Tr`. `picture` is a .png file of both paths.
    """
    if align not in ALIGNMENTS:
        raise ValueError(f"align: expected one of {', '.join(ALIGNMENTS)}, got {align!r}")
    if picture is not None:
        from ...visualization.render.plots import check_plot  # imports kernels, which are not needed for the errors

        check_plot(picture, overwrite=overwrite)
    estimate, true_path = read_trajectory(poses), read_trajectory(truth)
    T = None if extrinsic is None else read_extrinsic(extrinsic)
    errors = compare(estimate, true_path, poses, truth, align, T)
    files: tuple[str, ...] = ()
    if picture is not None:
        title = f"{Path(poses).name} against {Path(truth).name}, aligned by {align}"
        sensor = np.eye(4) if T is None else inv(T)
        write_image(picture, _draw_paths(estimate, true_path, errors, title, sensor), overwrite=overwrite)
        files = (os.fspath(picture),)
    return EvaluateReport(os.fspath(poses), os.fspath(truth), errors, files)


def read_extrinsic(path: FilePath) -> NDArray[np.float64]:
    """Extrinsic from a 4x4 matrix or the line `Tr` of KITTI's calib.txt. Raises FileError."""
    lines = read_lines(path)
    matches = [(number, columns[1:]) for number, columns in lines if columns[0].rstrip(":") in KITTI_EXTRINSICS]
    return read_pose(path) if not matches else kitti_poses(path, matches[:1], gaps=False)[0]


def compare(
    estimate: Trajectory,
    truth: Trajectory,
    poses: FilePath,
    true_path: FilePath,
    align: str,
    extrinsic: NDArray[np.float64] | None = None,
) -> TrajectoryError:
    """Errors of a trajectory. Paths are for messages. Raises FileError if the trajectories do not match."""
    if (estimate.timestamps is None or truth.timestamps is None) and len(estimate) != len(truth):
        reason = f"has {len(estimate)} poses, and {os.fspath(true_path)} has {len(truth)}"
        remedy = "Pass files with the same number of poses, or two TUM files with timestamps"
        raise FileError(poses, reason, remedy=remedy)
    try:
        return evaluate_trajectory(estimate, truth, extrinsic=extrinsic, **ALIGNMENTS[align])
    except ValueError as error:
        raise FileError(poses, f"cannot be compared with {os.fspath(true_path)}: {error}") from error


def _draw_paths(
    estimate: Trajectory, truth: Trajectory, errors: TrajectoryError, title: str, sensor: NDArray[np.float64]
) -> NDArray[np.uint8]:
    from ...visualization.render.plots import trajectory_plot

    rows, true_rows = errors.pairs.T
    T = errors.transformation
    path = (estimate.poses[rows] @ sensor)[:, :3, 3] @ T[:3, :3].T + T[:3, 3]
    times = None if truth.timestamps is None else truth.timestamps[true_rows]
    return trajectory_plot(path, truth.poses[true_rows, :3, 3], times=times, title=title)
