"""One update of the pages for several changes of a scene: `DeferredUpdate`."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable

log = logging.getLogger("pointloom.viewer")

MIN_INTERVAL = 1 / 30  # [s] minimum time between two runs
IDLE_TIMEOUT = 0.5  # [s] without a request after which the thread ends


class DeferredUpdate:
    """Runs a job once per frame in its own thread, with the lock held, if it was requested meanwhile."""

    def __init__(self, job: Callable[[], None], take_lock: Callable[[], bool], release_lock: Callable[[], None]):
        self._job, self._take_lock, self._release_lock = job, take_lock, release_lock
        self._requested, self._ended = threading.Event(), threading.Event()
        self._thread: threading.Thread | None = None

    def request(self) -> None:
        self._requested.set()
        if self._thread is None and not self._ended.is_set():
            self._thread = threading.Thread(target=self._run, name="pointloom-later", daemon=True)
            self._thread.start()

    def now(self) -> None:
        """Run a requested job at once. Requires the lock."""
        if self._requested.is_set():
            self._requested.clear()
            self._job()

    def close(self) -> None:
        self._ended.set()
        self._requested.set()  # wake all waiting threads

    def join(self) -> None:
        """Wait for the thread after `close`. Without the lock."""
        thread = self._thread
        if thread is not None and thread is not threading.current_thread():
            thread.join(timeout=5.0)

    def _run(self) -> None:
        while True:
            was_requested = self._requested.wait(IDLE_TIMEOUT)
            if self._ended.is_set() or not self._take_lock():
                return
            try:
                if self._ended.is_set():  # closed while waiting for the lock
                    return
                if not was_requested and not self._requested.is_set():
                    self._thread = None  # the next request starts a new thread
                    return
                self.now()
            except Exception:  # an internal error must not stop the viewer
                log.warning("an update after a change of the scene failed", exc_info=True)
            finally:
                self._release_lock()
            if self._ended.wait(MIN_INTERVAL):
                return
