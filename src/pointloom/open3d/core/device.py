"""Devices of tensors."""

from __future__ import annotations

from typing import Any


class Device:
    """A device by Open3D's name, such as "CPU:0" or "CUDA:1". `name` is the name in pointloom, "cpu" or "cuda:1"."""

    def __init__(self, device_type: Any = "CPU:0", device_id: int | None = None):
        if isinstance(device_type, Device):
            device_type = str(device_type)
        kind, _, number = str(device_type).partition(":")
        if device_id is not None:
            number = str(device_id)
        kind, number = kind.upper(), number or "0"
        if kind not in ("CPU", "CUDA") or not number.isdigit() or (kind == "CPU" and int(number)):
            raise ValueError(f"device: expected CPU:0 or CUDA:n, got {device_type!s}")
        self._kind, self._number = kind, int(number)

    @property
    def name(self) -> str:
        return "cpu" if self._kind == "CPU" else f"cuda:{self._number}"

    def get_type(self) -> str:
        return self._kind

    def get_id(self) -> int:
        return self._number

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Device) and self.name == other.name

    def __hash__(self) -> int:
        return hash(self.name)

    def __repr__(self) -> str:
        return f"{self._kind}:{self._number}"
