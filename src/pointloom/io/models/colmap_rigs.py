"""Rigs and frames of COLMAP 4, which determine the poses of the images.

The pose of an image is that of its frame, followed by that of its sensor in the rig: camera_from_rig * rig_from_world.
COLMAP ignores the copies of the poses in images.bin and images.txt if there are frames, so they may be outdated.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError
from ...kernels.linear_algebra import matmul
from .colmap_records import MIXED, Image, poses_of

CAMERA = "CAMERA"
SENSOR_TYPES = (CAMERA, "IMU")  # by their number in binary files

Sensor = tuple[str, int]  # type and number. The number of a camera is that of cameras.bin or cameras.txt
Pose = tuple[float, ...]  # quaternion w, x, y, z and translation
_IDENTITY_POSE: Pose = (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
_ONE_SOURCE = "Write rigs and frames again, or remove both to use the poses of the images"


@dataclasses.dataclass
class Rig:
    """A record of rigs: the pose of each sensor, rig to sensor. None if unknown; that of the reference is identity."""

    number: int
    sensors: dict[Sensor, Pose | None]
    where: str


@dataclasses.dataclass
class Frame:
    """A record of frames: the pose world to rig, and the number of the data of each sensor, for cameras an image."""

    number: int
    rig: int
    pose: Pose
    data: list[tuple[Sensor, int]]
    where: str


def rig_of(
    path: Path, where: str, number: int, reference: Sensor | None, sensors: Sequence[tuple[Sensor, Pose | None]]
) -> Rig:
    """A rig without duplicated sensors."""
    poses: dict[Sensor, Pose | None] = {} if reference is None else {reference: _IDENTITY_POSE}
    for sensor, pose in sensors:
        if sensor in poses:
            raise FileError(path, f"the sensor {_title(sensor)} of rig {number} is duplicated", where=where)
        poses[sensor] = pose
    return Rig(number, poses, where)


def read_frame_poses(paths: dict[str, Path], images: list[Image], reader: Any) -> NDArray[np.float64] | None:
    """Poses of all images, world to camera (n, 4, 4), or None if there are no rigs and frames.
    `reader` has `read_rigs` and `read_frames`, `paths` their files."""
    rigs = reader.read_rigs(paths["rigs"]) if paths["rigs"].is_file() else []
    frames = reader.read_frames(paths["frames"]) if paths["frames"].is_file() else []
    if not rigs and not frames:
        return None
    for name, other in (("rigs", "frames"), ("frames", "rigs")):
        if not paths[name].is_file():
            reason = f"does not exist, but {paths[other].name} does"
            raise FileError(paths[name], reason, remedy=_ONE_SOURCE)
    by_number = _by_number(paths["rigs"], rigs, "rig")
    _by_number(paths["frames"], frames, "frame")
    frame_rows, sensors = _find_frames(paths["frames"], by_number, frames, images)
    T_rig_world = _poses(paths["frames"], frames, lambda frame: f"frame {frame.number}", lambda frame: frame.pose)
    chosen = list(dict.fromkeys((frames[row].rig, sensor) for row, sensor in zip(frame_rows, sensors, strict=True)))
    T_sensor_rig = _sensor_poses(paths["rigs"], by_number, chosen)
    rows = {key: row for row, key in enumerate(chosen)}
    sensor_rows = [rows[frames[row].rig, sensor] for row, sensor in zip(frame_rows, sensors, strict=True)]
    return matmul(T_sensor_rig[sensor_rows], T_rig_world[frame_rows])


def _by_number(path: Path, records: Sequence[Any], what: str) -> dict[int, Any]:
    by_number: dict[int, Any] = {}
    for record in records:
        if record.number in by_number:
            raise FileError(path, f"the {what} number {record.number} is duplicated", where=record.where)
        by_number[record.number] = record
    return by_number


def _find_frames(
    path: Path, rigs: dict[int, Rig], frames: list[Frame], images: list[Image]
) -> tuple[list[int], list[Sensor]]:
    """The row of the frame of each image, and its camera. Data of images that are not in the model is ignored."""
    rows: dict[int, tuple[int, Sensor]] = {}
    for row, frame in enumerate(frames):
        if frame.rig not in rigs:
            reason = f"frame {frame.number} refers to rig {frame.rig}, which is missing in rigs{path.suffix}"
            raise FileError(path, reason, where=frame.where, remedy=MIXED)
        for sensor, number in frame.data:
            if sensor not in rigs[frame.rig].sensors:
                reason = f"frame {frame.number} has data of {_title(sensor)}, which rig {frame.rig} does not have"
                raise FileError(path, reason, where=frame.where, remedy=MIXED)
            if sensor[0] == CAMERA and number in rows:
                first = frames[rows[number][0]].number
                reason = f"image {number} belongs to the frames {first} and {frame.number}"
                raise FileError(path, reason, where=frame.where, remedy=_ONE_SOURCE)
            if sensor[0] == CAMERA:
                rows[number] = row, sensor
    for image in images:
        if image.number not in rows:
            reason = f"image {image.number} ({image.name!r}) belongs to no frame"
            raise FileError(path, reason, remedy=_ONE_SOURCE)
        row, sensor = rows[image.number]
        if sensor[1] != image.camera:
            reason = f"image {image.number} ({image.name!r}) is of {_title(sensor)}, and of camera {image.camera}"
            reason += f" in images{path.suffix}"
            raise FileError(path, reason, where=frames[row].where, remedy=_ONE_SOURCE)
    return [rows[p.number][0] for p in images], [rows[p.number][1] for p in images]


def _sensor_poses(path: Path, rigs: dict[int, Rig], chosen: list[tuple[int, Sensor]]) -> NDArray[np.float64]:
    for number, sensor in chosen:
        if rigs[number].sensors[sensor] is None:
            reason = f"{_title(sensor)} of rig {number} has images, but no pose in the rig"
            raise FileError(path, reason, where=rigs[number].where, remedy="Calibrate the rig in COLMAP first")
    return _poses(
        path,
        chosen,
        lambda key: f"{_title(key[1])} of rig {key[0]}",
        lambda key: rigs[key[0]].sensors[key[1]] or _IDENTITY_POSE,
        lambda key: rigs[key[0]].where,
    )


def _poses(
    path: Path,
    records: Sequence[Any],
    title: Callable[[Any], str],
    pose: Callable[[Any], Pose],
    where: Callable[[Any], str] = lambda record: record.where,
) -> NDArray[np.float64]:
    values = np.array([pose(record) for record in records]).reshape(-1, 7)
    return poses_of(path, values[:, :4], values[:, 4:], lambda i: (title(records[i]), where(records[i])))


def _title(sensor: Sensor) -> str:
    return f"{sensor[0].lower() if sensor[0] == CAMERA else sensor[0]} {sensor[1]}"
