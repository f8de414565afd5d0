"""Helpful errors for mismatched calls: argument names, Open3D's equivalents, the intended call.

`explain` adds them to each public name when it is loaded. The decorator is for functions that warn with a fixed stack
level.
"""

from __future__ import annotations

import enum
import functools
import inspect
from collections.abc import Callable, Mapping
from types import CodeType, FunctionType
from typing import Any, ParamSpec, TypeVar

from .attribute_hints import internal_names, nearest_name
from .open3d_names import ARGUMENTS, COMMON, hint, row_of

P = ParamSpec("P")
R = TypeVar("R")

MAX_CHARACTERS = 24  # of a value in the suggested call
EXPLAINED_MARK = "explains_errors"  # attribute of functions whose argument errors are helpful
# `warnings` does not count frames of such file names, so that fixed stack levels still refer to the user's line.
HIDDEN_FILE = "<importlib._bootstrap of pointloom>"
_CONSTRUCTORS = ("__init__", "__call__")
_explained: set[type] = set()


def explain_argument_errors(operation: Callable[P, R]) -> Callable[P, R]:
    """Decorator for helpful argument errors. Free for valid calls."""

    @functools.wraps(operation)
    def call(*args: P.args, **kwargs: P.kwargs) -> R:
        try:
            return operation(*args, **kwargs)
        except TypeError as error:
            if fits(operation, args, kwargs):
                raise
            raise mismatch(operation, args, kwargs, error) from None

    setattr(call, EXPLAINED_MARK, True)
    return call


def explain(value: Any) -> Any:
    """Add helpful argument errors to a public function, which is returned, or to all public calls of a class."""
    if isinstance(value, FunctionType):
        return _hidden(value)
    if not isinstance(value, type) or issubclass(value, enum.Enum):
        return value
    for base in value.__mro__:
        if base in _explained or not base.__module__.startswith("pointloom."):
            continue
        _explained.add(base)
        for name, member in list(vars(base).items()):
            is_public = not name.startswith("_") and name not in internal_names(base)
            if is_public or name in _CONSTRUCTORS or (name == "__new__" and issubclass(base, tuple)):
                if isinstance(member, FunctionType):
                    setattr(base, name, _hidden(member))
                elif isinstance(member, classmethod | staticmethod) and isinstance(member.__func__, FunctionType):
                    setattr(base, name, type(member)(_hidden(member.__func__)))
    return value


def _hidden(operation: FunctionType) -> FunctionType:
    """`explain_argument_errors` in a frame that warnings do not count, with the globals of the operation."""
    if hasattr(operation, EXPLAINED_MARK):
        return operation
    does_fit, explained, wrong_call = fits, mismatch, TypeError  # the globals of a named tuple have no builtins

    def call(*args: Any, **kwargs: Any) -> Any:
        try:
            return operation(*args, **kwargs)
        except wrong_call as error:
            if does_fit(operation, args, kwargs):
                raise
            raise explained(operation, args, kwargs, error) from None

    code = _hidden_code(call.__code__)
    made = FunctionType(code, operation.__globals__, operation.__name__, None, call.__closure__)
    functools.wraps(operation)(made)
    setattr(made, EXPLAINED_MARK, True)
    return made


@functools.cache
def _hidden_code(code: CodeType) -> CodeType:
    return code.replace(co_filename=HIDDEN_FILE)


def fits(operation: Callable[..., Any], args: tuple[Any, ...], kwargs: Mapping[str, Any]) -> bool:
    """True if a call matches the signature. Otherwise nothing of the function has run."""
    try:
        inspect.signature(operation).bind(*args, **kwargs)
    except TypeError:
        return False
    return True


def mismatch(
    operation: Callable[..., Any], args: tuple[Any, ...], kwargs: Mapping[str, Any], error: TypeError
) -> TypeError:
    parameters = list(inspect.signature(operation).parameters.values())
    call_name, given = operation.__name__, list(args)
    if parameters and parameters[0].name in ("self", "cls", "_cls") and given:
        kind = given[0] if isinstance(given[0], type) else type(given[0])
        parameters, given = parameters[1:], given[1:]
        call_name = kind.__name__ if call_name in ("__init__", "__new__") else f"{kind.__name__}.{call_name}"
    keywords = [p.name for p in parameters if p.kind is not p.VAR_KEYWORD and p.kind is not p.VAR_POSITIONAL]
    unknown = [name for name in kwargs if name not in keywords]
    if unknown:
        return TypeError(_unknown(call_name, unknown[0], kwargs[unknown[0]], keywords))
    positional = [p.name for p in parameters if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)]
    if len(given) > len(positional) and not any(p.kind is p.VAR_POSITIONAL for p in parameters):
        return TypeError(_too_many(call_name, positional, keywords, given) + _as_vectors(call_name, parameters, given))
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


def _as_vectors(call_name: str, parameters: list[inspect.Parameter], given: list[Any]) -> str:
    """The call with vectors if single numbers were given in their place, else ""."""
    count = len(given) // 3
    takes_arrays = all("ArrayLike" in str(parameter.annotation) for parameter in parameters[:count])
    is_number = all(isinstance(value, int | float) for value in given)
    if not (is_number and takes_arrays and len(given) == 3 * count and count <= len(parameters)):
        return ""
    vectors = ", ".join(repr(given[3 * k : 3 * k + 3]) for k in range(count))
    return f"; pass three numbers as one list: {call_name.rpartition('.')[2]}({vectors})"


def _short(value: object) -> str:
    text = repr(value)
    return text if len(text) <= MAX_CHARACTERS else "..."
