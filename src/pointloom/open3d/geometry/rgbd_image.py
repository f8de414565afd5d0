"""RGBDImage: a color image and a depth image [m], shared with `np.asarray`."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ...cameras import images
from ...core.devices import resolve_device
from ...kernels.lang import float32, uint8
from ...kernels.memory import upload
from ..argument_types import ImageLike
from ..wrapper import Rows
from .geometry import Geometry2D
from .image import Image, below, depth_of, pixels_of


class RGBDImage(Geometry2D):
    """Intensity (float32) or color (uint8), and depth (float32) [m], 0 if missing."""

    _kind = images.RGBDImage

    color = Rows(Image)
    depth = Rows(Image)

    def __init__(self):
        self._wrapped, self._shared = None, {}

    def _read(self, name: str) -> NDArray[Any]:
        return np.zeros((0, 0), np.float32) if self._wrapped is None else getattr(self._wrapped, name)

    def _made(self, changed: list[str]) -> Any:
        color, depth = np.asarray(self.color), np.asarray(self.depth)
        if color.shape[:2] != depth.shape:
            raise ValueError(f"color, depth: expected one size, got {list(color.shape[:2])} and {list(depth.shape)}")
        cpu, is_gray = resolve_device("cpu"), color.dtype != np.uint8
        pixels = (
            upload(color.flatten(), float32, cpu)
            if is_gray
            else upload(np.broadcast_to(color.reshape(depth.size, -1), (depth.size, 3)).copy(), uint8, cpu)
        )
        return images.RGBDImage.from_device_arrays(pixels, upload(depth.flatten(), float32, cpu), *depth.shape)

    @classmethod
    def create_from_color_and_depth(
        cls,
        color: ImageLike,
        depth: ImageLike,
        depth_scale: float = 1000.0,
        depth_trunc: float = 3.0,
        convert_rgb_to_intensity: bool = True,
    ) -> Self:
        """Make an image. Depth is divided by `depth_scale`, and 0 from `depth_trunc` on."""
        pixels, numbers = pixels_of(color, "color"), depth_of(depth, bytes_too=True)
        is_gray = pixels.dtype == np.float32 and (pixels.ndim == 2 or convert_rgb_to_intensity)
        taken = np.zeros(numbers.shape, np.uint8) if is_gray else pixels
        made = images.RGBDImage.create_from_color_and_depth(
            taken, numbers, depth_scale, below(depth_trunc), convert_rgb_to_intensity
        )
        image = cls.from_native(made)
        if is_gray:
            image.color = Image(Image(pixels).gray_floats())
        elif pixels.ndim == 2 and not convert_rgb_to_intensity:
            image.color = Image(pixels)
        return image

    @classmethod
    def create_from_redwood_format(
        cls, color: ImageLike, depth: ImageLike, convert_rgb_to_intensity: bool = True
    ) -> Self:
        """A frame of the Redwood datasets."""
        return cls.create_from_color_and_depth(color, depth, 1000.0, 4.0, convert_rgb_to_intensity)

    @classmethod
    def create_from_tum_format(cls, color: ImageLike, depth: ImageLike, convert_rgb_to_intensity: bool = True) -> Self:
        """A frame of the TUM datasets."""
        return cls.create_from_color_and_depth(color, depth, 5000.0, 4.0, convert_rgb_to_intensity)

    @classmethod
    def create_from_sun_format(cls, color: ImageLike, depth: ImageLike, convert_rgb_to_intensity: bool = True) -> Self:
        raw = pixels_of(depth, "depth")
        return cls.from_native(
            images.RGBDImage.create_from_sun_format(pixels_of(color, "color"), raw, convert_rgb_to_intensity)
        )

    @classmethod
    def create_from_nyu_format(cls, color: ImageLike, depth: ImageLike, convert_rgb_to_intensity: bool = True) -> Self:
        """A raw frame of NYU Depth v2."""
        raw = pixels_of(depth, "depth")
        return cls.from_native(
            images.RGBDImage.create_from_nyu_format(pixels_of(color, "color"), raw, convert_rgb_to_intensity)
        )

    def is_empty(self) -> bool:
        return self.color.is_empty() or self.depth.is_empty()

    def clear(self) -> Self:
        self._wrapped, self._shared = None, {}
        return self

    def get_min_bound(self) -> NDArray[np.float64]:
        """(0, 0)."""
        return np.zeros(2)

    def get_max_bound(self) -> NDArray[np.float64]:
        """Twice the width (both images side by side), and the height."""
        return self.color.get_max_bound() * (2, 1)

    def __repr__(self) -> str:
        sizes = [repr(image).partition("\n")[0].removeprefix("Image of size ") for image in (self.color, self.depth)]
        text = f"Color image : {sizes[0]}\nDepth image : {sizes[1]}"
        return f"RGBDImage of size \n{text}\nUse numpy.asarray to access buffer data."
