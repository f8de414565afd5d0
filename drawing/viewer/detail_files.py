"""What a tree of detail takes from a file: a first look at it, and the columns of its parts."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count
from ...core.coordinates import quiet
from ...core.errors import FileError
from ...core.paths import path_of
from ...files.points.in_parts import open_in_parts
from ...files.table import PointTable
from ...pcd.cloud import PointCloud


def sample_file(path: str | os.PathLike[str], count: int) -> PointCloud | None:
    """A first look at a file: points taken evenly from it, while its tree is built.

    Args:
        path: The file.
        count: Points at most.

    Returns:
        The cloud; None where the file can only be read whole.

    Raises:
        FileError: The file cannot be read.
        TypeError, ValueError: A count that is no whole number from 1.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.drawing.viewer.detail_files import sample_file
        >>> loom.write_point_cloud("scan.ply", loom.PointCloud(np.random.default_rng(0).random((1000, 3))))
        >>> sample_file("scan.ply", 10)
        PointCloud(10 points, no attributes, cpu)
    """
    path, count = path_of(path), check_count("count", count)
    file = open_in_parts(path)
    if file is None:
        return None
    table = file.sample(count)
    return PointCloud(table.points, colors=table.colors, device="cpu", origin=file.origin(), unit=file.unit)


@quiet()
def columns_of(
    path: Any, part: PointTable, origin: NDArray[np.float64], attributes: Sequence[str]
) -> dict[str, NDArray[Any]]:
    """The columns of a part that a tree keeps: positions about an origin, colours as bytes, attributes after a dot.

    Raises:
        FileError: No attribute of a name.
    """
    columns: dict[str, NDArray[Any]] = {"positions": (part.points - origin).astype(np.float32)}
    if part.colors is not None:
        columns["colors"] = to_bytes(part.colors)
    for name in attributes:
        if name not in part.attributes:
            raise no_attribute(path, name, list(part.attributes))
        columns["." + name] = part.attributes[name]
    return columns


def no_attribute(path: Any, name: str, known: list[str]) -> FileError:
    """The error where a file has no attribute of a name; says which it has."""
    return FileError(path, f"has no attribute {name!r}", remedy=f"It has {', '.join(known) or 'none'}")


def bytes_at(colors: NDArray[np.float32], indices: NDArray[np.int64]) -> NDArray[np.uint8]:
    """The colours of some points, uint8 [k, 3]."""
    return to_bytes(colors[indices])


@quiet()
def to_bytes(colors: NDArray[Any]) -> NDArray[np.uint8]:
    """Colours of 0 to 1 as bytes; those beyond are clipped, and NaN is 0."""
    return np.rint(np.clip(np.nan_to_num(colors), 0, 1) * np.float32(255)).astype(np.uint8)
