"""Wavefront OBJ, text: vertices (with colours as x y z r g b), vertex normals and faces.

Written are triangles. Not held: attributes (refused) and float64 types (values are written with digits enough to read
back the same).

Read are faces of any number of corners, each a fan of triangles, with corners as v, v/vt, v//vn and v/vt/vn, counted
from the first or (negative) from the last. OBJ has a normal at each corner of a face, a mesh one at each vertex: they
are taken where all corners at a vertex agree, else left behind with a warning (Open3D takes the first). Left behind too
are texture coordinates, materials, groups, points and lines; free-form surfaces and rational vertices are refused.

Source: Wavefront's "Object Files (.obj)", with the vertex colours that MeshLab and Blender added.
"""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..errors import FileError
from .ascii_rows import AsciiRows, row_format, write_rows
from .atomic import atomic_write, check_writable
from .columns import stack_colors, stack_normals
from .fans import fan_corners
from .source import open_source
from .table import MeshTable

_PASSED_OVER = frozenset(
    b"vp g o s mg usemtl mtllib usemap maplib p l lod bevel c_interp d_interp shadow_obj trace_obj".split()
)
_KINDS = {b"v": "vertices", b"vt": "texture coordinates", b"vn": "normals"}


def read_obj(path: str | os.PathLike[str]) -> MeshTable:
    """Read a triangle mesh from OBJ.

    Returns:
        The mesh with float64 vertices; normals and colours where all vertices have them.

    Raises:
        FileError: Missing, no face, a statement that is not known, a line with another number of values, a colour
            outside 0..1, a face of fewer than three corners, or a corner that names what is not there; says the line.

    Warns:
        UserWarning: The file has normals that are not one a vertex.
    """
    path = Path(path)
    statements = _read_statements(path)
    vertices, colors = _vertices_of(path, statements.rows(b"v"))
    normals = statements.rows(b"vn")
    normals.check_width(0, normals.row_count, 3)
    normal_values = stack_normals(path, [*normals.numbers().reshape(-1, 3).T]) if normals.row_count else None
    if not statements.faces:
        raise FileError(path, "holds no faces", remedy="Read the vertices as a cloud: convert them to .xyz first")
    corners, corner_normals = statements.corners()
    triangles = fan_corners(path, np.array([len(words) for _, words, _ in statements.faces]))
    vertex_normals = None
    if normal_values is not None:
        vertex_normals = _normals_of(corners, corner_normals, normal_values, len(vertices))
        if vertex_normals is None:
            message = f"{path}: the normals are left behind, since they are not one a vertex"
            warnings.warn(f"{message}; compute_vertex_normals() makes such", UserWarning, stacklevel=3)
    return MeshTable(vertices, corners[triangles], vertex_normals, colors).checked()


@dataclass
class _Statements:
    """The statements of a file that count, each with its line.

    Attributes:
        path: The file, for errors.
        lines: The values of each line by its kind, b"" elsewhere, so that lines keep their numbers.
        counts: How many there are of each kind.
        faces: Line, corners, and how many vertices, texture coordinates and normals came before.
    """

    path: Path
    lines: dict[bytes, list[bytes]]
    counts: dict[bytes, int] = field(default_factory=lambda: dict.fromkeys(_KINDS, 0))
    faces: list[tuple[int, list[bytes], tuple[int, ...]]] = field(default_factory=list)

    def rows(self, kind: bytes) -> AsciiRows:
        return AsciiRows(self.path, b"\n".join(self.lines[kind]), 1)

    def corners(self) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """The vertex and the normal of each corner, from 0; a normal of -1 is none."""
        table = self._all_corners()
        if table is None:
            table = self._corners_one_by_one()
        return table[:, 0], table[:, 2]

    def _all_corners(self) -> NDArray[np.int64] | None:
        """Vertex, texture coordinate and normal of each corner, where all are of one form and right; else None."""
        words = [word for _, corners, _ in self.faces for word in corners]
        text = b" ".join(words)
        forms = {(word.count(b"/"), b"//" in word) for word in words}
        if (
            len(forms) != 1
            or min(len(corners) for _, corners, _ in self.faces) < 3
            or text.translate(None, b"0123456789-/ ")
        ):
            return None
        ((slashes, skips),) = forms
        columns = [0, 2] if skips else [*range(slashes + 1)]
        try:
            numbers = np.array(text.replace(b"/", b" ").split()).astype(np.int64).reshape(len(words), len(columns))
        except (ValueError, OverflowError):
            return None
        before = np.repeat([counts for _, _, counts in self.faces], [len(corners) for _, corners, _ in self.faces], 0)
        table = np.full((len(words), 3), -1)
        places = np.where(numbers > 0, numbers - 1, before[:, columns] + numbers)
        limits = np.array([*self.counts.values()])[columns]
        if (numbers == 0).any() or (places < 0).any() or (places >= limits).any():
            return None
        table[:, columns] = places
        return table

    def _corners_one_by_one(self) -> NDArray[np.int64]:
        """The same for corners of several forms.

        Raises:
            FileError: The first that is wrong, with its line.
        """
        found: list[int] = []
        for line, words, before in self.faces:
            if len(words) < 3:
                reason = f"a face has {len(words)} corners; at least 3 are needed"
                raise FileError(self.path, reason, where=f"line {line}")
            for word in words:
                found += self._corner(word, before, line)
        return np.array(found, np.int64).reshape(-1, 3)

    def _corner(self, word: bytes, before: tuple[int, ...], line: int) -> list[int]:
        parts = word.split(b"/")
        form = [bool(part) for part in parts]
        if form not in ([True], [True, True], [True, False, True], [True, True, True]):
            raise self._bad_corner(word, line)
        places = [-1, -1, -1]
        for k, (part, kind) in enumerate(zip(parts, _KINDS, strict=False)):
            if not part:
                continue
            if not part.removeprefix(b"-").isdigit():
                raise self._bad_corner(word, line)
            number = int(part[:20])
            places[k] = number - 1 if number > 0 else before[k] + number
            if number == 0 or not 0 <= places[k] < self.counts[kind]:
                reason = f"a face names {number} of {self.counts[kind]} {_KINDS[kind]}"
                raise FileError(self.path, reason, where=f"line {line}")
        return places

    def _bad_corner(self, word: bytes, line: int) -> FileError:
        shown = word[:40].decode("ascii", "backslashreplace")
        reason = f"not a corner of a face: {shown!r}"
        return FileError(self.path, reason, where=f"line {line}", remedy="Corners are v, v/vt, v//vn or v/vt/vn")


def _read_statements(path: Path) -> _Statements:
    body = bytes(open_source(path)[:])
    if b"\r" in body:
        body = body.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    lines = body.split(b"\n")
    found = _Statements(path, {kind: [b""] * len(lines) for kind in _KINDS})
    begun, first = b"", 0
    for number, line in enumerate(lines, 1):
        text = line.partition(b"#")[0]
        if text.rstrip().endswith(b"\\"):  # goes on in the next line
            begun, first = begun + text.rstrip()[:-1] + b" ", first or number
            continue
        text, where = (begun + text, first) if first else (text, number)
        begun, first = b"", 0
        kind, _, rest = text.strip().replace(b"\t", b" ").partition(b" ")
        if kind in _KINDS:
            found.lines[kind][where - 1] = rest
            found.counts[kind] += 1
        elif kind == b"f":
            found.faces.append((where, rest.split(), tuple(found.counts.values())))
        elif kind and kind not in _PASSED_OVER:
            shown = kind[:40].decode("ascii", "backslashreplace")
            reason = f"the statement {shown!r} is not read"
            remedy = "Read are v, vt, vn and f; other programs turn free-form surfaces into faces"
            raise FileError(path, reason, where=f"line {where}", remedy=remedy)
    if first:
        raise FileError(path, "ends in a line that is to go on", where=f"line {len(lines)}")
    return found


def _vertices_of(path: Path, rows: AsciiRows) -> tuple[NDArray[np.float64], NDArray[np.float32] | None]:
    """Positions and, where the lines have six values, colours."""
    if not rows.row_count:
        raise FileError(path, "holds no vertices")
    width = int(rows.widths()[0])
    if width not in (3, 4, 6):
        raise FileError(path, f"a vertex has 3, 4 or 6 values, found {width}", where=rows.where(0))
    rows.check_width(0, rows.row_count, width)
    values = rows.numbers().reshape(-1, width)
    if width == 4 and (values[:, 3] != 1).any():
        row = int(np.flatnonzero(values[:, 3] != 1)[0])
        reason = f"a vertex has the weight {values[row, 3]:g}; rational vertices are not read"
        raise FileError(path, reason, where=rows.where(row))
    colors = stack_colors(path, [*values[:, 3:].T]) if width == 6 else None
    return np.ascontiguousarray(values[:, :3]), colors


def _normals_of(
    corners: NDArray[np.int64], named: NDArray[np.int64], normals: NDArray[np.float32], vertex_count: int
) -> NDArray[np.float32] | None:
    """One normal for each vertex, where the corners at it agree; None where some do not, or have none."""
    if (named < 0).any():
        return None
    if len(normals) == vertex_count and (corners == named).all():
        return normals
    of_vertex = np.full(vertex_count, -1)
    of_vertex[corners] = named
    if (of_vertex < 0).any() or (normals[of_vertex[corners]] != normals[named]).any():
        return None
    return normals[of_vertex]


def write_obj(path: str | os.PathLike[str], mesh: MeshTable, *, overwrite: bool = True) -> None:
    """Write a triangle mesh as OBJ.

    Args:
        path: The file; it appears whole or not at all.
        mesh: The mesh.
        overwrite: Whether an existing file may be replaced.

    Raises:
        FileError: The place cannot be written, the mesh has attributes, or a value is not finite.
        ValueError: An array of the mesh has the wrong shape, or a triangle names a missing vertex.
    """
    path = check_writable(path, overwrite=overwrite)
    mesh = mesh.checked()
    if mesh.attributes:
        reason = f"OBJ cannot hold the attributes {', '.join(mesh.attributes)}"
        raise FileError(path, reason, remedy="Write .ply, or drop them first")
    for name, values in (
        ("vertices", mesh.vertices),
        ("vertex_normals", mesh.vertex_normals),
        ("vertex_colors", mesh.vertex_colors),
    ):
        if values is not None and not np.isfinite(values).all():
            row = int(np.flatnonzero(~np.isfinite(values).all(axis=1))[0])
            raise FileError(path, f"{name}: OBJ cannot hold NaN or infinite values", where=f"row {row}")
    corners = [*(mesh.triangles.astype(np.int64) + 1).T]
    with atomic_write(path, overwrite=overwrite) as file:
        colors = [] if mesh.vertex_colors is None else [*mesh.vertex_colors.T]
        vertices = [*mesh.vertices.T, *colors]
        write_rows(file, vertices, line="v " + row_format(vertices))
        if mesh.vertex_normals is None:
            write_rows(file, corners, line="f " + row_format(corners))
        else:
            normals = [*mesh.vertex_normals.T]
            write_rows(file, normals, line="vn " + row_format(normals))
            pairs = [corner for corner in corners for _ in range(2)]
            write_rows(file, pairs, line="f %d//%d %d//%d %d//%d\n")
