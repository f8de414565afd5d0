"""OFF, text: vertices, with normals (NOFF), colours (COFF) and texture coordinates (STOFF), and faces of any size.

Read are the headers [ST][C][N]OFF, with the counts behind them in the same line or in the next, and comments from # on.
Colours are 0..255 where one of the file's is above 1, else 0..1; an alpha is left behind, and so are colours of faces.
Written are the counts of edges as 0, colours as 0..255 with an alpha of 255, as Open3D has them. Not held: texture
coordinates, since those of a mesh belong to corners (refused), and attributes (refused). Binary OFF and the spaces of
other dimensions (4OFF, nOFF) are refused.

Source: Geomview, "OFF Files".
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.coordinates import quiet
from ...core.errors import FileError
from ..ascii_rows import AsciiRows, row_format, write_rows
from ..columns import colors_to_bytes, stack_colors, stack_normals
from ..fans import fan_corners
from ..source import open_source
from ..table import MeshTable

_COMMENT = re.compile(rb"#[^\n]*")
_HEAD = re.compile(rb"\s*(ST)?(C)?(N)?(4)?(n)?OFF(?=[\s\d]|$)([ \t]+BINARY)?")


def read_off(path: str | os.PathLike[str]) -> MeshTable:
    """Read a triangle mesh from OFF.

    Returns:
        The mesh with float64 vertices; a face of more than three corners becomes the fan around its first.

    Raises:
        FileError: Missing, another header, fewer or more lines than the counts say, a line with another number of
            values, a colour out of its range, a face of fewer than three corners or with one that is no vertex; says
            the line or face.
    """
    path = Path(path)
    body = bytes(open_source(path)[:]).replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    body = _COMMENT.sub(b"", body)
    head = _HEAD.match(body)
    if head is None:
        raise FileError(path, "is no OFF: it does not begin with OFF, or a letter for what vertices have and OFF")
    textured, colored, with_normals, fourth, other, binary = (part is not None for part in head.groups())
    if fourth or other or binary:
        what = "binary OFF" if binary else "OFF of another dimension"
        raise FileError(path, f"{what} is not read", where="line 1", remedy="Convert it to .ply")
    blanks = re.sub(rb"[^\n]", b" ", body[: head.end()])
    rows = AsciiRows(path, blanks + body[head.end() :], 1)
    if not rows.row_count:
        raise FileError(path, "truncated: it has no counts", where=rows.where(0))
    rows.check_width(0, 1, 3)
    values = rows.numbers()
    vertex_count, face_count = (int(x) for x in rows.cast(values[:3], np.dtype(np.uint32), "a count", 0)[:2])
    _check_row_count(path, rows, vertex_count, face_count)
    width = _vertex_width(path, rows, vertex_count, 3 + 3 * with_normals + 2 * textured, colored)
    table = values[3 : 3 + vertex_count * width].reshape(-1, width)
    columns = [*table.T]
    normals = stack_normals(path, columns[3:6]) if with_normals else None
    at = 6 if with_normals else 3
    colors = _colors_of(path, rows, columns[at : at + 3]) if colored else None
    triangles = _triangles_of(path, rows, values, vertex_count, face_count)
    mesh = MeshTable(np.ascontiguousarray(table[:, :3]), triangles, normals, colors)
    if textured:
        with quiet():
            mesh.triangle_uvs = table[:, -2:].astype(np.float32)[triangles.reshape(-1)]
    return mesh.checked()


def _check_row_count(path: Path, rows: AsciiRows, vertex_count: int, face_count: int) -> None:
    expected = 1 + vertex_count + face_count
    if rows.row_count < expected:
        reason = f"truncated: {rows.row_count - 1} lines for {vertex_count} vertices and {face_count} faces"
        raise FileError(path, reason, where=rows.where(rows.row_count))
    if rows.row_count > expected:
        reason = f"{rows.row_count - expected} lines follow the {vertex_count} vertices and {face_count} faces"
        raise FileError(path, reason, where=rows.where(expected))


def _vertex_width(path: Path, rows: AsciiRows, count: int, bare: int, colored: bool) -> int:
    """Values of a vertex: `bare` and, with colours, three or four more, the same for all."""
    allowed = (bare + 3, bare + 4) if colored else (bare,)
    width = int(rows.widths()[1]) if count else allowed[0]
    if width not in allowed:
        expected = " or ".join(map(str, allowed))
        raise FileError(path, f"a vertex has {expected} values, found {width}", where=rows.where(1))
    rows.check_width(1, 1 + count, width)
    return width


def _colors_of(path: Path, rows: AsciiRows, channels: list[NDArray[np.float64]]) -> NDArray[np.float32]:
    if any((channel > 1).any() for channel in channels):
        return stack_colors(path, [rows.cast(channel, np.dtype(np.uint8), "a colour", 1) for channel in channels])
    return stack_colors(path, channels)


def _triangles_of(
    path: Path, rows: AsciiRows, values: NDArray[np.float64], vertex_count: int, face_count: int
) -> NDArray[np.int64]:
    begin = 1 + vertex_count
    first, widths = rows.first[begin:-1], rows.widths()[begin:]
    lengths = rows.cast(values[first], np.dtype(np.uint32), "the corners of a face", begin).astype(np.int64)
    extra = widths - 1 - lengths
    wrong = np.flatnonzero(~np.isin(extra, (0, 1, 3, 4)))
    if len(wrong):
        row = int(wrong[0])
        reason = f"a face of {lengths[row]} corners has {widths[row] - 1} values behind their number"
        raise FileError(path, reason, where=rows.where(begin + row), remedy="Behind corners stand 0, 1, 3 or 4 values")
    fans = fan_corners(path, lengths)
    within = np.arange(lengths.sum()) - np.repeat(np.cumsum(lengths) - lengths, lengths)
    corners = values[np.repeat(first + 1, lengths) + within]
    row_of = np.repeat(np.arange(begin, begin + face_count), lengths)
    corners = rows.cast(corners, np.dtype(np.uint32), "a corner", row_of).astype(np.int64)
    bad = np.flatnonzero(corners >= vertex_count)
    if len(bad):
        reason = f"a face names vertex {corners[bad[0]]}, but there are {vertex_count} vertices"
        raise FileError(path, reason, where=rows.where(int(row_of[bad[0]])))
    return corners[fans]


def write_off(path: str | os.PathLike[str], mesh: MeshTable, *, overwrite: bool = True) -> None:
    """Write a triangle mesh as OFF.

    Args:
        path: The file; it appears whole or not at all.
        mesh: The mesh; colours are rounded to 8 bits.
        overwrite: Whether an existing file may be replaced.

    Raises:
        FileError: The place cannot be written, or the mesh has attributes, texture coordinates, or a value that is not
            finite.
        ValueError: An array of the mesh has the wrong shape, or a triangle names a missing vertex.
    """
    path = check_writable(path, overwrite=overwrite)
    mesh = mesh.checked()
    lost = [*mesh.attributes, *(["triangle_uvs"] if mesh.triangle_uvs is not None else [])]
    if lost:
        raise FileError(path, f"OFF cannot hold {', '.join(lost)}", remedy="Write .ply, or drop them first")
    columns: list[NDArray[Any]] = [*mesh.vertices.T]
    if mesh.vertex_normals is not None:
        columns += [*mesh.vertex_normals.T]
    if not all(np.isfinite(column).all() for column in columns):
        raise FileError(path, "vertices, vertex_normals: OFF cannot hold NaN or infinite values")
    if mesh.vertex_colors is not None:
        columns += [*colors_to_bytes(path, mesh.vertex_colors).T]
        columns.append(np.full(len(mesh.vertices), 255, np.uint8))
    kind = "C" * (mesh.vertex_colors is not None) + "N" * (mesh.vertex_normals is not None)
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(f"{kind}OFF\n{len(mesh.vertices)} {len(mesh.triangles)} 0\n".encode("ascii"))
        write_rows(file, columns)
        triangles = [*mesh.triangles.T]
        write_rows(file, triangles, line="3 " + row_format(triangles))
