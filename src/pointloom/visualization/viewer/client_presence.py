"""Detection of open pages, with messages on stderr when the last one closes: `Presence`."""

from __future__ import annotations

import math
import threading
import time

from ...core.checks import check_positive
from ...core.standard_streams import write_to_stderr
from .scene_display import SceneDisplay

CHECK_INTERVAL = 0.2  # [s] between checks
KEEP_ALIVE = 60.0  # [s] after the last page has closed: pages may reload over a slow connection


class Presence:
    """The pages of a viewer from the point of view of a waiting program."""

    def __init__(self, display: SceneDisplay):
        self._display, self._is_reported, self._lock = display, False, threading.Lock()

    def wait(self, seconds: float | None, keep_alive: float) -> bool:
        keep_alive = check_positive("keep_alive", keep_alive, allow_zero=True, allow_infinite=True)
        end = math.inf if seconds is None else time.monotonic() + check_positive("seconds", seconds, allow_zero=True)
        display = self._display
        while not display.scene.wait_until_closed(min(CHECK_INTERVAL, max(end - time.monotonic(), 0.0))):
            gone = display.last_closed
            seen = None if gone is None else max(gone, display.server.last_request)
            left = self._is_over(bool(display.sessions), seen, keep_alive)
            if left or time.monotonic() >= end:
                return left
        return True

    def _is_over(self, is_open: bool, seen: float | None, keep_alive: float) -> bool:
        """True if no page was connected for `keep_alive` [s] since `seen`. Prints when the last closes or one opens."""
        with self._lock:
            if is_open or seen is None:
                if self._is_reported:
                    self._is_reported = False
                    write_to_stderr("a page is open again")
                return False
            over = time.monotonic() - seen >= keep_alive
            if not self._is_reported and keep_alive > 0 and not over:
                self._is_reported = True
                ending = "waiting for another" if math.isinf(keep_alive) else f"ending in {keep_alive:g} s"
                url = self._display.server.url
                write_to_stderr(f"the last page has closed; {ending} (open {url} again to stay, Ctrl-C ends now)")
            return over
