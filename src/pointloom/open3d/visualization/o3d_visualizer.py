"""O3DVisualizer: the window of `open3d.visualization.draw` as a browser page."""

from __future__ import annotations

import dataclasses
import enum
import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...core.attribute_hints import KnownNames
from ...core.checks import check_callback, check_name, check_number, check_positive
from ...core.errors import PointloomError
from .rendering.material import style_of
from .shown import drawn
from .visualizer import FilePath, Visualizer

ANIMATE = "Animate"
ANIMATION_RATE = 30.0  # [Hz]
Function = Callable[..., Any]


class TickResult(enum.Enum):
    """Return value of an animation tick callback. Ignored."""

    NO_CHANGE, REDRAW = range(2)


@dataclasses.dataclass
class DrawObject:
    """A geometry of a window (read-only): `name`, `geometry`, `group`, `time` and `is_visible`."""

    name: str
    geometry: Any
    group: str = ""
    time: float = 0.0
    is_visible: bool = True


class O3DVisualizer(KnownNames):
    """The window passed to callbacks of `draw`. A page, or an image if none is opened.

    If geometries have different times, the page has a timeline and shows those of the current time.
    """

    TickResult = TickResult

    def __init__(self, title: str = "Open3D", width: int = 1024, height: int = 768):
        self._window, self._objects = Visualizer(), dict[str, DrawObject]()
        self._window.create_window(check_name("title", title), width, height)
        self._buttons: dict[str, Function] = {}
        self._on_frame: Function | None = None
        self._on_tick: Function | None = None
        self._stop: Callable[[], None] | None = None
        self._animate: Any = None  # checkbox in the page
        self._time, self._step, self._end = 0.0, 1.0, math.inf

    def __repr__(self) -> str:
        return f"O3DVisualizer({self.title!r}, {len(self._objects)} geometries)"

    def add_geometry(
        self,
        name: str | Mapping[str, Any],
        geometry: object = None,
        material: object = None,
        group: str = "",
        time: float = 0.0,
        is_visible: bool = True,
    ) -> None:
        """Show a geometry under a name, or a dictionary with "name", "geometry" and more.

        A `rendering.MaterialRecord` sets the size of points, the width of lines, and the color of geometries without
        colors. Raises ValueError if the name is in use.
        """
        if isinstance(name, Mapping):
            known = {"name", "geometry", "material", "group", "time", "is_visible"}
            self.add_geometry(**{key: value for key, value in name.items() if key in known})
            return
        if check_name("name", name) in self._objects:
            raise ValueError(f"name: {name!r} is already displayed; remove_geometry({name!r}) removes it")
        one = DrawObject(name, geometry, check_name("group", group), check_number("time", time), bool(is_visible))
        shape, viewer = drawn(geometry), self._window.viewer
        self._window.styles[name] = style_of(material, shape)
        self._objects[name] = one
        if one.is_visible:
            self._window.geometries[name] = geometry
        if viewer is not None:
            viewer.add(name, shape, **self._window.style_of(shape, name))
            if not one.is_visible:
                viewer.set_visible(name, False)

    def update_geometry(self, name: str, geometry: object, update_flags: int = 0) -> None:
        one, shape = self.get_geometry(name), drawn(geometry)
        one.geometry = geometry
        if one.is_visible:
            self._window.geometries[name] = geometry
        if self._window.viewer is not None:
            self._window.viewer.update(name, shape)

    def remove_geometry(self, name: str) -> None:
        self.get_geometry(name)
        del self._objects[name]
        self._window.styles.pop(name, None)
        self._window.geometries.pop(name, None)
        if self._window.viewer is not None:
            self._window.viewer.remove(name)

    def show_geometry(self, name: str, show: bool) -> None:
        one = self.get_geometry(name)
        one.is_visible = bool(show)
        if one.is_visible:
            self._window.geometries[name] = one.geometry
        else:
            self._window.geometries.pop(name, None)
        if self._window.viewer is not None:
            self._window.viewer.set_visible(name, one.is_visible)

    def get_geometry(self, name: str) -> DrawObject:
        """Properties of a geometry. Raises KeyError for an unknown name."""
        if name not in self._objects:
            raise KeyError(
                f"name: no geometry {name!r}; expected one of {', '.join(map(repr, self._objects)) or 'none'}"
            )
        return self._objects[name]

    def _play_times(self) -> None:
        """Let the timeline show the geometries of each time."""
        times = sorted({one.time for one in self._objects.values()})
        viewer = self._window.viewer
        if viewer is None or len(times) < 2:
            return
        for time in times:
            viewer.set_time(time)
            for one in self._objects.values():
                viewer.set_visible(one.name, one.is_visible and one.time == time)
        viewer.show_time(times[0])

    def add_action(self, name: str, callback: Function) -> None:
        """Add a button that calls a function with this window in a thread of the page."""
        self._buttons[check_name("name", name)] = callback
        if self._window.viewer is not None:
            self._window.viewer.add_button(name, lambda page: callback(self), folder="Actions")

    def set_on_animation_frame(self, callback: Function | None) -> None:
        """Call a function with this window and the time every `animation_time_step` during animation."""
        self._on_frame = check_callback("callback", callback)
        self._offer_animation()

    def set_on_animation_tick(self, callback: Function | None) -> None:
        """Call a function with this window, the seconds since its last call and the time during animation."""
        self._on_tick = check_callback("callback", callback)
        self._offer_animation()

    @property
    def is_animating(self) -> bool:
        """True if animation callbacks run; assignable, or set by the page's checkbox."""
        return self._stop is not None

    @is_animating.setter
    def is_animating(self, animates: bool) -> None:
        stop, self._stop = self._stop, None
        if stop is not None:
            stop()
        if animates and self._window.viewer is not None:
            self._stop = self._window.viewer.on_frame(self._tick, ANIMATION_RATE)
        if self._animate is not None:
            self._animate.value = bool(animates)

    @property
    def current_time(self) -> float:
        """Time of the animation [s], assignable."""
        return self._time

    @current_time.setter
    def current_time(self, time: float) -> None:
        self._time = check_number("current_time", time)
        viewer = self._window.viewer
        if viewer is not None and viewer.edits.timeline is not None:
            viewer.show_time(self._time)

    @property
    def animation_time_step(self) -> float:
        """Frame interval of the animation [s], assignable."""
        return self._step

    @animation_time_step.setter
    def animation_time_step(self, seconds: float) -> None:
        self._step = check_positive("animation_time_step", seconds)

    @property
    def animation_duration(self) -> float:
        """Duration of the animation loop [s], may be infinite; assignable."""
        return self._end

    @animation_duration.setter
    def animation_duration(self, seconds: float) -> None:
        self._end = check_positive("animation_duration", seconds, allow_infinite=True)

    def _offer_animation(self) -> None:
        viewer = self._window.viewer
        if self._animate is None and viewer is not None and (self._on_frame or self._on_tick):
            self._animate = viewer.add_checkbox(ANIMATE, False, self._take_animate, folder="Animation")

    def _take_animate(self, animates: bool) -> None:
        self.is_animating = animates

    def _tick(self, seconds: float) -> None:
        before, time = self._time, self._time + seconds
        self.current_time = time if time < self._end else 0.0
        if self._on_tick is not None:
            self._on_tick(self, seconds, self._time)
        if self._on_frame is not None and self._time // self._step != before // self._step:
            self._on_frame(self, self._time)

    @property
    def title(self) -> str:
        return self._window.get_window_name()

    @property
    def point_size(self) -> float:
        """Diameter of points [px], assignable."""
        return self._window.get_render_option().point_size

    @point_size.setter
    def point_size(self, pixels: float) -> None:
        self._window.get_render_option().point_size = float(pixels)
        self.post_redraw()

    @property
    def line_width(self) -> float:
        """Width of lines [px], assignable."""
        return self._window.get_render_option().line_width

    @line_width.setter
    def line_width(self, pixels: float) -> None:
        self._window.get_render_option().line_width = float(pixels)
        self.post_redraw()

    @property
    def show_axes(self) -> bool:
        """Show a coordinate frame, assignable."""
        return self._window.get_render_option().show_coordinate_frame

    @show_axes.setter
    def show_axes(self, shown: bool) -> None:
        self._window.get_render_option().show_coordinate_frame = bool(shown)
        self.post_redraw()

    def set_background(self, bg_color: ArrayLike, bg_image: object = None) -> None:
        if bg_image is not None:
            raise PointloomError("bg_image: the background of a page is a color, not an image; use bg_color")
        self._window.get_render_option().background_color = np.asarray(bg_color, np.float64)[:3]
        self.post_redraw()

    def reset_camera_to_default(self) -> None:
        self._window.reset_view_point(True)
        self.post_redraw()

    def setup_camera(self, field_of_view: float, center: ArrayLike, eye: ArrayLike, up: ArrayLike) -> None:
        """Look from `eye` at `center` with a field of view [degrees]."""
        control = self._window.get_view_control()
        away = np.asarray(eye, np.float64) - np.asarray(center, np.float64)
        side = float(np.max(control.bounds[1] - control.bounds[0])) or 1.0
        angle = check_positive("field_of_view", field_of_view, maximum=179.0)
        control.angle = angle
        control.set_up(up)
        control.set_lookat(center)
        control.set_front(away)
        control.set_zoom(float(np.linalg.norm(away)) * math.tan(math.radians(angle / 2)) / side)
        self.post_redraw()

    def post_redraw(self) -> None:
        self._window.update_renderer()

    def export_current_image(self, path: FilePath) -> None:
        """Render to a .png or .jpg file."""
        self._window.capture_screen_image(path)

    def run(self) -> None:
        """Wait until the window is closed. If geometries have times, the timeline shows those of the first one."""
        self._play_times()
        self._window.run()

    def destroy_window(self) -> None:
        """Close the window and remove its geometries."""
        self._window.destroy_window()

    def close(self) -> None:
        self._window.close()
