"""LRU cache of images on the device with a fixed number of slots."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError
from ...kernels.array_types import Device
from ...kernels.lang import launch, uint8
from ...kernels.lru_cache import LruCache
from ...kernels.memory import copy, empty, upload, write
from ...kernels.stereo.brightness import resize_brightness_kernel
from .posed_images import PosedCamera

Image = str | os.PathLike[str] | NDArray[np.uint8]


def read_image(name: str, image: Image, camera: PosedCamera) -> NDArray[np.uint8]:
    size = (camera.intrinsic.height, camera.intrinsic.width)
    if isinstance(image, np.ndarray):
        if image.shape[:2] != size:
            raise ValueError(other_size(f"{name}: ", image.shape, size))
        return image
    from ...io.images.image_files import read_color

    pixels = read_color(image)
    if pixels.shape[:2] != size:
        raise FileError(image, other_size("", pixels.shape, size), remedy="Give the camera of this image")
    return pixels


def other_size(name: str, shape: Sequence[int], size: tuple[int, int]) -> str:
    return f"{name}expected {size[1]} x {size[0]} pixels as of its camera, got {shape[1]} x {shape[0]}"


class Slots:
    """A number of slots for images or maps in one device array."""

    def __init__(self, count: int, size: int, dtype: Any, device: Device):
        self.size = size
        self.values = empty(count * size, dtype, device)
        self._free = list(range(count))
        self._slots: LruCache[int] = LruCache(count, on_evict=self._free.append)

    def first_of(self, key: Any, load: Callable[[int], None]) -> int:
        """Offset of the slot with this key; `load(first)` fills it if missing."""

        def loaded() -> int:
            load(self._free[0] * self.size)
            return self._free.pop(0)

        return self._slots.get(key, 1, loaded) * self.size


def put_brightness(slots: Slots, first: int, pixels: NDArray[np.uint8], width: int, height: int) -> None:
    rows, columns = pixels.shape[:2]
    device = slots.values.device
    flat = upload(pixels.reshape(-1), uint8, device, copied=False)
    channels = 3 if pixels.ndim == 3 else 1
    launch(
        resize_brightness_kernel, width * height, [flat, channels, columns, rows, width, height, first, slots.values]
    )


def put_planes(slots: Slots, first: int, planes: Any) -> None:
    if isinstance(planes, np.ndarray):
        write(slots.values[first : first + len(planes)], planes)
    else:
        copy(slots.values, planes, count=planes.size, offset=first)
