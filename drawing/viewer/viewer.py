"""The viewer in the browser: `Viewer`."""

from __future__ import annotations

import os
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_name, check_rigid
from ...pcd.cloud import PointCloud
from ..notebook_output import live_output
from ..render.geometries import Named, named_geometries
from ..render.open3d_views import OPEN3D_KEYS
from ..render.view import View
from .detail_tree import DetailTree
from .items import Frame, make_item
from .presence import LINGER, Presence
from .scene import Scene, check_color, check_size
from .sessions import POINT_SIZE

MOST_POINTS = 2_000_000


class Viewer(Scene):
    """A scene in the browser, kept up to date by a program: on this machine, or over SSH on another one.

    What Open3D's `Visualizer` does with add_geometry, update_geometry, poll_events and update_renderer is
    `viewer.update(name, geometry)`: from any thread, and the page shows it without a flicker.

    Args:
        port: Of the server; where it is taken, the next free one. 0 takes any.
        host: The address that it listens on. With another than 127.0.0.1 whoever reaches the machine sees the scene.
        title: Of the page.
        max_points: Of all clouds together in one page; of more, levels of detail are sent, as the camera rests.
        point_size: Diameter of points that have none of their own [px].
        background: Red, green and blue, 0 to 1.
        size: Columns and rows of pictures where no page is open, and the height of the frame in a notebook [px].

    Attributes:
        url: Where the page is.
        ssh_line: What to run on one's own machine where this one is reached over SSH.
        items: What is in the scene, by name.

    Raises:
        PointloomError: The extra is not installed, with the line that installs it; or no port is free.

    Notes:
        Takes the memory of what is shown, once more for each page, and a few threads; `close` gives all of it back.
        All methods may be called from any thread.

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
        max_points: int = MOST_POINTS,
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

    def __repr__(self) -> str:
        return f"Viewer({self.url}, {len(self.items)} geometries{', closed' if self.closed else ''})"

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """The page in a frame over a still of it, for notebooks."""
        if self.closed:
            return {"text/plain": repr(self)}
        return live_output(repr(self), self.url, self.ssh_line, self.screenshot(), self._size[1] * 2 // 3)

    def __enter__(self) -> Viewer:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    # -- the scene ----------------------------------------------------------------------------------------------------

    def add(self, name: str, geometry: Any, **style: Any) -> None:
        """Add a geometry to the scene; one of the same name goes.

        Args:
            name: What it is called, in the page's list too.
            geometry: A cloud, mesh, box, line set, trajectory, voxel grid, frustum or another that `loom.render` draws.
            style: color, color_by, colormap, limits, point_size, metric, line_width, wireframe, back_faces, shaded,
                pose, as of `loom.render`.

        Raises:
            TypeError: A geometry of no known kind, or a key of style that there is none.
        """
        check_name("name", name)
        colormap = {name: check_name(name, style[name]) for name in ("colormap",) if style.get(name) is not None}
        self.add_all(named_geometries([{"geometry": geometry, "name": name, **style, **colormap}]))

    def add_all(self, named: list[Named], trees: Mapping[str, DetailTree] = MappingProxyType({})) -> None:
        """Add several geometries at once, as of `named_geometries`, some perhaps with levels of detail by name."""
        with self.lock:
            self._check_open()
            self._check_units(named)
            made = []
            for name, geometry, style in named:
                made.append(make_item(name, self._next_number, geometry, style, trees.get(name)))
                self._next_number += 1
            was_empty = self._scene_bounds() is None
            for item in made:
                self._take_out(item.name)
                self.items[item.name] = item
                self._color(item)
                if item.tree is None and isinstance(item.geometry, PointCloud):
                    self._build_levels(item)
            if was_empty:
                self._settle()
            with self.server.viser.atomic():
                for item in made:
                    self._show(item)
            self._changed(was_empty)

    def update(self, name: str, geometry: Any) -> None:
        """Show another geometry under a name, all at once and without a flicker; style, pose and visibility stay.

        Args:
            name: Of a geometry in the scene.
            geometry: What is shown from now on; what was shown is let go.

        Raises:
            KeyError: There is none of that name; names those that there are.
        """
        with self.lock:
            self._check_open()
            old = self._find(name)
            item = make_item(name, old.number, geometry, old.style)
            item.visible, item.pose = old.visible, old.pose
            was_empty = self._scene_bounds() is None
            self._coming.pop(name, None)
            self.items[name] = item
            self._color(item)
            if was_empty:
                self._settle()
            self._show(item)
            self._changed(was_empty, listed=False)

    def remove(self, name: str) -> None:
        """Take a geometry out of the scene.

        Raises:
            KeyError: There is none of that name.
        """
        with self.lock:
            self._check_open()
            self._find(name)
            self._take_out(name)
            self._changed(False)

    def clear(self) -> None:
        """Take all out of the scene; what comes next is looked at anew."""
        with self.lock:
            self._check_open()
            for name in list(self.items):
                self._take_out(name)
            self.frame = Frame(np.zeros(3))
            self._changed(False)

    def set_pose(self, name: str, T: Any) -> None:
        """Move a geometry: 84 bytes for each page, whatever its size.

        Args:
            name: Of a geometry in the scene.
            T: T_world_geometry, a rigid 4x4 [m].

        Raises:
            KeyError: There is none of that name.
            ValueError: No rigid motion.
        """
        with self.lock:
            self._check_open()
            item = self._find(name)
            item.pose = check_rigid("T", T)
            self._nodes[name].set_pose()
            for session in self._open_sessions():
                with session.as_it_lasts():
                    if name in session.streams:
                        session.streams[name].set_pose(item.pose_of(item.parts[0]))
                    session.refresh_tools()
            self._reach()

    def set_visible(self, name: str, visible: bool) -> None:
        """Show or hide a geometry.

        Raises:
            KeyError: There is none of that name.
        """
        with self.lock:
            self._check_open()
            item = self._find(name)
            item.visible = bool(visible)
            self._nodes[name].set_visible(item.visible)
            for session in self._open_sessions():
                with session.as_it_lasts():
                    if name in session.streams:
                        session.streams[name].set_visible(item.visible)
                    session.tell()
                    session.refresh_tools()
            self.panel.list_items()

    # -- where from ---------------------------------------------------------------------------------------------------

    def set_view(self, view: Any = None, **parameters: Any) -> None:
        """Look from somewhere, in all pages and those that come later; R in the page comes back to it.

        Args:
            view: A `View`, a file of Open3D's view JSON, a mapping of Open3D's parameters, or None to see all.
            parameters: zoom, front, lookat, up, field_of_view, as of Open3D's `draw_geometries`.

        Raises:
            TypeError: Something else, or both.
            ValueError: A parameter out of range.
        """
        if parameters and view is not None:
            raise TypeError("view: expected a view or Open3D's parameters, not both")
        unknown = [key for key in parameters if key not in OPEN3D_KEYS]
        if unknown:
            raise TypeError(f"parameters: unknown {unknown[0]!r}; there are {', '.join(OPEN3D_KEYS)}")
        with self.lock:
            self._check_open()
            home = self._take_view(parameters or view)
            self._aim_first_camera()
            for session in self._open_sessions():
                with session.as_it_lasts():
                    session.look_from(home)

    def get_view(self, client: int | None = None) -> View:
        """What a page shows.

        Args:
            client: The number of the page in `sessions`; None for the one that has been there longest, or where there
                is none, what the next one will show.

        Raises:
            KeyError: No such page.
        """
        with self.lock:
            if client is None:
                first = next(iter(self.sessions.values()), None)
                return self.home() if first is None else first.camera_view()
            if not isinstance(client, int) or client not in self.sessions:
                raise KeyError(f"client: no page {client!r}; there are {sorted(self.sessions)}")
            return self.sessions[client].camera_view()

    # -- what is seen -------------------------------------------------------------------------------------------------

    def screenshot(self, path: str | os.PathLike[str] | None = None, *, client: int | None = None) -> NDArray[np.uint8]:
        """A picture of the scene as a page shows it, drawn here: no page needs to be open.

        Args:
            path: A .png file to write; None writes none.
            client: The page whose view it is, as of `get_view`.

        Returns:
            Shape [h, w, 3], uint8.

        Raises:
            FileError: The place cannot be written.
        """
        from .stills import draw_scene

        with self.lock:
            return draw_scene(self, self.get_view(client), path, self.clip_of(client))

    def save_html(self, path: str | os.PathLike[str], *, overwrite: bool = True) -> None:
        """Write the scene as one page that needs neither server nor network, with at most `max_points` points.

        Raises:
            FileError: The place cannot be written.
        """
        from .stills import write_scene

        with self.lock:
            write_scene(self, path, overwrite=overwrite)

    @property
    def point_size(self) -> float:
        """Diameter of points without one of their own [px]; others grow and shrink alike. Assign another."""
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
        """Red, green and blue, 0 to 1; assign another."""
        return self._background.copy()

    @background.setter
    def background(self, color: Any) -> None:
        with self.lock:
            self._background = check_color(color)
            self._paint_background()
            self.panel.show_state()

    def color_by(self, by: str | None, *, colormap: str | None = None, limits: Any = None) -> None:
        """Colour the clouds by what is known of their points.

        Args:
            by: "rgb", "height", "normal", "label" or an attribute; None for their own colours. Clouds that have no such
                thing keep theirs.
            colormap, limits: Of values, as of `loom.render`.

        Raises:
            ValueError: No cloud has such a thing, or values out of range.
        """
        with self.lock:
            for name, value in {"by": by, "colormap": colormap}.items():
                check_name(name, "" if value is None else value)
            self.coloring = self.coloring.checked(by, colormap, limits, self.items.values())
            for item in self.items.values():
                self._color(item)
                for session in self._open_sessions():
                    with session.as_it_lasts():
                        if item.name in session.streams:
                            session.streams[item.name].set_colors(item.colors_of)
            self.panel.show_legend()

    def show_wireframe(self, shown: bool) -> None:
        """Show the edges of all surfaces."""
        with self.lock:
            self.wireframe = bool(shown)
            for nodes in self._nodes.values():
                nodes.set_wireframe(self.wireframe)
            self.panel.show_state()

    def show_normals(self, shown: bool) -> None:
        """Show the normals of all clouds that have them, as lines; of more than 10,000 points, of some."""
        with self.lock:
            self.normals = bool(shown)
            for nodes in self._nodes.values():
                nodes.set_normals(self._normal_length())
            self.panel.show_state()

    # -- its end ------------------------------------------------------------------------------------------------------

    def wait(self, seconds: float | None = None, *, linger: float = LINGER) -> bool:
        """Wait until the last page has been gone for a while, after one was there, or the viewer is closed.

        When the last page goes, stderr says so and what ends the wait at once; a page that comes back, or is loaded
        again, keeps it going.

        Args:
            seconds: At most so long, and then the answer is False; None has no end, and the answer is True.
            linger: How long the pages may be gone [s]; `math.inf` waits for another page without end.

        Raises:
            KeyboardInterrupt: Ctrl-C.
            ValueError: A time below zero.
        """
        return self._presence.wait(seconds, linger)

    def close(self) -> None:
        """Free port, threads and memory; the pages say that the viewer is gone. Twice is no error."""
        self._close("")

    def _close(self, words: str) -> None:
        """Close, where there are words with these in the pages."""
        if words and not self.closed:
            self.server.say_end(words)
        self._ended.set()
        threads = self._let_go()
        self.server.close()
        for thread in threads:
            thread.join()
