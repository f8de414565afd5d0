"""The times that drivers of LiDARs write beside each point, in seconds where their unit is sure.

A field's name and type tell the unit where one driver alone writes them: velodyne_pointcloud `time` (float, s),
ouster_ros `t` and livox_ros_driver2 `offset_time` (whole, ns). `timestamp` (float64) is s of hesai_ros_driver and
rslidar_sdk and ns of livox_ros_driver2, of a clock that began in 1970 or when the sensor was switched on; and there are
drivers and converted sets with microseconds under each of these names. So a unit has to agree with the message: with
the time in its header, where the field has the same clock, or else with a sweep, which takes between 2 ms and 1.5 s. A
thousand lies between two units, so that no two of them agree with either.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.units import warn_of_units
from .pieces import RecordingWarning

NAMES = ("time", "t", "timestamp", "offset_time", "time_offset", "timeStamp", "time_stamp")
UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
WRITTEN = {("time", "f"): "s", ("t", "u"): "ns", ("offset_time", "u"): "ns"}  # by one driver, see above
SWEEP = (2e-3, 1.5)  # [s] that a message takes
SHORTEST = 5e-4  # [s] that a message of a unit that is written takes
APART = 2.0  # [s] at most between the header's time and the first point's, of one clock
SINCE = 60.0  # [s] a clock has gone for; an earlier time may be one since the sweep began
COARSEST = 1e-3  # [s] steps of floats beyond which times of points are none


def with_seconds(path: Path, columns: Mapping[str, NDArray[Any]], seen: NDArray[Any], stamp: float) -> dict[str, Any]:
    """The columns with `time` [s] since the first point in the place of the driver's, where its unit is sure.

    Args:
        path: Named where the unit is not sure.
        columns: By name, one row a point.
        seen: bool [n]: which points were measured.
        stamp: The time in the message's header [s].

    Warns:
        RecordingWarning: No unit agrees with the message, or another than the one that this driver writes. Without a
            unit the numbers stay as they are, `time` under the name `timestamps`.
    """
    kept = dict(columns)
    name = next((name for name in NAMES if name in kept and kept[name].ndim == 1), None)
    if name is None:
        return kept
    raw = kept.pop(name)
    times = raw.astype(np.float64) if raw.dtype.kind == "f" else raw.astype(np.int64)
    measured = _set(times[seen & np.isfinite(times)])
    written = WRITTEN.get((name, raw.dtype.kind))
    unit = _unit(measured, written, stamp, _steps(raw.dtype, measured))
    if unit is None:
        other = name if name != "time" else "timestamps"
        told = f"the times of points in {name!r} are in no unit in which a sweep takes {SWEEP[0]:g} to {SWEEP[1]:g} s"
        warn_of_units(f"{path}: {told}; they stay as they are, as {other!r}", RecordingWarning)
        return {**kept, other: raw}
    if written is not None and unit != written:
        told = f"the times of points in {name!r} are read as {unit}: in {written} they would be those of no sweep"
        warn_of_units(f"{path}: {told}", RecordingWarning)
    first = measured.min() if measured.size else times.dtype.type(0)
    return {**kept, "time": np.asarray((times - first) * UNITS[unit], np.float64)}


def _set(times: NDArray[Any]) -> NDArray[Any]:
    """The times without those that a driver left at zero, among times of a clock."""
    others = times[times != 0]
    span = others.max() - others.min() if others.size else 0
    return others if 0 < 10 * span < others.min() else times


def _steps(kind: np.dtype[Any], times: NDArray[Any]) -> float:
    """Between two times that a type tells apart, in their unit."""
    return float(np.finfo(kind).eps * np.abs(times).max(initial=0.0)) if kind.kind == "f" else 1.0


def _unit(times: NDArray[Any], written: str | None, stamp: float, step: float) -> str | None:
    """The unit that agrees with the header or with a sweep; the one that is written where nothing speaks against it."""
    if not times.any():
        return written or "s"  # as good as any
    first, span = float(times.min()), float(times.max() - times.min())
    known = {unit: scale for unit, scale in UNITS.items() if step * scale < COARSEST}
    fitting = [u for u, scale in known.items() if stamp > SINCE < first * scale and abs(first * scale - stamp) < APART]
    if not fitting and written in known and (span == 0 or SHORTEST <= span * UNITS[written] <= SWEEP[1]):
        fitting = [written]
    if not fitting and span == 0 and "s" in known:
        fitting = ["s"]
    fitting = fitting or [unit for unit, scale in known.items() if SWEEP[0] <= span * scale <= SWEEP[1]]
    return fitting[0] if fitting else None
