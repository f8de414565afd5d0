"""Calls of a program's functions, one after the other, in one thread that is not the program's: `Calls`."""

from __future__ import annotations

import contextlib
import dataclasses
import logging
import threading
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ...core.errors import PointloomError

if TYPE_CHECKING:
    from .viewer import Viewer


MOST_WAITING = 64  # calls ahead of those that are done
PATIENCE = 3.0  # [s] after which pages that give no sign count as having taken the last frame
POLL = 0.25  # [s] between two looks whether a page is open
PATIENT_JOIN = 5.0  # [s] that `close` waits for a function that is at work
log = logging.getLogger("pointloom.viewer")


class HookPages:
    """Where words are shown, and what tells that a page has drawn; a viewer that was closed has no pages.

    Args:
        viewer: The viewer.
    """

    def __init__(self, viewer: Viewer):
        self._viewer = viewer
        self._answer: Callable[[], None] = lambda: None
        self._asked: frozenset[int] = frozenset()  # pages that are listened to

    def tell(self, client: int | None, text: str) -> None:
        """Show what went wrong in a page, or in all of them where none asked."""
        with contextlib.suppress(PointloomError):  # the viewer was closed meanwhile
            clients = self._viewer.server.pages.get_clients()
            for number in clients if client is None else {client} & {*clients}:
                clients[number].notify("pointloom", text, error=True)

    def are_open(self) -> bool:
        """Whether a page is open."""
        return bool(self._viewer.sessions)

    def ask_for_signs(self, answer: Callable[[], None]) -> None:
        """Have each page call back when it has drawn what it was sent."""
        self._answer = answer
        with contextlib.suppress(PointloomError):  # the viewer was closed meanwhile
            clients = self._viewer.server.pages.get_clients()
            for client in [client for number, client in clients.items() if number not in self._asked]:
                client.on_sign(lambda _: self._answer())
            self._asked = frozenset(clients)
            for client in clients.values():
                client.ask_for_sign()


@dataclasses.dataclass(eq=False)
class Beat:
    """A function that is called again and again.

    Attributes:
        function: Is given the seconds since it was called last.
        period: Between two calls at the least [s].
        due: When the next one may be, on the monotonic clock [s].
        last: When it was called last [s]; None before the first time, and where no page was open since.
    """

    function: Callable[[float], Any]
    period: float
    due: float
    last: float | None = None


class Calls:
    """The functions of a program that its pages call; the thread begins with the first.

    What a function raises is shown in the page that asked for it and goes to the log; the next one is called all the
    same. Of calls that may replace each other (a slider that is dragged) only the newest waits.

    Args:
        pages: The pages.
    """

    def __init__(self, pages: HookPages):
        self._pages = pages
        self._condition = threading.Condition()
        self._jobs: dict[Any, tuple[int | None, Callable[[], Any]]] = {}
        self._beats: list[Beat] = []
        self._closed = False
        self._asked: float | None = None  # when pages were asked for a sign that has not come
        self._thread: threading.Thread | None = None

    def call(self, client: int | None, job: Callable[[], Any], key: Any = None) -> None:
        """Call a function in its turn.

        Args:
            client: The page that asks for it.
            job: The function.
            key: Where a call of this key waits already, this one takes its place.
        """
        with self._condition:
            key = object() if key is None else key
            is_room = key in self._jobs or len(self._jobs) < MOST_WAITING
            if is_room and not self._closed:
                self._jobs[key] = client, job
                self._begin()
        if not is_room:
            self._pages.tell(client, "The program is busy: this was passed over.")

    def every(self, period: float, function: Callable[[float], Any]) -> Callable[[], None]:
        """Call a function again and again while a page is open; what is returned ends that."""
        beat = Beat(function, period, time.monotonic())
        with self._condition:
            self._beats.append(beat)
            self._begin()
        return lambda: self._stop(beat)

    def close(self) -> None:
        """Call nothing any more."""
        with self._condition:
            self._closed = True
            self._jobs.clear()
            self._beats.clear()
            self._condition.notify_all()

    def join(self) -> None:
        """Wait for a function that is at work, five seconds at most; not for the one that calls this."""
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join(PATIENT_JOIN)

    # -- within -------------------------------------------------------------------------------------------------------

    def _begin(self) -> None:
        if self._thread is None and not self._closed:
            self._thread = threading.Thread(target=self._run, name="pointloom-hooks", daemon=True)
            self._thread.start()
        self._condition.notify_all()

    def _stop(self, beat: Beat) -> None:
        with self._condition:
            if beat in self._beats:
                self._beats.remove(beat)

    def _run(self) -> None:
        while True:
            with self._condition:
                if self._closed:
                    return
                job = self._jobs.pop(next(iter(self._jobs))) if self._jobs else None
                beats = [] if job is not None else self._due()
                if job is None and not beats:
                    self._condition.wait(self._pause())
                    continue
            if job is not None:
                self._do(*job)
            for beat in beats:
                self._call_beat(beat)
            if beats:
                self._ask_for_signs()

    def _do(self, client: int | None, job: Callable[[], Any]) -> bool:
        """Whether it came to its end."""
        try:
            job()
        except BaseException as error:  # SystemExit too would end the thread without a word
            log.error("a function of the program that a page called", exc_info=True)
            self._pages.tell(client, f"{type(error).__name__}: {error}")
            return False
        return True

    # -- again and again ----------------------------------------------------------------------------------------------

    def _due(self) -> list[Beat]:
        """What is to be called now."""
        if not self._beats:
            return []
        if not self._pages.are_open():
            self._asked = None
            for beat in self._beats:
                beat.last = None
            return []
        now = time.monotonic()
        if self._asked is not None and now - self._asked < PATIENCE:
            return []
        return [beat for beat in self._beats if beat.due <= now]

    def _pause(self) -> float | None:
        """How long nothing is to be done [s]; None until something comes."""
        if not self._beats:
            return None
        if self._asked is not None or not self._pages.are_open():
            return POLL
        return max(min(beat.due for beat in self._beats) - time.monotonic(), 1e-3)

    def _call_beat(self, beat: Beat) -> None:
        now = time.monotonic()
        passed = 0.0 if beat.last is None else now - beat.last
        beat.last, beat.due = now, max(beat.due + beat.period, now + beat.period / 2)
        if not self._do(None, lambda: beat.function(passed)):
            self._stop(beat)
            self._pages.tell(None, "This was called with each frame; it is called no more.")

    def _ask_for_signs(self) -> None:
        with self._condition:
            self._asked = asked = time.monotonic()

        def answer() -> None:
            with self._condition:
                if self._asked == asked:
                    self._asked = None
                    self._condition.notify_all()

        self._pages.ask_for_signs(answer)
