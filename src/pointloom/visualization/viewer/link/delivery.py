"""Delivery of operations to pages: `Delivery`, and `Channel` to all pages or one.

A newer operation about the same object replaces or updates one that still waits in the `Outbox` of a page. So a slow
page never queues more than the scene itself.
"""

from __future__ import annotations

import contextlib
import itertools
import math
import threading
import time
from collections.abc import Callable, Iterable, Iterator

from .packing import Op, bytes_of

CREATE = {"node": "node", "control": "control"}
CHANGE = {"set": "node", "setcontrol": "control"}
DROP = {"drop": "node", "dropcontrol": "control", "dropcommand": "command"}
# Singletons: the newest counts. Kept ones are sent to new pages.
PERSISTENT = {"background", "clicks", "bounds", "progress", "hint", "title", "unit"}
NEWEST = PERSISTENT | {"sign", "end"}
MESSAGE_BYTES = 8 << 20  # target size of a message of several batches
MAX_NOTICES = 64  # waiting notices per page
# [s] Limit for overlapping batches of several threads, which would otherwise delay pages forever.
LONGEST_BATCH = 1.0

Key = tuple[str, int]
_events = itertools.count()


def key_of(op: Op) -> Key:
    name = op["op"]
    kind = CREATE.get(name) or CHANGE.get(name)
    if kind is not None or name in ("rows", "command"):
        return kind or name, op["id"]
    if name in NEWEST or name == "camera":
        return name, 0
    return name, op["id"] if name in DROP else next(_events)


def merge(op: Op, newer: Op) -> None:
    """Update a waiting operation by a later one with the same key."""
    if newer["op"] == "rows":
        _merge_rows(op, newer)
    else:
        op.update({name: value for name, value in newer.items() if name not in ("op", "id")})


def _merge_rows(rows: Op, newer: Op) -> None:
    """Merge changes of table rows; `put` is a mapping by row key here, `drop` one without values (ordered set)."""
    for key in newer["drop"]:
        rows["put"].pop(key, None)
        rows["drop"][key] = None
    for key, row in newer["put"].items():
        rows["drop"].pop(key, None)
        rows["put"][key] = row


def copied(op: Op) -> Op:
    """A copy that can be updated. Arrays are shared."""
    return {**op, "put": dict(op["put"]), "drop": dict(op["drop"])} if op["op"] == "rows" else dict(op)


def as_sent(op: Op) -> Op:
    if op["op"] != "rows":
        return op
    return {**op, "put": [[key, *row] for key, row in op["put"].items()], "drop": list(op["drop"])}


class Outbox:
    """Operations that wait for one page, in order; protected by the lock of the `Delivery`."""

    def __init__(self) -> None:
        self.own_bytes = 0
        self._waiting: dict[Key, tuple[Op, int, int]] = {}  # with batch number and own bytes
        # Range of batches to send in one message, because the last one updated an operation of the first.
        self._joined = (0, -1)
        self._notices: list[Key] = []

    def __bool__(self) -> bool:
        return bool(self._waiting)

    def put(self, op: Op, batch: int, *, own: bool, gone: Iterable[int] = ()) -> None:
        """Add a copy of an operation of a batch (ascending numbers).

        `own`: for this page only. `gone`: all objects that a drop operation removes.
        """
        if op["op"] in DROP and not self._drop(op, gone):
            return
        key = key_of(op)
        if key[0] in NEWEST:
            self._forget(key)
        if (entry := self._waiting.get(key)) is not None:
            waiting, first, before = entry
            merge(waiting, op)
            after = bytes_of(waiting) if before else 0
            self.own_bytes += after - before
            self._waiting[key] = (waiting, first, after)
            if first != batch:
                start, end = self._joined
                self._joined = (min(start, first) if end >= first else first, batch)
            return
        size = bytes_of(op) if own else 0
        self.own_bytes += size
        self._waiting[key] = (copied(op), batch, size)
        if key[0] == "notify":
            self._notices.append(key)
            if len(self._notices) > MAX_NOTICES:
                self._forget(self._notices.pop(0))

    def take(self, before: float = math.inf) -> list[Op]:
        """Remove the oldest complete batches before batch `before`, as many as make one message."""
        taken: list[Op] = []
        size, last = 0, -1
        first, end = self._joined
        limit = min(before, first) if before <= end else before
        for key, (op, batch, own) in list(self._waiting.items()):
            if batch >= limit:
                break
            if taken and batch != last and size >= MESSAGE_BYTES and not first <= last < batch <= end:
                break
            taken.append(as_sent(op))
            size, last = size + bytes_of(op), batch
            self.own_bytes -= own
            del self._waiting[key]
        self._notices = [key for key in self._notices if key in self._waiting]
        return taken

    def _drop(self, op: Op, gone: Iterable[int]) -> bool:
        """Remove waiting operations of dropped objects. True if the page has any of them."""
        kind = DROP[op["op"]]
        waiting = self._waiting.get((kind, op["id"]))
        for number in gone:
            self._forget((kind, number))
            self._forget(("rows", number))
        return waiting is None or waiting[0]["op"] not in (*CREATE, "command")

    def _forget(self, key: Key) -> None:
        entry = self._waiting.pop(key, None)
        if entry is not None:
            self.own_bytes -= entry[2]


class Shown:
    """State of all pages as operations for new pages; protected by the lock of the `Delivery`."""

    def __init__(self) -> None:
        self._ops: dict[Key, Op] = {}

    def contains(self, op: Op) -> bool:
        """True if a singleton operation is equal to the last one."""
        return op["op"] in PERSISTENT and self._ops.get(key_of(op)) == op

    def put(self, op: Op, gone: Iterable[int]) -> None:
        """Record a shared operation. Transient ones are ignored."""
        name = op["op"]
        if name in DROP:
            for number in gone:
                self._ops.pop((DROP[name], number), None)
                self._ops.pop(("rows", number), None)
            return
        key = key_of(op)
        if key in self._ops:
            merge(self._ops[key], op)
        elif name in CREATE or name in PERSISTENT or name in ("rows", "command", "camera"):
            self._ops[key] = copied(op)

    def batches(self) -> list[list[Op]]:
        """The complete state, parents first, in batches of moderate size."""
        batches: list[list[Op]] = [[{"op": "clear"}]]
        size = 0
        for op in self._ops.values():
            if size > MESSAGE_BYTES:
                batches.append([])
                size = 0
            batches[-1].append(op)
            size += bytes_of(op)
        return batches


class Delivery:
    """Takes operations from any thread, records the shared state and fills the outboxes of pages.

    No call waits for a page. The server's thread sends. `lock` protects state and outboxes, each time briefly.
    """

    def __init__(self) -> None:
        self.lock = threading.RLock()
        self.closed = False
        self._numbers = itertools.count(1)
        self._shown = Shown()
        self._outboxes: dict[Channel, tuple[Outbox, Callable[[], None]]] = {}
        self._batch = 0  # overlapping batches of several threads share one number
        self._open = 0
        self._opened = 0.0

    def number(self) -> int:
        return next(self._numbers)

    @contextlib.contextmanager
    def atomic(self) -> Iterator[None]:
        """Batch operations, so that pages apply them together. Batches may be nested and overlap between threads."""
        with self.lock:
            if self._open == 0:
                self._batch += 1
                self._opened = time.monotonic()
            self._open += 1
        try:
            yield
        finally:  # completed changes are sent even after an exception
            with self.lock:
                self._open -= 1
                for outbox, wake in self._outboxes.values():
                    if outbox and self._open == 0:
                        wake()

    def send(self, channel: Channel, op: Op, gone: Iterable[int] = ()) -> None:
        """Queue an operation; `gone` are all objects that a drop operation removes."""
        with self.lock:
            if self.closed or (channel.is_shared and self._shown.contains(op)):
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
        """Record an operation for future pages only."""
        with self.lock:
            self._shown.put(op, ())

    def join(self, channel: Channel, wake: Callable[[], None]) -> Outbox:
        """Outbox of a new page with the shared state; `wake` is called from any thread when something waits."""
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
        """Operations to send to a page now, and whether more wait for open batches."""
        with self.lock:
            is_complete = self._open == 0 or time.monotonic() - self._opened > LONGEST_BATCH
            ops = outbox.take(math.inf if is_complete else self._batch)
            return ops, bool(outbox)

    def leave(self, channel: Channel) -> None:
        with self.lock:
            self._outboxes.pop(channel, None)

    def close(self) -> None:
        """Free everything and ignore later operations."""
        with self.lock:
            self.closed = True
            self._shown = Shown()
            self._outboxes = {}


class Channel:
    """Sends operations to all pages (current and future), or to one."""

    but: Channel | None = None

    def __init__(self, delivery: Delivery, *, is_shared: bool):
        self.delivery, self.is_shared = delivery, is_shared
        self._children: dict[int, dict[int, None]] = {}
        self._parents: dict[int, int] = {}

    def create(self, op: Op) -> None:
        assert op["op"] in CREATE
        with self.delivery.lock:
            self._children.setdefault(op["parent"], {})[op["id"]] = None
            self._parents[op["id"]] = op["parent"]
            self.send(op)

    def drop(self, name: str, number: int) -> list[int]:
        """Send the removal of an object. Returns the numbers of all removed objects, itself first."""
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
        self.delivery.send(self, op)

    def send_but_to(self, page: Channel, op: Op) -> None:
        """Send an operation to all pages except the one it came from."""
        self.delivery.send(_AllBut(self, page), op)


class _AllBut(Channel):
    def __init__(self, channel: Channel, page: Channel):
        self.delivery, self.is_shared, self.but = channel.delivery, channel.is_shared, page
