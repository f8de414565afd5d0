"""The path of a scanner from a folder of its scans: `odometry_of_folder`."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..pcd.devices import resolve_device
from ..pcd.errors import FileError
from ..pcd.io.point_cloud import read_point_cloud
from ..pcd.io.trajectory import Trajectory, read_trajectory, write_trajectory
from ..registration.lidar_odometry import LidarOdometry
from ..registration.lidar_steps import OdometrySummary, summarize_steps
from ..registration.scan_files import list_scans
from .clouds import FilePath
from .console import Clock, ReportProgress, format_seconds, format_share, say_nothing
from .evaluate import compare, error_fields
from .tables import check_output
from .trajectory_report import some_runs

FORMATS = {"kitti": (".txt", ".kitti"), "tum": (".txt", ".tum")}  # extensions of each

# A loop that stands still between two places is common and harmless; where more of the scans do not come to rest than
# this, there is no place where they fit.
_MOST_UNSETTLED = 0.2


def odometry_of_folder(
    folder: FilePath,
    output: FilePath,
    *,
    format: str | None = None,
    voxel_size: float | None = None,
    max_range: float = 100.0,
    min_range: float = 5.0,
    truth: FilePath | None = None,
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Find the pose of each scan of a folder, and write them; the output and the truth are checked before the work.

    Args:
        folder: The scans, in natural order of their names: .bin as KITTI has them, or clouds.
        output: A file of poses: .txt, .kitti or .tum.
        format: "kitti" or "tum"; None goes by the extension, and takes KITTI's for .txt. TUM's times are the numbers
            of the scans.
        voxel_size, max_range, min_range: As of `LidarOdometry`.
        truth: A file of the scanner's true poses, one a scan.
        device: Where to compute.
        overwrite: Replace the output if it exists.
        progress: Called with the number of scans done and that of all.

    Returns:
        What was done, in JSON's types; "poor" says why the result is poor, or is None; "errors" is as of
        `evaluate_files`, aligned by se3, where the truth is given. Nothing is written where no scan has points in
        range.

    Raises:
        FileError: A file that cannot be read or written, fewer than two scans, or not one true pose a scan.
        ValueError: A length out of range.
        DeviceError: No such device.
    """
    form, where, clock = _check_output(output, format, overwrite), resolve_device(device), Clock()
    odometry = LidarOdometry(voxel_size=voxel_size, max_range=max_range, min_range=min_range, device=where)
    scans = list_scans(folder)
    if len(scans) < 2:
        raise FileError(folder, f"holds one scan, {scans[0].name}; odometry needs two", remedy="Give another folder")
    true_path = None if truth is None else read_trajectory(truth)
    if true_path is not None and len(true_path) != len(scans):
        reason = f"has {len(true_path)} poses, and {os.fspath(folder)} has {len(scans)} scans"
        raise FileError(truth or "", reason, remedy="Give the true pose of each scan")
    say, points = progress or say_nothing, 0
    say("scans", 0, len(scans))
    for done, path in enumerate(scans, 1):
        clock.restart()
        scan = read_point_cloud(path, device=where)
        clock.stop("read")
        odometry.register(scan)
        clock.stop("register")
        points += len(scan)
        say("scans", done, len(scans))
    summary, files = summarize_steps(odometry.steps), []
    path = Trajectory(odometry.poses)
    seen = any(step.reason != "no points in range" for step in odometry.steps)
    if seen:
        clock.restart()
        write_trajectory(output, path, format=form, overwrite=overwrite)
        clock.stop("write")
        files = [os.fspath(output)]
    errors = None if true_path is None or truth is None or not seen else compare(path, true_path, folder, truth, "se3")
    poor = _why_poor(summary, seen, max_range, min_range)
    report = {"command": "odometry", "folder": os.fspath(folder), "format": form, "device": str(where)}
    sizes = {"voxel_size": odometry.voxel_size, "max_range": max_range, "min_range": min_range}
    figures = _describe(summary, points, clock.seconds["register"])
    return report | sizes | figures | {"errors": errors, "seconds": clock.seconds, "files": files, "poor": poor}


def odometry_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    size = f"{report['voxel_size']:g} m"
    fields = [
        ("scans", f"{report['scans']:,}, {report['points']:,} points, {report['scans_per_second']:.1f} scans/s"),
        ("map", f"voxels of {size}, points from {report['min_range']:g} to {report['max_range']:g} m"),
        ("path", f"{report['path_length_m']:.2f} m"),
    ]
    if report["mean_fitness"] == report["mean_fitness"]:  # a scan was matched
        fit = (
            f"fitness {format_share(report['mean_fitness'])} and {report['mean_iterations']:.1f} iterations on average"
        )
        fields.append(("fit", fit))
    for name, label in (("predicted", "predicted"), ("strayed", "beside map"), ("unsettled", "not at rest")):
        if report[name]:
            fields.append((label, f"{len(report[name]):,}: {_scans(report[name])}"))
    if report["errors"] is not None:
        fields += error_fields(report["errors"])
    return [
        *fields,
        ("seconds", f"{format_seconds(report['seconds'])} on {report['device']}"),
        ("files", ", ".join(report["files"]) or "none"),
    ]


def _check_output(output: FilePath, format: str | None, overwrite: bool) -> str:
    """The format of the poses, once it is sure that they can be written."""
    suffix = Path(output).suffix.lower()
    if format is None:
        format = "tum" if suffix == ".tum" else "kitti"
    if format not in FORMATS:
        raise ValueError(f"format: expected one of {', '.join(FORMATS)}, got {format!r}")
    check_output(output, FORMATS[format], what=f"poses as {format}", overwrite=overwrite)
    return format


def _describe(summary: OdometrySummary, points: int, seconds: float) -> dict[str, Any]:
    return {
        "scans": summary.scan_count,
        "points": points,
        "scans_per_second": summary.scan_count / max(seconds, 1e-9),
        "path_length_m": summary.distance,
        "mean_fitness": summary.mean_fitness,
        "mean_iterations": summary.mean_iterations,
        "predicted": list(summary.predicted),
        "strayed": list(summary.strayed),
        "unsettled": list(summary.unsettled),
    }


def _why_poor(summary: OdometrySummary, seen: bool, max_range: float, min_range: float) -> str | None:
    reach = f"from {min_range:g} to {max_range:g} m of the scanner"
    if not seen:
        return f"no scan has points {reach}; nothing was written; change --min-range or --max-range"
    reasons, count = [], summary.scan_count
    if torn := summary.predicted:
        reasons.append(
            f"{len(torn)} of {count} scans do not overlap those before them, or have no points {reach}, so the path "
            f"may be torn at {_scans(torn)}"
        )
    if strayed := summary.strayed:
        reasons.append(
            f"{len(strayed)} of {count} scans lie beside the map of those before them ({_scans(strayed)}), so the path "
            f"is likely lost from scan {strayed[0]} on; give scans that lie closer together, or another --max-range"
        )
    unsettled = summary.unsettled
    if not strayed and len(unsettled) > _MOST_UNSETTLED * (count - 1):
        reasons.append(f"{len(unsettled)} of {count} scans did not come to rest on the map ({_scans(unsettled)})")
    return "; ".join(reasons) or None


def _scans(numbers: Sequence[int]) -> str:
    return f"scan {some_runs(numbers)}"
