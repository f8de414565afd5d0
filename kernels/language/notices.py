"""Says that a kernel is being compiled, where that takes long: records of the logger "pointloom" at level INFO.

A kernel is compiled at its first launch on a machine, and later processes fetch it from the compilers' caches; nothing
tells beforehand which it will be. So a first launch is announced when it has lasted `PATIENCE`. Taichi lets no other
thread run while it compiles: there the record comes right after.
"""

from __future__ import annotations

import contextlib
import logging
import threading
import time
from collections.abc import Iterator

LOGGER = logging.getLogger("pointloom")
PATIENCE = 1.0  # [s] a first launch from a warm cache takes less than half of it


@contextlib.contextmanager
def announced(name: str) -> Iterator[bool]:
    """Announce a kernel's first launch, if it lasts; gives True."""
    begin, said = time.monotonic(), threading.Event()

    def say() -> None:
        said.set()
        LOGGER.info("compiling %s for its first use on this machine", name)

    timer = threading.Timer(PATIENCE, say)
    timer.daemon = True
    with contextlib.suppress(RuntimeError):  # the system refuses a thread: then it is said afterwards
        timer.start()
    try:
        yield True
    finally:
        timer.cancel()
        if timer.is_alive():
            timer.join()
        seconds = time.monotonic() - begin
        if seconds > PATIENCE and not said.is_set():
            LOGGER.info("compiled %s for its first use on this machine in %.1f s", name, seconds)
