"""Connections that are not pages yet: their number and time are limited, so that none can take all file descriptors."""

from __future__ import annotations

import asyncio
from typing import Any

from websockets.asyncio.server import ServerConnection

try:
    import resource
except ImportError:  # Windows
    resource = None

# Connections without the token. Browsers open a few in advance, and 200 pages may be opened at once.
MAX_STRANGERS = 256
STRANGER_FRACTION = 4  # at most the fourth part of the descriptors that the process may open
STRANGER_SECONDS = 10.0  # limit for the first request, which browsers send at once
MAX_LOADING = 64  # requests for the page, with the token


class WaitingConnections:
    """The connections of a server before they become pages. The oldest ones are closed if there are too many."""

    def __init__(self) -> None:
        self._strangers: dict[ServerConnection, asyncio.TimerHandle] = {}
        self._loading: dict[ServerConnection, None] = {}

    def __len__(self) -> int:
        return len(self._strangers) + len(self._loading)

    def add(self, connection: ServerConnection) -> None:
        """A new connection. It is closed after `STRANGER_SECONDS` if it has not sent the token."""
        limit = _max_strangers()
        while len(self._strangers) >= limit:
            self._end(next(iter(self._strangers)))
        loop = asyncio.get_running_loop()
        self._strangers[connection] = loop.call_later(STRANGER_SECONDS, self._end, connection)

    def admit(self, connection: ServerConnection) -> None:
        """A connection that has sent the token."""
        self.remove(connection)
        while len(self._loading) >= MAX_LOADING:
            self._end(next(iter(self._loading)))
        self._loading[connection] = None

    def remove(self, connection: ServerConnection) -> None:
        """A connection that has ended, or has become a page."""
        self._loading.pop(connection, None)
        if (timer := self._strangers.pop(connection, None)) is not None:
            timer.cancel()

    def _end(self, connection: ServerConnection) -> None:
        self.remove(connection)
        connection.transport.abort()


def _max_strangers() -> int:
    if resource is None:
        return MAX_STRANGERS
    soft, _ = resource.getrlimit(resource.RLIMIT_NOFILE)
    return MAX_STRANGERS if soft < 0 else max(1, min(MAX_STRANGERS, soft // STRANGER_FRACTION))


class WatchedConnection(ServerConnection):
    """A connection that is counted until it becomes a page or ends."""

    def __init__(self, waiting: WaitingConnections, *arguments: Any, **options: Any):
        super().__init__(*arguments, **options)
        self._waiting = waiting

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        super().connection_made(transport)
        self._waiting.add(self)

    def connection_lost(self, exc: Exception | None) -> None:
        self._waiting.remove(self)
        super().connection_lost(exc)
