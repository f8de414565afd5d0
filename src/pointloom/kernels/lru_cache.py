"""Cache with a capacity that evicts the least recently used values."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Any, Generic, TypeVar

Value = TypeVar("Value")


class LruCache(Generic[Value]):
    """Values by key within a capacity. The newest value is kept even if it is larger than the capacity.

    Args:
        capacity: Maximum total size of the values, in the unit of their sizes.
        on_evict: Called with each value that is evicted or cleared.

    Example:
        >>> from pointloom.kernels.lru_cache import LruCache
        >>> images = LruCache(100, on_evict=print)
        >>> for key in (1, 2, 1, 3):
        ...     name = images.get(key, 40, lambda: f"image {key}")
        image 2
    """

    def __init__(self, capacity: int, *, on_evict: Callable[[Value], Any] | None = None):
        self._capacity, self._on_evict = capacity, on_evict
        self._entries: OrderedDict[Hashable, tuple[Value, int]] = OrderedDict()  # most recently used last

    @property
    def size(self) -> int:
        return sum(size for _, size in self._entries.values())

    def find(self, key: Hashable) -> Value | None:
        """The value of a key, marked as used. None if there is none."""
        if key not in self._entries:
            return None
        self._entries.move_to_end(key)
        return self._entries[key][0]

    def get(self, key: Hashable, size: int, make: Callable[[], Value], *, beside: Hashable = None) -> Value:
        """Value of a key. If absent, evict others (except `beside`), make (may raise) and insert it."""
        self.find(beside)
        if key not in self._entries:
            self._make_room(size, beside)
            self._entries[key] = make(), size
        self._entries.move_to_end(key)
        return self._entries[key][0]

    def put(self, key: Hashable, value: Value, size: int = 1) -> None:
        self._entries.pop(key, None)
        self._make_room(size, None)
        self._entries[key] = value, size

    def pop(self, key: Hashable) -> Value | None:
        """Remove and return the value of a key. None if there is none."""
        return self._entries.pop(key, (None, 0))[0]

    def clear(self) -> None:
        while self._entries:
            self._evict(next(iter(self._entries)))

    def _make_room(self, size: int, beside: Hashable) -> None:
        left = self._capacity - size - self.size
        for key in [key for key in self._entries if key != beside]:
            if left >= 0:
                return
            left += self._evict(key)

    def _evict(self, key: Hashable) -> int:
        value, size = self._entries.pop(key)
        if self._on_evict is not None:
            self._on_evict(value)
        return size
