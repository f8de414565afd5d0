"""PointCloud2 as the drivers of LiDARs fill it, read by NumPy's view of its rows.

Times per point become the attribute `time` [s] since the first point where their unit is sure (point_times.py). All
other fields keep their names and types.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError
from ..table import PointTable
from .point_times import with_seconds

TYPES = ("i1", "u1", "i2", "u2", "i4", "u4", "f4", "f8")  # datatype 1 to 8 of sensor_msgs/PointField
_OWN = ("points", "normals", "colors")


def table_of_message(path: Path, message: Any) -> PointTable:
    """The points of a PointCloud2; those that are not finite are kept, as in other files.

    Raises:
        FileError: Fields that do not fit the rows, no coordinates, or fewer bytes than announced.
    """
    columns = _columns(path, message)
    missing = [name for name in "xyz" if name not in columns]
    if missing:
        raise FileError(path, f"a cloud has no field {missing[0]!r}; it has {', '.join(columns) or 'none'}")
    if any(columns[name].dtype.kind != "f" or columns[name].ndim != 1 for name in "xyz"):
        raise FileError(path, "a cloud has coordinates that are not single floats")
    points = np.stack([_native(columns.pop(name)) for name in "xyz"], axis=1)
    attributes = {}
    colors = _colors(columns)
    for name, values in columns.items():
        attributes[name + "_field" if name in _OWN else name] = _native(values)
    seen = np.isfinite(points).all(axis=1) & (points != 0).any(axis=1)
    stamp = message.header.stamp
    attributes = with_seconds(path, attributes, seen, stamp.sec + stamp.nanosec * 1e-9)
    grid = (int(message.height), int(message.width)) if message.height > 1 and message.width else None
    return PointTable(points, colors=colors, attributes=attributes, grid=grid)


def _columns(path: Path, message: Any) -> dict[str, NDArray[Any]]:
    width, height, step, row = (int(message.width), int(message.height), int(message.point_step), int(message.row_step))
    order = ">" if message.is_bigendian else "<"
    names, formats, offsets = [], [], []
    for field in message.fields:
        if not 1 <= field.datatype <= len(TYPES):
            raise FileError(path, f"field {field.name!r} of a cloud has the unknown type {field.datatype}")
        form, count = order + TYPES[field.datatype - 1], max(int(field.count), 1)
        if field.offset + count * np.dtype(form).itemsize > step:
            raise FileError(path, f"field {field.name!r} of a cloud reaches beyond its rows of {step} bytes")
        if field.name and field.name not in names:
            names.append(field.name)
            formats.append((form, (count,)) if count > 1 else form)
            offsets.append(int(field.offset))
    data = np.asarray(message.data, np.uint8).reshape(-1)
    if height > 1 and row < width * step:
        raise FileError(path, f"a cloud has rows of {row} bytes for {width} points of {step}")
    needed = (height - 1) * row + width * step if height > 1 else width * height * step
    if width and height and (step < 1 or needed > len(data)):
        raise FileError(path, f"a cloud of {width} x {height} points needs {needed} bytes, and has {len(data)}")
    kind = np.dtype({"names": names, "formats": formats, "offsets": offsets, "itemsize": max(step, 1)})
    if not (width and height):
        rows = np.zeros(0, kind)
    elif height > 1:
        rows = np.ndarray((height, width), kind, np.ascontiguousarray(data), 0, (row, step)).reshape(-1)
    else:
        rows = np.frombuffer(np.ascontiguousarray(data), kind, width * height)
    return {name: rows[name] for name in names}


def _native(values: NDArray[Any]) -> NDArray[Any]:
    return np.ascontiguousarray(values, values.dtype.newbyteorder("="))


def _colors(columns: dict[str, NDArray[Any]]) -> NDArray[np.float32] | None:
    """Colours packed into four bytes, as PCL has them."""
    for name in ("rgb", "rgba"):
        if name in columns and columns[name].ndim == 1 and columns[name].dtype.itemsize == 4:
            packed = _native(columns.pop(name)).view(np.uint32)
            channels = [(packed >> np.uint32(shift)) & np.uint32(255) for shift in (16, 8, 0)]
            return np.stack(channels, axis=1).astype(np.float32) / np.float32(255)
    return None
