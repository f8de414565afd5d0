"""Tensor: an array on a device with Open3D's methods."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from ...core.atomic import atomic_write
from ...core.attribute_hints import HintedNames
from ...core.errors import values_of_file
from ...io.points.npz import read_npy
from ..argument_types import DeviceLike, ShapeLike, TensorLike
from . import elementwise, linalg
from .device import Device
from .dtype import Dtype, float32
from .errors import TensorError, as_tensor_error
from .indexing import as_numpy_key
from .methods import TensorMethods, on_host
from .printing import values_text
from .size_vector import SizeVector

Scalar = bool | int | float | np.generic


class Tensor(TensorMethods, HintedNames):
    """An array on a device.

    Operands have one dtype and one device. A number takes the dtype of the tensor, so a fraction loses its decimals
    beside integers. Slices are views, indices and masks give copies.

    On a GPU elementwise functions, comparisons, reductions, casts, and rows by an index or a mask are computed there
    for Float32, Float64, Int32, Int64 and Bool. Slices are views there, too. Other types, other indices, assignments to
    indices, division of integers, `argmin`, `argmax`, concatenation and linear algebra go through the host.

    `array` is a NumPy array on the CPU and a Warp array on a GPU: pointloom's functions take it as it is, and return
    results as arrays of the same library on the same device. `Tensor.from_array` wraps them.
    """

    __array_priority__ = 1000  # `array + tensor` is a tensor
    __hash__ = None  # type: ignore[assignment]  # compares elementwise

    array: Any
    is_number: bool  # True for a tensor without axes on a GPU, whose `array` has one element

    @as_tensor_error
    def __init__(self, np_array: TensorLike | None, dtype: Dtype | None = None, device: Device | str | None = None):
        if np_array is None:
            raise TensorError("np_array: expected numbers, got None")
        if device is None and isinstance(np_array, Tensor):
            device = np_array.device
        values = np.array(np_array, order="C")
        if values.dtype.kind not in "biuf":
            raise TensorError(f"np_array: expected numbers, got {values.dtype}")
        kind = Dtype.from_numpy(values.dtype) if dtype is None else dtype
        made = on_device(values.astype(kind.numpy, copy=False), device)
        self.array, self.is_number = made.array, made.is_number

    @classmethod
    def from_array(cls, array: Any, *, is_number: bool = False) -> Self:
        """Wrap a NumPy array or a Warp array without a copy. Warp arrays on the CPU become NumPy arrays."""
        made = cls.__new__(cls)
        if isinstance(array, Tensor):
            array, is_number = array.array, array.is_number
        if not isinstance(array, np.ndarray | np.generic) and hasattr(array, "numpy"):
            from .device_memory import wrapped

            array = wrapped(array)
        made.array = np.asarray(array) if isinstance(array, np.generic) else array
        made.is_number = is_number and not isinstance(made.array, np.ndarray)
        return made

    def _like(self, values: NDArray[Any] | np.generic) -> Tensor:
        """A tensor of host values on this tensor's device."""
        return on_device(np.asarray(values, order="C"), None if self.is_cpu else self.device)

    # Constructors

    @staticmethod
    def from_numpy(array: NDArray[Any]) -> Tensor:
        """A tensor that shares the memory of a NumPy array."""
        Dtype.from_numpy(array.dtype)
        return Tensor.from_array(array)

    @staticmethod
    def from_dlpack(source: object) -> Tensor:
        """A tensor that shares the memory of an array of another library, or of a capsule of it."""
        from .device_memory import shared

        return Tensor.from_array(shared(source))

    @staticmethod
    @as_tensor_error
    def full(
        shape: ShapeLike, fill_value: ArrayLike, dtype: Dtype | None = None, device: DeviceLike | None = None
    ) -> Tensor:
        values = np.empty(SizeVector(shape), (dtype or float32).numpy)
        values[...] = np.asarray(fill_value).astype(values.dtype)
        return on_device(values, device)

    @staticmethod
    def empty(shape: ShapeLike, dtype: Dtype | None = None, device: DeviceLike | None = None) -> Tensor:
        """A tensor of zeros."""
        return Tensor.full(shape, 0, dtype, device)

    zeros = empty

    @staticmethod
    def ones(shape: ShapeLike, dtype: Dtype | None = None, device: DeviceLike | None = None) -> Tensor:
        return Tensor.full(shape, 1, dtype, device)

    @staticmethod
    def eye(n: int, dtype: Dtype | None = None, device: DeviceLike | None = None) -> Tensor:
        return Tensor(np.eye(n), dtype or float32, device)

    @staticmethod
    def arange(
        start: float,
        stop: float | None = None,
        step: float | None = None,
        dtype: Dtype | None = None,
        device: DeviceLike | None = None,
    ) -> Tensor:
        """Numbers from `start` to below `stop`: Int64, or Float64 if an argument is a float. One argument is `stop`."""
        first, end, step = (0, start, 1) if stop is None else (start, stop, 1 if step is None else step)
        if step == 0:
            raise TensorError("step: expected a number other than 0, got 0")
        return Tensor(np.arange(first, end, step), dtype, device)

    @staticmethod
    def diag(values: Tensor) -> Tensor:
        """A square matrix with the values of a vector on its diagonal."""
        if values.ndim != 1:
            raise TensorError(f"input: expected a vector (n,), got shape {list(values.shape)}")
        return Tensor(np.diag(values.numpy()), device=values.device)

    @staticmethod
    def load(file_name: str) -> Tensor:
        """Read a .npy file. Raises FileError."""
        values = read_npy(file_name)
        with values_of_file(file_name):
            return Tensor(values)

    def save(self, file_name: str) -> None:
        """Write a .npy file."""
        with atomic_write(file_name) as file:
            np.save(file, np.asarray(self._values, order="C"))

    # Properties

    @property
    def is_cpu(self) -> bool:
        return isinstance(self.array, np.ndarray)

    @property
    def is_cuda(self) -> bool:
        return not self.is_cpu

    @property
    def device(self) -> Device:
        return Device() if self.is_cpu else Device(str(self.array.device))

    @property
    def _numpy_dtype(self) -> np.dtype[Any]:
        if self.is_cpu:
            return self.array.dtype
        from .device_memory import numpy_dtype

        return numpy_dtype(self.array)

    @property
    def dtype(self) -> Dtype:
        return Dtype.from_numpy(self._numpy_dtype)

    @property
    def _shape(self) -> tuple[int, ...]:
        return () if self.is_number else tuple(self.array.shape)

    @property
    def shape(self) -> SizeVector:
        return SizeVector(self._shape)

    @property
    def ndim(self) -> int:
        return len(self._shape)

    @property
    def strides(self) -> SizeVector:
        """Step in memory from an element to the next one along each axis, in elements."""
        if not self.num_elements():  # Open3D's strides are those of sizes of at least 1, NumPy's are zero
            return SizeVector([int(np.prod(np.maximum(self._shape[i + 1 :], 1))) for i in range(self.ndim)])
        return SizeVector([n // self._numpy_dtype.itemsize for n in self.array.strides[: self.ndim]])

    def num_elements(self) -> int:
        return int(self.array.size)

    def __len__(self) -> int:
        if not self._shape:
            raise TensorError("a tensor without axes has no length; item() is its number")
        return self._shape[0]

    def is_contiguous(self) -> bool:
        return self.array.flags.c_contiguous if self.is_cpu else self.array.is_contiguous

    # Conversions

    @property
    def _values(self) -> NDArray[Any]:
        """The values on the host: the memory itself on the CPU, a copy from a GPU."""
        if self.is_cpu:
            return self.array
        from .device_memory import to_host

        return to_host(self.array, self._shape)

    def numpy(self) -> NDArray[Any]:
        """The values as a NumPy array, which shares the memory of a tensor on the CPU."""
        return self._values.view()

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self._values, dtype) if copy else np.asarray(self._values, dtype)

    def to(
        self, *targets: Any, copy: bool = False, dtype: Dtype | None = None, device: DeviceLike | None = None
    ) -> Tensor:
        """This tensor with another dtype, on another device, or both. The tensor itself if nothing changes."""
        for target in targets:
            if isinstance(target, bool):
                copy = target
            elif isinstance(target, Dtype):
                dtype = target
            else:
                device = target
        type_changes = dtype is not None and dtype != self.dtype
        target_device = self.device if device is None else Device(device)
        if not copy and not type_changes and target_device == self.device:
            return self
        wanted = self._numpy_dtype if dtype is None else dtype.numpy
        if self.is_cuda and target_device == self.device:
            from .device_functions import converted

            return Tensor.from_array(converted(self.array, wanted), is_number=self.is_number)
        values = self._values.astype(wanted, "C")
        return on_device(values, target_device)

    def cpu(self) -> Tensor:
        return self.to(Device())

    def cuda(self, device_id: int = 0) -> Tensor:
        return self.to(Device("CUDA", device_id))

    def clone(self) -> Tensor:
        return self.to(copy=True)

    def contiguous(self) -> Tensor:
        return self if self.is_contiguous() else self.clone()

    def item(self) -> Any:
        """The number of a tensor with one element."""
        if self.num_elements() != 1:
            raise TensorError(f"item: expected a tensor with one element, got shape {list(self._shape)}")
        return self._values.item()

    def __bool__(self) -> bool:
        return bool(self.item())

    def __dlpack__(self, stream: int | None = None, **options: Any) -> Any:
        return self.array.__dlpack__(**options) if self.is_cpu else self.array.__dlpack__(stream)

    def __dlpack_device__(self) -> tuple[int, int]:
        return (1, 0) if self.is_cpu else (2, self.device.get_id())

    def to_dlpack(self) -> Any:
        return self.__dlpack__()

    def __reduce__(self) -> tuple[Any, ...]:
        return Tensor, (self._values, None, str(self.device))

    def __repr__(self) -> str:
        sizes, strides = ("{" + ", ".join(map(str, part)) + "}" for part in (self.shape, self.strides))
        address = self.array.ctypes.data if self.is_cpu else self.array.ptr or 0
        end = f"Tensor[shape={sizes}, stride={strides}, {self.dtype}, {self.device}, {address:#x}]"
        return f"{values_text(self._values)}\n{end}"

    # Views

    @as_tensor_error
    def __getitem__(self, key: object) -> Tensor:
        if isinstance(key, Tensor) and self.ndim and key.device == self.device:
            result = self._on_device("gathered", self.array, self._shape, key.array, tuple(key.shape))
            if result is not None:
                return result
        parts, is_copy = as_numpy_key(key)
        if is_copy:
            return self._like(np.ascontiguousarray(self._values[parts]))
        return _view(self, lambda values: values[(*parts, ...)])

    @as_tensor_error
    def __setitem__(self, key: object, value: TensorLike) -> None:
        parts, is_copy = as_numpy_key(key)
        if isinstance(value, Tensor) and not is_copy and self.is_cuda:
            _copy_into(self[key], value)
            return
        values = value.numpy() if isinstance(value, Tensor) else np.asarray(value)
        if values.dtype.kind not in "biuf":
            raise TensorError(f"value: expected numbers, got {values.dtype}")
        values = values.astype(self._numpy_dtype, copy=False)
        if self.is_cpu:
            self.array[parts] = values
        elif not is_copy:
            _write(self[key], values)
        else:
            changed = self._values
            changed[parts] = values
            _write(self, changed)

    def _written(self, result: Tensor) -> Self:
        """Replace the values by those of a tensor that broadcasts to this shape."""
        _copy_into(self, result)
        return self

    def __iter__(self) -> Iterator[Tensor]:
        return (self[i] for i in range(len(self)))

    def T(self) -> Tensor:
        """The transposed matrix, as a view."""
        if self.ndim > 2:
            raise TensorError(f"T: expected at most two axes, got {self.ndim}")
        return _view(self, lambda values: values.T)

    @as_tensor_error
    def reshape(self, dst_shape: ShapeLike) -> Tensor:
        """The same elements in another shape, of which one size may be -1. A view of contiguous tensors."""
        shape = SizeVector(dst_shape)
        if any(size < -1 for size in shape):
            raise TensorError(f"dst_shape: expected sizes from 0 on, and at most one -1, got {shape}")
        return _view(self.contiguous(), lambda values: values.reshape(shape))

    def flatten(self, start_dim: int = 0, end_dim: int = -1) -> Tensor:
        """This tensor with the axes from `start_dim` to `end_dim` joined."""
        axes = max(1, self.ndim)
        for name, dim in (("start_dim", start_dim), ("end_dim", end_dim)):
            if not -axes <= dim < axes:
                raise TensorError(f"{name}: expected {-axes} to {axes - 1}, got {dim}")
        first, last = start_dim % axes, end_dim % axes
        if first > last:
            raise TensorError(f"end_dim: expected an axis from {first} on, got {last}")
        return self.reshape([*self._shape[:first], -1 if self.num_elements() else 0, *self._shape[last + 1 :]])

    # Arithmetic

    def _checked(self, other: Tensor) -> Tensor:
        if not (self.is_cpu and other.is_cpu) and other.device != self.device:
            raise TensorError(f"other: expected a tensor on {self.device}, got {other.device}; .to(device) copies it")
        return other

    def _operand(self, name: str, other: object) -> Any:
        """The other operand as a tensor of the same dtype and device. NotImplemented for other objects."""
        if isinstance(other, Scalar):
            return self._like(np.asarray(other).astype(self._numpy_dtype))
        if isinstance(other, list | tuple | np.ndarray):
            other = Tensor(other, device=self.device)
        if not isinstance(other, Tensor):
            return NotImplemented
        if other.dtype != self.dtype:
            raise TensorError(
                f"{name}: expected a tensor of {self.dtype}, got {other.dtype}; .to(dtype) converts one of them"
            )
        return self._checked(other)

    def _combined(self, name: str, left: Tensor, right: Tensor) -> Tensor:
        shapes = tuple(left.shape), tuple(right.shape)
        result = self._on_device("binary", name, left.array, shapes[0], right.array, shapes[1])
        return self._like(elementwise.binary(name, left.numpy(), right.numpy())) if result is None else result

    def _on_device(self, function: str, *arguments: Any) -> Tensor | None:
        """The result of a function of `device_functions`. None on the CPU and for operations that run on the host."""
        if self.is_cpu:
            return None
        from . import device_functions

        result = getattr(device_functions, function)(*arguments)
        return None if result is None else Tensor.from_array(result[0], is_number=not result[1])

    @as_tensor_error
    def clip(self, min: ArrayLike, max: ArrayLike) -> Tensor:
        low, high = (np.asarray(end).astype(self._numpy_dtype) for end in (min, max))
        return self._like(np.clip(self._values, low, high))

    def clip_(self, min: ArrayLike, max: ArrayLike) -> Tensor:
        return self._written(self.clip(min, max))

    def isclose(self, other: Tensor, rtol: float = 1e-5, atol: float = 1e-8) -> Tensor:
        """True where the values differ by at most atol + rtol * abs(other)."""
        if self._operand("isclose", other).shape != self.shape:
            raise TensorError(f"other: expected shape {list(self._shape)}, got {list(other.shape)}")
        return self._like(np.isclose(self._values, other.numpy(), rtol, atol))

    def allclose(self, other: Tensor, rtol: float = 1e-5, atol: float = 1e-8) -> bool:
        return bool(self.isclose(other, rtol, atol).numpy().all())

    def issame(self, other: Tensor) -> bool:
        """True if both are the same memory with the same shape, strides and dtype."""

        def identity(part: Tensor) -> tuple[Any, ...]:
            address = part.array.ctypes.data if part.is_cpu else part.array.ptr
            return address, part.device, part.dtype, tuple(part.shape), tuple(part.strides)

        return identity(self) == identity(other)

    def nonzero(self, as_tuple: bool = False) -> Any:
        """Indices of nonzero elements: a list of one tensor per axis, or with `as_tuple` a tensor (axes, n)."""
        found = np.nonzero(self._values)
        return self._like(np.stack(found)) if as_tuple else [self._like(part) for part in found]

    def append(self, values: Tensor, axis: int | None = None) -> Tensor:
        """Join this tensor and another along an axis. Axis None joins flattened tensors."""
        return concatenate((self, values), axis)


def on_device(values: NDArray[Any], device: Device | str | None) -> Tensor:
    """A tensor that takes host values without a copy, or their copy on a GPU."""
    made = Tensor.from_array(values)
    if device is None or Device(device).name == "cpu":
        return made
    from .device_memory import to_device

    return Tensor.from_array(to_device(values, Device(device).name), is_number=not values.ndim)


def _view(tensor: Tensor, change: Callable[[NDArray[Any]], Any]) -> Tensor:
    """A view, by a function that computes it for a NumPy array."""
    if tensor.is_cpu:
        return Tensor.from_array(np.asarray(change(tensor.array)))
    from .device_memory import view

    array, shape = view(tensor.array, tuple(tensor.shape), change)
    return Tensor.from_array(array, is_number=not shape)


def _write(tensor: Tensor, values: NDArray[Any]) -> None:
    """Write host values that broadcast to the shape."""
    if tensor.is_cpu:
        tensor.array[...] = values
    else:
        from .device_memory import write

        write(tensor.array, tuple(tensor.shape), values)


def _copy_into(tensor: Tensor, source: Tensor) -> None:
    """Replace the values by those of a tensor that broadcasts to this shape."""
    if tensor.is_cuda and source.device == tensor.device and source.shape == tensor.shape:
        from .device_functions import converted, overwrite

        overwrite(tensor.array, converted(source.array, tensor.dtype.numpy))
    else:
        _write(tensor, source.numpy().astype(tensor.dtype.numpy, copy=False))


def concatenate(tensors: Tensor | Iterable[Tensor], axis: int | None = 0) -> Tensor:
    """Join tensors along an axis. A single tensor is split along its first axis. Axis None joins flattened tensors."""
    parts = [tensors] if isinstance(tensors, Tensor) else list(tensors)
    if not parts:
        raise TensorError("tensors: expected one or more tensors, got none")
    return _concatenated(*parts, axis=axis)


_concatenated = on_host(lambda *arrays, axis: linalg.concatenate(arrays, axis))
