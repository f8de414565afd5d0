"""Names under which formats hold attributes, by one rule for all formats.

A character that a format cannot hold becomes "_". A name that is empty, too long, in use, or would be read as something
else is cut where it is too long and gets "_2", "_3", ... at its end. Names that a format can hold stay as they are.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, field
from itertools import count
from typing import Any

from numpy.typing import NDArray

from ..core.escaped_text import escaped


@dataclass(frozen=True)
class NameRules:
    """What a format allows as names.

    Attributes:
        holds: True for a character that names may have.
        used: Names that the format has for something else.
        roles: Names that are read as something else if all of a tuple are there.
        max_bytes: Of a name in UTF-8.
        in_parts: True if an attribute of shape (n, c) is written as `name_0`, `name_1`, ...
        instead: Names of attributes whose values the format cannot hold under their own name, and the names to try.
    """

    holds: Callable[[str], bool]
    used: Collection[str] = ()
    roles: Sequence[tuple[str, ...]] = ()
    max_bytes: int | None = None
    in_parts: bool = True
    instead: dict[str, str] = field(default_factory=dict)


def is_word(character: str) -> bool:
    """True for printable ASCII but the blank: what headers of text hold."""
    return "!" <= character <= "~"


def new_names(attributes: dict[str, NDArray[Any]], rules: NameRules) -> dict[str, str]:
    """The names of attributes that have to be renamed, and their new ones."""
    used, later = {*rules.used}, []
    renamed = {}
    for name, values in attributes.items():
        wanted = rules.instead.get(name, name)
        parts = _parts(wanted, values, rules)
        if wanted != name or _clean(wanted, rules, 0) != wanted or _is_taken(parts, used, rules):
            later.append((name, wanted, values))
        else:
            used |= parts
    for name, wanted, values in later:
        tries = (_with_number(wanted, number, values, rules) for number in count(1))
        new = next(new for new in tries if not _is_taken(_parts(new, values, rules), used, rules))
        used |= _parts(new, values, rules)
        renamed[name] = new
    return renamed


def _with_number(name: str, number: int, values: NDArray[Any], rules: NameRules) -> str:
    """A name in the format's characters and bytes, with a number at its end from 2 on."""
    end = "" if number == 1 else f"_{number}"
    longest = max((len(part) for part in _parts("", values, rules)), default=0)
    return _clean(name, rules, longest + len(end)) + end


def warn_of_names(path: Any, reason: str, renamed: dict[str, str], *, stacklevel: int = 3) -> None:
    """Warn that attributes have other names than they had."""
    told = ", ".join(f"{old!r} as {new!r}" for old, new in renamed.items())
    message = f"{path}: attributes are {reason}: {told}"
    warnings.warn(escaped(message), UserWarning, stacklevel=stacklevel + 1)


def rename(
    path: Any, format: str, attributes: dict[str, NDArray[Any]], rules: NameRules, *, stacklevel: int = 3
) -> dict[str, NDArray[Any]]:
    """The attributes under names that a format can hold; warns of those that have other names then."""
    renamed = new_names(attributes, rules)
    if not renamed:
        return attributes
    reason = f"written under other names, since {format} cannot hold them under their own"
    warn_of_names(path, reason, renamed, stacklevel=stacklevel + 1)
    return {renamed.get(name, name): values for name, values in attributes.items()}


def _parts(name: str, values: NDArray[Any], rules: NameRules) -> set[str]:
    if not rules.in_parts or values.ndim < 2:
        return {name}
    return {f"{name}_{k}" for k in range(values.shape[1])}


def _is_taken(parts: Iterable[str], used: set[str], rules: NameRules) -> bool:
    parts = {*parts}
    together = used | parts
    return bool(parts & used) or any(parts & {*role} and {*role} <= together for role in rules.roles)


def _clean(name: str, rules: NameRules, reserved: int) -> str:
    """A name in the format's characters, which leaves so many bytes for what is put behind it."""
    name = "".join(letter if rules.holds(letter) else "_" for letter in name) or "_"
    if rules.max_bytes is None:
        return name
    return name.encode()[: rules.max_bytes - reserved].decode(errors="ignore")
