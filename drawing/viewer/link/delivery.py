"""How operations reach pages: `Delivery`, and `Channel`, the way to all pages or to one."""

from __future__ import annotations

import contextlib
import itertools
import threading
from collections.abc import Callable, Iterator
from typing import Any

from .outbox import CREATE, DROP, Outbox, Shown
from .packing import Op

_Entry = tuple["Channel", Op, tuple[int, ...]]


class Delivery:
    """Takes operations from any thread, keeps what all pages see, and fills the outboxes of pages.

    Nothing here waits for a page: an operation is noted, and the thread of the server sends it.

    Attributes:
        lock: Held for moments: around what is shown and what waits.
    """

    def __init__(self) -> None:
        self.lock = threading.RLock()
        self.closed = False
        self._numbers = itertools.count(1)
        self._shown = Shown()
        self._outboxes: dict[Channel, tuple[Outbox, Callable[[], None]]] = {}
        self._batch = threading.local()

    def number(self) -> int:
        """A number that no other node or control has."""
        return next(self._numbers)

    @contextlib.contextmanager
    def atomic(self) -> Iterator[None]:
        """Have pages apply together what this thread does within; may be nested."""
        if getattr(self._batch, "entries", None) is not None:
            yield
            return
        entries: list[_Entry] = []
        self._batch.entries = entries
        try:
            yield
        finally:  # what was done is done, whatever was raised then
            self._batch.entries = None
            self._deliver(entries)

    def send(self, entry: _Entry) -> None:
        """Note an operation, for now or for the end of this thread's batch."""
        entries = getattr(self._batch, "entries", None)
        if entries is None:
            self._deliver([entry])
        else:
            entries.append(entry)

    def keep(self, op: Op) -> None:
        """Note an operation for pages that come later alone."""
        with self.lock:
            self._shown.put(op, ())

    def join(self, channel: Channel, wake: Callable[[], None]) -> Outbox:
        """A page that comes: its outbox, filled with what all pages see.

        Args:
            channel: The way to it.
            wake: Called, from any thread, whenever something waits for it.
        """
        outbox = Outbox()
        with self.lock:
            for batch in self._shown.batches():
                outbox.put((op, False, ()) for op in batch)
            self._outboxes[channel] = (outbox, wake)
        return outbox

    def leave(self, channel: Channel) -> None:
        """A page has gone."""
        with self.lock:
            self._outboxes.pop(channel, None)

    def close(self) -> None:
        """Let go of everything; what comes later is passed over."""
        with self.lock:
            self.closed = True
            self._shown = Shown()
            self._outboxes = {}

    def _deliver(self, entries: list[_Entry]) -> None:
        with self.lock:
            if self.closed or not entries:
                return
            for channel, op, gone in entries:
                if channel.is_shared:
                    self._shown.put(op, gone)
            for page, (outbox, wake) in self._outboxes.items():
                mine = [
                    (op, not channel.is_shared, gone)
                    for channel, op, gone in entries
                    if (channel.is_shared and channel.but is not page) or channel is page
                ]
                if mine:
                    outbox.put(mine)
                    wake()


class Channel:
    """The way to all pages, or to one.

    Args:
        delivery: What it goes by.
        is_shared: Whether to all pages, those that come later as well.
    """

    but: Channel | None = None

    def __init__(self, delivery: Delivery, *, is_shared: bool):
        self.delivery, self.is_shared = delivery, is_shared
        self._children: dict[int, dict[int, None]] = {}
        self._parents: dict[int, int] = {}

    def create(self, op: Op) -> None:
        """Send an operation that makes a node or a control."""
        assert op["op"] in CREATE
        with self.delivery.lock:
            self._children.setdefault(op["parent"], {})[op["id"]] = None
            self._parents[op["id"]] = op["parent"]
            self.send(op)

    def drop(self, name: str, number: int) -> list[int]:
        """Send that something goes; the numbers of all that goes with it, itself first."""
        assert name in DROP
        with self.delivery.lock:
            gone = [number]
            for one in gone:
                gone += self._children.pop(one, {})
            self._children.get(self._parents.pop(number, -1), {}).pop(number, None)
            for one in gone[1:]:
                self._parents.pop(one, None)
            self.delivery.send((self, {"op": name, "id": number}, tuple(gone)))
        return gone

    def send(self, op: Op) -> None:
        """Send another operation."""
        self.delivery.send((self, op, ()))

    def send_but_to(self, page: Channel, op: Op) -> None:
        """Send an operation to all pages but one, which said it."""
        other: Any = _AllBut(self, page)
        self.delivery.send((other, op, ()))


class _AllBut(Channel):
    """All pages but one."""

    def __init__(self, channel: Channel, page: Channel):
        self.delivery, self.is_shared, self.but = channel.delivery, channel.is_shared, page
