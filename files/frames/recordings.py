"""Streams of frames written as they come, in the layout of 7-Scenes, readable at any moment.

A frame is its depth map, its colour and its pose, each written whole, and then a line in `frame-times.txt`. What has no
line there is no frame: however a recording ends, what was listed is whole and `open_frames` reads that.
"""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import numpy as np

from ...cameras.camera import PinholeCameraIntrinsic, intrinsic_to_json
from ...core.atomic import atomic_write
from ...core.checks import check_positive, check_progress
from ...core.errors import FileError
from ...core.escaped_text import escaped
from ...core.paths import path_of
from ...core.progress import ReportProgress
from ..pictures.image_files import write_png
from .dataset_layouts import FRAME_TIMES
from .datasets import Frame
from .frame_checks import checked_frame
from .rgbd_sources import RGBDSource

_HEADER = "# the whole frames of this recording: name and time [s], or -\n"


class FrameRecorder:
    """Writes frames one after another to a new folder, which can be read at any moment.

    Args:
        folder: A folder that does not exist yet, or is empty.
        intrinsic: The camera of all frames.
        depth_scale: Units a metre of depth in whole numbers. Depth in float32 metres is rounded to such units.

    Attributes:
        count: Frames written.

    Raises:
        FileError: The folder holds something, or cannot be made.

    Notes:
        Level-1 PNG: a VGA frame takes about 0.1 MB of depth, 0.45 MB of colour and 30 ms of one core. 65535, where
        7-Scenes' layout says that nothing was measured, is read as 0.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.files.frames.recordings import FrameRecorder
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> stream = loom.frames_from([(None, np.full((48, 64), 1000, np.uint16), 0.5)], camera)
        >>> recorder = FrameRecorder("take", camera)
        >>> for frame in stream:
        ...     recorder.write(frame)  # and whatever else is done with it
        >>> [frame.timestamp for frame in loom.open_frames("take")]
        [0.5]
    """

    def __init__(
        self, folder: str | os.PathLike[str], intrinsic: PinholeCameraIntrinsic, *, depth_scale: float = 1000.0
    ):
        self.folder = path_of(folder, "folder")
        if not isinstance(intrinsic, PinholeCameraIntrinsic):
            raise TypeError(f"intrinsic: expected a PinholeCameraIntrinsic, got {type(intrinsic).__name__}")
        self.depth_scale = check_positive("depth_scale", depth_scale)
        self.intrinsic, self.count = intrinsic, 0
        self._colored: bool | None = None
        _make_folder(self.folder)
        text = json.dumps(intrinsic_to_json(intrinsic) | {"depth_scale": self.depth_scale}, indent=4)
        with atomic_write(self.folder / "camera-intrinsics.json") as file:
            file.write(text.encode() + b"\n")
        with atomic_write(self.folder / FRAME_TIMES) as file:
            file.write(_HEADER.encode())

    def write(self, frame: Frame) -> None:
        """Write a frame; it counts once all its parts are there.

        Args:
            frame: Of the recorder's camera. It is numbered anew; its pose is written if it has one.

        Raises:
            TypeError, ValueError: No such frame; colour in some frames and not in others; depth beyond 16 bits.
            FileError: It cannot be written, as on a full disk; the frames before it stay.
        """
        if not all(hasattr(frame, name) for name in ("depth", "color", "name", "T_world_camera", "timestamp")):
            raise TypeError(f"frame: expected a frame of an RGBDSource, got {type(frame).__name__}")
        frame = checked_frame(frame, self.intrinsic)
        colored, name = frame.color is not None, f"frame-{self.count:06d}"
        if self._colored not in (None, colored):
            raise ValueError(
                f"frame {escaped(frame.name)}: {'has' if colored else 'has no'} colour, unlike those before it"
            )
        depth = _in_units(frame, self.depth_scale)
        if frame.color is not None:
            write_png(self.folder / f"{name}.color.png", frame.color)
        if frame.T_world_camera is not None:
            rows = ("\t".join(f"{value:.17g}" for value in row) for row in frame.T_world_camera)
            with atomic_write(self.folder / f"{name}.pose.txt") as file:
                file.write(("\n".join(rows) + "\n").encode())
        write_png(self.folder / f"{name}.depth.png", depth)
        time = "-" if frame.timestamp is None else repr(frame.timestamp)
        try:
            with (self.folder / FRAME_TIMES).open("ab") as file:
                file.write(f"{name} {time}\n".encode())
        except OSError as error:
            raise FileError(self.folder / FRAME_TIMES, f"cannot be written: {error.strerror or error}") from error
        self._colored, self.count = colored, self.count + 1


def record_frames(source: RGBDSource, folder: str | os.PathLike[str], *, progress: ReportProgress | None = None) -> int:
    """Write all frames of a source to a new folder, in the layout of 7-Scenes, which can be read at any moment.

    Args:
        source: What gives the frames; one that never ends is recorded until it is closed or Ctrl-C.
        folder: A folder that does not exist yet, or is empty.
        progress: Called with "frames", how many are written, and how many there are (0 for a source that does not
            know).

    Returns:
        How many frames were written.

    Raises:
        TypeError: No source of frames.
        ValueError: Frames that do not fit together.
        FileError: The folder holds something, or a file cannot be written; the frames before that stay.

    Notes:
        Depth in float32 metres is rounded to millimetres.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> pictures = [(None, np.full((48, 64), 1000, np.uint16)) for _ in range(3)]
        >>> loom.record_frames(loom.frames_from(pictures, camera), "recording")
        3
    """
    if not isinstance(source, RGBDSource):
        kind = type(source).__name__
        raise TypeError(f"source: expected an RGBDSource (intrinsic, depth_scale, iteration), got {kind}")
    say, recorder = check_progress(progress), None
    for frame in source:
        if recorder is None:
            scale = source.depth_scale if frame.depth.dtype.kind == "u" else 1000.0
            recorder = FrameRecorder(folder, source.intrinsic, depth_scale=scale)
        recorder.write(frame)
        say("frames", recorder.count, len(source) if hasattr(source, "__len__") else 0)  # type: ignore[arg-type]
    if recorder is None:
        recorder = FrameRecorder(folder, source.intrinsic)
    return recorder.count


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(exist_ok=True)
        entry = next(folder.iterdir(), None)
    except FileNotFoundError as error:
        raise FileError(folder, f"the folder {folder.parent} does not exist", remedy="Make it first") from error
    except OSError as error:
        raise FileError(folder, f"cannot be made: {error.strerror or error}") from error
    if entry is not None:
        raise FileError(folder, f"holds {entry.name} already", remedy="Give the name of a new folder")


def _in_units(frame: Frame, depth_scale: float) -> np.ndarray[Any, np.dtype[np.uint16]]:
    """Depth in whole units; metres that are no number or below zero are no measurement, as elsewhere."""
    if frame.depth.dtype == np.uint16:
        return np.asarray(frame.depth, np.uint16)
    metres = np.where(frame.depth > 0, frame.depth, np.float32(0)).astype(np.float64)
    units = np.rint(metres * depth_scale)
    if units.max(initial=0) >= 65535:
        most = 65534 / depth_scale
        raise ValueError(f"frame {escaped(frame.name)}: depth of {metres.max():.4g} m; 16 bits hold up to {most:.4g} m")
    return units.astype(np.uint16)
