"""Tensors by name, one of which is primary: the attributes of points, lines, vertices or triangles."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....core.escaped_text import escaped
from ....core.gpu_arrays import take_numbers
from ...argument_types import DeviceArray
from ...core.tensor import Tensor

RESERVED = {
    *("clear", "copy", "fromkeys", "get", "items", "keys", "pop", "popitem", "setdefault", "update", "values"),
    *("primary_key", "is_size_synchronized", "assert_size_synchronized", "erase"),
}


def tensor_of(name: str, values: object) -> Tensor:
    """A tensor, or one of a list or of a NumPy array, whose memory it shares. Raises TypeError."""
    if isinstance(values, Tensor):
        return values
    if isinstance(values, np.ndarray):
        return Tensor.from_numpy(values)
    if isinstance(values, list | tuple | int | float):
        return Tensor(values)
    raise TypeError(
        f"{escaped(name)}: expected a Tensor, got {type(values).__name__}; o3d.core.Tensor(array) makes one"
    )


def array_of(name: str, values: object) -> NDArray[Any]:
    """The values of a tensor or of what `tensor_of` accepts, as a NumPy array."""
    return tensor_of(name, values).numpy()


def matrix_of(name: str, values: object, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """A small argument as a NumPy array of a shape."""
    array = array_of(name, values)
    if array.shape != shape:
        raise ValueError(f"{escaped(name)}: expected shape {list(shape)}, got {list(array.shape)}")
    return array.astype(np.float64)


def wrap(values: DeviceArray) -> Tensor:
    """A tensor around a result of pointloom. Vectors of a Warp array become rows."""
    return Tensor.from_array(values if isinstance(values, np.ndarray) else take_numbers("values", values))


class MissingKeyError(KeyError, AttributeError):
    """A name that a TensorMap does not contain, also when read as an attribute."""

    def __str__(self) -> str:
        return str(self.args[0])


class TensorMap:
    """A mapping of names to tensors with attribute access: `point["positions"]` is `point.positions`.

    Args:
        primary_key: Name of the tensor whose length is the number of elements.
        map_keys_to_tensors: Initial tensors. They are shared, not copied.
    """

    primary_key: str
    _values: dict[str, Tensor]

    def __init__(self, primary_key: str, map_keys_to_tensors: Mapping[str, Tensor] | Iterable[tuple[str, Tensor]] = ()):
        object.__setattr__(self, "primary_key", primary_key)
        object.__setattr__(self, "_values", {})
        values = dict(map_keys_to_tensors)
        if values and primary_key not in values:
            raise RuntimeError(f"map_keys_to_tensors: expected the primary key {primary_key!r}, got {[*values]}")
        for name, tensor in values.items():
            self[name] = tensor

    def __getitem__(self, key: str) -> Tensor:
        if key not in self._values:
            raise MissingKeyError(f"{escaped(key)}: expected one of {[*self._values]}")
        return Tensor.from_array(self._values[key].array)  # another object, the same memory

    def __setitem__(self, key: str, value: object) -> None:
        if key in RESERVED or key.startswith("__"):
            raise KeyError(f"{escaped(key)}: the name is reserved")
        self._values[key] = tensor_of(key, value)

    def __delitem__(self, key: str) -> None:
        if key == self.primary_key:
            raise RuntimeError(f"{escaped(key)}: the primary key cannot be deleted")
        self._values.pop(key, None)

    def erase(self, key: str) -> int:
        """Delete a tensor. Returns 1, or 0 if there is none."""
        count = int(key in self._values)
        del self[key]
        return count

    def __getattr__(self, key: str) -> Tensor:
        if key.startswith("_"):
            raise AttributeError(f"TensorMap has no attribute {key!r}")
        return self[key]

    def __setattr__(self, key: str, value: Any) -> None:
        self[key] = value

    def __delattr__(self, key: str) -> None:
        self[key]  # raises KeyError if there is none
        del self[key]

    def __contains__(self, key: str) -> bool:
        return key in self._values

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def items(self) -> Iterator[tuple[str, Tensor]]:
        return iter([(name, self[name]) for name in self._values])

    def __len__(self) -> int:
        return len(self._values)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._values]

    def is_size_synchronized(self) -> bool:
        """True if all tensors have the length of the primary one."""
        return not self._odd()

    def assert_size_synchronized(self) -> None:
        """Raise RuntimeError if a tensor has another length than the primary one."""
        if odd := self._odd():
            names, primary = escaped(", ".join(odd)), escaped(self.primary_key)
            raise RuntimeError(f"{names}: expected {count_of(self)} rows as of {primary}, got {odd}")

    def _odd(self) -> dict[str, int]:
        lengths = {name: int(tensor.shape[0]) for name, tensor in self.items()}
        return {name: length for name, length in lengths.items() if length != count_of(self)}

    def __repr__(self) -> str:
        head = f'TensorMap(primary_key="{escaped(self.primary_key)}") with'
        if not self:
            return f"{head} no attribute"
        width = max(len(escaped(name)) for name in self)
        rows = [
            f"  - {escaped(name):<{width}}: shape={{{', '.join(map(str, tensor.shape))}}}, dtype={tensor.dtype}, "
            f"device={tensor.device}{' (primary)' if name == self.primary_key else ''}"
            for name, tensor in sorted(self.items())
        ]
        example = escaped(self.primary_key if self.primary_key in self else min(self))
        count = f"{len(self)} attribute{'s' if len(self) > 1 else ''}:"
        return "\n".join([f"{head} {count}", *rows, f"  (Use . to access attributes, e.g., tensor_map.{example})"])

    def __reduce__(self) -> tuple[Any, ...]:
        return TensorMap, (self.primary_key, self._values)

    def __copy__(self) -> TensorMap:
        return TensorMap(self.primary_key, self._values)

    def __deepcopy__(self, memo: dict[int, Any]) -> TensorMap:
        return mapped(self, lambda tensor: tensor.clone())


def count_of(tensors: TensorMap) -> int:
    """Length of the primary tensor. 0 if there is none."""
    return int(tensors[tensors.primary_key].shape[0]) if tensors.primary_key in tensors else 0


def mapped(tensors: TensorMap, function: Callable[[Tensor], Tensor]) -> TensorMap:
    """A map of the results of a function, such as a selection of rows."""
    return TensorMap(tensors.primary_key, {name: function(tensor) for name, tensor in tensors.items()})


def listed(tensors: TensorMap, *, ordered: bool = False) -> str:
    """The tensors besides the primary one as text: ` colors (dtype = Float32, shape = {8, 3}).`"""
    rows = [
        f" {escaped(name)} (dtype = {tensor.dtype}, shape = {{{', '.join(map(str, tensor.shape))}}})"
        for name, tensor in (sorted(tensors.items()) if ordered else tensors.items())
        if name != tensors.primary_key
    ]
    return f"{','.join(rows) or ' None'}."
