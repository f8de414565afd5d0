"""The link to all pages that look: `PageServer`."""

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

from ....core.checks import check_color, check_share
from ...page.sources import live_page
from ..guard import RequestGuard
from .arrays import triple
from .camera import FIRST, CameraState, camera_fields, moved
from .client import PageClient
from .delivery import Channel, Delivery
from .gui import Gui
from .packing import Op
from .page import ServedPage
from .scene import Scene

TOKEN_BYTES = 18
log = logging.getLogger("pointloom.viewer")
# A forked child (a worker of a data loader, of `multiprocessing`) has every open socket too. While it lived, the port
# of a closed viewer would stay taken, and browsers would wait for an answer that never comes.
_owners: weakref.WeakSet[PageServer] = weakref.WeakSet()


def own_port(server: PageServer) -> None:
    """Have children let go of all sockets at the server's port, those of its pages too, and of the server."""
    _owners.add(server)


def disown_port(server: PageServer) -> None:
    """The port is closed."""
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
                os.dup2(nothing, number, inheritable=False)  # the number stays, for objects that close it once more
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
    """Serves the page and is the program's way to all that look.

    All of it may be called from any thread, waits for no page, and raises nothing that a page causes.

    Args:
        bound: A listening socket, which `stop` closes.
        guard: Which requests are answered.
        title: Of the page.

    Attributes:
        scene: What all pages draw, those that come later as well.
        gui: What all have in their panels.
        token: What the page's address must hold.
        port: That it listens on.
        is_child: This is a forked child's copy: the pages are its parent's.
    """

    def __init__(self, bound: socket.socket, guard: RequestGuard, title: str = "pointloom"):
        from .hub import Hub  # the one file that needs websockets, an extra

        self.token = secrets.token_urlsafe(TOKEN_BYTES)
        self._delivery = Delivery()
        self._channel = Channel(self._delivery, is_shared=True)
        self.scene, self.gui = Scene(self._channel), Gui(self._channel)
        self._clients: dict[int, PageClient] = {}
        self._numbers = itertools.count()
        self._first: CameraState = FIRST
        self.is_child = False
        self._on_connect: list[Callable[[PageClient], Any]] = []
        self._on_disconnect: list[Callable[[PageClient], Any]] = []
        self._hub = Hub(bound, guard, ServedPage(live_page(title)), self.token, self._welcome)
        self._channel.send({"op": "title", "text": title})
        self.port = int(bound.getsockname()[1])
        own_port(self)

    # -- pages --------------------------------------------------------------------------------------------------------

    def get_clients(self) -> dict[int, PageClient]:
        """The pages that are connected, by their numbers."""
        with self._delivery.lock:
            return dict(self._clients)

    @property
    def client_count(self) -> int:
        """How many connections there are, those included that have not said hello yet."""
        return self._hub.client_count

    @property
    def last_asked(self) -> float:
        """When the page itself was last asked for with its token, by `time.monotonic`."""
        return self._hub.last_asked

    def on_client_connect(self, callback: Callable[[PageClient], Any]) -> Callable[[PageClient], Any]:
        """Call back with each page that comes, and with those that are here, in a thread of the page's own."""
        with self._delivery.lock:
            self._on_connect.append(callback)
            here = list(self._clients.values())
        for client in here:
            client.worker.run(callback, client, always=True)
        return callback

    def on_client_disconnect(self, callback: Callable[[PageClient], Any]) -> Callable[[PageClient], Any]:
        """Call back with each page that goes, after all its other callbacks, in a thread of the page's own."""
        self._on_disconnect.append(callback)
        return callback

    def disconnect_all(self) -> None:
        """Cut off every page; each connects again by itself, as a new client."""
        self._hub.cut_all()

    def atomic(self) -> contextlib.AbstractContextManager[None]:
        """Have pages apply together what this thread does within; may be nested."""
        return self._delivery.atomic()

    # -- what all pages see -------------------------------------------------------------------------------------------

    def set_background(self, rgb: Any, own: bool = True) -> None:
        """The colour behind the scene, 0 to 1 each; with `own` False a page may follow its reader's dark mode."""
        self._channel.send({"op": "background", "color": check_color("rgb", rgb).tolist(), "own": bool(own)})

    def set_first_camera(self, **fields: Any) -> None:
        """Where pages that come later begin; the fields of `PageCamera.put`."""
        sent = camera_fields(fields)
        with self._delivery.lock:
            self._first = moved(self._first, sent)
            self._delivery.keep({"op": "camera", **sent})

    def set_bounds(self, low: Any, high: Any) -> None:
        """The box around the scene, in the page's coordinates."""
        self._channel.send({"op": "bounds", "low": triple("low", low), "high": triple("high", high)})

    def set_hint(self, text: str) -> None:
        """Words in place of an empty scene; "" for none."""
        self._channel.send({"op": "hint", "text": str(text)})

    def set_title(self, text: str) -> None:
        """The page's title."""
        self._channel.send({"op": "title", "text": str(text)})

    def set_unit(self, text: str | None) -> None:
        """The unit of the page's coordinates, for its scale bar; None where there is none to say."""
        self._channel.send({"op": "unit", "text": None if text is None else str(text)})

    def set_progress(self, text: str, share: float | None = None) -> None:
        """What is being done, and how much of it is; "" once it is done."""
        share = None if share is None else check_share("share", share)
        self._channel.send({"op": "progress", "text": str(text), "share": share})

    def end(self, text: str) -> None:
        """Say that the program has ended, and how to start it again; pages show it until they connect again."""
        self._channel.send({"op": "end", "text": str(text)})

    def stop(self) -> None:
        """Send the pages away and free port, thread and memory; twice is no error."""
        self._hub.stop()
        self._delivery.close()
        disown_port(self)

    # -- in the server's thread ---------------------------------------------------------------------------------------

    def _welcome(self, hello: dict[str, Any], wake: Callable[[], None]) -> _Visitor:
        channel = Channel(self._delivery, is_shared=False)
        size = (int(hello["size"][0]), int(hello["size"][1]))
        with self._delivery.lock:
            first = CameraState(**{**vars(self._first), "size": size})
            client = PageClient(channel, next(self._numbers), first, (self.scene, self.gui))
            visitor = _Visitor(self, client, channel, wake)
            self._clients[client.client_id] = client
            callbacks = tuple(self._on_connect)
        for callback in callbacks:
            client.worker.run(callback, client, always=True)
        return visitor

    def _leave(self, client: PageClient, channel: Channel) -> None:
        with self._delivery.lock:
            self._delivery.leave(channel)
            self._clients.pop(client.client_id, None)
            client.is_open = False
        for callback in tuple(self._on_disconnect):
            client.worker.run(callback, client, always=True)
        client.worker.end()

    def forget(self) -> None:
        """In a forked child, whose copies of the sockets are closed already: the pages are its parent's."""
        self._delivery.lock = threading.RLock()
        self._delivery.close()
        self._clients, self.is_child = {}, True


class _Visitor:
    """A page, as the hub knows it."""

    def __init__(self, server: PageServer, client: PageClient, channel: Channel, wake: Callable[[], None]):
        self._server, self._client, self._channel = server, client, channel
        self._outbox = server._delivery.join(channel, wake)
        self.take = client.take

    @property
    def own_bytes(self) -> int:
        """Of what waits for this page alone."""
        return self._outbox.own_bytes

    def unsent(self) -> tuple[list[Op], bool]:
        """What is to be sent now, and whether more waits for what is not complete yet."""
        return self._server._delivery.take(self._outbox)

    def has_more(self) -> bool:
        """Whether anything waits for it."""
        return bool(self._outbox)

    def leave(self) -> None:
        """It has gone."""
        self._server._leave(self._client, self._channel)
