"""The path of a camera from its RGB-D frames: `track_frames` for any sequence, `track_folder` for one on disk."""

from __future__ import annotations

import contextlib
import dataclasses
import os
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..pcd.devices import resolve_device
from ..pcd.errors import FileError
from ..pcd.io.trajectory import Trajectory
from .camera_check import check_focal, why_focal_doubted
from .console import Clock, ReportProgress, format_bytes, format_seconds, format_share, peak_bytes, say_nothing
from .evaluate import error_fields
from .frames import (
    DEPTH_MAX,
    READ_AHEAD,
    FilePath,
    FrameSource,
    camera_line,
    describe_folder,
    measured_shares,
    open_folder,
    read_frames_or_errors,
    why_doubted,
    why_incomplete,
    why_out_of_reach,
)
from .trajectory_report import (
    check_trajectory_output,
    errors_against_truth,
    path_length,
    some_frames,
    trajectory_of,
    write_poses,
)

VOXEL_SIZE = 0.02  # [m] of the model that frames are held against

MANY_UNCERTAIN = 0.2  # share of the frames with an uncertain pose, beyond which the path is not to be believed


@dataclasses.dataclass
class Tracking:
    """What became of the frames of a sequence, by their numbers in it, from 0.

    Args:
        count: How many frames there were.
        placed: Frames that have a pose.
        poses: T_world_camera of each of these, [4, 4] [m].
        timestamps: Its time [s], or None.
        true_poses: The true one, or None where nobody knows it.
        uncertain: Frames whose pose is told with a doubt.
        lost: Frames that could not be placed, and why.
        unreadable: Frames that could not be read, and why.
        residuals: Root mean square distance [m] from the model of each placed frame after the first.
        fitness: Share of its depth that lies on the model.
        shares: Shares of the pixels of each frame that have a depth, and one in reach.
    """

    count: int = 0
    placed: list[int] = dataclasses.field(default_factory=list)
    poses: list[NDArray[np.float64]] = dataclasses.field(default_factory=list)
    timestamps: list[float | None] = dataclasses.field(default_factory=list)
    true_poses: list[NDArray[np.float64] | None] = dataclasses.field(default_factory=list)
    uncertain: list[int] = dataclasses.field(default_factory=list)
    lost: dict[int, str] = dataclasses.field(default_factory=dict)
    unreadable: dict[int, str] = dataclasses.field(default_factory=dict)
    residuals: list[float] = dataclasses.field(default_factory=list)
    fitness: list[float] = dataclasses.field(default_factory=list)
    shares: list[tuple[float, float]] = dataclasses.field(default_factory=list)

    @property
    def trajectory(self) -> Trajectory:
        """The poses of the frames that have one, with their numbers and times."""
        return trajectory_of(self.poses, self.placed, self.timestamps)

    def share_of_pixels(self) -> tuple[float, float]:
        """The mean shares over all frames that could be read; 0 where there is none."""
        return tuple(np.mean(self.shares, axis=0).tolist()) if self.shares else (0.0, 0.0)


def track_frames(
    dataset: FrameSource,
    slam: Any,
    *,
    depth_max: float = DEPTH_MAX,
    read_ahead: int = READ_AHEAD,
    progress: ReportProgress | None = None,
    clock: Clock | None = None,
) -> Tracking:
    """Track each frame against the model of those before it, and fold it into the model.

    Args:
        dataset: Frames of one camera, in their order; their poses are kept as the truth and tell the tracker nothing.
        slam: A `DenseSLAM` of that camera.
        depth_max: Up to where depth counts as seen [m].
        read_ahead: As of `fuse_dataset`.
        progress: Called with the stage, how many of its steps are done, and how many there are.
        clock: Counts the time of the stages.

    Raises:
        FileError: No frame can be read.
    """
    found, say, clock = Tracking(len(dataset)), progress or say_nothing, clock or Clock()
    first_error: FileError | None = None
    say("frames", 0, found.count)
    with contextlib.closing(read_frames_or_errors(dataset, read_ahead)) as frames:
        for number, frame in enumerate(frames):
            clock.stop("read")
            if isinstance(frame, FileError):
                first_error = first_error or frame
                found.unreadable[number] = str(frame)
            else:
                _track(found, number, frame, slam, depth_max * _depth_scale(dataset, frame))
                clock.stop("track")
            say("frames", number + 1, found.count)
    if first_error is not None and len(found.unreadable) == found.count:
        raise first_error
    return found


def make_slam(
    dataset: FrameSource, *, voxel_size: float, depth_max: float, device: Any, submap_frames: int | None = None
) -> Any:
    """A tracker for the frames of a data set; one that can close loops where it keeps submaps."""
    from .slam import DenseSLAM

    options: dict[str, Any] = {"depth_scale": dataset.depth_scale, "depth_max": depth_max, "device": device}
    return DenseSLAM(dataset.intrinsic, voxel_size=voxel_size, submap_frames=submap_frames, **options)


def _depth_scale(dataset: FrameSource, frame: Any) -> float:
    return dataset.depth_scale if frame.depth.dtype.kind in "iu" else 1.0


def _track(found: Tracking, number: int, frame: Any, slam: Any, farthest: float) -> None:
    """One frame: its pose, and its part of the model."""
    found.shares.append(measured_shares(frame.depth, farthest))
    step = slam.step(frame)
    if step.pose is None:
        found.lost[number] = step.reason
        return
    if not step.is_tracked:
        found.uncertain.append(number)
    found.placed.append(number)
    found.poses.append(step.pose)
    found.timestamps.append(getattr(frame, "timestamp", None))
    found.true_poses.append(getattr(frame, "T_world_camera", None))
    if len(found.placed) > 1:  # the first is where the model begins
        found.residuals.append(step.inlier_rmse)
        found.fitness.append(step.fitness)


# ------------------------------------------------------------------------------------------------ folders


def track_folder(
    folder: FilePath,
    output: FilePath,
    *,
    layout: str = "auto",
    intrinsic: FilePath | None = None,
    every: int = 1,
    depth_scale: float | None = None,
    voxel_size: float = VOXEL_SIZE,
    depth_max: float = DEPTH_MAX,
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> dict[str, Any]:
    """Find where each frame of a folder was taken, and write the poses; the output is checked before the work.

    Args:
        folder: As `open_frames` takes it, with `layout` and `every`; poses that lie there are taken as the truth.
        output: A file of poses, T_world_camera with the first frame as the world: .txt or .tum (TUM's format), .log.
        layout, every, depth_scale: As `open_frames`.
        intrinsic: A camera as Open3D's JSON, if it is another than the folder says.
        voxel_size: Edge of a voxel of the model that frames are held against [m].
        depth_max: Farther depth is left out [m].
        device: Where to compute.
        overwrite: Replace the output if it exists.
        progress: Called with the stage, how many of its steps are done, and how many there are.

    Returns:
        What was done, in JSON's types; "poor" says why the result is poor, or is None; "errors" holds ATE and RPE
        where true poses lie beside the frames. Frames that were lost have no pose in the output.

    Raises:
        FileError: A folder of fewer than two frames, a file that cannot be read, an output that cannot be written.
        ValueError: A length out of range.
        DeviceError: No such device.
    """
    form, where, clock = check_trajectory_output(output, overwrite=overwrite), resolve_device(device), Clock()
    dataset = open_folder(folder, layout=layout, intrinsic=intrinsic, every=every, depth_scale=depth_scale)
    if len(dataset) < 2:
        raise FileError(folder, "holds one frame; tracking needs two", remedy="Give another folder")
    clock.stop("open")
    slam = make_slam(dataset, voxel_size=voxel_size, depth_max=depth_max, device=where)
    found = track_frames(dataset, slam, depth_max=depth_max, progress=progress, clock=clock)
    report = {"command": "track", **describe_folder(folder, dataset, intrinsic), "format": form, "device": str(where)}
    report |= {"voxel_size": voxel_size, "depth_max": depth_max} | describe_tracking(found, clock)
    path = found.trajectory
    focal = check_focal(dataset, path, uncertain=found.uncertain, depth_max=depth_max, device=where)
    clock.stop("camera")
    files = []
    if found.placed:
        write_poses(output, path, overwrite=overwrite)
        files.append(os.fspath(output))
        clock.stop("write")
    report |= {"focal": focal, "errors": errors_against_truth(found.poses, found.true_poses)}
    report |= {"seconds": clock.seconds, "peak_bytes": peak_bytes(), "files": files}
    doubts = [why_incomplete(dataset), why_doubted(dataset, report["camera"]["source"]), why_focal_doubted(focal)]
    return report | {"poor": "; ".join(reason for reason in (*why_tracking_poor(report), *doubts) if reason) or None}


def describe_tracking(found: Tracking, clock: Clock) -> dict[str, Any]:
    """The figures of a track, in JSON's types."""
    depth_share, used_share = found.share_of_pixels()
    return {
        "frames": found.count,
        "tracked": len(found.placed),
        "uncertain": found.uncertain,
        "lost": [{"frame": number, "reason": reason} for number, reason in found.lost.items()],
        "unreadable": [{"frame": number, "reason": reason} for number, reason in found.unreadable.items()],
        "depth_share": depth_share,
        "used_share": used_share,
        "residual_m": _median(found.residuals),
        "fitness": _median(found.fitness),
        "path_length_m": path_length(found.trajectory.poses),
        "frames_per_second": found.count / max(clock.seconds.get("track", 0.0), 1e-9),
    }


def track_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """What was done as labels and values for the terminal."""
    return [
        *tracking_fields(report),
        ("model", f"voxels of {report['voxel_size'] * 1000:g} mm"),
        *error_part(report),
        ("seconds", format_seconds(report["seconds"])),
        ("memory", f"{format_bytes(report['peak_bytes'])} at most"),
        ("files", ", ".join(report["files"]) or "none"),
    ]


def tracking_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """The frames, the camera and the path as labels and values."""
    seen = f"{format_share(report['used_share'])} of the pixels within {report['depth_max']:g} m"
    frames = f"{report['frames']} on {report['device']}, {report['frames_per_second']:.1f} frames/s; {seen}"
    if left_out := report["left_out"]:
        frames += f"\n{len(left_out)} left out, the first {left_out[0]}"
    placed = f"{report['tracked']} of {report['frames']}, {report['path_length_m']:.2f} m long"
    fields = [("frames", frames), ("camera", camera_line(report["camera"])), ("path", placed)]
    for name in ("lost", "unreadable"):
        if numbers := [entry["frame"] for entry in report[name]]:
            fields.append((name, f"{len(numbers)}: {some_frames(numbers)}"))
    if report["uncertain"]:
        fields.append(("uncertain", f"{len(report['uncertain'])}: {some_frames(report['uncertain'])}"))
    if report["residual_m"] is not None:
        fit = (
            f"{report['residual_m'] * 1000:.1f} mm off the model, {format_share(report['fitness'])} of the depth on it"
        )
        fields.append(("fit", f"{fit} (medians)"))
    return fields


def error_part(report: dict[str, Any]) -> list[tuple[str, str]]:
    """ATE and RPE as labels and values, where the truth is known."""
    return [] if report["errors"] is None else error_fields(report["errors"])


def why_tracking_poor(report: dict[str, Any]) -> list[str | None]:
    """What is wrong with a track, for each kind of fault a reason or None."""
    count = report["frames"]
    reasons = [why_out_of_reach(report["depth_share"], report["used_share"], report["depth_max"])]
    if lost := report["lost"]:
        numbers = [entry["frame"] for entry in lost]
        reasons.append(
            f"{len(lost)} of {count} frames were lost ({some_frames(numbers)}) and are left out: {lost[0]['reason']}"
        )
    if len(report["uncertain"]) > MANY_UNCERTAIN * count:
        doubtful = report["uncertain"]
        reasons.append(f"{len(doubtful)} of {count} poses are uncertain ({some_frames(doubtful)})")
    if unreadable := report["unreadable"]:
        reasons.append(
            f"{len(unreadable)} of {count} frames cannot be read and are left out: {unreadable[0]['reason']}"
        )
    return reasons


def _median(values: Sequence[float]) -> float | None:
    return float(np.median(values)) if values else None
