"""Functions that open a window and wait until it is closed.

Without a display they write an image and do not wait. With POINTLOOM_DRAW=picture they neither open nor write anything.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from numpy.typing import ArrayLike

from ...core.errors import PointloomError
from ...core.open3d_names import hint, row_of
from ...visualization.notebook_output import in_notebook
from ...visualization.viewer.draw import draw as draw_page
from .editing import VisualizerWithEditing
from .o3d_visualizer import O3DVisualizer
from .shown import checked, drawn
from .visualizer import Visualizer, VisualizerWithKeyCallback


def draw_geometries(
    geometry_list: Iterable[object],
    window_name: str = "Open3D",
    width: int = 1920,
    height: int = 1080,
    left: int = 50,
    top: int = 50,
    point_show_normal: bool = False,
    mesh_show_wireframe: bool = False,
    mesh_show_back_face: bool = False,
    lookat: ArrayLike | None = None,
    up: ArrayLike | None = None,
    front: ArrayLike | None = None,
    zoom: float | None = None,
) -> None:
    """Show geometries like `loom.draw`; `window_name`, `left` and `top` are ignored by the browser."""
    page = draw_page(
        [drawn(geometry) for geometry in checked(geometry_list)],
        width,
        height,
        point_show_normal,
        mesh_show_wireframe,
        mesh_show_back_face,
        lookat,
        up,
        front,
        zoom,
    )
    if in_notebook():
        importlib.import_module("IPython.display").display(page)


def draw_geometries_with_animation_callback(
    geometry_list: Iterable[object],
    callback_function: Callable[[Visualizer], Any],
    window_name: str = "Open3D",
    width: int = 1920,
    height: int = 1080,
    left: int = 50,
    top: int = 50,
) -> None:
    """Show geometries and call a function of the window repeatedly."""
    window = Visualizer()
    window.register_animation_callback(callback_function)
    _show(window, geometry_list, window_name, width, height)


def draw_geometries_with_key_callbacks(
    geometry_list: Iterable[object],
    key_to_callback: Mapping[int, Callable[[Visualizer], Any]],
    window_name: str = "Open3D",
    width: int = 1920,
    height: int = 1080,
    left: int = 50,
    top: int = 50,
) -> None:
    window = VisualizerWithKeyCallback()
    for key, callback in key_to_callback.items():
        window.register_key_callback(key, callback)
    _show(window, geometry_list, window_name, width, height)


def draw_geometries_with_editing(
    geometry_list: Iterable[object],
    window_name: str = "Open3D",
    width: int = 1920,
    height: int = 1080,
    left: int = 50,
    top: int = 50,
) -> None:
    """Pick points and crop in a window. `VisualizerWithEditing` returns the picked points."""
    _show(VisualizerWithEditing(), geometry_list, window_name, width, height)


def draw(
    geometry: object = None,
    title: str = "Open3D",
    width: int = 1024,
    height: int = 768,
    actions: Any = None,
    lookat: ArrayLike | None = None,
    eye: ArrayLike | None = None,
    up: ArrayLike | None = None,
    field_of_view: float = 60.0,
    *,
    bg_color: ArrayLike = (1.0, 1.0, 1.0, 1.0),
    show_ui: bool | None = None,
    raw_mode: bool = False,
    point_size: int | None = None,
    line_width: int | None = None,
    animation_time_step: float = 1.0,
    animation_duration: float | None = None,
    on_init: Callable[[O3DVisualizer], Any] | None = None,
    on_animation_frame: Callable[[O3DVisualizer, float], Any] | None = None,
    on_animation_tick: Callable[[O3DVisualizer, float, float], Any] | None = None,
    show_axes: bool | None = None,
    **others: Any,
) -> None:
    """Show a geometry, a list of them, or of dictionaries with "geometry", "name" and "material".

    Callbacks of `actions` and animations run in a thread of the page and may add and change geometries.
    """
    unsupported = [name for name, value in others.items() if value is not None and value is not False]
    if unsupported:
        raise PointloomError(f"{unsupported[0]}: not supported by pages{hint(row_of(unsupported[0], ('draw',)))}")
    window = O3DVisualizer(title, width, height)
    try:
        window.point_size = window.point_size if point_size is None else point_size
        window.line_width = window.line_width if line_width is None else line_width
        window.set_background(bg_color)
        _fill(window, geometry, actions or ())
        if lookat is not None and eye is not None and up is not None:
            window.setup_camera(field_of_view, lookat, eye, up)
        window.show_axes = bool(show_axes)
        window.animation_time_step = animation_time_step
        window.animation_duration = window.animation_duration if animation_duration is None else animation_duration
        if on_init is not None:
            on_init(window)
        window.set_on_animation_frame(on_animation_frame)
        window.set_on_animation_tick(on_animation_tick)
        window.run()
    except KeyboardInterrupt:
        pass  # like closing the window
    finally:
        window.destroy_window()


def _fill(window: O3DVisualizer, geometry: object, actions: Any) -> None:
    """Add buttons and geometries to a window."""
    for name, callback in actions:
        window.add_action(name, callback)
    several = list(geometry) if isinstance(geometry, list | tuple) else [] if geometry is None else [geometry]
    for number, entry in enumerate(several, 1):
        name = f"Object {number}"
        window.add_geometry({"name": name, **entry} if isinstance(entry, Mapping) else name, entry)
    window.reset_camera_to_default()


def _show(window: Visualizer, geometries: Iterable[object], name: str, width: int, height: int) -> None:
    window.create_window(name, width, height)
    try:
        for geometry in checked(geometries):
            window.add_geometry(geometry)
        window.update_renderer()
        window.run()
    except KeyboardInterrupt:
        pass  # like closing the window
    finally:
        window.destroy_window()
