"""Point clouds from and to files, by extension."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from ..cloud import PointCloud
from ..errors import FileError
from ..point_arrays import VECTORS
from .formats import READERS, write_table
from .table import PointTable


def read_point_cloud(path: str | os.PathLike[str], *, device: Any = None) -> PointCloud:
    """Read a cloud with all its attributes: .ply .pcd .xyz .xyzn .xyzrgb .pts .npz.

    The readers are strict: a file that is truncated, has trailing bytes, or counts that do not fit its size is
    refused by name and place, before memory is taken for it; nothing is ever filled in.

    Args:
        path: The file.
        device: Where the cloud goes.

    Raises:
        FileError: The file cannot be read; says which byte or line, and why.
        DeviceError: No such device.

    Example:
        >>> import pointloom as loom
        >>> loom.write_point_cloud("scan.ply", loom.PointCloud([[0, 0, 0], [1, 2, 3]], intensity=[7.0, 8.0]))
        >>> loom.read_point_cloud("scan.ply")["intensity"].tolist()
        [7.0, 8.0]
    """
    return cloud_of(READERS[_extension(path)](path), path, device=device)


def cloud_of(table: PointTable, path: str | os.PathLike[str], *, device: Any = None) -> PointCloud:
    """The cloud of what was read from a file.

    Raises:
        FileError: An attribute with the name of an array that every cloud has.
        DeviceError: No such device.
    """
    cloud = PointCloud(table.points, normals=table.normals, colors=table.colors, device=device)
    for name, values in table.attributes.items():  # one by one: a file may call one "device" or "origin"
        if name in VECTORS:
            raise FileError(path, f"attribute {name!r} has the name of a cloud's own {name}", remedy="Rename it")
        cloud[name] = values
    cloud.grid = table.grid
    return cloud


def write_point_cloud(
    path: str | os.PathLike[str], cloud: PointCloud, *, ascii: bool = False, overwrite: bool = True
) -> None:
    """Write a cloud with all its attributes, whole or not at all; the extension gives the format.

    Coordinates of a cloud whose origin is zero are written in float32 as they are held; those of a moved origin in
    float64, so that nothing is lost.

    Args:
        path: The file: .ply .pcd .npz .xyz .xyzn .xyzrgb .pts.
        cloud: The cloud.
        ascii: Text instead of binary, for .ply and .pcd.
        overwrite: Whether an existing file may be replaced.

    Raises:
        FileError: The file cannot be made, or the format cannot hold an attribute.
        TypeError: No cloud.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[0, 0, 0], [1, 2, 3]], colors=[[1, 0, 0], [0, 1, 0]])
        >>> loom.write_point_cloud("scan.pcd", cloud)
        >>> len(loom.read_point_cloud("scan.pcd"))
        2
    """
    _extension(path)
    if not isinstance(cloud, PointCloud):
        raise TypeError(f"cloud: expected a PointCloud, got {type(cloud).__name__}")
    write_table(path, table_of(cloud), ascii=ascii, overwrite=overwrite)


def table_of(cloud: PointCloud) -> PointTable:
    """What a file of this cloud holds."""
    return PointTable(
        points=cloud.points if cloud.origin.any() else cloud.array("points").numpy(),
        normals=cloud.normals if cloud.has_normals else None,
        colors=cloud.colors if cloud.has_colors else None,
        attributes=dict(cloud.attributes),
        grid=cloud.grid,
    )


def _extension(path: str | os.PathLike[str]) -> str:
    extension = Path(path).suffix.lower()
    if extension not in READERS:
        known = " ".join(READERS)
        raise FileError(path, f"unknown extension {extension!r}", remedy=f"Use one of {known}")
    return extension
