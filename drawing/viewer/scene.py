"""What a viewer shows and to whom: `Scene`, which keeps the pages in step with the items."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
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
from .camera import camera_of, diagonal, read_parameters, set_first_camera, set_reach
from .coloring_choice import ColoringChoice
from .detail_tree import DetailTree
from .items import Bounds, Frame, Item
from .keys import check_hotkey
from .lights import light_evenly
from .nodes import NORMAL_LENGTH, ItemNodes
from .panel import Panel
from .server import ViewerServer
from .sessions import POINT_SIZE, Session
from .whole_cloud import FIRST

if TYPE_CHECKING:
    import viser

log = logging.getLogger("pointloom.viewer")

SMALLEST_POINT, LARGEST_POINT = 0.5, 40.0  # [px]
_NOTHING: Bounds = (np.full(3, -1.0), np.full(3, 1.0))  # what is looked at where there is nothing


class Scene:
    """The items, where they stand in the pages, and the pages themselves; `Viewer` is what programs use.

    Whoever changes something holds `lock`: programs call from any thread, and pages from threads of viser's.

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
        self._point_size, self.has_own_point_size = point_size, point_size != POINT_SIZE
        self.lock = threading.RLock()
        self.items: dict[str, Item] = {}
        self.sessions: dict[int, Session] = {}
        self.frame, self.coloring = Frame(np.zeros(3)), ColoringChoice()
        self.wireframe = self.normals = False
        self._view: View | dict[str, Any] | None = None
        self._nodes: dict[str, ItemNodes] = {}
        self._next_number = 0
        self._last_seen: float | None = None  # when a page went
        self._ended = threading.Event()
        self._builders: list[threading.Thread] = []
        self._coming: dict[str, Item] = {}  # whose levels of detail are being built
        self.server = ViewerServer(host, port, title=title)
        self.url, self.ssh_line = self.server.url, self.server.ssh_line
        try:
            self.panel = Panel(self)  # type: ignore[arg-type]  # a Viewer
            self._paint_background()
            light_evenly(self.server.viser)
            self._aim_first_camera()
            self.server.viser.on_client_connect(self._join)
            self.server.viser.on_client_disconnect(self._leave)
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
        up = self._up or up_of((item.geometry, item.style.pose) for item in self.items.values())
        look: dict[str, Any] = {"direction": direction_under(up), "up": up}
        return fit_view(self._outline(), **look, width=self._size[0], height=self._size[1])

    @property
    def bounds(self) -> Bounds:
        """The lowest and highest corner of what is in the scene [m]; a box of 2 m where nothing is."""
        found = self._scene_bounds()
        return _NOTHING if found is None else found

    def surface_nodes(self, name: str) -> list[tuple[Triangles, Any]]:
        """The surfaces of a geometry and their nodes, which all pages share; none of what is not in the scene."""
        with self.lock:
            nodes = self._nodes.get(name)
            return [] if nodes is None else nodes.surfaces()

    def on_key(self, key: str, callback: Callable[[int], None], label: str = "") -> None:
        """Call back when a key is pressed in a page, in place of what it did there.

        Args:
            key: "A" to "Z", "0" to "9", "space", "enter", "escape", "tab", "backspace", "delete", "insert", "home",
                "end", "pageup", "pagedown", "arrowup", "arrowdown", "arrowleft" or "arrowright".
            callback: Called with the number of the page, in a thread of the pages; what it raises is shown there.
            label: What the key does, for the list that Ctrl+K opens; "" for its name.

        Raises:
            ValueError: No such key.
            TypeError: No function.
        """
        if not callable(callback):
            raise TypeError(f"callback: expected a function, got {type(callback).__name__}")
        with self.lock:
            self.panel.bind_key(check_hotkey(key), check_name("label", label or key), callback)

    def take_lock(self) -> bool:
        """Take `lock`, for threads that `close` waits for, perhaps holding it; false once the viewer is closed."""
        while not self.closed:
            if self.lock.acquire(timeout=0.05):
                if not self.closed:
                    return True
                self.lock.release()
        return False

    def clip_of(self, client: int | None) -> Any:
        """The clip planes of a page, as `get_view` finds it; None without a page."""
        with self.lock:
            session = next(iter(self.sessions.values()), None) if client is None else self.sessions.get(client)
            return None if session is None else session.clip

    # -- within -------------------------------------------------------------------------------------------------------

    def budget_of(self, item: Item) -> int:
        """Points of a cloud that a page may hold: its share of `max_points`."""
        total = sum(len(other.cloud) for other in self.items.values() if other.cloud is not None)
        if item.cloud is None or total <= self.max_points:
            return self.max_points
        share = max(1, self.max_points * len(item.cloud) // total)
        return min(share, FIRST) if item.tree is None and item.name in self._coming else share

    def _join(self, client: viser.ClientHandle) -> None:
        with self.lock:
            if self.closed:
                return
            session = Session(self, client)  # type: ignore[arg-type]  # a Viewer
            self.sessions[client.client_id] = session
            with session.as_it_lasts():
                session.start()

    def _leave(self, client: viser.ClientHandle) -> None:
        with self.lock:
            session = self.sessions.pop(client.client_id, None)
            self._last_seen = time.monotonic()
        if session is not None:
            session.close()

    def _open_sessions(self) -> list[Session]:
        return [session for session in self.sessions.values() if not session.closed]

    def _find(self, name: str) -> Item:
        if check_name("name", name) not in self.items:
            known = ", ".join(map(repr, self.items)) or "none"
            raise KeyError(f"name: no geometry {name!r}; there are {known}")
        return self.items[name]

    def _check_open(self) -> None:
        if self.closed:
            raise PointloomError("the viewer is closed; open another one")

    def _check_units(self, named: list[Named]) -> None:
        """Warn where the scene will have lengths in two units once these are in it."""
        there = {name: item.geometry for name, item in self.items.items()}
        check_units((there | {name: geometry for name, geometry, _ in named}).values())

    def _show(self, item: Item) -> None:
        """Send a geometry to all pages."""
        nodes = self._nodes.get(item.name)
        if nodes is None:
            nodes = self._nodes[item.name] = ItemNodes(self.server.viser, self.lock, self.frame, item)
        else:
            nodes.show(item)
        nodes.set_wireframe(self.wireframe)
        nodes.set_normals(self._normal_length())
        for session in self._open_sessions():
            with session.as_it_lasts():
                session.show(item)

    def _let_go(self) -> list[Any]:
        """Close the pages and forget the scene; what is to be joined when the server is closed."""
        with self.lock:
            sessions, builders = list(self.sessions.values()), self._builders
            for session in sessions:
                session.close()
            for nodes in self._nodes.values():
                nodes.forget()
            self.sessions, self._nodes, self.items, self._coming, self._builders = {}, {}, {}, {}, []
        return [*sessions, *builders]

    def _build_levels(self, item: Item) -> None:
        """Build the levels of detail of a cloud, if it is large, while a part of it is shown; the lock is held."""
        if item.cloud is None or len(item.cloud) <= self.max_points:
            return
        self._coming[item.name] = item
        self._builders = [builder for builder in self._builders if builder.is_alive()]
        builder = threading.Thread(target=self._build, args=(item,), name="pointloom-levels", daemon=True)
        self._builders.append(builder)
        builder.start()

    def _build(self, item: Item) -> None:
        try:
            assert item.cloud is not None
            tree = None if self.closed else DetailTree.from_cloud(item.cloud)
        except Exception:  # no memory for it: an even share is what can be shown
            log.warning("%s is shown without levels of detail", item.name, exc_info=True)
            tree = None
        if not self.take_lock():
            return
        try:
            if self._coming.get(item.name) is item:
                del self._coming[item.name]
                item.tree = tree
                for session in self._open_sessions():
                    with session.as_it_lasts():
                        session.show(item)
                        session.tell()
        finally:
            self.lock.release()

    def _take_out(self, name: str) -> None:
        self._coming.pop(name, None)
        self.items.pop(name, None)
        nodes = self._nodes.pop(name, None)
        if nodes is not None:
            nodes.close()
        for session in self._open_sessions():
            with session.as_it_lasts():
                session.hide(name)

    def _changed(self, look: bool, *, listed: bool = True) -> None:
        """After the scene has changed: the shares of large clouds, the panel, what is drawn near and far."""
        for session in self._open_sessions():
            with session.as_it_lasts():
                session.share_anew()
        if listed:
            self.panel.list_items()
        self.panel.show_legend()
        self._reach()
        for session in self._open_sessions():
            with session.as_it_lasts():
                if look:
                    session.go_home()
                session.tell()
                session.refresh_tools()

    def _settle(self) -> None:
        """Choose the page's coordinates when the first geometry is there."""
        found = self._scene_bounds()
        if found is not None:
            self.frame = Frame.around(found)
            for item in self.items.values():
                self._take_nodes(item)

    def _take_nodes(self, item: Item) -> None:
        """Nodes in other coordinates go; those of geometries without points, that is."""
        nodes = self._nodes.pop(item.name, None)
        if nodes is not None:
            nodes.close()
            self._nodes[item.name] = ItemNodes(self.server.viser, self.lock, self.frame, item)
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

    def _scene_bounds(self) -> Bounds | None:
        found = [bounds for item in self.items.values() if (bounds := item.world_bounds()) is not None]
        if not found:
            return None
        return np.min([low for low, _ in found], axis=0), np.max([high for _, high in found], axis=0)

    def _outline(self) -> NDArray[np.float64]:
        """Points that a view of everything has to show."""
        found = []
        for item in self.items.values():
            bounds = item.world_bounds()
            if item.cloud is not None and bounds is not None:
                found.append(item.sample())
            elif bounds is not None:
                ends = np.stack(bounds)
                found.append([[ends[i, 0], ends[j, 1], ends[k, 2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
        return np.vstack(found) if found else np.stack(_NOTHING)

    def _reach(self) -> None:
        self._aim_first_camera()
        for session in self._open_sessions():
            with session.as_it_lasts():
                set_reach(session.client, self.frame, self.bounds)

    def _aim_first_camera(self) -> None:
        camera = camera_of(self.home(), self.frame, self.bounds)
        set_first_camera(self.server.viser, camera, self.frame, self.bounds)

    def _paint_background(self) -> None:
        color = np.rint(self._background * 255).astype(np.uint8)
        self.server.viser.scene.set_background_image(np.broadcast_to(color, (1, 1, 3)).copy(), format="png")


def check_color(color: Any) -> NDArray[np.float64]:
    """A background's red, green and blue, cut to 0 to 1."""
    return np.clip(check_finite("background", check_shape("background", color, (3,))), 0, 1)


def check_size(size: Any) -> float:
    """A size of points [px], cut to what can be seen."""
    return min(max(check_positive("point_size", size), SMALLEST_POINT), LARGEST_POINT)
