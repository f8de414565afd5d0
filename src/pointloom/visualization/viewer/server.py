"""Server of the viewer: local unless requested otherwise, guarded, on a free port."""

from __future__ import annotations

import errno
import getpass
import math
import os
import socket
from typing import TYPE_CHECKING, Any

from ...core.errors import PointloomError
from .guard import RequestGuard, is_loopback

if TYPE_CHECKING:
    from .link import PageServer

MAX_PORTS = 20  # number of ports that are tried


class ViewerError(PointloomError, RuntimeError):
    """Raised if the viewer cannot listen on the address."""


class ViewerExtraError(PointloomError, ImportError):
    """Raised if the package websockets is not installed."""


class ViewerServer:
    """A web server for the viewer that is safe to keep open beside a browser.

    It answers only requests that name this machine and contain its token. Only its own page may connect (`guard.py`),
    and messages are validated (`link/wire.py`). A `host` beyond 127.0.0.1 is reachable from the network, unencrypted,
    for everyone with the URL. The port is the next free one of 20. 0 takes any. Accepts up to 32 pages and messages of
    up to 1 MiB, and closes a page that does not read for a minute. At most 256 connections without the token are open,
    for 10 s each, so that they cannot take all file descriptors. Raises ValueError, ViewerError or ImportError.

    Attributes:
        pages: Connection to all pages.
        moved_from: Requested port if it was in use, else None.
        url: Address of the page with the token.
        ssh_line: Command for the local machine to reach the page under the same URL.
        exposed: True if other machines can reach it.
    """

    def __init__(self, host: str = "127.0.0.1", port: int = 8080, *, title: str = "pointloom"):
        if isinstance(port, bool) or not isinstance(port, int) or not 0 <= port <= 65535:
            raise ValueError(f"port: expected a whole number from 0 to 65535, got {port!r}")
        if not isinstance(host, str) or not host:
            raise ValueError(f"host: expected an address such as 127.0.0.1, got {host!r}")
        try:
            from .link.hub import Hub  # noqa: F401  it alone imports websockets
        except ImportError as error:
            if (error.name or "").split(".")[0] == "pointloom":
                raise
            raise ViewerExtraError(
                "the viewer needs the package websockets, which is not installed: pip install websockets"
            ) from error
        from .link import PageServer

        bound = _bind(host, port)
        self._pages: PageServer | None = None
        self.host, self.port = host, int(bound.getsockname()[1])
        self.moved_from = port if port not in (0, self.port) else None
        address = bound.getsockname()[0]
        self.exposed = not is_loopback(address)
        try:
            self._pages = PageServer(bound, _guard(host) if self.exposed else RequestGuard(), title)
        except BaseException:
            bound.close()
            raise
        self.url = f"http://{_shown_host(host, address)}:{self.port}/?token={self._pages.token}"
        self.ssh_line = _ssh_line(address, self.port)

    @property
    def pages(self) -> PageServer:
        """Connection to all pages. Raises an error after `close`."""
        if self._pages is None:
            raise ViewerError("the viewer is closed: open another")
        return self._pages

    @property
    def last_request(self) -> float:
        """Time of the last request for the page (`time.monotonic`); minus infinity when closed."""
        return -math.inf if self._pages is None else self._pages.last_request

    @property
    def closed(self) -> bool:
        """True after `close`, or in a forked child."""
        return self._pages is None or self._pages.is_child

    def close(self) -> None:
        """Disconnect the pages and free port, threads and memory. A second call has no effect."""
        pages, self._pages = self._pages, None
        if pages is not None:
            pages.stop()

    def __enter__(self) -> ViewerServer:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()


def _bind(host: str, port: int) -> socket.socket:
    try:
        family, _, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)[0]
        if host == "localhost":
            family, address = socket.AF_INET, ("127.0.0.1", port)
    except (OSError, UnicodeError) as error:
        raise ViewerError(f"host {host!r}: no such address ({error}). 127.0.0.1 is this machine") from error
    ports = range(port, min(port + MAX_PORTS, 65536)) if port else (0,)
    taken: OSError | None = None
    for one in ports:
        try:
            # queues 200 simultaneous connections instead of refusing them
            return socket.create_server((address[0], one), family=family, backlog=256)
        except OSError as error:
            if error.errno not in (errno.EADDRINUSE, errno.EACCES):
                raise ViewerError(f"host {host!r}: {error.strerror or error}. 127.0.0.1 is this machine") from error
            taken = error
    if taken is not None and taken.errno == errno.EACCES:
        raise ViewerError(f"port {port}: this user is not allowed to open it. Choose one from 1024 on") from taken
    raise ViewerError(f"ports {ports[0]} to {ports[-1]}: all in use. Choose another, or 0 for any") from taken


def _guard(host: str) -> RequestGuard:
    """Guard for a server reachable by others: under any of its addresses and its own names."""
    names = {host, socket.gethostname(), socket.getfqdn()}
    return RequestGuard(frozenset(name.lower().rstrip(".") for name in names), any_address=True)


def _shown_host(host: str, address: str) -> str:
    shown = {"0.0.0.0": "127.0.0.1", "::": "[::1]"}.get(address, address if is_loopback(address) else host)
    return f"[{shown}]" if ":" in shown and not shown.startswith("[") else shown


def _ssh_line(address: str, port: int) -> str:
    """Command for the local machine; inside an SSH session with the server it connected to."""
    session = os.environ.get("SSH_CONNECTION", "").split()  # client, its port, server, its port
    server, server_port = (session[2], session[3]) if len(session) == 4 else (socket.gethostname(), "22")
    try:
        user = getpass.getuser()
    except (OSError, KeyError, ImportError):
        user = "user"
    shown = {"0.0.0.0": "127.0.0.1", "::": "[::1]"}.get(address, f"[{address}]" if ":" in address else address)
    option = "" if server_port == "22" else f"-p {server_port} "
    return f"ssh {option}-L {port}:{shown}:{port} {user}@{server}"
