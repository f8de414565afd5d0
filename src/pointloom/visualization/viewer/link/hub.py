"""Thread of the web server and its connections: `Hub`.

Uses websockets on a bound socket. Requests pass the guard and the token check. The page is sent with an ETag. A
websocket receives data at its own speed and is closed when it stops reading. Connections that are not pages yet are
limited (`waiting_connections.py`).
"""

from __future__ import annotations

import asyncio
import contextlib
import functools
import hmac
import http
import logging
import re
import socket
import threading
import time
import urllib.parse
from collections.abc import Callable, Iterable
from typing import Any, Protocol

import websockets.asyncio.server
import websockets.exceptions
from websockets.asyncio.server import ServerConnection
from websockets.datastructures import Headers
from websockets.http11 import Request, Response
from websockets.typing import Subprotocol

from ..guard import RequestGuard, response_headers
from .delivery import LONGEST_BATCH
from .packing import Op, pack
from .page import ServedPage, refused_page
from .waiting_connections import WaitingConnections, WatchedConnection
from .wire import MAX_BYTES, read

PROTOCOL_VERSION = 1
PROTOCOL = f"pointloom.{PROTOCOL_VERSION}"
OTHER_VERSION = 4001  # close code for a cached page of another version
MAX_CLIENTS = 32
MAX_OWN_BYTES = 1 << 30  # backlog limit of one page
# A page is closed after this time without reading or a pong. Pings are sent in between.
STALL_SECONDS = 60.0
PING_SECONDS = 20.0
WATCH_SECONDS = 1.0  # interval of checks
HELLO_SECONDS = 60.0  # limit for the first message
CLOSE_SECONDS = 3.0  # limit for the closing handshake
FLUSH_SECONDS = 0.5  # for waiting data at shutdown, which includes the shutdown notice
# A page sends at most one camera per frame. More messages at once are delayed,
# so that reading them does not block the program's threads.
MAX_AT_ONCE = 256
BURST_SECONDS = 0.25

log = logging.getLogger("pointloom.viewer")
log.addHandler(logging.NullHandler())  # otherwise Python prints warnings on stderr
# Failed handshakes of strangers must not fill the user's log: websockets reports each as an error.
_handshakes = logging.getLogger("pointloom.viewer.handshakes")
_handshakes.addHandler(logging.NullHandler())
_handshakes.propagate = False
_handshakes.setLevel(logging.WARNING)  # a stored record would keep its connection and the viewer alive


class Visitor(Protocol):
    """Interface of a page for the hub."""

    @property
    def own_bytes(self) -> int:
        """Memory of operations that wait for this page only."""
        ...

    def unsent(self) -> tuple[list[Op], bool]:
        """Operations to send now, and whether more wait for open batches."""
        ...

    def has_more(self) -> bool: ...

    def take(self, message: dict[str, Any]) -> None: ...

    def leave(self) -> None: ...


Welcome = Callable[[dict[str, Any], Callable[[], None]], Visitor]


class Hub:
    """A web server in its own thread, on a listening socket `bound`. `token` is required in the address.

    `welcome` is called with a page's first message and a thread-safe function that wakes its sender.

    Attributes:
        client_count: Number of connected pages.
        last_request: Time of the last valid request for the page (`time.monotonic`).
    """

    def __init__(self, bound: socket.socket, guard: RequestGuard, page: ServedPage, token: str, welcome: Welcome):
        self._bound, self._guard, self._page, self._token, self._welcome = bound, guard, page, token, welcome
        self._refused = refused_page()
        self.client_count, self.last_request = 0, time.monotonic()
        self.lines: dict[ServerConnection, Visitor | None] = {}
        self.waiting = WaitingConnections()
        self._loop = asyncio.new_event_loop()
        self._stopping = asyncio.Event()
        self._failure: BaseException | None = None
        ready = threading.Event()
        self._thread = threading.Thread(target=self._run, args=(ready,), name="pointloom-pages", daemon=True)
        self._thread.start()
        ready.wait()
        if self._failure is not None:
            raise self._failure

    def stop(self) -> None:
        """Disconnect the pages, free the port and end the thread. A second call has no effect."""
        with contextlib.suppress(OSError):  # the copy of a child does not listen then either
            self._bound.shutdown(socket.SHUT_RDWR)
        with contextlib.suppress(RuntimeError):  # the loop has ended
            self._loop.call_soon_threadsafe(self._stopping.set)
        if threading.current_thread() is not self._thread:
            self._thread.join(timeout=5.0)

    def cut_all(self) -> None:
        with contextlib.suppress(RuntimeError):
            self._loop.call_soon_threadsafe(lambda: [line.transport.abort() for line in tuple(self.lines)])

    def _run(self, ready: threading.Event) -> None:
        loop = self._loop
        loop.set_exception_handler(_log_quietly)
        asyncio.set_event_loop(loop)
        try:
            loop.run_until_complete(self._serve(ready))
            left = asyncio.all_tasks(loop)
            for task in left:
                task.cancel()
            loop.run_until_complete(asyncio.gather(*left, return_exceptions=True))
            loop.run_until_complete(loop.shutdown_asyncgens())
        except BaseException as error:
            if ready.is_set():
                raise
            self._failure = error
        finally:
            ready.set()
            asyncio.set_event_loop(None)
            loop.close()
            self._bound.close()

    async def _serve(self, ready: threading.Event) -> None:
        server = await websockets.asyncio.server.serve(
            self._attend,
            sock=self._bound,
            max_size=MAX_BYTES,
            compression=None,  # the arrays hardly shrink, and it takes time
            process_request=self._answer,
            select_subprotocol=lambda _, offered: _choose(offered),
            ping_interval=None,  # `_watch` pings: a slow connection is no reason to close a page
            open_timeout=HELLO_SECONDS,  # the page must load over slow connections, too
            close_timeout=CLOSE_SECONDS,
            server_header=None,
            logger=_handshakes,
            create_connection=functools.partial(WatchedConnection, self.waiting),  # pyright: ignore[reportArgumentType]
        )
        ready.set()
        await self._stopping.wait()
        await self._flush_pages()
        server.close()
        await asyncio.wait([asyncio.ensure_future(server.wait_closed())], timeout=0.25)
        for line in tuple(self.lines):  # pages that do not read the shutdown notice
            line.transport.abort()
        await asyncio.wait([asyncio.ensure_future(server.wait_closed())], timeout=2.0)

    async def _flush_pages(self) -> None:
        end = time.monotonic() + FLUSH_SECONDS
        while time.monotonic() < end and not all(self._has_all(line) for line in tuple(self.lines)):
            await asyncio.sleep(0.01)

    def _has_all(self, line: ServerConnection) -> bool:
        visitor = self.lines.get(line)
        return visitor is None or (not visitor.has_more() and not line.transport.get_write_buffer_size())

    def _answer(self, connection: ServerConnection, request: Request) -> Response | None:
        """HTTP response, or None to open a websocket."""
        headers: dict[str, list[str]] = {}
        for name, value in request.headers.raw_items():
            headers.setdefault(name.lower(), []).append(value)
        websocket = "upgrade" in headers
        if refusal := self._guard.refusal(headers, websocket=websocket):
            return _response(http.HTTPStatus.FORBIDDEN, f"{refusal}\n".encode())
        path, _, query = request.path.partition("?")
        if path != ("/live" if websocket else "/"):
            return _response(http.HTTPStatus.NOT_FOUND, b"there is one page here: /\n")
        if not self._is_token(query):
            body = self._refused
            return _response(http.HTTPStatus.FORBIDDEN, body.text, host=headers["host"][0], sources=body.sources)
        self.waiting.admit(connection)
        if not websocket:
            self.last_request = time.monotonic()
            return self._page_answer(headers)
        if _choose(one.strip() for one in ",".join(headers.get("sec-websocket-protocol", [])).split(",")) is None:
            return _response(http.HTTPStatus.UPGRADE_REQUIRED, b"this page belongs to another version: reload it\n")
        if self.client_count >= MAX_CLIENTS:
            return _response(http.HTTPStatus.SERVICE_UNAVAILABLE, f"{MAX_CLIENTS} pages are open: close one\n".encode())
        return None

    def _is_token(self, query: str) -> bool:
        try:
            given = urllib.parse.parse_qs(query, max_num_fields=16).get("token", [])
        except ValueError:
            return False
        return len(given) == 1 and hmac.compare_digest(given[0].encode("utf-8", "replace"), self._token.encode())

    def _page_answer(self, headers: dict[str, list[str]]) -> Response:
        page, host = self._page, headers["host"][0]
        known = [one.strip().removeprefix("W/") for one in ",".join(headers.get("if-none-match", [])).split(",")]
        if page.tag in known:
            answer = _response(http.HTTPStatus.NOT_MODIFIED, b"", host=host, sources=page.sources)
        else:
            is_packed = "gzip" in ",".join(headers.get("accept-encoding", []))
            body = page.packed if is_packed else page.text
            answer = _response(http.HTTPStatus.OK, body, host=host, sources=page.sources)
            if is_packed:
                answer.headers["Content-Encoding"] = "gzip"
        del answer.headers["Cache-Control"]
        answer.headers["Cache-Control"] = "no-cache"  # cached but revalidated: usually answered by 304
        answer.headers["Vary"] = "Accept-Encoding"
        answer.headers["ETag"] = page.tag
        return answer

    async def _attend(self, connection: ServerConnection) -> None:
        if self.client_count >= MAX_CLIENTS:  # several requests at once may each have passed the check before
            return await connection.close(1013, "too many pages are open")
        if connection.subprotocol != PROTOCOL:
            return await connection.close(OTHER_VERSION, "this page belongs to another version: reload it")
        self.client_count += 1
        self.waiting.remove(connection)
        self.lines[connection] = None
        tasks: list[asyncio.Task[None]] = []
        visitor: Visitor | None = None
        try:
            with contextlib.suppress(websockets.exceptions.ConnectionClosed, TimeoutError):
                hello = await asyncio.wait_for(self._hello(connection), HELLO_SECONDS)
                if hello is None:
                    return
                loop, woken = asyncio.get_running_loop(), asyncio.Event()
                self.lines[connection] = visitor = self._welcome(hello, lambda: _wake(loop, woken))
                parts = (_send(connection, visitor, woken), _consume(connection, visitor), _watch(connection, visitor))
                tasks = [loop.create_task(part) for part in parts]
                done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
                for task in done:
                    task.result()
        except Exception:
            log.exception("a page of the viewer was disconnected")
        finally:
            self.client_count -= 1
            self.lines.pop(connection, None)
            if visitor is not None:
                visitor.leave()
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)

    @staticmethod
    async def _hello(connection: ServerConnection) -> dict[str, Any] | None:
        """First message of a page. None if it was closed because of another version."""
        try:
            message = read(await connection.recv())
        except ValueError as error:
            log.debug("a page: %s", error)
            message = None
        if message is None or message["say"] != "hello":
            await connection.close(1007, "expected hello as the first message")
        elif message["version"] != PROTOCOL_VERSION:
            await connection.close(OTHER_VERSION, "this page belongs to another version: reload it")
        else:
            return message
        return None


def _choose(offered: Iterable[str]) -> Subprotocol | None:
    """The subprotocol, or another version of it: its page is opened to give a reason, which a refusal would hide."""
    supported = [one for one in offered if re.fullmatch(r"pointloom\.[0-9]{1,4}", one)]
    return Subprotocol(PROTOCOL if PROTOCOL in supported else supported[0]) if supported else None


def _wake(loop: asyncio.AbstractEventLoop, woken: asyncio.Event) -> None:
    with contextlib.suppress(RuntimeError):  # the loop has ended
        loop.call_soon_threadsafe(woken.set)


async def _send(connection: ServerConnection, visitor: Visitor, woken: asyncio.Event) -> None:
    while True:
        woken.clear()
        ops, more = visitor.unsent()
        if ops:
            await connection.send(pack(ops))
        else:
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(woken.wait(), LONGEST_BATCH if more else None)


async def _consume(connection: ServerConnection, visitor: Visitor) -> None:
    """Forward messages. Malformed ones end the connection, unexpected ones are ignored."""
    begun, count = time.monotonic(), 0
    while True:
        raw = await connection.recv()
        count += 1
        if count >= MAX_AT_ONCE:
            await asyncio.sleep(max(begun + BURST_SECONDS - time.monotonic(), 0))  # throttles the sender through TCP
            begun, count = time.monotonic(), 0
        try:
            message = read(raw)
        except ValueError as error:
            log.debug("a page: %s", error)
            return await connection.close(1007, "not a message of this page")
        if message is None:
            continue
        try:
            visitor.take(message)
        except Exception:  # an error of one page must not affect others
            log.debug("message %s of a page failed", message["say"], exc_info=True)


def _unsent_bytes(connection: ServerConnection) -> int:
    return connection.transport.get_write_buffer_size()


async def _watch(connection: ServerConnection, visitor: Visitor) -> None:
    """Ping a page. Close it if it has stopped reading or its backlog is too large."""
    loop = asyncio.get_running_loop()
    seen, since, pinged = -1, loop.time(), loop.time()
    pong: Any = None
    while True:
        await asyncio.sleep(WATCH_SECONDS)
        unsent, now = _unsent_bytes(connection), loop.time()
        if pong is not None and pong.done():
            pong, since = None, now
        if unsent != seen or (unsent == 0 and pong is None):
            seen, since = unsent, now
        if now - since > STALL_SECONDS or visitor.own_bytes > MAX_OWN_BYTES:
            log.debug("a page that does not read was disconnected")
            connection.transport.abort()
            return
        if pong is None and now - pinged > PING_SECONDS and unsent == 0:
            pong, pinged = asyncio.ensure_future(await connection.ping()), now


def _log_quietly(_: asyncio.AbstractEventLoop, context: dict[str, Any]) -> None:
    log.debug("%s", context.get("message"), exc_info=context.get("exception"))


def _response(
    status: http.HTTPStatus, body: bytes, *, host: str = "localhost", sources: dict[str, list[str]] | None = None
) -> Response:
    """A response with the common headers. HTML if `sources` is given, else plain text."""
    headers = Headers(response_headers(host, sources))
    headers["Content-Type"] = f"text/{'plain' if sources is None else 'html'}; charset=utf-8"
    headers["Content-Length"] = str(len(body))
    headers["Connection"] = "close"
    return Response(status.value, status.phrase, headers, body)
