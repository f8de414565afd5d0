"""The vectors of `utility`: growing arrays whose memory `np.asarray` shares."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from ..core.attribute_hints import HintedNames
from ..core.masked_arrays import unmasked


class Vector(HintedNames):
    """Rows of one type; `np.asarray(vector)` is its memory, and writing to it changes the vector.

    As in Open3D, an array taken before the length changed keeps the old rows.
    """

    _internal = ("refill",)

    _row: ClassVar[tuple[int, ...]] = ()  # shape of an element
    _dtype: ClassVar[Any] = np.float64
    _element: ClassVar[str] = ""  # name printed by Open3D
    _array: NDArray[Any]
    _tail: list[Any]  # appended since the last access

    def __init__(self, values: ArrayLike | Vector = ()):
        self._array, self._tail = self._rows(values).copy(), []

    @classmethod
    def from_array(cls, values: NDArray[Any]) -> Self:
        """A vector of a copy of values of the right shape."""
        vector = cls()
        vector.refill(values)
        return vector

    @property
    def _values(self) -> NDArray[Any]:
        if self._tail:
            self._array = np.concatenate([self._array, self._rows(self._tail)])
            self._tail = []
        return self._array

    def refill(self, values: NDArray[Any]) -> None:
        """Replace the values, in the same memory if they fit."""
        if self._values.shape == values.shape:
            self._array[...] = values
        else:
            self._array = np.array(values, self._dtype)

    def _rows(self, values: object) -> NDArray[Any]:
        kind = type(self).__name__
        if isinstance(values, Iterable) and not isinstance(values, str | Sequence) and not hasattr(values, "__array__"):
            values = list(values)  # a set, a generator
        rows = np.asarray(unmasked(kind, values))
        if self._row and rows.shape[1:] == (*self._row, 1):  # columns
            rows = rows[..., 0]
        if rows.size == 0 and rows.ndim <= 1:
            return np.zeros((0, *self._row), self._dtype)
        if rows.dtype.kind not in "biuf":
            raise TypeError(f"{kind}: expected numbers, got {rows.dtype}")
        if rows.shape[1:] != self._row or rows.ndim == 0:
            swapped = rows.ndim == 2 and rows.T.shape[1:] == self._row
            remedy = "; array.T has this shape" if swapped else ""
            raise ValueError(
                f"{kind}: expected shape {['n', *self._row]}, got {list(rows.shape)}{remedy}".replace("'", "")
            )
        if not self._row and self._dtype == np.int32 and rows.dtype.kind == "f":
            raise TypeError(f"{kind}: expected integers, got {rows.dtype}")
        return rows.astype(self._dtype)

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """The memory itself, or a copy. NumPy converts to `dtype`."""
        return self._values.copy() if copy else self._values

    def __len__(self) -> int:
        return len(self._array) + len(self._tail)

    def __bool__(self) -> bool:
        return len(self) > 0

    def __iter__(self) -> Iterator[Any]:
        return iter(self._values if self._row else self._values.tolist())

    def __getitem__(self, index: Any) -> Any:
        values = self._values[index]
        if isinstance(index, slice):
            return type(self)(values)
        return values.item() if isinstance(values, np.generic) and not self._row else values

    def __setitem__(self, index: Any, value: Any) -> None:
        row = np.asarray(value)
        self._values[index] = row[..., 0] if self._row and row.shape == (*self._row, 1) else row

    def __delitem__(self, index: Any) -> None:
        self._array = np.delete(self._values, index, axis=0)

    def __contains__(self, value: Any) -> bool:
        return self.count(value) > 0

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return np.array_equal(self._values, np.asarray(other))

    __hash__ = None  # type: ignore[assignment]  # vectors compare by value

    def __repr__(self) -> str:
        if not self._row:
            return f"{type(self).__name__}[{', '.join(f'{value:.6g}' for value in self)}]"
        return f"std::vector<{self._element}> with {len(self)} elements.\nUse numpy.asarray() to access data."

    def __copy__(self) -> Self:
        return type(self)(self._values)

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return type(self)(self._values)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._values,)

    def append(self, x: Any) -> None:
        self._tail.append(self._rows([x])[0])

    def extend(self, L: Iterable[Any]) -> None:
        self._tail.extend(self._rows(L))

    def insert(self, i: int, x: Any) -> None:
        self._array = np.insert(self._values, i, self._rows([x])[0], axis=0)

    def pop(self, i: int = -1) -> Any:
        value = self[i]
        del self[i]
        return value

    def remove(self, x: Any) -> None:
        matches = np.flatnonzero(self._equal(x))
        if not len(matches):
            raise ValueError(f"{type(self).__name__}.remove(x): x not in vector")
        del self[int(matches[0])]

    def count(self, x: Any) -> int:
        return int(self._equal(x).sum())

    def clear(self) -> None:
        self._array, self._tail = self._array[:0], []

    def _equal(self, x: Any) -> NDArray[np.bool_]:
        return (self._values == np.asarray(x)).reshape(len(self), -1).all(axis=1)


class DoubleVector(Vector):
    """float64 (n,)."""


class IntVector(Vector):
    """int32 (n,)."""

    _dtype = np.int32


class Vector2dVector(Vector):
    """float64 (n, 2)."""

    _row, _element = (2,), "Eigen::Vector2d"


class Vector3dVector(Vector):
    """Points, normals or colors, float64 (n, 3)."""

    _row, _element = (3,), "Eigen::Vector3d"


class Vector2iVector(Vector):
    """int32 (n, 2)."""

    _row, _dtype, _element = (2,), np.int32, "Eigen::Vector2i"


class Vector3iVector(Vector):
    """Triangles, int32 (n, 3)."""

    _row, _dtype, _element = (3,), np.int32, "Eigen::Vector3i"


class Vector4iVector(Vector):
    """Tetrahedra, int32 (n, 4)."""

    _row, _dtype, _element = (4,), np.int32, "Eigen::Vector4i"


class Matrix3dVector(Vector):
    """float64 (n, 3, 3)."""

    _row, _element = (3, 3), "Eigen::Matrix3d"


class Matrix4dVector(Vector):
    """float64 (n, 4, 4)."""

    _row, _element = (4, 4), "Eigen::Matrix4d"
