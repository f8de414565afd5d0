"""RGB-D frames of a recording: synchronized depth and color topics.

`Image`, `CompressedImage` (PNG, JPEG) and `compressed_depth`. Integer depth is millimeters (REP 118), float depth
meters.
"""

from __future__ import annotations

import struct
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera
from ...cameras.depth_range import DEPTH_SCALE
from ...core.errors import FileError
from ...core.escaped_text import escaped
from ...core.reports import Assessed
from ...core.serialized import keep_through_forks
from ..frames.dataset_layouts import associate
from ..frames.datasets import Frame
from ..frames.frame_checks import checked_frame
from ..frames.frame_times import TimeWatch
from ..images.image_files import decode_depth, decode_texture
from ..images.png_stream import PNG_MAGIC
from .message_chunks import byte_order

IMAGE, COMPRESSED, CAMERA_INFO = (f"sensor_msgs/msg/{name}" for name in ("Image", "CompressedImage", "CameraInfo"))
DEPTH = {"16UC1": "u2", "mono16": "u2", "32FC1": "f4"}
COLOR_ENCODINGS = {  # type, and indices of red, green and blue
    "rgb8": (3, (0, 1, 2)), "bgr8": (3, (2, 1, 0)), "8UC3": (3, (2, 1, 0)), "rgba8": (4, (0, 1, 2)),
    "bgra8": (4, (2, 1, 0)), "8UC4": (4, (2, 1, 0)), "mono8": (1, (0, 0, 0)), "8UC1": (1, (0, 0, 0)),
}  # fmt: skip
_DEPTH_HEAD = struct.Struct("<iff")  # of compressed_depth_image_transport: a format, and two numbers of inverse depth
PACKED_DEPTH = "compressedDepth"


def is_depth(kind: str, message: Any) -> bool:
    """True if an image is a depth map, by its encoding."""
    return PACKED_DEPTH in message.format if kind == COMPRESSED else message.encoding in DEPTH


def depth_of_message(path: Path, kind: str, message: Any) -> NDArray[np.uint16] | NDArray[np.float32]:
    """A depth map (h, w): uint16 [mm] or float32 [m]."""
    if kind == COMPRESSED:
        return _packed_depth(path, message)
    if message.encoding not in DEPTH:
        raise FileError(
            path,
            f"an image of encoding {message.encoding!r} is not a depth map",
            remedy=f"Depth encodings are {_list(DEPTH)}",
        )
    rows = _rows(path, message, DEPTH[message.encoding], 1)[:, :, 0]
    return np.ascontiguousarray(rows, rows.dtype.newbyteorder("="))


def color_of_message(path: Path, kind: str, message: Any) -> NDArray[np.uint8]:
    """A color image, uint8 RGB (h, w, 3). Gray is replicated, transparency dropped."""
    if kind == COMPRESSED:
        return np.ascontiguousarray(decode_texture(path, np.asarray(message.data, np.uint8).tobytes())[:, :, :3])
    if message.encoding not in COLOR_ENCODINGS:
        reason = f"images of encoding {message.encoding!r} are not supported as color"
        raise FileError(path, reason, remedy=f"Supported are {_list(COLOR_ENCODINGS)}")
    channels, order = COLOR_ENCODINGS[message.encoding]
    return np.ascontiguousarray(_rows(path, message, "u1", channels)[:, :, list(order)])


def intrinsic_of_message(path: Path, message: Any, *, rectified: bool) -> PinholeCameraIntrinsic:
    """The pinhole camera of a CameraInfo: P for rectified images, K for raw ones. Raises `FileError` if it is empty."""
    columns = 4 if rectified else 3
    numbers = _matrix(message, "p" if rectified else "k")
    fx, cx, fy, cy = numbers[0], numbers[2], numbers[columns + 1], numbers[columns + 2]
    if not (fx > 0 and fy > 0):
        reason = f"a camera_info has the focal lengths {fx:g} and {fy:g}"
        raise FileError(path, reason, remedy="The camera was not calibrated: give intrinsic")
    try:
        return PinholeCameraIntrinsic(int(message.width), int(message.height), fx, fy, cx, cy)
    except (ValueError, TypeError) as error:
        raise FileError(path, f"a camera_info is not a valid camera: {error}", remedy="Give intrinsic") from error


def lens_of_message(message: Any) -> list[float]:
    values = _matrix(message, "d")
    return values if any(values) else []


def _matrix(message: Any, name: str) -> list[float]:
    """The values of a CameraInfo field: lower case in ROS 2, upper case in ROS 1."""
    return [float(value) for value in getattr(message, name if hasattr(message, name) else name.upper())]


def stamp_of(data: bytes, encoding: str) -> float:
    """Header time [s] of a message: after a counter in ROS 1, after the encoding in ROS 2."""
    seconds, nanoseconds = struct.unpack_from(byte_order(data, encoding) + "iI", data, 4)
    return seconds + nanoseconds * 1e-9


def _rows(path: Path, message: Any, code: str, channels: int) -> NDArray[Any]:
    """The pixels (h, w, channels) in the message's byte order, without row padding."""
    height, width, step = int(message.height), int(message.width), int(message.step)
    kind = np.dtype((">" if message.is_bigendian else "<") + code)
    data = np.ascontiguousarray(np.asarray(message.data, np.uint8).reshape(-1))
    row = width * channels * kind.itemsize
    if not (height and width):
        raise FileError(path, f"an image of {width} x {height} pixels")
    if step < row:
        raise FileError(path, f"an image has rows of {step} bytes, but {width} pixels need {row}")
    if len(data) != height * step:
        raise FileError(path, f"an image of {height} rows of {step} bytes has {len(data)}, not {height * step}")
    pixels = data.reshape(height, step)[:, :row]
    return np.ascontiguousarray(pixels).view(kind).reshape(height, width, channels)


def _packed_depth(path: Path, message: Any) -> NDArray[np.uint16] | NDArray[np.float32]:
    """A 16-bit PNG after 12 bytes with the quantization d = a / (n - b). 0 for none."""
    data = np.asarray(message.data, np.uint8).tobytes()
    encoding = message.format.split(";")[0].strip()
    if data[:8] == PNG_MAGIC:
        a, b, png = 0.0, 0.0, data
    elif data[12:20] == PNG_MAGIC:
        (_, a, b), png = _DEPTH_HEAD.unpack_from(data), data[12:]
    else:
        reason = f"depth packed as {message.format!r} is not a PNG"
        raise FileError(path, reason, remedy="RVL is not supported: record raw depth, or PNG-compressed depth")
    pixels = decode_depth(path, png)
    if encoding != "32FC1":
        return pixels
    if not (a > 0 and np.isfinite(b)):
        raise FileError(path, f"depth of floats packed with the numbers {a:g} and {b:g}")
    depth = np.zeros(pixels.shape, np.float32)
    known = pixels > 0
    with np.errstate(divide="ignore"):
        depth[known] = a / (pixels[known].astype(np.float64) - b)
    depth[~np.isfinite(depth) | (depth < 0)] = 0
    return depth


def _list(names: Any) -> str:
    return ", ".join(names)


_SUFFIXES = ("/compressed", "/compressedDepth", "/theora")


class Messages(Protocol):
    path: Path
    damage: str | None

    def topic_types(self) -> dict[str, str]: ...

    def rows_of(self, topic: str) -> list[Any]: ...

    def bytes_at(self, row: Any) -> tuple[str, bytes]: ...

    def content_at(self, row: Any) -> Any: ...


class RecordedFrames(Assessed):
    """The RGB-D frames of a recording, decoded one at a time; created by `Recording.frames`.

    Attributes:
        intrinsic: The camera.
        depth_scale: 1000, as integer depth is millimeters.
        depth, color: The topics. None without color.
        left_out: Images without a partner in time.
        pairing: Number of frames that were paired by time, and of possible ones. Empty without color.
        layout: "recording".
        intrinsic_source: Source of the camera.
        warnings: Why the camera may belong to other images. Empty if no check failed.
        damage: Missing data of the recording, or None. Results of the frames report it.
    """

    layout = "recording"
    resize_color = True
    depth_scale = DEPTH_SCALE

    def __init__(
        self,
        recording: Messages,
        depth: str,
        color: str | None,
        intrinsic: PinholeCameraIntrinsic | ArrayLike | None,
        tolerance: float,
        every: int,
    ):
        self._recording, self.depth, self.color = recording, depth, color
        self._kinds, self.damage = recording.topic_types(), recording.damage
        self._lock = threading.Lock()
        keep_through_forks(self)
        self.left_out: list[str] = []
        self.pairing: tuple[int, ...] = ()
        self._rows = self._pairs(tolerance)[::every]
        self.warnings, self.intrinsic_source = (), "given"
        self.intrinsic = self._find_camera() if intrinsic is None else self._check_camera(intrinsic)

    def __len__(self) -> int:
        return len(self._rows)

    def __iter__(self) -> Iterator[Frame]:
        return (self.read(i) for i in range(len(self)))

    def __repr__(self) -> str:
        topics = self.depth + (f" and {self.color}" if self.color else "")
        return escaped(f"RecordedFrames({self._recording.path.name}, {len(self)} frames of {topics})")

    @property
    def frames(self) -> list[Any]:
        """Time, depth row and color row of each frame."""
        return self._rows

    @property
    def notes(self) -> list[str]:
        """Timestamps that repeat, decrease or jump, each with its frame."""
        watch = TimeWatch()
        for i, (time, _, _) in enumerate(self._rows):
            watch.see(f"frame-{i:06d}", time)
        return watch.notes

    def read(self, index: int) -> Frame:
        """Decode a frame. A negative index counts from the end. Raises `FileError` if a message is damaged."""
        time, depth_row, color_row = self._rows[index]
        name = f"frame-{index % len(self):06d}"
        path = self._recording.path
        try:
            with self._lock:
                messages = [None if row is None else self._recording.content_at(row) for row in (depth_row, color_row)]
            depth = depth_of_message(path, self._kinds[self.depth], messages[0])
            color = None if messages[1] is None else color_of_message(path, self._kinds[str(self.color)], messages[1])
        except FileError as error:
            raise FileError(path, f"{name}: {error.reason}", where=error.where, remedy=error.remedy) from error
        try:
            return checked_frame(Frame(depth, color, None, name, time), self.intrinsic, resize=True)
        except (ValueError, TypeError) as error:
            raise FileError(path, str(error), remedy="Give the intrinsic of these images") from error

    def _pairs(self, tolerance: float) -> list[tuple[float, Any, Any]]:
        depth = self._stamped(self.depth)
        if self.color is None:
            return [(time, row, None) for time, row in depth]
        color = self._stamped(self.color)
        times = [np.array([time for time, _ in side]) for side in (depth, color)]
        pairs = associate(times[0], times[1], tolerance)
        self.pairing = len(pairs), min(len(depth), len(color))
        for i, (time, _) in enumerate(depth):
            if i not in pairs:
                self.left_out.append(f"{self.depth} at {time:.6f} s: no color within {tolerance:g} s")
        return [(time, row, color[pairs[i]][1]) for i, (time, row) in enumerate(depth) if i in pairs]

    def _stamped(self, topic: str) -> list[tuple[float, Any]]:
        rows = self._recording.rows_of(topic)
        stamped = []
        for number, row in enumerate(rows):
            encoding, data = self._recording.bytes_at(row)
            try:
                stamped.append((stamp_of(data, encoding), row))
            except struct.error as error:
                raise FileError(self._recording.path, f"{topic}: message {number} has no header") from error
        return sorted(stamped, key=lambda pair: pair[0])

    def _check_camera(self, intrinsic: PinholeCameraIntrinsic | ArrayLike) -> PinholeCameraIntrinsic:
        """The given camera. The size of a matrix is that of the first depth image."""
        if isinstance(intrinsic, PinholeCameraIntrinsic) or not self._rows:
            return check_camera("intrinsic", intrinsic)
        message = self._recording.content_at(self._rows[0][1])
        height, width = depth_of_message(self._recording.path, self._kinds[self.depth], message).shape
        return check_camera("intrinsic", intrinsic, (width, height))

    def _find_camera(self) -> PinholeCameraIntrinsic:
        path, topic = self._recording.path, self.depth
        for suffix in _SUFFIXES:
            topic = topic.removesuffix(suffix)
        beside = topic.rsplit("/", 1)[0] + "/camera_info"
        infos = [name for name, kind in self._kinds.items() if kind == CAMERA_INFO]
        if beside not in infos:
            known = f"; there are {', '.join(infos)}" if infos else ""
            raise FileError(path, f"has no {beside}, the camera of {self.depth}{known}",
                            remedy="Give its intrinsic")  # fmt: skip
        message = self._recording.content_at(self._recording.rows_of(beside)[0])
        rectified = "rect" in topic.rsplit("/", 1)[1]
        self.intrinsic_source = beside
        if (lens := lens_of_message(message)) and not rectified:
            coefficients = ", ".join(f"{value:.3g}" for value in lens)
            self.warnings = (f"{beside} has a lens distortion ({coefficients}) that is not corrected in {self.depth}",)
        return intrinsic_of_message(path, message, rectified=rectified)


def choose_images(recording: Messages, depth: str | None, color: str | None) -> tuple[str, str | None]:
    """The given depth and color topics, or the only ones. Raises `FileError` if none or several match."""
    kinds = {name: kind for name, kind in recording.topic_types().items() if kind in (IMAGE, COMPRESSED)}
    depths = [name for name in kinds if is_depth(kinds[name], recording.content_at(recording.rows_of(name)[0]))]
    colors = [name for name in kinds if name not in depths]
    return (
        str(_only(recording.path, "depth", depth, depths, needed=True)),
        _only(recording.path, "color", color, colors, needed=False),
    )


def _only(path: Path, what: str, requested: str | None, topics: list[str], *, needed: bool) -> str | None:
    if requested is not None:
        if requested not in topics:
            there = f"There are {', '.join(topics)}" if topics else "There are none"
            raise FileError(path, f"has no topic {requested!r} of {what} images", remedy=there)
        return requested
    if len(topics) > 1:
        raise FileError(
            path, f"has {len(topics)} topics of {what} images: {', '.join(topics)}", remedy=f"Choose one as {what}"
        )
    if not topics and needed:
        raise FileError(
            path, f"has no topic of {what} images", remedy="Depth is Image of 16UC1 or 32FC1, or compressed"
        )
    return topics[0] if topics else None
