"""Functions that open a window and wait until it is closed; POINTLOOM_DRAW=picture has them wait for nobody."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...core.errors import PointloomError
from ...core.open3d_names import row_of, told
from ...drawing.viewer.draw import draw as draw_page
from ..geometry import Geometry, Image
from .shown import checked, drawn
from .visualizer import Visualizer, VisualizerWithKeyCallback


def draw_geometries(
    geometry_list: Any,
    window_name: str = "Open3D",
    width: int = 1920,
    height: int = 1080,
    left: int = 50,
    top: int = 50,
    point_show_normal: bool = False,
    mesh_show_wireframe: bool = False,
    mesh_show_back_face: bool = False,
    lookat: Any = None,
    up: Any = None,
    front: Any = None,
    zoom: float | None = None,
) -> None:
    """Show geometries, as `loom.draw` does."""
    draw_page(
        [drawn(geometry) for geometry in checked(geometry_list)],
        window_name,
        width,
        height,
        left,
        top,
        point_show_normal,
        mesh_show_wireframe,
        mesh_show_back_face,
        lookat,
        up,
        front,
        zoom,
    )


def draw_geometries_with_animation_callback(
    geometry_list: Any,
    callback_function: Callable[[Visualizer], Any],
    window_name: str = "Open3D",
    width: int = 1920,
    height: int = 1080,
    left: int = 50,
    top: int = 50,
) -> None:
    """Show geometries, and call a function of the window again and again."""
    window = Visualizer()
    window.register_animation_callback(callback_function)
    _show(window, geometry_list, window_name, width, height)


def draw_geometries_with_key_callbacks(
    geometry_list: Any,
    key_to_callback: Mapping[int, Callable[[Visualizer], Any]],
    window_name: str = "Open3D",
    width: int = 1920,
    height: int = 1080,
    left: int = 50,
    top: int = 50,
) -> None:
    """Show geometries, with keys that call functions of the window."""
    window = VisualizerWithKeyCallback()
    for key, callback in key_to_callback.items():
        window.register_key_callback(key, callback)
    _show(window, geometry_list, window_name, width, height)


def draw(
    geometry: Any = None,
    title: str = "Open3D",
    width: int = 1024,
    height: int = 768,
    actions: Any = None,
    lookat: ArrayLike | None = None,
    eye: ArrayLike | None = None,
    up: ArrayLike | None = None,
    field_of_view: float = 60.0,
    *,
    bg_color: Any = (1.0, 1.0, 1.0, 1.0),
    show_ui: bool | None = None,
    raw_mode: bool = False,
    point_size: int | None = None,
    line_width: int | None = None,
    show_axes: bool | None = None,
    **others: Any,
) -> None:
    """Show a geometry, a list of them, or of dictionaries with "geometry" and "name"; materials are not looked at."""
    asked = [name for name, value in {"actions": actions, **others}.items() if value is not None and value is not False]
    if asked:
        raise PointloomError(f"{asked[0]}: pages have no such thing{told(row_of(asked[0], ('draw',)))}")
    window = Visualizer()
    option, control = window.get_render_option(), window.get_view_control()
    option.background_color = np.asarray(bg_color, np.float64)[:3]
    option.show_coordinate_frame = bool(show_axes)
    option.point_size = option.point_size if point_size is None else float(point_size)
    option.line_width = option.line_width if line_width is None else float(line_width)
    alone = isinstance(geometry, Geometry | Image | Mapping)
    entries = [geometry] if alone else list(geometry or [])
    shapes = [one["geometry"] if isinstance(one, Mapping) else one for one in entries]

    def look() -> None:
        control._angle = float(field_of_view)
        if up is not None:
            control.set_up(up)
        if lookat is not None:
            control.set_lookat(lookat)
        if eye is not None:
            away = np.asarray(eye, np.float64) - control._lookat
            side = float(np.max(control._bounds[1] - control._bounds[0])) or 1.0
            control.set_front(away)
            control.set_zoom(float(np.linalg.norm(away)) * math.tan(math.radians(field_of_view / 2)) / side)

    _show(window, shapes, title, width, height, look)


def _show(
    window: Visualizer, geometries: Any, name: str, width: int, height: int, look: Callable[[], None] | None = None
) -> None:
    """Show geometries until the window is closed."""
    window.create_window(name, width, height)
    try:
        for geometry in checked(geometries):
            window.add_geometry(geometry)
        if look is not None:
            look()
        window.update_renderer()
        window.run()
    except KeyboardInterrupt:
        pass  # as closing the window
    finally:
        window.destroy_window()
