"""Poses in text files; inf and NaN mark lost poses."""

from __future__ import annotations

import math
import os
import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_rigid
from ..core.errors import FileError
from ..core.paths import input_path
from ..core.quaternions import quaternions_to_rotations
from .camera import LARGEST_NUMBER

# Open3D (0.20) ends this comment without a line break, so the first pose of its TUM files follows on the same line.
_OPEN3D_TUM_HEADER = "# TUM trajectory, format: <t> <x> <y> <z> <qx> <qy> <qz> <qw>"

# Maximum deviation of a quaternion's length from 1: 4 decimals leave 1e-4. More is not a rotation.
_QUATERNION_TOLERANCE = 1e-2

_NS_DIGITS = 16  # of nanoseconds since 1970: shorter numbers may be in other units, unless the header has [ns]

_OF_C = re.compile(r"[-+]?(nan\(\w*\)|1\.#\w+)", re.I)  # NaN and infinity as printed by C runtimes

LOST = "inf and NaN mark a pose that was lost in tracking: pass skip_missing=True to skip it"

Line = tuple[int, list[str]]


def read_pose(path: str | os.PathLike[str]) -> NDArray[np.float64]:
    """Read one 4x4 pose. Raises `FileError` if it is not rigid."""
    return _read_pose(path, gaps=False)


def read_pose_or_gap(path: str | os.PathLike[str]) -> NDArray[np.float64] | None:
    """`read_pose`, or None if the pose is lost."""
    return pose_or_gap(_read_pose(path, gaps=True))


def pose_or_gap(pose: NDArray[np.float64]) -> NDArray[np.float64] | None:
    return None if np.isnan(pose).any() else pose


def _read_pose(path: str | os.PathLike[str], *, gaps: bool) -> NDArray[np.float64]:
    lines = read_lines(path)
    if len(lines) != 4:
        raise FileError(path, f"expected 4 rows of a pose, got {len(lines)}")
    return _matrix(path, [_parse(path, line, 4, gaps=gaps) for line in lines], lines[0][0])


def read_lines(path: str | os.PathLike[str], comments: list[str] | None = None) -> list[Line]:
    """Lines that are neither blank nor comments, as (line number, columns). `comments` receives the comments."""
    try:
        text = input_path(path).read_bytes().decode("utf-8-sig")
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    except UnicodeDecodeError as error:
        raise FileError(path, "not a text file", where=f"byte {error.start}") from error
    lines = []
    for number, line in enumerate(text.replace("\r\n", "\n").replace("\r", "\n").split("\n"), 1):
        if line.startswith(_OPEN3D_TUM_HEADER):
            line = line[len(_OPEN3D_TUM_HEADER) :]
        columns = re.split(r"[ \t\v\f]+", line.strip(" \t\v\f")) if line.strip(" \t\v\f") else []
        if columns and not columns[0].startswith("#"):
            lines.append((number, columns))
        elif columns and comments is not None:
            comments.append(line.strip())
    return lines


def parse_floats(path: str | os.PathLike[str], line: Line, count: int) -> list[float]:
    values = _numbers(path, line, count)
    if not all(map(math.isfinite, values)):
        raise FileError(path, "expected finite numbers", where=f"line {line[0]}")
    return values


def _parse(path: str | os.PathLike[str], line: Line, count: int, *, gaps: bool) -> list[float]:
    values = _numbers(path, line, count)
    if not gaps and not all(map(math.isfinite, values)):
        raise FileError(path, "expected finite numbers", where=f"line {line[0]}", remedy=LOST)
    return values


def _numbers(path: str | os.PathLike[str], line: Line, count: int) -> list[float]:
    number, columns = line
    if len(columns) != count:
        raise FileError(path, f"expected {count} numbers, got {len(columns)} columns", where=f"line {number}")
    try:
        values = [math.nan if _OF_C.fullmatch(column) else float(column) for column in columns]
    except ValueError as error:
        raise FileError(path, f"not a number: {error}"[:200], where=f"line {number}") from error
    words = "".join(columns)
    if "_" in words or not words.isascii() or any(LARGEST_NUMBER <= abs(value) < math.inf for value in values):
        raise FileError(path, "expected finite numbers", where=f"line {number}")
    return values


def _matrix(path: str | os.PathLike[str], rows: Any, line: int) -> NDArray[np.float64]:
    if not np.isfinite(rows).all():
        return np.full((4, 4), np.nan)
    return check_pose(path, rows, f"line {line}")


def check_pose(path: str | os.PathLike[str], rows: object, where: str) -> NDArray[np.float64]:
    try:
        return check_rigid("pose", rows)
    except ValueError as error:
        raise FileError(path, str(error), where=where) from error


def log_poses(
    path: str | os.PathLike[str], lines: list[Line], *, gaps: bool
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Poses and numbers of a .log file. Lost poses are NaN, or an error without `gaps`."""
    if len(lines) % 5:
        reason = f"ends within a pose: {len(lines)} lines, expected 5 per pose"
        raise FileError(path, reason, where=f"line {lines[-1][0]}", remedy="The file may be truncated")
    poses, ids = [], []
    for start in range(0, len(lines), 5):
        ids.append(_parse_ids(path, lines[start]))
        rows = [_parse(path, line, 4, gaps=gaps) for line in lines[start + 1 : start + 5]]
        poses.append(_matrix(path, rows, lines[start + 1][0]))
    return np.array(poses), np.array(ids, np.int64)


def _parse_ids(path: str | os.PathLike[str], line: Line) -> list[int]:
    number, columns = line
    try:
        ids = [int(column) for column in columns if column.isascii() and "_" not in column]
    except ValueError:
        ids = []
    if len(ids) != 3 or any(abs(i) >= 2**63 for i in ids):
        reason = f"expected three integers before a pose, got {' '.join(columns)[:60]!r}"
        raise FileError(path, reason, where=f"line {number}")
    return ids


def timed_poses(
    path: str | os.PathLike[str], lines: list[Line], *, gaps: bool
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Poses and times of TUM lines. Lost poses are NaN, or an error without `gaps`."""
    for number, columns in lines:
        parse_floats(path, (number, columns[:1]), 1)
    table = np.array([_parse(path, line, 8, gaps=gaps) for line in lines])
    table[~np.isfinite(table).all(axis=1), 1:] = np.nan
    quaternions = table[:, 4:]
    lengths = np.linalg.norm(quaternions, axis=1)
    wrong = np.flatnonzero(np.abs(lengths - 1) > _QUATERNION_TOLERANCE)
    if len(wrong):
        row = wrong[0]
        raise FileError(
            path,
            f"expected a unit quaternion qx qy qz qw, got {quaternions[row].tolist()} of length {lengths[row]:.4g}",
            where=f"line {lines[row][0]}",
        )
    poses = np.tile(np.eye(4), (len(table), 1, 1))
    poses[:, :3, :3] = quaternions_to_rotations(quaternions / lengths[:, None])
    poses[:, :3, 3] = table[:, 1:4]
    poses[np.isnan(lengths)] = np.nan
    return poses, table[:, 0].copy()


def euroc_lines(path: str | os.PathLike[str], lines: list[Line], comments: list[str]) -> list[Line]:
    """Lines of EuRoC, `timestamp [ns], x, y, z, qw, qx, qy, qz`, as those of TUM. Other columns are left out."""
    cells = [(number, [cell.strip() for cell in " ".join(columns).split(",")]) for number, columns in lines]
    heads = [row for row in (comment.lstrip("# ").split(",") for comment in comments) if len(row) > 1]
    if cells and not cells[0][1][0][:1].isdigit():
        heads.append(cells.pop(0)[1])
    expected = "the columns timestamp [ns], x, y, z, qw, qx, qy, qz"
    for head in heads[-1:]:
        names = [name.partition("[")[0].strip().lower() for name in head]
        if len(names) < 8 or [name[-1:] for name in names[1:8]] != list("xyzwxyz"):
            remedy = "Reorder the columns, or name a file of TUM's columns .tum"
            raise FileError(path, f"expected {expected}, got {', '.join(names[:8])[:200]}", remedy=remedy)
    is_marked, found = any("[ns]" in head[0] for head in heads[-1:]), []
    for number, row in cells:
        is_in_ns = row[0].isdecimal() and (len(row[0]) >= _NS_DIGITS or is_marked)
        if len(row) < 8 or not is_in_ns:
            given = f"{len(row)} columns and the timestamp {row[0][:40]!r}"
            raise FileError(path, f"expected {expected}, got {given}", where=f"line {number}")
        seconds, fraction = divmod(int(row[0][:40]), 10**9)
        found.append((number, [f"{seconds}.{fraction:09d}", *row[1:4], *row[5:8], row[4]]))
    return found


def kitti_poses(path: str | os.PathLike[str], lines: list[Line], *, gaps: bool) -> NDArray[np.float64]:
    """Poses of lines of 12 numbers. Lost poses are NaN, or an error without `gaps`."""
    poses = []
    for line in lines:
        values = _parse(path, line, 12, gaps=gaps)
        poses.append(_matrix(path, [values[:4], values[4:8], values[8:], [0.0, 0.0, 0.0, 1.0]], line[0]))
    return np.array(poses)
