"""Tensor: an array on a device with Open3D's methods."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ...core.devices import resolve_device
from .device import Device
from .dtype import Dtype


class Tensor:
    """An array on a device.

    `_array` is a NumPy array on the CPU and a Warp array on a GPU: pointloom's functions take it as it is, and return
    results as arrays of the same library on the same device.
    """

    _array: Any

    def __init__(self, np_array: Any, dtype: Dtype | None = None, device: Device | str | None = None):
        if isinstance(np_array, Tensor):
            np_array = np_array._array if device is None else np_array.numpy()
        values = np.array(np_array, None if dtype is None else dtype.numpy)
        self._array = _on(values, Device() if device is None else Device(device))

    @classmethod
    def _around(cls, array: Any) -> Self:
        """Wrap a NumPy array or a Warp array on a GPU without a copy. Warp arrays on the CPU become NumPy arrays."""
        made = cls.__new__(cls)
        on_host = not isinstance(array, np.ndarray) and hasattr(array, "numpy") and array.device.is_cpu
        made._array = array.numpy() if on_host else array
        return made

    @staticmethod
    def from_numpy(array: NDArray[Any]) -> Tensor:
        """A tensor that shares the memory of a NumPy array."""
        return Tensor._around(array)

    @property
    def device(self) -> Device:
        return Device() if isinstance(self._array, np.ndarray) else Device(str(self._array.device))

    @property
    def dtype(self) -> Dtype:
        return Dtype.from_numpy(self.numpy().dtype)

    @property
    def shape(self) -> tuple[int, ...]:
        return tuple(self._array.shape)

    def numpy(self) -> NDArray[Any]:
        """The values as a NumPy array, which shares the memory of a tensor on the CPU."""
        return self._array if isinstance(self._array, np.ndarray) else self._array.numpy()


def _on(values: NDArray[Any], device: Device) -> Any:
    """The array on a device."""
    if device.name == "cpu":
        return values
    import warp as wp

    return wp.array(values, device=resolve_device(device.name))
