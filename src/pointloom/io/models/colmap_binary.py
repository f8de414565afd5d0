"""COLMAP's binary files: cameras.bin, images.bin, points3D.bin, rigs.bin, frames.bin; little-endian, packed.

Tracks have variable length, so one loop reads only the lengths (0.3 s for a million points). The rest is read by
column.
"""

from __future__ import annotations

import struct
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera_models import MODEL_NUMBERS, MODELS, UNSUPPORTED, CameraModel
from ...core.errors import FileError
from ..source import open_source
from .colmap_records import Image, Points, Records, camera_of
from .colmap_rigs import SENSOR_TYPES, Frame, Pose, Rig, Sensor, rig_of

_CAMERA, _IMAGE, _COUNT = struct.Struct("<IiQQ"), struct.Struct("<I7dI"), struct.Struct("<Q")
_KEYPOINT_TYPE = np.dtype([("place", "<f8", 2), ("point", "<i8")])
_POINT_TYPE = np.dtype(
    [("number", "<i8"), ("position", "<f8", 3), ("color", "u1", 3), ("error", "<f8"), ("length", "<i8")]
)
_STEP = np.dtype([("image", "<u4"), ("keypoint", "<u4")])
_RIG, _SENSOR, _FRAME = struct.Struct("<II"), struct.Struct("<iI"), struct.Struct("<II7dI")
_POSE, _FLAG, _DATA = struct.Struct("<7d"), struct.Struct("<B"), struct.Struct("<iIQ")
_LENGTH_AT = _POINT_TYPE.itemsize - 8
LONGEST_NAME = 4096  # bytes: no path is longer
_CUT = "The file is cut off or damaged; copy or write it again"
_ROWS_PER_BLOCK = 1 << 16  # records gathered at a time


class _Reader:
    def __init__(self, path: Path):
        self.path, self.at = path, 0
        self.source = open_source(path)
        self.size = len(self.source)

    def take(self, record: struct.Struct, what: str) -> tuple[Any, ...]:
        self.need(record.size, what)
        values = record.unpack(self.source[self.at : self.at + record.size])
        self.at += record.size
        return values

    def array(self, dtype: np.dtype[Any], count: int, what: str) -> NDArray[Any]:
        self.need(count * dtype.itemsize, what)
        values = self.source.array(dtype, count, self.at)
        self.at += count * dtype.itemsize
        return values

    def need(self, size: int, what: str) -> None:
        if size > self.size - self.at:
            reason = f"ends within {what}: {size - self.size + self.at:,} of {size:,} bytes are missing"
            raise FileError(self.path, reason, where=f"byte {self.at}", remedy=_CUT)

    def count(self, what: str, smallest: int) -> int:
        """A record count that fits into the remaining file."""
        (count,) = self.take(_COUNT, f"the number of {what}")
        if count * smallest > self.size - self.at:
            reason = f"expected {count:,} {what}, but only {self.size - self.at:,} bytes follow"
            raise FileError(self.path, reason, where=f"byte {self.at - 8}", remedy=_CUT)
        return count

    def text(self, what: str) -> str:
        end = self.source.find(b"\0", self.at, self.at + LONGEST_NAME + 1)
        if end < 0:
            reason = f"{what} does not end within {LONGEST_NAME} bytes"
            raise FileError(self.path, reason, where=f"byte {self.at}", remedy=_CUT)
        try:
            text = self.source[self.at : end].decode()
        except UnicodeDecodeError as error:
            raise FileError(self.path, f"{what} is not UTF-8", where=f"byte {self.at + error.start}") from error
        self.at = end + 1
        return text

    def close(self) -> None:
        if self.at != self.size:
            reason = f"{self.size - self.at:,} bytes follow the last record"
            raise FileError(self.path, reason, where=f"byte {self.at}", remedy=_CUT)


def read_cameras(path: Path) -> dict[int, CameraModel]:
    file = _Reader(path)
    cameras: dict[int, CameraModel] = {}
    for _ in range(file.count("cameras", _CAMERA.size)):
        where = f"byte {file.at}"
        number, model, width, height = file.take(_CAMERA, "a camera")
        if number in cameras:
            raise FileError(path, f"the camera number {number} is duplicated", where=where)
        name = MODEL_NUMBERS.get(model)
        if name is None:
            raise unknown_model(path, where, str(model), UNSUPPORTED.get(model))
        params = file.array(np.dtype("<f8"), len(MODELS[name].params.split(", ")), "a camera's parameters")
        cameras[number] = camera_of(path, where, name, width, height, params.tolist())
    file.close()
    return cameras


def unknown_model(path: Path, where: str, model: str, name: str | None) -> FileError:
    """The error for an unsupported camera model; `name` is COLMAP's, if known."""
    if name:
        return FileError(
            path,
            f"the camera model {name} is not supported",
            where=where,
            remedy="Undistort the images with COLMAP first",
        )
    known = ", ".join(MODEL_NUMBERS.values())
    return FileError(path, f"unknown camera model {model[:40]}", where=where, remedy=f"Supported are {known}")


def read_images(path: Path) -> list[Image]:
    file = _Reader(path)
    images = []
    for _ in range(file.count("images", _IMAGE.size + 1 + _COUNT.size)):
        where = f"byte {file.at}"
        number, *pose, camera = file.take(_IMAGE, "an image")
        name = file.text("the name of an image")
        keypoints = file.array(_KEYPOINT_TYPE, file.count("keypoints", _KEYPOINT_TYPE.itemsize), "keypoints")
        pixels, points = keypoints["place"], keypoints["point"]
        images.append(Image(number, name, tuple(pose[:4]), tuple(pose[4:]), camera, pixels, points, where))
    file.close()
    return images


def read_rigs(path: Path) -> list[Rig]:
    file = _Reader(path)
    rigs = []
    for _ in range(file.count("rigs", _RIG.size)):
        where = f"byte {file.at}"
        number, count = file.take(_RIG, "a rig")
        reference = _sensor(file, *file.take(_SENSOR, "a sensor")) if count else None
        sensors: list[tuple[Sensor, Pose | None]] = []
        for _ in range(count - 1):
            sensor = _sensor(file, *file.take(_SENSOR, "a sensor"))
            (has_pose,) = file.take(_FLAG, "a sensor")
            sensors.append((sensor, file.take(_POSE, "the pose of a sensor") if has_pose else None))
        rigs.append(rig_of(path, where, number, reference, sensors))
    file.close()
    return rigs


def read_frames(path: Path) -> list[Frame]:
    file = _Reader(path)
    frames = []
    for _ in range(file.count("frames", _FRAME.size)):
        where = f"byte {file.at}"
        number, rig, *pose, count = file.take(_FRAME, "a frame")
        file.need(count * _DATA.size, "the data of a frame")
        values = [file.take(_DATA, "the data of a frame") for _ in range(count)]
        data = [(_sensor(file, kind, sensor), image) for kind, sensor, image in values]
        frames.append(Frame(number, rig, tuple(pose), data, where))
    file.close()
    return frames


def _sensor(file: _Reader, kind: int, number: int) -> Sensor:
    if not 0 <= kind < len(SENSOR_TYPES):
        known = ", ".join(f"{i} ({name})" for i, name in enumerate(SENSOR_TYPES))
        raise FileError(file.path, f"expected a sensor type of {known}, got {kind}", where=f"byte {file.at}")
    return SENSOR_TYPES[kind], number


def read_points(path: Path) -> Points:
    file = _Reader(path)
    count = file.count("points", _POINT_TYPE.itemsize)
    data = file.source.array(np.uint8, file.size)
    starts = _find_records(file, count, data)
    file.close()
    fixed = _gather(data, starts, _POINT_TYPE.itemsize).view(_POINT_TYPE).reshape(-1)
    lengths = fixed["length"].astype(np.int64)
    is_track = np.ones(len(data), bool)
    is_track[:8] = False
    for begin in range(0, count, _ROWS_PER_BLOCK):
        is_track[starts[begin : begin + _ROWS_PER_BLOCK, None] + np.arange(_POINT_TYPE.itemsize)] = False
    steps = data[is_track].view(_STEP)
    tracks = np.stack([steps["image"], steps["keypoint"]], axis=1).astype(np.int64)
    return Points(
        fixed["number"].astype(np.int64),
        fixed["position"].astype(np.float64),
        fixed["color"].copy(),
        fixed["error"].astype(np.float64),
        lengths,
        tracks,
        lambda row: f"byte {starts[row]}",
    )


def _find_records(file: _Reader, count: int, data: NDArray[np.uint8]) -> NDArray[np.int64]:
    starts, at, view = [0] * count, file.at, data.data
    unpack, size, last = _COUNT.unpack_from, _STEP.itemsize, file.size - 8
    for i in range(count):
        starts[i] = at
        at += _LENGTH_AT
        if at > last:
            raise FileError(file.path, "ends within a point", where=f"byte {starts[i]}", remedy=_CUT)
        at += 8 + size * unpack(view, at)[0]
    file.at = at
    if at > file.size:
        begin = starts[-1]
        raise FileError(file.path, "ends within the track of a point", where=f"byte {begin}", remedy=_CUT)
    return np.array(starts, np.int64)


def _gather(data: NDArray[np.uint8], starts: NDArray[np.int64], width: int) -> NDArray[np.uint8]:
    rows = np.empty((len(starts), width), np.uint8)
    for begin in range(0, len(starts), _ROWS_PER_BLOCK):
        rows[begin : begin + _ROWS_PER_BLOCK] = data[starts[begin : begin + _ROWS_PER_BLOCK, None] + np.arange(width)]
    return rows


def count_images(path: Path) -> int:
    return _Reader(path).count("images", _IMAGE.size + 1 + _COUNT.size)


def write_cameras(file: IO[bytes], records: Records) -> None:
    file.write(_COUNT.pack(len(records.cameras)))
    for number, camera in enumerate(records.cameras, 1):
        file.write(_CAMERA.pack(number, MODELS[camera.model].number, camera.width, camera.height))
        file.write(np.array(camera.params, "<f8").tobytes())


def write_images(file: IO[bytes], records: Records) -> None:
    model = records.model
    file.write(_COUNT.pack(len(model)))
    for i, name in enumerate(model.names):
        begin, end = records.starts[i], records.starts[i + 1]
        pose = (*records.quaternions[i], *model.T_camera_world[i, :3, 3])
        file.write(_IMAGE.pack(i + 1, *pose, records.camera_numbers[i]))
        file.write(name.encode() + b"\0" + _COUNT.pack(end - begin))
        keypoints = np.empty(end - begin, _KEYPOINT_TYPE)
        keypoints["place"], keypoints["point"] = records.keypoints[begin:end], model.observations[begin:end, 1] + 1
        file.write(keypoints.tobytes())


def write_points(file: IO[bytes], records: Records) -> None:
    model, count = records.model, len(records.model.points)
    file.write(_COUNT.pack(count))
    for begin in range(0, count, _ROWS_PER_BLOCK):
        end = min(begin + _ROWS_PER_BLOCK, count)
        fixed = np.empty(end - begin, _POINT_TYPE)
        fixed["number"] = np.arange(begin + 1, end + 1)
        fixed["position"], fixed["color"] = model.points[begin:end], model.colors[begin:end]
        fixed["error"], fixed["length"] = records.errors[begin:end], model.view_counts[begin:end]
        first, last = records.track_starts[begin], records.track_starts[end]
        steps = np.empty(last - first, _STEP)
        steps["image"], steps["keypoint"] = records.tracks[first:last].T
        starts = (
            np.arange(end - begin) * _POINT_TYPE.itemsize + (records.track_starts[begin:end] - first) * _STEP.itemsize
        )
        block = np.empty(fixed.nbytes + steps.nbytes, np.uint8)
        is_track = np.ones(len(block), bool)
        at = starts[:, None] + np.arange(_POINT_TYPE.itemsize)
        is_track[at] = False
        block[at] = fixed.view(np.uint8).reshape(len(fixed), -1)
        block[is_track] = steps.view(np.uint8)
        file.write(block.tobytes())
