"""The thread that serves the page and talks to those that look: `Hub`.

websockets' server over a socket that is bound already. Requests pass the guard and the token; the page goes out whole,
with an ETag; a websocket gets what waits for it in slices, as fast as it reads, and is cut off when it reads nothing.
"""

from __future__ import annotations

import asyncio
import contextlib
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
from .wire import MOST_BYTES, read

VERSION = 1
PROTOCOL = f"pointloom.{VERSION}"
OTHER_VERSION = 4001  # with this code a page is closed that a browser has kept from another version
MOST_CLIENTS = 32
MOST_OWN_BYTES = 1 << 30  # that wait for one page alone
# A page is dropped when it neither takes a byte nor answers a ping for so long; pings go out in between.
STALL_SECONDS = 60.0
PING_SECONDS = 20.0
WATCH_SECONDS = 1.0  # between looks at whether it reads
HELLO_SECONDS = 60.0  # until a page has said who it is
CLOSE_SECONDS = 3.0  # for the end of a connection to be answered
FAREWELL_SECONDS = 0.5  # for what waits for pages when the server stops: words for the end are among it
# A page says at most one camera a picture. One that says more than that many messages at once has to wait, so that the
# program's own threads are not held up by reading them.
MOST_AT_ONCE = 256
BURST_SECONDS = 0.25

log = logging.getLogger("pointloom.viewer")
log.addHandler(logging.NullHandler())  # without one, Python prints warnings on stderr
# What strangers send must not fill the user's log: websockets reports each failed handshake as an error of ours.
_handshakes = logging.getLogger("pointloom.viewer.handshakes")
_handshakes.addHandler(logging.NullHandler())
_handshakes.propagate = False
_handshakes.setLevel(logging.WARNING)  # a record holds its connection: kept by a handler, it keeps the viewer


class Visitor(Protocol):
    """What the hub tells of one page."""

    @property
    def own_bytes(self) -> int:
        """Of what waits for this page alone."""
        ...

    def unsent(self) -> tuple[list[Op], bool]:
        """What is to be sent now, and whether more waits for what is not complete yet."""
        ...

    def has_more(self) -> bool:
        """Whether anything waits for it."""
        ...

    def take(self, said: dict[str, Any]) -> None:
        """The page said this."""

    def leave(self) -> None:
        """The page has gone."""


Welcome = Callable[[dict[str, Any], Callable[[], None]], Visitor]


class Hub:
    """A server in a thread of its own.

    Args:
        bound: A listening socket.
        guard: Which requests are answered.
        page: What is served.
        token: What an address must hold.
        welcome: Called with a page's hello, and with what wakes its sender from any thread.

    Attributes:
        client_count: Pages that are connected.
        last_asked: When the page was last asked for, by `time.monotonic`.
    """

    def __init__(self, bound: socket.socket, guard: RequestGuard, page: ServedPage, token: str, welcome: Welcome):
        self._bound, self._guard, self._page, self._token, self._welcome = bound, guard, page, token, welcome
        self._refused = refused_page()
        self.client_count, self.last_asked = 0, time.monotonic()
        self.lines: dict[ServerConnection, Visitor | None] = {}
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
        """Send the pages away, free the port and end the thread; twice is no error."""
        with contextlib.suppress(OSError):  # a copy that a child has of it does not listen then either
            self._bound.shutdown(socket.SHUT_RDWR)
        with contextlib.suppress(RuntimeError):  # the loop has ended
            self._loop.call_soon_threadsafe(self._stopping.set)
        if threading.current_thread() is not self._thread:
            self._thread.join(timeout=5.0)

    def cut_all(self) -> None:
        """Cut off every page."""
        with contextlib.suppress(RuntimeError):
            self._loop.call_soon_threadsafe(lambda: [line.transport.abort() for line in tuple(self.lines)])

    # -- the thread ---------------------------------------------------------------------------------------------------

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
            max_size=MOST_BYTES,
            compression=None,  # the arrays hardly shrink, and it takes time
            process_request=self._answer,
            select_subprotocol=lambda _, offered: _choose(offered),
            ping_interval=None,  # `_watch` pings: a slow line is no reason to drop a page
            open_timeout=HELLO_SECONDS,  # the page goes over slow lines as well
            close_timeout=CLOSE_SECONDS,
            server_header=None,
            logger=_handshakes,
        )
        ready.set()
        await self._stopping.wait()
        await self._say_farewell()
        server.close()
        await asyncio.wait([asyncio.ensure_future(server.wait_closed())], timeout=0.25)
        for line in tuple(self.lines):  # who does not read its farewell
            line.transport.abort()
        await asyncio.wait([asyncio.ensure_future(server.wait_closed())], timeout=2.0)

    async def _say_farewell(self) -> None:
        """Give pages a moment to take what waits for them."""
        end = time.monotonic() + FAREWELL_SECONDS
        while time.monotonic() < end and not all(self._has_all(line) for line in tuple(self.lines)):
            await asyncio.sleep(0.01)

    def _has_all(self, line: ServerConnection) -> bool:
        visitor = self.lines.get(line)
        return visitor is None or (not visitor.has_more() and not line.transport.get_write_buffer_size())

    # -- requests -----------------------------------------------------------------------------------------------------

    def _answer(self, connection: ServerConnection, request: Request) -> Response | None:
        """An HTTP answer, or None for a websocket that may open."""
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
        if not websocket:
            self.last_asked = time.monotonic()
            return self._page_answer(headers)
        if _choose(one.strip() for one in ",".join(headers.get("sec-websocket-protocol", [])).split(",")) is None:
            return _response(http.HTTPStatus.UPGRADE_REQUIRED, b"this page is of another version: load it again\n")
        if self.client_count >= MOST_CLIENTS:
            return _response(
                http.HTTPStatus.SERVICE_UNAVAILABLE, f"{MOST_CLIENTS} pages are open: close one\n".encode()
            )
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
        answer.headers["Cache-Control"] = "no-cache"  # kept, but asked for each time: then 304 is all that goes over
        answer.headers["Vary"] = "Accept-Encoding"
        answer.headers["ETag"] = page.tag
        return answer

    # -- pages --------------------------------------------------------------------------------------------------------

    async def _attend(self, connection: ServerConnection) -> None:
        """One page, from its hello to its end."""
        if self.client_count >= MOST_CLIENTS:  # several asked at once, each while there was room
            return await connection.close(1013, "too many pages are open")
        if connection.subprotocol != PROTOCOL:
            return await connection.close(OTHER_VERSION, "this page is of another version: load it again")
        self.client_count += 1
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
            log.exception("a page of the viewer was dropped")
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
        """The first message of a page; None once it was sent away for another."""
        try:
            said = read(await connection.recv())
        except ValueError as error:
            log.debug("a page: %s", error)
            said = None
        if said is None or said["say"] != "hello":
            await connection.close(1007, "a page says hello first")
        elif said["version"] != VERSION:
            await connection.close(OTHER_VERSION, "this page is of another version: load it again")
        else:
            return said
        return None


def _choose(offered: Iterable[str]) -> Subprotocol | None:
    """Ours, or another version of it, so that its page can be told: browsers keep the reason of a refusal back."""
    ours = [one for one in offered if re.fullmatch(r"pointloom\.[0-9]{1,4}", one)]
    return Subprotocol(PROTOCOL if PROTOCOL in ours else ours[0]) if ours else None


def _wake(loop: asyncio.AbstractEventLoop, woken: asyncio.Event) -> None:
    with contextlib.suppress(RuntimeError):  # the loop has ended
        loop.call_soon_threadsafe(woken.set)


async def _send(connection: ServerConnection, visitor: Visitor, woken: asyncio.Event) -> None:
    """Send what waits, as fast as the page reads."""
    while True:
        woken.clear()
        ops, more = visitor.unsent()
        if ops:
            await connection.send(pack(ops))
        else:
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(woken.wait(), LONGEST_BATCH if more else None)


async def _consume(connection: ServerConnection, visitor: Visitor) -> None:
    """Hand on what a page says; what is no message ends it, what does not fit is passed over."""
    begun, count = time.monotonic(), 0
    while True:
        raw = await connection.recv()
        count += 1
        if count >= MOST_AT_ONCE:
            await asyncio.sleep(max(begun + BURST_SECONDS - time.monotonic(), 0))  # TCP makes it wait
            begun, count = time.monotonic(), 0
        try:
            said = read(raw)
        except ValueError as error:
            log.debug("a page: %s", error)
            return await connection.close(1007, "not a message of this page")
        if said is None:
            continue
        try:
            visitor.take(said)
        except Exception:  # nobody else is to suffer from what one page says
            log.debug("a page said %s", said["say"], exc_info=True)


def _unsent_bytes(connection: ServerConnection) -> int:
    return connection.transport.get_write_buffer_size()


async def _watch(connection: ServerConnection, visitor: Visitor) -> None:
    """Ping a page, and drop it when it has stopped reading or more waits for it than may."""
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
        if now - since > STALL_SECONDS or visitor.own_bytes > MOST_OWN_BYTES:
            log.debug("a page that does not read was dropped")
            connection.transport.abort()
            return
        if pong is None and now - pinged > PING_SECONDS and unsent == 0:
            pong, pinged = asyncio.ensure_future(await connection.ping()), now


def _log_quietly(_: asyncio.AbstractEventLoop, context: dict[str, Any]) -> None:
    log.debug("%s", context.get("message"), exc_info=context.get("exception"))


def _response(
    status: http.HTTPStatus, body: bytes, *, host: str = "localhost", sources: dict[str, list[str]] | None = None
) -> Response:
    """An answer under the headers that every one has; HTML where there are `sources`, else a line of text."""
    headers = Headers(response_headers(host, sources))
    headers["Content-Type"] = f"text/{'plain' if sources is None else 'html'}; charset=utf-8"
    headers["Content-Length"] = str(len(body))
    headers["Connection"] = "close"
    return Response(status.value, status.phrase, headers, body)
