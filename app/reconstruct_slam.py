"""`pointloom reconstruct --method slam`: tracking against the model, loops between submaps, and the surface of all."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from ..meshing.mesh import TriangleMesh
from ..meshing.tsdf import TSDFVolume
from ..pcd.io.trajectory import Trajectory
from .console import Clock, ReportProgress
from .frames import READ_AHEAD, FrameSource
from .slam.submaps import FRAMES as SUBMAP_FRAMES
from .surface_weights import least_weight
from .track import Tracking, describe_tracking, make_slam, track_frames, why_tracking_poor


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
    sizes: dict[str, Any] = {"voxel_size": voxel_size, "depth_max": depth_max}
    slam = make_slam(dataset, **sizes, submap_frames=SUBMAP_FRAMES, device=device)
    options: dict[str, Any] = {"depth_max": depth_max, "read_ahead": read_ahead, "progress": progress, "clock": clock}
    found = track_frames(dataset, slam, **options)
    volume, loops = _close_loops(slam, found, progress)
    clock.stop("loops")
    progress("extract", 0, 0)
    mesh = volume.extract_triangle_mesh(weight_threshold=least_weight(len(found.placed)))
    clock.stop("extract")
    report = {**sizes, **describe_tracking(found, clock), **loops}
    return Reconstruction(mesh, found.trajectory, report, why_tracking_poor(report))


def _close_loops(slam: Any, found: Tracking, progress: ReportProgress) -> tuple[TSDFVolume, dict[str, Any]]:
    """The surface, and what is told of the loops; the poses that were found are corrected in place."""
    told: dict[str, Any] = {"submaps": 0, "loops": [], "refused_loops": 0, "corrected_m": 0.0}
    volume = slam.volume  # as it was tracked: where no loop is closed, it is not to be made anew from its submaps
    if not slam.model.frame_count:
        return volume, told
    closure = slam.close_loops(progress=progress)
    told |= {"submaps": len(closure.T_world_submap), "refused_loops": len(closure.refused)}
    if not closure.loops:
        return volume, told
    told["loops"] = [[loop.target, loop.source] for loop in closure.loops]
    before, found.poses = found.poses, [result.pose for result in slam.results if result.pose is not None]
    shifts = [np.linalg.norm(new[:3, 3] - old[:3, 3]) for new, old in zip(found.poses, before, strict=True)]
    told["corrected_m"] = float(max(shifts))
    return slam.volume, told


def loop_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """The loops as labels and values for the terminal."""
    if not report["loops"]:
        return [("loops", "none")]
    count = f"{len(report['loops'])} closed among {report['submaps']} submaps"
    return [("loops", f"{count}, which moved frames by {report['corrected_m'] * 1000:.1f} mm at most")]
