"""The viewer in the browser: `Viewer`."""

from __future__ import annotations

import atexit
import contextlib
import os
import weakref
from collections.abc import Callable, Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.attribute_hints import nearest_name
from ...core.checks import check_count, check_name, check_positive
from ...core.open3d_names import hint, row_of
from ..notebook_output import live_output
from ..render.geometries import Named, named_geometries
from ..render.open3d_views import OPEN3D_KEYS
from ..render.parts import Triple
from ..render.view import View, ViewLike
from .client_presence import KEEP_ALIVE, Presence
from .controls import DEFAULT_FOLDER, Control
from .copc_tree import CopcTree
from .extents import Bounds
from .hooks import Hooks, check_function
from .items import Item
from .keys import check_hotkey
from .live_timeline import HISTORY_BYTES
from .page_actions import PageActions
from .panel import Panel
from .panel_sections import TOOLS_ORDER
from .scene import POINT_SIZE, Scene, check_color, check_size
from .scene_display import SceneDisplay
from .scene_edits import SceneEdits
from .screenshots import draw_scene, write_scene
from .server import ViewerServer
from .sessions import Session
from .shutdown_notice import shutdown_notice
from .tools.picking import Pick
from .tools.toolbox import Toolbox

if TYPE_CHECKING:
    from ...registration.lidar.lidar_slam import LidarSLAM
    from .link import PageClient

MAX_FRAME_RATE = 240.0  # [Hz] of frame callbacks
MAX_POINTS = 2_000_000


class Viewer:
    """A scene in the browser that a program updates, on this machine or over SSH.

    `viewer.update(name, geometry)` from any thread replaces Open3D's sequence of update_geometry, poll_events and
    update_renderer.

    Args:
        port: Port of the server. If it is in use, the next free one. 0 takes any.
        host: Address to listen on. Any address except 127.0.0.1 makes the viewer reachable from the network.
        title: Title of the page.
        max_points: Maximum number of points of all clouds in a page. Larger scenes are sent in levels of detail.
        point_size: Diameter of points without a size of their own [px].
        background: Red, green and blue, 0 to 1.
        size: Width and height of screenshots if no page is open, and height of the frame in a notebook [px].

    Attributes:
        url: Address of the page.
        ssh_line: Command to run on the local machine if this machine is reached over SSH.
        items: Geometries of the scene by name.

    Raises:
        PointloomError: The extra is not installed, or no port is free.

    Notes:
        Needs memory for the displayed geometries, once more for each page, and a few threads; `close` frees all of it.
        All methods are thread-safe.

    Example:
        >>> import pointloom as loom
        >>> with loom.Viewer(port=0) as viewer:
        ...     viewer.add("cloud", loom.PointCloud([[0, 0, 0], [1, 0, 0]]))
        ...     for step in range(3):
        ...         viewer.update("cloud", loom.PointCloud([[0, 0, step], [1, 0, 0]]))
        ...     list(viewer.items)
        ['cloud']
    """

    history_bytes = HISTORY_BYTES

    def __init__(
        self,
        *,
        port: int = 8080,
        host: str = "127.0.0.1",
        title: str = "pointloom",
        max_points: int = MAX_POINTS,
        point_size: float = POINT_SIZE,
        background: ArrayLike = (1.0, 1.0, 1.0),
        size: tuple[int, int] = (1280, 960),
    ):
        self.scene = Scene(
            check_count("max_points", max_points),
            check_size(point_size),
            check_color(background),
            (check_count("width", size[0]), check_count("height", size[1])),
        )
        self.lock, self.server = self.scene.lock, ViewerServer(host, port, title=title)
        self.url, self.ssh_line = self.server.url, self.server.ssh_line
        try:
            pages = self.server.pages
            self.panel = Panel(self.scene, pages)
            self.display = SceneDisplay(self.scene, self.server, self.panel)
            self.sessions: Mapping[int, Session] = self.display.sessions
            self.edits = SceneEdits(self.display)
            self.hooks = Hooks(self.display, PageActions(self.display, self.edits))
            pages.on_client_connect(self._connect)
            pages.on_client_disconnect(self.display.disconnect)
        except BaseException:
            self.server.close()
            raise
        self._presence = Presence(self.display)
        self.closing_notice: str | None = None  # in the pages after `close`. None: how to restart the program
        _open.add(self)

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:  # called only for missing attributes
            remedy = "" if name.startswith("_") else hint(row_of(name, ("Visualizer",)))
            remedy = remedy or nearest_name(name, dir(type(self)))
            raise AttributeError(f"{type(self).__name__} has no attribute {name!r}{remedy}")

    def __repr__(self) -> str:
        return f"Viewer({self.url}, {len(self.scene.shown)} geometries{', closed' if self.closed else ''})"

    def _repr_mimebundle_(
        self, include: Iterable[str] | None = None, exclude: Iterable[str] | None = None
    ) -> dict[str, Any]:
        """For notebooks: the page in a frame, with a static image as fallback."""
        if self.closed:
            return {"text/plain": repr(self)}
        return live_output(repr(self), self.url, self.ssh_line, self.screenshot(), self.scene.size[1] * 2 // 3)

    def __enter__(self) -> Viewer:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def add(self, name: str, geometry: object, **style: Any) -> None:
        """Add a geometry to the scene, replacing one of the same name. Use `batch` to add many at once.

        Args:
            name: Unique name. Names with "/" are listed in groups: "cars/7".
            geometry: A cloud, mesh, box, line set, trajectory, voxel grid, frustum or another type that `loom.render`
                draws.
            style: color, color_by, colormap, limits, point_size, metric, line_width, wireframe, back_faces, shaded,
                pose, see `loom.render`.

        Raises:
            TypeError: Unsupported geometry, or unknown style key.
        """
        self.edits.add(name, geometry, **style)

    def add_all(self, geometries: object) -> None:
        """Add several geometries atomically, replacing those of the same names.

        Args:
            geometries: A mapping of names to geometries, or a list of geometries or of dictionaries as in `loom.draw`:
                {"geometry": g, "name": "floor", "color": (1, 0, 0)}. Several clouds without colors get different ones.

        Raises:
            TypeError, ValueError: Unsupported geometry, unknown style key, or a value out of range. Nothing is added.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_all({f"cars/{k}": np.full((1, 3), k) for k in range(3)})
            ...     list(viewer.items)
            ['cars/0', 'cars/1', 'cars/2']
        """
        self.edits.add_named(named_geometries(geometries))

    def add_copc(self, name: str, path: str | os.PathLike[str], **style: Any) -> None:
        """Add a COPC file (.copc.laz) of any size. Only the visible parts are read.

        Tools (picking, measuring, cropping) use the coarse levels, 250,000 points, available as `items[name]`.

        Args:
            name: See `add`.
            path: The file. It must not change while the viewer is open.
            style: See `add`.

        Raises:
            FileError: Not a COPC file, or no coarse node is readable. Nodes that are damaged are skipped with a warning
                of the logger "pointloom.viewer".
            TypeError: Unknown style key.

        Notes:
            Needs at most 256 MB for decoded nodes, plus the data sent to a page.
        """
        tree = CopcTree(path)
        entry = {"geometry": tree.head, "name": check_name("name", name), **style}
        self.add_named(named_geometries([entry], {name} if tree.has_colors else ()), {name: tree})

    def add_named(self, named: list[Named], trees: Mapping[str, Any] = MappingProxyType({})) -> None:
        """Add the result of `named_geometries`, with optional level-of-detail trees by name."""
        self.edits.add_named(named, trees)

    def update(self, name: str, geometry: object) -> None:
        """Replace a geometry without flicker, keeping style, pose and visibility. Raises `KeyError`."""
        self.edits.update(name, geometry)

    def remove(self, name: str) -> None:
        """Remove a geometry from the scene. Raises `KeyError` for an unknown name."""
        self.edits.remove(name)

    def clear(self) -> None:
        """Remove all geometries. The view is fitted again to the next one."""
        self.edits.clear()

    def set_pose(self, name: str, T: ArrayLike) -> None:
        """Move a geometry. Sends 84 bytes to each page, independent of its size.

        Args:
            name: Name of a geometry in the scene.
            T: T_world_geometry, rigid transformation [m], shape (4, 4).

        Raises:
            KeyError, ValueError: Unknown name, or not a rigid transformation.
        """
        self.edits.set_pose(name, T)

    def set_visible(self, name: str, visible: bool) -> None:
        """Show or hide a geometry. Raises `KeyError` for an unknown name."""
        self.edits.set_visible(name, visible)

    @property
    def items(self) -> Mapping[str, Item]:
        """Geometries of the scene by name. Always the newest state, also if the pages show an earlier time."""
        return self.edits.items

    def batch(self) -> contextlib.AbstractContextManager[None]:
        """Apply several changes in all pages at once.

        Batches may be nested. Changes by other threads are delayed until the batch ends, at most one second. An
        exception ends the batch. Changes made before it are displayed.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     with viewer.batch():
            ...         for k in range(100):
            ...             viewer.add(f"boxes/{k}", loom.AxisAlignedBoundingBox([k, 0, 0], [k + 0.5, 1, 1]))
            ...     len(viewer.items)
            100
        """
        return self.display.batch()

    @property
    def bounds(self) -> Bounds:
        """Lowest and highest corner of the scene [m]. A 2 m box if it is empty."""
        return self.scene.bounds

    @property
    def closed(self) -> bool:
        """True after `close`."""
        return self.scene.closed

    def home(self) -> View:
        """Initial view of pages: that of `set_view`, else the complete scene."""
        return self.scene.home()

    @property
    def up(self) -> Triple | None:
        """Up axis of the initial view. Assign "x", "y", "z" or a direction.

        If None, that of the first mesh that defines one (.glb, .gltf), else z.
        """
        return self.scene.up

    @up.setter
    def up(self, value: ArrayLike | str | None) -> None:
        self.scene.up = value

    def set_view(self, view: ViewLike = None, **parameters: Any) -> None:
        """Set the camera of all current and later pages. The key R in a page resets to it.

        Args:
            view: A `View`, the path of an Open3D view JSON, a mapping of Open3D's parameters, or None to show the
                complete scene.
            parameters: zoom, front, lookat, up, field_of_view, as in Open3D's `draw_geometries`.

        Raises:
            TypeError, ValueError: Unsupported `view`, both are given, or a parameter is out of range.
        """
        if parameters and view is not None:
            raise TypeError("view: expected a view or Open3D's parameters, not both")
        unknown = [key for key in parameters if key not in OPEN3D_KEYS]
        if unknown:
            raise TypeError(f"parameters: expected the keys {', '.join(OPEN3D_KEYS)}, got {unknown[0]!r}")
        with self.lock:
            self.scene.check_open()
            self.display.set_view(parameters or view)

    def get_view(self, client: int | None = None) -> View:
        """Current view of a page, given by its number in `sessions`.

        If `client` is None: the oldest page, or the initial view if no page is open. Raises `KeyError` for an unknown
        page.
        """
        return self.display.view_of(client)

    @property
    def point_size(self) -> float:
        """Diameter [px] of points without a size of their own. Others scale with it. Assignable."""
        return self.scene.point_size

    @point_size.setter
    def point_size(self, size: float) -> None:
        self.display.set_point_size(size)

    @property
    def background(self) -> NDArray[np.float64]:
        """Background color: red, green and blue, 0 to 1; assignable."""
        return self.scene.background.copy()

    @background.setter
    def background(self, color: ArrayLike) -> None:
        self.display.set_background(color)

    def color_by(self, by: str | None, *, colormap: str | None = None, limits: ArrayLike | None = None) -> None:
        """Color the clouds by a property of their points.

        Args:
            by: "rgb", "height", "normal", "label" or an attribute. None for the original colors. Clouds without the
                property are not changed.
            colormap, limits: See `loom.render`.

        Raises:
            ValueError: No cloud has the property, or values are out of range.
        """
        for name, value in {"by": by, "colormap": colormap}.items():
            check_name(name, "" if value is None else value)
        self.display.color_by(by, colormap, limits)

    def show_wireframe(self, shown: bool) -> None:
        """Show the edges of all surfaces."""
        self.display.show_wireframe(bool(shown))

    def show_normals(self, shown: bool) -> None:
        """Show the normals of all clouds as lines. At most 10,000 per cloud."""
        self.display.show_normals(bool(shown))

    def tell_progress(self, text: str, fraction: float | None = None) -> None:
        """Show progress of the program in the pages.

        Args:
            text: Short description; "" when done. Raises `TypeError` if not a string.
            fraction: Fraction done, 0 to 1. None if unknown. Raises `TypeError` or `ValueError` otherwise.
        """
        with self.lock:
            self.scene.check_open()
            self.server.pages.set_progress(check_name("text", text), fraction)

    def screenshot(self, path: str | os.PathLike[str] | None = None, *, client: int | None = None) -> NDArray[np.uint8]:
        """Render the scene as a page shows it. No page needs to be open.

        Args:
            path: A .png file to write, or None.
            client: Number of the page, see `get_view`.

        Returns:
            Image of shape (h, w, 3), uint8.

        Raises:
            FileError: The file cannot be written.
        """
        with self.lock:
            view, clip = self.display.view_of(client), self.display.clip_of(client)
            return draw_scene(self.scene, view, path, clip)

    def save_html(self, path: str | os.PathLike[str], *, overwrite: bool = True) -> None:
        """Write the scene as a standalone HTML file with at most `max_points` points. Raises `FileError`."""
        with self.lock:
            view, clip = self.display.view_of(None), self.display.clip_of(None)
            write_scene(self.scene, view, path, clip, overwrite=overwrite)

    def add_button(
        self,
        label: str,
        callback: Callable[[int], Any],
        *,
        hotkey: str | None = None,
        folder: str = DEFAULT_FOLDER,
        hint: str = "",
    ) -> Control:
        """Add a button to the panel of all pages and to the command palette (Ctrl+K).

        Args:
            label: Label of the button.
            callback: Called with the number of the page in which the button was pressed.
            hotkey: Key with the same effect, see `on_key`.
            folder: Folder of the panel; created if missing.
            hint: Tooltip.

        Returns:
            The control. Its `remove()` removes the button.

        Raises:
            TypeError, ValueError: An argument of another type, an unknown key, or an empty label.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_button("Next scan", lambda page: print("pressed in page", page), hotkey="G")
            Control('Next scan')
        """
        return self.hooks.controls.add_button(label, callback, hotkey, folder, hint)

    def add_slider(
        self,
        label: str,
        low: float,
        high: float,
        value: float,
        callback: Callable[[Any], Any] | None = None,
        *,
        step: float | None = None,
        folder: str = DEFAULT_FOLDER,
    ) -> Control:
        """Add a slider to the panel of all pages. It is integer if all given numbers are integers.

        Args:
            label: Label of the slider.
            low, high: Range.
            value: Initial value.
            callback: Called with the value after a page has changed it. Only with the newest if several wait. If None,
                the program reads `value`.
            step: Step size. If None, 1 or a hundredth of the range.
            folder: See `add_button`.

        Raises:
            TypeError, ValueError: Not a number, not callable, or `value` or `step` out of range.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_slider("neighbors", 4, 64, 20).value, viewer.add_slider("radius", 0.0, 1, 0.5).value
            (20, 0.5)
        """
        return self.hooks.controls.add_slider(label, low, high, value, callback, step, folder)

    def add_checkbox(
        self,
        label: str,
        value: bool = False,
        callback: Callable[[bool], Any] | None = None,
        *,
        folder: str = DEFAULT_FOLDER,
    ) -> Control:
        """Add a checkbox to the panel of all pages. Arguments and errors as in `add_slider`.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_checkbox("ground", True).value
            True
        """
        return self.hooks.controls.add_checkbox(label, value, callback, folder)

    def add_dropdown(
        self,
        label: str,
        options: Sequence[str],
        callback: Callable[[str], Any] | None = None,
        value: str | None = None,
        *,
        folder: str = DEFAULT_FOLDER,
    ) -> Control:
        """Add a dropdown list to the panel of all pages. If `value` is None, the first option is selected.

        Raises:
            TypeError, ValueError: Options that are not strings, empty or duplicate, or `value` is not an option.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_dropdown("method", ["icp", "gicp"], value="gicp").value
            'gicp'
        """
        return self.hooks.controls.add_dropdown(label, options, callback, value, folder)

    def add_text(
        self, label: str, value: str = "", callback: Callable[[str], Any] | None = None, *, folder: str = DEFAULT_FOLDER
    ) -> Control:
        """Add a text field (at most 16,384 characters) to the panel of all pages.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_text("name", "scan 7").value
            'scan 7'
        """
        return self.hooks.controls.add_text(label, value, callback, folder)

    def on_key(self, key: str, callback: Callable[[int], None], label: str = "") -> None:
        """Call a function when a key is pressed in a page. Replaces the default action of the key.

        Args:
            key: "A" to "Z", "0" to "9", "space", "enter", "escape", "tab", "backspace", "delete", "insert", "home",
                "end", "pageup", "pagedown", "arrowup", "arrowdown", "arrowleft" or "arrowright".
            callback: Called with the number of the page.
            label: Description in the command palette (Ctrl+K). If "", the name of the key.

        Raises:
            ValueError, TypeError: Unknown key, or `callback` is not callable.
        """
        check_function(callback)
        self.scene.check_open()
        self.hooks.on_key(check_hotkey(key), callback, check_name("label", label or key))

    def on_pick(self, callback: Callable[[Pick], Any]) -> Callable[[], None]:
        """Call a function with the point or triangle at each click, while no tool is active.

        Args:
            callback: Called with a `Pick`: name, index of the point (or triangle), world position and attributes. All
                points are searched, also those that are not drawn. Clicks on the background are ignored. Raises
                `TypeError` if not callable.

        Returns:
            A function that removes the callback.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     stop = viewer.on_pick(lambda pick: print(pick.name, pick.index, pick.point, pick.attributes))
            ...     stop()
        """
        check_function(callback)
        return self.hooks.on_pick(callback)

    def on_frame(self, callback: Callable[[float], Any], rate: float = 30.0) -> Callable[[], None]:
        """Call a function repeatedly while a page is open, for animations.

        Args:
            callback: Called with the seconds since the last call. 0 for the first call and for the first one after no
                page was open. An exception ends the calls and is displayed in all pages.
            rate: Maximum number of calls per second, in (0, 240]; limited by the drawing speed of the fastest page.

        Returns:
            A function that ends the calls.

        Raises:
            TypeError, ValueError: `callback` is not callable, or `rate` is not a number or out of range.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     stop = viewer.on_frame(lambda seconds: None, rate=10)
            ...     stop()
        """
        check_function(callback)
        return self.hooks.calls.every(1.0 / check_positive("rate", rate, maximum=MAX_FRAME_RATE), callback)

    def set_time(self, t: float) -> None:
        """Start a new time step. Later changes of the scene belong to it.

        From the second step on, all pages share a timeline of the history. At its end it follows the newest step.

        Args:
            t: Time [s] or frame number. Not before the newest step.

        Raises:
            TypeError, ValueError: `t` is not a number, not finite, or before the newest step.

        Notes:
            A step takes memory for its changes only. Beyond `history_bytes` of the viewer (1 GiB) the oldest steps are
            dropped, with one notice.

        Example:
            >>> import pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     for frame in range(3):
            ...         viewer.set_time(frame)
            ...         viewer.add("cloud", loom.PointCloud([[frame, 0, 0], [1, 1, 1]]))
            ...     viewer.show_time(1)
            ...     viewer.items["cloud"].cloud.points[0].tolist()
            [2.0, 0.0, 0.0]
        """
        self.edits.set_time(t, self.history_bytes)

    def show_time(self, t: float | None = None) -> None:
        """Show the scene at a time in all pages. If None, follow the newest step.

        Raises `TypeError` for another type and `ValueError` if there is no history because `set_time` was never called.
        """
        self.edits.show_time(t)

    def follow(self, slam: LidarSLAM) -> contextlib.AbstractContextManager[None]:
        """Show the map of a `LidarSLAM`, its path and its loops, while it registers scans inside a `with` block.

        The scene changes when a submap is finished: the submap is added, colored by height above the scanner, and all
        submaps move to their corrected poses. At most 20,000 points of a submap are shown. Scans that other threads
        register are not shown until this thread registers the next. Closing the viewer does not stop the mapping.

        Raises:
            TypeError: Not a LidarSLAM.

        Example:
            >>> import pointloom as loom
            >>> slam, scans = loom.registration.LidarSLAM(max_range=30), []
            >>> with loom.Viewer(port=0) as viewer, viewer.follow(slam):
            ...     for scan in scans:
            ...         T = slam.register(scan)
        """
        from .live_map import following

        return following(self.edits, slam)

    def save_recording(self, path: str | os.PathLike[str], **options: Any) -> None:
        """Write the history since `set_time` as a recording with one frame per time step.

        The view is that of a page or of `set_view`. Without either, all of the scene is visible at all times.

        Args:
            path: The file, in a format of `record`.
            **options: fps, size, max_points, max_frames, title, background, overwrite, see `loom.record`.

        Raises:
            ValueError: No history, or an option is out of range.
            TypeError: Unknown option.
            FileError: The file cannot be written.

        Example:
            >>> import os, tempfile, pointloom as loom
            >>> with loom.Viewer(port=0) as viewer, tempfile.TemporaryDirectory() as folder:
            ...     for frame in range(3):
            ...         viewer.set_time(frame)
            ...         viewer.add("cloud", loom.PointCloud([[frame, 0, 0], [1, 1, 1]]))
            ...     viewer.save_recording(f"{folder}/run.html")
            ...     os.listdir(folder)
            ['run.html']
        """
        from .live_recording import write_history

        write_history(self.edits, path, **options)

    def take_lock(self) -> bool:
        """Take `lock` in a thread that `close` may wait for. False if the viewer is closed."""
        return self.scene.take_lock()

    def catch_up(self) -> None:
        """Apply scheduled updates at once."""
        self.display.catch_up()

    def wait(self, seconds: float | None = None, *, keep_alive: float = KEEP_ALIVE) -> bool:
        """Wait until all pages were closed for a while, or the viewer is closed.

        When the last page closes, a message on stderr shows how to end the wait at once. Reopening or reloading a page
        continues it.

        Args:
            seconds: Timeout [s]. The result is False if it expires, else True. None: no timeout.
            keep_alive: Time without a page after which the wait ends [s]; `math.inf`: wait for another page forever.

        Raises:
            KeyboardInterrupt: Ctrl-C.
            ValueError: Negative time.
        """
        return self._presence.wait(seconds, keep_alive)

    def close(self) -> None:
        """Free port, threads and memory. Pages show that the viewer is closed and how to restart it."""
        if not self.closed and not self.server.closed:
            self.server.pages.end(shutdown_notice() if self.closing_notice is None else self.closing_notice)
        self.scene.shut_down()
        with self.lock:
            threads = [*self.display.shut_down(), *self.hooks.close()]
            self.edits.close()
        self.server.close()
        for thread in threads:
            thread.join()

    def _connect(self, client: PageClient) -> None:
        def make_tools(session: Session) -> Toolbox:
            return Toolbox(session, self.edits, client.gui.add_folder("Tools", order=TOOLS_ORDER))

        self.display.connect(client, make_tools)


_open: weakref.WeakSet[Viewer] = weakref.WeakSet()


@atexit.register
def _close_all() -> None:
    for viewer in list(_open):
        if not viewer.server.closed:  # closed in the copy of a forked child, which has no page
            with contextlib.suppress(Exception):  # the interpreter is shutting down
                viewer.close()
