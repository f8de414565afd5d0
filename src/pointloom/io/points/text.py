"""Points as plain text: XYZ, XYZN, XYZRGB and PTS, separated by blanks; conventions of Open3D's documentation.

XYZ may have other separators and named columns (text_table.py). PTS starts with the number of points. Rows are x y z
[intensity] [r g b] with colors 0..255. Writing is lossless, except 8-bit colors of PTS. Unsupported content raises.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.errors import FileError, FilePath
from ...core.units import warn_of_units
from ..ascii_rows import AsciiRows, is_number, unix_lines, write_rows
from ..columns import colors_to_bytes, stack_colors, stack_normals
from ..source import open_source, parse_count
from ..table import PointTable
from .text_table import read_text_table

#: Values per line by extension. PTS has one of several.
_VALUES_PER_LINE = {".xyz": (3,), ".xyzn": (6,), ".xyzrgb": (6,), ".pts": (3, 4, 6, 7)}

_COMMENT = re.compile(rb"^[ \t]*#[^\n]*", re.M)


def read_text(path: FilePath) -> PointTable:
    path = Path(path)
    kind = _kind(path)
    if kind == ".xyz":
        return read_text_table(path)
    body = unix_lines(bytes(open_source(path)[:]))
    if kind == ".pts":
        return _read_pts(path, body)
    if b"#" in body:
        body = _COMMENT.sub(b"", body)
    rows = AsciiRows(path, body, 1, is_table=True)
    (width,) = _VALUES_PER_LINE[kind]
    rows.check_width(0, rows.row_count, width)
    if not rows.row_count:
        raise FileError(path, "contains no points")
    table = rows.numbers().reshape(-1, width)
    points, extra = np.ascontiguousarray(table[:, :3]), [*table[:, 3:].T]
    if kind == ".xyzn":
        return PointTable(points, normals=stack_normals(path, extra))
    return PointTable(points, colors=stack_colors(path, extra))


def write_text(path: FilePath, table: PointTable, *, overwrite: bool = True) -> None:
    """Write an .xyz, .xyzn, .xyzrgb or .pts file atomically. Raises if the format cannot store the table."""
    path = check_writable(path, overwrite=overwrite)
    kind = _kind(path)
    table = table.checked()
    columns = _columns(path, kind, table)
    with atomic_write(path, overwrite=overwrite) as file:
        if kind == ".pts":
            file.write(f"{len(table.points)}\n".encode("ascii"))
        write_rows(file, columns)


def _kind(path: Path) -> str:
    kind = path.suffix.lower()
    if kind not in _VALUES_PER_LINE:
        raise FileError(path, f"{path.suffix!r} is not one of {', '.join(_VALUES_PER_LINE)}")
    return kind


def _read_pts(path: Path, body: bytes) -> PointTable:
    first, _, rest = body.partition(b"\n")
    declared = pts_count(path, first)
    rows = AsciiRows(path, body if declared is None else rest, 1 if declared is None else 2, is_table=True)
    count = rows.row_count if declared is None else declared
    if rows.row_count < count:
        raise FileError(path, f"truncated: {rows.row_count} of {count} points", where=rows.where(rows.row_count))
    if rows.row_count > count:
        raise FileError(
            path, f"{rows.row_count - count} lines follow the declared {count} points", where=rows.where(count)
        )
    if not count:
        return PointTable(np.empty((0, 3)))
    width = int(rows.widths()[0])
    if width not in _VALUES_PER_LINE[".pts"]:
        raise FileError(path, f"expected 3, 4, 6 or 7 values, got {width}", where=rows.where(0))
    rows.check_width(0, count, width)
    table = rows.numbers().reshape(count, width)
    colors = None
    if width >= 6:
        channels = [rows.cast(column, np.dtype(np.uint8), "color", 0) for column in table[:, -3:].T]
        colors = stack_colors(path, channels)
    attributes = {"intensity": table[:, 3].copy()} if width in (4, 7) else {}
    return PointTable(np.ascontiguousarray(table[:, :3]), None, colors, attributes)


def pts_count(path: FilePath, first: bytes) -> int | None:
    """The number of points in the first line of a PTS file. None, with a warning, if it is a point."""
    words = first.split()
    if len(words) in _VALUES_PER_LINE[".pts"] and all(map(is_number, words)):
        warn_of_units(f"{path}: has no number of points in its first line; all its lines are read", UserWarning)
        return None
    return parse_count(path, first.strip().decode("ascii", "backslashreplace"), "the number of points", 1)


def _columns(path: Path, kind: str, table: PointTable) -> list[NDArray[Any]]:
    attributes = dict(table.attributes)
    columns = [*table.points.T]
    if kind == ".pts" and "intensity" in attributes and attributes["intensity"].ndim == 1:
        columns.append(attributes.pop("intensity"))
    lost = [f"the attribute {name!r}" for name in attributes]
    for name, values, holders in (
        ("normals", table.normals, (".xyzn",)),
        ("colors", table.colors, (".xyzrgb", ".pts")),
    ):
        if values is None:
            if kind in holders and kind != ".pts":
                raise FileError(path, f"{kind} needs {name}, but the cloud has none", remedy="Write .xyz or .ply")
        elif kind not in holders:
            lost.append(name)
        elif kind == ".pts":
            columns += [*colors_to_bytes(path, values).T]
        else:
            columns += [*values.T]
    if lost:
        remedy = "Write .csv or .ply, which store them all, or pass drop_unsupported=True"
        raise FileError(path, f"{kind} cannot store {', '.join(lost)}", remedy=remedy)
    if not len(table.points) and kind != ".pts":
        raise FileError(
            path, f"{kind} cannot distinguish a cloud without points from an empty file", remedy="Write .ply"
        )
    return columns
