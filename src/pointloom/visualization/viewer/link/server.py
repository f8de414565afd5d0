"""Server of the pages: `PageServer`."""

from __future__ import annotations

import contextlib
import itertools
import logging
import os
import secrets
import socket
import stat
import threading
import weakref
from collections.abc import Callable
from pathlib import Path
from typing import Any

from numpy.typing import ArrayLike

from ....core.checks import check_color, check_fraction
from ...page.sources import live_page
from ..guard import RequestGuard
from .arrays import triple
from .camera import FIRST_STATE, CameraState, camera_fields, moved
from .client import PageClient
from .delivery import Channel, Delivery
from .gui import Gui
from .packing import Op
from .page import ServedPage
from .scene import Scene

TOKEN_BYTES = 18
log = logging.getLogger("pointloom.viewer")
# A forked child (data loader, `multiprocessing`) inherits all open sockets. Without closing them,
# the port of a closed viewer would stay in use, and browsers would wait forever.
_owners: weakref.WeakSet[PageServer] = weakref.WeakSet()


def own_port(server: PageServer) -> None:
    """Register a server whose sockets forked children must close."""
    _owners.add(server)


def disown_port(server: PageServer) -> None:
    _owners.discard(server)


def _after_fork_in_child() -> None:
    owners = list(_owners)
    _owners.clear()
    if not owners:
        return
    ports = {server.port for server in owners}
    nothing = os.open(os.devnull, os.O_RDWR | os.O_CLOEXEC)
    for entry in Path("/dev/fd").iterdir():
        number = int(entry.name)
        with contextlib.suppress(OSError):
            if stat.S_ISSOCK(os.fstat(number).st_mode) and _port_of(number) in ports:
                os.dup2(nothing, number, inheritable=False)  # the number stays valid for objects that close it again
    os.close(nothing)
    for server in owners:
        server.forget()


def _port_of(number: int) -> int | None:
    with socket.socket(fileno=os.dup(number)) as one:
        is_internet = one.family in (socket.AF_INET, socket.AF_INET6)
        return int(one.getsockname()[1]) if is_internet else None


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_after_fork_in_child)


class PageServer:
    """Serves the page on a listening socket `bound` and connects the program to all pages.

    Thread-safe. Never waits for a page and never raises an error caused by a page. `guard` decides which requests are
    answered.

    Attributes:
        scene, gui: Scene and panel of all pages.
        token: Secret in the page's address.
        is_child: True in a forked child, where the pages belong to the parent.
    """

    def __init__(self, bound: socket.socket, guard: RequestGuard, title: str = "pointloom"):
        from .hub import Hub  # the only module that needs websockets, an extra

        self.token = secrets.token_urlsafe(TOKEN_BYTES)
        self.delivery = Delivery()
        self._channel = Channel(self.delivery, is_shared=True)
        self.scene, self.gui = Scene(self._channel), Gui(self._channel)
        self._clients: dict[int, PageClient] = {}
        self._numbers = itertools.count()
        self._first: CameraState = FIRST_STATE
        self.is_child = False
        self._on_connect: list[Callable[[PageClient], Any]] = []
        self._on_disconnect: list[Callable[[PageClient], Any]] = []
        self._hub = Hub(bound, guard, ServedPage(live_page(title)), self.token, self._welcome)
        self._channel.send({"op": "title", "text": title})
        self.port = int(bound.getsockname()[1])
        own_port(self)

    def get_clients(self) -> dict[int, PageClient]:
        with self.delivery.lock:
            return dict(self._clients)

    @property
    def client_count(self) -> int:
        """Number of connections, including those before their first message."""
        return self._hub.client_count

    @property
    def last_request(self) -> float:
        """Time of the last valid request for the page (`time.monotonic`)."""
        return self._hub.last_request

    def on_client_connect(self, callback: Callable[[PageClient], Any]) -> Callable[[PageClient], Any]:
        """Add a callback for current and new pages, called in the page's thread."""
        with self.delivery.lock:
            self._on_connect.append(callback)
            here = list(self._clients.values())
        for client in here:
            client.worker.run(callback, client, always=True)
        return callback

    def on_client_disconnect(self, callback: Callable[[PageClient], Any]) -> Callable[[PageClient], Any]:
        """Add a callback for closed pages, called in the page's thread after its other callbacks."""
        self._on_disconnect.append(callback)
        return callback

    def disconnect_all(self) -> None:
        """Disconnect all pages. They reconnect as new clients."""
        self._hub.cut_all()

    def atomic(self) -> contextlib.AbstractContextManager[None]:
        """Context in which this thread's changes are applied together; may be nested."""
        return self.delivery.atomic()

    def set_background(self, rgb: ArrayLike, own: bool = True) -> None:
        """Set the background color, 0 to 1. If not `own`, a page may follow dark mode."""
        self._channel.send({"op": "background", "color": check_color("rgb", rgb).tolist(), "own": bool(own)})

    def set_first_camera(self, **fields: Any) -> None:
        """Set the camera of future pages. Fields as in `PageCamera.put`."""
        sent = camera_fields(fields)
        with self.delivery.lock:
            self._first = moved(self._first, sent)
            self.delivery.keep({"op": "camera", **sent})

    def set_bounds(self, low: ArrayLike, high: ArrayLike) -> None:
        self._channel.send({"op": "bounds", "low": triple("low", low), "high": triple("high", high)})

    def set_hint(self, text: str) -> None:
        self._channel.send({"op": "hint", "text": str(text)})

    def set_title(self, text: str) -> None:
        self._channel.send({"op": "title", "text": str(text)})

    def set_unit(self, text: str | None) -> None:
        """Set the unit of the scale bar. None hides it."""
        self._channel.send({"op": "unit", "text": None if text is None else str(text)})

    def set_progress(self, text: str, fraction: float | None = None) -> None:
        """Show a task and the fraction done; "" when done."""
        fraction = None if fraction is None else check_fraction("share", fraction)
        self._channel.send({"op": "progress", "text": str(text), "share": fraction})

    def end(self, text: str) -> None:
        """Show until reconnection that the program has ended and how to restart it."""
        self._channel.send({"op": "end", "text": str(text)})

    def stop(self) -> None:
        """Disconnect the pages and free port, thread and memory. A second call has no effect."""
        self._hub.stop()
        self.delivery.close()
        disown_port(self)

    def _welcome(self, hello: dict[str, Any], wake: Callable[[], None]) -> _Visitor:
        channel = Channel(self.delivery, is_shared=False)
        size = (int(hello["size"][0]), int(hello["size"][1]))
        with self.delivery.lock:
            first = CameraState(**{**vars(self._first), "size": size})
            client = PageClient(channel, next(self._numbers), first, (self.scene, self.gui))
            visitor = _Visitor(self, client, channel, wake)
            self._clients[client.client_id] = client
            callbacks = tuple(self._on_connect)
        for callback in callbacks:
            client.worker.run(callback, client, always=True)
        return visitor

    def disconnect(self, client: PageClient, channel: Channel) -> None:
        with self.delivery.lock:
            self.delivery.leave(channel)
            self._clients.pop(client.client_id, None)
            client.is_open = False
        for callback in tuple(self._on_disconnect):
            client.worker.run(callback, client, always=True)
        client.worker.end()

    def forget(self) -> None:
        """Drop the pages in a forked child, whose copies of the sockets are already closed."""
        self.delivery.lock = threading.RLock()
        self.delivery.close()
        self._clients, self.is_child = {}, True


class _Visitor:
    def __init__(self, server: PageServer, client: PageClient, channel: Channel, wake: Callable[[], None]):
        self._server, self._client, self._channel = server, client, channel
        self._outbox = server.delivery.join(channel, wake)
        self.take = client.take

    @property
    def own_bytes(self) -> int:
        return self._outbox.own_bytes

    def unsent(self) -> tuple[list[Op], bool]:
        return self._server.delivery.take(self._outbox)

    def has_more(self) -> bool:
        return bool(self._outbox)

    def leave(self) -> None:
        self._server.disconnect(self._client, self._channel)
