"""Triangle meshes from and to files: PLY, OBJ, STL, OFF and GLB."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np

from ...core.errors import FileError
from ...files.meshes.mesh_formats import MESH_READERS, write_mesh
from ...files.table import MeshTable
from .mesh import TriangleMesh


def read_triangle_mesh(path: str | os.PathLike[str], *, device: Any = None) -> TriangleMesh:
    """Read a triangle mesh; the extension names the format.

    Args:
        path: A .ply, .obj, .stl, .off or .glb file, text or binary. Faces of more than three corners become fans of
            triangles. Corners of an .stl that lie at exactly the same place become one vertex.
        device: Where to put it; "cpu" by default.

    Returns:
        The mesh with the vertex normals and colours of the file, its texture coordinates, and one texture a material:
        its picture, or a pixel of its colour. Pictures of .ply and .obj lie beside them. (0, 0) is the lower left
        corner of a picture in every format. Other values at vertices are left behind, and so are normals of an .obj
        that are not one a vertex, with a warning. Where a picture is missing, textures are left behind with a warning.

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
    if suffix not in MESH_READERS:
        raise FileError(path, f"meshes are read from {', '.join(MESH_READERS)}, not from {suffix or 'no extension'}")
    table = MESH_READERS[suffix](path)
    mesh = TriangleMesh(
        table.vertices,
        table.triangles,
        vertex_normals=table.vertex_normals,
        vertex_colors=table.vertex_colors,
        triangle_uvs=table.triangle_uvs,
        triangle_material_ids=table.triangle_material_ids,
        textures=table.textures,
        device=device,
    )
    mesh.unit = table.unit
    return mesh


def write_triangle_mesh(
    path: str | os.PathLike[str],
    mesh: TriangleMesh,
    *,
    ascii: bool = False,
    overwrite: bool = True,
    write_vertex_normals: bool = True,
    write_vertex_colors: bool = True,
    write_triangle_uvs: bool = True,
) -> None:
    """Write a triangle mesh; the extension names the format.

    Positions are written as float32 where the mesh has no origin, else as float64 with the origin added; STL holds
    float32 only, GLB float32 about a translation.

    Args:
        path: A .ply (binary unless `ascii`), .obj (text), .stl (binary), .off (text) or .glb (binary) file; it appears
            whole or not at all. Textures of m.ply are written beside it as m_0.png, m_1.png, ..., those of m.obj as
            well, with m.mtl; a .glb holds them. A texture of one pixel is a colour in an .mtl.
        mesh: The mesh. STL holds neither shared vertices nor normals nor colours at them, and refuses the last; STL and
            OFF refuse textures. GLB writes a vertex once for each texture coordinate that its corners have, and
            triangles in the order of their materials. Material numbers without textures do not come back from any.
        ascii: Text, for .ply.
        overwrite: Whether existing files may be replaced.
        write_vertex_normals: Whether vertex normals are written where the mesh has them.
        write_vertex_colors: Whether vertex colours are.
        write_triangle_uvs: Whether texture coordinates, material numbers and textures are.

    Raises:
        FileError: The place cannot be written, or the format cannot hold the mesh.
        ValueError: Text was asked of STL, OFF or GLB, or a material number names no texture.
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
    if suffix not in MESH_READERS:
        raise FileError(path, f"meshes are written to {', '.join(MESH_READERS)}, not to {suffix or 'no extension'}")
    if ascii and suffix in (".stl", ".off", ".glb"):
        raise ValueError(f"ascii: {suffix[1:].upper()} is written in one form only")
    table = mesh_table(mesh)
    if not write_vertex_normals:
        table.vertex_normals = None
    if not write_vertex_colors:
        table.vertex_colors = None
    if not write_triangle_uvs:
        table.triangle_uvs, table.triangle_material_ids, table.textures = None, None, ()
    write_mesh(path, table, ascii=ascii, overwrite=overwrite)


def mesh_table(mesh: TriangleMesh) -> MeshTable:
    """A mesh as files have it: positions in float32 where it has no origin, else in float64 with the origin added."""
    return MeshTable(
        mesh.vertices if mesh.origin.any() else mesh.vertices.astype(np.float32),
        mesh.triangles,
        mesh.vertex_normals,
        mesh.vertex_colors,
        triangle_uvs=mesh.triangle_uvs,
        triangle_material_ids=mesh.triangle_material_ids,
        textures=mesh.textures,
        unit=mesh.unit,
    )
