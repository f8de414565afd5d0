"""Wavefront OBJ, written as text: vertices (with colours as x y z r g b), vertex normals and triangles.

Not held: attributes (refused) and float64 types (values are written with digits enough to read back the same).

Source: Wavefront's "Object Files (.obj)", with the vertex colours that MeshLab and Blender added.
"""

from __future__ import annotations

import os

import numpy as np

from ..errors import FileError
from .ascii_rows import row_format, write_rows
from .atomic import atomic_write, check_writable
from .table import MeshTable


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
