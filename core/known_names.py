"""Objects that take no attribute but those they have: a misspelt name is an error, not a new attribute."""

from __future__ import annotations

import functools
import sys
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

OPEN3D_NAMES = "docs/open3d.md says what Open3D's names are here"


def nearest_name(name: str, known: Iterable[str]) -> str:
    """`; did you mean 'colors'?` where a known public name is like this one, else nothing."""
    from difflib import get_close_matches  # only errors pay for it

    found = get_close_matches(name, [other for other in known if not other.startswith("_")], n=1, cutoff=0.6)
    return f"; did you mean {found[0]!r}?" if found else ""


class KnownNames:
    """A class whose objects have no attribute that it does not declare: reading or setting one names the nearest."""

    _how_to_add = ""  # what else who sets an unknown attribute may have meant

    if not TYPE_CHECKING:  # which finds misspelt names by itself

        def __setattr__(self, name: str, value: Any) -> None:
            if not name.startswith("_") and not _declares(type(self), name):
                raise AttributeError(_message(self, name, self._how_to_add.format(name=name)))
            object.__setattr__(self, name, value)

        def __getattr__(self, name: str) -> Any:  # asked only where there is none
            raise AttributeError(_message(self, name, "" if name.startswith("_") else OPEN3D_NAMES))


def _declares(kind: type, name: str) -> bool:
    return any(name in vars(base) or name in _annotated(base) for base in kind.__mro__)


@functools.lru_cache(256)
def _annotated(kind: type) -> frozenset[str]:
    """The names that a class itself annotates, whatever their types."""
    if sys.version_info >= (3, 14):
        from annotationlib import Format, get_annotations

        return frozenset(get_annotations(kind, format=Format.FORWARDREF))
    return frozenset(vars(kind).get("__annotations__", ()))


def _message(owner: Any, name: str, remedy: str) -> str:
    kind = type(owner)
    near = nearest_name(name, dir(kind))
    return f"{kind.__name__} has no attribute {name!r}{near}" + (f"{' ' if near else '; '}{remedy}" if remedy else "")
