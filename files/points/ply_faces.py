"""What PLY faces have beside corners and textures, and triangle strips.

Roles of face properties: red green blue (and alpha, where it is of their type) are colours; every other scalar is an
attribute of the triangles under its own name. A face of n corners gives its values to n - 2 triangles. Lists other than
corners and texture coordinates, and elements that no mesh has, are left behind with a warning.

Strips: the element `tristrips`, whose lists run through triangles, each turned against the last; -1 begins a new one,
and triangles that name a vertex twice, by which strips are joined, are none.

Source: Greg Turk's "ply2ply" and the range scans of Stanford for strips; VCGlib's exporter for colours of faces.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError
from ..attribute_names import NameRules, is_word
from ..columns import check_name, check_type, colors_or_loss, colors_to_bytes, own, warn_of_loss
from .ply_header import TYPE_NAMES, PlyHeader
from .ply_rows import Column, ListColumn

STRIPS = "tristrips"
_COLORS = ("red", "green", "blue")
_ALPHA = "alpha"

# Properties of faces that are no attributes.
_CORNERS = ("vertex_indices", "vertex_index")
_TEXTURE = ("texcoord", "texnumber")


def strip_triangles(path: Any, strips: ListColumn, vertex_count: int) -> NDArray[np.int64]:
    """The triangles of strips, shape [t, 3].

    Raises:
        FileError: A strip that names a vertex which is not there.
    """
    values = strips.values.astype(np.int64)
    bad = np.flatnonzero((values < -1) | (values >= vertex_count))
    row_of = np.repeat(np.arange(len(strips.lengths)), strips.lengths)
    if len(bad):
        reason = f"a strip names vertex {values[bad[0]]}, but there are {vertex_count} vertices"
        raise FileError(path, reason, where=f"strip {row_of[bad[0]]}")
    places = np.arange(len(values))
    begins = np.ones(len(values), bool)
    begins[1:] = (row_of[1:] != row_of[:-1]) | (values[:-1] < 0)
    within = places - np.maximum.accumulate(np.where(begins, places, 0))  # of its part between two -1
    third = np.flatnonzero((within >= 2) & (values >= 0))
    rows = np.stack([values[third - 2], values[third - 1], values[third]], axis=1)
    odd = within[third] % 2 == 1
    rows[odd] = rows[odd][:, [1, 0, 2]]
    return rows[(rows[:, 0] != rows[:, 1]) & (rows[:, 1] != rows[:, 2]) & (rows[:, 2] != rows[:, 0])]


def triangle_attributes(
    path: Any, columns: Mapping[str, Column], lengths: NDArray[np.int64]
) -> dict[str, NDArray[Any]]:
    """The scalars of faces for their triangles; colors outside their range as `colors_or_loss` handles them."""
    scalars = {
        name: column
        for name, column in columns.items()
        if not isinstance(column, ListColumn) and name not in (*_CORNERS, *_TEXTURE)
    }
    found: dict[str, NDArray[Any]] = {}
    if all(name in scalars for name in _COLORS):
        colors = colors_or_loss(path, _color_channels(scalars), what="colors of faces", stacklevel=4)
        if colors is not None:
            found["colors"] = colors
    if "colors" in scalars:
        warn_of_loss(path, "values 'colors' of faces", "a mesh calls something else so", stacklevel=4)
        del scalars["colors"]
    found |= {name: own(column) for name, column in scalars.items()}
    if (lengths == 3).all():
        return found
    return {name: np.repeat(values, lengths - 2, axis=0) for name, values in found.items()}


def _color_channels(scalars: dict[str, NDArray[Any]]) -> list[NDArray[Any]]:
    """Take the colors out of the scalars, with the alpha if it has their type."""
    channels = [scalars.pop(name) for name in _COLORS]
    if _ALPHA in scalars and scalars[_ALPHA].dtype == channels[0].dtype:
        channels.append(scalars.pop(_ALPHA))
    return channels


def warn_of_rest(path: Any, header: PlyHeader, columns: Mapping[str, Mapping[str, Column]]) -> None:
    """Warn of lists and elements that are left behind."""
    lost = []
    for element in header.elements:
        if not element.count:
            continue
        if element.name not in ("vertex", "face", STRIPS):
            lost.append(f"element {element.name!r}")
        elif element.name != STRIPS:
            lost += [f"{element.name} {p.name!r}" for p in element.properties if p.name not in columns[element.name]]
    if lost:
        warn_of_loss(path, "lists and elements", f"a mesh has no place for them: {', '.join(lost)}", stacklevel=4)


def face_name_rules(colors: NDArray[Any] | None) -> NameRules:
    """The names that attributes of triangles may have, beside colours or None."""
    held = () if colors is None else (*_COLORS, _ALPHA) if colors.shape[1:] == (4,) else _COLORS
    used = {*_CORNERS, *_TEXTURE, *held}
    return NameRules(is_word, used, [] if colors is not None else [_COLORS])


def attribute_columns(
    path: Any, attributes: dict[str, NDArray[Any]], types: str, remedy: str
) -> tuple[list[str], list[NDArray[Any]]]:
    """The properties that hold attributes of triangles, and their columns.

    Raises:
        FileError: A name or type that PLY has not, or a name that would be read as something else.
    """
    columns: dict[str, NDArray[Any]] = {}
    colors = attributes.get("colors")
    if colors is not None:
        if colors.ndim != 2 or colors.shape[1] not in (3, 4):
            raise FileError(path, f"colors of triangles: expected shape [t, 3] or [t, 4], got {list(colors.shape)}")
        rgb = colors_to_bytes(path, colors[:, :3])
        columns |= dict(zip(_COLORS, rgb.T, strict=True))
        if colors.shape[1] == 4:
            columns[_ALPHA] = colors_to_bytes(path, colors[:, [3, 3, 3]])[:, 0]
    for name, values in attributes.items():
        if name == "colors":
            continue
        check_name(path, name)
        check_type(path, name, values, types, remedy)
        parts = {name: values} if values.ndim == 1 else {f"{name}_{k}": part for k, part in enumerate(values.T)}
        clash = sorted(parts.keys() & {*columns, *_CORNERS, *_TEXTURE, "colors"})
        if clash:
            raise FileError(path, f"attribute {name!r}: faces have another property {clash[0]!r}", remedy="Rename it")
        columns |= parts
    if colors is None and all(name in columns for name in _COLORS):
        reason = f"the attributes {', '.join(_COLORS)} of triangles would be read as colours"
        raise FileError(path, reason, remedy="Rename one of them")
    alpha = columns.get(_ALPHA)
    if colors is not None and colors.shape[1] == 3 and alpha is not None and alpha.dtype == np.uint8:
        raise FileError(path, "the attribute 'alpha' of triangles would be read with the colours", remedy="Rename it")
    heads = [f"property {TYPE_NAMES[f'{c.dtype.kind}{c.dtype.itemsize}']} {name}" for name, c in columns.items()]
    return heads, list(columns.values())
