"""Nodes of octrees from JSON, checked completely."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...core.errors import FileError
from ...core.json_files import check_keys, json_count, json_numbers
from ..geometry.octree_nodes import (
    CHILDREN,
    OctreeColorLeafNode,
    OctreeInternalNode,
    OctreeInternalPointNode,
    OctreePointColorLeafNode,
    made,
)
from .ply_elements import FilePath

MAX_DEPTH = 100  # levels: 53 halvings separate any two float64 corners, and each level nests two levels of JSON
MAX_INDEX = 2**31 - 1  # clouds have at most 2^31 points
TOLERANCE = 1e-3  # of colors in 0..1: they are averages in float32, as in `check_colors`

KINDS = {
    kind.__name__: (kind, keys)
    for kind, keys in (
        (OctreeInternalNode, {"class_name", "children"}),
        (OctreeInternalPointNode, {"class_name", "children", "indices"}),
        (OctreeColorLeafNode, {"class_name", "color"}),
        (OctreePointColorLeafNode, {"class_name", "color", "indices"}),
    )
}


def read_node(path: FilePath, value: Any, depth: int, where: str = "tree") -> Any:
    """A node with those below it, at most `depth` levels of children. None for an empty object.

    Raises FileError with the location `where` of the wrong value.
    """
    if value in (None, {}):
        return None
    if not isinstance(value, dict):
        raise FileError(path, f"expected an object, got a {type(value).__name__}", where=f"key {where}")
    name = value.get("class_name")
    if not isinstance(name, str) or name not in KINDS:
        reason = f"expected one of {', '.join(KINDS)}, got {str(name)[:40]!r}"
        raise FileError(path, reason, where=f"key {where}.class_name")
    kind, keys = KINDS[name]
    check_keys(path, value, required=keys, where=f"{where}.")
    fields: dict[str, Any] = {}
    if "children" in keys:
        fields["children"] = _read_children(path, value["children"], depth, f"{where}.children")
    else:
        fields["_color"] = _read_color(path, value["color"], f"key {where}.color")
    if "indices" in keys:
        fields["indices"] = _read_indices(path, value["indices"], f"key {where}.indices")
    return made(kind, **fields)


def _read_children(path: FilePath, values: Any, depth: int, where: str) -> list[Any]:
    if not isinstance(values, list) or len(values) != CHILDREN:
        given = f"{len(values)}" if isinstance(values, list) else f"a {type(values).__name__}"
        raise FileError(path, f"expected a list of {CHILDREN} nodes, got {given}", where=f"key {where}")
    if depth < 1:
        raise FileError(path, "expected a leaf, as max_depth is reached, got children", where=f"key {where}")
    return [read_node(path, child, depth - 1, f"{where}[{k}]") for k, child in enumerate(values)]


def _read_color(path: FilePath, values: Any, where: str) -> Any:
    color = np.array(json_numbers(path, values, 3, where=where))
    if not ((color >= -TOLERANCE) & (color <= 1 + TOLERANCE)).all():
        raise FileError(path, f"expected red, green and blue in 0..1, got {values}", where=where)
    return color


def _read_indices(path: FilePath, values: Any, where: str) -> list[int]:
    if values is None:  # Open3D's empty list
        return []
    if not isinstance(values, list):
        raise FileError(path, f"expected a list of integers, got a {type(values).__name__}", where=where)
    return [json_count(path, value, MAX_INDEX, where=where) for value in values]
