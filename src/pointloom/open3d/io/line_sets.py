"""Files of line sets: PLY with the elements `vertex` and `edge`, as Open3D writes them."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..geometry.line_set import LineSet
from ..vectors import Vector2iVector, Vector3dVector
from .ply_elements import (
    FilePath,
    check_ply,
    color_columns,
    colors_of,
    integers_of,
    numbers_of,
    read_elements,
    write_elements,
)


def read_line_set(filename: FilePath, format: str = "auto", print_progress: bool = False) -> LineSet:
    """Read a .ply of points and lines, with the lines' colors. Raises FileError."""
    path = check_ply(filename, format)
    elements = read_elements(path, "vertex", "edge")
    points = numbers_of(path, elements, "vertex", "x", "y", "z")
    ends = integers_of(path, elements, "edge", "vertex1", "vertex2", low=0, high=len(points) - 1)
    made = LineSet(Vector3dVector(points), Vector2iVector(ends))
    colors = colors_of(path, elements, "edge")
    if colors is not None:
        made.colors = Vector3dVector(colors)
    return made


def write_line_set(
    filename: FilePath,
    line_set: object,
    write_ascii: bool = False,
    compressed: bool = False,
    print_progress: bool = False,
) -> bool:
    """Write a .ply with 8-bit colors."""
    if not isinstance(line_set, LineSet):
        raise TypeError(f"line_set: expected a LineSet, got {type(line_set).__name__}")
    points: dict[str, Any] = dict(zip("xyz", np.array(line_set.points).T, strict=True))
    edges: dict[str, Any] = dict(zip(("vertex1", "vertex2"), np.array(line_set.lines).T, strict=True))
    if line_set.has_colors():
        edges |= color_columns(np.array(line_set.colors))
    write_elements(check_ply(filename), {"vertex": points, "edge": edges}, ascii=write_ascii)
    return True
