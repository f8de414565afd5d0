"""Frame-to-model tracking, loop closure, and the fused surface: `model_by_slam`."""

from __future__ import annotations

import dataclasses
from typing import Any

from ...cameras.trajectory import Trajectory
from ...core.devices import DeviceLike
from ...core.progress import ReportProgress
from ...core.reports import Assessed, Fields, quality
from ...core.timing import Clock
from ...io.frames.frames import FrameSource
from ...io.frames.rgbd_sources import RGBDSource
from ...kernels.linear_algebra import norm
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.volume.surface_weights import min_weight
from ...meshing.volume.tsdf import TSDFVolume
from .dense_slam import DenseSLAM
from .submaps import SUBMAP_FRAMES as SUBMAP_FRAMES
from .tracked_path import TrackedPath
from .tracking import make_slam, track_with


@dataclasses.dataclass(frozen=True, eq=False)
class SlamAccount(Assessed):
    """Result of tracking with loop closure.

    Attributes:
        path: The corrected TrackedPath.
        submap_count: Number of submaps.
        loops: Accepted loop closures (target, source).
        refused_loop_count: Number of rejected pairs.
        corrected: Maximum displacement of a frame [m].
        loop_warnings: Failed quality checks of the pose graph.
    """

    path: TrackedPath
    submap_count: int = 0
    loops: tuple[tuple[int, int], ...] = ()
    refused_loop_count: int = 0
    corrected: float = 0.0
    loop_warnings: tuple[str, ...] = ()

    @property
    def trajectory(self) -> Trajectory:
        """The poses as a Trajectory."""
        return self.path.trajectory

    @property
    def uncertain(self) -> tuple[int, ...]:
        return self.path.uncertain

    @property
    def voxel_size(self) -> float:
        return self.path.voxel_size

    @property
    def depth_max(self) -> float:
        return self.path.depth_max

    @property
    def warnings(self) -> tuple[str, ...]:
        return (*self.path.warnings, *self.loop_warnings)

    def to_dict(self) -> dict[str, Any]:
        return self.path.to_dict() | self.loops_to_dict() | quality(self)

    def loops_to_dict(self) -> dict[str, Any]:
        loops = [list(loop) for loop in self.loops]
        refused = {"refused_loops": self.refused_loop_count, "corrected_m": self.corrected}
        return {"submaps": self.submap_count, "loops": loops, **refused}

    def fields(self, frames_per_second: float | None = None) -> Fields:
        fields = self.path.fields(frames_per_second)
        if not self.loops:
            return [*fields, ("loops", "none")]
        count = f"{len(self.loops)} closed among {self.submap_count} submaps"
        return [*fields, ("loops", f"{count}, which moved frames by {self.corrected * 1000:.1f} mm at most")]


def model_by_slam(
    frames: FrameSource | RGBDSource,
    *,
    voxel_size: float,
    depth_max: float,
    device: DeviceLike,
    read_ahead: int,
    progress: ReportProgress,
    clock: Clock,
) -> tuple[TriangleMesh, SlamAccount]:
    """Track all frames, close the loops, and extract the surface. Arguments as of `loom.rgbd.track`."""
    sizes: dict[str, Any] = {"voxel_size": voxel_size, "depth_max": depth_max, "device": device}
    slam = make_slam(frames, **sizes, submap_frames=SUBMAP_FRAMES)
    path = track_with(slam, frames, **sizes, read_ahead=read_ahead, progress=progress, clock=clock)
    volume, account = _close_loops(slam, path, progress)
    clock.stop("loops")
    progress("extract", 0, 0)
    mesh = volume.extract_triangle_mesh(weight_threshold=min_weight(len(path.trajectory)))
    clock.stop("extract")
    return mesh, account


def _close_loops(slam: DenseSLAM, path: TrackedPath, progress: ReportProgress) -> tuple[TSDFVolume, SlamAccount]:
    volume = slam.volume  # without loop closures the tracked volume is kept
    if not volume.frame_count:
        return volume, SlamAccount(path)
    closure = slam.close_loops(progress=progress)
    counts: dict[str, Any] = {"submap_count": len(closure.T_world_submap), "refused_loop_count": len(closure.refused)}
    # Groups of submaps that no loop connects are no failure here: the tracker has relocalized the camera between them.
    counts["loop_warnings"] = closure.graph_warnings
    if not closure.loops:
        return volume, SlamAccount(path, **counts)
    loops = tuple((loop.target, loop.source) for loop in closure.loops)
    before, poses = path.trajectory.poses, slam.trajectory.poses
    shifts = [norm(new[:3, 3] - old[:3, 3]) for new, old in zip(poses, before, strict=True)]
    corrected = float(max(shifts))
    return slam.volume, SlamAccount(path.with_poses(poses), loops=loops, corrected=corrected, **counts)
