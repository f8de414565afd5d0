"""Files of clouds of tensors: all attributes in the types of the file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from ....core.errors import FileError, FilePath
from ....core.escaped_text import escaped
from ....io.columns import warn_left_out
from ....io.meshes.tables import write_cloud_table
from ....io.points.by_extension import read_points
from ....io.points.formats import CLOUD_FORMATS, WRITTEN
from ....io.points.pcd import warn_of_viewpoint
from ....io.points.ply_header import read_header
from ....io.source import open_source
from ....io.table import PointTable
from ...core.tensor import Tensor
from ...io.shapes import COLUMNS, TEXT_COLUMNS
from ..geometry.point_cloud import PointCloud
from .attributes import set_attribute


def read_point_cloud(
    filename: FilePath,
    format: str = "auto",
    remove_nan_points: bool = False,
    remove_infinite_points: bool = False,
    print_progress: bool = False,
) -> PointCloud:
    """Read a cloud on the CPU: all formats of `loom.read_point_cloud`, `format` as in `o3d.io.read_point_cloud`.

    Attributes of one column have shape (n, 1). Colors are uint8 if the file has bytes, else float32 in 0..1.
    """
    suffix = Path(filename).suffix.lower()
    if format not in ("auto", suffix.lstrip("."), *COLUMNS):
        raise ValueError(f"format: expected a file that ends in .{format}, got {escaped(filename)}; rename it")
    if suffix not in CLOUD_FORMATS:
        raise FileError(
            filename, f"unknown extension {suffix!r}", remedy=f"Clouds are read from {' '.join(CLOUD_FORMATS)}"
        )
    table = read_points(filename, None if format in ("auto", suffix.lstrip(".")) else COLUMNS[format])
    warn_of_viewpoint(filename, table.viewpoint, stacklevel=3)
    cloud = PointCloud(Tensor(table.points))
    if table.normals is not None:
        cloud.point.normals = table.normals.astype(table.points.dtype)
    if table.colors is not None:
        cloud.point.colors = np.rint(table.colors * 255).astype(np.uint8) if _has_bytes(filename) else table.colors
    for given, values in table.attributes.items():
        name = "intensities" if suffix == ".pts" and given == "intensity" else given  # as in Open3D
        if name in cloud.point:
            raise FileError(filename, f"expected one attribute of each name, got {name!r} twice")
        set_attribute(
            filename, cloud.point, name, np.ascontiguousarray(values[:, None] if values.ndim == 1 else values)
        )
    if remove_nan_points or remove_infinite_points:
        cloud, _ = cloud.remove_non_finite_points(remove_nan_points, remove_infinite_points)
    return cloud


def write_point_cloud(
    filename: FilePath,
    pointcloud: PointCloud,
    write_ascii: bool = False,
    compressed: bool = False,
    print_progress: bool = False,
) -> bool:
    """Write a cloud as `loom.write_point_cloud`: colors as bytes. The suffix defines the format.

    Text formats write the columns they have. Warns of attributes that another format cannot store.
    """
    if not isinstance(pointcloud, PointCloud):
        raise TypeError(f"pointcloud: expected a t.geometry.PointCloud, got {type(pointcloud).__name__}")
    suffix = Path(filename).suffix.lower()
    if suffix not in WRITTEN:
        raise FileError(filename, f"unknown extension {suffix!r}", remedy=f"Clouds are written as {' '.join(WRITTEN)}")
    arrays = {name: tensor.numpy() for name, tensor in pointcloud.point.items()}
    points = arrays.pop("positions", np.zeros((0, 3), np.float32))
    normals, colors = arrays.pop("normals", None), arrays.pop("colors", None)
    if suffix == ".pts" and "intensities" in arrays:
        arrays["intensity"] = arrays.pop("intensities")
    if colors is not None and colors.dtype.kind == "u":
        colors = colors / np.float32(np.iinfo(colors.dtype).max)
    others = {name: values.reshape(len(values), -1) for name, values in arrays.items()}
    flat = {name: values[:, 0] if values.shape[1:] == (1,) else values for name, values in others.items()}
    floats = points if points.dtype.kind == "f" else points.astype(np.float64)
    left_out = write_cloud_table(filename, PointTable(floats, normals, colors, flat), as_text=write_ascii)
    if suffix not in TEXT_COLUMNS:
        warn_left_out(filename, suffix, left_out)
    return True


def _has_bytes(filename: FilePath) -> bool:
    """True if the file stores colors as bytes."""
    suffix = Path(filename).suffix.lower()
    if suffix != ".ply":
        return suffix in (".pcd", ".pts")
    properties: Any = read_header(filename, open_source(filename)).element(filename, "vertex").properties
    return all(part.dtype == np.uint8 for part in properties if part.name in ("red", "diffuse_red"))
