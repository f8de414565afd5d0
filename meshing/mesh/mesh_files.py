"""Triangle meshes from and to files: PLY, OBJ, STL, OFF, GLB and glTF."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from ...core.devices import resolve_device
from ...core.errors import FileError
from ...core.paths import path_of
from ...files.meshes.mesh_formats import MESH_READERS, UPRIGHT, read_mesh, write_mesh
from ...files.source import content_errors
from ...files.table import MeshTable
from ...pcd.point_arrays import PointArrays
from .mesh import TriangleMesh


def read_triangle_mesh(
    path: str | os.PathLike[str], *, device: Any = None, up: str = "y", outside_files: bool = False
) -> TriangleMesh:
    """Read a triangle mesh; the extension names the format.

    Args:
        path: A .ply, .obj, .stl, .off, .glb or .gltf file, text or binary. Faces of more than three corners become
            triangles that cover them once (docs/meshes.md). Corners of an .stl that lie at exactly the same place
            become one vertex.
        device: Where to put it; "cpu" by default.
        up: Which axis is to be up in the mesh of a .glb or .gltf: "y" as the standard and the file have it, "z" as most
            clouds do.
        outside_files: Whether pictures and other files are read that a file names outside its own folder.

    Returns:
        The mesh with the vertex normals and colours of the file, its texture coordinates, and one texture for each
        material that triangles have: its picture, or a pixel of its colour; a picture of several materials is held
        once. (0, 0) is the lower left corner of a picture in every format. Meshes of a .glb or .gltf stand as they do
        at rest. Other values at vertices and of triangles are `vertex_attributes` and `triangle_attributes`. Normals
        of an .obj that are not one a vertex are left behind with a warning, textures where a picture is missing or
        lies outside the folder, and what else of a .glb or .gltf a mesh has no place for.

    Raises:
        FileError: Missing, damaged, without faces, or of a format that is not read; says the byte, line or row.
        DeviceError: No such device.
        ValueError: Another axis, or "z" of a file that is no .glb or .gltf.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> loom.write_triangle_mesh("mesh.ply", mesh)
        >>> loom.read_triangle_mesh("mesh.ply").vertices[1].tolist()
        [2.0, 0.0, 0.0]
    """
    suffix = path_of(path).suffix.lower()
    if suffix not in MESH_READERS:
        raise FileError(path, f"meshes are read from {', '.join(MESH_READERS)}, not from {suffix or 'no extension'}")
    where = resolve_device(device)
    table = read_mesh(path, up=up, outside_files=outside_files)
    mesh = mesh_of(table, path, device=where)
    mesh.up = up if suffix in UPRIGHT else None
    return mesh


def mesh_of(table: MeshTable, path: str | os.PathLike[str], *, device: Any = None) -> TriangleMesh:
    """The mesh of a table that was read from a file.

    Raises:
        FileError: Vertices too far apart for float32.
    """
    with content_errors(path):
        mesh = TriangleMesh(
            table.vertices,
            table.triangles,
            vertex_normals=table.vertex_normals,
            vertex_colors=table.vertex_colors,
            triangle_uvs=table.triangle_uvs,
            triangle_material_ids=table.triangle_material_ids,
            textures=table.textures,
            vertex_attributes=table.attributes,
            triangle_attributes=table.triangle_attributes,
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
    up: str = "y",
) -> None:
    """Write a triangle mesh; the extension names the format.

    Positions are written as float32 where the mesh has no origin, else as float64 with the origin added; STL holds
    float32 only, GLB float32 about a translation.

    Args:
        path: A .ply (binary unless `ascii`), .obj (text), .stl (binary), .off (text), .glb (binary) or .gltf (text)
            file; it appears whole or not at all. Textures of m.ply are written beside it as m_0.png, m_1.png, ...,
            those of m.obj and m.gltf as well, with m.mtl or m.bin; a .glb holds them. A texture of one pixel is a
            colour in an .mtl.
        mesh: The mesh. STL holds neither shared vertices nor normals nor colours at them, STL and OFF no textures,
            which are left out with a warning. GLB writes a vertex once for each texture coordinate that its corners
            have, and triangles in the order of their materials. Material numbers without textures do not come back
            from any. Further attributes are held by .ply, those of vertices by .glb and .gltf, colours of triangles by
            .off; other formats leave them out, with a warning.
        ascii: Text, for .ply.
        overwrite: Whether existing files may be replaced.
        write_vertex_normals: Whether vertex normals are written where the mesh has them.
        write_vertex_colors: Whether vertex colours are.
        write_triangle_uvs: Whether texture coordinates, material numbers and textures are.
        up: For .glb and .gltf: the axis that is up in the mesh, "y" or "z"; in the file it is y, by the standard.

    Raises:
        FileError: The place cannot be written, or the format cannot hold the mesh.
        ValueError: Text was asked of STL, OFF or GLB, a material number names no texture, or an axis that is none.
        TypeError: No mesh.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> loom.write_triangle_mesh("mesh.stl", mesh)
        >>> loom.write_triangle_mesh("mesh.obj", mesh)
    """
    suffix = path_of(path).suffix.lower()
    if not isinstance(mesh, TriangleMesh):
        remedy = "; write_point_cloud writes clouds" if isinstance(mesh, PointArrays) else ""
        raise TypeError(f"mesh: expected a TriangleMesh, got {type(mesh).__name__}{remedy}")
    if suffix not in MESH_READERS:
        raise FileError(path, f"meshes are written to {', '.join(MESH_READERS)}, not to {suffix or 'no extension'}")
    if ascii and suffix in (".stl", ".off", ".glb", ".gltf"):
        raise ValueError(f"ascii: {suffix[1:].upper()} is written in one form only")
    table = mesh_table(mesh)
    if not write_vertex_normals:
        table.vertex_normals = None
    if not write_vertex_colors:
        table.vertex_colors = None
    if not write_triangle_uvs:
        table.triangle_uvs, table.triangle_material_ids, table.textures = None, None, ()
    write_mesh(path, table, ascii=ascii, overwrite=overwrite, up=up)


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
        attributes=dict(mesh.vertex_attributes),
        triangle_attributes=dict(mesh.triangle_attributes),
        unit=mesh.unit,
    )
