"""Mutable Open3D objects over immutable pointloom objects, with `Wrapper` as base class.

Until an array has been handed out, the pointloom object is authoritative and its caches (search trees) are kept. A
handed out or assigned vector may be written to at any time, so before each operation it is compared with its last known
content, and a new pointloom object is made if it differs. In-place operations write into the memory of these vectors,
as Open3D's arrays follow its objects.

To write a class: set `_kind`, declare arrays as `Rows`, and implement `_read`, `_made` and `_token`. Mutating methods
return `self._become(self.native.method(...))`, others `Class.from_native(self.native.method(...))`. Arguments go
through `unwrap`.
"""

from __future__ import annotations

import dataclasses
import functools
import inspect
from collections.abc import Callable
from typing import Any, ClassVar, Generic, ParamSpec, Self, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.attribute_hints import KnownNames
from ..core.checks import check_shape
from .vectors import Vector

P = ParamSpec("P")
W = TypeVar("W", bound="Wrapper")
IDENTITY_POSE = np.eye(4)  # default of poses, which no function changes


class Rows:
    """A vector or image attribute of a `Wrapper`: the same object at each access."""

    def __init__(self, kind: Any):
        self.kind = kind

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, instance: Any, owner: type) -> Any:
        return self if instance is None else instance.vector(self.name)

    def __set__(self, instance: Wrapper, values: object) -> None:
        if not isinstance(values, self.kind | np.ndarray):
            module = "utility" if issubclass(self.kind, Vector) else "geometry"
            wanted = f"{module}.{self.kind.__name__}"
            raise TypeError(
                f"{self.name}: expected a {wanted}, got {type(values).__name__}; o3d.{wanted}(values) makes one"
            )
        instance.assign(self.name, self.kind(values))


@dataclasses.dataclass
class _SharedVector:
    """A vector that others may write to, and its last known content."""

    vector: Any  # a Vector or an Image
    was: NDArray[Any]

    def changed(self) -> bool:
        now = np.asarray(self.vector)
        return now.shape != self.was.shape or not np.array_equal(_bits(now), _bits(self.was))

    def keep(self) -> None:
        self.was = np.array(self.vector)


class Wrapper(KnownNames):
    """An Open3D object around a pointloom object."""

    _internal = ("native_kind", "vector", "assign")

    _kind: ClassVar[Any] = None  # the pointloom class
    _wrapped: Any
    _shared: dict[str, _SharedVector]

    @classmethod
    def native_kind(cls) -> Any:
        """The pointloom class, or None."""
        return cls._kind

    @classmethod
    def from_native(cls, native: Any) -> Self:
        """Wrap a pointloom object without a copy."""
        made = cls.__new__(cls)
        vars(made).update(_wrapped=native, _shared={})
        return made

    @property
    def native(self) -> Any:
        """The pointloom object, updated from the vectors."""
        changed = [name for name, shared in self._shared.items() if shared.changed()]
        if changed:
            self._wrapped = self._made(changed)
            for name in changed:
                self._shared[name].keep()
        return self._wrapped

    def _become(self, new: Any) -> Self:
        """Replace the object by a result and update the handed out vectors."""
        old, self._wrapped = self._wrapped, new
        for name, shared in self._shared.items():
            before, after = self._token(old, name), self._token(new, name)
            if after is None and before is not None:
                shared.vector.refill(shared.was[:0])
            elif after is not None and (before is None or not _same(before, after)):
                shared.vector.refill(self._read(name))
            else:
                continue
            shared.keep()
        self._follow(old, new)
        return self

    def _follow(self, old: Any, new: Any) -> None:
        """Called after a result has replaced the object."""

    def _read(self, name: str) -> NDArray[Any]:
        """Values of an array of `_wrapped`. Empty if it has none."""
        raise NotImplementedError

    def _made(self, changed: list[str]) -> Any:
        """A new object with the vectors `changed`."""
        raise NotImplementedError

    def _token(self, native: Any, name: str) -> tuple[Any, ...] | None:
        """Identity (objects or bytes) of an array for comparison. None if there is none."""
        raise NotImplementedError

    def vector(self, name: str) -> Any:
        """The vector or image of an array, which the caller may write to."""
        if name not in self._shared:
            vector = getattr(type(self), name).kind.from_array(self._read(name))
            self._shared[name] = _SharedVector(vector, np.array(vector))
        return self._shared[name].vector

    def assign(self, name: str, values: ArrayLike | Vector) -> None:
        """Write values into the vector of an array."""
        self.vector(name).refill(np.asarray(values))

    def _count(self, name: str) -> int:
        """Number of rows of an array, without an update."""
        return len(self._shared[name].vector) if name in self._shared else len(self._read(name))

    def __copy__(self) -> Self:
        made = self.from_native(self.native)
        for name, shared in self._shared.items():
            vars(made)["_shared"][name] = _SharedVector(type(shared.vector)(shared.vector), shared.was.copy())
        return made

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self.__copy__()

    def __getstate__(self) -> dict[str, Any]:
        return {"ours": self.native, "out": {name: shared.vector for name, shared in self._shared.items()}}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self._wrapped = state["ours"]
        self._shared = {name: _SharedVector(vector, np.array(vector)) for name, vector in state["out"].items()}


class PlainWrapper(Wrapper):
    """A wrapper without vectors, whose state is that of its attributes."""

    def __getstate__(self) -> dict[str, Any]:
        return dict(vars(self))

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)


class Forwarded(Generic[P]):
    """A factory of a pointloom class. Its signature shows Open3D's parameters: all but the keyword-only ones."""

    def __init__(self, factory: Callable[P, Any]):
        self.factory, parameters = factory, inspect.signature(factory).parameters.values()
        self.signature = inspect.Signature([p for p in parameters if p.kind is not p.KEYWORD_ONLY])

    def __get__(self, instance: object, owner: type[W]) -> Callable[P, W]:
        @functools.wraps(self.factory)
        def make(*args: P.args, **keywords: P.kwargs) -> W:
            return owner.from_native(self.factory(*args, **keywords))

        make.__signature__ = self.signature  # type: ignore[attr-defined]
        return make


def unwrap(value: object, kind: type[Wrapper] | None = None, name: str = "") -> Any:
    """Unwrap a `Wrapper`, or a list of them. Pointloom objects and arrays are returned unchanged.

    Raises TypeError if it is not of type `kind`; `name` is the argument's name for the message.
    """
    if kind is not None and not isinstance(value, kind) and not isinstance(value, kind.native_kind() or ()):
        prefix = f"{name}: " if name else ""
        module = type(value).__module__
        given = f"{module}.{type(value).__name__}" if module.startswith("open3d") else type(value).__name__
        raise TypeError(f"{prefix}expected a {kind.__name__}, got {given}{_remedy_of(value, kind)}")
    if isinstance(value, Wrapper):
        return value.native
    if isinstance(value, list | tuple) and any(isinstance(part, Wrapper) for part in value):
        return [unwrap(part) for part in value]
    return value


def _remedy_of(value: object, kind: type[Wrapper]) -> str:
    """How to make a cloud of a mesh, or a mesh of a cloud, as the end of a message, or ""."""
    if kind.__name__ == "PointCloud" and hasattr(value, "sample_points_uniformly"):
        return "; mesh.sample_points_uniformly(100_000) returns one, PointCloud(mesh.vertices) that of its vertices"
    if kind.__name__ == "TriangleMesh" and hasattr(value, "estimate_normals"):
        return "; TriangleMesh.create_from_point_cloud_poisson(pcd) makes one of a cloud"
    return ""


def as_array(vector: ArrayLike | Vector) -> NDArray[Any]:
    """The memory of a vector or array-like."""
    return np.asarray(vector)


def column(name: str, values: Any, count: int = 3) -> NDArray[np.float64]:
    """Numbers as an array (count,), also from a column (count, 1), as Open3D accepts."""
    array = np.asarray(values)
    return check_shape(name, array[:, 0] if array.shape == (count, 1) else values, (count,))


def _bits(values: NDArray[Any]) -> NDArray[Any]:
    """The bits as integers, so that NaN equals itself and 0 differs from -0."""
    return np.ascontiguousarray(values).view(f"u{values.itemsize}")


def _same(before: tuple[Any, ...], after: tuple[Any, ...]) -> bool:
    """True if tokens are the same objects or equal bytes."""
    return all(a is b or (isinstance(a, bytes) and a == b) for a, b in zip(before, after, strict=True))
