"""PLY files of points and triangle meshes, in text and both binary byte orders.

Counts are compared with the file size before memory is allocated. An attribute (n, c) is written as a_0 .. a_{c-1}.
Textures as in MeshLab: `texcoord` and `texnumber` of faces, `comment TextureFile`. Also s t, u v or texture_u texture_v
of vertices. Greg Turk, "The PLY Polygon File Format" (1994). VCGlib for textures.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.coordinates import quiet
from ...core.errors import CLOUD_REMEDY, FileError, FilePath
from ..ascii_rows import CHUNK_ROWS, write_rows
from ..attribute_names import NameRules, is_word, split_columns
from ..columns import (
    check_extent,
    check_name,
    check_types,
    colors_or_loss,
    colors_to_bytes,
    narrow_attributes,
    own,
    stack_colors,
    stack_normals,
    stack_points,
    warn_of_loss,
)
from ..fixed_rows import NO_TABLE
from ..images.texture_files import image_names, read_textures, write_with
from ..source import SourceFile, open_source
from ..table import MeshTable, PointTable
from ..triangulation import split_faces, warn_of_small
from .ply_faces import STRIPS, attribute_columns, strip_triangles, triangle_attributes, warn_of_rest
from .ply_header import TYPE_NAMES, Element, PlyHeader, Property, read_header
from .ply_rows import Column, ListColumn, find_rows, read_rows

_AT_CORNERS, _NUMBER, _IMAGE = "texcoord", "texnumber", "TextureFile"
_AT_VERTICES = (("texture_u", "texture_v"), ("s", "t"), ("u", "v"))


def texture_properties(path: FilePath, face: Element) -> list[Property]:
    """The texture properties of faces. Raises `FileError` if a list is a scalar or the reverse."""
    properties = [prop for prop in face.properties if prop.name in (_AT_CORNERS, _NUMBER)]
    for prop in properties:
        is_list = prop.count_type is not None
        if is_list != (prop.name == _AT_CORNERS) or (not is_list and prop.dtype.kind == "f"):
            expected = "a list of coordinates" if prop.name == _AT_CORNERS else "a whole number"
            raise FileError(path, f"the faces' property {prop.name!r} is not {expected}")
    return properties


def pair_at_vertices(attributes: dict[str, NDArray[Any]]) -> tuple[str, str] | None:
    return next((pair for pair in _AT_VERTICES if all(name in attributes for name in pair)), None)


def add_textures(
    path: FilePath,
    mesh: MeshTable,
    header: PlyHeader,
    columns: dict[str, Column],
    lengths: NDArray[np.int64],
    fans: NDArray[np.int64],
    *,
    outside_files: bool = False,
) -> None:
    """Add textures to a mesh; `lengths` (f,) are corners per face, `fans` (t, 3) triangles as corner indices."""
    mesh.triangle_uvs = _uvs_of(path, mesh, columns, lengths, fans)
    if mesh.triangle_uvs is None:
        return
    named = [words[1] for words in (text.split(None, 1) for text in header.comments) if _is_image(words)]
    if not named:
        return
    numbers = columns.get(_NUMBER)
    used, ids = np.zeros(1, np.int64), None
    if numbers is not None:
        assert not isinstance(numbers, ListColumn)
        bad = np.flatnonzero((numbers < 0) | (numbers >= len(named)))
        if len(bad):
            reason = f"a face refers to texture {numbers[bad[0]]}, but {len(named)} are listed"
            raise FileError(path, reason, where=f"face {int(bad[0])}")
        used, ids = np.unique(numbers, return_inverse=True)
    mesh.textures = read_textures(path, [named[number] for number in used], outside_files=outside_files)
    if mesh.textures and ids is not None and ids.any():
        mesh.triangle_material_ids = np.repeat(ids.astype(np.int32), lengths - 2)


def _is_image(words: list[str]) -> bool:
    return len(words) == 2 and words[0] == _IMAGE


def _uvs_of(
    path: FilePath, mesh: MeshTable, columns: dict[str, Column], lengths: NDArray[np.int64], fans: NDArray[np.int64]
) -> NDArray[np.float32] | None:
    given, pair = columns.get(_AT_CORNERS), pair_at_vertices(mesh.attributes)
    with quiet():
        if isinstance(given, ListColumn) and (given.lengths != 0).any():
            wrong = np.flatnonzero(given.lengths != 2 * lengths)
            if len(wrong):
                row = int(wrong[0])
                reason = f"a face of {lengths[row]} corners has {given.lengths[row]} texture coordinates"
                raise FileError(path, reason, where=f"face {row}")
            return given.values.astype(np.float32).reshape(-1, 2)[fans.reshape(-1)]
        if pair is None:
            return None
        u, v = (mesh.attributes.pop(name).astype(np.float32) for name in pair)
    return np.stack([u, v], axis=1)[mesh.triangles.reshape(-1)]


def face_columns(mesh: MeshTable) -> tuple[list[str], list[NDArray[Any]]]:
    """The texture properties of faces to write, and their columns."""
    if mesh.triangle_uvs is None:
        return [], []
    properties, columns = ["property list uchar float texcoord"], [np.broadcast_to(np.uint8(6), len(mesh.triangles))]
    columns += [*mesh.triangle_uvs.reshape(-1, 6).T]
    if mesh.triangle_material_ids is not None:
        properties.append("property int texnumber")
        columns.append(mesh.triangle_material_ids)
    return properties, columns


_POINTS: tuple[str, ...] = ("x", "y", "z")
_NORMALS: tuple[str, ...] = ("nx", "ny", "nz")
_COLORS: tuple[tuple[str, ...], ...] = (
    ("red", "green", "blue"),
    ("diffuse_red", "diffuse_green", "diffuse_blue"),
    ("r", "g", "b"),
)
_CORNERS = ("vertex_indices", "vertex_index")
_PACKED_SPLATS = "packed_position"
TYPES = "i1 u1 i2 u2 i4 u4 f4 f8"
_CONVERSION = "Convert it to an integer of at most 32 bits or to float32 or float64"
_CLOUD_REMEDY = f"{_CONVERSION}, or write NPZ, or pass drop_unsupported=True"
_MESH_REMEDY = f"{_CONVERSION}, or write .vtp, or delete it from mesh.vertex_attributes or mesh.triangle_attributes"


def read_ply(path: FilePath, *, source: SourceFile | None = None) -> PointTable:
    """Read the vertices of a PLY file, as float32 if x, y and z are float, else float64. `source`: the open file.
    Text files need about 25 bytes of memory per number in addition to the result."""
    path = Path(path)
    source = source or open_source(path)
    header = read_header(path, source)
    table = _read_vertices(path, source, header)
    warn_of_lost_values(path, header)
    return table


def _read_vertices(path: Path, source: SourceFile, header: PlyHeader) -> PointTable:
    if not (header.ascii or header.element(path, "vertex").has_lists):
        rows = find_rows(path, source, header, "vertex")
        try:
            return rows.table(lambda columns, out: table_of(path, columns, out))
        except FileError:  # of colors that depend on all rows, or of a row whose number is known for all rows only
            return _table_of(path, rows.columns(), colors_or_loss)
    return _table_of(path, vertex_columns(path, source, header), colors_or_loss)


def warn_of_lost_values(path: Path, header: PlyHeader) -> None:
    """Warn of the lists of vertices and the elements that a cloud cannot store. Faces are those of a mesh."""
    vertex = header.element(path, "vertex")
    kept = {prop.name: np.empty(0) for prop in vertex.properties if prop.count_type is None}
    warn_of_rest(path, header, {"vertex": kept}, what="cloud")


def vertex_columns(path: Path, source: SourceFile, header: PlyHeader) -> dict[str, NDArray[Any]]:
    """The vertex scalars, after checking the file size against the header."""
    header.element(path, "vertex")
    columns = read_rows(path, source, header, _is_vertex_scalar)["vertex"]
    return {name: column for name, column in columns.items() if not isinstance(column, ListColumn)}


def table_of(path: Path, columns: Mapping[str, Column], out: PointTable | None = None) -> PointTable:
    """Copy columns, or some rows, into a point table, or into `out`. Raises if colors are out of range."""
    return _table_of(path, columns, stack_colors, out)


def _table_of(
    path: Path,
    columns: Mapping[str, Column],
    colors_of: Callable[..., NDArray[np.float32] | None],
    out: PointTable | None = None,
) -> PointTable:
    points, normals, colors, attributes = _assign_roles(path, columns, colors_of, out)
    return PointTable(points, normals, colors, attributes)


def read_ply_mesh(path: FilePath, *, outside_files: bool = False, source: SourceFile | None = None) -> MeshTable:
    """Read a PLY file as a triangle mesh, with values of faces as triangle attributes. Polygons are triangulated.
    `source`: the open file."""
    path = Path(path)
    source = source or open_source(path)
    header = read_header(path, source)
    header.element(path, "vertex")
    by_name = {element.name: element for element in header.elements if element.count}
    if "face" not in by_name and STRIPS not in by_name:
        if "face" in (element.name for element in header.elements):
            _corner_property(path, header.element(path, "face"))
        raise FileError(path, "contains no faces", remedy=CLOUD_REMEDY)
    taken: dict[str, list[Property]] = {}
    for name in ("face", STRIPS):
        if name in by_name:
            taken[name] = [_corner_property(path, by_name[name])]
    if "face" in by_name:
        taken["face"] += texture_properties(path, by_name["face"])

    def wanted(element: Element, prop: Property) -> bool:
        is_scalar = prop.count_type is None and element.name in ("vertex", "face")
        return is_scalar or prop in taken.get(element.name, ())

    columns = read_rows(path, source, header, wanted)
    vertices, normals, colors, attributes = _assign_roles(path, columns["vertex"], colors_or_loss)
    check_extent(path, vertices)
    mesh = MeshTable(vertices, np.empty((0, 3), np.int64), normals, colors, attributes)
    if "face" in by_name:
        faces = columns["face"][taken["face"][0].name]
        assert isinstance(faces, ListColumn)
        vertex_of = _check_corners(path, faces, len(vertices))
        if (faces.lengths < 3).any():
            warn_of_small(path, faces.lengths)
            vertex_of = vertex_of[np.repeat(faces.lengths >= 3, faces.lengths)]
            columns["face"] = _chosen(columns["face"], faces.lengths >= 3)
            faces = columns["face"][taken["face"][0].name]
            assert isinstance(faces, ListColumn)
        fans = split_faces(path, faces.lengths, vertex_of, vertices)
        mesh.triangles = vertex_of[fans]
        add_textures(path, mesh, header, columns["face"], faces.lengths, fans, outside_files=outside_files)
        mesh.triangle_attributes = triangle_attributes(path, columns["face"], faces.lengths)
    if STRIPS in by_name:
        _add_strips(path, mesh, columns[STRIPS][taken[STRIPS][0].name])
    warn_of_rest(path, header, columns)
    return mesh


def _chosen(columns: Mapping[str, Column], mask: NDArray[np.bool_]) -> dict[str, Column]:
    """The chosen rows of an element."""
    return {
        name: ListColumn(column.lengths[mask], column.values[np.repeat(mask, column.lengths)])
        if isinstance(column, ListColumn)
        else column[mask]
        for name, column in columns.items()
    }


def _add_strips(path: Path, mesh: MeshTable, strips: Column) -> None:
    """Append the triangles of strips, which have no face attributes."""
    assert isinstance(strips, ListColumn)
    triangles = strip_triangles(path, strips, len(mesh.vertices))
    if not len(mesh.triangles) and not len(triangles):
        raise FileError(path, "contains no faces: its strips have no triangle", remedy=CLOUD_REMEDY)
    if mesh.triangle_uvs is not None or mesh.triangle_attributes:
        warn_of_loss(path, "textures and values of faces", "the strips beside them have none")
        mesh.triangle_uvs, mesh.triangle_material_ids, mesh.textures, mesh.triangle_attributes = None, None, (), {}
    mesh.triangles = np.concatenate([mesh.triangles, triangles])


def write_ply(
    path: FilePath, table: PointTable, *, ascii: bool = False, overwrite: bool = True, comments: Sequence[str] = ()
) -> None:
    """Write points as PLY, binary little-endian or text, atomically; lossless except for 8-bit colors."""
    path = check_writable(path, overwrite=overwrite)
    table = table.checked()
    columns = _vertex_columns(path, table.points, table.normals, table.colors, table.attributes)
    head = _header(columns, len(table.points), ascii=ascii, comments=comments)
    with atomic_write(path, overwrite=overwrite) as file:
        file.write("\n".join([*head, "end_header", ""]).encode("ascii"))
        _write_columns(file, list(columns.values()), ascii=ascii)


def write_ply_mesh(
    path: FilePath, mesh: MeshTable, *, ascii: bool = False, overwrite: bool = True, comments: Sequence[str] = ()
) -> None:
    """Write a mesh as PLY, binary little-endian or text, with textures in m_0.png, m_1.png, .. beside m.ply."""
    path = check_writable(path, overwrite=overwrite)
    mesh = mesh.checked()
    if mesh.triangles.dtype != np.int32:
        raise FileError(
            path, f"PLY's 32-bit indices cannot index {len(mesh.vertices)} vertices", remedy="Split the mesh"
        )
    columns = _vertex_columns(
        path, mesh.vertices, mesh.vertex_normals, mesh.vertex_colors, mesh.attributes, _MESH_REMEDY
    )
    if mesh.triangle_uvs is None and (pair := pair_at_vertices(mesh.attributes)):
        reason = f"the attributes {', '.join(pair)} would be read as texture coordinates"
        raise FileError(path, reason, remedy="Rename one of them")
    names = image_names(path, len(mesh.textures))
    properties, values = face_columns(mesh)
    more, more_values = attribute_columns(path, mesh.triangle_attributes, TYPES, _MESH_REMEDY)
    all_comments = [*comments, *(f"TextureFile {name}" for name in names)]
    head = _header(columns, len(mesh.vertices), ascii=ascii, comments=all_comments)
    head += ["element face " + str(len(mesh.triangles)), "property list uchar int vertex_indices"]
    head += [*properties, *more]
    with write_with(path, dict(zip(names, mesh.textures, strict=True)), overwrite=overwrite) as file:
        file.write("\n".join([*head, "end_header", ""]).encode("ascii"))
        _write_columns(file, list(columns.values()), ascii=ascii)
        corner_counts = np.broadcast_to(np.uint8(3), len(mesh.triangles))
        _write_columns(file, [corner_counts, *mesh.triangles.T, *values, *more_values], ascii=ascii)


def write_ply_mesh_parts(
    path: FilePath, parts: Callable[[], Iterable[MeshTable]], counts: tuple[int, int], *, overwrite: bool = True
) -> None:
    """Write a mesh that is generated in parts as one binary PLY, with one part in memory at a time.
    `parts` is called twice. Its triangles index the vertices of all parts. `counts` are all vertices and triangles."""
    path, (vertices, triangles) = check_writable(path, overwrite=overwrite), counts
    if vertices > np.iinfo(np.int32).max:
        reason = f"PLY's 32-bit indices cannot index {vertices:,} vertices"
        raise FileError(path, reason, remedy="Write the parts as files of a folder")
    with atomic_write(path, overwrite=overwrite) as file:
        for number, part in enumerate(parts()):
            columns = _vertex_columns(path, part.vertices, None, part.vertex_colors, {})
            if not number:
                head = _header(columns, vertices, ascii=False)
                head += [f"element face {triangles}", "property list uchar int vertex_indices"]
                file.write("\n".join([*head, "end_header", ""]).encode("ascii"))
            _write_columns(file, list(columns.values()), ascii=False)
        for part in parts():
            corners = np.broadcast_to(np.uint8(3), len(part.triangles))
            _write_columns(file, [corners, *part.triangles.astype(np.int32).T], ascii=False)


def _is_vertex_scalar(element: Element, prop: Property) -> bool:
    return element.name == "vertex" and prop.count_type is None


def _role_names(path: FilePath, names: Sequence[str] | Mapping[str, Any]) -> list[tuple[str, ...] | None]:
    """The properties of positions, normals and colors. None for a missing role."""
    missing = [name for name in _POINTS if name not in names]
    if missing and _PACKED_SPLATS in names:
        raise FileError(path, "contains compressed Gaussian splats (SuperSplat)", remedy="read_splats reads them")
    if missing:
        raise FileError(path, f"element 'vertex' has no property {', '.join(missing)}")
    normals = _NORMALS if all(name in names for name in _NORMALS) else None
    colors = next((triple for triple in _COLORS if all(name in names for name in triple)), None)
    return [_POINTS, normals, colors]


def _assign_roles(
    path: FilePath,
    columns: Mapping[str, Column],
    colors_of: Callable[..., NDArray[np.float32] | None],
    out: PointTable | None = None,
) -> tuple[NDArray[Any], NDArray[np.float32] | None, NDArray[np.float32] | None, dict[str, NDArray[Any]]]:
    arrays = {name: column for name, column in columns.items() if not isinstance(column, ListColumn)}
    roles = _role_names(path, arrays)
    points, normals, colors = ([arrays.pop(name) for name in names] if names else None for names in roles)
    assert points is not None
    given = NO_TABLE if out is None else out
    return (
        stack_points(points, given.points),
        None if normals is None else stack_normals(path, normals, given.normals),
        None if colors is None else colors_of(path, colors, out=given.colors),
        {name: own(column, given.attributes.get(name)) for name, column in arrays.items()},
    )


def _corner_property(path: FilePath, face: Element) -> Property:
    for prop in face.properties:
        if prop.name in _CORNERS:
            if prop.count_type is None or prop.dtype.kind == "f":
                raise FileError(path, f"the property {prop.name!r} of {face.name!r} is not a list of whole numbers")
            return prop
    raise FileError(path, f"element {face.name!r} has no property vertex_indices")


def _check_corners(path: FilePath, faces: ListColumn, vertex_count: int) -> NDArray[Any]:
    corners = faces.values
    bad = (corners < 0) | (corners >= vertex_count)
    if bad.any():
        k = int(np.flatnonzero(bad)[0])
        row = int(np.searchsorted(np.cumsum(faces.lengths), k, side="right"))
        reason = f"a face refers to vertex {corners[k]}, but there are {vertex_count} vertices"
        raise FileError(path, reason, where=f"face {row}")
    return corners.astype(np.int32 if vertex_count <= 2**31 else np.int64)


def name_rules(normals: Any, colors: Any) -> NameRules:
    used = {*_POINTS, *(_NORMALS if normals is not None else ()), *(_COLORS[0] if colors is not None else ())}
    roles = [*([_NORMALS] if normals is None else []), *(_COLORS if colors is None else [])]
    return NameRules(is_word, used, roles)


def _vertex_columns(
    path: FilePath,
    points: NDArray[Any],
    normals: NDArray[Any] | None,
    colors: NDArray[Any] | None,
    attributes: dict[str, NDArray[Any]],
    remedy: str = _CLOUD_REMEDY,
) -> dict[str, NDArray[Any]]:
    """Columns of shape (n,) by property name. Raises if a name or type would not read back."""
    columns: dict[str, NDArray[Any]] = dict(zip(_POINTS, points.T, strict=True))
    if normals is not None:
        columns |= dict(zip(_NORMALS, normals.T, strict=True))
    if colors is not None:
        columns |= dict(zip(_COLORS[0], colors_to_bytes(path, colors).T, strict=True))
    attributes = narrow_attributes(attributes)
    check_types(path, attributes, TYPES, remedy)
    for name, values in attributes.items():
        check_name(path, name)
        parts = split_columns(name, values)
        clash = sorted(parts.keys() & columns.keys())
        if clash:
            raise FileError(path, f"attribute {name!r}: the property {clash[0]!r} exists already", remedy="Rename it")
        columns |= parts
    expected = [_POINTS, None if normals is None else _NORMALS, None if colors is None else _COLORS[0]]
    for names, meant in zip(_role_names(path, columns), expected, strict=True):
        if names != meant:
            reason = f"the attributes {', '.join(names or ())} would be read as normals or colors"
            raise FileError(path, reason, remedy="Rename one of them")
    return columns


def _header(columns: dict[str, NDArray[Any]], count: int, *, ascii: bool, comments: Sequence[str] = ()) -> list[str]:
    lines = ["ply", f"format {'ascii' if ascii else 'binary_little_endian'} 1.0"]
    lines += [*(f"comment {comment}" for comment in comments), f"element vertex {count}"]
    for name, column in columns.items():
        lines.append(f"property {TYPE_NAMES[f'{column.dtype.kind}{column.dtype.itemsize}']} {name}")
    return lines


def _write_columns(file: IO[bytes], columns: list[NDArray[Any]], *, ascii: bool) -> None:
    if ascii:
        write_rows(file, columns)
        return
    row = np.dtype([(f"f{k}", column.dtype.newbyteorder("<")) for k, column in enumerate(columns)])
    for begin in range(0, len(columns[0]), CHUNK_ROWS):
        parts = [column[begin : begin + CHUNK_ROWS] for column in columns]
        packed = np.empty(len(parts[0]), row)
        for k, part in enumerate(parts):
            packed[f"f{k}"] = part
        file.write(packed.tobytes())
