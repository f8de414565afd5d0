"""Scene of a viewer, synchronized with its pages: `Scene`."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...core.attribute_hints import nearest_name
from ...core.checks import check_finite, check_name, check_positive, check_shape
from ...core.coordinates import finite_rows
from ...core.errors import PointloomError
from ...core.open3d_names import hint, row_of
from ...core.up_axis import check_up
from ...kernels.memory import download
from ..render.geometries import Named, check_units
from ..render.parts import Lines, Part, Points, Triangles, Triple
from ..render.up_axis import direction_under, up_of
from ..render.view import View, fit_view
from .camera import camera_limits, camera_of, diagonal, read_parameters
from .coloring_choice import ColoringChoice
from .detail_tree import DetailTree
from .extents import Bounds, Extents
from .home_views import Arrivals
from .hooks import Hooks
from .items import Frame, Item
from .panel import Panel
from .point_transfer import FIRST
from .server import ViewerServer
from .sessions import POINT_SIZE, Session
from .surfaces import line_arrays, surface_arrays

if TYPE_CHECKING:
    from .link import Node, PageClient, PageServer
    from .viewer import Viewer


log = logging.getLogger("pointloom.viewer")

HINT = 'Nothing is shown yet. In the program, viewer.add("name", geometry) shows something here.'
SMALLEST_POINT, LARGEST_POINT = 0.5, 40.0  # [px]
OUTLINE, MIN_OUTLINE = 100_000, 50  # points of clouds for the view of everything. Minimum number per cloud
_NOTHING: Bounds = (np.full(3, -1.0), np.full(3, 1.0))  # bounds of an empty scene


class Scene(Hooks):
    """The items of a viewer, their nodes and the pages. Programs use `Viewer`.

    Changes require `lock`: programs call from any thread, pages from their own threads.

    Args:
        port, host, title, max_points, point_size, background, size: See `Viewer`.
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
        self._has_own_background = bool((background != 1).any())  # a white background may follow dark mode
        self._point_size, self.has_own_point_size = point_size, point_size != POINT_SIZE
        self.lock = threading.RLock()
        self.shown: dict[str, Item] = {}  # state of the pages; `items` is the state of the program
        self.sessions: dict[int, Session] = {}
        self.frame, self.coloring = Frame(np.zeros(3)), ColoringChoice()
        self.wireframe = self.normals = False
        self._view: View | dict[str, Any] | None = None
        self._nodes: dict[str, ItemNodes] = {}
        self._next_number = 0
        self._last_seen: float | None = None  # time when the last page closed
        self._ended = threading.Event()
        self._levels = LevelBuilder(self)  # type: ignore[arg-type]  # a Viewer
        self._extents = Extents()
        self._point_count = self.triangle_count = 0  # of all clouds, and of all surfaces
        self._with_unit: dict[str, Any] = {}  # geometries that had a unit when added
        self._deferred = DeferredUpdate(self._catch_up, self.take_lock, self.lock.release)
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

        def __getattr__(self, name: str) -> Any:  # called only for missing attributes
            remedy = "" if name.startswith("_") else hint(row_of(name, ("Visualizer",)))
            remedy = remedy or nearest_name(name, dir(type(self)))
            raise AttributeError(f"{type(self).__name__} has no attribute {name!r}{remedy}")

    @property
    def closed(self) -> bool:
        """True after `close`."""
        return self._ended.is_set()

    _up: Triple | None = None

    @property
    def up(self) -> Triple | None:
        """Up axis of the initial view. Assign "x", "y", "z" or a direction.

        If None, that of the first mesh that defines one (.glb, .gltf), else z.
        """
        return self._up

    @up.setter
    def up(self, value: Any) -> None:
        self._up = None if value is None else check_up(value)

    def home(self) -> View:
        """Initial view of pages: that of `set_view`, else the complete scene."""
        if isinstance(self._view, View):
            return self._view
        if self._view is not None:
            return View.from_open3d(self.bounds, **self._view, width=self._size[0], height=self._size[1])
        up = self._up or up_of((item.geometry, item.style.pose) for item in self.shown.values())
        look: dict[str, Any] = {"direction": direction_under(up), "up": up}
        return fit_view(self._outline(), **look, width=self._size[0], height=self._size[1])

    @property
    def _has_own_view(self) -> bool:
        """True if `set_view` defined the initial view."""
        return self._view is not None

    @property
    def bounds(self) -> Bounds:
        """Lowest and highest corner of the scene [m]. A 2 m box if it is empty."""
        bounds = self._extents.union()
        return _NOTHING if bounds is None else bounds

    def _surface_nodes(self, name: str) -> list[tuple[Triangles, Node]]:
        with self.lock:
            nodes = self._nodes.get(name)
            return [] if nodes is None else nodes.surfaces()

    def take_lock(self) -> bool:
        """Take `lock` in a thread that `close` may wait for. False if the viewer is closed."""
        while not self.closed:
            if self.lock.acquire(timeout=0.05):
                if not self.closed:
                    return True
                self.lock.release()
        return False

    def _clip_of(self, client: int | None) -> Any:
        with self.lock:
            session = next(iter(self.sessions.values()), None) if client is None else self.sessions.get(client)
            return None if session is None else session.clip

    def _budget_of(self, item: Item) -> int:
        """Number of points of a cloud in a page: its part of `max_points`."""
        if item.cloud is None or self._point_count <= self.max_points:
            return self.max_points
        share = max(1, self.max_points * item.point_count // self._point_count)
        return min(share, FIRST) if item.tree is None and item.name in self._levels else share

    def _join(self, client: PageClient) -> None:
        with self.lock:
            if self.closed:
                return
            session = Session(self, client)  # type: ignore[arg-type]  # a Viewer
            self._deferred.now()
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
        """Warn if the scene would have two length units."""
        coming = {name for name, _, _ in named}
        there = next((geometry for name, geometry in self._with_unit.items() if name not in coming), None)
        check_units([*([] if there is None else [there]), *(geometry for _, geometry, _ in named)])

    def _page_unit(self) -> str | None:
        """Length unit of the page. None if unknown or mixed."""
        units = {geometry.unit for geometry in self._with_unit.values()} - {None}
        unit = units.pop() if len(units) == 1 and self.frame.unit == 1 else None
        return None if unit is None or unit.meters is None else unit.symbol

    def _take_in(self, item: Item) -> None:
        before = self.shown.get(item.name)
        self._count(before, -1)
        self.shown[item.name] = item
        self._count(item, 1)
        self._with_unit.pop(item.name, None)
        if getattr(item.geometry, "unit", None) is not None:
            self._with_unit[item.name] = item.geometry
        self._extents.put(item.name, item.world_bounds())

    def _count(self, item: Item | None, sign: int) -> None:
        """Update the point and triangle counts. Detect changed budgets of clouds."""
        if item is None:
            return
        self.triangle_count += sign * item.triangle_count
        if item.cloud is not None and len(item.cloud):
            was_over = self._point_count > self.max_points
            self._point_count += sign * item.point_count
            self._shares_changed |= was_over or self._point_count > self.max_points

    def _show(self, item: Item) -> None:
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
        """Close the pages and clear the scene. Returns the objects to join after the server is closed."""
        with self.lock:
            sessions, builders = list(self.sessions.values()), self._levels.let_go()
            for session in sessions:
                session.close()
            self.sessions, self._nodes, self.shown = {}, {}, {}
            self._extents, self._with_unit = Extents(), {}
            self._deferred.close()
            hooks = self._end_hooks()
        return [*sessions, *builders, self._deferred, *hooks]

    def _show_levels(self, item: Item) -> None:
        """Show the levels of a cloud after they were built. Requires the lock."""
        for session in self._open_sessions():
            with session.as_it_lasts():
                session.show(item)
                session.show_counts()

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
        """Schedule one update for all changes within a frame."""
        if look:
            self._aim_first_camera()
            self._update_limits()
            self._arrivals.fitted()
            for session in self._open_sessions():
                with session.as_it_lasts():
                    session.go_home()
        self._deferred.request()

    def _catch_up(self) -> None:
        """Update budgets of large clouds, clipping planes, panel and tools."""
        shares, self._shares_changed = self._shares_changed, False
        self.panel.catch_up()
        self.server.pages.set_hint("" if self.shown else HINT)
        self.server.pages.set_unit(self._page_unit())
        self._update_limits()
        self._arrivals.fit()
        for session in self._open_sessions():
            with session.as_it_lasts():
                if shares:
                    session.share_anew()
                session.show_counts()
                session.refresh_tools()

    def catch_up(self) -> None:
        """Apply scheduled updates at once."""
        with self.lock:
            self._deferred.now()

    def _choose_frame(self) -> None:
        """Choose the page's coordinates at the first geometry."""
        bounds = self._extents.union()
        if bounds is not None:
            self.frame = Frame.around(bounds)
            for item in self.shown.values():
                self._take_nodes(item)

    def _take_nodes(self, item: Item) -> None:
        """Replace the item's nodes, made in old coordinates, and hide it in all pages."""
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
        """Set the initial view. If it cannot be drawn, raise TypeError or ValueError without a change."""
        before, self._view = self._view, read_parameters(given)
        try:
            with np.errstate(all="ignore"):
                return self.home()
        except (TypeError, ValueError, ArithmeticError) as error:
            self._view = before
            kind = TypeError if isinstance(error, TypeError) else ValueError
            raise kind(f"view of {', '.join(given)}: {error}") from error

    def _outline(self) -> NDArray[np.float64]:
        """Points that define the complete scene: samples of clouds, corners of all other geometries."""
        if not len(self._extents):
            return np.stack(_NOTHING)
        clouds = [item for item in self.shown.values() if item.cloud is not None and item.bounds is not None]
        each = OUTLINE // max(len(clouds), 1)
        if each < MIN_OUTLINE:  # so few that their boxes suffice
            return self._extents.corners()
        samples = [item.sample()[:: -(-len(item.sample()) // each)] for item in clouds]
        boxes = Extents()
        for item in self.shown.values():
            if item.cloud is None:
                boxes.put(item.name, item.world_bounds())
        return np.vstack([*samples, boxes.corners()])

    def _update_limits(self) -> None:
        self.server.pages.set_bounds(*map(self.frame.to_page, self.bounds))
        for session in self._open_sessions():
            with session.as_it_lasts():
                session.update_limits()

    def _aim_first_camera(self) -> None:
        camera = camera_of(self.home(), self.frame, self.bounds)
        self.server.pages.set_first_camera(**camera.fields(), **camera_limits(camera, self.frame, self.bounds))

    def _paint_background(self) -> None:
        self.server.pages.set_background(self._background, own=self._has_own_background)


def check_color(color: Any) -> NDArray[np.float64]:
    return np.clip(check_finite("background", check_shape("background", color, (3,))), 0, 1)


def check_size(size: Any) -> float:
    """Point size [px], clipped to the visible range."""
    return min(max(check_positive("point_size", size), SMALLEST_POINT), LARGEST_POINT)


MAX_NORMALS = 10_000
NORMAL_LENGTH = 0.01  # over the scene's diagonal
NORMAL_COLOR = (0, 0, 0)


class ItemNodes:
    """Nodes of an item except points, shared by all pages."""

    def __init__(self, pages: PageServer, frame: Frame, item: Item, *, wireframe: bool = False):
        self._pages, self._frame, self._wireframe = pages, frame, wireframe
        self._nodes: list[tuple[Part, Node]] = []
        self._normals: Node | None = None
        self.show(item)

    def show(self, item: Item) -> None:
        """Replace the displayed item within one frame."""
        self._item = item
        with self._pages.atomic():
            for _, node in self._nodes:
                node.remove()
            self._nodes = [(part, node) for part in item.parts if (node := self._add(part)) is not None]

    def surfaces(self) -> list[tuple[Triangles, Node]]:
        return [(part, node) for part, node in self._nodes if isinstance(part, Triangles)]

    def set_pose(self) -> None:
        with self._pages.atomic():
            for part, node in self._nodes:
                node.set_transform(*self._frame.pose_in_page(part.origin, self._item.pose_of(part)))
            if self._normals is not None and self._item.points is not None:
                part = self._item.points
                self._normals.set_transform(*self._frame.pose_in_page(part.origin, self._item.pose_of(part)))

    def set_visible(self, visible: bool) -> None:
        for _, node in self._nodes:
            node.visible = visible
        if self._normals is not None:
            self._normals.visible = visible

    def set_wireframe(self, shown: bool) -> None:
        self._wireframe = shown
        for part, node in self.surfaces():
            node.set(wireframe=shown or part.wireframe)

    def set_normals(self, length: float | None) -> None:
        """Show the normals of a cloud as lines of this length [m]. None hides them."""
        if self._normals is not None:
            self._normals.remove()
            self._normals = None
        part = self._item.points
        if length is None or part is None or not part.normals.size:
            return
        step = -(-part.positions.size // MAX_NORMALS)
        feet = download(part.positions).reshape(-1, 3)[::step]
        heads = feet + np.float32(length) * download(part.normals).reshape(-1, 3)[::step]
        finite = finite_rows(heads)
        if finite.any():
            ends = np.stack([feet[finite], heads[finite]], axis=1)
            self._normals = self._pages.scene.add_lines(ends, plain=NORMAL_COLOR, **self._placement(part))

    def close(self) -> None:
        with self._pages.atomic():
            for _, node in self._nodes:
                node.remove()
            if self._normals is not None:
                self._normals.remove()
        self._nodes, self._normals = [], None

    def _add(self, part: Part) -> Node | None:
        if isinstance(part, Points):
            return None
        scene, placement = self._pages.scene, self._placement(part)
        if isinstance(part, Lines):
            lines = line_arrays(part)
            return None if lines is None else scene.add_lines(**lines, **placement)
        surface = surface_arrays(part)
        if surface is None:
            return None
        return scene.add_surface(**surface, wireframe=self._wireframe or part.wireframe, **placement)

    def _placement(self, part: Part) -> dict[str, Any]:
        return {**self._frame.placing(part.origin, self._item.pose_of(part)), "visible": self._item.visible}


FRAME = 1 / 30  # [s] minimum time between two runs
IDLE = 0.5  # [s] without a request after which the thread ends


class DeferredUpdate:
    """Runs a job once per frame in its own thread, with the lock held, if it was requested meanwhile."""

    def __init__(self, job: Callable[[], None], take_lock: Callable[[], bool], release_lock: Callable[[], None]):
        self._job, self._take_lock, self._release_lock = job, take_lock, release_lock
        self._requested, self._ended = threading.Event(), threading.Event()
        self._thread: threading.Thread | None = None

    def request(self) -> None:
        self._requested.set()
        if self._thread is None and not self._ended.is_set():
            self._thread = threading.Thread(target=self._run, name="pointloom-later", daemon=True)
            self._thread.start()

    def now(self) -> None:
        """Run a requested job at once. Requires the lock."""
        if self._requested.is_set():
            self._requested.clear()
            self._job()

    def close(self) -> None:
        self._ended.set()
        self._requested.set()  # wake all waiting threads

    def join(self) -> None:
        """Wait for the thread after `close`. Without the lock."""
        thread = self._thread
        if thread is not None and thread is not threading.current_thread():
            thread.join(timeout=5.0)

    def _run(self) -> None:
        while True:
            was_requested = self._requested.wait(IDLE)
            if self._ended.is_set() or not self._take_lock():
                return
            try:
                if self._ended.is_set():  # closed while waiting for the lock
                    return
                if not was_requested and not self._requested.is_set():
                    self._thread = None  # the next request starts a new thread
                    return
                self.now()
            except Exception:  # an internal error must not stop the viewer
                log.warning("an update after a change of the scene failed", exc_info=True)
            finally:
                self._release_lock()
            if self._ended.wait(FRAME):
                return


class LevelBuilder:
    """Builds levels of detail in threads and shows them when done. The caller holds the viewer's lock."""

    def __init__(self, viewer: Viewer):
        self._viewer = viewer
        self._coming: dict[str, Item] = {}
        self._threads: list[threading.Thread] = []

    def __contains__(self, name: str) -> bool:
        """True if the levels of an item are being built."""
        return name in self._coming

    def build(self, item: Item) -> None:
        """Build the levels of a cloud that is too large to be sent completely."""
        if item.cloud is None or len(item.cloud) <= self._viewer.max_points:
            return
        self._coming[item.name] = item
        self._threads = [thread for thread in self._threads if thread.is_alive()]
        thread = threading.Thread(target=self._build, args=(item,), name="pointloom-levels", daemon=True)
        self._threads.append(thread)
        self._show_status()
        thread.start()

    def forget(self, name: str) -> None:
        if self._coming.pop(name, None) is not None:
            self._show_status()

    def let_go(self) -> list[threading.Thread]:
        """Cancel all builds. Returns the threads to wait for."""
        threads, self._threads = self._threads, []
        self._coming.clear()
        return threads

    def _build(self, item: Item) -> None:
        viewer = self._viewer
        try:
            assert item.cloud is not None
            tree = None if viewer.closed else DetailTree.from_cloud(item.cloud)
        except Exception:  # out of memory: show an even sample
            log.warning("%s is shown without levels of detail", item.name, exc_info=True)
            tree = None
        if not viewer.take_lock():
            return
        try:
            if self._coming.get(item.name) is item:
                del self._coming[item.name]
                item.tree = tree
                viewer._show_levels(item)
                self._show_status()
        finally:
            viewer.lock.release()

    def _show_status(self) -> None:
        coming = list(self._coming)
        others = f" and {len(coming) - 1} more" if len(coming) > 1 else ""
        text = f"a preview; preparing all points of {coming[0]}{others}" if coming else ""
        self._viewer.server.pages.set_progress(text)
