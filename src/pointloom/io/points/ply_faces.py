"""Attributes of PLY faces (colors and scalars, repeated for all triangles of a polygon), and triangle strips.

-1 starts a new strip in `tristrips`. Triangles with a repeated vertex join strips and are dropped. Greg Turk's
"ply2ply" and the Stanford range scans for strips. VCGlib for face colors.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError, FilePath
from ..attribute_names import NameRules, is_word, split_columns
from ..columns import check_name, check_types, colors_or_loss, colors_to_bytes, narrow_attributes, own, warn_of_loss
from .ply_header import TYPE_NAMES, PlyHeader
from .ply_rows import Column, ListColumn

STRIPS = "tristrips"
_COLORS = ("red", "green", "blue")
_ALPHA = "alpha"

# Face properties that are no attributes.
_CORNERS = ("vertex_indices", "vertex_index")
_TEXTURE = ("texcoord", "texnumber")


def strip_triangles(path: FilePath, strips: ListColumn, vertex_count: int) -> NDArray[np.int64]:
    values = strips.values.astype(np.int64)
    bad = np.flatnonzero((values < -1) | (values >= vertex_count))
    row_of = np.repeat(np.arange(len(strips.lengths)), strips.lengths)
    if len(bad):
        reason = f"a strip refers to vertex {values[bad[0]]}, but there are {vertex_count} vertices"
        raise FileError(path, reason, where=f"strip {row_of[bad[0]]}")
    index = np.arange(len(values))
    begins = np.ones(len(values), bool)
    begins[1:] = (row_of[1:] != row_of[:-1]) | (values[:-1] < 0)
    within = index - np.maximum.accumulate(np.where(begins, index, 0))  # position within its strip
    third = np.flatnonzero((within >= 2) & (values >= 0))
    rows = np.stack([values[third - 2], values[third - 1], values[third]], axis=1)
    odd = within[third] % 2 == 1
    rows[odd] = rows[odd][:, [1, 0, 2]]
    return rows[(rows[:, 0] != rows[:, 1]) & (rows[:, 1] != rows[:, 2]) & (rows[:, 2] != rows[:, 0])]


def triangle_attributes(
    path: FilePath, columns: Mapping[str, Column], lengths: NDArray[np.int64]
) -> dict[str, NDArray[Any]]:
    """Face scalars per triangle. Colors out of range as in `colors_or_loss`."""
    scalars = {
        name: column
        for name, column in columns.items()
        if not isinstance(column, ListColumn) and name not in (*_CORNERS, *_TEXTURE)
    }
    attributes: dict[str, NDArray[Any]] = {}
    if all(name in scalars for name in _COLORS):
        colors = colors_or_loss(path, _color_channels(scalars), what="colors of faces", stacklevel=4)
        if colors is not None:
            attributes["colors"] = colors
    if "colors" in scalars:
        warn_of_loss(path, "values 'colors' of faces", "a mesh uses this name for something else", stacklevel=4)
        del scalars["colors"]
    attributes |= {name: own(column) for name, column in scalars.items()}
    if (lengths == 3).all():
        return attributes
    return {name: np.repeat(values, lengths - 2, axis=0) for name, values in attributes.items()}


def _color_channels(scalars: dict[str, NDArray[Any]]) -> list[NDArray[Any]]:
    """Remove the colors from the scalars, with alpha if it has their type."""
    channels = [scalars.pop(name) for name in _COLORS]
    if _ALPHA in scalars and scalars[_ALPHA].dtype == channels[0].dtype:
        channels.append(scalars.pop(_ALPHA))
    return channels


def warn_of_rest(
    path: FilePath, header: PlyHeader, columns: Mapping[str, Mapping[str, Column]], *, what: str = "mesh"
) -> None:
    """Warn of elements, and of properties of the read elements, that a mesh or cloud cannot store. A cloud has no
    faces."""
    lost = []
    for element in header.elements:
        if not element.count:
            continue
        if element.name not in ("vertex", "face", STRIPS):
            lost.append(f"element {element.name!r}")
        elif element.name in columns and element.name != STRIPS:
            lost += [f"{element.name} {p.name!r}" for p in element.properties if p.name not in columns[element.name]]
    if lost:
        warn_of_loss(path, "lists and elements", f"a {what} cannot store them: {', '.join(lost)}", stacklevel=4)


def face_name_rules(colors: NDArray[Any] | None) -> NameRules:
    color_names = () if colors is None else (*_COLORS, _ALPHA) if colors.shape[1:] == (4,) else _COLORS
    used = {*_CORNERS, *_TEXTURE, *color_names}
    return NameRules(is_word, used, [] if colors is not None else [_COLORS])


def attribute_columns(
    path: FilePath, attributes: dict[str, NDArray[Any]], types: str, remedy: str
) -> tuple[list[str], list[NDArray[Any]]]:
    """Properties and columns of triangle attributes. Raises `FileError` for unsupported names or types."""
    columns: dict[str, NDArray[Any]] = {}
    colors = attributes.get("colors")
    if colors is not None:
        if colors.ndim != 2 or colors.shape[1] not in (3, 4):
            raise FileError(path, f"colors of triangles: expected shape [t, 3] or [t, 4], got {list(colors.shape)}")
        rgb = colors_to_bytes(path, colors[:, :3])
        columns |= dict(zip(_COLORS, rgb.T, strict=True))
        if colors.shape[1] == 4:
            columns[_ALPHA] = colors_to_bytes(path, colors[:, [3, 3, 3]])[:, 0]
    others = narrow_attributes({name: values for name, values in attributes.items() if name != "colors"})
    check_types(path, others, types, remedy)
    for name, values in others.items():
        check_name(path, name)
        parts = split_columns(name, values)
        used = (*_CORNERS, *_TEXTURE, "colors")
        clash = sorted(part for part in parts if part in columns or part in used)
        if clash:
            raise FileError(path, f"attribute {name!r}: faces have another property {clash[0]!r}", remedy="Rename it")
        columns |= parts
    if colors is None and all(name in columns for name in _COLORS):
        reason = f"the attributes {', '.join(_COLORS)} of triangles would be read as colors"
        raise FileError(path, reason, remedy="Rename one of them")
    alpha = columns.get(_ALPHA)
    if colors is not None and colors.shape[1] == 3 and alpha is not None and alpha.dtype == np.uint8:
        raise FileError(path, "the attribute 'alpha' of triangles would be read with the colors", remedy="Rename it")
    heads = [f"property {TYPE_NAMES[f'{c.dtype.kind}{c.dtype.itemsize}']} {name}" for name, c in columns.items()]
    return heads, list(columns.values())
