"""How far a trajectory lies from the true one: `evaluate_files`."""

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
from ...drawing.render.picture_files import save_picture
from ...kernels.linear_algebra import inv
from ...registration.trajectories.trajectory_error import TrajectoryError, evaluate_trajectory

KITTI_EXTRINSICS = ("Tr", "Tr_velo_to_cam", "Tr_velo_cam")  # velodyne to camera, in its calibration files

# How the estimate is brought onto the truth: arguments of `evaluate_trajectory`.
ALIGNMENTS: dict[str, dict[str, Any]] = {
    "none": {"align": None},
    "first": {"align": "first"},
    "se3": {"align": True},
    "sim3": {"align": True, "with_scale": True},
}


@dataclass(frozen=True)
class EvaluateReport(Report, Assessed):
    """What `evaluate_files` found.

    Attributes:
        poses, truth: The files that were compared.
        found: The errors.
        files: What was written.
    """

    poses: str
    truth: str
    found: TrajectoryError
    files: tuple[str, ...] = ()

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks; empty if the result is reliable."""
        return self.found.warnings

    def to_dict(self) -> dict[str, Any]:
        """All of it on one level."""
        read = {"command": "evaluate", "poses": self.poses, "truth": self.truth}
        return read | self.found.to_dict() | {"files": list(self.files), **quality(self)}

    def fields(self) -> Fields:
        """The errors, and the picture where there is one."""
        return self.found.fields() + [("files", ", ".join(self.files))] * bool(self.files)


def evaluate_files(
    poses: FilePath,
    truth: FilePath,
    *,
    align: str = "se3",
    extrinsic: FilePath | None = None,
    picture: FilePath | None = None,
    overwrite: bool = False,
) -> EvaluateReport:
    """The errors of a file of poses.

    Args:
        poses: The trajectory to judge: .log, .tum, .kitti, .txt or .json.
        truth: The true one, in any of these formats.
        align: One of ALIGNMENTS.
        extrinsic: A file of T_truth_estimate between the sensors, where they are two of one body: four rows of four
            numbers, or KITTI's calib.txt with its `Tr`.
        picture: A .png file for a picture of both paths.
        overwrite: Replace the picture if it exists.

    Raises:
        FileError: A file that cannot be read or written, or trajectories that do not belong together.
        ValueError: No such alignment.
    """
    if align not in ALIGNMENTS:
        raise ValueError(f"align: expected one of {', '.join(ALIGNMENTS)}, got {align!r}")
    if picture is not None:
        from ...drawing.render.plots import check_plot  # loads kernels, which the errors alone do not need

        check_plot(picture, overwrite=overwrite)
    estimate, true_path = read_trajectory(poses), read_trajectory(truth)
    T = None if extrinsic is None else read_extrinsic(extrinsic)
    found = compare(estimate, true_path, poses, truth, align, T)
    files: tuple[str, ...] = ()
    if picture is not None:
        title = f"{Path(poses).name} against {Path(truth).name}, aligned by {align}"
        sensor = np.eye(4) if T is None else inv(T)
        save_picture(picture, _draw_paths(estimate, true_path, found, title, sensor), overwrite=overwrite)
        files = (os.fspath(picture),)
    return EvaluateReport(os.fspath(poses), os.fspath(truth), found, files)


def read_extrinsic(path: FilePath) -> NDArray[np.float64]:
    """The pose of a sensor in another one: a matrix, or the line `Tr` of KITTI's calib.txt.

    Raises:
        FileError: Neither.
    """
    lines = read_lines(path)
    found = [(number, columns[1:]) for number, columns in lines if columns[0].rstrip(":") in KITTI_EXTRINSICS]
    return read_pose(path) if not found else kitti_poses(path, found[:1], gaps=False)[0]


def compare(
    estimate: Trajectory,
    truth: Trajectory,
    poses: FilePath,
    true_path: FilePath,
    align: str,
    extrinsic: NDArray[np.float64] | None = None,
) -> TrajectoryError:
    """The errors of a trajectory; the paths name the two in messages.

    Raises:
        FileError: Trajectories that do not belong together.
    """
    if (estimate.timestamps is None or truth.timestamps is None) and len(estimate) != len(truth):
        reason = f"has {len(estimate)} poses, and {os.fspath(true_path)} has {len(truth)}"
        remedy = "Give files with as many poses, or both as TUM with timestamps"
        raise FileError(poses, reason, remedy=remedy)
    try:
        return evaluate_trajectory(estimate, truth, extrinsic=extrinsic, **ALIGNMENTS[align])
    except ValueError as error:
        raise FileError(poses, f"cannot be compared with {os.fspath(true_path)}: {error}") from error


def _draw_paths(
    estimate: Trajectory, truth: Trajectory, found: TrajectoryError, title: str, sensor: NDArray[np.float64]
) -> NDArray[np.uint8]:
    """Both paths where they were compared, the estimate as it was aligned."""
    from ...drawing.render.plots import trajectory_plot

    rows, true_rows = found.pairs.T
    T = found.transformation
    path = (estimate.poses[rows] @ sensor)[:, :3, 3] @ T[:3, :3].T + T[:3, 3]
    times = None if truth.timestamps is None else truth.timestamps[true_rows]
    return trajectory_plot(path, truth.poses[true_rows, :3, 3], times=times, title=title)
