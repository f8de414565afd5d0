"""A server for the viewer's page: on this machine alone unless asked, behind the guard, on a port that it says."""

from __future__ import annotations

import errno
import getpass
import os
import socket
from typing import TYPE_CHECKING, Any

from ...core.errors import PointloomError
from .guard import RequestGuard, is_loopback

if TYPE_CHECKING:
    from .link import PageServer

MOST_PORTS = 20  # that are tried, from the one asked for


class ViewerError(PointloomError, RuntimeError):
    """The viewer cannot listen where it was asked to."""


class ViewerExtraError(PointloomError, ImportError):
    """The viewer's extra is not installed."""


class ViewerServer:
    """A server for the viewer's page that is safe to leave open beside a browser.

    It answers only requests that name this machine and hold its token, and only the page that it served itself may
    connect (`guard.py`); what a page says is checked before anything acts on it (`link/wire.py`). Nothing is printed.

    Args:
        host: The address to listen on. 127.0.0.1 is reached from this machine alone; any other by whoever reaches the
            port, and what goes over is not encrypted. The page is for those alone who know the URL with its token.
        port: The port; where it is taken, the next free one of 20. 0 takes any.
        title: Of the page.

    Attributes:
        pages: The link to all pages that look.
        port: The port that it listens on.
        moved_from: The port asked for where that was taken, else None: to be said to the user.
        url: Where the page is, with the token without which it is not shown.
        ssh_line: What to run on one's own machine to reach it there, under the same URL.
        exposed: Whether others than this machine may reach it.

    Raises:
        ValueError: a port outside 0 to 65535.
        ViewerError: the address is not this machine's, or no port is free there.
        ImportError: the extra is not installed; with the line that installs it.

    Notes:
        Takes up to 32 pages at once, messages of theirs of up to 1 MiB, and drops one that does not read for a
        minute. Threads and port are given back by `close`, which the end of the process does as well.
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
                'the viewer needs the package websockets: pip install "pointloom[viewer]"'
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
        """The link to all pages that look; an error after `close`."""
        if self._pages is None:
            raise ViewerError("the viewer is closed: open another")
        return self._pages

    @property
    def closed(self) -> bool:
        """Whether `close` was called."""
        return self._pages is None

    def close(self) -> None:
        """Send the pages away and free port, threads and memory; twice is no error."""
        pages, self._pages = self._pages, None
        if pages is not None:
            pages.stop()

    def __enter__(self) -> ViewerServer:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()


def _bind(host: str, port: int) -> socket.socket:
    """A listening socket on the port, or on the next free one."""
    try:
        family, _, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE)[0]
        if host == "localhost":
            family, address = socket.AF_INET, ("127.0.0.1", port)
    except (OSError, UnicodeError) as error:
        raise ViewerError(f"host {host!r}: no such address ({error}). 127.0.0.1 is this machine") from error
    ports = range(port, min(port + MOST_PORTS, 65536)) if port else (0,)
    taken: OSError | None = None
    for one in ports:
        try:
            # 200 connections at once wait here rather than being turned away
            return socket.create_server((address[0], one), family=family, backlog=256)
        except OSError as error:
            if error.errno not in (errno.EADDRINUSE, errno.EACCES):
                raise ViewerError(f"host {host!r}: {error.strerror or error}. 127.0.0.1 is this machine") from error
            taken = error
    if taken is not None and taken.errno == errno.EACCES:
        raise ViewerError(f"port {port}: not allowed to this user. Ports from 1024 are") from taken
    raise ViewerError(f"ports {ports[0]} to {ports[-1]}: all taken. Choose another, or 0 for any") from taken


def _guard(host: str) -> RequestGuard:
    """For a server that others reach: under any address of it, and under its own names."""
    names = {host, socket.gethostname(), socket.getfqdn()}
    return RequestGuard(frozenset(name.lower().rstrip(".") for name in names), any_address=True)


def _shown_host(host: str, address: str) -> str:
    """The host to put into a browser on this machine."""
    shown = {"0.0.0.0": "127.0.0.1", "::": "[::1]"}.get(address, address if is_loopback(address) else host)
    return f"[{shown}]" if ":" in shown and not shown.startswith("[") else shown


def _ssh_line(address: str, port: int) -> str:
    """The line for the user's own machine; inside an SSH session with the server that it was opened to."""
    session = os.environ.get("SSH_CONNECTION", "").split()  # client, its port, server, its port
    server, server_port = (session[2], session[3]) if len(session) == 4 else (socket.gethostname(), "22")
    try:
        user = getpass.getuser()
    except (OSError, KeyError, ImportError):
        user = "user"
    shown = {"0.0.0.0": "127.0.0.1", "::": "[::1]"}.get(address, f"[{address}]" if ":" in address else address)
    option = "" if server_port == "22" else f"-p {server_port} "
    return f"ssh {option}-L {port}:{shown}:{port} {user}@{server}"
