"""Says that a kernel is being compiled, where that takes long: records of the logger "pointloom" at level INFO.

A kernel is compiled at its first launch on a machine, and later processes fetch it from the compilers' caches. What
makes it ready knows which it is, and calls `compiling` where it is not there: a compilation is announced when it has
lasted `PATIENCE`, a slow machine that only loads is not. Taichi lets no other thread run while it compiles: there the
record comes right after.
"""

from __future__ import annotations

import contextlib
import logging
import threading
import time
from collections.abc import Iterator

LOGGER = logging.getLogger("pointloom")
COMPILES = {"compiles": True}  # of a record, for handlers
PATIENCE = 1.0  # [s] shorter waits are nobody's concern

_current = threading.local()  # the first launch that this thread is in, if any


class FirstLaunch:
    """A kernel's first launch in this process: says that it is compiled, once it is known to be and has lasted."""

    def __init__(self, name: str):
        self._name, self._began = name, 0.0
        self._said, self._timer = threading.Event(), threading.Timer(PATIENCE, self._say)
        self._timer.daemon = True

    def _say(self) -> None:
        self._said.set()
        LOGGER.info("compiling %s for its first use on this machine", self._name, extra=COMPILES)

    def compiling(self) -> None:
        """It is compiled from now on."""
        if not self._began:
            self._began = time.monotonic()
            with contextlib.suppress(RuntimeError):  # the system refuses a thread: then it is said afterwards
                self._timer.start()

    def end(self) -> None:
        """It is over."""
        self._timer.cancel()
        if self._timer.is_alive():
            self._timer.join()
        seconds = time.monotonic() - self._began
        if self._began and seconds > PATIENCE and not self._said.is_set():
            LOGGER.info("compiled %s for its first use on this machine in %.1f s", self._name, seconds, extra=COMPILES)


@contextlib.contextmanager
def announced(name: str) -> Iterator[bool]:
    """Announce a kernel's first launch, if it is compiled and that lasts; gives True."""
    outer, launch = getattr(_current, "launch", None), FirstLaunch(name)
    _current.launch = launch
    try:
        yield True
    finally:
        _current.launch = outer
        launch.end()


def compiling() -> None:
    """Something is compiled from now on, and not fetched from a cache."""
    launch = getattr(_current, "launch", None)
    if launch is not None:
        launch.compiling()
