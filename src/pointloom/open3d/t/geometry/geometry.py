"""Base class of the geometries of tensors."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar, Self

from ....core.attribute_hints import KnownNames
from ...argument_types import DeviceLike
from ...core.device import Device
from ...core.tensor import Tensor
from .tensor_map import TensorMap, count_of, mapped

CPU = Device("CPU:0")


class Geometry(KnownNames):
    """A geometry of tensors on one device.

    To write a class: list the attributes with a Tensor, a TensorMap or another Geometry in `_parts`. The first one
    determines the device. Set `_home` in the constructor: the device while there is no tensor. List read-only
    attributes in `_fixed`.
    """

    _internal = ("map_tensors",)

    _parts: ClassVar[tuple[str, ...]] = ()
    _home: Device

    @property
    def device(self) -> Device:
        part = getattr(self, self._parts[0])
        if not isinstance(part, TensorMap):
            return part.device
        return part[part.primary_key].device if part.primary_key in part else self._home

    @property
    def is_cpu(self) -> bool:
        return self.device.name == "cpu"

    @property
    def is_cuda(self) -> bool:
        return not self.is_cpu

    def to(self, device: Device, copy: bool = False) -> Self:
        """The geometry on a device: itself if it is there already, unless `copy`."""
        device = device_of(device)
        if device == self.device and not copy:
            return self
        made = self.map_tensors(lambda tensor: tensor.to(device, copy))
        vars(made)["_home"] = device
        return made

    def cpu(self) -> Self:
        return self.to(CPU)

    def cuda(self, device_id: int = 0) -> Self:
        return self.to(Device("CUDA", device_id))

    def clone(self) -> Self:
        """Copy with tensors of its own."""
        return self.map_tensors(lambda tensor: tensor.clone())

    def __copy__(self) -> Self:
        return self.map_tensors(lambda tensor: tensor)

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self.clone()

    def map_tensors(self, function: Callable[[Tensor], Tensor]) -> Self:
        """A geometry whose tensors are the results of a function."""
        made = type(self).__new__(type(self))
        vars(made).update(vars(self))
        for name in self._parts:
            part = getattr(self, name)
            vars(made)[name] = (
                mapped(part, function) if isinstance(part, TensorMap)
                else part.map_tensors(function) if isinstance(part, Geometry)
                else function(part)
            )  # fmt: skip
        return made

    def is_empty(self) -> bool:
        return count_of(getattr(self, self._parts[0])) == 0

    def clear(self) -> Self:
        """Remove all values, in place."""
        device = self.device
        for name in self._parts:
            vars(self)[name] = TensorMap(getattr(self, name).primary_key)
        self._home = device
        return self


def device_of(value: DeviceLike) -> Device:
    """The `Device` of an argument: a Device or its name."""
    return value if isinstance(value, Device) else Device(value)
