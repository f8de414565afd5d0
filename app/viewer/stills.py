"""A viewer's scene as a picture and as a page of its own."""

from __future__ import annotations

import dataclasses
import os
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..pictures.picture_files import check_picture, save_picture
from ..pictures.view import View
from .coloring_choice import choices_of, shown_coloring
from .items import Item
from .sessions import POINT_SIZE

if TYPE_CHECKING:
    from .viewer import Viewer


def draw_scene(viewer: Viewer, view: View, path: str | os.PathLike[str] | None) -> NDArray[np.uint8]:
    """The scene as `loom.render` draws it from there, and as a .png file where a path is given.

    Raises:
        FileError: The place cannot be written.
    """
    from ..pictures.render import render

    if path is not None:
        check_picture(path, overwrite=True)
    picture = render(
        [_entry(viewer, item) for item in viewer.items.values() if item.visible],
        camera=view,
        background=tuple(viewer.background.tolist()),
        color_bar=shown_coloring(viewer.items.values()),
    )
    if path is not None:
        save_picture(path, picture)
    return picture


def _entry(viewer: Viewer, item: Item) -> dict[str, Any]:
    """A geometry with the style that the viewer shows it in."""
    style = {field.name: getattr(item.style, field.name) for field in dataclasses.fields(item.style)}
    if item.pose is not None:
        style["pose"] = item.pose if style["pose"] is None else item.pose @ style["pose"]
    if item.cloud is not None:
        if not style["metric"]:
            style["point_size"] = viewer.point_size * (style["point_size"] or POINT_SIZE) / POINT_SIZE
        choice = viewer.coloring
        if choice.by is not None and choice.by in choices_of(item.cloud):
            style |= {"color_by": choice.by, "colormap": choice.colormap, "limits": choice.limits, "color": None}
    elif viewer.wireframe and item.has_surface:
        style["wireframe"] = True
    given = {name: value for name, value in style.items() if value is not None}
    return {"geometry": item.geometry if item.cloud is None else item.cloud, "name": item.name, **given}


def write_scene(viewer: Viewer, path: str | os.PathLike[str], *, overwrite: bool) -> None:
    """The scene as one page that needs no server.

    Raises:
        FileError: The place cannot be written.
    """
    raise NotImplementedError
