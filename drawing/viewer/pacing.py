"""How fast a page takes what it is sent: `Pace`."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

PATIENCE = 3.0  # [s] after which a page that gives no sign is sent the next step all the same
SIGNS = 3  # frames of the page between two steps: it prepares one or two ahead of what is on the screen
PAUSE = 0.1  # [s] more


class Pace:
    """A sign from a page between one step and the next, so that it draws each before it has to take another.

    A page works off its messages once for each frame that it draws: one that draws slowly answers slowly.

    Args:
        ask: Asks the page for a sign.
    """

    def __init__(self, ask: Callable[[], None]):
        self._ask = ask
        self._answered, self._ended = threading.Event(), threading.Event()

    def answer(self) -> None:
        """The page has given a sign."""
        self._answered.set()

    def wait(self) -> bool:
        """Until the page has taken what it was sent; false where it has gone."""
        end = time.monotonic() + PATIENCE
        for _ in range(SIGNS):
            self._answered.clear()
            if self._ended.is_set():
                return False
            self._ask()
            if not self._answered.wait(max(end - time.monotonic(), 0.0)):
                break
        return not self._ended.wait(PAUSE)

    def close(self) -> None:
        """Nobody has to wait any more."""
        self._ended.set()
        self._answered.set()
