"""OFF text files: vertices with normals (NOFF), colors (COFF) and texture coordinates (STOFF), and polygons.

Colors are 0..255 if one is above 2, or all are integers and one is above 1. Else 0..1. Vertex alpha becomes the
attribute `alpha` if not opaque, face colors the triangle attribute `colors` if complete. Palette indices are dropped.
Geomview, "OFF Files".
"""

from __future__ import annotations

import re
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.coordinates import quiet
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ..ascii_rows import AsciiRows, row_format, unix_lines, write_rows
from ..columns import check_extent, color_scale, colors_to_bytes, fit_colors, stack_normals, warn_left_out, warn_of_loss
from ..source import open_source
from ..table import MeshTable
from ..triangulation import split_faces, triangle_counts

_COMMENT = re.compile(rb"#[^\n]*")
_HEAD = re.compile(rb"\s*(ST)?(C)?(N)?(4)?(n)?OFF(?=[\s\d]|$)([ \t]+BINARY)?")


def read_off(path: FilePath) -> MeshTable:
    """Read a triangle mesh from OFF, with float64 vertices. Polygons are triangulated."""
    path = Path(path)
    body = unix_lines(bytes(open_source(path)[:]))
    body = _COMMENT.sub(b"", body)
    head = _HEAD.match(body)
    if head is None:
        raise FileError(
            path, "is not an OFF file: it does not begin with OFF, or with letters for the vertex data and OFF"
        )
    textured, colored, with_normals, fourth, other, binary = (part is not None for part in head.groups())
    if fourth or other or binary:
        what = "binary OFF" if binary else "OFF of another dimension"
        raise FileError(path, f"{what} is not supported", where="line 1", remedy="Convert it to .ply")
    blanks = re.sub(rb"[^\n]", b" ", body[: head.end()])
    rows = AsciiRows(path, blanks + body[head.end() :], 1)
    if not rows.row_count:
        raise FileError(path, "truncated: it has no counts", where=rows.where(0))
    rows.check_width(0, 1, 3)
    values = rows.numbers()
    vertex_count, face_count = (int(x) for x in rows.cast(values[:3], np.dtype(np.uint32), "a count", 0)[:2])
    _check_row_count(path, rows, vertex_count, face_count)
    if not face_count:
        raise FileError(path, "contains no faces", remedy="Read the vertices as a cloud: convert them to .xyz first")
    width = _vertex_width(path, rows, vertex_count, 3 + 3 * with_normals + 2 * textured, colored)
    table = values[3 : 3 + vertex_count * width].reshape(-1, width)
    columns = [*table.T]
    normals = stack_normals(path, columns[3:6]) if with_normals else None
    at = 6 if with_normals else 3
    colors, attributes = _vertex_colors(path, columns[at : at + width - at - 2 * textured]) if colored else (None, {})
    vertices = np.ascontiguousarray(table[:, :3])
    check_extent(path, vertices)
    corners, lengths, face_colors = _faces_of(path, rows, values, len(vertices))
    triangles = corners[split_faces(path, lengths, corners, vertices)]
    mesh = MeshTable(vertices, triangles, normals, colors, attributes)
    if face_colors is not None:
        mesh.triangle_attributes = {"colors": np.repeat(face_colors, triangle_counts(lengths), axis=0)}
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
    """Values per vertex: `bare`, plus 3 or 4 with colors."""
    allowed = (bare + 3, bare + 4) if colored else (bare,)
    width = int(rows.widths()[1]) if count else allowed[0]
    if width not in allowed:
        expected = " or ".join(map(str, allowed))
        raise FileError(path, f"a vertex has {expected} values, got {width}", where=rows.where(1))
    rows.check_width(1, 1 + count, width)
    return width


def _vertex_colors(
    path: Path, channels: list[NDArray[np.float64]]
) -> tuple[NDArray[np.float32] | None, dict[str, NDArray[Any]]]:
    """Colors, and the alpha attribute if not opaque."""
    full = color_scale(channels[:3])
    colors = _fit(path, channels[:3], full, "colors")
    if colors is None or len(channels) < 4 or (channels[3] == full).all():
        return colors, {}
    alpha = _fit(path, channels[3:], full, "alpha values")
    if alpha is None:
        return colors, {}
    return colors, {"alpha": np.rint(alpha[:, 0] * 255).astype(np.uint8) if full > 1 else alpha[:, 0]}


def _fit(path: Path, channels: list[NDArray[np.float64]], full: int, what: str) -> NDArray[np.float32] | None:
    """Channels scaled from 0..full to 0..1; clamped with a warning, or None with a warning if not finite."""
    values, note = fit_colors(channels, full)
    if values is None:
        warn_of_loss(path, what, note, stacklevel=5)
    elif note:
        warnings.warn(escaped(f"{path}: {what}: {note}"), UserWarning, stacklevel=5)
    return values


def _faces_of(
    path: Path, rows: AsciiRows, values: NDArray[np.float64], vertex_count: int
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float32] | None]:
    """Vertex of each corner, corners per face, and face colors (f, 3 or 4)."""
    begin = 1 + vertex_count
    first, widths = rows.first[begin:-1], rows.widths()[begin:]
    lengths = rows.cast(values[first], np.dtype(np.uint32), "the corners of a face", begin).astype(np.int64)
    extra = widths - 1 - lengths
    wrong = np.flatnonzero((extra < 0) | (extra == 2) | (extra > 4))
    if len(wrong):
        row = int(wrong[0])
        reason = f"a face of {lengths[row]} corners has {widths[row] - 1} values after their number"
        raise FileError(
            path, reason, where=rows.where(begin + row), remedy="Corners are followed by 0, 1, 3 or 4 values"
        )
    if (lengths == lengths[0]).all() and (extra == extra[0]).all():
        corners = values[first[0] :].reshape(len(lengths), -1)[:, 1 : 1 + int(lengths[0])].reshape(-1)
    else:
        within = np.arange(lengths.sum()) - np.repeat(np.cumsum(lengths) - lengths, lengths)
        corners = values[np.repeat(first + 1, lengths) + within]
    if not ((corners >= 0) & (corners < vertex_count) & (np.floor(corners) == corners)).all():
        row_of = np.repeat(np.arange(begin, begin + len(lengths)), lengths)
        integers = rows.cast(corners, np.dtype(np.uint32), "a corner", row_of)
        bad = int(np.flatnonzero(integers >= vertex_count)[0])
        reason = f"a face refers to vertex {integers[bad]}, but there are {vertex_count} vertices"
        raise FileError(path, reason, where=rows.where(int(row_of[bad])))
    return corners.astype(np.int64), lengths, _face_colors(path, values, first + 1 + lengths, extra)


def _face_colors(
    path: Path, values: NDArray[np.float64], first: NDArray[np.int64], extra: NDArray[np.int64]
) -> NDArray[np.float32] | None:
    """Face colors, 3 or 4 values from `first`. None with a warning if incomplete."""
    width = int(extra[0])
    if not extra.any():
        return None
    if width < 3 or (extra != width).any():
        some = np.count_nonzero(extra > 1)
        reason = f"{some} of {len(extra)} faces have one of {width if width > 2 else '3 or 4'} values"
        warn_of_loss(path, "colors of faces", reason, stacklevel=5)
        return None
    channels = [values[first + k] for k in range(width)]
    return _fit(path, channels, color_scale(channels[:3]), "colors of faces")


def storable_in_off(mesh: MeshTable) -> tuple[MeshTable, list[str]]:
    storable, of_triangles, names = {}, {}, []
    for name, values in mesh.attributes.items():
        if name == "alpha" and mesh.vertex_colors is not None and values.dtype == np.uint8 and values.ndim == 1:
            storable[name] = values
        else:
            names.append(name)
    for name, values in mesh.triangle_attributes.items():
        if name == "colors" and values.ndim == 2 and values.shape[1] in (3, 4):
            of_triangles[name] = values
        else:
            names.append(f"triangle {name}")
    if mesh.triangle_uvs is not None:
        names.append("textures")
    return replace(mesh.without_texture(), attributes=storable, triangle_attributes=of_triangles), names


def write_off(path: FilePath, mesh: MeshTable, *, overwrite: bool = True) -> None:
    """Write a mesh as OFF atomically, with 8-bit colors. Textures and other attributes are dropped with a warning."""
    path = check_writable(path, overwrite=overwrite)
    mesh, lost = storable_in_off(mesh.checked())
    columns: list[NDArray[Any]] = [*mesh.vertices.T]
    if mesh.vertex_normals is not None:
        columns += [*mesh.vertex_normals.T]
    if not all(np.isfinite(column).all() for column in columns):
        raise FileError(path, "vertices, vertex_normals: OFF cannot store NaN or infinite values")
    if mesh.vertex_colors is not None:
        columns += [*colors_to_bytes(path, mesh.vertex_colors).T]
        columns.append(mesh.attributes.get("alpha", np.full(len(mesh.vertices), 255, np.uint8)))
    kind = "C" * (mesh.vertex_colors is not None) + "N" * (mesh.vertex_normals is not None)
    faces, colors = [*mesh.triangles.T], mesh.triangle_attributes.get("colors")
    if colors is not None:
        faces += [colors_to_bytes(path, colors[:, [k, k, k]])[:, 0] for k in range(colors.shape[1])]
    warn_left_out(path, "OFF", lost)
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(f"{kind}OFF\n{len(mesh.vertices)} {len(mesh.triangles)} 0\n".encode("ascii"))
        write_rows(file, columns)
        write_rows(file, faces, line="3 " + row_format(faces))
