"""The thread in which a page's callbacks run: `Worker`."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable, Hashable
from typing import Any

MOST_WAITING = 64  # callbacks of one page; what comes while so many wait is dropped

log = logging.getLogger("pointloom.viewer")


class Worker:
    """Runs callbacks one after the other in a thread that it starts with the first; what they raise is logged.

    Args:
        name: Of the thread.
    """

    def __init__(self, name: str):
        self._name = name
        self._lock = threading.Lock()
        self._wake = threading.Condition(self._lock)
        self._waiting: dict[Hashable, tuple[Callable[..., Any], tuple[Any, ...]]] = {}
        self._thread: threading.Thread | None = None
        self._ended = False

    def run(self, callback: Callable[..., Any], *arguments: Any, about: Hashable = None, always: bool = False) -> bool:
        """Have a callback called.

        Args:
            callback: The callback.
            arguments: Of its call.
            about: What it tells of: a callback about the same that still waits is not called, this one is in its turn.
            always: Whether it is called however many wait.

        Returns:
            Whether it will be called.
        """
        with self._lock:
            key: Hashable = object() if about is None else (id(callback), about)
            if self._ended or (len(self._waiting) >= MOST_WAITING and key not in self._waiting and not always):
                return False
            self._waiting[key] = (callback, arguments)
            if self._thread is None:
                self._thread = threading.Thread(target=self._work, name=self._name, daemon=True)
                self._thread.start()
            self._wake.notify()
            return True

    def end(self) -> None:
        """Take no more; the thread ends when those that wait were called."""
        with self._lock:
            self._ended = True
            self._wake.notify()

    def _work(self) -> None:
        while True:
            with self._lock:
                while not self._waiting and not self._ended:
                    self._wake.wait()
                if not self._waiting:
                    return
                key = next(iter(self._waiting))
                callback, arguments = self._waiting.pop(key)
            self._call(callback, arguments)
            del callback, arguments, key

    def _call(self, callback: Callable[..., Any], arguments: tuple[Any, ...]) -> None:
        try:
            callback(*arguments)
        except Exception:
            log.exception("a callback of the viewer failed")
