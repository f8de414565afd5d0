"""Camera tracking of a folder of RGB-D frames: `track_folder`."""

from __future__ import annotations

import dataclasses
import os
from typing import Any

from ...cameras.depth_range import DEPTH_MAX
from ...cameras.pose_files import check_trajectory_output, write_poses
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from ...core.reports import Fields, with_warnings
from ...core.timing import Clock
from ...core.wording import plain
from ...rgbd.slam.tracked_path import TrackedPath
from ...rgbd.slam.tracking import VOXEL_SIZE, track
from .frame_folder import FolderOptions, FrameFolder, FramesReport


@dataclasses.dataclass(frozen=True, eq=False)
class TrackReport(FramesReport):
    """Report of `pointloom track`."""

    path: TrackedPath
    form: str

    @property
    def rate(self) -> float:
        return rate_of(self.path, self.done.seconds)

    def to_dict(self) -> dict[str, Any]:
        """Report in JSON types; "errors" has ATE and RPE if true poses exist."""
        report = {"command": self.done.command, **self.folder.to_dict(), "format": self.form, **self.path.to_dict()}
        report |= {"frames_per_second": self.rate, "focal": plain(self.path.camera), "errors": plain(self.path.error)}
        return report | self.ending_to_dict()

    def fields(self) -> Fields:
        return [
            *self.folder.among(self.path.fields(self.rate), before="path"),
            ("model", f"voxels of {self.path.voxel_size * 1000:g} mm"),
            *(with_warnings(self.path.error.fields(), self.path.error) if self.path.error else []),
            *self.ending(),
        ]


def rate_of(path: TrackedPath, seconds: dict[str, float]) -> float:
    return path.frame_count / max(seconds.get("track", 0.0), 1e-9)


def track_folder(
    folder: FilePath,
    output: FilePath,
    *,
    options: FolderOptions | None = None,
    voxel_size: float = VOXEL_SIZE,
    depth_max: float = DEPTH_MAX,
    device: DeviceLike = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> TrackReport:
    """Track the frames of a folder and write the poses. The output is checked before the work.

    Poses in the folder are only used as truth. The output has T_world_camera with the first frame as world,
    without lost frames. It is not written if all are lost.
    """
    form, where, clock = check_trajectory_output(output, overwrite=overwrite), resolve_device(device), Clock()
    opened = FrameFolder.open(folder, options or FolderOptions())
    dataset = opened.dataset
    if len(dataset) < 2:
        raise FileError(folder, "expected at least two frames, got one", remedy="Pass another folder")
    clock.stop("open")
    sizes: dict[str, Any] = {"depth_max": depth_max, "device": where}
    path = track(dataset, voxel_size=voxel_size, **sizes, progress=progress, clock=clock)
    files = []
    if len(path.trajectory):
        write_poses(output, path.trajectory, overwrite=overwrite)
        files.append(os.fspath(output))
        clock.stop("write")
    done = opened.done("track", clock, files, *path.warnings)
    return TrackReport(done, opened, path, form)
