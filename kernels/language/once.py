"""A property that is computed when it is first asked for, once, whatever threads ask."""

from __future__ import annotations

import contextlib
import gc
from collections.abc import Callable, Iterator
from typing import Any, Generic, TypeVar

from .device_lock import lock

Value = TypeVar("Value")


@contextlib.contextmanager
def without_collections() -> Iterator[None]:
    """Hold the garbage collector: what is made here stays, and walking over it takes a third of the time."""
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()


class once(Generic[Value]):  # noqa: N801  a decorator, as `property` is
    """Marks a method as such a property; the value lies in the object's `__dict__`, so that later reads cost nothing.

    What is computed belongs to the compilers, which take turns: so it takes the launches' lock, and no second one that
    could be taken in the other order.
    """

    def __init__(self, method: Callable[[Any], Value]) -> None:
        self.method, self.__doc__ = method, method.__doc__

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, owner: Any, kind: type | None = None) -> Value:
        if owner is None:
            return self  # type: ignore[return-value]
        with lock, without_collections():
            found = vars(owner)
            if self.name not in found:
                try:
                    found[self.name] = self.method(owner)
                except AttributeError as error:  # which who asks by getattr(..., None) would take for "there is none"
                    raise RuntimeError(f"{self.name}: {error}") from error
            return found[self.name]
