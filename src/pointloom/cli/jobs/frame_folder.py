"""Folders of RGB-D frames for commands, and their reports."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Iterable, Sequence
from typing import Any

from ...cameras.camera import read_pinhole_camera_intrinsic
from ...core.errors import DatasetError, FileError, FilePath, PointloomError
from ...core.paths import is_recording, path_of
from ...core.reports import Fields, failed, quality
from ...core.timing import Clock, peak_bytes
from ...core.wording import format_bytes, format_seconds
from ...io.bags.recording import open_recording
from ...io.frames.datasets import REQUIRED, RGBDDataset, open_frames
from ...io.frames.frames import camera_line, describe_camera, describe_folder, open_folder
from .job import Done, JobReport


@dataclasses.dataclass(frozen=True)
class FolderOptions:
    """Selection of frames of a folder; `layout` as in `open_frames`.

    Attributes:
        intrinsic: Camera as Open3D's JSON, replacing that of the folder.
        every: Use every k-th frame, starting with the first.
        depth_scale: Stored depth of one meter, replacing that of the folder. Not with posed frames.
        skip_missing: Skip frames without an image or with a non-finite pose. Only with posed frames.
    """

    layout: str = "auto"
    intrinsic: FilePath | None = None
    every: int = 1
    depth_scale: float | None = None
    skip_missing: bool = False
    topic: str | None = None
    color_topic: str | None = None


@dataclasses.dataclass(frozen=True)
class FrameFolder:
    """An opened folder, with its frames and the camera file if given."""

    path: FilePath
    dataset: RGBDDataset
    intrinsic: FilePath | None

    @classmethod
    def open(cls, path: FilePath, options: FolderOptions) -> FrameFolder:
        """Open a folder of frames that need no poses. Raises FileError."""
        if is_recording(path_of(path)):
            return cls(path, _frames_of_recording(path, options), options.intrinsic)
        given = dataclasses.asdict(options)
        given.pop("skip_missing")
        for name in ("topic", "color_topic"):
            if topic := given.pop(name):
                option = f"--{name.replace('_', '-')}"
                raise FileError(path, f"is not a recording, so it has no topic {topic!r}", remedy=f"Leave {option} out")
        return cls(path, open_folder(path, **given), options.intrinsic)

    @classmethod
    def open_posed(cls, path: FilePath, options: FolderOptions) -> FrameFolder:
        """Open a folder of posed frames. Raises FileError, with a hint for frames without poses."""
        camera = None if options.intrinsic is None else read_pinhole_camera_intrinsic(options.intrinsic)
        given: dict[str, Any] = {"layout": options.layout, "intrinsic": camera, "every": options.every}
        given |= {"skip_missing": options.skip_missing, "resize_color": True}
        try:
            return cls(path, open_frames(path, poses=REQUIRED, **given), options.intrinsic)
        except DatasetError as error:
            if not _has_no_poses(path, given):
                raise
            remedy = "Use pointloom reconstruct for frames without poses, or estimate them with pointloom track"
            raise FileError(path, "contains no poses", remedy=remedy) from error

    def done(self, command: str, clock: Clock, files: Iterable[str], *warnings: str | None) -> Done:
        return Done(command, os.fspath(self.path), clock.seconds, (), tuple(files), failed(*warnings))

    def to_dict(self) -> dict[str, Any]:
        return describe_folder(self.path, self.dataset, self.intrinsic)

    def among(self, fields: Fields, *, before: str) -> Fields:
        """Insert omitted frames after the frames, and the camera before a label."""
        camera = camera_line(describe_camera(self.dataset, self.intrinsic))
        return with_camera(fields, camera, self.dataset.left_out, before=before)


@dataclasses.dataclass(frozen=True, eq=False)
class FramesReport(JobReport):
    """Report of a command on a folder of frames. Base class. `peak` is the peak memory [B]."""

    folder: FrameFolder
    peak: int = dataclasses.field(default_factory=peak_bytes, kw_only=True)

    def ending_to_dict(self, **more: Any) -> dict[str, Any]:
        """Common last entries: cost, further values, files and quality."""
        cost = {"seconds": self.done.seconds, "peak_bytes": self.peak}
        return cost | more | {"files": list(self.done.files), **quality(self)}

    def ending(self) -> Fields:
        return [
            ("seconds", format_seconds(self.done.seconds)),
            ("memory", f"{format_bytes(self.peak)} at most"),
            ("files", ", ".join(self.done.files) or "none"),
        ]


def with_camera(fields: Fields, camera: str, left_out: Sequence[str], *, before: str) -> Fields:
    """Insert omitted frames after the frames, and the camera before a label."""
    result: Fields = []
    for label, value in fields:
        lost = left_out if label == "frames" else ()
        result += [("camera", camera)] if label == before else []
        result.append((label, f"{value}\n{len(lost)} left out, the first {lost[0]}" if lost else value))
    return result


def _frames_of_recording(path: FilePath, options: FolderOptions) -> Any:
    """RGB-D frames of a recording, with depth in millimeters or meters by its encoding."""
    for name, value, usual in (("layout", options.layout, "auto"), ("depth_scale", options.depth_scale, None)):
        if value != usual:
            raise FileError(
                path,
                f"is a recording, for which {name} is not an option",
                remedy=f"Leave out --{name.replace('_', '-')}",
            )
    camera = None if options.intrinsic is None else read_pinhole_camera_intrinsic(options.intrinsic)
    recording = open_recording(path)
    return recording.frames(options.topic, options.color_topic, intrinsic=camera, every=options.every)


def _has_no_poses(path: FilePath, given: dict[str, Any]) -> bool:
    try:
        return all(frame.T_world_camera is None for frame in open_frames(path, **given).frames)
    except PointloomError:
        return False
