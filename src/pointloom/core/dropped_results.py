"""Warn if a statement drops the result of an operation that works in place in Open3D."""

from __future__ import annotations

import dis
import functools
import sys
import warnings
from collections.abc import Callable
from types import CodeType
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar, cast

from .argument_errors import MARK, fits, mismatch

P = ParamSpec("P")
R = TypeVar("R")

READS_BYTECODE = sys.implementation.name == "cpython"
MAX_CALLS = 4096  # whose callee is remembered
OWNERS = {"PointCloud": "cloud", "TriangleMesh": "mesh", "LineSet": "lines", "TSDFVolume": "volume"}


class DroppedResultWarning(UserWarning):
    """The result of an operation that returns a new object was dropped. Raised by CPython alone.

    Example:
        >>> import warnings, pointloom as loom
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", loom.DroppedResultWarning)  # make it an error
    """


class Pair(tuple[Any, ...]):
    """A tuple of results with a helpful error for attribute access: `cloud.remove_radius_outlier(4, 0.1).points`."""

    __slots__ = ()

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:  # called only for missing attributes
            if not self or name.startswith("_") or not hasattr(type(self[0]), name):
                raise AttributeError(f"'tuple' object has no attribute {name!r}")
            kinds = ", ".join(type(part).__name__ for part in self)
            targets = ", ".join([OWNERS.get(type(self[0]).__name__, "result"), *("_" * (len(self) - 1))])
            raise AttributeError(f"a tuple of {kinds} has no attribute {name!r}; unpack it: {targets} = ...")


def returns_new(operation: Callable[P, R]) -> Callable[P, R]:
    """Mark an operation that returns a new object where Open3D changes in place or returns another type.
    A statement such as `cloud.estimate_normals()` warns, found by one instruction of the caller (POP_TOP) and its
    callee: `clouds.extend(map(...))` is none. Mismatched arguments raise the error of `explain_argument_errors`."""

    @functools.wraps(operation)
    def call(*args: P.args, **kwargs: P.kwargs) -> R:
        try:
            result = operation(*args, **kwargs)
        except TypeError as error:
            if fits(operation, args, kwargs):
                raise
            raise mismatch(operation, args, kwargs, error) from None
        if READS_BYTECODE:
            caller = sys._getframe(1)
            if _is_dropped(caller.f_code, caller.f_lasti, operation.__name__):
                warnings.warn(_message(operation, args, result), DroppedResultWarning, stacklevel=2)
        return cast(R, Pair(result)) if type(result) is tuple else result

    setattr(call, MARK, True)
    return call


def _message(operation: Callable[..., Any], args: tuple[Any, ...], result: object) -> str:
    name = operation.__name__
    call_name, target, call = name, "result", name
    if "." in operation.__qualname__:
        kind = type(args[0]).__name__
        target = OWNERS.get(kind, "box" if kind.endswith("Box") else "result")
        call_name, call = f"{kind}.{name}", f"{target if target != 'result' else 'it'}.{name}"
    target += ", _" if isinstance(result, tuple) else ""
    return (
        f"{call_name}: the result is discarded; it returns a new object and changes nothing: "
        f"write {target} = {call}(...)"
    )


@functools.lru_cache(MAX_CALLS)
def _is_dropped(code: CodeType, at: int, name: str) -> bool:
    """True if the call at a bytecode offset is `name(...)` or `x.name(...)`, not for example `map`, and its result is
    dropped. The load of a callee has the source position of its call. Without positions nothing is detected."""
    steps = list(dis.get_instructions(code))
    starts = [step.positions[::2] if step.positions else (None,) for step in steps]  # line and column
    call = max(k for k, step in enumerate(steps) if step.offset <= at)  # `at` may be in the inline cache after it
    if call + 1 == len(steps) or steps[call + 1].opname != "POP_TOP" or None in starts[call]:
        return False
    return any(step.argval == name and start == starts[call] for step, start in zip(steps[:call], starts, strict=False))
