"""Fusion of posed RGB-D frames into a mesh file: `fuse_folder`."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable
from typing import Any

from ...cameras.depth_range import DEPTH_MAX
from ...cameras.pose_files import trajectory_of
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...core.reports import Fields
from ...core.timing import Clock
from ...core.wording import format_bytes, format_seconds
from ...rgbd.fusion.fuse import VOXEL_SIZE, fuse
from ...rgbd.fusion.results import FusionResult
from .frame_folder import FolderOptions, FrameFolder, FramesReport
from .model_outputs import ModelOutputs


@dataclasses.dataclass(frozen=True, eq=False)
class FuseReport(FramesReport):
    result: FusionResult

    def to_dict(self) -> dict[str, Any]:
        figures = self.result.to_dict()
        refinement = figures.pop("refinement")
        report = {"command": self.done.command, **self.folder.to_dict(), **figures}
        return report | self.ending_to_dict(refinement=refinement)

    def fields(self) -> Fields:
        fields = self.folder.among(self.result.fields(), before="voxels")
        return fusion_fields(fields, self.done.seconds, self.peak, self.done.files)


def fusion_fields(fields: Fields, seconds: dict[str, float], peak: int, files: Iterable[str]) -> Fields:
    """Fields of a FusionResult with cost and written files."""
    at = next(k for k, (name, _) in enumerate(fields) if name == "memory")  # notes follow
    return [
        *fields[:at],
        ("seconds", format_seconds(seconds)),
        ("memory", f"{fields[at][1]}, {format_bytes(peak)} at most"),
        *fields[at + 1 :],
        ("files", ", ".join(files) or "none"),
    ]


def fuse_folder(
    folder: FilePath,
    outputs: ModelOutputs,
    *,
    options: FolderOptions | None = None,
    voxel_size: float = VOXEL_SIZE,
    truncation: float | None = None,
    depth_max: float = DEPTH_MAX,
    refine: bool = False,
    device: DeviceLike = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> FuseReport:
    """Fuse a folder of frames into a mesh file and its image. Outputs are checked before the work.

    An empty mesh and its poses are not written. See `loom.rgbd.fuse` for the other arguments and errors.
    """
    outputs.check(overwrite=overwrite)
    where, clock = resolve_device(device), Clock()
    opened = FrameFolder.open_posed(folder, options or FolderOptions())
    clock.stop("open")
    sizes: dict[str, Any] = {"voxel_size": voxel_size, "truncation": truncation, "depth_max": depth_max}
    result = fuse(opened.dataset, **sizes, refine=refine, device=where, progress=progress, clock=clock)
    files = []
    if len(result.mesh):
        times = [frame.timestamp for frame in opened.dataset.frames]
        path = trajectory_of(result.T_world_camera, range(len(times)), times)
        files += outputs.write_mesh(result.mesh, result.T_world_camera, overwrite=overwrite)
        files += outputs.write_trajectory(path, overwrite=overwrite)
        clock.stop("write")
    done = opened.done("fuse", clock, files, *result.warnings)
    return FuseReport(done, opened, result)
