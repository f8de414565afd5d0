"""A warning where the result of an operation is dropped that Open3D would have made in place."""

from __future__ import annotations

import functools
import opcode
import sys
import warnings
from collections.abc import Callable
from types import FrameType
from typing import Any, ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")

_CACHE, _POP_TOP = opcode.opmap.get("CACHE", 0), opcode.opmap["POP_TOP"]


class DroppedResultWarning(UserWarning):
    """An operation was called for nothing: it returns what it made, and nobody took it.

    Example:
        >>> import warnings, pointloom as loom
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", loom.DroppedResultWarning)  # make it an error
    """


def returns_new(operation: Callable[P, R]) -> Callable[P, R]:
    """Marks an operation that changes its object in Open3D and returns a new one here.

    A call on a line of its own, whose result nobody takes, warns: `cloud.estimate_normals()`. What an interactive
    prompt shows is taken. The check reads one instruction of the caller, in a microsecond.
    """

    @functools.wraps(operation)
    def call(*args: P.args, **kwargs: P.kwargs) -> R:
        result = operation(*args, **kwargs)
        if _is_dropped(sys._getframe(1)):
            warnings.warn(_message(operation, args), DroppedResultWarning, stacklevel=2)
        return result

    return call


def _message(operation: Callable[..., Any], args: tuple[Any, ...]) -> str:
    name = operation.__name__
    said, wanted = name, f"result = {name}(...)"
    if "." in operation.__qualname__:
        kind = type(args[0]).__name__
        owner = {"PointCloud": "cloud", "TriangleMesh": "mesh"}.get(kind, "box")
        said, wanted = f"{kind}.{name}", f"{owner} = {owner}.{name}(...)"
    return f"{said}: the result is dropped; it returns a new object and changes nothing: write {wanted}"


def _is_dropped(caller: FrameType) -> bool:
    """Whether the instruction after the caller's call throws the result away."""
    code = caller.f_code.co_code
    at = caller.f_lasti + 2
    while at < len(code) and code[at] == _CACHE:
        at += 2
    return at < len(code) and code[at] == _POP_TOP
