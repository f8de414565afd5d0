"""Screenshots and standalone pages of a viewer's scene."""

from __future__ import annotations

import dataclasses
import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...meshing.mesh.mesh import TriangleMesh
from ...pcd.cloud import PointCloud
from ..render.geometries import Named
from ..render.parts import Triple
from ..render.picture_files import check_picture, write_image
from ..render.styles import Style
from ..render.up_axis import DEFAULT_LOOK, look_of
from ..render.view import View
from .coloring_choice import choices_of, shown_coloring
from .items import Item
from .point_transfer import even_fraction
from .scene import POINT_SIZE, Scene
from .tools.clip_planes import Clip, clip_mesh

VIEW_SIZE = (1280, 960)  # [px] of the fitted initial view
MAX_DRAWN = 20_000_000  # points of an image if they must be copied


def draw_scene(
    scene: Scene, view: View, path: str | os.PathLike[str] | None, clip: Clip | None = None
) -> NDArray[np.uint8]:
    """Render the scene with clip planes, and write a .png file if a path is given."""
    from ..render.render import render

    if path is not None:
        check_picture(path, overwrite=True)
    picture = render(
        [as_entry(named) for named in shown_geometries(scene, clip)],
        camera=view,
        background=tuple(scene.background.tolist()),
        color_bar=shown_coloring(scene.shown.values()),
    )
    if path is not None:
        write_image(path, picture)
    return picture


def write_scene(scene: Scene, view: View, path: str | os.PathLike[str], clip: Clip | None, *, overwrite: bool) -> None:
    shown, background = shown_geometries(scene, clip), scene.background.tolist()
    write_geometries(path, shown, scene.max_points, view=view, background=background, overwrite=overwrite)


def write_geometries(
    path: str | os.PathLike[str],
    named: list[Named],
    max_points: int,
    *,
    view: View | None = None,
    background: Any = (1.0, 1.0, 1.0),
    title: str = "pointloom",
    overwrite: bool = True,
    up: Triple | None = None,
) -> dict[str, tuple[int, int]]:
    """Write geometries as a standalone .html page, with the color bar of the first one that has a coloring.

    `max_points` is shared by all. Returns the displayed and total number of points and vertices of each name. Without a
    view, everything is shown with `up` (None: that of the first mesh that defines one, else z).
    """
    from ..recording.film import view_frames
    from ..recording.page import write_page
    from ..recording.shapes import ShapeStore, pose_about, sketch
    from ..recording.timeline import Frame, Placement, Timeline
    from ..render.legends import key_of

    store, shown = ShapeStore(), {}
    sketches = {name: sketch(geometry, style, max_points) for name, geometry, style in named}
    total = sum(drawn.total for drawn in sketches.values())
    if total > max_points:
        sketches = {
            name: sketch(geometry, style, max(1, max_points * sketches[name].total // total))
            for name, geometry, style in named
        }
    origin = next((drawn.origin for drawn in sketches.values()), np.zeros(3))
    for name, drawn in sketches.items():
        numbers = tuple(store.add(shape) for shape in drawn.shapes)
        shown[name] = Placement(numbers, pose_about(drawn.pose, drawn.origin, origin))
    timeline = Timeline(origin, store.shapes, [Frame(shown)], title=title)
    look = look_of(((geometry, style.pose) for _, geometry, style in named), up)
    if view is None and look != DEFAULT_LOOK:
        view = view_frames(timeline, look, *VIEW_SIZE)
    coloring = next((drawn.coloring for drawn in sketches.values() if drawn.coloring is not None), None)
    key = None if coloring is None else key_of(coloring)
    write_page(path, timeline, view=view, background=tuple(background), overwrite=overwrite, key=key)
    return {name: (drawn.drawn, drawn.total) for name, drawn in sketches.items()}


def as_entry(named: Named) -> dict[str, Any]:
    name, geometry, style = named
    given = {field.name: getattr(style, field.name) for field in dataclasses.fields(style)}
    return {"geometry": geometry, "name": name, **{key: value for key, value in given.items() if value is not None}}


def shown_geometries(scene: Scene, clip: Clip | None = None) -> list[Named]:
    """Displayed geometries with their displayed styles, clipped."""
    return [shown_geometry(scene, item, clip) for item in scene.shown.values() if item.visible]


def shown_geometry(scene: Scene, item: Item, clip: Clip | None = None) -> Named:
    geometry, style = item.geometry if item.cloud is None else with_colors(item), _style(scene, item)
    if clip is not None:
        geometry = clipped(geometry, clip, style.pose)
    return item.name, geometry, style


def clipped(geometry: object, clip: Clip, pose: ArrayLike | None) -> Any:
    """Clip a cloud or mesh at a pose. Other types are returned unchanged."""
    if not clip.cuts:
        return geometry
    if isinstance(geometry, TriangleMesh):
        return clip_mesh(geometry, clip, pose=pose)
    if not isinstance(geometry, PointCloud) or not len(geometry):
        return geometry
    return geometry.select_by_index(np.flatnonzero(clip.keeper(pose)(geometry.points)))


def with_colors(item: Item) -> PointCloud:
    """The cloud of an item. For a file with colors in its tree, a sample of at most 20 million points with colors."""
    cloud = item.cloud
    assert cloud is not None
    if not item.has_colors_in_tree:
        return cloud
    rows = even_fraction(len(cloud), MAX_DRAWN)
    return item.select(np.arange(len(cloud)) if rows is None else rows)


def _style(scene: Scene, item: Item) -> Style:
    changed: dict[str, Any] = {}
    style, choice = item.style, scene.coloring
    if item.pose is not None:
        changed["pose"] = item.pose if style.pose is None else item.pose @ style.pose
    if item.cloud is not None:
        if not style.metric:
            changed["point_size"] = scene.point_size * (style.point_size or POINT_SIZE) / POINT_SIZE
        if choice.by is not None and choice.by in choices_of(item.cloud):
            changed |= {"color_by": choice.by, "colormap": choice.colormap, "limits": choice.limits, "color": None}
    elif scene.wireframe and item.has_surface:
        changed["wireframe"] = True
    return dataclasses.replace(style, **changed)
