"""Triangle meshes from and to files: PLY, OBJ and STL."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np

from ..pcd.errors import FileError
from ..pcd.io import obj, ply, stl
from ..pcd.io.table import MeshTable
from .mesh import TriangleMesh

_READERS = {".ply": ply.read_ply_mesh, ".obj": obj.read_obj, ".stl": stl.read_stl}
_WRITTEN = (".ply", ".obj", ".stl")


def read_triangle_mesh(path: str | os.PathLike[str], *, device: Any = None) -> TriangleMesh:
    """Read a triangle mesh; the extension names the format.

    Args:
        path: A .ply, .obj or .stl file, text or binary. Faces of more than three corners become fans of triangles.
            Corners of an .stl that lie at exactly the same place become one vertex.
        device: Where to put it; "cpu" by default.

    Returns:
        The mesh with the vertex normals and colours of the file; other values at vertices are left behind, and so are
        normals of an .obj that are not one a vertex, with a warning.

    Raises:
        FileError: Missing, damaged, without faces, or of a format that is not read; says the byte, line or row.
        DeviceError: No such device.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> loom.write_triangle_mesh("mesh.ply", mesh)
        >>> loom.read_triangle_mesh("mesh.ply").vertices[1].tolist()
        [2.0, 0.0, 0.0]
    """
    suffix = Path(path).suffix.lower()
    if suffix not in _READERS:
        raise FileError(path, f"meshes are read from {', '.join(_READERS)}, not from {suffix or 'no extension'}")
    table = _READERS[suffix](path)
    extras = {"vertex_normals": table.vertex_normals, "vertex_colors": table.vertex_colors}
    return TriangleMesh(table.vertices, table.triangles, device=device, **extras)


def write_triangle_mesh(
    path: str | os.PathLike[str], mesh: TriangleMesh, *, ascii: bool = False, overwrite: bool = True
) -> None:
    """Write a triangle mesh; the extension names the format.

    Positions are written as float32 where the mesh has no origin, else as float64 with the origin added; STL holds
    float32 only.

    Args:
        path: A .ply (binary unless `ascii`), .obj (text) or .stl (binary) file; it appears whole or not at all.
        mesh: The mesh. STL holds neither shared vertices nor normals nor colours at them, and refuses the last.
        ascii: Text, for .ply.
        overwrite: Whether an existing file may be replaced.

    Raises:
        FileError: The place cannot be written, or the format cannot hold the mesh.
        ValueError: Text was asked of STL.
        TypeError: No mesh.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> loom.write_triangle_mesh("mesh.stl", mesh)
        >>> loom.write_triangle_mesh("mesh.obj", mesh)
    """
    suffix = Path(path).suffix.lower()
    if not isinstance(mesh, TriangleMesh):
        raise TypeError(f"mesh: expected a TriangleMesh, got {type(mesh).__name__}")
    vertices = mesh.vertices if mesh.origin.any() else mesh.vertices.astype(np.float32)
    table = MeshTable(vertices, mesh.triangles, mesh.vertex_normals, mesh.vertex_colors)
    if suffix == ".ply":
        ply.write_ply_mesh(path, table, ascii=ascii, overwrite=overwrite)
    elif suffix == ".obj":
        obj.write_obj(path, table, overwrite=overwrite)
    elif suffix == ".stl":
        if ascii:
            raise ValueError("ascii: STL is written in its binary form only")
        stl.write_stl(path, table, overwrite=overwrite)
    else:
        raise FileError(path, f"meshes are written to {', '.join(_WRITTEN)}, not to {suffix or 'no extension'}")
