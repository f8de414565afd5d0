"""What was changed in a page, so that it can be taken back and done again: `History`."""

from __future__ import annotations

import dataclasses
import threading
import time
from collections.abc import Callable

MOST = 100  # changes that are kept
MOST_BYTES = 64 << 20  # of what they hold on to
TOGETHER = 1.0  # [s] between changes of one slider that count as one


@dataclasses.dataclass(frozen=True, eq=False)
class Change:
    """A change.

    Args:
        label: What it was, such as "Hide scan".
        undo, redo: Take it back, and do it again.
        key: Changes of the same key that follow each other quickly are one; None joins none.
        nbytes: What it holds on to.
    """

    label: str
    undo: Callable[[], None]
    redo: Callable[[], None]
    key: str | None = None
    nbytes: int = 0


class History:
    """The changes of one page, the last ones first to be taken back.

    Args:
        clock: Seconds, for changes that count as one.

    Attributes:
        is_watched: Whether somebody waits for an action's end to add what it changed.

    Example:
        >>> values, history = [0], History()
        >>> def set_value(value):
        ...     before = values[0]
        ...     values[0] = value
        ...     history.add(Change(f"Set {value}", lambda: values.__setitem__(0, before), lambda: set_value(value)))
        >>> set_value(5)
        >>> history.undo(), values
        ('Taken back: Set 5', [0])
        >>> history.redo(), values
        ('Done again: Set 5', [5])
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic):
        self._clock, self._lock = clock, threading.RLock()
        self._done: list[Change] = []
        self._undone: list[Change] = []
        self._last, self._is_busy = -TOGETHER, False
        self._forgotten, self.is_watched = 0, False

    def add(self, change: Change) -> None:
        """A change that has been made; what was taken back before it cannot be done again. While one is taken back or
        done again, nothing is added.
        """
        with self._lock:
            if self._is_busy:
                return
            now, last = self._clock(), self._done[-1] if self._done else None
            is_same = last is not None and change.key is not None and last.key == change.key
            if last is not None and is_same and now - self._last <= TOGETHER and not self._undone:
                self._done[-1] = dataclasses.replace(change, undo=last.undo)
            else:
                self._done.append(change)
            self._undone.clear()
            self._last = now
            while len(self._done) > MOST or (len(self._done) > 1 and self._bytes() > MOST_BYTES):
                self._done.pop(0)
                self._forgotten += 1

    def undo(self) -> str:
        """Take back the last change; says in words what was done."""
        with self._lock:
            if not self._done:
                told = f"; the {self._forgotten} before are no longer kept" if self._forgotten else ""
                return f"There is nothing to take back{told}."
            change = self._done.pop()
            return self._run(change, change.undo, self._undone, "Taken back")

    def redo(self) -> str:
        """Do again what was taken back last; says in words what was done."""
        with self._lock:
            if not self._undone:
                return "There is nothing to do again."
            change = self._undone.pop()
            return self._run(change, change.redo, self._done, "Done again")

    def labels(self) -> tuple[list[str], list[str]]:
        """What can be taken back, and what can be done again; the next ones last."""
        with self._lock:
            return [change.label for change in self._done], [change.label for change in self._undone]

    def _run(self, change: Change, job: Callable[[], None], kept: list[Change], told: str) -> str:
        self._is_busy, self._last = True, -TOGETHER
        try:
            job()
        except (ValueError, KeyError, LookupError, RuntimeError) as error:  # what it was about has gone
            reason = str(error.args[0]) if error.args else type(error).__name__
            return f"Cannot be {told.lower()}: {change.label}: {reason}"
        finally:
            self._is_busy = False
        kept.append(change)
        return f"{told}: {change.label}"

    def _bytes(self) -> int:
        return sum(change.nbytes for change in self._done)
