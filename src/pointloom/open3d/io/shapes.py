"""Files of clouds and meshes."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from ...io.points import point_cloud
from ...meshing.mesh import mesh_files
from ..geometry.point_cloud import PointCloud
from ..geometry.triangle_mesh import TriangleMesh
from ..wrapper import unwrap

FilePath = str | os.PathLike[str]

# Columns of Open3D's text formats, for files with another suffix.
COLUMNS = {"xyz": ("x", "y", "z"), "xyzn": ("x", "y", "z", "nx", "ny", "nz"), "xyzrgb": ("x", "y", "z", "r", "g", "b")}

# Columns of Open3D's text formats besides the points. Other data of a cloud is not written.
TEXT_COLUMNS = {".xyz": (), ".xyzn": ("normals",), ".xyzrgb": ("colors",), ".pts": ("colors", "intensity")}


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
        raise ValueError(f"format: expected a file that ends in .{format}, got {filename}; rename it")
    if remove_nan_points or remove_infinite_points:
        cloud = cloud.remove_non_finite_points(remove_nan_points, remove_infinite_points)
    return PointCloud._of(cloud)


def write_point_cloud(
    filename: FilePath,
    pointcloud: Any,
    format: str = "auto",
    write_ascii: bool = False,
    compressed: bool = False,
    print_progress: bool = False,
) -> bool:
    """Like `loom.write_point_cloud`. The suffix defines the format, and text formats write the columns they have."""
    _check_format(filename, format)
    cloud = unwrap(pointcloud, PointCloud, "pointcloud")
    columns = TEXT_COLUMNS.get(Path(filename).suffix.lower())
    left_out = [] if columns is None else [name for name in cloud._device_arrays if name not in ("points", *columns)]
    point_cloud.write_point_cloud(filename, cloud.without(*left_out), ascii=write_ascii)
    return True


def read_triangle_mesh(
    filename: FilePath, enable_post_processing: bool = False, print_progress: bool = False
) -> TriangleMesh:
    return TriangleMesh._of(mesh_files.read_triangle_mesh(filename))


def write_triangle_mesh(
    filename: FilePath,
    mesh: Any,
    write_ascii: bool = False,
    compressed: bool = False,
    write_vertex_normals: bool = True,
    write_vertex_colors: bool = True,
    write_triangle_uvs: bool = True,
    print_progress: bool = False,
) -> bool:
    mesh_files.write_triangle_mesh(
        filename,
        unwrap(mesh, TriangleMesh, "mesh"),
        ascii=write_ascii,
        write_vertex_normals=write_vertex_normals,
        write_vertex_colors=write_vertex_colors,
        write_triangle_uvs=write_triangle_uvs,
    )
    return True


def _check_format(filename: FilePath, format: str) -> None:
    if format != "auto" and Path(filename).suffix.lower() != f".{format}":
        raise ValueError(f"format: expected a name that ends in .{format}, got {filename}")
