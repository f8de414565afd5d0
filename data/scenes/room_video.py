"""The furnished room as a video: what a telephone would film, and apart from it the truth.

The camera goes a wide round along the walls and looks across the room (`film_pose`). Its pictures have a grain, the
noise of a sensor, and neither depth nor poses.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic, write_pinhole_camera_intrinsic
from ...cameras.trajectory import Trajectory, write_trajectory
from ...core.atomic import atomic_write, check_writable, part_name
from ...core.checks import check_count, check_positive, check_progress
from ...core.errors import FileError
from ...core.progress import ReportProgress
from ...drawing.recording.video import find_ffmpeg, write_mp4
from .room import RoomSequence, room_views
from .room_paths import film_pose

FRAMES = 240  # 1.5 degrees and 3 cm from one to the next
WIDTH, HEIGHT = 640, 480
FPS = 20.0
JPEG_QUALITY = 95

TUM, LOG, CAMERA, DEPTH = "poses.tum", "poses.log", "camera-intrinsics.json", "depth"  # the folder of the truth


def room_video_poses(frame_count: int = FRAMES) -> NDArray[np.float64]:
    """Camera to world [m] of the frames of one round through the room, shape [n, 4, 4]."""
    return np.array([film_pose(i / frame_count) for i in range(check_count("frame_count", frame_count))])


def room_video_frames(
    frame_count: int = FRAMES,
    *,
    width: int = WIDTH,
    height: int = HEIGHT,
    seed: int = 0,
    color_noise: float | None = None,
    device: Any = "cpu",
) -> RoomSequence:
    """The frames of the video, with exact depth and true poses.

    Args:
        frame_count: Frames of the round.
        width, height: Size [px]; the focal length is 525 px at 640 columns, without distortion.
        seed, color_noise, device: As `room_sequence`.

    Returns:
        A sequence of `RoomFrame`: iterate, or `read(i)`.

    Raises:
        TypeError, ValueError: As `room_sequence`.
        DeviceError: No such device.
    """
    width, height = check_count("width", width), check_count("height", height)
    focal = 525.0 * width / 640
    camera = PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)
    return room_views(room_video_poses(frame_count), camera, seed=seed, color_noise=color_noise, device=device)


def write_room_video(
    path: str | os.PathLike[str],
    frames: RoomSequence | None = None,
    *,
    fps: float = FPS,
    truth: str | os.PathLike[str] | None = None,
    depth: bool = False,
    overwrite: bool = False,
    progress: ReportProgress | None = None,
) -> None:
    """Write frames of the room as a video or as a folder of pictures, and the truth somewhere else.

    Args:
        path: A name that ends in .mp4 is a video, made by the program ffmpeg; any other a new folder of pictures,
            frame-NNNNNN.jpg.
        frames: What to write; None is `room_video_frames()`.
        fps: Frames a second.
        truth: A new folder for the camera, camera-intrinsics.json, and its poses, camera to world [m]: poses.tum with
            the times in the video, poses.log with the numbers of the frames.
        depth: Whether that folder also gets depth/frame-NNNNNN.npy: exact, float32 [h, w] [m].
        overwrite: Replace a video that exists; folders are never replaced.
        progress: Called with "video", frames written, all of them.

    Raises:
        FileError: A place that exists or cannot be written; no ffmpeg; it failed.
        ValueError: A video of odd sides; depth without a folder for the truth.

    Notes:
        Each of both is written whole or not at all. Pictures have the same bits on every device up to what rounding
        does to the light of the room; how ffmpeg encodes them is its own.
    """
    path, say = Path(path), check_progress(progress)
    frames = room_video_frames() if frames is None else frames
    fps = check_positive("fps", fps)
    if depth and truth is None:
        raise ValueError("depth: is part of the truth; give truth= a folder too")
    if truth is not None:
        _check_new_folder(Path(truth))
    if path.suffix.lower() == ".mp4":
        if frames.intrinsic.width % 2 or frames.intrinsic.height % 2:
            size = f"{frames.intrinsic.width} x {frames.intrinsic.height}"
            raise ValueError(f"frames: an .mp4 wants even sides, got {size}; give a folder, or an even size")
        check_writable(path, overwrite=overwrite)
        find_ffmpeg(path)
    else:
        _check_new_folder(path)
    with _NewFolder(truth) as answers:
        if answers is not None:
            _write_cameras(answers, frames, fps)
        kept = _keep_depth(frames, answers if depth else None, say)
        if path.suffix.lower() == ".mp4":
            with atomic_write(path, overwrite=overwrite) as file:
                write_mp4(file, (color for _, color in kept), fps, path)
        else:
            with _NewFolder(path) as pictures:
                assert pictures is not None
                for name, color in kept:
                    _write_jpeg(pictures / f"{name}.jpg", color)


def _keep_depth(
    frames: RoomSequence, folder: Path | None, say: ReportProgress
) -> Iterator[tuple[str, NDArray[np.uint8]]]:
    """The name and the colours of each frame; its depth goes to the folder meanwhile."""
    if folder is not None:
        (folder / DEPTH).mkdir()
    for k, frame in enumerate(frames):
        say("video", k, len(frames))
        if folder is not None:
            np.save(folder / DEPTH / f"{frame.name}.npy", np.asarray(frame.depth, np.float32))
        assert frame.color is not None
        yield frame.name, frame.color
    say("video", len(frames), len(frames))


def _write_cameras(folder: Path, frames: RoomSequence, fps: float) -> None:
    times = np.arange(len(frames)) / fps
    write_trajectory(folder / TUM, Trajectory(frames.poses, timestamps=times))
    write_trajectory(folder / LOG, Trajectory(frames.poses))
    write_pinhole_camera_intrinsic(folder / CAMERA, frames.intrinsic)


def _write_jpeg(path: Path, color: NDArray[np.uint8]) -> None:
    from PIL import Image

    Image.fromarray(color).save(path, quality=JPEG_QUALITY, subsampling=0)


def _check_new_folder(folder: Path) -> None:
    if folder.exists():
        raise FileError(folder, "exists already", remedy="Give the name of a new folder")
    if not folder.absolute().parent.is_dir():
        raise FileError(folder, f"the folder {folder.absolute().parent} does not exist", remedy="Make it first")


class _NewFolder:
    """A folder that takes its name when the block ends without an error; None for no folder."""

    def __init__(self, folder: str | os.PathLike[str] | None):
        self._folder, self._part = None if folder is None else Path(folder), None

    def __enter__(self) -> Path | None:
        if self._folder is None:
            return None
        _check_new_folder(self._folder)
        try:
            self._part = part_name(self._folder)
            self._part.mkdir()
        except OSError as error:
            raise FileError(self._folder, f"cannot be made: {error.strerror or error}") from error
        return self._part

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: object) -> None:
        if self._folder is None or self._part is None:
            return
        try:
            if kind is None:
                self._part.rename(self._folder)
        except OSError as fault:
            raise FileError(self._folder, f"cannot be written: {fault.strerror or fault}") from fault
        finally:
            shutil.rmtree(self._part, ignore_errors=True)
        if isinstance(error, OSError) and not isinstance(error, FileError):
            raise FileError(self._folder, f"cannot be written: {error.strerror or error}") from error
