"""Record frames in the 7-Scenes layout, readable at any time.

A frame counts once it has a line in `frame-times.txt`, which is written after its files. An interrupted recording is
valid.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from ...cameras.camera import PinholeCameraIntrinsic, check_camera, intrinsic_to_json
from ...cameras.depth_range import DEPTH_SCALE
from ...core.atomic import atomic_write
from ...core.checks import check_positive, check_progress
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.paths import path_of
from ...core.progress import ReportProgress
from ...core.serialized import Serialized
from ..images.image_files import write_png
from .dataset_layouts import FRAME_TIMES
from .datasets import Frame
from .frame_checks import checked_frame
from .rgbd_sources import RGBDSource

_HEADER = "# the whole frames of this recording: name and time [s], or -\n"


class FrameRecorder(Serialized):
    """Write frames to a new folder that is readable at any time.

    Args:
        folder: A new or empty folder.
        intrinsic: The camera of all frames.
        depth_scale: Integer depth units per meter. Float depth [m] is rounded to them.

    Attributes:
        count: Number of frames written.

    Raises:
        FileError: The folder is not empty or cannot be created.

    Notes:
        Level-1 PNG: a VGA frame takes about 0.1 MB of depth, 0.45 MB of color and 30 ms of one core. 65535 (no
        measurement in 7-Scenes) is read as 0.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.io.frames.recordings import FrameRecorder
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> stream = loom.frames_from([(None, np.full((48, 64), 1000, np.uint16), 0.5)], camera)
        >>> recorder = FrameRecorder("take", camera)
        >>> for frame in stream:
        ...     recorder.write(frame)  # and whatever else is done with it
        >>> [frame.timestamp for frame in loom.open_frames("take")]
        [0.5]
    """

    def __init__(self, folder: FilePath, intrinsic: PinholeCameraIntrinsic, *, depth_scale: float = DEPTH_SCALE):
        self.folder = path_of(folder, "folder")
        check_camera("intrinsic", intrinsic)
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
        """Write a frame, renumbered, with its pose if it has one.

        Args:
            frame: A frame of the recorder's camera.

        Raises:
            TypeError, ValueError: An invalid frame. Color in some frames only. Depth beyond 16 bits.
            FileError: It cannot be written, for example on a full disk. Earlier frames stay valid.
        """
        if not all(hasattr(frame, name) for name in ("depth", "color", "name", "T_world_camera", "timestamp")):
            raise TypeError(f"frame: expected a frame of an RGBDSource, got {type(frame).__name__}")
        frame = checked_frame(frame, self.intrinsic)
        colored, name = frame.color is not None, f"frame-{self.count:06d}"
        if self._colored not in (None, colored):
            raise ValueError(
                f"frame {escaped(frame.name)}: {'has' if colored else 'has no'} color, unlike those before it"
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


def record_frames(source: RGBDSource, folder: FilePath, *, progress: ReportProgress | None = None) -> int:
    """Write all frames of a source to a new folder in the 7-Scenes layout, readable at any time.

    Args:
        source: The frames. An endless source is recorded until it is closed or Ctrl-C.
        folder: A new or empty folder.
        progress: Called with "frames", the number written, and the total (0 if unknown).

    Returns:
        Number of frames written.

    Raises:
        TypeError: No source of frames.
        ValueError: Inconsistent frames.
        FileError: The folder is not empty, or a file cannot be written. Earlier frames stay valid.

    Notes:
        Float depth [m] is rounded to millimeters.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> images = [(None, np.full((48, 64), 1000, np.uint16)) for _ in range(3)]
        >>> loom.record_frames(loom.frames_from(images, camera), "recording")
        3
    """
    if not isinstance(source, RGBDSource):
        kind = type(source).__name__
        raise TypeError(f"source: expected an RGBDSource (intrinsic, depth_scale, iteration), got {kind}")
    report, recorder = check_progress(progress), None
    for frame in source:
        if recorder is None:
            scale = source.depth_scale if frame.depth.dtype.kind == "u" else DEPTH_SCALE
            recorder = FrameRecorder(folder, source.intrinsic, depth_scale=scale)
        recorder.write(frame)
        report("frames", recorder.count, len(source) if hasattr(source, "__len__") else 0)  # type: ignore[arg-type]
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
        raise FileError(folder, f"cannot be created: {error.strerror or error}") from error
    if entry is not None:
        raise FileError(folder, f"already contains {entry.name}", remedy="Give the name of a new folder")


def _in_units(frame: Frame, depth_scale: float) -> np.ndarray[Any, np.dtype[np.uint16]]:
    """Depth in integer units; negative and NaN depths become 0."""
    if frame.depth.dtype == np.uint16:
        return np.asarray(frame.depth, np.uint16)
    meters = np.where(frame.depth > 0, frame.depth, np.float32(0)).astype(np.float64)
    units = np.rint(meters * depth_scale)
    if units.max(initial=0) >= 65535:
        max_depth = 65534 / depth_scale
        raise ValueError(
            f"frame {escaped(frame.name)}: depth of {meters.max():.4g} m; 16 bits store up to {max_depth:.4g} m"
        )
    return units.astype(np.uint16)
