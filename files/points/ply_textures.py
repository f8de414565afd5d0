"""Textures in PLY files, as MeshLab has them: coordinates in faces or at vertices, pictures in comments.

A face has `property list uchar float texcoord`, u and v of each of its corners, and `property int texnumber`, which of
the pictures that `comment TextureFile name` lines name. Read are also coordinates at vertices: the properties
texture_u texture_v, or s t, or u v. (0, 0) is the lower left corner of a picture.

Source: VCGlib's exporter and importer of PLY, whose names these are.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import quiet
from ...core.errors import FileError
from ..pictures.texture_files import read_textures
from ..table import MeshTable
from .ply_header import Element, PlyHeader, Property
from .ply_rows import Column, ListColumn

_AT_CORNERS, _NUMBER, _PICTURE = "texcoord", "texnumber", "TextureFile"
_AT_VERTICES = (("texture_u", "texture_v"), ("s", "t"), ("u", "v"))


def texture_properties(path: Any, face: Element) -> list[Property]:
    """The properties of faces that tell their texture.

    Raises:
        FileError: One of them is a list where it should not be, or is none where it should.
    """
    found = [prop for prop in face.properties if prop.name in (_AT_CORNERS, _NUMBER)]
    for prop in found:
        is_list = prop.count_type is not None
        if is_list != (prop.name == _AT_CORNERS) or (not is_list and prop.dtype.kind == "f"):
            expected = "a list of coordinates" if prop.name == _AT_CORNERS else "a whole number"
            raise FileError(path, f"the faces' property {prop.name!r} is not {expected}")
    return found


def pair_at_vertices(attributes: dict[str, NDArray[Any]]) -> tuple[str, str] | None:
    """Which attributes of vertices are texture coordinates; None where none are."""
    return next((pair for pair in _AT_VERTICES if all(name in attributes for name in pair)), None)


def add_textures(
    path: Any,
    mesh: MeshTable,
    header: PlyHeader,
    columns: dict[str, Column],
    lengths: NDArray[np.int64],
    fans: NDArray[np.int64],
    *,
    outside_files: bool = False,
) -> None:
    """Give a mesh the textures of its file: the pictures that faces have, in the order of their names.

    Args:
        path: The file.
        mesh: The mesh, whose `attributes` hold the scalars at vertices.
        header: The file's header, with the comments.
        columns: The texture properties of faces.
        lengths: Corners of each face, shape [f].
        fans: The triangles as places in the list of all corners, shape [t, 3].
        outside_files: Whether names that lead out of the file's folder are followed.

    Raises:
        FileError: A face with another number of coordinates than two a corner, a number that no comment names, or a
            picture that is damaged.
    """
    mesh.triangle_uvs = _uvs_of(path, mesh, columns, lengths, fans)
    if mesh.triangle_uvs is None:
        return
    named = [words[1] for words in (text.split(None, 1) for text in header.comments) if _is_picture(words)]
    if not named:
        return
    numbers = columns.get(_NUMBER)
    used, ids = np.zeros(1, np.int64), None
    if numbers is not None:
        assert not isinstance(numbers, ListColumn)
        bad = np.flatnonzero((numbers < 0) | (numbers >= len(named)))
        if len(bad):
            reason = f"a face has the texture {numbers[bad[0]]}, but {len(named)} are named"
            raise FileError(path, reason, where=f"face {int(bad[0])}")
        used, ids = np.unique(numbers, return_inverse=True)
    mesh.textures = read_textures(path, [named[number] for number in used], outside_files=outside_files)
    if mesh.textures and ids is not None and ids.any():
        mesh.triangle_material_ids = np.repeat(ids.astype(np.int32), lengths - 2)


def _is_picture(words: list[str]) -> bool:
    return len(words) == 2 and words[0] == _PICTURE


def _uvs_of(
    path: Any, mesh: MeshTable, columns: dict[str, Column], lengths: NDArray[np.int64], fans: NDArray[np.int64]
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
    """The properties of faces that hold the texture of a mesh, and the columns behind the corners that fill them."""
    if mesh.triangle_uvs is None:
        return [], []
    properties, columns = ["property list uchar float texcoord"], [np.broadcast_to(np.uint8(6), len(mesh.triangles))]
    columns += [*mesh.triangle_uvs.reshape(-1, 6).T]
    if mesh.triangle_material_ids is not None:
        properties.append("property int texnumber")
        columns.append(mesh.triangle_material_ids)
    return properties, columns
