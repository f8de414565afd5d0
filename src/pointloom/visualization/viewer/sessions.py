"""Connection of one page to the viewer: its camera, clouds and tools (`Session`)."""

from __future__ import annotations

import contextlib
import logging
import threading
import time
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from ..render.view import View
from .camera import Camera, camera_limits, camera_of, view_of
from .home_views import Homes
from .items import Item
from .panel_sections import COUNTS_ORDER
from .point_transfer import WholeCloud
from .scene import POINT_SIZE, Scene

if TYPE_CHECKING:
    from .link import PageCamera, PageClient
    from .streaming import CloudStream
    from .tools.clip_planes import Clip
    from .tools.picking import Pick

IDLE_TIME = 0.25  # [s] without motion until the camera is at rest
log = logging.getLogger("pointloom.viewer")


class PageTools(Protocol):
    """Mouse tools of a page."""

    @property
    def clip(self) -> Clip: ...

    @property
    def is_idle(self) -> bool:
        """True if no tool is active."""
        ...

    def pick(self, view: View, x: float, y: float) -> Pick | None:
        """The geometry at an image position [px]."""
        ...

    def release_key(self, key: str) -> None: ...

    def refresh(self) -> None: ...

    def close(self) -> None: ...


class Session:
    """A page while it is connected. A reconnected page is a new session.

    Attributes:
        streams: Clouds of the page by item name.
    """

    def __init__(self, scene: Scene, client: PageClient):
        self.scene, self.client, self.closed = scene, client, False
        self.streams: dict[str, WholeCloud | CloudStream] = {}
        self._budgets: dict[str, int] = {}
        self._unfinished: dict[str, WholeCloud] = {}  # with steps left to send
        self._in_levels: set[str] = set()  # point count depends on the view
        self._counts: dict[str, tuple[int, int]] = {}  # last reported drawn and total number of points
        self._drawn = self._total = 0
        self._moved, self._timer = time.monotonic(), None
        self._put, self._put_shape = np.zeros(3), 0  # last camera position that was set, and the page's shape then
        self._homes = Homes()
        self._line: Any = None
        self.tools: PageTools | None = None
        self._pace = Pace(client.request_signal)
        self._feeder: threading.Thread | None = None
        self._leaving: list[Any] = []  # removed once the page has the replacement
        self._state: Any = None
        self._limits: dict[str, float] = {}

    def start(self, make_tools: Callable[[Session], PageTools]) -> None:
        """Show the scene. Requires the scene's lock."""
        with self.client.atomic():
            self.go_home()
            self._line = self.client.gui.add_words("", order=COUNTS_ORDER, visible=False)
            for item in self.scene.shown.values():
                self.show(item)
            self.tools = make_tools(self)
            self.show_counts()
        self.client.on_sign(lambda _: self._pace.answer())
        self.client.camera.on_update(self._on_camera)
        self.feed()

    def camera_view(self) -> View:
        return self.view_of(self.client.camera.state)

    def view_of(self, camera: Any) -> View:
        return view_of(camera, self.scene.frame, self.scene.bounds, camera.size)

    def go_home(self) -> None:
        self._look_from(self.scene.home())
        self._homes.put(self._put)

    def go_home_if_still(self) -> None:
        """Show the complete scene again, unless the user has moved the camera or uses a tool."""
        if self._homes.are_at(self.client.camera.position) and (self.tools is None or self.tools.is_idle):
            self.go_home()

    def look_from(self, view: View) -> None:
        self._homes.leave()
        self._look_from(view)

    def _look_from(self, view: View) -> None:
        width, height = self.client.camera.size
        self._put_camera(camera_of(view, self.scene.frame, self.scene.bounds, width / height))

    def look_as(self, state: Any) -> None:
        """Restore a camera state (`client.camera.state`)."""
        self._limits = camera_limits(state, self.scene.frame, self.scene.bounds)
        fields = {name: getattr(state, name) for name in ("position", "rotation", "fov", "pivot", "orthographic")}
        self.client.camera.put(**fields, **self._limits)

    def update_limits(self) -> None:
        limits = camera_limits(self.client.camera, self.scene.frame, self.scene.bounds)
        if limits != self._limits:
            self._limits = limits
            self.client.camera.put(**limits)

    def show(self, item: Item) -> None:
        stream, name = self.streams.get(item.name), item.name
        same = self._budgets.get(name) == self.scene.budget_of(item)
        if item.cloud is None:
            self.hide(name)
        elif isinstance(stream, WholeCloud) and item.tree is None and same:
            stream.replace(item)
        elif isinstance(stream, WholeCloud) and self._has_levels(item):
            self._leaving.append(self.streams.pop(name))
            self.streams[name] = self._open(item)
        else:
            self.hide(name)
            self.streams[name] = self._open(item)
        self._update_count(name)
        self.feed()

    def set_pose(self, item: Item) -> None:
        stream = self.streams.get(item.name)
        pose = item.pose_of(item.parts[0])
        if stream is not None and pose is not None:
            stream.set_pose(pose)

    def set_visible(self, item: Item) -> None:
        stream = self.streams.get(item.name)
        if stream is not None:
            stream.set_visible(item.visible)
            self._update_count(item.name)

    def set_colors(self, item: Item) -> None:
        stream = self.streams.get(item.name)
        if stream is not None:
            stream.set_colors(item.colors_of)

    def feed(self) -> None:
        """Send remaining parts of clouds at the page's speed. Requires the scene's lock."""
        if self._feeder is None and self._unfinished and not self.closed:
            self._feeder = threading.Thread(target=self._feed, name="pointloom-feed", daemon=True)
            self._feeder.start()

    @property
    def clip(self) -> Clip | None:
        """Clip planes of the page. None before it has tools."""
        return None if self.tools is None else self.tools.clip

    def release_key(self, key: str) -> None:
        """Release a key that the program now uses."""
        if self.tools is not None and not self.closed:
            self.tools.release_key(key)

    def refresh_tools(self) -> None:
        if self.tools is not None and not self.closed:
            self.tools.refresh()

    def rebalance_budgets(self) -> None:
        for item in self.scene.shown.values():
            if item.name in self.streams and self._budgets[item.name] != self.scene.budget_of(item):
                self.show(item)

    def hide(self, name: str) -> None:
        stream = self.streams.pop(name, None)
        if stream is not None:
            stream.close()
        self._update_count(name)

    def resize_points(self) -> None:
        for name, stream in self.streams.items():
            stream.set_point_size(*self._size_of(self.scene.shown[name]))

    def recount(self) -> None:
        for name in list(self.streams):
            self._update_count(name)

    @contextlib.contextmanager
    def ignore_if_closed(self) -> Iterator[None]:
        """Log errors instead of passing them to the program or other pages."""
        try:
            yield
        except Exception:
            if self.client.is_open:
                log.warning("an update of page %d failed", self.client.client_id, exc_info=True)
            else:
                self.closed = True

    def show_counts(self) -> None:
        if self._line is not None and not self.closed:
            for name in self._in_levels:
                self._update_count(name)
            text = counts_text(self._drawn, self._total, self.scene.triangle_count)
            self._line.value, self._line.visible = text, bool(text)

    def close(self) -> None:
        self.closed = True
        if self._timer is not None:
            self._timer.cancel()
        self._pace.close()
        if self.tools is not None:
            self.tools.close()
        self.streams.clear()
        self._unfinished.clear()
        self._leaving.clear()

    def join(self) -> None:
        """Wait for the page's thread after `close`. Without the scene's lock."""
        feeder = self._feeder
        if feeder is not None and feeder is not threading.current_thread():
            feeder.join(timeout=5.0)

    def _feed(self) -> None:
        while self._pace.wait() and self.scene.take_lock():
            try:
                name = None if self.closed else next(iter(self._unfinished), None)
                if name is None:
                    self._feeder = None  # later work starts another thread
                    return
                self._unfinished[name].send_next()
                self._update_count(name)
                self.show_counts()
            except Exception:  # an error of one page must not stop the viewer
                log.debug("sending the next step to a page failed", exc_info=True)
                self._feeder = None
                return
            finally:
                self.scene.lock.release()

    def _update_count(self, name: str) -> None:
        """Update whether a cloud is complete, and its drawn number of points."""
        stream = self.streams.get(name)
        before = self._counts.pop(name, (0, 0))
        now = (0, 0) if stream is None else (stream.drawn, stream.total)
        if stream is not None:
            self._counts[name] = now
        self._drawn, self._total = self._drawn + now[0] - before[0], self._total + now[1] - before[1]
        if isinstance(stream, WholeCloud) and stream.waits:
            self._unfinished[name] = stream
        else:
            self._unfinished.pop(name, None)
        if stream is None or isinstance(stream, WholeCloud):
            self._in_levels.discard(name)
        else:
            self._in_levels.add(name)

    def _pause(self) -> bool:
        """Pause between the steps of a stream. False if the page has gone."""
        if not self.scene.take_lock():
            return False
        try:
            with self.ignore_if_closed():
                self.show_counts()
        finally:
            self.scene.lock.release()
        return self._pace.wait()

    def _open(self, item: Item) -> Any:
        budget, frame = self.scene.budget_of(item), self.scene.frame
        self._budgets[item.name] = budget
        size, metric = self._size_of(item)
        sizes: dict[str, Any] = {"budget": budget, "point_size": size, "metric": metric}
        if not self._has_levels(item):
            return WholeCloud(self.client, item, frame=frame, **sizes)
        from .streaming import CloudStream

        stream = CloudStream(self.client, item.tree, origin=frame.origin, pause=self._pause, **sizes)
        pose = item.pose_of(item.parts[0])
        if pose is not None:
            stream.set_pose(pose)
        stream.set_visible(item.visible)
        stream.set_colors(item.colors_of)
        self._restart_timer(0.0)
        return stream

    def _has_levels(self, item: Item) -> bool:
        return item.tree is not None and self.scene.frame.unit == 1

    def _size_of(self, item: Item) -> tuple[float | None, bool]:
        """Point diameter of an item, and whether it is in meters. None for levels that close gaps."""
        part, scene = item.points, self.scene
        assert part is not None
        if part.metric and part.size is not None:
            return part.size, True
        if self._has_levels(item) and not scene.has_own_point_size and part.size is None:
            return None, True
        return scene.point_size * (1.0 if part.size is None else part.size / POINT_SIZE), False

    def _put_camera(self, camera: Camera) -> None:
        self._put, self._put_shape = camera.position, _shape(self.client.camera.size)
        self._limits = camera_limits(camera, self.scene.frame, self.scene.bounds)
        self.client.camera.put(**camera.fields(), **self._limits)

    def _on_camera(self, camera: PageCamera) -> None:
        if camera.state is self._state:
            return
        self._state, self._moved = camera.state, time.monotonic()
        if self._timer is None and not self.closed:
            self._wait(IDLE_TIME)

    def _refit(self) -> None:
        """Fit the view again if the page's aspect ratio changed and the camera was not moved."""
        shape = _shape(self.client.camera.size)
        if shape != self._put_shape:
            if np.allclose(self.client.camera.position, self._put, rtol=1e-4, atol=0):
                self.go_home()
            self._put_shape = shape

    def _restart_timer(self, seconds: float) -> None:
        if self._timer is not None:
            self._timer.cancel()
        self._moved = time.monotonic() - IDLE_TIME
        self._wait(seconds)

    def _wait(self, seconds: float) -> None:
        self._timer = threading.Timer(seconds, self._check_if_idle)
        self._timer.daemon = True
        self._timer.start()

    def _check_if_idle(self) -> None:
        left = IDLE_TIME - (time.monotonic() - self._moved)
        if self.closed:
            return
        if left > 0:
            self._wait(left)
            return
        self._timer = None
        try:
            self._at_rest()
        except Exception:  # the page has gone, or a tool failed: continue
            log.debug("an update of a page after camera motion failed", exc_info=True)

    def _at_rest(self) -> None:
        with self.scene.lock:
            if self.closed:
                return
            self._refit()
            view = self.camera_view()
            streams = [self.streams[name] for name in self._in_levels]
        for stream in streams:  # sends for a while, without the lock
            stream.look(view)
        with self.scene.lock:
            for stream in self._leaving:
                stream.close()
            self._leaving.clear()
            self.show_counts()
        self.refresh_tools()


def _shape(size: tuple[int, int]) -> int:
    return round(50 * size[0] / size[1]) if size[1] else 0


def counts_text(drawn: int, total: int, triangles: int = 0) -> str:
    words = []
    if total >= 1_000_000:
        millions = f"{total / 1e6:.3g}" if total < 1e9 else f"{total / 1e6:,.0f}"
        words.append(f"{drawn / 1e6:.1f} of {millions} million points")
    elif total:
        words.append(_counted(total, "point") if drawn == total else f"{drawn:,} of {_counted(total, 'point')}")
    if triangles:
        words.append(_counted(triangles, "triangle"))
    return ", ".join(words)


def _counted(count: int, name: str) -> str:
    return f"{count:,} {name}{'' if count == 1 else 's'}"


SIGNAL_TIMEOUT = 3.0  # [s] after which the next step is sent without a signal
FRAMES_PER_STEP = 3  # frames between two steps: a page prepares one or two frames ahead
STEP_PAUSE = 0.1  # [s] more


class Pace:
    """Waits for a signal from a page between steps, so that it draws each step before the next.

    A page handles messages once per frame: a page that draws slowly answers slowly.
    """

    def __init__(self, request: Callable[[], None]):
        self._request = request
        self._answered, self._ended = threading.Event(), threading.Event()

    def answer(self) -> None:
        self._answered.set()

    def wait(self) -> bool:
        """Wait until the page has drawn what it was sent. False if it has gone."""
        end = time.monotonic() + SIGNAL_TIMEOUT
        for _ in range(FRAMES_PER_STEP):
            self._answered.clear()
            if self._ended.is_set():
                return False
            self._request()
            if not self._answered.wait(max(end - time.monotonic(), 0.0)):
                break
        return not self._ended.wait(STEP_PAUSE)

    def close(self) -> None:
        self._ended.set()
        self._answered.set()
