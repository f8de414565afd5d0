"""Reading of files for level-of-detail trees: a first sample and columns of parts."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count
from ...core.coordinates import quiet
from ...core.errors import FileError, FilePath
from ...core.paths import path_of
from ...io.points.in_parts import open_in_parts
from ...io.table import PointTable
from ...pcd.cloud import PointCloud


def sample_file(path: str | os.PathLike[str], count: int) -> PointCloud | None:
    """Read an even sample of a file, see `DetailTree.sample`."""
    path, count = path_of(path), check_count("count", count)
    file = open_in_parts(path)
    if file is None:
        return None
    table = file.sample(count)
    return PointCloud(table.points, colors=table.colors, device="cpu", origin=file.origin(), unit=file.unit)


@quiet()
def columns_of(
    path: FilePath, part: PointTable, origin: NDArray[np.float64], attributes: Sequence[str]
) -> dict[str, NDArray[Any]]:
    """Columns of a part for a tree: positions relative to an origin, uint8 colors, attributes prefixed by a dot."""
    columns: dict[str, NDArray[Any]] = {"positions": (part.points - origin).astype(np.float32)}
    if part.colors is not None:
        columns["colors"] = to_bytes(part.colors)
    for name in attributes:
        if name not in part.attributes:
            raise no_attribute(path, name, list(part.attributes))
        columns["." + name] = part.attributes[name]
    return columns


def no_attribute(path: Any, name: str, known: list[str]) -> FileError:
    return FileError(path, f"has no attribute {name!r}", remedy=f"It has {', '.join(known) or 'none'}")


def bytes_at(colors: NDArray[np.float32], indices: NDArray[np.int64]) -> NDArray[np.uint8]:
    return to_bytes(colors[indices])


@quiet()
def to_bytes(colors: NDArray[Any]) -> NDArray[np.uint8]:
    """Colors from 0 to 1 as uint8; clipped, NaN is 0."""
    return np.rint(np.clip(np.nan_to_num(colors), 0, 1) * np.float32(255)).astype(np.uint8)
