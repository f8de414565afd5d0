"""How far a trajectory lies from the true one: `evaluate_files`."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..pcd.errors import FileError
from ..pcd.io.trajectory import Trajectory, read_trajectory
from ..registration.trajectory_error import ErrorStatistics, TrajectoryError, evaluate_trajectory
from .clouds import FilePath
from .pictures.picture_files import check_picture, save_picture

# How the estimate is brought onto the truth: arguments of `evaluate_trajectory`.
ALIGNMENTS: dict[str, dict[str, Any]] = {
    "none": {"align": None},
    "first": {"align": "first"},
    "se3": {"align": True},
    "sim3": {"align": True, "with_scale": True},
}


def evaluate_files(
    poses: FilePath,
    truth: FilePath,
    *,
    align: str = "se3",
    picture: FilePath | None = None,
    overwrite: bool = False,
) -> dict[str, Any]:
    """The errors of a file of poses.

    Args:
        poses: The trajectory to judge: .log, .tum, .kitti, .txt or .json.
        truth: The true one, in any of these formats.
        align: One of ALIGNMENTS.
        picture: A .png file for a picture of both paths.
        overwrite: Replace the picture if it exists.

    Returns:
        The errors, in JSON's types: "absolute" (ATE), "relative" (RPE, from each pose to the next), "segments" (over
        lengths of the path, as KITTI has them).

    Raises:
        FileError: A file that cannot be read or written, or trajectories that do not belong together.
        ValueError: No such alignment.
    """
    if align not in ALIGNMENTS:
        raise ValueError(f"align: expected one of {', '.join(ALIGNMENTS)}, got {align!r}")
    if picture is not None:
        check_picture(picture, overwrite=overwrite)
    estimate, true_path = read_trajectory(poses), read_trajectory(truth)
    found = _find_errors(estimate, true_path, poses, truth, align)
    files = []
    if picture is not None:
        title = f"{Path(poses).name} against {Path(truth).name}, aligned by {align}"
        save_picture(picture, _draw_paths(estimate, true_path, found, title), overwrite=overwrite)
        files.append(os.fspath(picture))
    report = {"command": "evaluate", "poses": os.fspath(poses), "truth": os.fspath(truth)}
    return report | {"align": align, **describe_errors(found), "files": files, "poor": None}


def evaluate_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """The errors of files as labels and values for the terminal."""
    return error_fields(report) + [("files", ", ".join(report["files"]))] * bool(report["files"])


def compare(
    estimate: Trajectory, truth: Trajectory, poses: FilePath, true_path: FilePath, align: str
) -> dict[str, Any]:
    """The errors of a trajectory in JSON's types; the paths name the two in messages.

    Raises:
        FileError: Trajectories that do not belong together.
    """
    return {"align": align, **describe_errors(_find_errors(estimate, truth, poses, true_path, align))}


def _find_errors(
    estimate: Trajectory, truth: Trajectory, poses: FilePath, true_path: FilePath, align: str
) -> TrajectoryError:
    if (estimate.timestamps is None or truth.timestamps is None) and len(estimate) != len(truth):
        reason = f"has {len(estimate)} poses, and {os.fspath(true_path)} has {len(truth)}"
        remedy = "Give files with as many poses, or both as TUM with timestamps"
        raise FileError(poses, reason, remedy=remedy)
    try:
        return evaluate_trajectory(estimate, truth, **ALIGNMENTS[align])
    except ValueError as error:
        raise FileError(poses, f"cannot be compared with {os.fspath(true_path)}: {error}") from error


def _draw_paths(estimate: Trajectory, truth: Trajectory, found: TrajectoryError, title: str) -> NDArray[np.uint8]:
    """Both paths where they were compared, the estimate as it was aligned."""
    from .pictures.trajectory_plot import trajectory_plot  # which starts what runs kernels: figures alone need none

    rows, true_rows = found.pairs.T
    T = found.transformation
    path = estimate.poses[rows, :3, 3] @ T[:3, :3].T + T[:3, 3]
    times = None if truth.timestamps is None else truth.timestamps[true_rows]
    return trajectory_plot(path, truth.poses[true_rows, :3, 3], times=times, title=title).to_numpy()


def describe_errors(found: TrajectoryError) -> dict[str, Any]:
    """Errors in JSON's types, [m] and [degrees]."""
    return {
        "compared": len(found.pairs),
        "scale": found.scale,
        "transformation": found.transformation.tolist(),
        "absolute": {"m": _figures(found.absolute_translation), "deg": _figures(found.absolute_rotation)},
        "relative": {"m": _figures(found.relative_translation), "deg": _figures(found.relative_rotation)},
        "segments": [
            {"length_m": s.length, "percent": s.translation, "deg_per_m": s.rotation, "count": s.count}
            for s in found.segments
        ],
        "segment_percent": found.segment_translation,
        "segment_deg_per_m": found.segment_rotation,
    }


def error_fields(errors: dict[str, Any]) -> list[tuple[str, str]]:
    """Errors as labels and values for the terminal."""
    scale = f", scale {errors['scale']:.6g}" if errors["align"] == "sim3" else ""
    relative = "none: too few poses"
    if errors["relative"]["m"]["count"]:
        turn = errors["relative"]["deg"]["rmse"]
        relative = f"{_line(errors['relative']['m'])}; {turn:.4g} degrees rmse, from pose to pose"
    fields = [  # no angles of the ATE: alignment goes by positions, and those of a nearly straight path fix no turn
        ("compared", f"{errors['compared']:,} poses, aligned by {errors['align']}{scale}"),
        ("ATE", _line(errors["absolute"]["m"])),
        ("RPE", relative),
    ]
    if errors["segments"]:
        lengths = ", ".join(f"{segment['length_m']:g}" for segment in errors["segments"])
        mean = f"{errors['segment_percent']:.3f} %, {errors['segment_deg_per_m']:.5f} degrees/m"
        fields.append(("segments", f"{mean} over {lengths} m"))
    return fields


def _figures(statistics: ErrorStatistics) -> dict[str, float]:
    names = ("rmse", "mean", "median", "std", "max", "count")
    return {name: getattr(statistics, name) for name in names}


def _line(shift: dict[str, Any]) -> str:
    return f"{shift['rmse']:.4g} m rmse, {shift['median']:.4g} median, {shift['max']:.4g} at most"
