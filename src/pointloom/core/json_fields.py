"""Checks of the fields of a JSON object from an untrusted file."""

from __future__ import annotations

import re
from collections.abc import Callable, Container
from dataclasses import MISSING, fields
from functools import partial
from types import NoneType, UnionType
from typing import Any, TypeGuard, get_args, get_origin, get_type_hints

from .checks import check_rigid, shown

MAX_NUMBER = 1e300  # sums of numbers stay finite

# A null character, and halves of surrogate pairs but those of file names that are not UTF-8 (PEP 383).
_NO_TEXT = re.compile("[\0\ud800-\udc7f\udd00-\udfff]")

Check = Callable[[Any], bool]
Checks = dict[str, Check]  # by field of a JSON object


def is_number(value: object) -> TypeGuard[float]:
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= MAX_NUMBER


def is_count(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 2**63


def is_text(value: object) -> TypeGuard[str]:
    return isinstance(value, str) and not _NO_TEXT.search(value)


def is_list(value: object) -> bool:
    return isinstance(value, list)


def is_flag(value: object) -> bool:
    return isinstance(value, bool)


def is_positive(value: object) -> bool:
    return is_number(value) and value > 0


def numbers(count: int) -> Check:
    return list_of(is_number, count)


def list_of(check: Check, count: int | None = None) -> Check:
    return lambda value: isinstance(value, list) and count in (None, len(value)) and all(map(check, value))


def optional(check: Check) -> Check:
    return lambda value: value is None or check(value)


def below(count: int) -> Check:
    """Check an index of `count` items."""
    return lambda value: is_count(value) and value < count


def has_fields(checks: Checks, may_lack: Container[str] = ()) -> Check:
    return lambda value: (
        isinstance(value, dict)
        and all(checks[name](value[name]) if name in value else name in may_lack for name in checks)
    )


def is_object(value: object) -> bool:
    return isinstance(value, dict)


def record_of(kind: type) -> Check:
    """Check the fields of a dataclass as JSON: NaN is None, fields with a default may be missing."""
    checks = {name: _check_of(hint) for name, hint in get_type_hints(kind).items()}
    return has_fields(checks, [each.name for each in fields(kind) if each.default is not MISSING])


def _check_of(hint: Any) -> Check:
    if isinstance(hint, UnionType):
        return optional(_check_of(next(part for part in get_args(hint) if part is not NoneType)))
    if get_origin(hint) is tuple:
        return list_of(_check_of(get_args(hint)[0]))
    return _PLAIN[hint] if hint in _PLAIN else record_of(hint)


def row_of(*checks: Check) -> Check:
    """Check a list with one check per value."""
    return lambda value: (
        isinstance(value, list)
        and len(value) == len(checks)
        and all(check(each) for check, each in zip(checks, value, strict=True))
    )


def all_of(*checks: Check) -> Check:
    return lambda value: all(check(value) for check in checks)


def is_pose(value: object) -> bool:
    """True for the rows of a rigid 4x4 matrix."""
    return list_of(list_of(is_number, 4), 4)(value) and builds(partial(check_rigid, "pose"))(value)


def is_ascending(value: object) -> bool:
    """True for a list of integers >= 0 in ascending order, each once."""
    return isinstance(value, list) and all(map(is_count, value)) and value == sorted(set(value))


def builds(make: Callable[[Any], object]) -> Check:
    """Check that a constructor accepts a value."""

    def is_right(value: object) -> bool:
        try:
            make(value)
        except (TypeError, ValueError, LookupError, AttributeError, ArithmeticError):
            return False
        return True

    return is_right


def check_fields(what: str, table: Any, checks: Checks) -> None:
    """Raise ValueError for the first missing or invalid field of a JSON object."""
    if not isinstance(table, dict):
        raise ValueError(f"{what}: expected an object, got {shown(table)}")
    for name, is_right in checks.items():
        if name not in table:
            raise ValueError(f"{what}: {name} is missing")
        if not is_right(table[name]):
            raise ValueError(f"{what}: {name} is {shown(table[name])}")


_PLAIN: dict[Any, Check] = {int: is_count, float: optional(is_number), str: is_text, bool: is_flag}
