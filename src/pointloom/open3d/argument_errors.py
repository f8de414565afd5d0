"""Invalid arguments of functions for which Open3D raises RuntimeError."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")


class ArgumentError(RuntimeError, ValueError):
    """An invalid argument: a RuntimeError, as in Open3D, and a ValueError, as in pointloom."""


def as_runtime_errors(function: Callable[P, R]) -> Callable[P, R]:
    """Raise ValueErrors of a function as `ArgumentError`."""

    @wraps(function)
    def checked(*args: P.args, **keywords: P.kwargs) -> R:
        try:
            return function(*args, **keywords)
        except ValueError as error:
            if isinstance(error, RuntimeError):
                raise
            raise ArgumentError(str(error)) from error

    return checked
