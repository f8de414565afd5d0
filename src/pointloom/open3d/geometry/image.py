"""Image: an array shared with `np.asarray`, with Open3D's filters by scipy."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray
from scipy.ndimage import correlate1d

from ...core.attribute_hints import HintedNames
from ..argument_types import ImageLike
from .enums import ImageFilterType
from .geometry import GeometryType

# Separable kernels of Open3D's filters.
FILTER_WEIGHTS = {
    ImageFilterType.Gaussian3: ([0.25, 0.5, 0.25],) * 2,
    ImageFilterType.Gaussian5: ([0.0625, 0.25, 0.375, 0.25, 0.0625],) * 2,
    ImageFilterType.Gaussian7: ([0.03125, 0.109375, 0.21875, 0.28125, 0.21875, 0.109375, 0.03125],) * 2,
    ImageFilterType.Sobel3dx: ([-1.0, 0.0, 1.0], [1.0, 2.0, 1.0]),
    ImageFilterType.Sobel3dy: ([1.0, 2.0, 1.0], [-1.0, 0.0, 1.0]),
}
GRAY_WEIGHTS = np.array([0.2990, 0.5870, 0.1140], np.float32)


class Image(HintedNames):
    """An image, uint8, uint16 or float32, (h, w) or (h, w, c); `np.asarray(image)` is its memory."""

    _internal = ("refill", "gray_floats")

    Type = GeometryType

    def __init__(self, image: ArrayLike | Image | None = None):
        values: NDArray[Any] = np.zeros((0, 0), np.uint8) if image is None else np.asarray(image)
        if values.dtype not in (np.uint8, np.uint16, np.float32) or values.ndim not in (2, 3):
            raise TypeError(
                f"image: expected uint8, uint16 or float32 of shape [h, w] or [h, w, c], got {values.dtype} of "
                f"{list(values.shape)}; array.astype(np.float32) makes floats"
            )
        self._values = np.array(values[..., 0] if values.ndim == 3 and values.shape[2] == 1 else values, order="C")

    @classmethod
    def from_array(cls, values: NDArray[Any]) -> Self:
        """An image of a copy of values of the right type and shape."""
        image = cls()
        image.refill(values)
        return image

    def refill(self, values: NDArray[Any]) -> None:
        """Replace the pixels, in the same memory if they fit."""
        if self._values.shape == values.shape and self._values.dtype == values.dtype:
            self._values[...] = values
        else:
            self._values = np.array(values)

    def gray_floats(self) -> NDArray[np.float32]:
        """Gray floats as in Open3D: bytes over 255, larger types unscaled."""
        values = self._values.astype(np.float32) / np.float32(255 if self._values.dtype == np.uint8 else 1)
        return values if values.ndim == 2 else values[..., :3] @ GRAY_WEIGHTS

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """The memory itself, unless a copy or another type is requested."""
        values = self._values
        return np.array(values, dtype) if copy else values.astype(dtype or values.dtype, copy=False)

    def __repr__(self) -> str:
        height, width, channels = (*self._values.shape, 1)[:3] if self._values.size else (0, 0, 0)
        size = f"Image of size {width}x{height}, with {channels} channels."
        return f"{size}\nUse numpy.asarray to access buffer data."

    def __copy__(self) -> Image:
        return Image(self)

    def __deepcopy__(self, memo: dict[int, Any]) -> Image:
        return Image(self)

    def dimension(self) -> int:
        return 2

    def get_geometry_type(self) -> GeometryType:
        return GeometryType.Image

    def is_empty(self) -> bool:
        return self._values.size == 0

    def clear(self) -> Image:
        self._values = np.zeros((0, 0), np.uint8)
        return self

    def get_min_bound(self) -> NDArray[np.float64]:
        """(0, 0)."""
        return np.zeros(2)

    def get_max_bound(self) -> NDArray[np.float64]:
        """Width and height."""
        return np.array(self._values.shape[1::-1], np.float64)

    def flip_vertical(self) -> Image:
        return Image(self._values[::-1])

    def flip_horizontal(self) -> Image:
        return Image(self._values[:, ::-1])

    def filter(self, filter_type: ImageFilterType) -> Image:
        columns, rows = FILTER_WEIGHTS[filter_type]
        values = correlate1d(self.gray_floats(), columns, axis=1, mode="nearest")
        return Image(correlate1d(values, rows, axis=0, mode="nearest"))

    def create_pyramid(self, num_of_levels: int, with_gaussian_filter: bool) -> list[Image]:
        """Gray floats at successive half sizes (means of 2 x 2 pixels)."""
        levels = [self.gray_floats()]
        for _ in range(num_of_levels - 1):
            image = Image(levels[-1])
            fine = np.asarray(image.filter(ImageFilterType.Gaussian3) if with_gaussian_filter else image)
            height, width = fine.shape[0] // 2, fine.shape[1] // 2
            levels.append(fine[: 2 * height, : 2 * width].reshape(height, 2, width, 2).mean(axis=(1, 3)))
        return [Image(level) for level in levels]

    @staticmethod
    def filter_pyramid(image_pyramid: list[Image], filter_type: ImageFilterType) -> list[Image]:
        return [image.filter(filter_type) for image in image_pyramid]


def pixels_of(image: ImageLike, name: str = "image") -> NDArray[Any]:
    """The array of an image, or an array. Raises TypeError."""
    if not isinstance(image, Image | np.ndarray):
        raise TypeError(
            f"{name}: expected a geometry.Image, got {type(image).__name__}; o3d.io.read_image(path) reads one, "
            "o3d.geometry.Image(array) makes one"
        )
    return np.asarray(image)


def depth_of(depth: ImageLike, *, bytes_too: bool = False) -> NDArray[Any]:
    """Pixels of a depth image, 16 bits or floats, to be divided by a scale.

    Bytes are scaled to 0 to 1 if `bytes_too`, as Open3D does for RGBDImages. Otherwise they are rejected.
    """
    pixels = pixels_of(depth, "depth")
    if pixels.dtype == np.uint16 or (pixels.dtype == np.uint8 and not bytes_too):
        return pixels
    return Image(pixels).gray_floats()


def below(depth_trunc: float) -> float:
    """The largest depth below a limit: Open3D drops values at the limit."""
    return float(np.nextafter(np.float32(depth_trunc), np.float32(0)))
