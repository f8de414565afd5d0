"""Strict JSON objects: no NaN, infinity or duplicate keys."""

from __future__ import annotations

import json
import math
import os
from collections import Counter
from typing import Any

from .checks import LARGEST_NUMBER as LARGEST_NUMBER
from .errors import FileError
from .paths import input_path

MAX_DIGITS = 300  # digits of an integer that float64 represents


def read_json_object(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Read a JSON object strictly. Syntax errors report the line."""
    file = input_path(path)
    try:
        content = json.loads(
            data := file.read_bytes(),
            object_pairs_hook=_unique_pairs,
            parse_constant=_refuse,
            parse_float=_finite,
            parse_int=_bounded,
        )
        if b"\\ud" in data.lower():
            json.dumps(content, ensure_ascii=False).encode()  # a lone surrogate is invalid text
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    except json.JSONDecodeError as error:
        raise FileError(path, f"not JSON: {error.msg}", where=f"line {error.lineno}, column {error.colno}") from error
    except (ValueError, RecursionError) as error:
        raise FileError(path, f"not valid JSON: {error}") from error
    if not isinstance(content, dict):
        raise FileError(path, f"expected a JSON object, got a {type(content).__name__}")
    return content


def check_keys(
    path: str | os.PathLike[str],
    content: dict[str, Any],
    *,
    required: set[str] | frozenset[str],
    optional: set[str] | frozenset[str] = frozenset(),
    where: str = "",
) -> None:
    """Raise if a JSON object lacks a key or has an unknown one; `where` is its location, such as "a."."""
    missing, unknown = sorted(required - content.keys()), sorted(content.keys() - required - optional)
    if missing:
        raise FileError(path, "missing", where=f"key {where}{missing[0]}", remedy=f"Expected {sorted(required)}")
    if unknown:
        reason = "is unknown"
        raise FileError(path, reason, where=f"key {where}{unknown[0]}", remedy="Remove it if it is not needed")


def check_version(path: str | os.PathLike[str], content: dict[str, Any], class_name: str) -> None:
    """Raise `FileError` if an object of Open3D has another class or version. Missing keys are accepted."""
    for key, expected in (("class_name", class_name), ("version_major", 1), ("version_minor", 0)):
        value = content.get(key, expected)
        if value != expected or isinstance(value, bool):
            raise FileError(path, f"expected {expected!r}, got {str(value)[:40]!r}", where=f"key {key}")


def json_numbers(path: str | os.PathLike[str], values: object, count: int, *, where: str) -> list[float]:
    """A JSON list of numbers. Raises `FileError` unless there are `count` finite ones up to 1e100."""
    if not isinstance(values, list) or len(values) != count:
        given = f"{len(values)}" if isinstance(values, list) else f"a {type(values).__name__}"
        raise FileError(path, f"expected a list of {count} numbers, got {given}", where=where)
    for value in values:
        if isinstance(value, bool) or not isinstance(value, int | float) or abs(value) > LARGEST_NUMBER:
            raise FileError(path, f"expected finite numbers, got {str(value)[:40]!r}", where=where)
    return [float(value) for value in values]


def json_count(path: str | os.PathLike[str], value: object, maximum: int, *, where: str) -> int:
    """A JSON integer from 0 to `maximum`. Raises `FileError`; 1.0 and true are no integers."""
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= maximum:
        raise FileError(path, f"expected an integer from 0 to {maximum:,}, got {str(value)[:40]!r}", where=where)
    return value


def _unique_pairs(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    content = dict(pairs)
    if len(content) != len(pairs):
        counts = Counter(name for name, _ in pairs)
        raise ValueError(f"key {next(name for name, count in counts.items() if count > 1)!r} is given twice")
    return content


def _refuse(constant: str) -> Any:
    raise ValueError(f"{constant} is not a number")


def _bounded(text: str) -> int:
    if len(text) > MAX_DIGITS:
        raise ValueError(f"{text[:40]}... is too large")
    return int(text)


def _finite(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(f"{text[:40]} is too large")
    return value
