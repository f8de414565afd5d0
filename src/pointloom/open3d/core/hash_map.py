"""HashMap and HashSet: rows of integers to rows of buffers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.attribute_hints import HintedNames
from ...core.checks import check_count, shown
from ...core.errors import FileError, values_of_file
from ...core.paths import path_of
from ...core.serialized import Serialized
from ...io.points.npz import read_arrays
from .device import Device
from .dtype import Dtype
from .errors import TensorError
from .size_vector import SizeVector
from .tensor import Tensor

Rows = NDArray[Any]


class _Table(Serialized, HintedNames):
    """Keys in the rows of a buffer, with values in the same rows of others.

    The buffers are on the device, and keys are looked up on the host, by binary search. A key keeps its row until it is
    erased, also when the buffers grow. New keys take the lowest free rows.
    """

    def __init__(
        self,
        init_capacity: int,
        key_dtype: Dtype,
        key_element_shape: Any,
        value_dtypes: Sequence[Dtype],
        value_element_shapes: Sequence[Any],
        device: Any,
    ):
        capacity = check_count("init_capacity", init_capacity)
        if key_dtype.numpy.kind not in "iu":
            raise TensorError(f"key_dtype: expected a type of integers, got {key_dtype}")
        if len(value_dtypes) != len(value_element_shapes):
            wanted = f"one shape for each of {len(value_dtypes)} types"
            raise TensorError(f"value_element_shapes: expected {wanted}, got {len(value_element_shapes)}")
        shapes = [SizeVector(shape) for shape in (key_element_shape, *value_element_shapes)]
        if 0 in shapes[0]:
            raise TensorError(f"key_element_shape: expected sizes from 1 on, got {shapes[0]}")
        self._buffers = [
            Tensor.zeros([capacity, *shape], dtype, device)
            for dtype, shape in zip((key_dtype, *value_dtypes), shapes, strict=True)
        ]
        self._is_active = np.zeros(capacity, bool)
        self._sort()

    def _sort(self) -> None:
        """Sort the active keys for `_search`."""
        rows = np.flatnonzero(self._is_active)
        keys = _as_items(self._buffers[0]._values[rows])
        order = np.argsort(keys, kind="stable")
        self._sorted_keys, self._sorted_rows = keys[order], rows[order].astype(np.int32)

    def _search(self, items: Rows) -> tuple[Rows, Rows]:
        """The row of each key, 0 for missing ones, and True for the others."""
        if not len(self._sorted_keys):
            return np.zeros(len(items), np.int32), np.zeros(len(items), bool)
        places = np.searchsorted(self._sorted_keys, items).clip(max=len(self._sorted_keys) - 1)
        found = self._sorted_keys[places] == items
        return np.where(found, self._sorted_rows[places], np.int32(0)), found

    def _checked(self, name: str, values: Tensor, buffer: Tensor, count: int | None = None) -> Rows:
        """The rows of an argument for a buffer, on the host."""
        rows = (len(values) if values.ndim else 1) if count is None else count
        shape = (rows, *buffer.shape[1:])
        if values.dtype != buffer.dtype or values.num_elements() != np.prod(shape):
            wanted = f"{buffer.dtype} of shape ({'n' if count is None else count}, {str(list(shape[1:]))[1:-1]})"
            raise TensorError(f"{name}: expected {wanted}, got {values.dtype} of shape {list(values.shape)}")
        if values.device != self.device:
            raise TensorError(f"{name}: expected a tensor on {self.device}, got {values.device}")
        return values._values.reshape(shape)

    def _insert(self, keys: Tensor, values: Sequence[Tensor]) -> tuple[Tensor, Tensor]:
        key_rows = self._checked("keys", keys, self._buffers[0])
        count = len(key_rows)
        value_rows = [
            self._checked("values", value, buffer, count)
            for value, buffer in zip(values, self._buffers[1:], strict=False)
        ]
        if self.size() + count > self.capacity():
            self.reserve(max(self.size() + count, 2 * self.capacity()))
        items = _as_items(key_rows)
        _, found = self._search(items)
        is_first = np.zeros(count, bool)
        is_first[np.unique(items, return_index=True)[1]] = True
        is_new = is_first & ~found
        rows = np.flatnonzero(~self._is_active)[: is_new.sum()]
        for buffer, given in zip(self._buffers, [key_rows, *value_rows], strict=False):
            buffer[rows] = given[is_new]
        self._is_active[rows] = True
        self._sort()
        return self._tensors(self._search(items)[0], is_new)

    def _tensors(self, *arrays: Rows) -> Any:
        return tuple(Tensor(array, device=self.device) for array in arrays)

    def find(self, keys: Tensor) -> tuple[Tensor, Tensor]:
        """The row of each key in the buffers, Int32, and True for each key that exists. Missing keys have row 0."""
        return self._tensors(*self._search(_as_items(self._checked("keys", keys, self._buffers[0]))))

    def erase(self, keys: Tensor) -> Tensor:
        """Remove keys. True for each one removed: the first of equal keys that exist."""
        items = _as_items(self._checked("keys", keys, self._buffers[0]))
        rows, found = self._search(items)
        is_first = np.zeros(len(items), bool)
        is_first[np.unique(items, return_index=True)[1]] = True
        self._is_active[rows[found]] = False
        self._sort()
        return Tensor(found & is_first, device=self.device)

    def active_buf_indices(self) -> Tensor:
        """The rows in use, Int32, ascending."""
        return Tensor(np.flatnonzero(self._is_active).astype(np.int32), device=self.device)

    def key_tensor(self) -> Tensor:
        """The buffer of keys. Rows not in use have undefined keys."""
        return self._buffers[0]

    def size(self) -> int:
        return int(self._is_active.sum())

    def capacity(self) -> int:
        return len(self._is_active)

    def reserve(self, capacity: int) -> None:
        """Make room for at least this many keys."""
        more = capacity - self.capacity()
        if more > 0:
            self._is_active = np.concatenate([self._is_active, np.zeros(more, bool)])
            self._buffers = [
                b.append(Tensor.zeros([more, *b.shape[1:]], b.dtype, b.device), axis=0) for b in self._buffers
            ]

    @property
    def device(self) -> Device:
        return self._buffers[0].device

    @property
    def is_cpu(self) -> bool:
        return self.device.name == "cpu"

    @property
    def is_cuda(self) -> bool:
        return not self.is_cpu

    def clone(self) -> Self:
        return self.to(self.device, copy=True)

    def to(self, device: Any, copy: bool = False) -> Self:
        if not copy and self.device == Device(device):
            return self
        made = type(self).__new__(type(self))
        made._buffers = [buffer.to(device, copy=True) for buffer in self._buffers]
        made._is_active = self._is_active.copy()
        made._sort()
        return made

    def cpu(self) -> Self:
        return self.to(Device())

    def cuda(self, device_id: int = 0) -> Self:
        return self.to(Device("CUDA", device_id))

    def save(self, file_name: str) -> None:
        """Write the keys and values in use to a .npz file."""
        key, *values = (buffer._values[self._is_active] for buffer in self._buffers)
        arrays = {f"value_{i:03d}": value for i, value in enumerate(values)}
        with atomic_write(file_name) as file:
            np.savez(file, allow_pickle=False, key=key, n_values=np.array([len(values)]), **arrays)

    @classmethod
    def load(cls, file_name: str) -> Self:
        """Read a .npz file of `save`, or of Open3D. Raises FileError."""
        key, *values = _read_table(file_name)
        if values and not issubclass(cls, HashMap):
            raise FileError(file_name, f"expected keys without values, got {len(values)} arrays of values")
        made = cls.__new__(cls)
        with values_of_file(file_name):
            made._buffers = [Tensor(array) for array in (key, *values)]
        made._is_active = np.ones(len(key), bool)
        made._sort()
        if len(np.unique(made._sorted_keys)) < len(key):
            raise FileError(file_name, "expected each key once, got duplicate keys", where="array key")
        return made


class HashMap(_Table):
    """A map from rows of integers to rows of one or more tensors.

    `value_dtype` and `value_element_shape` are a type and a shape, or lists of them for several tensors.
    """

    def __init__(
        self,
        init_capacity: int,
        key_dtype: Dtype,
        key_element_shape: Any,
        value_dtype: Any = None,
        value_element_shape: Any = None,
        device: Any = None,
        *,
        value_dtypes: Sequence[Dtype] | None = None,
        value_element_shapes: Sequence[Any] | None = None,
    ):
        types, shapes = (value_dtypes or value_dtype), (value_element_shapes or value_element_shape)
        if isinstance(types, Dtype):
            types, shapes = [types], [shapes]
        super().__init__(init_capacity, key_dtype, key_element_shape, types, shapes, device)

    def insert(self, keys: Tensor, values: Tensor | Sequence[Tensor]) -> tuple[Tensor, Tensor]:
        """Add keys with values. Keys that exist keep theirs, and of equal keys the first one counts.

        Returns:
            The row of each key in the buffers, Int32, and True for each key that was added.
        """
        listed = [values] if isinstance(values, Tensor) else list(values)
        if len(listed) != len(self._buffers) - 1:
            raise TensorError(f"values: expected {len(self._buffers) - 1} tensors, got {len(listed)}")
        return self._insert(keys, listed)

    def activate(self, keys: Tensor) -> tuple[Tensor, Tensor]:
        """Add keys without values: these are undefined until they are written to `value_tensor`. As `insert`."""
        return self._insert(keys, ())

    def value_tensor(self, value_buffer_id: int = 0) -> Tensor:
        """A buffer of values: writing to it changes the map."""
        return self._buffers[1:][value_buffer_id]

    def value_tensors(self) -> list[Tensor]:
        return self._buffers[1:]


class HashSet(_Table):
    """A set of rows of integers."""

    def __init__(self, init_capacity: int, key_dtype: Dtype, key_element_shape: Any, device: Any = None):
        super().__init__(init_capacity, key_dtype, key_element_shape, (), (), device)

    def insert(self, keys: Tensor) -> tuple[Tensor, Tensor]:
        """Add keys. Returns the row of each key in the buffer, Int32, and True for each key that was added."""
        return self._insert(keys, ())


def _as_items(keys: Rows) -> Rows:
    """Each row as one element that can be sorted: a number, or its bytes."""
    width = int(np.prod(keys.shape[1:]))
    flat = np.ascontiguousarray(keys.reshape(len(keys), width))
    return flat[:, 0] if width == 1 else flat.view(np.dtype((np.void, flat.itemsize * width)))[:, 0]


def _read_table(file_name: Any) -> list[Rows]:
    """Keys, and arrays of values with as many rows."""
    arrays = read_arrays(path_of(file_name, "file_name"))
    key, number = arrays.pop("key", np.zeros(0)), arrays.pop("n_values", np.zeros(0))
    if key.dtype.kind not in "iu" or not key.ndim or 0 in key.shape[1:]:
        reason = f"expected integers of shape [n, ...], got {key.dtype} {list(key.shape)}"
        raise FileError(file_name, reason, where="array key")
    if number.dtype.kind not in "iu" or number.size != 1 or int(number.flat[0]) != len(arrays):
        reason = f"expected the number of arrays of values, {len(arrays)}, got {shown(number.tolist())}"
        raise FileError(file_name, reason, where="array n_values")
    names = [f"value_{i:03d}" for i in range(len(arrays))]
    for name in names:
        if name not in arrays:
            unknown = min(arrays.keys() - set(names))
            raise FileError(file_name, f"expected the arrays {', '.join(names)}, got {shown(unknown)}")
        if arrays[name].shape[:1] != key.shape[:1]:
            reason = f"expected {len(key)} rows as of the keys, got the shape {list(arrays[name].shape)}"
            raise FileError(file_name, reason, where=f"array {name}")
    return [key, *(arrays[name] for name in names)]
