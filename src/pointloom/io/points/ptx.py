"""PTX: Leica's text format of scans.

A scan has numbers of columns and rows; scanner position and axes. A 4x4 matrix for row vectors (T_world_scan); and a
line per direction, column by column: x y z intensity [r g b] [m, 0..255]. Directions without a return ("0 0 0") are
dropped; `row_index` and `column_index` identify the others.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_rigid
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.quaternions import nearest_rotations
from ...core.units import METRE
from ..ascii_rows import AsciiRows, is_number, unix_lines
from ..columns import stack_colors
from ..source import Source, open_source, parse_count
from ..table import PointTable
from .e57 import SCAN_INDEX, ScanFrame, merge_scans, with_points

_HEADER_LINES = 10
_NO_POSE = np.vstack([np.zeros(3), np.eye(3)])  # position and axes
_SAME_POSE = 1e-3  # [m], and relative: more than the three decimals that programs write
_VALUES_PER_LINE = (4, 7)
_LINES_PER_BLOCK = 1 << 18  # lines parsed at a time
_BYTES_PER_SEARCH = 1 << 24  # bytes in which line ends are found at a time


@dataclass(frozen=True, eq=False)
class _Scan:
    """The header of a scan: `shape` (columns, rows), `pose` T_world_scan (4, 4), `first` point line (from 0)."""

    shape: tuple[int, int]
    pose: NDArray[np.float64]
    first: int


class _Lines:
    def __init__(self, path: Path, source: Source):
        self.path = path
        self._body: Source = source if source.find(b"\n") >= 0 else unix_lines(bytes(source[:]))
        begins = range(0, len(self._body), _BYTES_PER_SEARCH)
        newlines = [np.flatnonzero(_bytes_of(self._body, begin) == ord("\n")) + begin for begin in begins]
        ends = np.concatenate(newlines)
        is_open = not len(ends) or ends[-1] + 1 < len(self._body)
        self._ends = np.append(ends, len(self._body)) if is_open else ends
        self.count = len(self._ends)

    def text(self, begin: int, end: int) -> bytes:
        first = int(self._ends[begin - 1]) + 1 if begin else 0
        return bytes(self._body[first : int(self._ends[end - 1])]) if end > begin else b""

    def integer(self, line: int, what: str) -> int:
        text = self.text(line, line + 1).strip().decode("ascii", "backslashreplace")
        return parse_count(self.path, text, what, line + 1)

    def numbers(self, line: int, width: int, what: str) -> list[float]:
        words = self.text(line, line + 1).split()
        values = [float(word) for word in words] if all(map(is_number, words)) else []
        if len(values) != width or not np.isfinite(values).all():
            shown = b" ".join(words)[:60].decode("ascii", "backslashreplace")
            reason = f"{what}: expected {width} finite numbers, got {shown!r}"
            raise FileError(self.path, reason, where=f"line {line + 1}")
        return values

    def rows(self, begin: int, end: int) -> AsciiRows:
        """Lines `begin` to `end` as rows of numbers. None may be blank."""
        rows = AsciiRows(self.path, self.text(begin, end), begin + 1)
        if rows.row_count != end - begin:
            reason = f"{rows.row_count} of {end - begin} lines of points have values"
            raise FileError(self.path, reason, where=f"lines {begin + 1} to {end}", remedy="Remove the blank lines")
        return rows


def _bytes_of(body: Source, begin: int) -> NDArray[np.uint8]:
    return np.frombuffer(body[begin : begin + _BYTES_PER_SEARCH], np.uint8)


def read_ptx(path: FilePath, *, scan: int | None = None) -> PointTable:
    """Read the points of a PTX file in world coordinates. All scans (with `scan_index`) if `scan` is None.
    Needs memory for the result and twice the largest scan."""
    if scan is not None:
        lines, scans = _open(path)
        if not 0 <= scan < len(scans):
            raise IndexError(f"scan: expected 0..{len(scans) - 1}, got {scan}")
        return _in_world(_read_scan(lines, scans[scan]), scans[scan].pose)
    return merge_scans(path, with_points([*iterate_world_scans(path)]))


def iterate_ptx(path: FilePath) -> Iterator[tuple[PointTable, NDArray[np.float64]]]:
    """Yield the points of each scan in scanner coordinates, with the pose T_world_scan."""
    lines, scans = _open(path)
    for scan in scans:
        yield _read_scan(lines, scan), scan.pose


def iterate_world_scans(path: FilePath) -> Iterator[PointTable]:
    """Yield the points of each scan in world coordinates, with `scan_index`."""
    for number, (table, pose) in enumerate(iterate_ptx(path)):
        table.attributes[SCAN_INDEX] = np.full(len(table.points), number, np.int32)
        yield _in_world(table, pose)


def read_ptx_frames(path: FilePath) -> list[ScanFrame]:
    """The pose of each scan. PTX has no names."""
    return [ScanFrame("", scan.pose) for scan in _open(path)[1]]


def describe_ptx(path: FilePath) -> list[dict[str, Any]]:
    """Name, point count and position [m] of each scan, as `describe_e57`."""
    scans = iterate_ptx(path)
    return [{"name": "", "points": len(table.points), "position": pose[:3, 3].tolist()} for table, pose in scans]


def _open(path: FilePath) -> tuple[_Lines, list[_Scan]]:
    """The lines of a file and its scan headers, checked against the number of lines."""
    lines, scans, at = _Lines(Path(path), open_source(path)), [], 0
    while at < lines.count:
        if not lines.text(at, at + 1).strip():
            at += 1
            continue
        scans.append(_read_header(lines, at))
        columns, rows = scans[-1].shape
        at = scans[-1].first + columns * rows
    if not scans:
        raise FileError(path, "contains no scan of points")
    return lines, scans


def _read_header(lines: _Lines, at: int) -> _Scan:
    columns = lines.integer(at, "the number of columns of a scan")
    if lines.count - at < _HEADER_LINES:
        reason = f"truncated: the header of a scan has {lines.count - at} of {_HEADER_LINES} lines"
        raise FileError(lines.path, reason, where=f"line {lines.count}")
    rows = lines.integer(at + 1, "the number of rows of a scan")
    titles = ("position of the scanner", "X axis", "Y axis", "Z axis")
    scanner = np.array([lines.numbers(at + 2 + k, 3, what) for k, what in enumerate(titles)])
    matrix = np.array([lines.numbers(at + 6 + k, 4, "matrix of the scan") for k in range(4)])
    try:
        pose = check_rigid("matrix of the scan", matrix.T)
    except ValueError as error:
        raise FileError(lines.path, str(error), where=f"lines {at + 7} to {at + 10}") from error
    pose = pose.copy()
    pose[:3, :3], pose[3] = nearest_rotations(pose[None, :3, :3])[0], (0, 0, 0, 1)
    _compare_poses(lines.path, at, scanner, pose)
    left = lines.count - at - _HEADER_LINES
    if columns * rows > left:
        expected = f"{columns} x {rows} = {columns * rows} lines of points"
        reason = f"truncated: expected {expected} of a scan, got {left}"
        raise FileError(lines.path, reason, where=f"line {at + 1}", remedy="It was cut off, or the numbers are wrong")
    return _Scan((columns, rows), pose, at + _HEADER_LINES)


def _compare_poses(path: Path, at: int, scanner: NDArray[np.float64], pose: NDArray[np.float64]) -> None:
    """Warn if the header of a scan gives the scanner two poses, unless the first is that of a file without one."""
    if np.array_equal(scanner, _NO_POSE):
        return
    by_matrix = np.vstack([pose[:3, 3], pose[:3, :3].T])
    if not np.allclose(scanner, by_matrix, rtol=_SAME_POSE, atol=_SAME_POSE):
        given, used = (" ".join(f"{value:.6g}" for value in rows[0]) for rows in (scanner, by_matrix))
        message = (
            f"{path} (line {at + 3}): the scanner is at {given} by its position and axes, and at {used} by the matrix. "
            "The matrix is used."
        )
        warnings.warn(escaped(message), UserWarning, stacklevel=5)


def _read_scan(lines: _Lines, scan: _Scan) -> PointTable:
    count, width = scan.shape[0] * scan.shape[1], 0
    indices, parts = [np.empty(0, np.int64)], [np.empty((0, 4))]
    for begin in range(scan.first, scan.first + count, _LINES_PER_BLOCK):
        end = min(begin + _LINES_PER_BLOCK, scan.first + count)
        rows = lines.rows(begin, end)
        if not width:
            width = int(rows.widths()[0])
            if width not in _VALUES_PER_LINE:
                reason = f"expected 4 or 7 values (x y z intensity, then r g b), got {width}"
                raise FileError(lines.path, reason, where=rows.where(0), remedy="Check the number of rows and columns")
            parts = [np.empty((0, width))]
        rows.check_width(0, rows.row_count, width)
        values = rows.numbers().reshape(-1, width)
        for column in values[:, 4:].T:
            rows.cast(column, np.dtype(np.uint8), "color", 0)
        there = np.flatnonzero(np.isfinite(values[:, :3]).all(axis=1) & (values[:, :3] != 0).any(axis=1))
        indices.append(there + (begin - scan.first))
        parts.append(values[there])
    table, index = np.concatenate(parts), np.concatenate(indices)
    colors = stack_colors(lines.path, [*table[:, 4:].astype(np.uint8).T]) if width == 7 else None
    column_index, row_index = np.divmod(index, max(scan.shape[1], 1))
    attributes = {
        "intensity": table[:, 3].copy(),
        "row_index": row_index.astype(np.int32),
        "column_index": column_index.astype(np.int32),
    }
    return PointTable(np.ascontiguousarray(table[:, :3]), None, colors, attributes, unit=METRE)


def _in_world(table: PointTable, pose: NDArray[np.float64]) -> PointTable:
    table.points = table.points @ pose[:3, :3].T + pose[:3, 3]
    return table
