"""Attribute names for file formats.

Unsupported characters become "_". Names that are empty, too long, in use or ambiguous are cut and get the suffix "_2",
"_3", ...
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, field
from itertools import count
from typing import Any

from numpy.typing import NDArray

from ..core.errors import FilePath
from ..core.escaped_text import escaped


@dataclass(frozen=True)
class NameRules:
    """The names that a format allows: characters (`is_allowed`), reserved names (`used`) and bytes in UTF-8
    (`max_bytes`).
    `roles` are tuples of names with another meaning if all are present. `in_parts` writes an attribute (n, c) with
    `split_columns`. `instead` gives alternative names for attributes whose values do not fit under their own."""

    is_allowed: Callable[[str], bool]
    used: Collection[str] = ()
    roles: Sequence[tuple[str, ...]] = ()
    max_bytes: int | None = None
    in_parts: bool = True
    instead: dict[str, str] = field(default_factory=dict)


def is_word(character: str) -> bool:
    """True for printable ASCII except the blank."""
    return "!" <= character <= "~"


def new_names(attributes: dict[str, NDArray[Any]], rules: NameRules) -> dict[str, str]:
    used, deferred = {*rules.used}, []
    renamed = {}
    for name, values in attributes.items():
        wanted = rules.instead.get(name, name)
        parts = _parts(wanted, values, rules)
        if wanted != name or _clean(wanted, rules, 0) != wanted or _is_taken(parts, used, rules):
            deferred.append((name, wanted, values))
        else:
            used |= parts
    numbers: dict[tuple[Any, ...], int] = {}  # the first that may be free for names that become equal
    for name, wanted, values in deferred:
        key = _clean(wanted, rules, 0), values.shape[1:]
        tries = ((number, _with_number(wanted, number, values, rules)) for number in count(numbers.get(key, 1)))
        free = ((k, new) for k, new in tries if not _is_taken(_parts(new, values, rules), used, rules))
        numbers[key], renamed[name] = next(free)
        used |= _parts(renamed[name], values, rules)
    return renamed


def _with_number(name: str, number: int, values: NDArray[Any], rules: NameRules) -> str:
    """A valid name with a number suffix from 2 on."""
    end = "" if number == 1 else f"_{number}"
    longest = max((len(part) for part in _parts("", values, rules)), default=0)
    return _clean(name, rules, longest + len(end)) + end


def warn_of_names(path: FilePath, reason: str, renamed: dict[str, str], *, stacklevel: int = 3) -> None:
    pairs = ", ".join(f"{old!r} as {new!r}" for old, new in renamed.items())
    message = f"{path}: attributes are {reason}: {pairs}"
    warnings.warn(escaped(message), UserWarning, stacklevel=stacklevel + 1)


def rename(
    path: FilePath, format: str, attributes: dict[str, NDArray[Any]], rules: NameRules, *, stacklevel: int = 3
) -> dict[str, NDArray[Any]]:
    """The attributes with valid names. Warns of changes."""
    renamed = new_names(attributes, rules)
    if not renamed:
        return attributes
    reason = f"written under other names, because {format} cannot store their own"
    warn_of_names(path, reason, renamed, stacklevel=stacklevel + 1)
    return {renamed.get(name, name): values for name, values in attributes.items()}


def _parts(name: str, values: NDArray[Any], rules: NameRules) -> set[str]:
    if not rules.in_parts or values.ndim < 2:
        return {name}
    return {*split_columns(name, values)}


def split_columns(name: str, values: NDArray[Any]) -> dict[str, NDArray[Any]]:
    """The columns of an attribute (n,) or (n, c) by name: `name_0`, `name_1`, ..., or `name` if there is only one."""
    columns = {name: values} if values.ndim == 1 else {f"{name}_{k}": part for k, part in enumerate(values.T)}
    return {name: next(iter(columns.values()))} if len(columns) == 1 else columns


def _is_taken(parts: Iterable[str], used: set[str], rules: NameRules) -> bool:
    parts = {*parts}
    if not parts.isdisjoint(used):
        return True
    return any(
        not parts.isdisjoint(role) and all(name in parts or name in used for name in role) for role in rules.roles
    )


def _clean(name: str, rules: NameRules, reserved: int) -> str:
    """A valid name that leaves `reserved` bytes for a suffix."""
    name = "".join(letter if rules.is_allowed(letter) else "_" for letter in name) or "_"
    if rules.max_bytes is None:
        return name
    return name.encode()[: rules.max_bytes - reserved].decode(errors="ignore")
