"""What was used last, within a budget: where something new wants room, what was not used for longest makes it."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from typing import Any, Generic, TypeVar

Value = TypeVar("Value")


class LastUsed(Generic[Value]):
    """Things by their keys, those used last.

    Args:
        room: That all of them may take, such as bytes.
        dropped: Called with each thing that makes room.

    Example:
        >>> from pointloom.photos.mvs.last_used import LastUsed
        >>> pictures = LastUsed(100, dropped=print)
        >>> for key in (1, 2, 1, 3):
        ...     name = pictures.get(key, 40, lambda: f"picture {key}")
        picture 2
    """

    def __init__(self, room: int, *, dropped: Callable[[Value], Any] | None = None):
        self._room, self._dropped = room, dropped
        self._kept: OrderedDict[Hashable, tuple[Value, int]] = OrderedDict()  # the one used last stands last

    def get(self, key: Hashable, size: int, make: Callable[[], Value], *, beside: Hashable = None) -> Value:
        """The thing of this key, which is made where it is not kept.

        Args:
            key: Of the thing.
            size: Of the room that it takes; one that is larger than all the room is kept alone.
            make: Makes it, once there is room. Where it raises, nothing is kept.
            beside: Key of another that is in use meanwhile, and makes no room.
        """
        for used in (beside, key):
            if used in self._kept:
                self._kept.move_to_end(used)
        if key not in self._kept:
            self._make_room(size, beside)
            self._kept[key] = make(), size
        return self._kept[key][0]

    def _make_room(self, size: int, beside: Hashable) -> None:
        left = self._room - size - sum(taken for _, taken in self._kept.values())
        for key in [key for key in self._kept if key != beside]:
            if left >= 0:
                return
            value, taken = self._kept.pop(key)
            left += taken
            if self._dropped is not None:
                self._dropped(value)
