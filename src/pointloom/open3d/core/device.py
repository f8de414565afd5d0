"""Devices of tensors."""

from __future__ import annotations

import enum
from typing import ClassVar

from ...core.attribute_hints import HintedNames
from .errors import TensorError


class DeviceType(enum.Enum):
    CPU, CUDA = range(2)


class Device(HintedNames):
    """A device by Open3D's name, such as "CPU:0" or "CUDA:1". `name` is the name in pointloom, "cpu" or "cuda:1"."""

    DeviceType: ClassVar[type[DeviceType]] = DeviceType
    CPU, CUDA = DeviceType

    def __init__(self, device_type: Device | DeviceType | str = "CPU:0", device_id: int | None = None):
        given = getattr(device_type, "name", device_type)  # a Device or a DeviceType
        kind, _, number = str(given).upper().partition(":")
        number = str(device_id) if device_id is not None else number or "0"
        if kind not in ("CPU", "CUDA") or not number.isdigit() or (kind == "CPU" and int(number)):
            raise TensorError(
                f"device: expected CPU:0 or CUDA:n, got {given if device_id is None else (given, device_id)}"
            )
        self._type, self._number = DeviceType[kind], int(number)

    @property
    def name(self) -> str:
        return "cpu" if self._type is DeviceType.CPU else f"cuda:{self._number}"

    def get_type(self) -> DeviceType:
        return self._type

    def get_id(self) -> int:
        return self._number

    def __eq__(self, other: object) -> bool:
        if isinstance(other, str):
            other = Device(other)
        return isinstance(other, Device) and self.name == other.name

    def __hash__(self) -> int:
        return hash(self.name)

    def __str__(self) -> str:
        return f"{self._type.name}:{self._number}"

    def __repr__(self) -> str:
        return f'Device("{self._type.name}", {self._number})'
