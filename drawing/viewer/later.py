"""What follows from changes of the scene, done once a frame however many there were: `Later`."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable

FRAME = 1 / 30  # [s] between two times
IDLE = 0.5  # [s] without anything to do, after which the thread ends

log = logging.getLogger("pointloom.viewer")


class Later:
    """Has a job done soon, in a thread of its own, once for all who ask meanwhile.

    Args:
        job: Done with the lock held.
        take_lock: Takes the lock; false once all is over.
        release_lock: Gives it back.
    """

    def __init__(self, job: Callable[[], None], take_lock: Callable[[], bool], release_lock: Callable[[], None]):
        self._job, self._take_lock, self._release_lock = job, take_lock, release_lock
        self._asked, self._ended = threading.Event(), threading.Event()
        self._thread: threading.Thread | None = None

    def ask(self) -> None:
        """Have the job done within a frame; the lock is held."""
        self._asked.set()
        if self._thread is None and not self._ended.is_set():
            self._thread = threading.Thread(target=self._run, name="pointloom-later", daemon=True)
            self._thread.start()

    def now(self) -> None:
        """Do what was asked for and is not done yet; the lock is held."""
        if self._asked.is_set():
            self._asked.clear()
            self._job()

    def close(self) -> None:
        """What is left is not done any more."""
        self._ended.set()
        self._asked.set()  # so that nobody waits

    def join(self) -> None:
        """Wait for the thread, after `close`; without the lock."""
        thread = self._thread
        if thread is not None and thread is not threading.current_thread():
            thread.join(timeout=5.0)

    def _run(self) -> None:
        while True:
            was_asked = self._asked.wait(IDLE)
            if self._ended.is_set() or not self._take_lock():
                return
            try:
                if self._ended.is_set():  # while the lock was waited for
                    return
                if not was_asked and not self._asked.is_set():
                    self._thread = None  # who asks from now on starts another
                    return
                self.now()
            except Exception:  # a fault of ours: the viewer goes on
                log.warning("what follows from a change of the scene", exc_info=True)
            finally:
                self._release_lock()
            if self._ended.wait(FRAME):
                return
