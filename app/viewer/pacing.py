"""How fast a page takes what it is sent: `Pace`."""

from __future__ import annotations

import threading
from collections.abc import Callable

PATIENCE = 3.0  # [s] after which a page that gives no sign is sent the next step all the same
PAUSE = 0.05  # [s] more, in which the frame with the last step is shown


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
        self._answered.clear()
        self._ask()
        if not self._ended.is_set():
            self._answered.wait(PATIENCE)
        return not self._ended.wait(PAUSE)

    def close(self) -> None:
        """Nobody has to wait any more."""
        self._ended.set()
        self._answered.set()
