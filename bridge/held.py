"""Mutable objects of Open3D over immutable ones of ours: who holds the truth, and how each comes from the other.

`Held` is the base of all. Until an array of it has been handed out, the object of ours is the truth, and what is kept
with it (search trees, ray trees) stays. A vector that was handed out or assigned may be written to at any time without
a call, so it is compared with what it was before each operation, and ours is made anew where it differs. An operation
in place puts the new values into the memory of the vectors that are out, as Open3D's arrays follow its objects.

To write a class: name ours in `_kind`, declare the arrays as `Rows`, and say how ours is read, made and compared
(`_read`, `_made`, `_token`). A method that changes the object returns `self._become(self._ours.method(...))`, one that
gives a new one `Class._of(self._ours.method(...))`; arguments go through `ours`.
"""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import check_shape
from ..core.known_names import KnownNames
from .vectors import Vector


class Rows:
    """An attribute of a `Held` that is a vector or an image: the same object at each reading, written to by all."""

    def __init__(self, kind: Any):
        self.kind = kind

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, held: Any, owner: type) -> Any:
        return self if held is None else held._vector(self.name)

    def __set__(self, held: Held, values: Any) -> None:
        if not isinstance(values, self.kind | np.ndarray):
            module = "utility" if issubclass(self.kind, Vector) else "geometry"
            wanted = f"{module}.{self.kind.__name__}"
            raise TypeError(
                f"{self.name}: expected a {wanted}, got {type(values).__name__}; o3d.{wanted}(values) makes one"
            )
        held._assign(self.name, self.kind(values))


@dataclasses.dataclass
class _HandedOut:
    """A vector that others may write to, and what it held when ours was last brought up to date."""

    vector: Any  # a Vector, or an Image
    was: NDArray[Any]

    def changed(self) -> bool:
        now = self.vector._values
        return now.shape != self.was.shape or not np.array_equal(_bits(now), _bits(self.was))

    def keep(self) -> None:
        self.was = self.vector._values.copy()


class Held(KnownNames):
    """An object of Open3D's kind around one of ours."""

    _kind: ClassVar[Any] = None  # our class
    _held: Any
    _out: dict[str, _HandedOut]

    @classmethod
    def _of(cls, ours: Any) -> Self:
        """The object around one of ours, which is shared, not copied."""
        made = cls.__new__(cls)
        made._held, made._out = ours, {}
        return made

    @property
    def _ours(self) -> Any:
        """Our object, with all that was written to vectors."""
        changed = [name for name, out in self._out.items() if out.changed()]
        if changed:
            self._held = self._made(changed)
            for name in changed:
                self._out[name].keep()
        return self._held

    def _become(self, new: Any) -> Self:
        """Hold what an operation made of `_ours`; vectors that are out follow."""
        old, self._held = self._held, new
        for name, out in self._out.items():
            before, after = self._token(old, name), self._token(new, name)
            if after is None and before is not None:
                out.vector._fill(out.was[:0])
            elif after is not None and (before is None or not _same(before, after)):
                out.vector._fill(self._read(name))
            else:
                continue
            out.keep()
        return self

    # ------------------------------------------------------------------------------- what a class says of its arrays

    def _read(self, name: str) -> NDArray[Any]:
        """The values of an array of `_held`; no rows where it has none."""
        raise NotImplementedError

    def _made(self, changed: list[str]) -> Any:
        """Our object with the vectors `changed` taken over."""
        raise NotImplementedError

    def _token(self, ours: Any, name: str) -> tuple[Any, ...] | None:
        """The same objects, or equal bytes, where an array of ours is the same; None where there is none."""
        raise NotImplementedError

    # ------------------------------------------------------------------------------------------------------- vectors

    def _vector(self, name: str) -> Any:
        if name not in self._out:
            kind = getattr(type(self), name).kind
            vector = kind._around(np.array(self._read(name), kind._dtype))
            self._out[name] = _HandedOut(vector, vector._values.copy())
        return self._out[name].vector

    def _assign(self, name: str, vector: Any) -> None:
        self._vector(name)._fill(vector._values)

    def _count(self, name: str) -> int:
        """How many rows an array has, without bringing ours up to date."""
        return len(self._out[name].vector) if name in self._out else len(self._read(name))

    def __copy__(self) -> Self:
        made = self._of(self._ours)
        made._out = {name: _HandedOut(type(o.vector)(o.vector), o.was.copy()) for name, o in self._out.items()}
        return made

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self.__copy__()

    def __getstate__(self) -> dict[str, Any]:
        return {"ours": self._ours, "out": {name: out.vector for name, out in self._out.items()}}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self._held = state["ours"]
        self._out = {name: _HandedOut(vector, vector._values.copy()) for name, vector in state["out"].items()}


def ours(value: Any, kind: type[Held] | None = None, name: str = "") -> Any:
    """Our object of one of Open3D's kind; of a list of them, theirs. What is ours already, and arrays, pass.

    Args:
        value: A `Held`, an object of ours, anything else.
        kind: The class that is wanted; None for any.
        name: The argument, for the error.

    Raises:
        TypeError: Not of this kind.
    """
    if kind is not None and not isinstance(value, kind) and not isinstance(value, kind._kind or ()):
        said = f"{name}: " if name else ""
        module = type(value).__module__
        found = f"{module}.{type(value).__name__}" if module.startswith("open3d") else type(value).__name__
        raise TypeError(f"{said}expected a {kind.__name__}, got {found}")
    if isinstance(value, Held):
        return value._ours
    if isinstance(value, list | tuple) and any(isinstance(part, Held) for part in value):
        return [ours(part) for part in value]
    return value


def as_array(vector: ArrayLike | Vector) -> NDArray[Any]:
    """The memory of a vector, or of what else NumPy takes."""
    return np.asarray(vector)


def column(name: str, values: Any, count: int = 3) -> NDArray[np.float64]:
    """Some numbers as an array (count,), also those of a column (count, 1), which Open3D takes, too."""
    array = np.asarray(values)
    return check_shape(name, array[:, 0] if array.shape == (count, 1) else values, (count,))


def _bits(values: NDArray[Any]) -> NDArray[Any]:
    """The values as whole numbers, so that NaN equals itself and 0 is not -0."""
    return np.ascontiguousarray(values).view(f"u{values.itemsize}")


def _same(before: tuple[Any, ...], after: tuple[Any, ...]) -> bool:
    """Whether tokens name the same objects, or equal bytes."""
    return all(a is b or (isinstance(a, bytes) and a == b) for a, b in zip(before, after, strict=True))
