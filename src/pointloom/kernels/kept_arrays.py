"""Arrays kept for the next call: their allocation would take longer than a small kernel."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Generic, TypeVar

Arrays = TypeVar("Arrays")


class KeptArrays(Generic[Arrays]):
    """Scratch arrays by a key, such as a shape. Keys must be few. A second thread, or a signal handler that calls in
    between, gets other arrays."""

    def __init__(self, make: Callable[..., Arrays]) -> None:
        self._make = make
        self._idle: dict[tuple[Hashable, ...], list[Arrays]] = {}

    def take(self, *key: Hashable) -> Arrays:
        """Arrays for one call, made by `make(*key)` if none are idle. Uninitialized."""
        try:
            return self._idle[key].pop()
        except (KeyError, IndexError):
            return self._make(*key)

    def keep(self, arrays: Arrays, *key: Hashable) -> None:
        """Keep the arrays for the next call."""
        self._idle.setdefault(key, []).append(arrays)
