"""A folder of posed RGB-D frames to a mesh file: `fuse_folder`."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable
from typing import Any

from ...cameras.pose_files import trajectory_of
from ...core.devices import resolve_device
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...core.reports import Fields
from ...core.timing import Clock
from ...core.wording import format_bytes, format_seconds
from ...files.frames.frames import DEPTH_MAX
from ...rgbd.fusion.fuse import VOXEL_SIZE, fuse
from ...rgbd.fusion.results import FusionResult
from .frame_folder import FolderOptions, FrameFolder, FramesReport
from .model_outputs import ModelOutputs


@dataclasses.dataclass(frozen=True, eq=False)
class FuseReport(FramesReport):
    """What `pointloom fuse` did; `result` is what was made of the frames."""

    result: FusionResult

    def to_dict(self) -> dict[str, Any]:
        """The report, in JSON's types."""
        figures = self.result.to_dict()
        refinement = figures.pop("refinement")
        report = {"command": self.done.command, **self.folder.to_dict(), **figures}
        return report | self.ending_to_dict(refinement=refinement)

    def fields(self) -> Fields:
        """The report as labels and values for the terminal."""
        told = self.folder.among(self.result.fields(), before="voxels")
        return fusion_fields(told, self.done.seconds, self.peak, self.done.files)


def fusion_fields(told: Fields, seconds: dict[str, float], peak: int, files: Iterable[str]) -> Fields:
    """What a FusionResult tells, with what the work cost and what was written."""
    *told, (memory, volume) = told
    return [
        *told,
        ("seconds", format_seconds(seconds)),
        (memory, f"{volume}, {format_bytes(peak)} at most"),
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
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> FuseReport:
    """Fuse a folder of frames into a mesh file, and a picture of it; outputs are checked before the work.

    Args:
        folder: As `open_dataset` takes it.
        outputs: What is written. An empty mesh is not, nor its poses.
        options: Which frames of the folder; None for all, as they lie there.
        voxel_size, truncation, depth_max, refine, device, progress: As `loom.fuse`.
        overwrite: Replace outputs that exist.

    Raises:
        FileError: A file that cannot be read, or an output that cannot be written.
        ValueError, DeviceError: As `loom.fuse`.
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
    done = opened.done("fuse", clock, files, *result.warnings, opened.camera_problem)
    return FuseReport(done, opened, result)
