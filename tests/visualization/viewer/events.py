"""Events of the viewers in this process. A test waits for a condition; it is evaluated again after each event."""

import functools
import logging
import threading
import time
import weakref
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from pointloom.visualization.viewer.callback_queue import Calls
from pointloom.visualization.viewer.deferred_update import DeferredUpdate
from pointloom.visualization.viewer.level_builder import LevelBuilder
from pointloom.visualization.viewer.link.client import PageClient, Worker
from pointloom.visualization.viewer.link.delivery import Delivery
from pointloom.visualization.viewer.link.hub import Hub
from pointloom.visualization.viewer.sessions import Session
from pointloom.visualization.viewer.streaming import CloudStream
from pointloom.visualization.viewer.tools.toolbox import Toolbox

# State may have changed after each call of these.
SOURCES: tuple[tuple[type, tuple[str, ...]], ...] = (
    (Delivery, ("send", "join", "leave", "take")),
    (PageClient, ("take",)),
    (Worker, ("_call", "_work")),
    (DeferredUpdate, ("now", "_run")),
    (Calls, ("_do", "_run")),
    (Toolbox, ("_do",)),
    (Session, ("_feed", "_pause", "close")),
    (CloudStream, ("_update_request", "close")),
    (LevelBuilder, ("_build",)),
)
TIMEOUT = 60.0  # [s]; reached only by failing tests


class Events:
    """Counts events.

    Attributes:
        at_rest_running: Number of sessions that react to a camera at rest at this moment.
        heard: Clients of which a message was taken.
    """

    def __init__(self) -> None:
        self.count = 0
        self.at_rest_running = 0
        self.heard: weakref.WeakSet[PageClient] = weakref.WeakSet()
        self._condition = threading.Condition()

    def happened(self, at_rest: int = 0) -> None:
        """Wake all waiting tests; so many more sessions react to a camera at rest."""
        with self._condition:
            self.count += 1
            self.at_rest_running += at_rest
            self._condition.notify_all()

    def wait(self, count: int, seconds: float) -> bool:
        """Wait until there are more events than `count`; False after the time limit."""
        with self._condition:
            return self._condition.wait_for(lambda: self.count > count, seconds)


events = Events()


def wait_until(claim: Callable[[], object], seconds: float = TIMEOUT) -> None:
    """Wait until the condition holds, evaluated now and after each event."""
    end = time.monotonic() + seconds
    while True:
        count = events.count
        if claim():
            return
        if not events.wait(count, end - time.monotonic()):
            raise AssertionError("it came without an event" if claim() else "it never came")


def join_threads(running: Callable[[threading.Thread], bool]) -> None:
    """Wait until the threads for which `running` is true have ended."""
    for thread in filter(running, threading.enumerate()):
        thread.join(TIMEOUT)
        assert not thread.is_alive(), f"{thread.name} still runs"


def announce(patch: pytest.MonkeyPatch, owner: Any, name: str) -> None:
    """Have each call of a function announce an event when it ends."""
    function = getattr(owner, name)

    @functools.wraps(function)
    def announced(*args: Any, **kwargs: Any) -> Any:
        try:
            return function(*args, **kwargs)
        finally:
            events.happened()

    patch.setattr(owner, name, announced)


class _LogEvents(logging.Handler):
    def emit(self, record: logging.LogRecord) -> None:
        events.happened()


@pytest.fixture(scope="session", autouse=True)
def announced_events() -> Iterator[None]:
    """Have all sources announce their events."""
    log, handler = logging.getLogger("pointloom.viewer"), _LogEvents()
    rests, attend, take = Session._check_if_idle, Hub._attend, PageClient.take

    def count_rests(session: Session) -> None:
        events.happened(at_rest=1)
        try:
            rests(session)
        finally:
            events.happened(at_rest=-1)

    async def announce_end(hub: Hub, connection: Any) -> None:
        try:
            await attend(hub, connection)
        finally:
            events.happened()

    def note_client(client: PageClient, message: dict[str, Any]) -> None:
        take(client, message)
        events.heard.add(client)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Session, "_check_if_idle", count_rests)
        patch.setattr(Hub, "_attend", announce_end)
        patch.setattr(PageClient, "take", note_client)
        for owner, names in SOURCES:
            for name in names:
                announce(patch, owner, name)
        log.addHandler(handler)
        yield
        log.removeHandler(handler)
