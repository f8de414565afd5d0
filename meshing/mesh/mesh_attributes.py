"""The attributes of a mesh's vertices and of its triangles as mappings: to set an item there sets the mesh's."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, MutableMapping
from typing import Any

import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import NUMPY, library_of
from ...core.checks import check_name, check_numeric, is_on_gpu, shown
from ...core.escaped_text import escaped
from ...core.gpu_arrays import take_column
from ...kernels.arrays.select import gather_rows
from ...kernels.memory import download, upload
from ...pcd.point_arrays import read_only

Arrays = dict[str, wp.array]


class MeshAttributes(MutableMapping[str, NDArray[Any]]):
    """Attributes by name, as read-only NumPy arrays of shape [n] or [n, c], n the mesh's vertices or its triangles.

    Assigning takes numbers of any type of up to 64 bits, booleans among them, and keeps the type.

    Example:
        >>> import pointloom as loom
        >>> mesh = loom.TriangleMesh.create_box()
        >>> mesh.triangle_attributes["label"] = range(12)
        >>> mesh.remove_triangles_by_index([0, 1]).triangle_attributes["label"][0]
        np.int64(2)
    """

    def __init__(self, arrays: Arrays, count: int, device: Any, of: str, fields: tuple[str, ...]):
        self._arrays, self._count, self._device, self._of, self._fields = arrays, count, device, of, fields

    def __getitem__(self, name: str) -> NDArray[Any]:
        return read_only(download(self._arrays[name]).copy())

    def __setitem__(self, name: str, values: ArrayLike) -> None:
        if check_name("name", name) in self._fields:
            raise KeyError(f"{name}: assign mesh.{name}")
        self._arrays[name] = self._taken(name, values)

    def __delitem__(self, name: str) -> None:
        del self._arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter(list(self._arrays))

    def __len__(self) -> int:
        return len(self._arrays)

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{name!r}: {values.dtype} {list(values.shape)}" for name, values in self.items()) + "}"

    @property
    def name(self) -> str:
        """What the mesh calls it: "vertex_attributes" or "triangle_attributes"."""
        return "vertex_attributes" if self._of == "vertices" else "triangle_attributes"

    @property
    def arrays(self) -> Arrays:
        """The device arrays by name."""
        return dict(self._arrays)

    def array(self, name: str) -> wp.array:
        """The device array of an attribute, shared without a copy.

        Raises:
            KeyError: There is no such attribute.
        """
        return self._arrays[name]

    def _taken(self, name: str, values: Any) -> wp.array:
        if is_on_gpu(values):
            return take_column(name, values, self._device, self._count)
        column = check_numeric(name, values)
        if column.ndim not in (1, 2) or len(column) != self._count:
            expected = f"[{self._count}] or [{self._count}, c], one row a {self._of}"
            raise ValueError(f"{name}: expected shape {expected}, got {list(column.shape)}")
        if column.dtype.itemsize > 8:
            raise TypeError(f"{name}: expected numbers of 64 bits at most, got {column.dtype}")
        kind = wp.dtype_from_numpy(column.dtype.newbyteorder("="))
        return upload(column, kind, self._device, copied=library_of(values) == NUMPY)


def assign_all(attributes: MeshAttributes, given: Mapping[str, Any] | None) -> None:
    """Set what was given; nothing where that is None.

    Raises:
        TypeError: It is no mapping.
    """
    if given is not None and not isinstance(given, Mapping):
        raise TypeError(f"{attributes.name}: expected arrays by name, got {shown(given)}")
    for name, values in (given or {}).items():
        attributes[name] = values


def each(arrays: Arrays, change: Callable[[wp.array], Any]) -> dict[str, Any]:
    """All arrays, changed."""
    return {name: change(values) for name, values in arrays.items()}


def rows_of(arrays: Arrays, rows: wp.array) -> dict[str, Any]:
    """The rows of all arrays, by an int32 device array."""
    return each(arrays, lambda values: gather_rows(values, rows))


def listed(names: Iterable[str]) -> str:
    """Names in one line of text, without control characters."""
    return escaped(", ".join(names))
