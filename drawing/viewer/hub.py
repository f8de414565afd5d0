"""viser behind the guard: the one file that knows viser's private parts (1.1; pyproject.toml pins it).

viser's own server listens on every interface, answers any page, lets a client open a tunnel to a public address, sets
any attribute of a GUI handle that a client names, prints on stdout, and waits without end where no port is free. Here
its websocket loop is replaced by one over a socket that is bound already; its scene, its GUI and its way of sending
messages are untouched.
"""

from __future__ import annotations

import asyncio
import builtins
import concurrent.futures
import contextlib
import dataclasses
import functools
import gzip
import http
import inspect
import logging
import math
import socket
import threading
import time
import types
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import viser
import viser._viser
import viser.infra
import websockets.asyncio.server
import websockets.exceptions
from viser import _messages
from viser.infra._async_message_buffer import AsyncMessageBuffer
from viser.infra._infra import ClientId, WebsockClientConnection, WebsockServer, _ClientHandleState, _message_producer
from viser.infra._messages import Message, get_type_hints_cached
from websockets.asyncio.server import ServerConnection
from websockets.datastructures import Headers
from websockets.http11 import Request, Response
from websockets.typing import Subprotocol

from .guard import MOST_BYTES, RequestGuard, control_value, read_message, response_headers

MOST_CLIENTS = 32
# Of one client: messages in work, callbacks of all clients that wait for a thread, and bytes that it has not read yet.
MOST_IN_WORK = 64
MOST_CALLBACKS = 256
MOST_UNREAD_BYTES = 1 << 30
MOST_UPLOADS = 4  # files at once, of at most MOST_BYTES each
# A client is dropped when it neither takes a byte nor answers a ping for so long; pings go out in between.
STALL_SECONDS = 60.0
PING_SECONDS = 20.0
WATCH_SECONDS = 1.0  # between looks at whether it reads

_PROTOCOL = f"viser-v{viser.__version__}"
_CHECKED = (_messages.GuiUpdateMessage, _messages.FileTransferStartUpload, _messages.FileTransferPart)
_NEVER = ("ShareUrlRequest", "ShareUrlDisconnect")

log = logging.getLogger("pointloom.viewer")
log.addHandler(logging.NullHandler())  # without one, Python prints warnings on stderr
# What strangers send must not fill the user's log: websockets reports each failed handshake as an error of ours.
_handshakes = logging.getLogger("pointloom.viewer.handshakes")
_handshakes.addHandler(logging.NullHandler())
_handshakes.propagate = False
_handshakes.setLevel(logging.WARNING)  # a record holds its connection: kept by a handler, it keeps the viewer


class GuardedHub(WebsockServer):
    """viser's websocket server over a bound socket, with the guard's rules and bounds on what a client may take."""

    def __init__(self, bound: socket.socket, guard: RequestGuard, title: str, **settings: Any):
        super().__init__(**settings)
        self._bound, self._guard = bound, guard
        assert self._http_server_root is not None
        self._page = gzip.compress(_page(self._http_server_root / "index.html", title), 6)
        self._client_count = 0
        self._next_id = 0
        self.last_request = -math.inf  # when the page was last given (time.monotonic)
        self.owner: GuardedViser | None = None  # once it is complete

    # -- the thread ---------------------------------------------------------------------------------------------------

    def _background_worker(self, ready_sem: threading.Semaphore) -> None:
        loop = asyncio.new_event_loop()
        loop.set_exception_handler(_log_quietly)
        asyncio.set_event_loop(loop)
        self._background_event_loop = loop
        self._stop_event = asyncio.Event()
        self._broadcast_buffer = AsyncMessageBuffer(loop, persistent_messages=True)
        try:
            loop.run_until_complete(self._serve(ready_sem))
            left = asyncio.all_tasks(loop)
            for task in left:
                task.cancel()
            loop.run_until_complete(asyncio.gather(*left, return_exceptions=True))
            loop.run_until_complete(loop.shutdown_asyncgens())
        finally:
            asyncio.set_event_loop(None)
            loop.close()
            self._bound.close()

    async def _serve(self, ready_sem: threading.Semaphore) -> None:
        assert self._stop_event is not None
        server = await websockets.asyncio.server.serve(
            self._attend,
            sock=self._bound,
            max_size=MOST_BYTES,
            compression=None,  # the arrays hardly shrink, and it takes time
            process_request=self._answer,
            select_subprotocol=lambda _, offered: Subprotocol(_PROTOCOL) if _PROTOCOL in offered else None,
            ping_interval=None,  # `_watch` pings: a slow line is no reason to drop a client
            open_timeout=60.0,  # the page goes over slow lines as well
            close_timeout=30.0,
            server_header=None,
            logger=_handshakes,
        )
        ready_sem.release()
        await self._stop_event.wait()
        server.close()
        await asyncio.wait([asyncio.ensure_future(server.wait_closed())], timeout=0.25)
        for connection in tuple(server.handlers):  # who does not read its farewell
            connection.transport.abort()
        await asyncio.wait([asyncio.ensure_future(server.wait_closed())], timeout=2.0)

    # -- requests -----------------------------------------------------------------------------------------------------

    def _answer(self, connection: ServerConnection, request: Request) -> Response | None:
        """An HTTP answer, or None for a websocket that may open."""
        headers: dict[str, list[str]] = {}
        for name, value in request.headers.raw_items():
            headers.setdefault(name.lower(), []).append(value)
        websocket = "upgrade" in headers
        if refusal := self._guard.refusal(headers, websocket=websocket):
            return _response(http.HTTPStatus.FORBIDDEN, refusal)
        path = request.path.partition("?")[0]
        if path not in ("/", "/index.html"):
            return _response(http.HTTPStatus.NOT_FOUND, "there is one page here: /")
        self.last_request = time.monotonic()
        if websocket:
            if _PROTOCOL not in request.headers.get("Sec-WebSocket-Protocol", "").replace(",", " ").split():
                return _response(http.HTTPStatus.UPGRADE_REQUIRED, "this page is of another version: load it again")
            if self._client_count >= MOST_CLIENTS:
                return _response(http.HTTPStatus.SERVICE_UNAVAILABLE, f"{MOST_CLIENTS} pages are open: close one")
            return None
        encoded = "gzip" in request.headers.get("Accept-Encoding", "")
        body = self._page if encoded else gzip.decompress(self._page)
        answer = _response(http.HTTPStatus.OK, body, host=headers["host"][0])
        if encoded:
            answer.headers["Content-Encoding"] = "gzip"
        return answer

    # -- clients ------------------------------------------------------------------------------------------------------

    async def _attend(self, connection: ServerConnection) -> None:
        """One client, from its first message to its last; the order of steps is viser's `ws_handler`."""
        if self._client_count >= MOST_CLIENTS:  # several asked at once, each while there was room
            return await connection.close(1013, "too many pages are open")
        loop = asyncio.get_running_loop()
        client_id, self._next_id = self._next_id, self._next_id + 1
        buffer = AsyncMessageBuffer(loop, persistent_messages=False)
        buffer._warned_push_after_done = True  # a page may go while something is sent to it: that is nobody's fault
        state = _ClientHandleState(buffer, loop)
        client = WebsockClientConnection(client_id, state)
        self._client_count += 1
        self._client_state_from_id[client_id] = state
        self._live_connections[client_id] = connection
        tasks: list[asyncio.Task[None]] = []
        try:
            await self._tell(self._client_connect_cb, client)
            parts = (
                _message_producer(connection, state.message_buffer, client_id),
                _message_producer(connection, self._broadcast_buffer, client_id, self._backlog_done_message),
                self._consume(connection, client),
                _watch(connection, state.message_buffer),
            )
            tasks = [loop.create_task(part) for part in parts]
            with contextlib.suppress(websockets.exceptions.ConnectionClosed):
                await asyncio.gather(*tasks)
        except Exception:
            log.exception("a page of the viewer was dropped")
        finally:
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)
            state.message_buffer.set_done()
            self._client_state_from_id.pop(client_id, None)
            self._live_connections.pop(client_id, None)
            self._broadcast_buffer.generator_cursors.pop(client_id, None)
            self._client_count -= 1
            await self._tell(self._client_disconnect_cb, client)

    @staticmethod
    async def _tell(callbacks: list[Callable[..., Any]], client: WebsockClientConnection) -> None:
        for callback in callbacks:
            answer = callback(client)
            if inspect.isawaitable(answer):
                await answer

    async def _consume(self, connection: ServerConnection, client: WebsockClientConnection) -> None:
        """Hand on what a client says; what is no message ends it, what does not fit is passed over."""
        in_work: set[asyncio.Task[None]] = set()
        while True:
            raw = await connection.recv()
            try:
                if not isinstance(raw, bytes):
                    raise ValueError("text")
                known = read_message(raw, functools.partial(self._hints_of, client)) is not None
            except ValueError as error:
                log.debug("client %d: %s", client.client_id, error)
                return await connection.close(1007, "not a message of this page")
            message = _deserialize(raw) if known else None
            if message is None:
                continue
            while len(in_work) >= MOST_IN_WORK or self._callbacks_waiting() > MOST_CALLBACKS:
                await asyncio.sleep(0.01)  # it has to wait, and TCP makes it
            task = asyncio.ensure_future(self._handle(client, message))
            in_work.add(task)
            task.add_done_callback(in_work.discard)

    async def _handle(self, client: WebsockClientConnection, message: Message) -> None:
        clients = {} if self.owner is None else self.owner._connected_clients
        for handler, scope in ((self, self.owner), (client, clients.get(client.client_id))):
            try:
                if isinstance(message, _CHECKED):
                    if scope is None:
                        continue  # there is no GUI yet
                    _check_change(scope.gui, client.client_id, message)
                await handler._handle_incoming_message(ClientId(client.client_id), message)
            except Exception:  # viser asserts and casts as it goes: nobody else is to suffer from what one page says
                log.debug("client %d: %s", client.client_id, type(message).__name__, exc_info=True)

    def _callbacks_waiting(self) -> int:
        return 0 if self.owner is None else self.owner._thread_executor._work_queue.qsize()

    def _hints_of(self, client: WebsockClientConnection, kind: str) -> Mapping[str, Any] | None:
        """The fields of a kind of message that somebody listens to."""
        found = _messages.Message._subclass_from_type_string().get(kind)
        heard = found in self._incoming_handlers or found in client._incoming_handlers
        return get_type_hints_cached(found) if found is not None and heard and kind not in _NEVER else None


def _deserialize(raw: bytes) -> Message | None:
    """viser's message of a page, whose fields were checked; None where one is missing."""
    try:
        return _messages.Message.deserialize(raw)
    except TypeError:
        return None


def _log_quietly(_: asyncio.AbstractEventLoop, context: dict[str, Any]) -> None:
    log.debug("%s", context.get("message"), exc_info=context.get("exception"))


async def _watch(connection: ServerConnection, buffer: AsyncMessageBuffer) -> None:
    """Ping a client, and drop it when it has stopped reading or more waits for it than may."""
    loop = asyncio.get_running_loop()
    seen, since, pinged = -1, loop.time(), loop.time()
    pong: asyncio.Future[float] | None = None
    while True:
        await asyncio.sleep(WATCH_SECONDS)
        unsent, now = connection.transport.get_write_buffer_size(), loop.time()
        if pong is not None and pong.done():
            pong, since = None, now
        if unsent != seen or (unsent == 0 and pong is None):
            seen, since = unsent, now
        if now - since > STALL_SECONDS or unsent + _buffered_bytes(buffer) > MOST_UNREAD_BYTES:
            log.debug("a page that does not read was dropped")
            connection.transport.abort()
            return
        if pong is None and now - pinged > PING_SECONDS and unsent == 0:
            pong, pinged = asyncio.ensure_future(await connection.ping()), now


def _buffered_bytes(buffer: AsyncMessageBuffer) -> int:
    """The bytes of arrays in the messages that wait for one client."""
    with buffer.buffer_lock:
        waiting: list[Any] = [vars(message) for message in buffer.message_from_id.values()]
    total = 0
    while waiting:  # arrays stand in fields, in the properties of nodes and in changes of these
        value = waiting.pop()
        if isinstance(value, dict):
            waiting += value.values()
        elif dataclasses.is_dataclass(value):
            waiting.append(vars(value))
        else:
            total += len(value) if isinstance(value, bytes) else getattr(value, "nbytes", 0)
    return total


def _check_change(gui: Any, client_id: int, message: Any) -> None:
    """Check what a page sets a control of this GUI to; viser would set any attribute that it names, and cast.

    Raises:
        ValueError: it is no value for this control, or a file beyond the bounds.
    """
    uploads = gui._current_file_upload_states
    if isinstance(message, _messages.FileTransferStartUpload):
        own = sum(state["client_id"] == client_id for state in uploads.values())
        if own >= MOST_UPLOADS or not 0 <= message.size_bytes <= MOST_BYTES or message.transfer_uuid in uploads:
            raise ValueError("this file is too large, or one too many")
    elif isinstance(message, _messages.FileTransferPart):
        state = uploads.get(message.transfer_uuid)
        if state is not None and state["transferred_bytes"] + len(message.content) > state["total_bytes"]:
            raise ValueError("this file is larger than it said")
    elif (handle := gui._gui_input_handle_from_uuid.get(message.uuid)) is not None:
        if set(message.updates) != {"value"}:
            raise ValueError(f"only values may be set, got {sorted(message.updates)}")
        props = handle._impl.props
        low, high, options = (getattr(props, name, None) for name in ("min", "max", "options"))
        message.updates["value"] = control_value(
            message.updates["value"], handle._impl.value, low=low, high=high, options=options
        )


def send_camera(client: viser.ClientHandle, position: Any, look_at: Any, up: Any, fov: float) -> None:
    """Tell a page where its camera stands, whatever it is believed to be.

    viser's setters leave out what equals the last that the page said. That may be older than what was sent since: then
    one of two messages that belong together was missing, and the page looked past the scene.
    """
    for message in (
        _messages.SetCameraUpDirectionMessage(_triple(up)),
        _messages.SetCameraPositionMessage(_triple(position)),
        _messages.SetCameraLookAtMessage(_triple(look_at)),
        _messages.SetCameraFovMessage(float(fov)),
    ):
        client._websock_connection.queue_message(message)


def _triple(values: Any) -> tuple[float, float, float]:
    x, y, z = map(float, values)
    return x, y, z


class _QuietPool(concurrent.futures.ThreadPoolExecutor):
    """Runs callbacks; what they raise is logged, where viser would print it."""

    def submit(self, function: Callable[..., Any], /, *arguments: Any, **settings: Any) -> Any:
        def run() -> Any:
            try:
                return function(*arguments, **settings)
            except Exception:
                log.exception("a callback of the viewer failed")
                return None

        return super().submit(run)


def _response(status: http.HTTPStatus, body: str | bytes, *, host: str = "localhost") -> Response:
    """A page (bytes) or a line of text, under the headers that every answer has."""
    data, kind = (body, "html") if isinstance(body, bytes) else (f"{body}\n".encode(), "plain")
    headers = Headers(response_headers(host))
    headers["Content-Type"] = f"text/{kind}; charset=utf-8"
    headers["Content-Length"] = str(len(data))
    headers["Connection"] = "close"
    return Response(status.value, status.phrase, headers, data)


_ICON = (
    "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 16 16'%3E%3Cg fill='%232563eb'%3E"
    "%3Ccircle cx='3' cy='4' r='2'/%3E%3Ccircle cx='8' cy='3' r='2'/%3E%3Ccircle cx='13' cy='5' r='2'/%3E"
    "%3Ccircle cx='4' cy='9' r='2'/%3E%3Ccircle cx='9' cy='8' r='2'/%3E%3Ccircle cx='12' cy='12' r='2'/%3E"
    "%3Ccircle cx='6' cy='13' r='2'/%3E%3C/g%3E%3C/svg%3E"
)


# A notebook shows its frame once the page says that it is there (drawing/notebook_output.py).
# viser's page flies on these letters, W above all, which is ours for wireframes: its hotkeys listen at the root element
# and its camera at the document above, so that events that end at the root reach hotkeys alone.
_NO_FLIGHT = """<script>
if (parent !== window) parent.postMessage("pointloom", "*");
document.documentElement.addEventListener("keydown", (event) => {
  if (/^Key[WASDQE]$/.test(event.code)) event.stopPropagation();
});
</script>"""


def _page(path: Path, title: str) -> bytes:
    """viser's page under our title and icon, with its letters for our keys."""
    text = path.read_text(encoding="utf-8")
    start = text.find('href="data:image/svg+xml,')
    if start >= 0:
        text = text[: start + 6] + _ICON + text[text.index('"', start + 6) :]
    escaped = title.replace("&", "&amp;").replace("<", "&lt;")
    return text.replace("<title>Viser</title>", f"<title>{escaped}</title>{_NO_FLIGHT}", 1).encode()


def _over_other_names(function: types.FunctionType, **names: Any) -> Any:
    """The same function that finds these names in place of its module's: nothing is patched for anybody else."""
    found = {**function.__globals__, **names}
    changed = types.FunctionType(
        function.__code__, found, function.__name__, function.__defaults__, function.__closure__
    )
    changed.__kwdefaults__ = function.__kwdefaults__
    return changed


def _import_without_print(
    name: str, globals: Any = None, locals: Any = None, fromlist: Any = (), level: int = 0
) -> Any:
    if name == "rich" and not fromlist:
        return types.SimpleNamespace(print=lambda *_, **__: None)
    return builtins.__import__(name, globals, locals, fromlist, level)


class GuardedViser(viser.ViserServer):
    """viser's server that listens on a given socket, prints nothing and opens no tunnel."""

    def __init__(self, bound: socket.socket, guard: RequestGuard, title: str):
        hub = functools.partial(GuardedHub, bound, guard, title)
        start = _over_other_names(
            viser.ViserServer.__init__,  # type: ignore[arg-type]
            ThreadPoolExecutor=_QuietPool,
            infra=types.SimpleNamespace(**{**vars(viser.infra), "WebsockServer": hub}),
            __builtins__={**vars(builtins), "__import__": _import_without_print},
        )
        host, port = bound.getsockname()[:2]
        start(self, host=host, port=port, label=title, verbose=False)
        for kind in (_messages.ShareUrlRequest, _messages.ShareUrlDisconnect):
            self._websock_server.unregister_handler(kind)
        self._websock_server.owner = self  # type: ignore[attr-defined]
        self.gui.configure_theme(show_logo=False, show_share_button=False)

    def request_share_url(self, verbose: bool = True) -> str | None:
        """Refused: a scan leaves this machine only over a line that its owner opens."""
        raise RuntimeError("the viewer opens no tunnel: use ssh -L")

    def disconnect_share_url(self) -> None:
        """Nothing to do: there is no tunnel."""
