"""Wavefront OBJ and MTL (text): vertices with colors, normals, texture coordinates, materials, faces.

A vertex gets a normal if all its corners agree (Open3D takes the first). Missing texture coordinates are (0, 0). Each
material becomes one image: map_Kd, else one pixel of Kd, else white. Without any `usemtl`, all faces have the first
material. Unsupported content and material errors only warn.
Wavefront, "Object Files (.obj)" and "MTL material format" (1995), with the vertex colors of MeshLab and Blender.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import check_writable
from ...core.coordinates import quiet
from ...core.errors import CLOUD_REMEDY, FileError, FilePath
from ...core.escaped_text import escaped
from ...core.paths import path_of
from ..ascii_rows import AsciiRows, is_float, row_format, write_rows
from ..columns import check_extent, stack_normals, warn_left_out, warn_of_loss
from ..images.texture_files import (
    alpha_mode,
    derived_name,
    drop_alpha,
    find_beside,
    image_names,
    read_textures,
    warn_left_behind,
    why_missing,
    write_with,
)
from ..obj_statements import Statements, read_statements, vertices_of
from ..source import open_source
from ..table import MeshTable
from ..triangulation import split_faces, triangle_counts
from .obj_corners import read_corners

# Maximum number of words after each option of a map; those of _MAP_TRANSFORM_DEFAULTS are fewer if a word is no number.
_MAP_OPTION_WORDS = {
    "-blendu": 1, "-blendv": 1, "-cc": 1, "-clamp": 1, "-texres": 1, "-imfchan": 1, "-bm": 1, "-boost": 1,
    "-type": 1, "-mm": 2, "-o": 3, "-s": 3, "-t": 3,
}  # fmt: skip
_MAP_TRANSFORM_DEFAULTS = {"-mm": (0.0, 1.0), "-o": (0.0,) * 3, "-s": (1.0,) * 3, "-t": (0.0,) * 3}
_MAX_NOTES = 5

WHITE_RGB = (1.0, 1.0, 1.0)


@dataclass
class Material:
    """A material of an MTL file: `image` is map_Kd, `color` Kd in 0..1, `opacity` map_d; `scale`, `offset` map uv.
    `is_opaque` is True without map_d and without d below 1."""

    name: str
    image: str | None = None
    color: tuple[float, ...] | None = None
    opacity: str | None = None
    is_opaque: bool = True
    scale: tuple[float, float] = (1.0, 1.0)
    offset: tuple[float, float] = (0.0, 0.0)


def read_mtl(path: FilePath) -> list[Material]:
    """Read the materials of an MTL file in file order. Faults are dropped or clamped with a warning."""
    text = bytes(open_source(path)[:]).decode("utf-8", "surrogateescape").removeprefix("\ufeff")
    materials: dict[str, Material] = {}
    notes: list[str] = []
    current: Material | None = None
    for number, line in enumerate(text.splitlines(), 1):
        kind, _, rest = line.strip().replace("\t", " ").partition(" ")
        kind, rest, note = kind.lower(), rest.strip(), ""
        if kind == "newmtl":
            current = Material(rest)
            if rest in materials:
                note = f"the material {rest[:60]!r} is defined twice"
            materials.setdefault(rest, current)
        elif kind in ("kd", "map_kd", "d", "map_d"):
            note = f"{kind} comes before any newmtl" if current is None else _take(current, kind, rest)
        if note:
            notes.append(f"line {number}: {note}")
    for material in materials.values():
        if material.opacity is not None and not material.opacity.endswith(material.image or "\0"):
            notes.append(f"the opacity map {material.opacity[:60]!r} of {material.name[:60]!r} is ignored")
    if notes:
        more = f"; and {len(notes) - _MAX_NOTES} more" if len(notes) > _MAX_NOTES else ""
        warnings.warn(escaped(f"{path}: {'; '.join(notes[:_MAX_NOTES])}{more}"), UserWarning, stacklevel=5)
    return [*materials.values()]


def _take(material: Material, kind: str, rest: str) -> str:
    """Set a material's value from a statement. Returns the ignored part, or ""."""
    if kind == "map_kd":
        return _take_map(material, rest)
    if kind == "map_d":
        material.opacity, material.is_opaque = rest, False
        return ""
    words = rest.partition("#")[0].split()
    values = [float(word) for word in words if is_float(word)]
    if kind == "d":
        material.is_opaque = material.is_opaque and not (values and values[-1] < 1)
        return ""
    if len(values) != len(words) or len(values) not in (1, 3) or not np.isfinite(values).all():
        return f"Kd: expected three numbers in 0..1, got {rest[:60]!r}; it is ignored"
    material.color = tuple(min(max(value, 0.0), 1.0) for value in values) * (3 // len(values))  # one number is gray
    return "" if all(0 <= value <= 1 for value in values) else f"Kd {rest[:60]} is clamped to 0..1"


def _take_map(material: Material, text: str) -> str:
    """Set an image name and its options. Returns the ignored part, or ""."""
    lost = []
    while text.startswith("-"):
        option, _, rest = text.partition(" ")
        if option not in _MAP_OPTION_WORDS:
            lost.append(f"the unknown option {option[:40]!r} of map_Kd")
            text = rest.rpartition(" ")[2]  # number of values unknown. Names with blanks are rare
            break
        values: list[str] = []
        while len(values) < _MAP_OPTION_WORDS[option]:
            word, _, after = rest.lstrip().partition(" ")
            if option in _MAP_TRANSFORM_DEFAULTS and not is_float(word):
                break
            values.append(word)
            rest = after
        if option in _MAP_TRANSFORM_DEFAULTS:
            numbers = [*map(float, values), *_MAP_TRANSFORM_DEFAULTS[option][len(values) :]]
            if option in ("-s", "-o") and np.isfinite(numbers).all():
                setattr(material, "scale" if option == "-s" else "offset", (numbers[0], numbers[1]))
            elif tuple(numbers) != _MAP_TRANSFORM_DEFAULTS[option]:
                lost.append(f"the option {option} of map_Kd")
        text = rest.lstrip()
    material.image = text or None
    if not text:
        lost.append("map_Kd, which names no image")
    return f"{', '.join(lost)} is ignored" if lost else ""


def materials_of(path: Path, libraries: Sequence[str], *, outside_files: bool = False) -> list[Material] | None:
    """The materials of the MTL files that an OBJ names. None, with a warning, if a file is missing."""
    materials: dict[str, Material] = {}
    read: set[Path] = set()
    for library in dict.fromkeys(libraries):
        file = find_beside(path, library, outside_files=outside_files)
        if file is None:
            reason = why_missing(path, library, outside_files=outside_files)
            warn_left_behind(path, f"the file {library!r} of its materials {reason}")
            return None
        if (real := file.resolve()) not in read:
            read.add(real)
            for material in read_mtl(file):
                materials.setdefault(material.name, material)
    return [*materials.values()]


def images_of(
    path: Path, materials: list[Material], ids: NDArray[np.int64], *, outside_files: bool = False
) -> tuple[tuple[NDArray[np.uint8], ...], NDArray[np.int64]]:
    """Distinct images of the used materials, and the image index of each triangle.
    Empty if no used material has an image or a color, or, with a warning, if an image is missing or damaged."""
    used, numbers = np.unique(ids, return_inverse=True)
    materials = [materials[number] for number in used]
    if all(material.image is None and material.color is None for material in materials):
        return (), numbers
    named = [material.image for material in materials if material.image is not None]
    opaque: dict[int, NDArray[np.uint8]] = {}
    images = iter(read_textures(path, named, outside_files=outside_files))
    result = []
    for material in materials:
        if material.image is None:
            color = np.array(material.color or WHITE_RGB)
            result.append(np.rint(color * 255).astype(np.uint8).reshape(1, 1, 3))
            continue
        image = next(images, None)
        if image is None:
            return (), numbers
        if material.is_opaque and image.shape[2] == 4:
            if id(image) not in opaque:
                opaque[id(image)] = drop_alpha(image)
            image = opaque[id(image)]
        result.append(image)
    return tuple(result), numbers


def move_uvs(uvs: NDArray[np.float32], materials: list[Material], ids: NDArray[np.int64]) -> NDArray[np.float32]:
    """Texture coordinates of corners, float32 (3 t, 2), scaled and shifted by the material of each triangle."""
    scale = np.array([material.scale for material in materials])
    offset = np.array([material.offset for material in materials])
    if (scale == 1).all() and (offset == 0).all():
        return uvs
    corners = np.repeat(ids, 3)
    with quiet():
        return (uvs * scale[corners] + offset[corners]).astype(np.float32)


def material_name(number: int) -> str:
    return f"material_{number}"


def mtl_of(path: FilePath, textures: Sequence[NDArray[np.uint8]]) -> tuple[bytes, dict[str, NDArray[np.uint8]]]:
    """The MTL text for these images and the image files it names, each once. An image of one pixel becomes a color."""
    lines, named, first = [], {}, {}
    for number, (name, image) in enumerate(zip(image_names(path, len(textures)), textures, strict=True)):
        lines.append(f"newmtl {material_name(number)}")
        if image.shape == (1, 1, 3):
            lines.append("Kd {:.9g} {:.9g} {:.9g}".format(*(image[0, 0] / 255)))
        else:
            name = first.setdefault(id(image), name)
            lines += ["Kd 1 1 1", f"map_Kd {name}"]
            if alpha_mode(image) != "OPAQUE":
                lines.append(f"map_d {name}")
            named[name] = image
    return "\n".join([*lines, ""]).encode("ascii"), named


# Default names that programs write.
_NAMELESS = frozenset(("", "default", "Default", "off", "(null)", "None"))
_MAX_NAMES = 5


def read_obj(path: FilePath, *, outside_files: bool = False) -> MeshTable:
    """Read a triangle mesh from OBJ, with float64 vertices and one texture per used material."""
    path = path_of(path)
    statements = read_statements(path)
    statements.libraries = [name for text in statements.libraries for name in _libraries_of(path, text)]
    vertices, colors = vertices_of(path, statements.rows(0))
    normals = statements.rows(2)
    normals.check_width(0, normals.row_count, 3)
    normal_values = stack_normals(path, [*normals.numbers().reshape(-1, 3).T]) if normals.row_count else None
    if not statements.faces:
        raise FileError(path, "contains no faces", remedy=CLOUD_REMEDY)
    corners = read_corners(path, statements.faces, statements.face_lines, statements.before, statements.counts)
    check_extent(path, vertices)
    triangles = split_faces(path, corners.lengths, corners.vertices, vertices)
    vertex_normals = None
    if "normals" in corners.missing:
        warn_of_loss(path, "normals", corners.missing["normals"])
    elif normal_values is not None:
        vertex_normals = _normals_of(corners.vertices, corners.normals, normal_values, len(vertices))
        if vertex_normals is None:
            warn_of_loss(path, "normals", "they are not one per vertex; call compute_vertex_normals()")
    mesh = MeshTable(vertices, corners.vertices[triangles], vertex_normals, colors)
    if "texture coordinates" in corners.missing:
        warn_of_loss(path, "texture coordinates", corners.missing["texture coordinates"])
    elif (corners.uvs >= 0).any():
        mesh.triangle_uvs = _uvs_of(path, statements.rows(1), corners.uvs[triangles.reshape(-1)])
    if any(used >= 0 for used in statements.materials) or not statements.material_names:
        used = np.repeat(statements.materials, triangle_counts(corners.lengths))
        _add_textures(path, mesh, statements, used, outside_files=outside_files)
    _warn_of_rest(path, mesh, statements)
    return mesh.checked()


def _warn_of_rest(path: Path, mesh: MeshTable, statements: Statements) -> None:
    if statements.has_lines:
        warn_of_loss(path, "points and lines", "a mesh cannot store them")
    materials = [] if mesh.textures or statements.libraries else statements.material_names
    lost = []
    for what, names in ({**statements.names, "materials": materials}).items():
        named = [repr(name[:60]) for name in names if name not in _NAMELESS]
        if named:
            more = f" and {len(named) - _MAX_NAMES} more" if len(named) > _MAX_NAMES else ""
            lost.append(f"{what} {', '.join(named[:_MAX_NAMES])}{more}")
    if lost:
        warn_of_loss(path, "names", f"a mesh cannot store them: {'; '.join(lost)}")


def _libraries_of(path: Path, text: str) -> list[str]:
    return [text] if find_beside(path, text, outside_files=True) else text.split()


def _uvs_of(path: Path, rows: AsciiRows, corners: NDArray[np.int64]) -> NDArray[np.float32]:
    """Texture coordinates of corners: the first two of the one to three values of a vt; (0, 0) without one."""
    widths = rows.widths()
    wrong = np.flatnonzero(widths > 3)
    if len(wrong):
        reason = f"a vt has 1 to 3 values, got {widths[wrong[0]]}"
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
    path: Path, mesh: MeshTable, statements: Statements, used: NDArray[np.int64], *, outside_files: bool
) -> None:
    """Add the images of its materials to a mesh; `used` is the material of each triangle."""
    materials = materials_of(path, statements.libraries, outside_files=outside_files)
    if not materials:
        return
    known = {material.name: number for number, material in enumerate(materials)}
    lacking = [name for name in statements.material_names if name not in known]
    if lacking:
        message = f"{path}: the material {lacking[0][:60]!r} is not defined in {', '.join(statements.libraries)}"
        warnings.warn(escaped(f"{message}; white is used"), UserWarning, stacklevel=4)
    materials += [Material(name) for name in lacking]
    known = {material.name: number for number, material in enumerate(materials)}
    without_name = len(materials) if statements.material_names else 0  # without any usemtl: the first, as in Open3D
    numbers = np.array([*(known[name] for name in statements.material_names), without_name])
    if (used < 0).any() and without_name:
        materials.append(Material(""))
    if mesh.triangle_uvs is not None:
        mesh.triangle_uvs = move_uvs(mesh.triangle_uvs, materials, numbers[used])
    mesh.textures, ids = images_of(path, materials, numbers[used], outside_files=outside_files)
    if mesh.textures and ids.any():
        mesh.triangle_material_ids = ids
    if mesh.textures and mesh.triangle_uvs is None:
        mesh.triangle_uvs = np.zeros((3 * len(mesh.triangles), 2), np.float32)


def _normals_of(
    corners: NDArray[np.int64], named: NDArray[np.int64], normals: NDArray[np.float32], vertex_count: int
) -> NDArray[np.float32] | None:
    """One normal per vertex if its corners agree. None if some do not, or have none."""
    if (named < 0).any():
        return None
    if len(normals) == vertex_count and (corners == named).all():
        return normals
    of_vertex = np.full(vertex_count, -1)
    of_vertex[corners] = named
    if (of_vertex < 0).any() or (normals[of_vertex[corners]] != normals[named]).any():
        return None
    return normals[of_vertex]


def write_obj(path: FilePath, mesh: MeshTable, *, overwrite: bool = True) -> None:
    """Write a triangle mesh as OBJ. Textures go to m.mtl and m_0.png, m_1.png, .. beside m.obj. Files are atomic."""
    path = check_writable(path, overwrite=overwrite)
    mesh, lost = storable_in_obj(mesh.checked())
    _refuse_unwritable(path, mesh)
    warn_left_out(path, "OBJ", lost)
    beside, library = {}, derived_name(path, ".mtl")
    if mesh.textures:
        text, images = mtl_of(path, mesh.textures)
        beside = {library: text, **images}
    with write_with(path, beside, overwrite=overwrite) as file:
        if mesh.textures:
            file.write(f"mtllib {library}\n".encode("ascii"))
        colors = [] if mesh.vertex_colors is None else [*mesh.vertex_colors.T]
        vertices = [*mesh.vertices.T, *colors]
        write_rows(file, vertices, line="v " + row_format(vertices))
        corners = [mesh.triangles.astype(np.int64) + 1]
        form = "%d"
        if mesh.triangle_uvs is not None:
            uvs, uv_index = np.unique(mesh.triangle_uvs, axis=0, return_inverse=True)
            write_rows(file, [*uvs.T], line="vt " + row_format([*uvs.T]))
            corners.append(uv_index.reshape(-1, 3) + 1)
            form += "/%d"
        if mesh.vertex_normals is not None:
            normals = [*mesh.vertex_normals.T]
            write_rows(file, normals, line="vn " + row_format(normals))
            form += "/%d" if len(corners) == 2 else "//%d"
            corners.append(corners[0])
        columns = [part[:, k] for k in range(3) for part in corners]
        _write_faces(file, columns, f"f {form} {form} {form}\n", mesh)


def storable_in_obj(mesh: MeshTable) -> tuple[MeshTable, list[str]]:
    names = [*mesh.attributes, *(f"triangle {name}" for name in mesh.triangle_attributes)]
    return replace(mesh, attributes={}, triangle_attributes={}), names


def _refuse_unwritable(path: Path, mesh: MeshTable) -> None:
    for name in ("vertices", "vertex_normals", "vertex_colors", "triangle_uvs"):
        values = getattr(mesh, name)
        if values is not None and not np.isfinite(values).all():
            row = int(np.flatnonzero(~np.isfinite(values).all(axis=1))[0])
            raise FileError(path, f"{name}: OBJ cannot store NaN or infinite values", where=f"row {row}")


def _write_faces(file: IO[bytes], columns: list[NDArray[Any]], line: str, mesh: MeshTable) -> None:
    if not mesh.textures or not len(mesh.triangles):
        write_rows(file, columns, line=line)
        return
    ids = mesh.triangle_material_ids
    ids = np.zeros(len(mesh.triangles), np.int32) if ids is None else ids
    begins = np.flatnonzero(np.diff(ids, prepend=-1))
    for begin, end in zip(begins, [*begins[1:], len(ids)], strict=True):
        file.write(f"usemtl {material_name(ids[begin])}\n".encode("ascii"))
        write_rows(file, [column[begin:end] for column in columns], line=line)
