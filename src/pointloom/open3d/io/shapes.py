"""Files of clouds and meshes."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np

from ...core.errors import FilePath
from ...core.escaped_text import escaped
from ...core.paths import path_of
from ...io.meshes.stl import read_stl
from ...io.points import point_cloud
from ...io.points.ply_faces import STRIPS
from ...io.points.ply_header import read_header
from ...io.source import netted, open_source
from ...meshing.mesh import mesh_files
from ...meshing.mesh.mesh import TriangleMesh as NativeMesh
from ..argument_types import CloudLike, MeshLike
from ..geometry.point_cloud import PointCloud
from ..geometry.triangle_mesh import TriangleMesh
from ..wrapper import unwrap

# Columns of Open3D's text formats, for files with another suffix.
COLUMNS = {"xyz": ("x", "y", "z"), "xyzn": ("x", "y", "z", "nx", "ny", "nz"), "xyzrgb": ("x", "y", "z", "r", "g", "b")}

# Columns of Open3D's text formats besides the points. Other data of a cloud is not written.
TEXT_COLUMNS = {".xyz": (), ".xyzn": ("normals",), ".xyzrgb": ("colors",), ".pts": ("colors", "intensity")}

# Formats in which empty clouds and meshes are not written, as in Open3D.
OF_POINTS, OF_VERTICES = (".ply", ".pcd", ".xyz", ".xyzn", ".xyzrgb", ".pts"), (".ply", ".stl", ".off")

SAME_NORMAL = 1e-5  # distance of unit normals in an .stl up to which corners are one vertex, as in Open3D


def read_point_cloud(
    filename: FilePath,
    format: str = "auto",
    remove_nan_points: bool = False,
    remove_infinite_points: bool = False,
    print_progress: bool = False,
) -> PointCloud:
    """Like `loom.read_point_cloud`, including .las and .e57; `format="xyzrgb"` names the columns of a .txt file."""
    suffix = Path(filename).suffix.lower().lstrip(".")
    if format in ("auto", suffix):
        cloud = point_cloud.read_point_cloud(filename)
    elif format in COLUMNS and suffix in ("txt", "csv", "xyz"):
        cloud = point_cloud.read_point_cloud(filename, columns=COLUMNS[format])
    else:
        raise ValueError(f"format: expected a file that ends in .{format}, got {escaped(filename)}; rename it")
    if remove_nan_points or remove_infinite_points:
        cloud = cloud.remove_non_finite_points(remove_nan_points, remove_infinite_points)
    return PointCloud.from_native(cloud)


def write_point_cloud(
    filename: FilePath,
    pointcloud: CloudLike,
    format: str = "auto",
    write_ascii: bool = False,
    compressed: bool = False,
    print_progress: bool = False,
) -> bool:
    """Like `loom.write_point_cloud`. The suffix defines the format, and text formats write the columns they have.

    Returns False, with a warning, for an empty cloud in a format of Open3D, and writes no file.
    """
    _check_format(filename, format)
    cloud, suffix = unwrap(pointcloud, PointCloud, "pointcloud"), Path(filename).suffix.lower()
    if not len(cloud) and suffix in OF_POINTS:
        return _not_written(filename, "the cloud is empty")
    columns = TEXT_COLUMNS.get(suffix)
    left_out = [] if columns is None else [name for name in cloud.arrays if name not in ("points", *columns)]
    point_cloud.write_point_cloud(filename, cloud.without(*left_out), write_ascii=write_ascii)
    return True


def read_triangle_mesh(
    filename: FilePath, enable_post_processing: bool = False, print_progress: bool = False
) -> TriangleMesh:
    """Like `loom.read_triangle_mesh`, with Open3D's vertices of an .stl and of a .ply without faces.

    Coincident corners of an .stl are one vertex only if their facets have the same normal in the file, which becomes
    the vertex normal. A .ply without faces gives its vertices, with a warning.
    """
    return TriangleMesh.from_native(read_native_mesh(filename))


def read_native_mesh(filename: FilePath) -> NativeMesh:
    """The mesh of a file with Open3D's vertices."""
    suffix = path_of(filename).suffix.lower()
    if suffix == ".ply" and not _has_faces(filename):
        warnings.warn(escaped(f"{filename}: contains no faces; the mesh has vertices only"), UserWarning, stacklevel=3)
        return _vertices_of(point_cloud.read_point_cloud(filename))
    if suffix == ".stl":
        table = netted(read_stl)(filename, with_normals=True)
        return _split_at_edges(mesh_files.mesh_of(table, filename))
    return mesh_files.read_triangle_mesh(filename, up="y")


def write_triangle_mesh(
    filename: FilePath,
    mesh: MeshLike,
    write_ascii: bool = False,
    compressed: bool = False,
    write_vertex_normals: bool = True,
    write_vertex_colors: bool = True,
    write_triangle_uvs: bool = True,
    print_progress: bool = False,
) -> bool:
    """Like `loom.write_triangle_mesh`. An .stl needs no normals.

    Returns False, with a warning, for a mesh without vertices as .ply, .stl or .off, and writes no file.
    """
    native = unwrap(mesh, TriangleMesh, "mesh")
    if not len(native.vertices) and path_of(filename).suffix.lower() in OF_VERTICES:
        return _not_written(filename, "the mesh has no vertices")
    mesh_files.write_triangle_mesh(
        filename,
        native,
        write_ascii=write_ascii,
        write_vertex_normals=write_vertex_normals,
        write_vertex_colors=write_vertex_colors,
        write_triangle_uvs=write_triangle_uvs,
        up="y",  # Open3D does not rotate
    )
    return True


def _check_format(filename: FilePath, format: str) -> None:
    if format != "auto" and Path(filename).suffix.lower() != f".{format}":
        raise ValueError(f"format: expected a name that ends in .{format}, got {escaped(filename)}")


def _not_written(filename: FilePath, reason: str) -> bool:
    warnings.warn(escaped(f"{filename}: not written, {reason}"), UserWarning, stacklevel=3)
    return False


def _has_faces(filename: FilePath) -> bool:
    """True if a .ply has triangles."""
    header = read_header(filename, open_source(filename))
    return any(element.count and element.name in ("face", STRIPS) for element in header.elements)


def _vertices_of(cloud: Any) -> NativeMesh:
    """A mesh of the points of a cloud, without triangles."""
    parts = {f"vertex_{name}": getattr(cloud, name) for name in ("normals", "colors") if name in cloud}
    return NativeMesh(cloud.points, vertex_attributes=cloud.attributes, device=cloud.device, **parts)


def _split_at_edges(mesh: NativeMesh) -> NativeMesh:
    """A mesh with a vertex for each normal of the facets around a vertex, in the order of the facets. NaN normals are
    equal."""
    normals, corners = mesh.triangle_attributes["normals"], mesh.triangles.reshape(-1)
    compared = np.nan_to_num(normals, nan=0.0)
    group = np.arange(len(corners))  # of each corner: the first one of its vertex
    rest = np.argsort(corners, kind="stable")
    while len(rest):
        is_first = np.diff(corners[rest], prepend=-1) != 0  # of the rest at its vertex
        leaders = rest[is_first][np.cumsum(is_first) - 1]
        is_same = ((compared[rest // 3] - compared[leaders // 3]) ** 2).sum(axis=1) <= SAME_NORMAL**2
        group[rest[is_same]] = leaders[is_same]
        rest = rest[~is_same]
    first, rank = np.unique(group, return_inverse=True)
    made = NativeMesh(
        mesh.vertices[corners[first]],
        rank.reshape(-1, 3),
        vertex_normals=normals[first // 3],
        triangle_attributes={name: v for name, v in mesh.triangle_attributes.items() if name != "normals"},
        device=mesh.device,
        origin=mesh.origin,
    )
    made.unit, made.crs = mesh.unit, mesh.crs
    return made
