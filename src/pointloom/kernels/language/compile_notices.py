"""Log record (INFO, logger "pointloom") for a kernel whose compilation lasts longer than `NOTICE_DELAY`.

Loading from a cache is not announced. Taichi blocks other threads while it compiles, so its record comes afterward.
"""

from __future__ import annotations

import contextlib
import logging
import threading
import time
from collections.abc import Iterator

LOGGER = logging.getLogger("pointloom")
COMPILES = {"compiles": True}  # attribute of the record, for logging handlers
NOTICE_DELAY = 1.0  # [s] shorter waits are not reported

_current = threading.local()  # the first launch in progress on this thread, if there is one


class FirstLaunch:
    """The first launch of a kernel. Logs its compilation if it lasts longer than `NOTICE_DELAY`."""

    def __init__(self, name: str):
        self._name, self._began = name, 0.0
        self._reported, self._timer = threading.Event(), threading.Timer(NOTICE_DELAY, self._report)
        self._timer.daemon = True

    def _report(self) -> None:
        self._reported.set()
        LOGGER.info("compiling %s for its first use on this machine", self._name, extra=COMPILES)

    def compiling(self) -> None:
        if not self._began:
            self._began = time.monotonic()
            with contextlib.suppress(RuntimeError):  # no thread can start: `end` logs the compilation
                self._timer.start()

    def end(self) -> None:
        self._timer.cancel()
        if self._timer.is_alive():
            self._timer.join()
        seconds = time.monotonic() - self._began
        if self._began and seconds > NOTICE_DELAY and not self._reported.is_set():
            LOGGER.info("compiled %s for its first use on this machine in %.1f s", self._name, seconds, extra=COMPILES)


@contextlib.contextmanager
def announced(name: str) -> Iterator[bool]:
    outer, launch = getattr(_current, "launch", None), FirstLaunch(name)
    _current.launch = launch
    try:
        yield True
    finally:
        _current.launch = outer
        launch.end()


def compiling() -> None:
    """Report that the current kernel is being compiled instead of loaded from a cache."""
    launch = getattr(_current, "launch", None)
    if launch is not None:
        launch.compiling()
