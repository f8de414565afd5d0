"""Helpful errors for unknown names: the equivalents of names of other libraries, and the nearest known names."""

from __future__ import annotations

import functools
import sys
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from .name_words import near_names, row_of_words, same_names
from .open3d_names import BRIDGE, COMMON, SHAPES, hint, row_of


def nearest_name(name: object, known: Iterable[str]) -> str:
    """`; did you mean 'colors'?` if known public names have the same words or letters, else "", also for no text."""
    nearest = near_names(name, known) if isinstance(name, str) else ()
    return f"; did you mean {' or '.join(map(repr, nearest))}?" if nearest else ""


class HintedClass(type):
    """Metaclass with helpful errors for unknown class attributes: `TriangleMesh.create_half_edge_mesh`."""

    if not TYPE_CHECKING:  # type checkers detect misspelled names themselves

        def __getattr__(cls, name: str) -> Any:  # called only for missing attributes
            if name in vars(cls).get("__annotations__", ()):  # a field: `dataclass` looks for its default
                raise AttributeError(f"type object {cls.__name__!r} has no attribute {name!r}", name=name, obj=cls)
            raise AttributeError(_message(cls, name), name=name, obj=cls)

    def __dir__(cls) -> list[str]:
        return [name for name in super().__dir__() if name not in internal_names(cls)]


class HintedNames(metaclass=HintedClass):
    """A class with helpful errors for unknown attributes: the equivalent of Open3D's name, or the nearest name.

    Attributes in `_fixed` cannot be reassigned, since others depend on them. Members in `_internal` are for other
    modules of this package: not public, absent from `dir()`, the documentation and hints.
    """

    _fixed: tuple[str, ...] = ()
    _internal: tuple[str, ...] = ()

    def __dir__(self) -> list[str]:
        return [name for name in super().__dir__() if name not in internal_names(type(self))]

    if not TYPE_CHECKING:

        def __setattr__(self, name: str, value: object) -> None:
            if name in self._fixed and name in vars(self):
                raise AttributeError(
                    f"{name}: cannot be changed in an existing {type(self).__name__}; create another one"
                )
            object.__setattr__(self, name, value)

        def __getattr__(self, name: str) -> Any:
            raise AttributeError(_message(type(self), name))


class KnownNames(HintedNames):
    """A class that rejects assignments to undeclared attributes, with the nearest name."""

    _how_to_add = ""  # how to add an attribute, for the error of an unknown one

    if not TYPE_CHECKING:

        def __setattr__(self, name: str, value: object) -> None:
            if (type(self), name) not in _declared and not name.startswith("_") and not _declares(type(self), name):
                raise AttributeError(_message(type(self), name, self._how_to_add.format(name=name)))
            if self._fixed:
                super().__setattr__(name, value)
            else:
                object.__setattr__(self, name, value)


@functools.lru_cache(1024)
def internal_names(kind: type) -> frozenset[str]:
    """Members of a class that only other modules of this package use: those in `_internal` of it and its bases."""
    return frozenset(name for base in kind.__mro__ for name in vars(base).get("_internal", ()))


_declared: set[tuple[type, str]] = set()  # cache of (class, name): a declared name stays declared


def _declares(kind: type, name: str) -> bool:
    declared = any(name in vars(base) or name in _annotated(base) for base in kind.__mro__)
    declared = declared and name not in internal_names(kind)
    if declared:
        _declared.add((kind, name))
    return declared


@functools.lru_cache(256)
def _annotated(kind: type) -> frozenset[str]:
    if sys.version_info >= (3, 14):
        from annotationlib import Format, get_annotations

        return frozenset(get_annotations(kind, format=Format.FORWARDREF))
    return frozenset(vars(kind).get("__annotations__", ()))


@functools.lru_cache(1024)
def _message(kind: type, name: str, how_to_add: str = "") -> str:
    message = f"{kind.__name__} has no attribute {name!r}"
    if name.startswith("_"):
        return message
    classes = [base.__name__ for base in kind.__mro__]
    own = [f"{BRIDGE}.{each}" for each in classes] if _in_bridge(kind) else []
    is_shape = any("get_center" in vars(base) for base in kind.__mro__)
    common = [f"{COMMON}.{each}" for each in (*classes, *(["Shape"] if is_shape else []))]
    rows = (*own, *classes, SHAPES, *([] if own else common))
    row = hint(row_of(name, rows))
    fields = [field for base in kind.__mro__ for field in _annotated(base)]  # dir() lacks fields without a default
    known = [other for other in {*dir(kind), *fields} - internal_names(kind) if not other.startswith("_")]
    if not row and not same_names(name, known):
        row = hint(row_of_words(name, rows)) or _elsewhere(kind, name)
    near = "" if row else nearest_name(name, sorted(known))
    if how_to_add:
        return message + (f"{row}; {how_to_add}" if row else f"{near} {how_to_add}" if near else f"; {how_to_add}")
    return message + (row or near)


def _in_bridge(kind: type) -> bool:
    """True for the classes of `pointloom.open3d`."""
    return ".open3d." in kind.__module__


def _elsewhere(kind: type, name: str) -> str:
    """`; it is loom.classify_ground` for a function of a module, `; TriangleMesh has it` for other classes, or ""."""
    from ..public_names import function_named  # lists of names, read only for errors

    return ("" if _in_bridge(kind) else function_named(name)) or _others(kind, name)


def _others(kind: type, name: str) -> str:
    """`; TriangleMesh has it` if other loaded classes have the name: of pointloom, or of `pointloom.open3d`."""
    names, waiting = set(), [HintedNames]
    while waiting:
        base = waiting.pop()
        waiting += base.__subclasses__()
        is_other = base is not kind and not base.__name__.startswith("_") and _in_bridge(base) == _in_bridge(kind)
        if is_other and not base.__subclasses__() and name not in internal_names(base):
            names |= {base.__name__} if any(name in vars(parent) for parent in base.__mro__) else set()
    return f"; {' and '.join(sorted(names))} {'have' if len(names) > 1 else 'has'} it" if names else ""
