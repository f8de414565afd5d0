"""Point clouds in recordings: PointCloud2 and Livox CustomMsg, read as NumPy views.

Per-point times become `time` [s] since the first point if their unit is certain, as drivers differ: `time` is s
(velodyne_pointcloud); `t`, `offset_time` are ns (ouster_ros, livox_ros_driver2); `timestamp` is s (hesai_ros_driver,
rslidar_sdk) or ns (livox_ros_driver2). Some data use microseconds. The unit must match the header time or a sweep of 2
ms to 1.5 s. Units differ by 1,000, so at most one does. CustomMsg: header, base time [ns], count, scanner, then 19 B
per point (ROS 2: 20).
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError
from ...core.time_checks import float32_step, is_single
from ...core.units import warn_of_units
from ..columns import colors_or_loss, roles_in_lower_case
from ..table import PointTable
from .message_chunks import RecordingWarning, byte_order

LIVOX = tuple(f"{package}/msg/CustomMsg" for package in ("livox_ros_driver", "livox_ros_driver2", "livox_interfaces"))
_FIELDS = [("offset_time", "u4"), ("x", "f4"), ("y", "f4"), ("z", "f4")]
_FIELDS += [("reflectivity", "u1"), ("tag", "u1"), ("line", "u1")]


def table_of_livox(path: Path, data: bytes, encoding: str) -> PointTable:
    """The points of a CustomMsg, with `time` [s] since the first, `reflectivity`, `tag` and `line`."""
    order = byte_order(data, encoding)
    is_one = encoding == "ros1"
    try:
        at = 12  # seq and a stamp, or the encoding and a stamp
        (size,) = struct.unpack_from(order + "I", data, at)
        at += 4 + size
        if not is_one:  # relative to the end of the encoding
            at += -(at - 4) % 8
        declared_count, count = struct.unpack_from(order + "8xI4xI", data, at)
    except struct.error as error:
        raise FileError(path, f"a Livox cloud is cut off in its header: {len(data)} bytes") from error
    if declared_count != count:
        raise FileError(path, f"a Livox cloud declares {declared_count} points, but has {count}")
    step, first = (19 if is_one else 20), at + 20
    kind = np.dtype([(name, order + code) for name, code in _FIELDS])
    needed = first + max(count - 1, 0) * step + (kind.itemsize if count else 0)
    if needed > len(data):
        raise FileError(path, f"a Livox cloud of {count} points needs {needed} bytes, but has {len(data)}")
    rows = np.ndarray((count,), kind, np.frombuffer(data, np.uint8), first, (step,)) if count else np.zeros(0, kind)
    points = np.stack([rows[axis].astype(np.float32) for axis in "xyz"], axis=1)
    attributes = {name: rows[name].copy() for name in ("reflectivity", "tag", "line")}
    return PointTable(points, attributes={"time": rows["offset_time"] * 1e-9, **attributes})


NAMES = ("time", "t", "timestamp", "offset_time", "time_offset", "timeStamp", "time_stamp")
SECONDS_PER_UNIT = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
WRITTEN = {("time", "f"): "s", ("t", "u"): "ns", ("offset_time", "u"): "ns"}  # of one driver, see above
SWEEP_DURATIONS = (2e-3, 1.5)  # [s] plausible duration of a message
MIN_DURATION = 5e-4  # [s] plausible duration of a message with a documented unit
MAX_CLOCK_DIFFERENCE = 2.0  # [s] maximum difference of header time and first point, same clock
MIN_CLOCK_TIME = 60.0  # [s] minimum clock time. An earlier one may be relative to the sweep
MIN_STEPS = 8  # minimum number of steps of float32 in a sweep, below which its times are useless
MAX_TIME_STEP = 1e-3  # [s] float resolution beyond which point times are useless


def with_seconds(
    path: Path, columns: Mapping[str, NDArray[Any]], seen: NDArray[Any], stamp: float, *, absolute_times: bool = False
) -> dict[str, Any]:
    """Replace the driver's times by `time` [s] since the first point, or on the clock of the header, if their unit is
    certain. `seen` (n,) marks measured points, `stamp` is the header time [s]. Warns of unknown or unexpected units.
    Without a unit the values are unchanged, with `time` renamed to `timestamps`."""
    remaining = dict(columns)
    name = next((name for name in NAMES if name in remaining and remaining[name].ndim == 1), None)
    if name is None:
        return remaining
    raw = remaining.pop(name)
    times = raw.astype(np.float64) if raw.dtype.kind == "f" else raw.astype(np.int64)
    measured = _set(times[seen & np.isfinite(times)])
    written = WRITTEN.get((name, raw.dtype.kind))
    unit = _unit(measured, written, stamp, _steps(raw.dtype, measured))
    if unit is None and is_single(raw.dtype) and measured.size and _is_coarse(measured):
        largest = float(np.abs(measured).max())
        message = f"are float32 numbers up to {largest:.6g}, which are {float32_step(largest):g} apart"
        message = f"the point times in {name!r} {message}, so scans are not deskewed; they are kept as '{name}_field'"
        warn_of_units(f"{path}: {message}", RecordingWarning)
        return {**remaining, name + "_field": raw}
    if unit is None:
        other = name if name != "time" else "timestamps"
        low, high = SWEEP_DURATIONS
        message = f"the point times in {name!r} give no sweep of {low:g} to {high:g} s in any unit"
        warn_of_units(f"{path}: {message}; they are kept unchanged as {other!r}", RecordingWarning)
        return {**remaining, other: raw}
    if written is not None and unit != written:
        message = f"the point times in {name!r} are read as {unit}: in {written} no sweep has such a duration"
        warn_of_units(f"{path}: {message}", RecordingWarning)
    first = measured.min() if measured.size else times.dtype.type(0)
    start = 0.0
    if absolute_times:
        finite = times[np.isfinite(times)]
        low, high = (
            float(end) * SECONDS_PER_UNIT[unit] for end in (finite.min(initial=first), finite.max(initial=first))
        )
        start = _start(float(first * SECONDS_PER_UNIT[unit]), stamp, is_clock=low > high - low > 0)
    return {**remaining, "time": np.asarray((times - first) * SECONDS_PER_UNIT[unit] + start, np.float64)}


def _is_coarse(times: NDArray[Any]) -> bool:
    """True if float32 numbers do not resolve the sweep."""
    low, high = float(times.min()), float(times.max())
    return high - low < MIN_STEPS * float32_step(max(abs(low), abs(high)))


def _start(first: float, stamp: float, *, is_clock: bool) -> float:
    """The time of the first point on the clock of the header, whose time is `stamp` [s].

    `is_clock`: the times begin more than a sweep after zero, so they are not relative to the header."""
    is_same_clock = abs(first - stamp) < MAX_CLOCK_DIFFERENCE
    if is_same_clock and first > MIN_CLOCK_TIME:
        return first
    # times relative to the header are negative if it is the time of the last packet
    if abs(first) <= SWEEP_DURATIONS[1] and not is_clock:
        return stamp + first
    return first if is_same_clock else stamp  # another clock, such as the time since the scanner started


def _set(times: NDArray[Any]) -> NDArray[Any]:
    """Clock times without unset zeros."""
    others = times[times != 0]
    span = others.max() - others.min() if others.size else 0
    return others if 0 < 10 * span < others.min() else times


def _steps(kind: np.dtype[Any], times: NDArray[Any]) -> float:
    """Resolution of a time type, in its unit."""
    return float(np.finfo(kind).eps * np.abs(times).max(initial=0.0)) if kind.kind == "f" else 1.0


def _unit(times: NDArray[Any], written: str | None, stamp: float, step: float) -> str | None:
    """The unit consistent with the header or a sweep. The documented one if there is no contradiction."""
    if not times.any():
        return written or "s"  # as good as any
    first, span = float(times.min()), float(times.max() - times.min())
    known = {unit: scale for unit, scale in SECONDS_PER_UNIT.items() if step * scale < MAX_TIME_STEP}
    starts = {unit: first * scale for unit, scale in known.items() if stamp > MIN_CLOCK_TIME < first * scale}
    fitting = [unit for unit, start in starts.items() if abs(start - stamp) < MAX_CLOCK_DIFFERENCE]
    shortest, longest = SWEEP_DURATIONS
    if not fitting and written in known and (span == 0 or MIN_DURATION <= span * known[written] <= longest):
        fitting = [written]
    if not fitting and span == 0 and "s" in known:
        fitting = ["s"]
    fitting = fitting or [unit for unit, scale in known.items() if shortest <= span * scale <= longest]
    return fitting[0] if fitting else None


PCL_TYPES = {9: "int64", 10: "uint64", 11: "bool"}  # as PCL writes them, which sensor_msgs does not define
TYPES = ("i1", "u1", "i2", "u2", "i4", "u4", "f4", "f8")  # datatype 1 to 8 of sensor_msgs/PointField
_CHANNELS = (("red", "green", "blue"), ("r", "g", "b"))
_OWN = ("points", "normals", "colors")


def table_of_message(path: Path, message: Any, *, absolute_times: bool = False) -> PointTable:
    """The points of a PointCloud2, including non-finite ones. Raises `FileError` if its fields are invalid."""
    columns = _columns(path, message)
    missing = [name for name in "xyz" if name not in columns]
    if missing:
        raise FileError(path, f"a cloud has no field {missing[0]!r}; it has {', '.join(columns) or 'none'}")
    if any(columns[name].dtype.kind != "f" or columns[name].ndim != 1 for name in "xyz"):
        raise FileError(path, "a cloud has coordinates that are not one float each")
    points = np.stack([_native(columns.pop(name)) for name in "xyz"], axis=1)
    attributes = {}
    colors = _colors(path, columns)
    for name, values in columns.items():
        attributes[name + "_field" if name in _OWN else name] = _native(values)
    seen = np.isfinite(points).all(axis=1) & (points != 0).any(axis=1)
    stamp = message.header.stamp
    time = stamp.sec + stamp.nanosec * 1e-9
    attributes = with_seconds(path, attributes, seen, time, absolute_times=absolute_times)
    grid = (int(message.height), int(message.width)) if message.height > 1 and message.width else None
    return PointTable(points, colors=colors, attributes=attributes, grid=grid)


def _columns(path: Path, message: Any) -> dict[str, NDArray[Any]]:
    width, height, step, row = (int(message.width), int(message.height), int(message.point_step), int(message.row_step))
    order = ">" if message.is_bigendian else "<"
    names: list[str] = []
    formats, offsets, dropped = [], [], []
    for field in message.fields:
        if field.datatype in PCL_TYPES:
            dropped.append(f"{field.name} ({PCL_TYPES[field.datatype]})")
            continue
        if not 1 <= field.datatype <= len(TYPES):
            raise FileError(path, f"field {field.name!r} of a cloud has the unknown type {field.datatype}")
        form, count = order + TYPES[field.datatype - 1], max(int(field.count), 1)
        if field.offset + count * np.dtype(form).itemsize > step:
            raise FileError(path, f"field {field.name!r} of a cloud reaches beyond its rows of {step} bytes")
        if field.name and field.name not in names:
            names.append(field.name)
            formats.append((form, (count,)) if count > 1 else form)
            offsets.append(int(field.offset))
    if dropped:
        message_text = f"{path}: fields of types that PointField does not define are left out: {', '.join(dropped)}"
        warn_of_units(message_text, RecordingWarning)
    if not names:
        return {}
    data = np.asarray(message.data, np.uint8).reshape(-1)
    if height > 1 and len(data) == width * height * step:
        row = width * step  # some drivers write the size of the image, or zero, for that of a row
    if height > 1 and row < width * step:
        raise FileError(path, f"a cloud has rows of {row} bytes for {width} points of {step}")
    needed = (height - 1) * row + width * step if height > 1 else width * height * step
    if width and height and needed > len(data):
        raise FileError(path, f"a cloud of {width} x {height} points needs {needed} bytes, but has {len(data)}")
    kind = np.dtype({"names": names, "formats": formats, "offsets": offsets, "itemsize": step})
    if not (width and height):
        rows = np.zeros(0, kind)
    elif height > 1:
        rows = np.ndarray((height, width), kind, np.ascontiguousarray(data), 0, (row, step)).reshape(-1)
    else:
        rows = np.frombuffer(np.ascontiguousarray(data), kind, width * height)
    spelled = roles_in_lower_case(names, (("x", "y", "z"), *_CHANNELS))
    return {spelled.get(name, name): rows[name] for name in names}


def _native(values: NDArray[Any]) -> NDArray[Any]:
    return np.ascontiguousarray(values, values.dtype.newbyteorder("="))


def _colors(path: Path, columns: dict[str, NDArray[Any]]) -> NDArray[np.float32] | None:
    """Colors packed in four bytes, as in PCL, or in three fields."""
    for name in ("rgb", "rgba"):
        if name in columns and columns[name].ndim == 1 and columns[name].dtype.itemsize == 4:
            packed = _native(columns.pop(name)).view(np.uint32)
            channels = [(packed >> np.uint32(shift)) & np.uint32(255) for shift in (16, 8, 0)]
            return np.stack(channels, axis=1).astype(np.float32) / np.float32(255)
    for names in _CHANNELS:
        if all(name in columns and columns[name].ndim == 1 for name in names):
            return colors_or_loss(path, [_native(columns.pop(name)) for name in names])
    return None
