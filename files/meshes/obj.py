"""Wavefront OBJ, text: vertices (with colours as x y z r g b), vertex normals, texture coordinates, materials, faces.

Written are triangles; textures as pictures and an .mtl beside the file (obj_materials.py). Not held: attributes
(refused), float64 types (values are written with digits enough to read back the same), and material numbers of a mesh
that has no textures.

Read are faces of any number of corners, each a fan of triangles, with corners as v, v/vt, v//vn and v/vt/vn, counted
from the first or (negative) from the last. OBJ has a normal at each corner of a face, a mesh one at each vertex: they
are taken where all corners at a vertex agree, else left behind with a warning (Open3D takes the first). A corner
without texture coordinates gets (0, 0) where others have them. Materials that faces have are numbered in the order of
the .mtl, those that it lacks (a warning) and faces without a material behind them, white. Where the .mtl or a picture
is missing, or its name leads out of the folder, textures and material numbers are left behind with a warning. Left
behind too are groups, points and lines; free-form surfaces and rational vertices are refused.

Source: Wavefront's "Object Files (.obj)", with the vertex colours that MeshLab and Blender added.
"""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import check_writable
from ...core.coordinates import quiet
from ...core.errors import FileError
from ...core.paths import path_of
from ..ascii_rows import AsciiRows, row_format, write_rows
from ..columns import stack_colors, stack_normals
from ..fans import fan_corners
from ..pictures.texture_files import derived_name, find_beside, write_with
from ..source import open_source
from ..table import MeshTable
from .obj_materials import Material, material_name, materials_of, mtl_of, pictures_of

_PASSED_OVER = frozenset(b"vp g o s mg usemap maplib p l lod bevel c_interp d_interp shadow_obj trace_obj".split())
_KINDS = {b"v": "vertices", b"vt": "texture coordinates", b"vn": "normals"}


def read_obj(path: str | os.PathLike[str], *, outside_files: bool = False) -> MeshTable:
    """Read a triangle mesh from OBJ.

    Args:
        path: The file.
        outside_files: Whether names of an .mtl or a picture that lead out of the file's folder are followed.

    Returns:
        The mesh with float64 vertices; normals and colours where all vertices have them, and one texture for each
        material that a face has.

    Raises:
        FileError: Missing, no face, a statement that is not known, a line with another number of values, a colour
            outside 0..1, a face of fewer than three corners, or a corner that names what is not there; says the line.
            Or an .mtl or a picture that is damaged.

    Warns:
        UserWarning: The file has normals that are not one a vertex, or names an .mtl, a picture or a material that is
            not there.
    """
    path = path_of(path)
    statements = _read_statements(path)
    vertices, colors = _vertices_of(path, statements.rows(b"v"))
    normals = statements.rows(b"vn")
    normals.check_width(0, normals.row_count, 3)
    normal_values = stack_normals(path, [*normals.numbers().reshape(-1, 3).T]) if normals.row_count else None
    if not statements.faces:
        raise FileError(path, "holds no faces", remedy="Read the vertices as a cloud: convert them to .xyz first")
    corners, corner_uvs, corner_normals = statements.corners()
    lengths = np.array([len(words) for _, words, _ in statements.faces])
    triangles = fan_corners(path, lengths)
    vertex_normals = None
    if normal_values is not None:
        vertex_normals = _normals_of(corners, corner_normals, normal_values, len(vertices))
        if vertex_normals is None:
            message = f"{path}: the normals are left behind, since they are not one a vertex"
            warnings.warn(f"{message}; compute_vertex_normals() makes such", UserWarning, stacklevel=3)
    mesh = MeshTable(vertices, corners[triangles], vertex_normals, colors)
    if (corner_uvs >= 0).any():
        mesh.triangle_uvs = _uvs_of(path, statements.rows(b"vt"), corner_uvs[triangles.reshape(-1)])
    if any(used >= 0 for used in statements.materials):
        used = np.repeat(statements.materials, lengths - 2)
        _add_textures(path, mesh, statements, used, outside_files=outside_files)
    return mesh.checked()


@dataclass
class _Statements:
    """The statements of a file that count, each with its line.

    Attributes:
        path: The file, for errors.
        lines: The values of each line by its kind, b"" elsewhere, so that lines keep their numbers.
        counts: How many there are of each kind.
        faces: Line, corners, and how many vertices, texture coordinates and normals came before.
        materials: The material of each face, a place in `material_names`; -1 for none.
        material_names: In the order of their first use.
        libraries: The .mtl files that are named.
    """

    path: Path
    lines: dict[bytes, list[bytes]]
    counts: dict[bytes, int] = field(default_factory=lambda: dict.fromkeys(_KINDS, 0))
    faces: list[tuple[int, list[bytes], tuple[int, ...]]] = field(default_factory=list)
    materials: list[int] = field(default_factory=list)
    material_names: dict[str, int] = field(default_factory=dict)
    libraries: list[str] = field(default_factory=list)

    def rows(self, kind: bytes) -> AsciiRows:
        return AsciiRows(self.path, b"\n".join(self.lines[kind]), 1)

    def corners(self) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
        """The vertex, the texture coordinates and the normal of each corner, from 0; -1 is none."""
        table = self._all_corners()
        if table is None:
            table = self._corners_one_by_one()
        return table[:, 0], table[:, 1], table[:, 2]

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
    begun, first, material = b"", 0, -1
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
            found.materials.append(material)
        elif kind == b"usemtl":
            name = rest.strip().decode("utf-8", "surrogateescape")
            material = found.material_names.setdefault(name, len(found.material_names))
        elif kind == b"mtllib":
            found.libraries += _libraries_of(path, rest.strip().decode("utf-8", "surrogateescape"))
        elif kind and kind not in _PASSED_OVER:
            shown = kind[:40].decode("ascii", "backslashreplace")
            reason = f"the statement {shown!r} is not read"
            remedy = "Read are v, vt, vn and f; other programs turn free-form surfaces into faces"
            raise FileError(path, reason, where=f"line {where}", remedy=remedy)
    if first:
        raise FileError(path, "ends in a line that is to go on", where=f"line {len(lines)}")
    return found


def _libraries_of(path: Path, text: str) -> list[str]:
    """The files that a mtllib names: one whose name may have blanks, or several."""
    return [text] if find_beside(path, text, outside_files=True) else text.split()


def _uvs_of(path: Path, rows: AsciiRows, corners: NDArray[np.int64]) -> NDArray[np.float32]:
    """The texture coordinates of corners: the first two of the one to three values of a vt; (0, 0) without one."""
    widths = rows.widths()
    wrong = np.flatnonzero(widths > 3)
    if len(wrong):
        reason = f"a vt has 1 to 3 values, found {widths[wrong[0]]}"
        raise FileError(path, reason, where=rows.where(int(wrong[0])))
    values, first = np.append(rows.numbers(), 0), rows.first[:-1]
    pairs = np.stack([values[first], np.where(widths > 1, values[first + 1], 0)], axis=1)
    with quiet():
        single = pairs.astype(np.float32)
    wild = np.flatnonzero((np.isinf(single) & np.isfinite(pairs)).any(axis=1))
    if len(wild):
        raise FileError(path, "a vt is beyond the range of float32", where=rows.where(int(wild[0])))
    return np.concatenate([single, np.zeros((1, 2), np.float32)])[corners]


def _add_textures(
    path: Path, mesh: MeshTable, statements: _Statements, used: NDArray[np.int64], *, outside_files: bool
) -> None:
    """Give a mesh the pictures of its materials; `used` is the material of each triangle, by first use."""
    materials = materials_of(path, statements.libraries, outside_files=outside_files)
    if not materials:
        return
    known = {material.name: number for number, material in enumerate(materials)}
    lacking = [name for name in statements.material_names if name not in known]
    if lacking:
        message = f"{path}: the material {lacking[0][:60]!r} is in none of {', '.join(statements.libraries)}"
        warnings.warn(f"{message}; it is taken for white", UserWarning, stacklevel=4)
    materials += [Material(name) for name in lacking]
    known = {material.name: number for number, material in enumerate(materials)}
    numbers = np.array([*(known[name] for name in statements.material_names), len(materials)])
    if (used < 0).any():
        materials.append(Material(""))
    mesh.textures, ids = pictures_of(path, materials, numbers[used], outside_files=outside_files)
    if mesh.textures and ids.any():
        mesh.triangle_material_ids = ids
    if mesh.textures and mesh.triangle_uvs is None:
        mesh.triangle_uvs = np.zeros((3 * len(mesh.triangles), 2), np.float32)


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
    """Write a triangle mesh as OBJ; its textures, if any, as m.mtl and m_0.png, m_1.png, .. beside m.obj.

    Args:
        path: The file; it appears whole or not at all, and so do those beside it, before it does.
        mesh: The mesh.
        overwrite: Whether existing files may be replaced.

    Raises:
        FileError: The place cannot be written, the mesh has attributes, or a value is not finite.
        ValueError: An array of the mesh has the wrong shape, or a triangle names a missing vertex or texture.
    """
    path = check_writable(path, overwrite=overwrite)
    mesh = mesh.checked()
    _refuse_unwritable(path, mesh)
    beside, library = {}, derived_name(path, ".mtl")
    if mesh.textures:
        text, pictures = mtl_of(path, mesh.textures)
        beside = {library: text, **pictures}
    with write_with(path, beside, overwrite=overwrite) as file:
        if mesh.textures:
            file.write(f"mtllib {library}\n".encode("ascii"))
        colors = [] if mesh.vertex_colors is None else [*mesh.vertex_colors.T]
        vertices = [*mesh.vertices.T, *colors]
        write_rows(file, vertices, line="v " + row_format(vertices))
        corners = [mesh.triangles.astype(np.int64) + 1]
        form = "%d"
        if mesh.triangle_uvs is not None:
            uvs, places = np.unique(mesh.triangle_uvs, axis=0, return_inverse=True)
            write_rows(file, [*uvs.T], line="vt " + row_format([*uvs.T]))
            corners.append(places.reshape(-1, 3) + 1)
            form += "/%d"
        if mesh.vertex_normals is not None:
            normals = [*mesh.vertex_normals.T]
            write_rows(file, normals, line="vn " + row_format(normals))
            form += "/%d" if len(corners) == 2 else "//%d"
            corners.append(corners[0])
        columns = [part[:, k] for k in range(3) for part in corners]
        _write_faces(file, columns, f"f {form} {form} {form}\n", mesh)


def _refuse_unwritable(path: Path, mesh: MeshTable) -> None:
    if mesh.attributes:
        reason = f"OBJ cannot hold the attributes {', '.join(mesh.attributes)}"
        raise FileError(path, reason, remedy="Write .ply, or drop them first")
    for name in ("vertices", "vertex_normals", "vertex_colors", "triangle_uvs"):
        values = getattr(mesh, name)
        if values is not None and not np.isfinite(values).all():
            row = int(np.flatnonzero(~np.isfinite(values).all(axis=1))[0])
            raise FileError(path, f"{name}: OBJ cannot hold NaN or infinite values", where=f"row {row}")


def _write_faces(file: IO[bytes], columns: list[NDArray[Any]], line: str, mesh: MeshTable) -> None:
    """The faces in their order, with the name of a material wherever it changes."""
    if not mesh.textures or not len(mesh.triangles):
        write_rows(file, columns, line=line)
        return
    ids = mesh.triangle_material_ids
    ids = np.zeros(len(mesh.triangles), np.int32) if ids is None else ids
    begins = np.flatnonzero(np.diff(ids, prepend=-1))
    for begin, end in zip(begins, [*begins[1:], len(ids)], strict=True):
        file.write(f"usemtl {material_name(ids[begin])}\n".encode("ascii"))
        write_rows(file, [column[begin:end] for column in columns], line=line)
