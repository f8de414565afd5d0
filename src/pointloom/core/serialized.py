"""Objects that several threads may use, one call at a time, also in forked processes and pickles."""

from __future__ import annotations

import contextlib
import functools
import inspect
import os
import threading
import time
import weakref
from collections.abc import Callable, Iterable, Iterator
from types import FunctionType
from typing import Any, ClassVar, NoReturn, Self, TypeVar, cast

import numpy as np

from .attribute_hints import internal_names

Method = TypeVar("Method", bound=Callable[..., Any])

_OPERATORS = {
    "__len__", "__contains__", "__getitem__", "__setitem__", "__delitem__", "__iter__", "__call__", "__repr__",
    "__getstate__", "__copy__", "__deepcopy__", "__reduce__",
}  # fmt: skip
FORK_SECONDS = 1.0  # [s] at most that a fork waits for running calls: longer than a frame or a scan takes

_locked: weakref.WeakValueDictionary[int, Any] = weakref.WeakValueDictionary()  # objects with locks, by their id
_forking = threading.RLock()  # one fork at a time
_acquired: list[Any] = []  # during a fork: objects that no other thread uses


_RLock: Any = type(threading.RLock())


class CallLock(_RLock):
    """Re-entrant lock of an object, with the thread that runs a call.

    It is acquired by a `with` of the interpreter, which Ctrl-C does not part from the release. What is noted about
    threads may be old after Ctrl-C, so `announce` tries the lock before it raises.
    """

    waiting: ClassVar[dict[int, CallLock]] = {}  # by thread: the lock that it waits for, or is about to acquire
    looking = threading.Lock()  # for a ring of waiting threads
    thread = 0  # inside of a call

    def announce(self, owner: object) -> int:
        """Note that this thread, which is returned, is to wait. Raises RuntimeError if it would wait forever: the
        thread of the running call waits, directly or through others, for a call of this thread."""
        me = threading.get_ident()
        CallLock.waiting[me] = self
        if self.thread in (0, me):
            return me
        with CallLock.looking:  # of several threads in a ring, the first one raises, and the others go on
            wanted, seen = self, set[int]()
            while wanted is not None and wanted.thread not in {0, me, *seen}:
                seen.add(wanted.thread)
                wanted = CallLock.waiting.get(wanted.thread)
            if wanted is None or wanted.thread != me:
                return me
            if self.acquire(blocking=False):
                self.release()
                return me
            del CallLock.waiting[me]
        raise RuntimeError(
            f"this {type(owner).__name__} is in use by another thread, which waits for the call that this thread is "
            "in: neither would end. Two objects must not use each other in their callbacks from two threads"
        )


class Serialized:
    """Base class of stateful objects: public methods and properties of one object run one at a time.

    A second thread waits until the running call has returned, so it never sees a change that is under way. The lock is
    re-entrant: methods call each other, and callbacks of a method may use its object. Ctrl-C ends a waiting call. Calls
    of two threads that would wait for each other raise RuntimeError in one of them.

    A fork waits for running calls, at most FORK_SECONDS. A child raises RuntimeError for objects still in use.
    """

    _lock: Any

    def __new__(cls, *args: Any, **options: Any) -> Self:
        made = super().__new__(cls)
        object.__setattr__(made, "_lock", CallLock())
        keep_through_forks(made)
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
                made = one_at_a_time(value)
                setattr(cls, name, _without_views(made) if name in ("__getstate__", "__reduce__") else made)

    def __getstate__(self) -> Any:
        """The attributes without the lock: a copy has its own."""
        with self._lock:
            return without_views({name: value for name, value in vars(self).items() if name != "_lock"})


def without_views(state: Any) -> Any:
    """The state of a pickle with copies of its containers and views: pickle reads them after the lock is released."""
    if isinstance(state, np.ndarray):
        return state if state.flags.owndata else state.copy()
    if type(state) is dict:
        return {key: without_views(value) for key, value in state.items()}
    return type(state)(map(without_views, state)) if type(state) in (list, tuple) else state


def _without_views(function: Callable[[Any], Any]) -> Callable[[Any], Any]:
    @functools.wraps(function)
    def state_of(self: Any) -> Any:
        with self._lock:
            return without_views(function(self))

    return state_of


class _LostLock:
    """Lock of an object in a child process whose state another thread of the parent was changing."""

    def __init__(self, kind: str) -> None:
        self._kind = kind

    def announce(self, owner: object) -> NoReturn:
        self.__enter__()

    def __enter__(self) -> NoReturn:
        raise RuntimeError(
            f"this {self._kind} was in use by another thread when the process was forked, so its state is not known; "
            "create it in the child, or fork between the calls"
        )

    def __exit__(self, *_: object) -> None: ...

    def acquire(self, timeout: float) -> bool:
        return False


def keep_through_forks(owner: Any) -> None:
    """Let a forked process use an object whose `_lock` another thread of the parent may have acquired."""
    _locked[id(owner)] = owner


def _before_fork() -> None:
    _forking.acquire()
    end = time.monotonic() + FORK_SECONDS
    for owner in list(_locked.values()):
        if owner._lock.acquire(timeout=max(0.0, end - time.monotonic())):
            _acquired.append(owner)


def _after_fork_in_parent() -> None:
    while _acquired:
        _acquired.pop()._lock.release()
    _forking.release()


def _after_fork_in_child() -> None:
    known = {id(owner) for owner in _acquired}
    CallLock.waiting.clear()  # threads of the parent
    CallLock.looking = threading.Lock()
    _after_fork_in_parent()
    for owner in list(_locked.values()):
        if id(owner) not in known:
            object.__setattr__(owner, "_lock", _LostLock(type(owner).__name__))


if hasattr(os, "register_at_fork"):  # not on Windows
    os.register_at_fork(before=_before_fork, after_in_parent=_after_fork_in_parent, after_in_child=_after_fork_in_child)


def one_at_a_time(function: Method) -> Method:
    """Acquire the lock of the object for a method. Needed for internal methods that other objects call."""
    waiting = CallLock.waiting

    def call(self: Any, *args: Any, **options: Any) -> Any:
        lock = self._lock
        me = lock.announce(self)
        with lock:
            outer, lock.thread = lock.thread, me
            waiting.pop(me, None)
            try:
                return function(self, *args, **options)
            finally:
                lock.thread = outer if outer == me else 0

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
