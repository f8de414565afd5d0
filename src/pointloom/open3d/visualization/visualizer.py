"""Visualizer: Open3D's window as a browser page, or as images only."""

from __future__ import annotations

import queue
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from ...core.attribute_hints import KnownNames
from ...core.checks import check_callback, check_count, check_positive
from ...core.errors import FilePath
from ...core.escaped_text import escaped
from ...core.units import without_warnings
from ...meshing.mesh.mesh import TriangleMesh
from ...visualization.render.open3d_views import read_view, write_view
from ...visualization.render.render import render
from ...visualization.viewer.draw import announce, draw_mode, open_page, save_numbered
from ...visualization.viewer.viewer import Viewer
from ..geometry import Image, PointCloud
from ..io import write_image, write_point_cloud
from .render_option import COLOR_BY, MeshShadeOption, RenderOption
from .shown import bounds_of, drawn
from .view_control import EMPTY_SCENE_BOUNDS, ViewControl

Callback = Callable[["Visualizer"], Any]

UNATTENDED_FRAMES = 60  # one second of a screen
CALLBACK_INTERVAL = 1 / 30  # [s] between two animation callbacks
FRAME = "coordinate frame"
KEY_NAMES = {
    32: "space", 256: "escape", 257: "enter", 258: "tab", 259: "backspace", 260: "insert", 261: "delete",
    262: "arrowright", 263: "arrowleft", 264: "arrowdown", 265: "arrowup", 266: "pageup", 267: "pagedown",
    268: "home", 269: "end", **{code: chr(code) for code in (*range(48, 58), *range(65, 91))},
}  # fmt: skip  # GLFW's numbers of keys, and what they are called in the page


class Visualizer(KnownNames):
    """A window: `create_window`, `add_geometry`, then `run`, or `poll_events` and `update_renderer` in a loop.

    It is a browser page (`loom.Viewer`) whose address is printed on stderr. The key Q closes it. With `visible=False`,
    without a display, or if the environment variable POINTLOOM_DRAW is "picture", no page is opened: captures are
    rendered, and `run` and `poll_events` end after 60 frames. Without a display an image is written, as by `loom.draw`.
    """

    _internal = ("on_opened", "style_of")

    viewer: Viewer | None  # the page, if one is open
    geometries: dict[str, Any]  # displayed ones by name
    styles: dict[str, dict[str, Any]]  # of some geometries by name

    def __init__(self):
        self._name, self._frames, self._closed = "Open3D", 0, False
        self.geometries, self.styles, self.viewer = {}, {}, None
        self._writes_image = False  # a window without a display, of which no image was taken
        self._option, self._control = RenderOption(), ViewControl()
        self._animation: Callback | None = None
        self._callbacks: dict[str, Callback] = {}
        self._pressed: queue.SimpleQueue[str] = queue.SimpleQueue()
        self._option_shown: Any = None

    def create_window(
        self,
        window_name: str = "Open3D",
        width: int = 1920,
        height: int = 1080,
        left: int = 50,
        top: int = 50,
        visible: bool = True,
    ) -> bool:
        """Open the window; `width` and `height` apply to images only."""
        self.destroy_window()
        self._name, self._frames, self._closed = str(window_name), 0, False
        self._control.size = check_count("width", width), check_count("height", height)
        mode = draw_mode() if visible else "picture"
        self._writes_image = mode == "file"
        if mode == "page":
            self.viewer = Viewer(title=self._name, size=self._control.size)
            self._control.page_view = lambda: self.viewer.get_view() if self.viewer and self.viewer.sessions else None
            self.viewer.on_key("Q", lambda client: self.close(), "Close the window")
            for key in self._callbacks:
                self._listen(key)
            announce(self.viewer)
            open_page(self.viewer)
        self.on_opened(self.viewer)
        return True

    def on_opened(self, viewer: Viewer | None) -> None:
        """Called for each new window, with None without a page."""

    def destroy_window(self) -> None:
        """Close the window and remove its geometries."""
        if self._frames:
            self._write_image()
        self._closed = True
        self.geometries.clear()
        self.styles.clear()
        if self.viewer is not None:
            self.viewer.close()
            self.viewer = None

    def close(self) -> None:
        self._closed = True

    def get_window_name(self) -> str:
        return self._name

    def is_full_screen(self) -> bool:
        return False

    def __repr__(self) -> str:
        return f"{type(self).__name__} with name {escaped(self._name)}"

    def add_geometry(self, geometry: object, reset_bounding_box: bool = True) -> bool:
        """Show a geometry. The view is reset unless `reset_bounding_box` is False."""
        shape, name = drawn(geometry), self._name_of(geometry)
        if name is not None:
            return self.update_geometry(geometry)
        name = f"{type(geometry).__name__} {len(self.geometries) + 1}"
        while name in self.geometries:
            name += "'"
        self.geometries[name] = geometry
        if reset_bounding_box:
            self.reset_view_point(True)
        if self.viewer is not None:
            self.viewer.add(name, shape, **self.style_of(shape, name))
            self._show_options()
        return True

    def update_geometry(self, geometry: object = None) -> bool:
        """Show the current state of a geometry, or of all. False for an unknown geometry."""
        if geometry is None:
            return all([self.update_geometry(one) for one in list(self.geometries.values())])
        name = self._name_of(geometry)
        if name is not None and self.viewer is not None:
            self.viewer.update(name, drawn(geometry))
        return name is not None

    def remove_geometry(self, geometry: object, reset_bounding_box: bool = True) -> bool:
        """Remove a geometry. False if unknown."""
        name = self._name_of(geometry)
        if name is None:
            return False
        del self.geometries[name]
        if self.viewer is not None:
            self.viewer.remove(name)
        if reset_bounding_box:
            self.reset_view_point(True)
        return True

    def clear_geometries(self) -> bool:
        for geometry in list(self.geometries.values()):
            self.remove_geometry(geometry)
        return True

    def _name_of(self, geometry: object) -> str | None:
        return next((name for name, shown in self.geometries.items() if shown is geometry), None)

    def get_render_option(self) -> RenderOption:
        """Render options, assignable fields."""
        return self._option

    def get_view_control(self) -> ViewControl:
        return self._control

    def reset_view_point(self, reset_bounding_box: bool = False) -> None:
        """Show everything, or the bounds of the last reset."""
        bounds = self._control.bounds
        if reset_bounding_box:
            bounds = bounds_of(list(self.geometries.values())) or EMPTY_SCENE_BOUNDS
        self._control.show_box(bounds)

    def get_view_status(self) -> str:
        """The view as JSON, as copied by Ctrl+C in Open3D."""
        with tempfile.TemporaryDirectory(prefix="pointloom-") as folder:
            write_view(Path(folder) / "view.json", self._control.view(), self._control.bounds)
            return (Path(folder) / "view.json").read_text(encoding="utf-8")

    def set_view_status(self, view_status_str: str) -> None:
        """Set the view from `get_view_status`."""
        width, height = self._control.size
        with tempfile.TemporaryDirectory(prefix="pointloom-") as folder:
            (Path(folder) / "view.json").write_text(view_status_str, encoding="utf-8")
            view = read_view(Path(folder) / "view.json", width=width, height=height)
        self._control.look_from(view)

    def style_of(self, shape: Any, name: str) -> dict[str, Any]:
        return self._common_style(shape) | self.styles.get(name, {})

    def _common_style(self, shape: Any) -> dict[str, Any]:
        option, style = self._option, {"line_width": self._option.line_width}
        if isinstance(shape, TriangleMesh):
            return style | {"back_faces": option.mesh_show_back_face, "shaded": bool(option.light_on)}
        by = COLOR_BY.get(option.point_color_option)
        known = (
            hasattr(shape, "has_normals")
            and (by != "rgb" or shape.has_colors)
            and (by != "normal" or shape.has_normals)
        )
        return style | ({"color_by": by} if by and known else {})

    def _entries(self) -> list[dict[str, Any]]:
        shapes = {name: drawn(geometry) for name, geometry in self.geometries.items()}
        if self._option.show_coordinate_frame:
            shapes[FRAME] = self._coordinate_frame()
        return [{"geometry": shape, "name": name, **self.style_of(shape, name)} for name, shape in shapes.items()]

    def _coordinate_frame(self) -> TriangleMesh:
        low, high = self._control.bounds
        return TriangleMesh.create_coordinate_frame(0.2 * (float(np.max(high - low)) or 1.0), low)

    def poll_events(self) -> bool:
        """Run key callbacks. False once the window is closed."""
        if self.viewer is None:
            self._frames += 1
            return not self._closed and self._frames < UNATTENDED_FRAMES
        self._call_keys()
        self.update_renderer()
        return not self._closed and not self.viewer.wait(0)

    def update_renderer(self) -> None:
        """Apply the current view and options."""
        if self.viewer is None:
            return
        self._show_options()
        if self._control.is_moved:
            self._control.is_moved = False
            self.viewer.set_view(self._control.configured_view())

    def run(self) -> None:
        """Wait until the window is closed, running animation and key callbacks."""
        self._wait()
        self._write_image()

    def _write_image(self) -> None:
        """Without a display, write an image of a window of which no image was taken."""
        if self._writes_image and self.geometries:
            save_numbered(self._drawn())

    def _wait(self) -> None:
        while not self._closed and (self.viewer is not None or self._animation is not None):
            if self._animation is not None and self._animation(self):
                self.update_geometry()
            if not self.poll_events() or (self.viewer is not None and self.viewer.wait(CALLBACK_INTERVAL)):
                return

    def register_animation_callback(self, callback_func: Callback | None) -> None:
        """Let `run` call a function of the window repeatedly. If it returns True, everything is updated."""
        self._animation = check_callback("callback_func", callback_func)

    def _call_keys(self) -> None:
        while not self._pressed.empty():
            callback = self._callbacks.get(self._pressed.get())
            if callback is not None and callback(self):
                self.update_geometry()

    def _listen(self, key: str) -> None:
        if self.viewer is not None:
            self.viewer.on_key(key, lambda client: self._pressed.put(key))

    def _show_options(self) -> None:
        state, viewer = self._option.state(), self.viewer
        if viewer is None or state == self._option_shown:
            return
        first, self._option_shown = self._option_shown is None, state
        viewer.background, viewer.point_size = self._option.background_color, self._option.point_size
        viewer.show_normals(self._option.point_show_normal)
        viewer.show_wireframe(self._option.mesh_show_wireframe)
        if not first or self._option.show_coordinate_frame:
            if FRAME in viewer.items:
                viewer.remove(FRAME)
            for entry in self._entries():
                viewer.add(entry.pop("name"), entry.pop("geometry"), **entry)

    def capture_screen_image(self, filename: FilePath, do_render: bool = False) -> None:
        """Render the window by `loom.render` to a .png or .jpg file."""
        write_image(filename, Image(self._drawn()))

    def capture_screen_float_buffer(self, do_render: bool = False) -> Image:
        """Render the window to an image with values from 0 to 1."""
        return Image(self._drawn().astype(np.float32) / np.float32(255))

    def capture_depth_float_buffer(self, do_render: bool = False) -> Image:
        """Depth image, 0 for the background."""
        depth = np.asarray(self._drawn(depth=True)[1], np.float32)
        return Image(np.where(np.isfinite(depth), depth, np.float32(0)))

    def capture_depth_image(self, filename: FilePath, do_render: bool = False, depth_scale: float = 1000.0) -> None:
        """Write the depth image as a 16-bit .png."""
        depth = np.asarray(self.capture_depth_float_buffer()) * check_positive("depth_scale", depth_scale)
        write_image(filename, Image(np.clip(np.round(depth), 0, 65535).astype(np.uint16)))

    def capture_depth_point_cloud(
        self, filename: FilePath, do_render: bool = False, convert_to_world_coordinate: bool = False
    ) -> None:
        """Write the points of the depth image in the camera or world frame."""
        camera = self._control.convert_to_pinhole_camera_parameters()
        extrinsic = camera.extrinsic if convert_to_world_coordinate else np.eye(4)
        depth = self.capture_depth_float_buffer()
        cloud = PointCloud.create_from_depth_image(depth, camera.intrinsic, extrinsic, 1.0, 1e9)
        write_point_cloud(filename, cloud)

    def _drawn(self, *, depth: bool = False) -> Any:
        self._writes_image = False
        option = self._option
        smooth = "smooth" if option.mesh_shade_option is MeshShadeOption.Color else None
        with without_warnings(UserWarning):  # an empty window is no mistake
            return render(
                self._entries(),
                self._control.view(),
                point_size=option.point_size,
                point_show_normal=bool(option.point_show_normal),
                mesh_show_wireframe=bool(option.mesh_show_wireframe),
                background=tuple(option.background_color.tolist()),
                shading=smooth,
                depth=depth,
            )


class VisualizerWithKeyCallback(Visualizer):
    """A window with key callbacks, called during `run` or `poll_events`."""

    def register_key_callback(self, key: int, callback_func: Callback) -> None:
        """Register a key callback. If it returns True, everything is updated. None removes it.

        `key` is GLFW's number: ord("K"), 32 for space, 256 for escape, 262 to 265 for arrows, ... Raises ValueError for
        keys that pages do not report.
        """
        if key not in KEY_NAMES:
            raise ValueError(
                f"key: expected a letter, a digit or one of {', '.join(list(KEY_NAMES.values())[:15])}, got {key!r}"
            )
        self._callbacks[KEY_NAMES[key]] = check_callback("callback_func", callback_func)
        self._listen(KEY_NAMES[key])

    def register_key_action_callback(self, key: int, callback_func: Callable[[Any, int, int], Any]) -> None:
        """Like `register_key_callback`, called with (window, 1, 0): pages report key presses only."""
        check_callback("callback_func", callback_func)
        self.register_key_callback(key, lambda window: callback_func(window, 1, 0))
