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
from .copc_tree import CopcTree
from .items import Frame, make_item
from .logged import logged
from .presence import LINGER, Presence
from .scene import Scene, check_color, check_size
from .sessions import POINT_SIZE


class Looks(Scene):
    """Sizes, colours and edges of a scene, the same for all pages; changes in one message; stills."""

    @contextlib.contextmanager
    def batch(self) -> Iterator[None]:
        """Have pages take many changes as one, which they show in one picture.

        Within another it is part of that one. While one is open, what other threads change waits for its end as well,
        but no longer than a second. What raises within it ends it, and what was changed until then is shown.

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

    def tell_progress(self, text: str, share: float | None = None) -> None:
        """Say in the pages what the program is doing.

        Args:
            text: In a few words; "" once it is done.
            share: How much of it is done, 0 to 1; None where nobody knows.

        Raises:
            TypeError, ValueError: No text, or no share.
        """
        with self.lock:
            self._check_open()
            self.server.pages.set_progress(check_name("text", text), share)

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
            viewer: Any = self  # a Viewer
            return draw_scene(viewer, viewer.get_view(client), path, self._clip_of(client))

    def save_html(self, path: str | os.PathLike[str], *, overwrite: bool = True) -> None:
        """Write the scene as one page that needs neither server nor network, with at most `max_points` points.

        Raises:
            FileError: The place cannot be written.
        """
        from .stills import write_scene

        with self.lock:
            write_scene(self, path, overwrite=overwrite)  # type: ignore[arg-type]  # a Viewer

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
            self._background, self._has_own_background = check_color(color), True
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
        """Show the normals of all clouds that have them, as lines; of more than 10,000 points, of some."""
        with self.lock:
            self.normals = bool(shown)
            with self.batch():
                for nodes in self._nodes.values():
                    nodes.set_normals(self._normal_length())
            self.panel.show_state()


MOST_POINTS = 2_000_000


class Viewer(Looks):
    """A scene in the browser, kept up to date by a program: on this machine, or over SSH on another one.

    What Open3D's `Visualizer` does with add_geometry, update_geometry, poll_events and update_renderer is
    `viewer.update(name, geometry)`: from any thread, and the page shows it without a flicker.

    Args:
        port: Of the server; where it is taken, the next free one. 0 takes any.
        host: The address that it listens on. With another than 127.0.0.1 the network reaches it too.
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
        close_at_exit(self)

    def __repr__(self) -> str:
        return f"Viewer({self.url}, {len(self.shown)} geometries{', closed' if self.closed else ''})"

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
        """Add a geometry to the scene; one of the same name goes. Of many, `batch` makes one message.

        Args:
            name: What it is called, in the page's list too; those with a "/" are listed in groups: "cars/7".
            geometry: A cloud, mesh, box, line set, trajectory, voxel grid, frustum or another that `loom.render` draws.
            style: color, color_by, colormap, limits, point_size, metric, line_width, wireframe, back_faces, shaded,
                pose, as of `loom.render`.

        Raises:
            TypeError: A geometry of no known kind, or a key of style that there is none.
        """
        check_name("name", name)
        colormap = {name: check_name(name, style[name]) for name in ("colormap",) if style.get(name) is not None}
        self.add_named(named_geometries([{"geometry": geometry, "name": name, **style, **colormap}]))

    def add_all(self, geometries: Any) -> None:
        """Add several geometries at once: all of them or, where one cannot be drawn, none.

        Args:
            geometries: A mapping of names to geometries, or a list of geometries or of dictionaries as `loom.draw`
                takes them: {"geometry": g, "name": "floor", "color": (1, 0, 0)}. Several clouds without colours get
                different ones. What has the name of one goes.

        Raises:
            TypeError: A geometry of no known kind.
            ValueError: A key of style that there is none, or a value out of range.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> with loom.Viewer(port=0) as viewer:
            ...     viewer.add_all({f"cars/{k}": np.full((1, 3), k) for k in range(3)})
            ...     list(viewer.items)
            ['cars/0', 'cars/1', 'cars/2']
        """
        self.add_named(named_geometries(geometries))

    def add_copc(self, name: str, path: str | os.PathLike[str], **style: Any) -> None:
        """Add a COPC file (.copc.laz) of any size: what a view needs of it is read when it is looked at.

        Tools (picking, measuring, cropping) work on the coarse levels, 250,000 points, which are `items[name]`.

        Args:
            name: What it is called, as of `add`.
            path: The file; it must stay as it is while the viewer is open.
            style: As of `add`.

        Raises:
            FileError: No COPC file, or one of which no coarse node can be read. A node that is damaged is told by a
                warning of the logger "pointloom.viewer" when it is looked at, and the others are shown.
            TypeError: A key of style that there is none.

        Notes:
            Takes 256 MB at most for unpacked nodes, and what a page is sent.
        """
        tree = CopcTree(path)
        self.add_named(
            named_geometries([{"geometry": tree.head, "name": check_name("name", name), **style}]), {name: tree}
        )

    @logged
    def add_named(self, named: list[Named], trees: Mapping[str, Any] = MappingProxyType({})) -> None:
        """Add what `named_geometries` gives, some perhaps with levels of detail by name."""
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
                self._settle()
            for item in made:
                self._show(item)
                self.panel.put_item(item)
            self._arrivals.note()
            self._changed(was_empty)

    @logged
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
            was_empty = not len(self._extents)
            self._levels.forget(name)
            self._take_in(item)
            self._color(item)
            if was_empty:
                self._settle()
            self._show(item)
            self.panel.put_item(item)
            self._changed(was_empty)

    @logged
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

    @logged
    def clear(self) -> None:
        """Take all out of the scene; what comes next is looked at anew."""
        with self.lock, self.batch():
            self._check_open()
            for name in list(self.shown):
                self._take_out(name)
            self.frame = Frame(np.zeros(3))
            self._changed(False)

    @logged
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
            item.pose = check_rigid("T", T).copy()  # the caller may go on with its own
            self._nodes[name].set_pose()
            for session in self._open_sessions():
                with session.as_it_lasts():
                    session.set_pose(item)
            self._extents.put(name, item.world_bounds())
            self._changed(False)

    @logged
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
                    session.set_visible(item)
            self.panel.put_item(item)
            self._changed(False)

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
        """Free port, threads and memory; pages say that the viewer is closed, and how to start it again."""
        self._close(farewell())

    def _close(self, words: str) -> None:
        """Close; pages say these words."""
        if not self.closed and not self.server.closed:
            self.server.pages.end(words)
        self._ended.set()
        threads = self._let_go()
        self.server.close()
        for thread in threads:
            thread.join()


_open: weakref.WeakSet[Viewer] = weakref.WeakSet()


def close_at_exit(viewer: Viewer) -> None:
    """Close a viewer at the end of the process, where nobody has done so before."""
    _open.add(viewer)


@atexit.register
def _close_all() -> None:
    for viewer in list(_open):
        if not viewer.server.closed:  # as a forked child's copy is, which has no page
            with contextlib.suppress(Exception):  # the interpreter is going
                viewer.close()


def farewell() -> str:
    """That the program has ended, and how to start it again."""
    if in_notebook():
        again = "Run the cell again to see it again."
    else:
        command = _command(sys.argv)
        again = f"To start it again:\n{command}" if command else "The program can open another viewer."
    return f"The viewer has been closed. {again}"


def _command(arguments: list[str]) -> str:
    """The command line that this program was started by; "" where there was none, as in an interpreter."""
    name = Path(arguments[0]).name if arguments else ""
    if name in ("", "-", "-c", "-m"):
        return ""
    if name in ("pointloom", "pointloom.exe") or (name == "__main__.py" and "pointloom" in arguments[0]):
        return shlex.join(["pointloom", *arguments[1:]])
    return f"python {shlex.quote(name)}"
