"""A thread-safe cached property."""

from __future__ import annotations

import contextlib
import gc
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from .device_lock import lock


@contextlib.contextmanager
def without_collections() -> Iterator[None]:
    """Suspend the garbage collector, which would take a third of the time here."""
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()


if TYPE_CHECKING:
    once = property  # protocols accept this type only
else:

    class once:  # noqa: N801  a decorator, as `property` is
        """Cached property stored in `__dict__`. It uses the launch lock, since a second lock could cause a deadlock."""

        def __init__(self, method: Callable[[Any], Any]) -> None:
            self.method, self.__doc__ = method, method.__doc__

        def __set_name__(self, owner: type, name: str) -> None:
            self.name = name

        def __get__(self, owner: object, kind: type | None = None) -> Any:
            if owner is None:
                return self
            with lock, without_collections():
                values = vars(owner)
                if self.name not in values:
                    try:
                        values[self.name] = self.method(owner)
                    except AttributeError as error:  # which getattr(..., None) would interpret as absence
                        raise RuntimeError(f"{self.name}: {error}") from error
                return values[self.name]
