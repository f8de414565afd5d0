"""One page that looks at the viewer: its camera, its clouds, and what happens when the camera rests: `Session`."""

from __future__ import annotations

import contextlib
import logging
import threading
import time
import warnings
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from ...core.errors import PointloomError
from ..render.view import View
from .camera import camera_of, diagonal, point_radius, set_camera, set_reach, view_of
from .items import Item
from .lights import Lamps
from .pacing import Pace
from .whole_cloud import WholeCloud

if TYPE_CHECKING:
    import viser

    from .viewer import Viewer

POINT_SIZE = 3.0  # [px] of points that have no size of their own, until the panel says another
REST = 0.25  # [s] without motion after which a camera rests
log = logging.getLogger("pointloom.viewer")

# viser says once for each page that went away that nobody will see what it is sent, which is all right here.
warnings.filterwarnings("ignore", message="Queued a .* on a closed connection")


class Session:
    """A page from when it connects until it goes; one that reconnects is another.

    Args:
        viewer: The viewer.
        client: viser's handle of the page.

    Attributes:
        streams: The clouds of the page by the names of their items.
    """

    def __init__(self, viewer: Viewer, client: viser.ClientHandle):
        self.viewer, self.client, self.closed = viewer, client, False
        self.streams: dict[str, Any] = {}
        self._budgets: dict[str, int] = {}
        self._callbacks: list[Callable[[View], None]] = []
        self._moved, self._timer = time.monotonic(), None
        self._canvas, self._sizes = (0, 0), {}
        self._put, self._put_shape = np.zeros(3), 0  # where the camera was put, and the shape of the page then
        self._line: Any = None
        self._lamps: Lamps | None = None
        self._toolbox: Any = None
        self._pace = Pace(self._ask_for_sign)
        self._feeder: threading.Thread | None = None
        self._leaving: list[Any] = []  # what goes once the page has what comes in its place
        self._camera: tuple[Any, ...] = ()

    def start(self) -> None:
        """Show the scene to the page; the viewer's lock is held."""
        self._take_size(self.client.camera)
        self.go_home()
        self._lamps = Lamps(self.client)
        self._line = self.viewer.panel.add_line(self.client)
        for item in self.viewer.items.values():
            self.show(item)
        self._toolbox = self.viewer.panel.add_tools(self)
        self.tell()
        self.client.camera.on_update(self._on_camera)
        self.feed()

    def camera_view(self) -> View:
        """What the page shows, in the world's coordinates and the pixels of its canvas."""
        return view_of(self.client.camera, self.viewer.frame, self._size())

    def rest(self, callback: Callable[[View], None]) -> None:
        """Call back with the view each time that the camera has rested for a quarter of a second."""
        self._callbacks.append(callback)

    def go_home(self) -> None:
        """Look from where the viewer was told to, or from where all is seen; draw all of it."""
        bounds = self.viewer.bounds
        set_reach(self.client, self.viewer.frame, bounds)
        self.look_from(self.viewer.home())

    def look_from(self, view: View) -> None:
        """Put the camera there."""
        width, height = self._size()
        camera = camera_of(view, self.viewer.frame, self.viewer.bounds, width / height)
        self._put, self._put_shape = camera.position, _shape(self._canvas)
        set_camera(self.client, camera)

    def show(self, item: Item) -> None:
        """Show a cloud, or other points in place of it."""
        stream = self.streams.get(item.name)
        same = self._budgets.get(item.name) == self.viewer.budget_of(item)
        if item.cloud is None:
            self.hide(item.name)
        elif isinstance(stream, WholeCloud) and item.tree is None and same:
            stream.replace(item)
        elif isinstance(stream, WholeCloud) and self._has_levels(item):
            self._leaving.append(self.streams.pop(item.name))
            self.streams[item.name] = self._open(item)
        else:
            self.hide(item.name)
            self.streams[item.name] = self._open(item)
        self.feed()

    def feed(self) -> None:
        """Send what is left of clouds step by step, as fast as the page takes it; the viewer's lock is held."""
        if self._feeder is None and any(self._waiting()) and not self.closed:
            self._feeder = threading.Thread(target=self._feed, name="pointloom-feed", daemon=True)
            self._feeder.start()

    @property
    def clip(self) -> Any:
        """What the page's clip planes leave; None before it has tools."""
        return None if self._toolbox is None else self._toolbox.stage.clip

    @property
    def history(self) -> Any:
        """What was changed in the page; None before it has tools."""
        return None if self._toolbox is None else self._toolbox.stage.history

    def refresh_tools(self) -> None:
        """The scene has changed: clip planes cut it, tools offer what there is."""
        if self._toolbox is not None and not self.closed:
            self._toolbox.refresh()

    def share_anew(self) -> None:
        """Give clouds their shares of the points that a page may hold, where those have changed."""
        for item in self.viewer.items.values():
            if item.name in self.streams and self._budgets[item.name] != self.viewer.budget_of(item):
                self.show(item)

    def hide(self, name: str) -> None:
        """Take a cloud out of the page."""
        stream = self.streams.pop(name, None)
        if stream is not None:
            stream.close()

    def resize_points(self) -> None:
        """Give points the size that the panel says, as seen from here."""
        view = self.camera_view()
        for name, stream in self.streams.items():
            item = self.viewer.items[name]
            if isinstance(stream, WholeCloud):
                stream.set_point_size(self._radius(item, view))
            elif self.viewer.has_own_point_size or item.style.point_size is not None:
                stream.set_point_size(2 * self._radius(item, view))

    @contextlib.contextmanager
    def as_it_lasts(self) -> Iterator[None]:
        """What is done to a page that goes meanwhile is in vain, and no error."""
        try:
            yield
        except RuntimeError:
            if self.client.client_id in self.viewer.server.viser.get_clients():
                raise
            self.closed = True

    def tell(self) -> None:
        """Say how many points of how many are drawn."""
        if self._line is not None and not self.closed:
            streams = self.streams.values()
            self._line.content = told(sum(s.drawn for s in streams), sum(s.total for s in streams))

    def close(self) -> None:
        """The page has gone."""
        self.closed = True
        if self._timer is not None:
            self._timer.cancel()
        self._pace.close()
        stop = getattr(self._toolbox, "close", None)
        if stop is not None:
            stop()
        self.streams.clear()
        self._leaving.clear()
        self._callbacks.clear()

    def join(self) -> None:
        """Wait for the page's thread, after `close`; without the viewer's lock."""
        feeder = self._feeder
        if feeder is not None and feeder is not threading.current_thread():
            feeder.join(timeout=5.0)

    # -- what is sent -------------------------------------------------------------------------------------------------

    def _waiting(self) -> Iterator[WholeCloud]:
        return (stream for stream in self.streams.values() if isinstance(stream, WholeCloud) and stream.waits)

    def _feed(self) -> None:
        while self._pace.wait() and self.viewer.take_lock():
            try:
                stream = None if self.closed else next(self._waiting(), None)
                if stream is None:
                    self._feeder = None  # what comes from now on starts another
                    return
                with self.as_it_lasts():
                    stream.send_next()
                    self.tell()
            except Exception:  # of one page: the viewer goes on
                log.debug("a page's next step", exc_info=True)
                self._feeder = None
                return
            finally:
                self.viewer.lock.release()

    def _ask_for_sign(self) -> None:
        with contextlib.suppress(RuntimeError, AssertionError, PointloomError):  # the page has gone
            self.viewer.server.ask_for_sign(self.client)

    def _pause(self) -> bool:
        """Between the steps of a stream."""
        if not self.viewer.take_lock():
            return False
        try:
            with self.as_it_lasts():
                self.tell()
        finally:
            self.viewer.lock.release()
        return self._pace.wait()

    # -- the camera ---------------------------------------------------------------------------------------------------

    def _open(self, item: Item) -> Any:
        budget, frame = self.viewer.budget_of(item), self.viewer.frame
        self._budgets[item.name] = budget
        if not self._has_levels(item):
            radius = self._radius(item, self.camera_view())
            return WholeCloud(self.client, f"/cloud/{item.number}", item, frame=frame, budget=budget, point_size=radius)
        from .streaming import CloudStream

        stream = CloudStream(
            self.client, f"/levels/{item.number}", item.tree, origin=frame.origin, budget=budget, pause=self._pause
        )
        pose = item.pose_of(item.parts[0])
        if pose is not None:
            stream.set_pose(pose)
        stream.set_visible(item.visible)
        stream.set_colors(item.colors_of)
        self._wait_anew(0.0)
        return stream

    def _has_levels(self, item: Item) -> bool:
        return item.tree is not None and self.viewer.frame.unit == 1

    def _radius(self, item: Item, view: View) -> float:
        part, frame = item.points, self.viewer.frame
        assert part is not None
        if part.metric and part.size is not None:
            return part.size / 2 / frame.unit
        pixels = self.viewer.point_size * (1.0 if part.size is None else part.size / POINT_SIZE)
        return point_radius(pixels, item.sample(), view, frame, diagonal(self.viewer.bounds))

    def _size(self) -> tuple[int, int]:
        """The canvas without the page's coarser drawing while it is slow: the largest of one shape that was seen."""
        return self._sizes.get(_shape(self._canvas), self._canvas)

    def _take_size(self, camera: viser.CameraHandle) -> None:
        size = (max(1, int(camera.image_width)), max(1, int(camera.image_height)))
        if _shape(size) != _shape(self._canvas):
            self._sizes.clear()
        self._canvas = size
        self._sizes[_shape(size)] = max(size, self._sizes.get(_shape(size), size))

    def _on_camera(self, camera: viser.CameraHandle) -> None:
        self._pace.answer()
        self._take_size(camera)
        now = (*camera.wxyz, *camera.position, *camera.look_at, camera.fov, camera.image_width, camera.image_height)
        if now == self._camera:
            return  # it was only asked for a sign
        self._camera, self._moved = now, time.monotonic()
        if self._lamps is not None and not self.closed:
            with self.as_it_lasts():
                self._lamps.follow(camera)
        if self._timer is None and not self.closed:
            self._wait(REST)

    def _fit_anew(self) -> None:
        """Show all again where the page has another shape since, and nobody has moved the camera."""
        if _shape(self._canvas) != self._put_shape:
            if np.allclose(self.client.camera.position, self._put, rtol=1e-4, atol=0):
                self.look_from(self.viewer.home())
            self._put_shape = _shape(self._canvas)

    def _wait_anew(self, seconds: float) -> None:
        """Rest after so long, whatever was waited for."""
        if self._timer is not None:
            self._timer.cancel()
        self._moved = time.monotonic() - REST
        self._wait(seconds)

    def _wait(self, seconds: float) -> None:
        self._timer = threading.Timer(seconds, self._look_whether_it_rests)
        self._timer.daemon = True
        self._timer.start()

    def _look_whether_it_rests(self) -> None:
        left = REST - (time.monotonic() - self._moved)
        if self.closed:
            return
        if left > 0:
            self._wait(left)
            return
        self._timer = None
        try:
            self._at_rest()
        except Exception:  # a page that goes in the midst of it, or a tool's fault: the viewer goes on
            log.debug("a page's camera rested", exc_info=True)

    def _at_rest(self) -> None:
        with self.viewer.lock:
            if self.closed:
                return
            self._fit_anew()
            view = self.camera_view()
            self.resize_points()
            streams = list(self.streams.values())
        for stream in streams:  # sends for a while: the program goes on meanwhile
            stream.look(view)
        with self.viewer.lock:
            for stream in self._leaving:
                stream.close()
            self._leaving.clear()
            self.tell()
        for callback in tuple(self._callbacks):
            callback(view)


def told(drawn: int, total: int) -> str:
    """How many points are drawn, in words."""
    if total < 1_000_000:
        return f"{drawn:,} of {total:,} points" if drawn != total else f"{total:,} points"
    millions = f"{total / 1e6:.3g}" if total < 1e9 else f"{total / 1e6:,.0f}"
    return f"{drawn / 1e6:.1f} of {millions} million points"


def _shape(size: tuple[int, int]) -> int:
    """Width by height, coarse enough for rounding."""
    return round(50 * size[0] / size[1]) if size[1] else 0
