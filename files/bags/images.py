"""Pictures as ROS sends them: `Image` by rows, `CompressedImage` as PNG or JPEG, depth as `compressed_depth` packs it.

Depth in whole numbers is millimetres (REP 118), in floats metres; colours come as RGB. What is not known is refused.
"""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.errors import FileError
from ..pictures.image_files import decode_depth, decode_texture
from ..pictures.png_stream import PNG_MAGIC
from .pieces import byte_order

IMAGE, COMPRESSED, CAMERA_INFO = (f"sensor_msgs/msg/{name}" for name in ("Image", "CompressedImage", "CameraInfo"))
DEPTH = {"16UC1": "u2", "mono16": "u2", "32FC1": "f4"}
COLORS = {  # type, and which of the channels are red, green and blue
    "rgb8": (3, (0, 1, 2)), "bgr8": (3, (2, 1, 0)), "8UC3": (3, (2, 1, 0)), "rgba8": (4, (0, 1, 2)),
    "bgra8": (4, (2, 1, 0)), "8UC4": (4, (2, 1, 0)), "mono8": (1, (0, 0, 0)), "8UC1": (1, (0, 0, 0)),
}  # fmt: skip
_DEPTH_HEAD = struct.Struct("<iff")  # of compressed_depth_image_transport: a format, and two numbers of inverse depth
PACKED_DEPTH = "compressedDepth"


def holds_depth(kind: str, message: Any) -> bool:
    """Whether a picture is a depth map, by its encoding."""
    return PACKED_DEPTH in message.format if kind == COMPRESSED else message.encoding in DEPTH


def depth_of_message(path: Path, kind: str, message: Any) -> NDArray[np.uint16] | NDArray[np.float32]:
    """A depth map: uint16 millimetres or float32 metres, shape [h, w].

    Raises:
        FileError: No depth map, or a damaged one.
    """
    if kind == COMPRESSED:
        return _packed_depth(path, message)
    if message.encoding not in DEPTH:
        raise FileError(path, f"a picture of {message.encoding!r} is no depth map", remedy=f"Those are {_list(DEPTH)}")
    rows = _rows(path, message, DEPTH[message.encoding], 1)[:, :, 0]
    return np.ascontiguousarray(rows, rows.dtype.newbyteorder("="))


def color_of_message(path: Path, kind: str, message: Any) -> NDArray[np.uint8]:
    """A colour picture, uint8 RGB [h, w, 3]; grey is replicated, transparency dropped.

    Raises:
        FileError: No colour picture, or a damaged one.
    """
    if kind == COMPRESSED:
        return np.ascontiguousarray(decode_texture(path, np.asarray(message.data, np.uint8).tobytes())[:, :, :3])
    if message.encoding not in COLORS:
        reason = f"pictures of {message.encoding!r} are not read as colours"
        raise FileError(path, reason, remedy=f"Known are {_list(COLORS)}")
    channels, order = COLORS[message.encoding]
    return np.ascontiguousarray(_rows(path, message, "u1", channels)[:, :, list(order)])


def intrinsic_of_message(path: Path, message: Any, *, rectified: bool) -> PinholeCameraIntrinsic:
    """The pinhole of a CameraInfo: P of rectified pictures, K of raw ones.

    Raises:
        FileError: It says nothing (a focal length of 0), or is no camera.
    """
    columns = 4 if rectified else 3
    numbers = _matrix(message, "p" if rectified else "k")
    fx, cx, fy, cy = numbers[0], numbers[2], numbers[columns + 1], numbers[columns + 2]
    if not (fx > 0 and fy > 0):
        reason = f"a camera_info says that its focal lengths are {fx:g} and {fy:g}"
        raise FileError(path, reason, remedy="The camera was not calibrated: give intrinsic")
    try:
        return PinholeCameraIntrinsic(int(message.width), int(message.height), fx, fy, cx, cy)
    except (ValueError, TypeError) as error:
        raise FileError(path, f"a camera_info is no camera: {error}", remedy="Give intrinsic") from error


def lens_of_message(message: Any) -> list[float]:
    """The distortion of a CameraInfo; empty where there is none."""
    values = _matrix(message, "d")
    return values if any(values) else []


def _matrix(message: Any, name: str) -> list[float]:
    """The numbers of a CameraInfo: named in small letters in ROS 2, in capitals in ROS 1."""
    return [float(value) for value in getattr(message, name if hasattr(message, name) else name.upper())]


def stamp_of(data: bytes, encoding: str) -> float:
    """The time [s] in the header that a message begins with: behind a counter in ROS 1, an encoding in ROS 2."""
    seconds, nanoseconds = struct.unpack_from(byte_order(data, encoding) + "iI", data, 4)
    return seconds + nanoseconds * 1e-9


def _rows(path: Path, message: Any, code: str, channels: int) -> NDArray[Any]:
    """The pixels [h, w, channels] in the order of bytes that the message has, without what pads its rows."""
    height, width, step = int(message.height), int(message.width), int(message.step)
    kind = np.dtype((">" if message.is_bigendian else "<") + code)
    data = np.ascontiguousarray(np.asarray(message.data, np.uint8).reshape(-1))
    row = width * channels * kind.itemsize
    if not (height and width):
        raise FileError(path, f"a picture of {width} x {height} pixels")
    if step < row:
        raise FileError(path, f"a picture has rows of {step} bytes for {width} pixels, which are {row}")
    if len(data) != height * step:
        raise FileError(path, f"a picture of {height} rows of {step} bytes has {len(data)}, not {height * step}")
    pixels = data.reshape(height, step)[:, :row]
    return np.ascontiguousarray(pixels).view(kind).reshape(height, width, channels)


def _packed_depth(path: Path, message: Any) -> NDArray[np.uint16] | NDArray[np.float32]:
    """A PNG of 16 bits behind twelve bytes that say how floats became whole numbers: d = a / (n - b), 0 for none."""
    data = np.asarray(message.data, np.uint8).tobytes()
    encoding = message.format.split(";")[0].strip()
    if data[:8] == PNG_MAGIC:
        a, b, png = 0.0, 0.0, data
    elif data[12:20] == PNG_MAGIC:
        (_, a, b), png = _DEPTH_HEAD.unpack_from(data), data[12:]
    else:
        reason = f"depth packed as {message.format!r} is no PNG"
        raise FileError(path, reason, remedy="RVL is not read: record depth raw, or packed by png")
    whole = decode_depth(path, png)
    if encoding != "32FC1":
        return whole
    if not (a > 0 and np.isfinite(b)):
        raise FileError(path, f"depth of floats packed with the numbers {a:g} and {b:g}")
    depth = np.zeros(whole.shape, np.float32)
    known = whole > 0
    with np.errstate(divide="ignore"):
        depth[known] = a / (whole[known].astype(np.float64) - b)
    depth[~np.isfinite(depth) | (depth < 0)] = 0
    return depth


def _list(names: Any) -> str:
    return ", ".join(names)
