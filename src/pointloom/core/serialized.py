"""Objects that several threads may use: one call at a time."""

from __future__ import annotations

import contextlib
import functools
import inspect
import threading
from collections.abc import Callable, Iterable, Iterator
from types import FunctionType
from typing import Any, Self, TypeVar, cast

from .attribute_hints import internal_names

Method = TypeVar("Method", bound=Callable[..., Any])

_OPERATORS = {
    "__len__", "__contains__", "__getitem__", "__setitem__", "__delitem__", "__iter__", "__call__", "__repr__",
    "__getstate__", "__copy__", "__deepcopy__", "__reduce__",
}  # fmt: skip


class Serialized:
    """Base class of stateful objects: public methods and properties of one object run one at a time.

    A second thread waits until the running call has returned, so it never sees a change that is under way. The lock is
    re-entrant: methods call each other, and callbacks of a method may use its object. Ctrl-C ends a waiting call.
    """

    _lock: Any

    def __new__(cls, *args: Any, **options: Any) -> Self:
        made = super().__new__(cls)
        object.__setattr__(made, "_lock", threading.RLock())
        return made

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        for name, value in list(vars(cls).items()):
            if (name.startswith("_") and name not in _OPERATORS) or name in internal_names(cls):
                continue
            if isinstance(value, property):
                parts: list[Any] = [part and one_at_a_time(part) for part in (value.fget, value.fset, value.fdel)]
                made: Any = property(parts[0], parts[1], parts[2], value.__doc__)
                made.__set_name__(cls, name)  # for error messages
                setattr(cls, name, made)
            elif inspect.isfunction(value):
                setattr(cls, name, one_at_a_time(value))

    def __getstate__(self) -> Any:
        """The attributes without the lock: a copy has its own."""
        return {name: value for name, value in vars(self).items() if name != "_lock"}


def one_at_a_time(function: Method) -> Method:
    """Acquire the lock of the object for a method. Needed for internal methods that other objects call."""

    def call(self: Any, *args: Any, **options: Any) -> Any:
        with self._lock:
            return function(self, *args, **options)

    # with the globals of the method, by which warnings recognize the caller's line
    home = cast(FunctionType, function).__globals__
    made = FunctionType(cast(FunctionType, call).__code__, home, function.__name__, None, call.__closure__)
    return cast(Method, functools.wraps(function)(made))


@contextlib.contextmanager
def locked_objects(objects: Iterable[Serialized]) -> Iterator[None]:
    """Acquire the locks of several objects, in the same order for all callers."""
    with contextlib.ExitStack() as stack:
        for each in sorted(objects, key=id):
            stack.enter_context(each._lock)
        yield
