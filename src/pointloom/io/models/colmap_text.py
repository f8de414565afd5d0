"""COLMAP's text files: cameras.txt, images.txt, points3D.txt, rigs.txt, frames.txt.

`#` lines and blank lines are skipped, except that the line after an image always has its keypoints and may be blank.
Image names may contain blanks.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import IO

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera_models import MODEL_NUMBERS, UNSUPPORTED, CameraModel
from ...core.errors import FileError
from ..ascii_rows import AsciiRows
from ..source import open_source
from .colmap_binary import unknown_model
from .colmap_records import CUT, Image, Points, Records, camera_of
from .colmap_rigs import SENSOR_TYPES, Frame, Pose, Rig, Sensor, rig_of

_COMMENT = re.compile(rb"^[ \t]*#[^\r\n]*", re.M)
_MAX_EXACT_INTEGER = 2**53  # up to here integers are exact in float64
_ROWS_PER_BLOCK = 1 << 14


def read_cameras(path: Path) -> dict[int, CameraModel]:
    cameras: dict[int, CameraModel] = {}
    for line, text in _lines(path):
        words, where = text.split(), f"line {line}"
        if not words or words[0].startswith("#"):
            continue
        if len(words) < 5:
            reason = f"expected number, model, width, height and parameters, got {len(words)} columns"
            raise FileError(path, reason, where=where)
        number, width, height = (_integer(path, where, words[i]) for i in (0, 2, 3))
        if number in cameras:
            raise FileError(path, f"the camera number {number} is duplicated", where=where)
        if words[1] not in MODEL_NUMBERS.values():
            raise unknown_model(path, where, repr(words[1]), words[1] if words[1] in UNSUPPORTED.values() else None)
        cameras[number] = camera_of(path, where, words[1], width, height, [_real(path, where, w) for w in words[4:]])
    return cameras


def read_images(path: Path) -> list[Image]:
    images, lines = [], _lines(path)
    for line, text in lines:
        words, where = text.split(None, 9), f"line {line}"
        if not words or words[0].startswith("#"):
            continue
        if len(words) < 10:
            reason = f"expected number, 4 + 3 numbers of the pose, camera and name, got {len(words)} columns"
            remedy = "Each image is followed by one line of keypoints, which may be blank"
            raise FileError(path, reason, where=where, remedy=remedy)
        number, camera = _integer(path, where, words[0]), _integer(path, where, words[8])
        pose = tuple(_real(path, where, word) for word in words[1:8])
        below, keypoints = next(lines, (line + 1, None))
        if keypoints is None:
            reason = f"ends after image {words[9]!r}, whose line of keypoints is missing"
            raise FileError(path, reason, where=where, remedy="The file may be cut off; the line may be blank")
        pixels, points = _keypoints(path, below, keypoints)
        images.append(Image(number, words[9], pose[:4], pose[4:], camera, pixels, points, where))
    return images


def read_rigs(path: Path) -> list[Rig]:
    rigs = []
    for words in _records(path):
        number, count = words.integer(), words.integer()
        reference = words.sensor() if count else None
        sensors: list[tuple[Sensor, Pose | None]] = []
        for _ in range(count - 1):
            sensor = words.sensor()
            sensors.append((sensor, words.reals(7) if words.integer() else None))
        words.end()
        rigs.append(rig_of(path, words.where, number, reference, sensors))
    return rigs


def read_frames(path: Path) -> list[Frame]:
    frames = []
    for words in _records(path):
        number, rig, pose = words.integer(), words.integer(), words.reals(7)
        data = [(words.sensor(), words.integer()) for _ in range(words.integer())]
        words.end()
        frames.append(Frame(number, rig, pose, data, words.where))
    return frames


class _Words:
    """The words of a line, taken from left to right."""

    def __init__(self, path: Path, where: str, words: list[str]):
        self.path, self.where, self._words, self._at = path, where, words, 0

    def integer(self) -> int:
        return _integer(self.path, self.where, self._next())

    def reals(self, count: int) -> tuple[float, ...]:
        return tuple(_real(self.path, self.where, self._next()) for _ in range(count))

    def sensor(self) -> Sensor:
        kind = self._next()
        if kind not in SENSOR_TYPES:
            reason = f"expected a sensor type ({' or '.join(SENSOR_TYPES)}), got {kind[:40]!r}"
            raise FileError(self.path, reason, where=self.where)
        return kind, self.integer()

    def _next(self) -> str:
        if self._at == len(self._words):
            raise FileError(self.path, f"expected more than {self._at} words", where=self.where, remedy=CUT)
        self._at += 1
        return self._words[self._at - 1]

    def end(self) -> None:
        if self._at < len(self._words):
            reason = f"expected {self._at} words, got {len(self._words)}"
            raise FileError(self.path, reason, where=self.where)


def _records(path: Path) -> Iterator[_Words]:
    for line, text in _lines(path):
        words = text.split()
        if words and not words[0].startswith("#"):
            yield _Words(path, f"line {line}", words)


def _keypoints(path: Path, line: int, text: str) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    numbers = AsciiRows(path, text.encode(), line).numbers()
    if len(numbers) % 3:
        raise FileError(path, f"expected 3 numbers per keypoint, got {len(numbers)}", where=f"line {line}")
    table = numbers.reshape(-1, 3)
    return table[:, :2], _as_integers(path, table[:, 2], -1, lambda _: f"line {line}", "the number of a point")


def read_points(path: Path) -> Points:
    """The points in file order. An empty file is allowed, as in COLMAP's guide for known poses."""
    body = _body(path)
    rows = AsciiRows(path, _COMMENT.sub(b"", body), 1)
    numbers, widths, first = rows.numbers(), rows.widths(), rows.first[:-1]
    wrong = np.flatnonzero((widths < 8) | (widths % 2 == 1))
    if len(wrong):
        reason = f"expected 8 numbers and two per step of the track, got {widths[wrong[0]]}"
        raise FileError(path, reason, where=rows.where(int(wrong[0])))
    fixed = numbers[first[:, None] + np.arange(8)].reshape(-1, 8)
    is_track = np.ones(len(numbers), bool)
    is_track[first[:, None] + np.arange(8)] = False
    lengths = (widths - 8) // 2
    owners = np.repeat(np.arange(len(first)), lengths * 2)
    tracks = _as_integers(path, numbers[is_track], 0, lambda i: rows.where(int(owners[i])), "a step of a track")
    colors = _as_integers(path, fixed[:, 4:7].reshape(-1), 0, lambda i: rows.where(i // 3), "a color")
    bright = np.flatnonzero(colors > 255)
    if len(bright):
        reason = f"expected colors of 0..255, got {colors[bright[0]]}"
        raise FileError(path, reason, where=rows.where(int(bright[0]) // 3))
    return Points(
        _as_integers(path, fixed[:, 0], 0, rows.where, "the number of a point"),
        fixed[:, 1:4],
        colors.reshape(-1, 3).astype(np.uint8),
        fixed[:, 7],
        lengths,
        tracks.reshape(-1, 2),
        rows.where,
    )


def _as_integers(path: Path, values: NDArray[np.float64], minimum: int, where, what: str) -> NDArray[np.int64]:
    wrong = np.flatnonzero(~((values >= minimum) & (values <= _MAX_EXACT_INTEGER) & (values == np.floor(values))))
    if len(wrong):
        i = int(wrong[0])
        raise FileError(path, f"{what}: expected a whole number >= {minimum}, got {values[i]:g}", where=where(i))
    return values.astype(np.int64)


def _body(path: Path) -> bytes:
    if path.is_file() and path.stat().st_size == 0:
        return b""
    return bytes(open_source(path)[:]).removeprefix(b"\xef\xbb\xbf")


def _lines(path: Path) -> Iterator[tuple[int, str]]:
    body = _body(path)
    try:
        text = body.decode()
    except UnicodeDecodeError as error:
        raise FileError(path, "not a text file", where=f"byte {error.start}") from error
    lines = re.split("\r\n|\n|\r", text)
    if not lines[-1]:
        lines.pop()
    return iter(enumerate(lines, 1))


def _integer(path: Path, where: str, word: str) -> int:
    if not (word.isascii() and word.isdigit() and len(word) < 19):
        raise FileError(path, f"expected a whole number, got {word[:40]!r}", where=where)
    return int(word)


def _real(path: Path, where: str, word: str) -> float:
    try:
        if "_" not in word:
            return float(word)
    except ValueError:
        pass
    raise FileError(path, f"not a number: {word[:40]!r}", where=where)


def count_images(path: Path) -> int:
    return len(read_images(path))


def write_cameras(file: IO[bytes], records: Records) -> None:
    lines = ["# Cameras, one a line: CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]"]
    for number, camera in enumerate(records.cameras, 1):
        lines.append(f"{number} {camera.model} {camera.width} {camera.height} {' '.join(map(repr, camera.params))}")
    file.write(("\n".join(lines) + "\n").encode())


def write_images(file: IO[bytes], records: Records) -> None:
    model = records.model
    file.write(b"# Images, two lines each: IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n")
    file.write(b"#   POINTS2D[] as (X, Y, POINT3D_ID)\n")
    for i, name in enumerate(model.names):
        begin, end = records.starts[i], records.starts[i + 1]
        pose = (*records.quaternions[i].tolist(), *model.T_camera_world[i, :3, 3].tolist())
        file.write(f"{i + 1} {' '.join(map(repr, pose))} {records.camera_numbers[i]} {name}\n".encode())
        points = (model.observations[begin:end, 1] + 1).tolist()
        pixels = records.keypoints[begin:end].tolist()
        file.write(" ".join([f"{x!r} {y!r} {n}" for (x, y), n in zip(pixels, points, strict=True)]).encode() + b"\n")


def write_points(file: IO[bytes], records: Records) -> None:
    model = records.model
    file.write(b"# Points, one a line: POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)\n")
    for begin in range(0, len(model.points), _ROWS_PER_BLOCK):
        end = min(begin + _ROWS_PER_BLOCK, len(model.points))
        first = records.track_starts[begin]
        steps = [f"{a} {b}" for a, b in records.tracks[first : records.track_starts[end]].tolist()]
        starts = (records.track_starts[begin : end + 1] - first).tolist()
        columns = zip(
            model.points[begin:end].tolist(),
            model.colors[begin:end].tolist(),
            records.errors[begin:end].tolist(),
            strict=True,
        )
        lines = []
        for i, ((x, y, z), (r, g, b), error) in enumerate(columns):
            track = " ".join(steps[starts[i] : starts[i + 1]])
            lines.append(f"{begin + i + 1} {x!r} {y!r} {z!r} {r} {g} {b} {error!r} {track}".rstrip() + "\n")
        file.write("".join(lines).encode())
