"""The viewer in the browser: `Viewer`."""

from __future__ import annotations

import atexit
import contextlib
import os
import shlex
import sys
import weakref
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_name, check_rigid
from ...pcd.cloud import PointCloud
from ..notebook_output import in_notebook, live_output
from ..render.geometries import Named, named_geometries
from ..render.open3d_views import OPEN3D_KEYS
from ..render.view import View
from .client_presence import KEEP_ALIVE, Presence
from .copc_tree import CopcTree
from .items import Frame, make_item
from .scene import Scene, check_color, check_size
from .sessions import POINT_SIZE
from .timed_calls import logged


class Appearance(Scene):
    """Appearance of a scene in all pages, batched changes and screenshots."""

    @contextlib.contextmanager
    def batch(self) -> Iterator[None]:
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
        with self.server.pages.atomic():
            yield

    def tell_progress(self, text: str, fraction: float | None = None) -> None:
        """Show progress of the program in the pages.

        Args:
            text: Short description; "" when done. Raises `TypeError` if not a string.
            fraction: Fraction done, 0 to 1. None if unknown. Raises `TypeError` or `ValueError` otherwise.
        """
        with self.lock:
            self._check_open()
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
        from .screenshots import draw_scene

        with self.lock:
            viewer: Any = self  # a Viewer
            return draw_scene(viewer, viewer.get_view(client), path, self._clip_of(client))

    def save_html(self, path: str | os.PathLike[str], *, overwrite: bool = True) -> None:
        """Write the scene as a standalone HTML file with at most `max_points` points. Raises `FileError`."""
        from .screenshots import write_scene

        with self.lock:
            write_scene(self, path, overwrite=overwrite)  # type: ignore[arg-type]  # a Viewer

    @property
    def point_size(self) -> float:
        """Diameter [px] of points without a size of their own. Others scale with it. Assignable."""
        return self._point_size

    @point_size.setter
    def point_size(self, size: float) -> None:
        with self.lock:
            self._point_size, self.has_own_point_size = check_size(size), True
            for session in self._open_sessions():
                with session.as_it_lasts():
                    session.resize_points()
            self.panel.show_state()

    @property
    def background(self) -> NDArray[np.float64]:
        """Background color: red, green and blue, 0 to 1; assignable."""
        return self._background.copy()

    @background.setter
    def background(self, color: Any) -> None:
        with self.lock:
            self._background, self._has_own_background = check_color(color), True
            self._paint_background()
            self.panel.show_state()

    def color_by(self, by: str | None, *, colormap: str | None = None, limits: Any = None) -> None:
        """Color the clouds by a property of their points.

        Args:
            by: "rgb", "height", "normal", "label" or an attribute. None for the original colors. Clouds without the
                property are not changed.
            colormap, limits: See `loom.render`.

        Raises:
            ValueError: No cloud has the property, or values are out of range.
        """
        with self.lock, self.batch():
            for name, value in {"by": by, "colormap": colormap}.items():
                check_name(name, "" if value is None else value)
            self.coloring = self.coloring.checked(by, colormap, limits, self.shown.values())
            for item in self.shown.values():
                self._color(item)
                for session in self._open_sessions():
                    with session.as_it_lasts():
                        session.set_colors(item)
            self.panel.show_legend()

    def show_wireframe(self, shown: bool) -> None:
        """Show the edges of all surfaces."""
        with self.lock:
            self.wireframe = bool(shown)
            with self.batch():
                for nodes in self._nodes.values():
                    nodes.set_wireframe(self.wireframe)
            self.panel.show_state()

    def show_normals(self, shown: bool) -> None:
        """Show the normals of all clouds as lines. At most 10,000 per cloud."""
        with self.lock:
            self.normals = bool(shown)
            with self.batch():
                for nodes in self._nodes.values():
                    nodes.set_normals(self._normal_length())
            self.panel.show_state()


MAX_POINTS = 2_000_000


class Viewer(Appearance):
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

    def __init__(
        self,
        *,
        port: int = 8080,
        host: str = "127.0.0.1",
        title: str = "pointloom",
        max_points: int = MAX_POINTS,
        point_size: float = POINT_SIZE,
        background: Any = (1.0, 1.0, 1.0),
        size: tuple[int, int] = (1280, 960),
    ):
        super().__init__(
            port,
            host,
            title,
            check_count("max_points", max_points),
            check_size(point_size),
            check_color(background),
            (check_count("width", size[0]), check_count("height", size[1])),
        )
        self._presence = Presence(self)
        close_at_exit(self)

    def __repr__(self) -> str:
        return f"Viewer({self.url}, {len(self.shown)} geometries{', closed' if self.closed else ''})"

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """For notebooks: the page in a frame, with a static image as fallback."""
        if self.closed:
            return {"text/plain": repr(self)}
        return live_output(repr(self), self.url, self.ssh_line, self.screenshot(), self._size[1] * 2 // 3)

    def __enter__(self) -> Viewer:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def add(self, name: str, geometry: Any, **style: Any) -> None:
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
        check_name("name", name)
        colormap = {name: check_name(name, style[name]) for name in ("colormap",) if style.get(name) is not None}
        self.add_named(named_geometries([{"geometry": geometry, "name": name, **style, **colormap}]))

    def add_all(self, geometries: Any) -> None:
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
        self.add_named(named_geometries(geometries))

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
        self.add_named(
            named_geometries([{"geometry": tree.head, "name": check_name("name", name), **style}]), {name: tree}
        )

    @logged
    def add_named(self, named: list[Named], trees: Mapping[str, Any] = MappingProxyType({})) -> None:
        """Add the result of `named_geometries`, with optional level-of-detail trees by name."""
        with self.lock, self.batch():
            self._check_open()
            self._check_units(named)
            made = []
            for name, geometry, style in named:
                made.append(make_item(name, self._next_number, geometry, style, trees.get(name)))
                self._next_number += 1
            was_empty = not len(self._extents)
            for item in made:
                self._take_out(item.name)
                self._take_in(item)
                self._color(item)
                if item.tree is None and isinstance(item.geometry, PointCloud):
                    self._levels.build(item)
            if was_empty:
                self._choose_frame()
            for item in made:
                self._show(item)
                self.panel.put_item(item)
            self._arrivals.note()
            self._changed(was_empty)

    @logged
    def update(self, name: str, geometry: Any) -> None:
        """Replace a geometry without flicker, keeping style, pose and visibility. Raises `KeyError`."""
        with self.lock:
            self._check_open()
            old = self._find(name)
            item = make_item(name, old.number, geometry, old.style)
            item.visible, item.pose = old.visible, old.pose
            was_empty = not len(self._extents)
            self._levels.forget(name)
            self._take_in(item)
            self._color(item)
            if was_empty:
                self._choose_frame()
            self._show(item)
            self.panel.put_item(item)
            self._changed(was_empty)

    @logged
    def remove(self, name: str) -> None:
        """Remove a geometry from the scene. Raises `KeyError` for an unknown name."""
        with self.lock:
            self._check_open()
            self._find(name)
            self._take_out(name)
            self._changed(False)

    @logged
    def clear(self) -> None:
        """Remove all geometries. The view is fitted again to the next one."""
        with self.lock, self.batch():
            self._check_open()
            for name in list(self.shown):
                self._take_out(name)
            self.frame = Frame(np.zeros(3))
            self._changed(False)

    @logged
    def set_pose(self, name: str, T: Any) -> None:
        """Move a geometry. Sends 84 bytes to each page, independent of its size.

        Args:
            name: Name of a geometry in the scene.
            T: T_world_geometry, rigid transformation [m], shape (4, 4).

        Raises:
            KeyError, ValueError: Unknown name, or not a rigid transformation.
        """
        with self.lock:
            self._check_open()
            item = self._find(name)
            item.pose = check_rigid("T", T).copy()  # the caller may change its array later
            self._nodes[name].set_pose()
            for session in self._open_sessions():
                with session.as_it_lasts():
                    session.set_pose(item)
            self._extents.put(name, item.world_bounds())
            self._changed(False)

    @logged
    def set_visible(self, name: str, visible: bool) -> None:
        """Show or hide a geometry. Raises `KeyError` for an unknown name."""
        with self.lock:
            self._check_open()
            item = self._find(name)
            item.visible = bool(visible)
            self._nodes[name].set_visible(item.visible)
            for session in self._open_sessions():
                with session.as_it_lasts():
                    session.set_visible(item)
            self.panel.put_item(item)
            self._changed(False)

    def set_view(self, view: Any = None, **parameters: Any) -> None:
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
            self._check_open()
            home = self._take_view(parameters or view)
            self._aim_first_camera()
            for session in self._open_sessions():
                with session.as_it_lasts():
                    session.look_from(home)

    def get_view(self, client: int | None = None) -> View:
        """Current view of a page, given by its number in `sessions`.

        If `client` is None: the oldest page, or the initial view if no page is open. Raises `KeyError` for an unknown
        page.
        """
        with self.lock:
            if client is None:
                first = next(iter(self.sessions.values()), None)
                return self.home() if first is None else first.camera_view()
            if not isinstance(client, int) or client not in self.sessions:
                raise KeyError(f"client: expected one of the pages {sorted(self.sessions)}, got {client!r}")
            return self.sessions[client].camera_view()

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
        self._close(shutdown_notice())

    def _close(self, words: str) -> None:
        if not self.closed and not self.server.closed:
            self.server.pages.end(words)
        self._ended.set()
        threads = self._let_go()
        self.server.close()
        for thread in threads:
            thread.join()


_open: weakref.WeakSet[Viewer] = weakref.WeakSet()


def close_at_exit(viewer: Viewer) -> None:
    """Close a viewer at the end of the process if it is still open."""
    _open.add(viewer)


@atexit.register
def _close_all() -> None:
    for viewer in list(_open):
        if not viewer.server.closed:  # closed in the copy of a forked child, which has no page
            with contextlib.suppress(Exception):  # the interpreter is shutting down
                viewer.close()


def shutdown_notice() -> str:
    """Shutdown notice: the program has ended, and how to restart it."""
    if in_notebook():
        again = "Run the cell again to see it again."
    else:
        command = _command(sys.argv)
        again = f"To start it again:\n{command}" if command else "The program can open another viewer."
    return f"The viewer has been closed. {again}"


def _command(arguments: list[str]) -> str:
    """Command line of this program; "" if unknown, as in an interpreter."""
    name = Path(arguments[0]).name if arguments else ""
    if name in ("", "-", "-c", "-m"):
        return ""
    if name in ("pointloom", "pointloom.exe") or (name == "__main__.py" and "pointloom" in arguments[0]):
        return shlex.join(["pointloom", *arguments[1:]])
    return f"python {shlex.quote(name)}"
