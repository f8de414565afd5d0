"""The further attributes of a cloud as a mapping: what is set or deleted there is set or deleted in the cloud."""

from __future__ import annotations

from collections.abc import Iterator, MutableMapping
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from .point_arrays import PointArrays

VECTORS = ("points", "normals", "colors")


class Attributes(MutableMapping[str, NDArray[Any]]):
    """Attributes by name, as read-only NumPy arrays of shape [n] or [n, c]: all but points, normals and colours."""

    def __init__(self, cloud: PointArrays):
        self._cloud = cloud

    def __getitem__(self, name: str) -> NDArray[Any]:
        if name in VECTORS or name not in self._cloud:
            raise KeyError(name)
        return self._cloud[name]

    def __setitem__(self, name: str, values: ArrayLike) -> None:
        if name in VECTORS:
            raise KeyError(f"{name}: assign cloud.{name}")
        self._cloud[name] = values

    def __delitem__(self, name: str) -> None:
        if name in VECTORS or name not in self._cloud:
            raise KeyError(name)
        del self._cloud._arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter([name for name in self._cloud._arrays if name not in VECTORS])

    def __len__(self) -> int:
        return sum(name not in VECTORS for name in self._cloud._arrays)

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{name!r}: {values.dtype} {list(values.shape)}" for name, values in self.items()) + "}"
