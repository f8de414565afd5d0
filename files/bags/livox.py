"""Livox's own clouds (`CustomMsg` of livox_ros_driver, livox_ros_driver2 and livox_interfaces), by NumPy's view.

A message is a header, the time of the first point [ns], how many points there are, the number of the scanner, and 19
bytes a point: time after the first [ns], x, y, z, reflectivity, tag, line. ROS 2 pads points to 20 bytes.
Source: CustomMsg.msg and CustomPoint.msg of livox_ros_driver2.
"""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np

from ...core.errors import FileError
from ..table import PointTable
from .pieces import byte_order

LIVOX = tuple(f"{package}/msg/CustomMsg" for package in ("livox_ros_driver", "livox_ros_driver2", "livox_interfaces"))
_FIELDS = [("offset_time", "u4"), ("x", "f4"), ("y", "f4"), ("z", "f4")]
_FIELDS += [("reflectivity", "u1"), ("tag", "u1"), ("line", "u1")]


def table_of_livox(path: Path, data: bytes, encoding: str) -> PointTable:
    """The points of a message, with `time` [s] since the first, `reflectivity`, `tag` and `line`.

    Raises:
        FileError: It ends before its points do, or tells two numbers of them.
    """
    order = byte_order(data, encoding)
    is_one = encoding == "ros1"
    try:
        at = 12  # seq and a stamp, or the encoding and a stamp
        (size,) = struct.unpack_from(order + "I", data, at)
        at += 4 + size
        if not is_one:  # counted from behind the encoding
            at += -(at - 4) % 8
        told, count = struct.unpack_from(order + "8xI4xI", data, at)
    except struct.error as error:
        raise FileError(path, f"a cloud of Livox is cut off in its header: {len(data)} bytes") from error
    if told != count:
        raise FileError(path, f"a cloud of Livox says that it has {told} points, and has {count}")
    step, first = (19 if is_one else 20), at + 20
    kind = np.dtype([(name, order + code) for name, code in _FIELDS])
    needed = first + max(count - 1, 0) * step + (kind.itemsize if count else 0)
    if needed > len(data):
        raise FileError(path, f"a cloud of Livox of {count} points needs {needed} bytes, and has {len(data)}")
    rows = np.ndarray((count,), kind, np.frombuffer(data, np.uint8), first, (step,)) if count else np.zeros(0, kind)
    points = np.stack([rows[axis].astype(np.float32) for axis in "xyz"], axis=1)
    attributes = {name: rows[name].copy() for name in ("reflectivity", "tag", "line")}
    return PointTable(points, attributes={"time": rows["offset_time"] * 1e-9, **attributes})
