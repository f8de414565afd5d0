"""`pointloom reconstruct --method slam`: tracking against the model, loops between submaps, and the surface of all."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..meshing.mesh import TriangleMesh
from ..meshing.tsdf import TSDFVolume
from ..pcd.io.trajectory import Trajectory
from .console import Clock, ReportProgress
from .frames import READ_AHEAD, FrameSource
from .fuse import least_weight
from .slam.loops import LoopClosure, close_loops, corrected_trajectory, fuse_submaps
from .slam.submaps import Submap, SubmapRecorder
from .track import Tracking, describe_tracking, make_slam, track_frames, why_tracking_poor

Matrix = NDArray[np.float64]


@dataclasses.dataclass(frozen=True, eq=False)
class Reconstruction:
    """What a method makes of the frames.

    Args:
        mesh: The surface; empty where nothing was seen often enough.
        trajectory: The poses of the frames that have one, in the frame of the mesh; ids hold the frames' numbers.
        report: What else is to be told, in JSON's types.
        poor: What is wrong with it, for each kind of fault a reason or None.
    """

    mesh: TriangleMesh
    trajectory: Trajectory
    report: dict[str, Any]
    poor: list[str | None]


def run_slam(
    dataset: FrameSource,
    *,
    voxel_size: float,
    depth_max: float,
    device: Any,
    progress: ReportProgress,
    clock: Clock,
    read_ahead: int = READ_AHEAD,
) -> Reconstruction:
    """Track each frame against the model of those before it, close the loops, and take the surface.

    Args:
        dataset: Frames of one camera, in their order.
        voxel_size: Edge of a voxel [m].
        depth_max: Farther depth is left out [m].
        device: Where to compute.
        progress: Called with the stage, how many of its steps are done, and how many there are.
        clock: Counts the time of the stages.
        read_ahead: As of `fuse_dataset`.

    Raises:
        FileError: No frame can be read.
    """
    slam = make_slam(dataset, voxel_size=voxel_size, depth_max=depth_max, device=device)
    limits: dict[str, Any] = {"voxel_size": voxel_size, "depth_scale": dataset.depth_scale, "depth_max": depth_max}
    recorder: SubmapRecorder | None = None

    def record(number: int, frame: Any, step: Any) -> None:
        nonlocal recorder
        if recorder is None:
            recorder = SubmapRecorder(dataset.intrinsic, **limits, color=frame.color is not None, device=device)
        if step.pose is None or step.fused:
            recorder.add(frame.depth, step.pose, frame.color, number)

    options: dict[str, Any] = {"depth_max": depth_max, "read_ahead": read_ahead, "progress": progress, "clock": clock}
    found = track_frames(dataset, slam, record=record, **options)
    submaps = [] if recorder is None else recorder.finish()
    volume, loops = _closed(submaps, found, progress)
    clock.stop("loops")
    progress("extract", 0, 0)
    volume = volume or slam.volume
    mesh = volume.extract_triangle_mesh(weight_threshold=least_weight(len(found.placed)))
    clock.stop("extract")
    report = {"voxel_size": voxel_size, "depth_max": depth_max, **describe_tracking(found, clock), **loops}
    return Reconstruction(mesh, found.trajectory, report, why_tracking_poor(report))


def _closed(
    submaps: list[Submap], found: Tracking, progress: ReportProgress
) -> tuple[TSDFVolume | None, dict[str, Any]]:
    """The volume of the submaps where loops put them, and what is told of these; poses are corrected in place."""
    told: dict[str, Any] = {"submaps": len(submaps), "loops": [], "refused_loops": 0, "corrected_m": 0.0}
    if len(submaps) < 2:
        return None, told
    closure = close_loops(submaps, progress=progress)
    told |= {"loops": [[loop.target, loop.source] for loop in closure.loops], "refused_loops": len(closure.refused)}
    if not closure.loops:
        return None, told
    told["corrected_m"] = _correct(submaps, closure, found)
    return fuse_submaps(submaps, closure.T_world_submap), told


def _correct(submaps: list[Submap], closure: LoopClosure, found: Tracking) -> float:
    """Move the poses that were found as their submaps moved; gives the farthest that one went [m]."""
    numbers, poses = corrected_trajectory(submaps, closure.T_world_submap)
    before = dict(zip(found.placed, found.poses, strict=True))
    moves = [pose @ np.linalg.inv(before[number]) for number, pose in zip(numbers.tolist(), poses, strict=True)]
    farthest = 0.0
    for place, number in enumerate(found.placed):  # a frame that is not fused goes with the nearest that is
        moved = moves[int(np.argmin(np.abs(numbers - number)))] @ found.poses[place]
        farthest = max(farthest, float(np.linalg.norm(moved[:3, 3] - found.poses[place][:3, 3])))
        found.poses[place] = moved
    return farthest


def loop_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """The loops as labels and values for the terminal."""
    if not report["loops"]:
        return [("loops", "none")]
    count = f"{len(report['loops'])} closed among {report['submaps']} submaps"
    return [("loops", f"{count}, which moved frames by {report['corrected_m'] * 1000:.1f} mm at most")]
