"""How operations reach pages: `Delivery`, and `Channel`, the way to all pages or to one."""

from __future__ import annotations

import contextlib
import itertools
import math
import threading
import time
from collections.abc import Callable, Iterable, Iterator

from .outbox import CREATE, DROP, Outbox, Shown
from .packing import Op

# Threads whose batches overlap without end would keep everything from the pages: they wait for so long at most [s].
LONGEST_BATCH = 1.0


class Delivery:
    """Takes operations from any thread, keeps what all pages see, and fills the outboxes of pages.

    Nothing here waits for a page: an operation is noted, and the thread of the server sends it.

    Attributes:
        lock: Held for moments: around what is shown and what waits.
        closed: Whether everything is passed over.
    """

    def __init__(self) -> None:
        self.lock = threading.RLock()
        self.closed = False
        self._numbers = itertools.count(1)
        self._shown = Shown()
        self._outboxes: dict[Channel, tuple[Outbox, Callable[[], None]]] = {}
        self._batch = 0  # What is sent while batches of several threads overlap is one batch.
        self._open = 0
        self._opened = 0.0

    def number(self) -> int:
        """A number that no other node or control has."""
        return next(self._numbers)

    @contextlib.contextmanager
    def atomic(self) -> Iterator[None]:
        """Have pages apply together what is done within; may be nested, and overlap with others."""
        with self.lock:
            if self._open == 0:
                self._batch += 1
                self._opened = time.monotonic()
            self._open += 1
        try:
            yield
        finally:  # what was done is done, whatever was raised then
            with self.lock:
                self._open -= 1
                for outbox, wake in self._outboxes.values():
                    if outbox and self._open == 0:
                        wake()

    def send(self, channel: Channel, op: Op, gone: Iterable[int] = ()) -> None:
        """Note an operation; of one that drops something, with the numbers of all that goes."""
        with self.lock:
            if self.closed or (channel.is_shared and self._shown.holds(op)):
                return
            if self._open == 0:
                self._batch += 1
            if channel.is_shared:
                self._shown.put(op, gone)
            for page in list(self._outboxes) if channel.is_shared else [channel]:
                if page is not channel.but and page in self._outboxes:
                    outbox, wake = self._outboxes[page]
                    outbox.put(op, self._batch, own=not channel.is_shared, gone=gone)
                    if self._open == 0:
                        wake()

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
                if self._open == 0:
                    self._batch += 1
                for op in batch:
                    outbox.put(op, self._batch, own=False)
            self._outboxes[channel] = (outbox, wake)
        return outbox

    def take(self, outbox: Outbox) -> tuple[list[Op], bool]:
        """What is to be sent to a page now, and whether more waits for threads that are in the midst of a batch."""
        with self.lock:
            is_whole = self._open == 0 or time.monotonic() - self._opened > LONGEST_BATCH
            ops = outbox.take(math.inf if is_whole else self._batch)
            return ops, bool(outbox)

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
            self.delivery.send(self, {"op": name, "id": number}, gone)
        return gone

    def send(self, op: Op) -> None:
        """Send another operation."""
        self.delivery.send(self, op)

    def send_but_to(self, page: Channel, op: Op) -> None:
        """Send an operation to all pages but one, which said it."""
        self.delivery.send(_AllBut(self, page), op)


class _AllBut(Channel):
    """All pages but one."""

    def __init__(self, channel: Channel, page: Channel):
        self.delivery, self.is_shared, self.but = channel.delivery, channel.is_shared, page
