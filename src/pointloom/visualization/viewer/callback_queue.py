"""Queue of the program's callbacks in one thread: `Calls`."""

from __future__ import annotations

import contextlib
import dataclasses
import logging
import threading
import time
from collections.abc import Callable, Hashable, Mapping
from typing import Any

from ...core.errors import PointloomError
from .server import ViewerServer

MAX_WAITING = 64  # waiting calls
SIGNAL_TIMEOUT = 3.0  # [s] after which a page without a signal counts as ready
POLL_INTERVAL = 0.25  # [s] between checks for open pages
PATIENT_JOIN = 5.0  # [s] that `close` waits for a running callback
log = logging.getLogger("pointloom.viewer")


class HookPages:
    """Pages for messages and draw signals. None after the viewer was closed."""

    def __init__(self, server: ViewerServer, sessions: Mapping[int, Any]):
        self._server, self._sessions = server, sessions
        self._answer: Callable[[], None] = lambda: None
        self._subscribed: frozenset[int] = frozenset()  # pages with a signal callback

    def show_error(self, client: int | None, text: str) -> None:
        """Show an error in a page, or in all if the page is unknown."""
        with contextlib.suppress(PointloomError):  # the viewer was closed meanwhile
            clients = self._server.pages.get_clients()
            for number in clients if client is None else {client} & {*clients}:
                clients[number].notify("pointloom", text, error=True)

    def are_open(self) -> bool:
        return bool(self._sessions)

    def request_signals(self, answer: Callable[[], None]) -> None:
        """Request a signal from each page after it has drawn everything sent before."""
        self._answer = answer
        with contextlib.suppress(PointloomError):  # the viewer was closed meanwhile
            clients = self._server.pages.get_clients()
            for client in [client for number, client in clients.items() if number not in self._subscribed]:
                client.on_sign(lambda _: self._answer())
            self._subscribed = frozenset(clients)
            for client in clients.values():
                client.request_signal()


@dataclasses.dataclass(eq=False)
class Beat:
    """A periodic callback of the seconds since its last call, with minimum interval and time of the next call [s]."""

    function: Callable[[float], Any]
    period: float
    due: float
    last: float | None = None


class Calls:
    """Runs callbacks of the program in order in one thread, started by the first call.

    Exceptions are shown in the page that caused the call and logged. Of replaceable calls (a dragged slider), only the
    newest waits.
    """

    def __init__(self, pages: HookPages):
        self._pages = pages
        self._condition = threading.Condition()
        self._jobs: dict[Any, tuple[int | None, Callable[[], Any]]] = {}
        self._beats: list[Beat] = []
        self._closed = False
        self._requested: float | None = None  # time of an unanswered request for signals
        self._thread: threading.Thread | None = None

    def call(self, client: int | None, job: Callable[[], Any], key: Hashable = None) -> None:
        """Queue a function for a page. A waiting call of the same `key` is replaced."""
        with self._condition:
            key = object() if key is None else key
            is_room = key in self._jobs or len(self._jobs) < MAX_WAITING
            if is_room and not self._closed:
                self._jobs[key] = client, job
                self._begin()
        if not is_room:
            self._pages.show_error(client, "The program is busy: this request was skipped.")

    def every(self, period: float, function: Callable[[float], Any]) -> Callable[[], None]:
        """Call a function periodically while a page is open. Returns a function that ends it."""
        beat = Beat(function, period, time.monotonic())
        with self._condition:
            self._beats.append(beat)
            self._begin()
        return lambda: self._stop(beat)

    def close(self) -> None:
        with self._condition:
            self._closed = True
            self._jobs.clear()
            self._beats.clear()
            self._condition.notify_all()

    def join(self) -> None:
        """Wait at most 5 s for a running callback, except from within it."""
        if self._thread is not None and self._thread is not threading.current_thread():
            self._thread.join(PATIENT_JOIN)

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
                self._request_signals()

    def _do(self, client: int | None, job: Callable[[], Any]) -> bool:
        try:
            job()
        except BaseException as error:  # SystemExit would silently end the thread, too
            log.error("a callback of the program failed", exc_info=True)
            self._pages.show_error(client, f"{type(error).__name__}: {error}")
            return False
        return True

    def _due(self) -> list[Beat]:
        if not self._beats:
            return []
        if not self._pages.are_open():
            self._requested = None
            for beat in self._beats:
                beat.last = None
            return []
        now = time.monotonic()
        if self._requested is not None and now - self._requested < SIGNAL_TIMEOUT:
            return []
        return [beat for beat in self._beats if beat.due <= now]

    def _pause(self) -> float | None:
        """Time until the next periodic call [s]. None without one."""
        if not self._beats:
            return None
        if self._requested is not None or not self._pages.are_open():
            return POLL_INTERVAL
        return max(min(beat.due for beat in self._beats) - time.monotonic(), 1e-3)

    def _call_beat(self, beat: Beat) -> None:
        now = time.monotonic()
        passed = 0.0 if beat.last is None else now - beat.last
        beat.last, beat.due = now, max(beat.due + beat.period, now + beat.period / 2)
        if not self._do(None, lambda: beat.function(passed)):
            self._stop(beat)
            self._pages.show_error(None, "The periodic callback failed and was stopped.")

    def _request_signals(self) -> None:
        with self._condition:
            self._requested = requested = time.monotonic()

        def answer() -> None:
            with self._condition:
                if self._requested == requested:
                    self._requested = None
                    self._condition.notify_all()

        self._pages.request_signals(answer)
