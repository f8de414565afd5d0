"""Frame: maps of one camera by name."""

from __future__ import annotations

from typing import Any

from .....core.attribute_hints import KnownNames
from .....core.checks import check_count
from ....argument_types import DeviceLike, TensorImage, TensorLike
from ....core.device import Device
from ....core.tensor import Tensor
from ... import geometry
from ..tensors import as_matrix, tensor_of


class Frame(KnownNames):
    """Tensors (height, width, c) by name, such as "depth" and "color", on one device. `intrinsics`: (3, 3) [px]."""

    intrinsics: Tensor

    def __init__(self, height: Any, width: int = 0, intrinsics: TensorLike | None = None, device: DeviceLike = "CPU:0"):
        if isinstance(height, Frame):
            vars(self).update(vars(height))
            self._maps = dict(self._maps)
            return
        self._size = check_count("height", height), check_count("width", width)
        self.intrinsics, self._device = as_matrix(intrinsics), Device(device)
        self._maps: dict[str, Tensor] = {}

    def has_data(self, name: str) -> bool:
        return name in self._maps

    def height(self) -> int:
        return self._size[0]

    def width(self) -> int:
        return self._size[1]

    def set_data(self, name: str, data: Tensor) -> None:
        """Store a tensor on the device of the frame."""
        self._maps[name] = data if data.device == self._device else tensor_of(data, data.dtype, self._device)

    def get_data(self, name: str) -> Tensor:
        """Raises KeyError if there is no such tensor. Open3D returns an empty one."""
        if name not in self._maps:
            raise KeyError(f"{name}: expected one of {[*self._maps]}; set_data({name!r}, tensor) sets it")
        return self._maps[name]

    def set_data_from_image(self, name: str, data: TensorImage) -> None:
        self.set_data(name, data.as_tensor())

    def get_data_as_image(self, name: str) -> Any:
        return geometry.Image(self.get_data(name))
