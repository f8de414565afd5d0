"""Helpful errors for mismatched calls: argument names, Open3D's equivalents, the intended call."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Mapping
from typing import Any, ParamSpec, TypeVar

from .attribute_hints import nearest_name
from .open3d_names import ARGUMENTS, COMMON, hint, row_of

P = ParamSpec("P")
R = TypeVar("R")

MAX_CHARACTERS = 24  # of a value in the suggested call


def explain_argument_errors(operation: Callable[P, R]) -> Callable[P, R]:
    """Decorator for helpful argument errors. Free for valid calls."""

    @functools.wraps(operation)
    def call(*args: P.args, **kwargs: P.kwargs) -> R:
        try:
            return operation(*args, **kwargs)
        except TypeError as error:
            if not is_of_call(error):
                raise
            raise mismatch(operation, args, kwargs, error) from None

    return call


def is_of_call(error: TypeError) -> bool:
    """True if a call did not match the signature, so that nothing of the function has run."""
    return error.__traceback__ is not None and error.__traceback__.tb_next is None


def mismatch(
    operation: Callable[..., Any], args: tuple[Any, ...], kwargs: Mapping[str, Any], error: TypeError
) -> TypeError:
    parameters = list(inspect.signature(operation).parameters.values())
    call_name, given = operation.__name__, list(args)
    if parameters and parameters[0].name in ("self", "cls") and given:
        kind = given[0] if isinstance(given[0], type) else type(given[0])
        parameters, given = parameters[1:], given[1:]
        call_name = kind.__name__ if call_name == "__init__" else f"{kind.__name__}.{call_name}"
    keywords = [p.name for p in parameters if p.kind is not p.VAR_KEYWORD and p.kind is not p.VAR_POSITIONAL]
    unknown = [name for name in kwargs if name not in keywords]
    if unknown:
        return TypeError(_unknown(call_name, unknown[0], kwargs[unknown[0]], keywords))
    positional = [p.name for p in parameters if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)]
    if len(given) > len(positional) and not any(p.kind is p.VAR_POSITIONAL for p in parameters):
        return TypeError(_too_many(call_name, positional, keywords, given))
    missing = [p.name for p in parameters if p.default is p.empty and p.name in keywords and p.name not in kwargs]
    missing = [name for name in missing if name not in positional[: len(given)]]
    if missing:
        return TypeError(f"{call_name}() is missing {', '.join(missing)}: it takes {', '.join(keywords)}")
    return TypeError(str(error).replace(operation.__qualname__, call_name))


def _unknown(call_name: str, name: str, value: object, keywords: list[str]) -> str:
    message = f"{call_name}() has no argument {name!r}"
    if "radius" in keywords and type(value).__name__.startswith("KDTreeSearchParam"):
        return f"{message}; here: {call_name.rpartition('.')[2]}({_search(value)})"
    row = hint(row_of(name, (ARGUMENTS,)))
    same = (row_of(name, (f"{COMMON}.{ARGUMENTS}",)) or "").split(", ")
    near = next((f"; did you mean {other!r}?" for other in same if other in keywords), nearest_name(name, keywords))
    return message + (row or near) + f"; it takes {', '.join(keywords) or 'none'}"


def _search(value: object) -> str:
    radius = getattr(value, "radius", None)
    max_nn = getattr(value, "max_nn", getattr(value, "knn", None))
    return ", ".join(([f"radius={radius:g}"] if radius is not None else []) + [f"max_nn={max_nn}"])


def _too_many(call_name: str, positional: list[str], keywords: list[str], given: list[Any]) -> str:
    only = [name for name in keywords if name not in positional]
    extra = given[len(positional) :]
    if len(extra) > len(only):
        return f"{call_name}() takes at most {len(keywords)} arguments ({', '.join(keywords)}), got {len(given)}"
    first = [
        name if len(repr(value)) > MAX_CHARACTERS else repr(value)
        for name, value in zip(positional, given, strict=False)
    ]
    rest = [f"{name}={_short(value)}" for name, value in zip(only, extra, strict=False)]
    call = f"{call_name.rpartition('.')[2]}({', '.join(first + rest)})"
    begins = f"after {', '.join(positional)}" if positional else "from the first one on"
    return f"{call_name}() takes its arguments by name {begins}: write {call}; it takes {', '.join(keywords)}"


def _short(value: object) -> str:
    text = repr(value)
    return text if len(text) <= MAX_CHARACTERS else "..."
