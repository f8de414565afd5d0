"""Positions of a scanner from a file, or from the NavSatFix messages of a recording."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.coordinate_systems import CoordinateSystem, Reprojection
from ...core.errors import FileError, FilePath
from ...core.paths import is_recording
from ...io.bags.motions import stamp_of_header
from ...io.bags.recording import Recording, read_recording
from ...pcd.geodesy import WorldFrame
from ...registration.lidar.position_readings import MAX_SIGMA, MIN_SIGMA, PositionReadings

WGS84 = CoordinateSystem("EPSG:4326")  # of the messages
FIX = "sensor_msgs/msg/NavSatFix"
_NO_FIX = 0  # lowest status of a message with a position
_UNKNOWN = 0  # type of a covariance


class GivenPositions(NamedTuple):
    """The `readings`, and notes for the report."""

    readings: PositionReadings | None
    notes: tuple[str, ...] = ()


def read_positions(
    given: FilePath | None, sigma: float, folder: FilePath, topic: str | None, system: CoordinateSystem | None = None
) -> GivenPositions:
    """Read positions of a file; of a recording with one topic of NavSatFix; or of such a topic of the recording
    `folder`, if no file has its name. `topic` is that of the clouds in `folder`, and defines the frame of the scanner.
    NavSatFix is converted to `system`, or to meters east, north and up of the first position. Heights stay.
    """
    if given is None:
        return GivenPositions(None)
    if is_recording(Path(given)):
        return _of_recording(read_recording(given), None, sigma, folder, topic, system)
    if is_recording(Path(folder)) and not Path(given).exists():
        return _of_recording(read_recording(folder), os.fspath(given), sigma, folder, topic, system)
    return GivenPositions(PositionReadings.read(given, sigma))


def _of_recording(
    recording: Recording,
    name: str | None,
    sigma: float,
    folder: FilePath,
    clouds: str | None,
    system: CoordinateSystem | None,
) -> GivenPositions:
    chosen = recording.choose_topic(name, FIX)
    times, degrees, sigmas, count = [], [], [], 0
    for message in recording.messages(chosen):
        count += 1
        row = _row_of(message.content, sigma)
        if row is not None and row[0] not in times[-1:]:
            for column, value in zip((times, degrees, sigmas), row, strict=True):
                column.append(value)
    if not times:
        raise FileError(recording.path, f"{chosen}: none of {count} messages has a position")
    heights = np.array(degrees)[:, 2]
    known = np.isfinite(heights)
    table, spread = np.array(degrees), np.array(sigmas)
    table[:, 2] = np.where(known, heights, heights[known][0] if known.any() else 0.0)
    spread[~known, 2] = MAX_SIGMA
    try:
        frame = WorldFrame(*table[0])
        offset, notes = _antenna(recording, chosen, folder, clouds)
        places = frame.to_enu(table) if system is None else Reprojection(WGS84, system).points(table[:, [1, 0, 2]])
        readings = PositionReadings(np.array(times), places, spread, offset)
    except ValueError as error:
        raise FileError(recording.path, f"{chosen}: {error}") from error
    lost = count - len(times)
    notes += [f"{lost} of {count} messages of {chosen} have no position or repeat a time"] if lost else []
    return GivenPositions(readings, (f"the reference frame is {frame if system is None else system.name}", *notes))


def _row_of(fix: Any, sigma: float) -> tuple[float, list[float], NDArray[np.float64]] | None:
    """Time [s], latitude, longitude [degrees] and height [m], and standard deviations [m] of a message. None without a
    position."""
    place = [float(fix.latitude), float(fix.longitude), float(fix.altitude)]
    if fix.status.status < _NO_FIX or not np.isfinite(place[:2]).all():
        return None
    variances = np.array(fix.position_covariance, np.float64)[[0, 4, 8]]
    is_known = (variances > 0) & np.isfinite(variances) & (fix.position_covariance_type != _UNKNOWN)
    deviations = np.sqrt(np.where(is_known, variances, sigma**2))
    return stamp_of_header(fix.header), place, np.clip(deviations, MIN_SIGMA, MAX_SIGMA)


def _antenna(
    recording: Recording, topic: str, folder: FilePath, clouds: str | None
) -> tuple[NDArray[np.float64], list[str]]:
    """The antenna in the frame of the scanner [m], by the static transform between their frames, and notes."""
    drive = (
        recording if recording.path == Path(folder) else read_recording(folder) if is_recording(Path(folder)) else None
    )
    own = recording.header_at(recording.rows_of(topic)[0])[1].removeprefix("/")
    frame = ""
    if drive is not None:
        chosen = drive.choose_topic(clouds)
        frame = drive.header_at(drive.rows_of(chosen)[0])[1].removeprefix("/")
    if drive is None or not own or not frame or own == frame:
        return np.zeros(3), []
    try:
        return drive.transforms().lookup(frame, own)[:3, 3], []
    except FileError as error:
        return np.zeros(3), [f"the antenna ({own}) is assumed at the scanner ({frame}): {error.reason}"]
