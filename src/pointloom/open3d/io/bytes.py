"""Point clouds in memory, and the contents of files."""

from __future__ import annotations

import enum
import io
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from ...core.errors import FileError
from ...core.paths import path_of
from ...io.meshes.mesh_formats import MESH_READERS
from ...io.points.formats import READERS
from ...io.points.ply_header import read_header
from ...io.source import open_source
from ..geometry.point_cloud import PointCloud
from ..wrapper import unwrap
from .ply_elements import FilePath
from .shapes import read_point_cloud, write_point_cloud

PREFIX = "mem::"
IN_MEMORY = ("ply", "pcd", "xyz", "xyzn", "xyzrgb", "pts")


class FileGeometry(enum.IntFlag):
    """Contents of a file."""

    CONTENTS_UNKNOWN = 0
    CONTAINS_POINTS = 1
    CONTAINS_LINES = 2
    CONTAINS_TRIANGLES = 4
    CONTAINS_GAUSSIAN_SPLATS = 8


CONTENTS_UNKNOWN = FileGeometry.CONTENTS_UNKNOWN
CONTAINS_POINTS = FileGeometry.CONTAINS_POINTS
CONTAINS_LINES = FileGeometry.CONTAINS_LINES
CONTAINS_TRIANGLES = FileGeometry.CONTAINS_TRIANGLES
CONTAINS_GAUSSIAN_SPLATS = FileGeometry.CONTAINS_GAUSSIAN_SPLATS


def read_file_geometry_type(path: FilePath) -> FileGeometry:
    """Contents by suffix, and by the header of a .ply. Raises FileError for a missing or invalid .ply."""
    suffix = path_of(path).suffix.lower()
    if suffix == ".ply":
        return _in_ply(path_of(path))
    if suffix in MESH_READERS:
        return CONTAINS_TRIANGLES | CONTAINS_POINTS
    return CONTAINS_POINTS if suffix in READERS else CONTENTS_UNKNOWN


def _in_ply(path: Path) -> FileGeometry:
    elements = {element.name: element for element in read_header(path, open_source(path)).elements if element.count}
    if "face" in elements or "tristrips" in elements:
        return CONTAINS_TRIANGLES
    if "edge" in elements:
        return CONTAINS_LINES
    if "vertex" not in elements:
        return CONTENTS_UNKNOWN
    has_splats = any(prop.name == "f_dc_0" for prop in elements["vertex"].properties)
    return CONTAINS_POINTS | CONTAINS_GAUSSIAN_SPLATS if has_splats else CONTAINS_POINTS


def read_point_cloud_from_bytes(
    bytes: Any,
    format: str = "auto",
    remove_nan_points: bool = False,
    remove_infinite_points: bool = False,
    print_progress: bool = False,
) -> PointCloud:
    """Read a cloud from the content of a file, by the format "mem::xyz", "mem::ply" or another one.

    Raises FileError, whose path is "bytes".
    """
    suffix = _format(format)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"cloud.{suffix}")
        try:
            path.write_bytes(bytes)
        except TypeError as error:
            raise TypeError(f"bytes: expected the content of a file, got {type(bytes).__name__}") from error
        try:
            return read_point_cloud(path, "auto", remove_nan_points, remove_infinite_points)
        except FileError as error:
            reason = error.reason.replace(str(path), "bytes")
            raise FileError("bytes", reason, where=error.where, remedy=error.remedy) from error


def write_point_cloud_to_bytes(
    pointcloud: Any,
    format: str = "auto",
    write_ascii: bool = False,
    compressed: bool = False,
    print_progress: bool = False,
) -> bytes:
    """Content of a file of a cloud, by the format "mem::xyz", "mem::ply" or another one."""
    suffix = _format(format)
    if suffix == "xyz":
        text = io.BytesIO()
        np.savetxt(text, unwrap(pointcloud, PointCloud, "pointcloud").points, "%.10f")  # as in Open3D
        return text.getvalue()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, f"cloud.{suffix}")
        write_point_cloud(path, pointcloud, "auto", write_ascii, compressed)
        return path.read_bytes()


def _format(format: str) -> str:
    if not format.startswith(PREFIX) or format.removeprefix(PREFIX) not in IN_MEMORY:
        known = ", ".join(f'"{PREFIX}{name}"' for name in IN_MEMORY)
        raise ValueError(f'format: expected one of {known}, got "{format}"')
    return format.removeprefix(PREFIX)
