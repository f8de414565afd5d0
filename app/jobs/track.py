"""The path of a camera from a folder of its RGB-D frames, to a file: `track_folder`."""

from __future__ import annotations

import dataclasses
import os
from typing import Any, Self

from ...cameras.pose_files import check_trajectory_output, write_poses
from ...core.devices import resolve_device
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from ...core.reports import Fields
from ...core.timing import Clock, peak_bytes
from ...core.wording import format_bytes, format_seconds
from ...files.frames.frames import DEPTH_MAX, why_incomplete
from ...rgbd.slam.focal_check import FocalCheck, check_focal
from ...rgbd.slam.tracked_path import TrackedPath
from ...rgbd.slam.tracking import VOXEL_SIZE, track
from .frame_folder import FolderOptions, FrameFolder
from .trajectory_report import error_part, error_to_json


@dataclasses.dataclass(frozen=True, eq=False)
class TrackReport:
    """What `pointloom track` did.

    Attributes:
        folder: The frames.
        path: What was made of them.
        form: The format of the poses.
        focal: Whether another focal length fits better.
        seconds: Time of each stage.
        files: What was written.
        peak: The most memory [B] that was held.
    """

    folder: FrameFolder
    path: TrackedPath
    form: str
    focal: FocalCheck | None
    seconds: dict[str, float]
    files: list[str]
    peak: int = dataclasses.field(default_factory=peak_bytes)

    def with_file(self, path: FilePath) -> Self:
        """The report, with one more file that was written."""
        return dataclasses.replace(self, files=[*self.files, os.fspath(path)])

    @property
    def poor(self) -> str | None:
        """Why the result is poor, or None."""
        doubts = [why_incomplete(self.folder.dataset), self.folder.camera_doubt]
        reasons = [self.path.poor, *doubts, self.focal.doubt if self.focal else None]
        return "; ".join(reason for reason in reasons if reason) or None

    def to_json(self) -> dict[str, Any]:
        """The report, in JSON's types; "errors" holds ATE and RPE where true poses lie beside the frames."""
        report = {"command": "track", **self.folder.to_json(), "format": self.form, **self.path.to_json()}
        report |= {"frames_per_second": rate_of(self.path, self.seconds)}
        report |= {"focal": self.focal.to_json() if self.focal else None, "errors": error_to_json(self.path.error)}
        return report | {
            "seconds": self.seconds, "peak_bytes": self.peak, "files": self.files, "poor": self.poor
        }  # fmt: skip

    def fields(self) -> Fields:
        """The report as labels and values for the terminal."""
        told = self.path.fields(rate_of(self.path, self.seconds))
        return [
            *self.folder.among(told, before="path"),
            ("model", f"voxels of {self.path.voxel_size * 1000:g} mm"),
            *error_part(self.path.error),
            ("seconds", format_seconds(self.seconds)),
            ("memory", f"{format_bytes(self.peak)} at most"),
            ("files", ", ".join(self.files) or "none"),
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
    return TrackReport(opened, path, form, focal, clock.seconds, files)
