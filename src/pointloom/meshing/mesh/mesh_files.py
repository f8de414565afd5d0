"""Read and write triangle meshes in the formats of io/meshes/mesh_formats.py."""

from __future__ import annotations

import os
from typing import Any

from ...core.array_libraries import library_for
from ...core.coordinate_systems import is_in_degrees
from ...core.coordinates import choose_origin, lengths_of_axes, warn_if_rounded
from ...core.devices import DeviceLike, resolve_device
from ...core.errors import CLOUD_REMEDY, FileError
from ...core.other_geometry import conversion_of, is_other
from ...core.paths import path_of, recording_remedy
from ...io.meshes.by_extension import read_mesh, write_mesh
from ...io.meshes.mesh_formats import MESH_FORMATS
from ...io.points.formats import CLOUD_FORMATS
from ...io.source import content_errors
from ...io.table import MeshTable
from ...pcd.point_arrays import PointArrays
from .conversion import mesh_table
from .mesh import TriangleMesh


def read_triangle_mesh(
    path: str | os.PathLike[str],
    *,
    device: DeviceLike = None,
    up: str | None = None,
    outside_files: bool = False,
    arrays: str | None = None,
) -> TriangleMesh:
    """Read a triangle mesh. The extension determines the format.

    Args:
        path: The file, text or binary (formats: docs/files.md). Polygons are triangulated (docs/meshes.md). Coincident
            corners of an .stl are merged.
        device: Target device, "cpu" by default.
        up: Up axis of a mesh from .glb or .gltf: "y" as in the file, or "z". None: the up direction of the mesh that
            `write_triangle_mesh` rotated, else "y".
        outside_files: Read images and other files outside the file's own folder.
        arrays: Library of returned arrays, as of `TriangleMesh`. If None: "numpy".

    Returns:
        The mesh with normals, colors, texture coordinates, other attributes, and one texture per used material (an
        image or a pixel of its color). (0, 0) is the lower left corner in every format. Unsupported data, missing
        textures and .obj normals that are not per vertex are dropped with a warning.

    Raises:
        FileError: If the file is missing, damaged, without faces or of an unknown format; includes byte, line or row.
        DeviceError, ValueError: If the device does not exist, or if `up` is invalid, or "z" for another format.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> loom.write_triangle_mesh("mesh.ply", mesh)
        >>> loom.read_triangle_mesh("mesh.ply").vertices[1].tolist()
        [2.0, 0.0, 0.0]
    """
    suffix = path_of(path).suffix.lower()
    if suffix not in MESH_FORMATS:
        reason = f"meshes are read from {', '.join(MESH_FORMATS)}, not from {suffix or 'no extension'}"
        remedy = CLOUD_REMEDY if suffix in CLOUD_FORMATS else recording_remedy(path, "scans()")
        raise FileError(path, reason, remedy=remedy)
    where, library = resolve_device(device), library_for(arrays)
    table = read_mesh(path, up=up, outside_files=outside_files)
    mesh = mesh_of(table, path, device=where, arrays=library)
    return mesh


def mesh_of(
    table: MeshTable, path: str | os.PathLike[str], *, device: DeviceLike = None, arrays: str | None = None
) -> TriangleMesh:
    """Mesh of a table read from a file. FileError if vertices are too far apart for float32."""
    with content_errors(path):
        in_degrees = is_in_degrees(table.unit, table.crs)
        mesh = TriangleMesh(
            table.vertices,
            table.triangles,
            origin=choose_origin(table.vertices, in_degrees=True) if in_degrees else None,
            vertex_normals=table.vertex_normals,
            vertex_colors=table.vertex_colors,
            triangle_uvs=table.triangle_uvs,
            triangle_material_ids=table.triangle_material_ids,
            textures=table.textures,
            vertex_attributes=table.attributes,
            triangle_attributes=table.triangle_attributes,
            device=device,
            arrays=arrays,
        )
    mesh.unit, mesh.crs, mesh.up = table.unit, table.crs, table.up
    meters = None if table.unit is None else table.unit.meters
    warn_if_rounded(path, table.vertices, mesh.origin, None, lengths_of_axes(meters, in_degrees=in_degrees))
    return mesh


def write_triangle_mesh(
    path: str | os.PathLike[str],
    mesh: TriangleMesh,
    *,
    write_ascii: bool = False,
    overwrite: bool = True,
    write_vertex_normals: bool = True,
    write_vertex_colors: bool = True,
    write_triangle_uvs: bool = True,
    up: str | None = None,
) -> None:
    """Write a triangle mesh. The extension determines the format.

    Positions are float32 without an origin, else float64 with the origin added. GLB uses a translation.

    Args:
        path: The file, written atomically (formats: docs/files.md). Textures of m.ply, m.obj and m.gltf are written
            as m_0.png, m_1.png, ..., with m.mtl or m.bin. A .glb contains them.
        mesh: The mesh, or one of another library, see `from_any`. Data that the format cannot store is dropped with a
            warning: STL has no vertex data, STL and OFF no textures, and only .ply, .vtk and .vtp all attributes (.glb
            and .gltf those of vertices, .off triangle colors). GLB duplicates vertices at texture seams and sorts
            triangles by material.
        write_ascii: Text instead of binary, for .ply and .vtk. Files of .obj, .off and .gltf are always text.
        overwrite: Allow replacing existing files.
        write_vertex_normals, write_vertex_colors: Write these arrays if the mesh has them.
        write_triangle_uvs: Write texture coordinates, material ids and textures.
        up: For .glb and .gltf, where y is up: up axis of the mesh, "y" or "z", which is rotated to y. None: `mesh.up`,
            which `read_triangle_mesh` restores, or z of a mesh with a coordinate system, else "y".

    Raises:
        FileError: If the file cannot be written, or the format cannot store the mesh.
        ValueError: If text is requested for a binary format, a material id has no texture, or `up` is invalid.
        TypeError: If `mesh` is not a mesh.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> loom.write_triangle_mesh("mesh.stl", mesh)
        >>> loom.write_triangle_mesh("mesh.obj", mesh)
    """
    suffix = path_of(path).suffix.lower()
    given: Any = mesh
    mesh = TriangleMesh(given) if is_other(given) else mesh
    if not isinstance(mesh, TriangleMesh):
        remedy = "; write_point_cloud writes clouds" if isinstance(mesh, PointArrays) else ""
        raise TypeError(f"mesh: expected a TriangleMesh, got {type(mesh).__name__}{remedy or conversion_of(mesh)}")
    if suffix not in MESH_FORMATS:
        raise FileError(path, f"meshes are written to {', '.join(MESH_FORMATS)}, not to {suffix or 'no extension'}")
    if write_ascii and MESH_FORMATS[suffix].encoding == "binary":
        raise ValueError(f"write_ascii: {MESH_FORMATS[suffix].name} has only one encoding")
    table = mesh_table(mesh)
    if not write_vertex_normals:
        table.vertex_normals = None
    if not write_vertex_colors:
        table.vertex_colors = None
    if not write_triangle_uvs:
        table.triangle_uvs, table.triangle_material_ids, table.textures = None, None, ()
    write_mesh(path, table, ascii=write_ascii, overwrite=overwrite, up=up)
