"""The path of a camera from a folder of its RGB-D frames, to a file: `track_folder`."""

from __future__ import annotations

import dataclasses
import os
from typing import Any

from ...cameras.pose_files import check_trajectory_output, write_poses
from ...core.devices import resolve_device
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from ...core.reports import Fields
from ...core.timing import Clock
from ...core.wording import plain
from ...files.frames.frames import DEPTH_MAX
from ...rgbd.slam.focal_check import FocalCheck, check_focal
from ...rgbd.slam.tracked_path import TrackedPath
from ...rgbd.slam.tracking import VOXEL_SIZE, track
from .frame_folder import FolderOptions, FrameFolder, FramesReport


@dataclasses.dataclass(frozen=True, eq=False)
class TrackReport(FramesReport):
    """What `pointloom track` did.

    Attributes:
        path: What was made of the frames.
        form: The format of the poses.
        focal: Whether another focal length fits better.
    """

    path: TrackedPath
    form: str
    focal: FocalCheck | None

    @property
    def rate(self) -> float:
        """Frames a second of tracking alone."""
        return rate_of(self.path, self.done.seconds)

    def to_dict(self) -> dict[str, Any]:
        """The report, in JSON's types; "errors" holds ATE and RPE where true poses lie beside the frames."""
        report = {"command": self.done.command, **self.folder.to_dict(), "format": self.form, **self.path.to_dict()}
        report |= {"frames_per_second": self.rate, "focal": plain(self.focal), "errors": plain(self.path.error)}
        return report | self.ending_to_dict()

    def fields(self) -> Fields:
        """The report as labels and values for the terminal."""
        return [
            *self.folder.among(self.path.fields(self.rate), before="path"),
            ("model", f"voxels of {self.path.voxel_size * 1000:g} mm"),
            *(self.path.error.fields() if self.path.error else []),
            *self.ending(),
        ]


def rate_of(path: TrackedPath, seconds: dict[str, float]) -> float:
    """Frames a second of tracking alone."""
    return path.frame_count / max(seconds.get("track", 0.0), 1e-9)


def track_folder(
    folder: FilePath,
    output: FilePath,
    *,
    options: FolderOptions | None = None,
    voxel_size: float = VOXEL_SIZE,
    depth_max: float = DEPTH_MAX,
    device: Any = "auto",
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> TrackReport:
    """Find where each frame of a folder was taken, and write the poses; the output is checked before the work.

    Args:
        folder: As `open_frames` takes it; poses that lie there are taken as the truth.
        output: A file of poses, T_world_camera with the first frame as the world: .txt or .tum (TUM's format), .log.
            Frames that were lost have none in it; without any it is not written.
        options: Which frames of the folder; None for all, as they lie there.
        voxel_size, depth_max, device, progress: As `loom.track`.
        overwrite: Replace the output if it exists.

    Raises:
        FileError: A folder of fewer than two frames, a file that cannot be read, an output that cannot be written.
        ValueError: A length out of range.
        DeviceError: No such device.
    """
    form, where, clock = check_trajectory_output(output, overwrite=overwrite), resolve_device(device), Clock()
    opened = FrameFolder.open(folder, options or FolderOptions())
    dataset = opened.dataset
    if len(dataset) < 2:
        raise FileError(folder, "holds one frame; tracking needs two", remedy="Give another folder")
    clock.stop("open")
    sizes: dict[str, Any] = {"depth_max": depth_max, "device": where}
    path = track(dataset, voxel_size=voxel_size, **sizes, progress=progress, clock=clock)
    focal = check_focal(dataset, path.trajectory, uncertain=path.uncertain, **sizes)
    clock.stop("camera")
    files = []
    if len(path.trajectory):
        write_poses(output, path.trajectory, overwrite=overwrite)
        files.append(os.fspath(output))
        clock.stop("write")
    done = opened.done("track", clock, files, *path.warnings, *opened.warnings, *(focal.warnings if focal else ()))
    return TrackReport(done, opened, path, form, focal)
