"""Mutable mappings of the attributes of vertices and triangles."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, MutableMapping
from typing import Any

import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import owned, shared_view
from ...core.checks import check_name, shown
from ...core.escaped_text import escaped
from ...kernels.arrays.select import gather_rows
from ...pcd.attribute_columns import upload_column
from ...pcd.point_store import ArrayStore
from ...pcd.stored_arrays import read_only

Arrays = dict[str, wp.array]


class MeshAttributes(MutableMapping[str, NDArray[Any]]):
    """Read-only NumPy attributes of shape (n,) or (n, c) by name, n the mesh's vertices or triangles. Assignment
    accepts numbers of up to 64 bits and booleans, and keeps the type."""

    def __init__(self, store: ArrayStore, arrays: Arrays, count: int, of: str, fields: tuple[str, ...]):
        self._store, self._arrays, self._count, self._of, self._fields = store, arrays, count, of, fields

    def __getitem__(self, name: str) -> NDArray[Any]:
        return read_only(owned(self._arrays[name]))

    def __setitem__(self, name: str, values: ArrayLike) -> None:
        if check_name("name", name) in self._fields:
            raise KeyError(f"{name}: not a custom attribute. Assign mesh.{name}")
        self._arrays[name] = upload_column(name, values, self._count, self._store.device, of=self._of)

    def __delitem__(self, name: str) -> None:
        del self._arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter(list(self._arrays))

    def __len__(self) -> int:
        return len(self._arrays)

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{name!r}: {values.dtype} {list(values.shape)}" for name, values in self.items()) + "}"

    def _ipython_key_completions_(self) -> list[str]:
        return list(self)

    @property
    def name(self) -> str:
        """ "vertex_attributes" or "triangle_attributes"."""
        return "vertex_attributes" if self._of == "vertices" else "triangle_attributes"

    @property
    def arrays(self) -> Arrays:
        return dict(self._arrays)

    def array(self, name: str) -> Any:
        """Shared array of an attribute, as of `TriangleMesh.array`. KeyError if missing."""
        return shared_view(self._arrays[name], self._store.library)


def assign_all(attributes: MeshAttributes, given: Mapping[str, Any] | None) -> None:
    """Assign a mapping. TypeError if it is none. None assigns nothing."""
    if given is not None and not isinstance(given, Mapping):
        raise TypeError(f"{attributes.name}: expected arrays by name, got {shown(given)}")
    for name, values in (given or {}).items():
        attributes[name] = values


def each(arrays: Arrays, change: Callable[[wp.array], Any]) -> dict[str, Any]:
    return {name: change(values) for name, values in arrays.items()}


def rows_of(arrays: Arrays, rows: wp.array) -> dict[str, Any]:
    return each(arrays, lambda values: gather_rows(values, rows))


def listed(names: Iterable[str]) -> str:
    """Names in one line of text, without control characters."""
    return escaped(", ".join(names))
