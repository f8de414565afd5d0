"""What a viewer shows and to whom: `Scene`, which keeps the pages in step with the items."""

from __future__ import annotations

import logging
import threading
import time
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_finite, check_name, check_positive, check_shape
from ...core.errors import PointloomError
from ...core.known_names import nearest_name
from ...core.open3d_names import row_of, told
from ...core.upward import check_up
from ..render.geometries import Named, check_units
from ..render.parts import Triangles, Triple
from ..render.upward import direction_under, up_of
from ..render.view import View, fit_view
from .arrivals import Arrivals
from .camera import camera_of, diagonal, reach_of, read_parameters
from .coloring_choice import ColoringChoice
from .extents import Bounds, Extents
from .hooks import Hooks
from .items import Frame, Item
from .later import Later
from .level_builder import LevelBuilder
from .nodes import NORMAL_LENGTH, ItemNodes
from .panel import Panel
from .server import ViewerServer
from .sessions import POINT_SIZE, Session
from .whole_cloud import FIRST

if TYPE_CHECKING:
    from .link import Node, PageClient

log = logging.getLogger("pointloom.viewer")

HINT = 'Nothing is shown yet. In the program, viewer.add("name", geometry) shows something here.'
SMALLEST_POINT, LARGEST_POINT = 0.5, 40.0  # [px]
OUTLINE, LEAST_OUTLINE = 100_000, 50  # points of clouds by which a view of everything is found; of each one at least
_NOTHING: Bounds = (np.full(3, -1.0), np.full(3, 1.0))  # what is looked at where there is nothing


class Scene(Hooks):
    """The items, where they stand in the pages, and the pages themselves; `Viewer` is what programs use.

    Whoever changes something holds `lock`: programs call from any thread, and pages from threads of theirs.

    Args:
        port, host, title: Of the server.
        max_points: Of all clouds together in one page.
        point_size: Of points without one of their own [px].
        background: Red, green and blue, 0 to 1.
        size: Of pictures [px].
    """

    def __init__(
        self,
        port: int,
        host: str,
        title: str,
        max_points: int,
        point_size: float,
        background: NDArray[np.float64],
        size: tuple[int, int],
    ):
        self.max_points, self._size, self._background = max_points, size, background
        self._has_own_background = bool((background != 1).any())  # a white one may follow a dark mode
        self._point_size, self.has_own_point_size = point_size, point_size != POINT_SIZE
        self.lock = threading.RLock()
        self.shown: dict[str, Item] = {}  # what pages see; `items` is what the program has
        self.sessions: dict[int, Session] = {}
        self.frame, self.coloring = Frame(np.zeros(3)), ColoringChoice()
        self.wireframe = self.normals = False
        self._view: View | dict[str, Any] | None = None
        self._nodes: dict[str, ItemNodes] = {}
        self._next_number = 0
        self._last_seen: float | None = None  # when a page went
        self._ended = threading.Event()
        self._levels = LevelBuilder(self)  # type: ignore[arg-type]  # a Viewer
        self._extents = Extents()
        self._point_count = self.triangle_count = 0  # of all clouds, and of all surfaces
        self._with_unit: dict[str, Any] = {}  # geometries that had one when they came
        self._later = Later(self._catch_up, self.take_lock, self.lock.release)
        self._shares_changed, self._arrivals = False, Arrivals(self)
        self.server = ViewerServer(host, port, title=title)
        self.url, self.ssh_line = self.server.url, self.server.ssh_line
        try:
            self.panel = Panel(self)  # type: ignore[arg-type]  # a Viewer
            self._paint_background()
            self.server.pages.set_hint(HINT)
            self._aim_first_camera()
            self.server.pages.on_client_connect(self._join)
            self.server.pages.on_client_disconnect(self._leave)
        except BaseException:
            self.server.close()
            raise

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:  # asked only where there is none
            remedy = "" if name.startswith("_") else told(row_of(name, ("Visualizer",)))
            remedy = remedy or nearest_name(name, dir(type(self)))
            raise AttributeError(f"{type(self).__name__} has no attribute {name!r}{remedy}")

    @property
    def closed(self) -> bool:
        """Whether `close` was called."""
        return self._ended.is_set()

    _up: Triple | None = None

    @property
    def up(self) -> Triple | None:
        """What is up where pages look from at first: "x", "y", "z" or a direction is assigned.

        None takes that of the first mesh that says so, as those of .glb and .gltf, else z.
        """
        return self._up

    @up.setter
    def up(self, value: Any) -> None:
        self._up = None if value is None else check_up(value)

    def home(self) -> View:
        """Where pages look from at first: what `set_view` said, else what shows all of the scene."""
        if isinstance(self._view, View):
            return self._view
        if self._view is not None:
            return View.from_open3d(self.bounds, **self._view, width=self._size[0], height=self._size[1])
        up = self._up or up_of((item.geometry, item.style.pose) for item in self.shown.values())
        look: dict[str, Any] = {"direction": direction_under(up), "up": up}
        return fit_view(self._outline(), **look, width=self._size[0], height=self._size[1])

    @property
    def _has_own_view(self) -> bool:
        """Whether `set_view` has said where pages look from at first."""
        return self._view is not None

    @property
    def bounds(self) -> Bounds:
        """The lowest and highest corner of what is in the scene [m]; a box of 2 m where nothing is."""
        found = self._extents.union()
        return _NOTHING if found is None else found

    def _surface_nodes(self, name: str) -> list[tuple[Triangles, Node]]:
        """The surfaces of a geometry and their nodes, which all pages share; none of what is not in the scene."""
        with self.lock:
            nodes = self._nodes.get(name)
            return [] if nodes is None else nodes.surfaces()

    def take_lock(self) -> bool:
        """Take `lock`, for threads that `close` waits for, perhaps holding it; false once the viewer is closed."""
        while not self.closed:
            if self.lock.acquire(timeout=0.05):
                if not self.closed:
                    return True
                self.lock.release()
        return False

    def _clip_of(self, client: int | None) -> Any:
        """The clip planes of a page, as `get_view` finds it; None without a page."""
        with self.lock:
            session = next(iter(self.sessions.values()), None) if client is None else self.sessions.get(client)
            return None if session is None else session.clip

    # -- within -------------------------------------------------------------------------------------------------------

    def _budget_of(self, item: Item) -> int:
        """Points of a cloud that a page may hold: its share of `max_points`."""
        if item.cloud is None or self._point_count <= self.max_points:
            return self.max_points
        share = max(1, self.max_points * item.point_count // self._point_count)
        return min(share, FIRST) if item.tree is None and item.name in self._levels else share

    def _join(self, client: PageClient) -> None:
        with self.lock:
            if self.closed:
                return
            session = Session(self, client)  # type: ignore[arg-type]  # a Viewer
            self._later.now()
            with session.as_it_lasts():
                session.start()
                self.sessions[client.client_id] = session

    def _leave(self, client: PageClient) -> None:
        with self.lock:
            session = self.sessions.pop(client.client_id, None)
            self._last_seen = time.monotonic()
        if session is not None:
            session.close()

    def _open_sessions(self) -> list[Session]:
        return [session for session in self.sessions.values() if not session.closed]

    def _find(self, name: str) -> Item:
        if check_name("name", name) not in self.shown:
            known = ", ".join(map(repr, self.shown)) or "none"
            raise KeyError(f"name: no geometry {name!r}; there are {known}")
        return self.shown[name]

    def _check_open(self) -> None:
        if self.closed:
            raise PointloomError("the viewer is closed; open another one")

    def _check_units(self, named: list[Named]) -> None:
        """Warn where the scene will have lengths in two units once these are in it."""
        coming = {name for name, _, _ in named}
        there = next((geometry for name, geometry in self._with_unit.items() if name not in coming), None)
        check_units([*([] if there is None else [there]), *(geometry for _, geometry, _ in named)])

    def _page_unit(self) -> str | None:
        """What a length of the page is in; None where nobody knows, or not all of the scene is in one unit."""
        units = {geometry.unit for geometry in self._with_unit.values()} - {None}
        unit = units.pop() if len(units) == 1 and self.frame.unit == 1 else None
        return None if unit is None or unit.metres is None else unit.symbol

    def _take_in(self, item: Item) -> None:
        """Have an item stand under its name, in place of the one before."""
        before = self.shown.get(item.name)
        self._count(before, -1)
        self.shown[item.name] = item
        self._count(item, 1)
        self._with_unit.pop(item.name, None)
        if getattr(item.geometry, "unit", None) is not None:
            self._with_unit[item.name] = item.geometry
        self._extents.put(item.name, item.world_bounds())

    def _count(self, item: Item | None, sign: int) -> None:
        """Points more or less, and whether clouds have other shares of what a page may hold then."""
        if item is None:
            return
        self.triangle_count += sign * item.triangle_count
        if item.cloud is not None and len(item.cloud):
            was_over = self._point_count > self.max_points
            self._point_count += sign * item.point_count
            self._shares_changed |= was_over or self._point_count > self.max_points

    def _show(self, item: Item) -> None:
        """Send a geometry to all pages."""
        nodes = self._nodes.get(item.name)
        if nodes is None:
            nodes = self._nodes[item.name] = ItemNodes(self.server.pages, self.frame, item, wireframe=self.wireframe)
        else:
            nodes.show(item)
        nodes.set_normals(self._normal_length())
        for session in self._open_sessions():
            with session.as_it_lasts():
                session.show(item)

    def _let_go(self) -> list[Any]:
        """Close the pages and forget the scene; what is to be joined when the server is closed."""
        with self.lock:
            sessions, builders = list(self.sessions.values()), self._levels.let_go()
            for session in sessions:
                session.close()
            self.sessions, self._nodes, self.shown = {}, {}, {}
            self._extents, self._with_unit = Extents(), {}
            self._later.close()
            hooks = self._end_hooks()
        return [*sessions, *builders, self._later, *hooks]

    def _show_levels(self, item: Item) -> None:
        """The levels of a cloud are there; the lock is held."""
        for session in self._open_sessions():
            with session.as_it_lasts():
                session.show(item)
                session.tell()

    def _take_out(self, name: str) -> None:
        self._levels.forget(name)
        self._with_unit.pop(name, None)
        self._extents.drop(name)
        self._count(self.shown.pop(name, None), -1)
        self.panel.drop_item(name)
        nodes = self._nodes.pop(name, None)
        if nodes is not None:
            nodes.close()
        for session in self._open_sessions():
            with session.as_it_lasts():
                session.hide(name)

    def _changed(self, look: bool) -> None:
        """After the scene has changed: what follows from it comes within a frame, once for many changes."""
        if look:
            self._aim_first_camera()
            self._reach()
            self._arrivals.fitted()
            for session in self._open_sessions():
                with session.as_it_lasts():
                    session.go_home()
        self._later.ask()

    def _catch_up(self) -> None:
        """What follows from changes: shares of large clouds, what is drawn near and far, what panel and tools say."""
        shares, self._shares_changed = self._shares_changed, False
        self.panel.catch_up()
        self.server.pages.set_hint("" if self.shown else HINT)
        self.server.pages.set_unit(self._page_unit())
        self._reach()
        self._arrivals.fit()
        for session in self._open_sessions():
            with session.as_it_lasts():
                if shares:
                    session.share_anew()
                session.tell()
                session.refresh_tools()

    def catch_up(self) -> None:
        """Do at once what would follow from changes within a frame."""
        with self.lock:
            self._later.now()

    def _settle(self) -> None:
        """Choose the page's coordinates when the first geometry is there."""
        found = self._extents.union()
        if found is not None:
            self.frame = Frame.around(found)
            for item in self.shown.values():
                self._take_nodes(item)

    def _take_nodes(self, item: Item) -> None:
        """Nodes in other coordinates go; those of geometries without points, that is."""
        nodes = self._nodes.pop(item.name, None)
        if nodes is not None:
            nodes.close()
            self._nodes[item.name] = ItemNodes(self.server.pages, self.frame, item, wireframe=self.wireframe)
        for session in self._open_sessions():
            with session.as_it_lasts():
                session.hide(item.name)

    def _color(self, item: Item) -> None:
        item.recolor(self.coloring.of(item))

    def _normal_length(self) -> float | None:
        return NORMAL_LENGTH * diagonal(self.bounds) if self.normals else None

    def _take_view(self, given: Any) -> View:
        """Look from there from now on, where that can be drawn; what pages look from at first.

        Raises:
            TypeError, ValueError: It cannot; the view stays as it was.
        """
        before, self._view = self._view, read_parameters(given)
        try:
            with np.errstate(all="ignore"):
                return self.home()
        except (TypeError, ValueError, ArithmeticError) as error:
            self._view = before
            kind = TypeError if isinstance(error, TypeError) else ValueError
            raise kind(f"view of {', '.join(given)}: {error}") from error

    def _outline(self) -> NDArray[np.float64]:
        """Points that a view of everything has to show: some of each cloud, and the corners of all else."""
        if not len(self._extents):
            return np.stack(_NOTHING)
        clouds = [item for item in self.shown.values() if item.cloud is not None and item.bounds is not None]
        each = OUTLINE // max(len(clouds), 1)
        if each < LEAST_OUTLINE:  # of so many that their boxes tell as much
            return self._extents.corners()
        found = [item.sample()[:: -(-len(item.sample()) // each)] for item in clouds]
        boxes = Extents()
        for item in self.shown.values():
            if item.cloud is None:
                boxes.put(item.name, item.world_bounds())
        return np.vstack([*found, boxes.corners()])

    def _reach(self) -> None:
        """Pages draw all of the scene; their wheels go as near and as far as makes sense."""
        self.server.pages.set_bounds(*map(self.frame.to_page, self.bounds))
        for session in self._open_sessions():
            with session.as_it_lasts():
                session.set_reach()

    def _aim_first_camera(self) -> None:
        camera = camera_of(self.home(), self.frame, self.bounds)
        self.server.pages.set_first_camera(**camera.fields(), **reach_of(camera, self.frame, self.bounds))

    def _paint_background(self) -> None:
        self.server.pages.set_background(self._background, own=self._has_own_background)


def check_color(color: Any) -> NDArray[np.float64]:
    """A background's red, green and blue, cut to 0 to 1."""
    return np.clip(check_finite("background", check_shape("background", color, (3,))), 0, 1)


def check_size(size: Any) -> float:
    """A size of points [px], cut to what can be seen."""
    return min(max(check_positive("point_size", size), SMALLEST_POINT), LARGEST_POINT)
