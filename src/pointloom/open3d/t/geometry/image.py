"""Image of a tensor. Filters of colors run on the host by SciPy, those of depth on the device by pointloom."""

from __future__ import annotations

import enum
from collections.abc import Callable
from typing import Any, Self

import numpy as np
import PIL.Image
from numpy.typing import DTypeLike, NDArray
from scipy import ndimage

from ....cameras.camera import PinholeCameraIntrinsic
from ....cameras.depth_filters import filter_depth_bilateral
from ....pcd.cloud import PointCloud
from ....visualization.render.colormaps import colormap_table
from ... import geometry as legacy
from ...argument_types import DeviceLike, ImageLike, TensorLike
from ...core.dtype import Dtype, float32, float64, int64, uint8, uint16
from ...core.tensor import Tensor
from ...geometry.image import GRAY_WEIGHTS, pixels_of
from .geometry import CPU, Geometry, device_of
from .tensor_map import array_of, matrix_of, tensor_of, wrap

SOBEL_SMOOTHING = {3: [1, 2, 1], 5: [1, 4, 6, 4, 1]}  # columns and rows of Sobel's filters by size
SOBEL_SLOPE = {3: [-1, 0, 1], 5: [-1, -2, 0, 2, 1]}


class InterpType(enum.Enum):
    """Interpolation of `Image.resize`."""

    Nearest, Linear, Cubic, Lanczos, Super = range(5)


PILLOW = {
    InterpType.Cubic: PIL.Image.Resampling.BICUBIC,
    InterpType.Lanczos: PIL.Image.Resampling.LANCZOS,
    InterpType.Super: PIL.Image.Resampling.BOX,
}


class Image(Geometry):
    """An image, a tensor of shape (rows, columns, channels).

    Args:
        rows: Number of rows of a black image. Or a tensor of shape (h, w) or (h, w, c), or an image, both shared.
        cols, channels, dtype, device: Of a black image.
    """

    _parts = ("_data",)
    _data: Tensor

    def __init__(
        self,
        rows: object = 0,
        cols: int = 0,
        channels: int = 1,
        dtype: Dtype = float32,
        device: DeviceLike = CPU,
        *,
        tensor: object = None,
    ):
        given = rows if tensor is None else tensor
        if isinstance(given, Image):
            given = given.as_tensor()
        elif isinstance(given, int):
            given = Tensor(np.zeros((given, cols, channels), dtype.numpy), device=device_of(device))
        data = tensor_of("tensor", given)
        if len(data.shape) not in (2, 3):
            raise ValueError(f"tensor: expected shape [h, w] or [h, w, c], got {list(data.shape)}")
        self._data = data if len(data.shape) == 3 else data.reshape((*data.shape, 1))
        self._home = data.device

    def as_tensor(self) -> Tensor:
        """The tensor itself, (rows, columns, channels)."""
        return self._data

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """The memory of an image on the CPU, or a copy."""
        return self._data.__array__(dtype, copy)

    @property
    def rows(self) -> int:
        return int(self._data.shape[0])

    @property
    def columns(self) -> int:
        return int(self._data.shape[1])

    @property
    def channels(self) -> int:
        return int(self._data.shape[2])

    @property
    def dtype(self) -> Dtype:
        return self._data.dtype

    def is_empty(self) -> bool:
        return self.rows * self.columns == 0

    def clear(self) -> Self:
        self._data = Tensor(np.zeros((0, 0, 1), self.dtype.numpy), device=self.device)
        return self

    def get_min_bound(self) -> Tensor:
        return Tensor([0, 0], int64)

    def get_max_bound(self) -> Tensor:
        """Rows and columns."""
        return Tensor([self.rows, self.columns], int64)

    @staticmethod
    def from_legacy(image_legacy: ImageLike, device: DeviceLike = CPU) -> Image:
        return Image(Tensor(pixels_of(image_legacy, "image_legacy"), device=device_of(device)))

    def to_legacy(self) -> Any:
        return legacy.Image(self._data.numpy())

    def to(self, *args: Any, **keywords: Any) -> Image:
        """The image on a device, `to(device, copy=False)`, or of a type, `to(dtype, copy=False, scale=None, offset=0)`.

        By default bytes and 16 bits are scaled to 0..1 for floats. Integers are rounded and limited to their range.
        """
        if isinstance(args[0] if args else keywords.get("dtype"), Dtype):
            return self._converted(*args, **keywords)
        return super().to(*args, **keywords)

    def _converted(self, dtype: Dtype, copy: bool = False, scale: float | None = None, offset: float = 0.0) -> Image:
        if dtype == self.dtype and scale is None and offset == 0:
            return self.clone() if copy else self
        if scale is None:
            scale = {uint8: 1 / 255, uint16: 1 / 65535}.get(self.dtype, 1.0) if dtype in (float32, float64) else 1.0
        return self._like(self._data.numpy() * np.float64(scale) + offset, dtype)

    def _like(self, values: NDArray[Any], dtype: Dtype | None = None) -> Image:
        """An image of values on the same device, rounded and limited for integers."""
        kind = (dtype or self.dtype).numpy
        if kind.kind in "iu":
            limits = np.iinfo(kind)
            values = np.rint(values).clip(limits.min, limits.max)
        return Image(Tensor(values.astype(kind), device=self.device))

    def _filtered(self, function: Callable[[NDArray[np.float64]], NDArray[Any]], dtype: Dtype | None = None) -> Image:
        """An image of the results of a function for each channel, in float64."""
        values = self._data.numpy().astype(np.float64)
        return self._like(np.stack([function(values[..., c]) for c in range(self.channels)], axis=-1), dtype)

    def linear_transform(self, scale: float = 1.0, offset: float = 0.0) -> Self:
        """Scale the values and add an offset, in place."""
        self._data[:] = self._converted(self.dtype, True, scale, offset).as_tensor()
        return self

    def rgb_to_gray(self) -> Image:
        if self.channels != 3:
            raise ValueError(f"image: expected 3 channels, got {self.channels}")
        return self._like((self._data.numpy() @ GRAY_WEIGHTS.astype(np.float64))[..., None])

    def resize(self, sampling_rate: float = 0.5, interp_type: InterpType = InterpType.Nearest) -> Image:
        """Scale the size. Cubic, Lanczos and Super are Pillow's, which average when they shrink."""
        height, width = int(self.rows * sampling_rate), int(self.columns * sampling_rate)
        if interp_type in PILLOW:
            return self._filtered(
                lambda v: np.asarray(
                    PIL.Image.fromarray(v.astype(np.float32)).resize((width, height), PILLOW[interp_type])
                )
            )
        y = (np.arange(height) + 0.5) * (self.rows / max(height, 1)) - 0.5
        x = (np.arange(width) + 0.5) * (self.columns / max(width, 1)) - 0.5
        if interp_type == InterpType.Nearest:
            return self._like(self._data.numpy()[np.ix_(np.ceil(y - 0.5).astype(int), np.ceil(x - 0.5).astype(int))])
        places = np.meshgrid(y, x, indexing="ij")
        return self._filtered(lambda v: ndimage.map_coordinates(v, places, order=1, mode="nearest"))

    def dilate(self, kernel_size: int = 3) -> Image:
        return self._filtered(lambda v: ndimage.maximum_filter(v, kernel_size, mode="nearest"))

    def filter(self, kernel: TensorLike) -> Image:
        """Correlate with a kernel (h, w)."""
        weights = array_of("kernel", kernel).astype(np.float64)
        return self._filtered(lambda v: ndimage.correlate(v, weights, mode="nearest"))

    def filter_gaussian(self, kernel_size: int = 3, sigma: float = 1.0) -> Image:
        return self._filtered(lambda v: ndimage.gaussian_filter(v, sigma, radius=kernel_size // 2, mode="nearest"))

    def filter_sobel(self, kernel_size: int = 3) -> tuple[Image, Image]:
        """Slopes along x and y, int16 of bytes. `kernel_size` is 3 or 5."""
        if kernel_size not in SOBEL_SLOPE:
            raise ValueError(f"kernel_size: expected 3 or 5, got {kernel_size}")
        slope, smoothing = SOBEL_SLOPE[kernel_size], SOBEL_SMOOTHING[kernel_size]

        def along(axis: int) -> Callable[[NDArray[np.float64]], NDArray[Any]]:
            return lambda v: ndimage.correlate1d(
                ndimage.correlate1d(v, slope, axis, mode="nearest"), smoothing, 1 - axis, mode="nearest"
            )

        kind = INT16 if self.dtype == uint8 else self.dtype
        return self._filtered(along(1), kind), self._filtered(along(0), kind)

    def filter_bilateral(self, kernel_size: int = 3, value_sigma: float = 20.0, dist_sigma: float = 10.0) -> Image:
        """Smooth within edges. A float image of one channel is depth, in which 0 and NaN are holes and remain."""
        if self.channels > 1 or self.dtype != float32:
            return self._like(
                _bilateral(self._data.numpy().astype(np.float64), kernel_size // 2, value_sigma, dist_sigma)
            )
        depth = self._data.reshape((self.rows, self.columns))
        smooth = wrap(filter_depth_bilateral(depth.array, kernel_size, value_sigma, dist_sigma))
        smooth[depth.isnan()] = float("nan")
        return Image(smooth)

    def pyrdown(self) -> Image:
        """Half the size: every second pixel after a Gaussian filter over 5 x 5 pixels."""
        smooth = self.filter_gaussian(5, 1.0).as_tensor().numpy()
        return self._like(smooth[: self.rows // 2 * 2 : 2, : self.columns // 2 * 2 : 2])

    def clip_transform(self, scale: float, min_value: float, max_value: float, clip_fill: float = 0.0) -> Image:
        """Depth divided by `scale`, float32, and `clip_fill` where it is not between the limits."""
        self._check_depth(uint16, float32)
        metric = self._data.numpy().astype(np.float32) / np.float32(scale)
        is_outside = (metric <= min_value) | (metric >= max_value)
        return self._like(np.where(is_outside, np.float32(clip_fill), metric), float32)

    def create_vertex_map(self, intrinsics: TensorLike, invalid_fill: float = 0.0) -> Image:
        """Points of the pixels in the camera frame, float32 (h, w, 3)."""
        self._check_depth(float32)
        K = matrix_of("intrinsics", intrinsics, (3, 3))
        camera = PinholeCameraIntrinsic(self.columns, self.rows, K)
        depth = self._data.reshape((self.rows, self.columns))
        made = PointCloud.create_from_depth_image(depth.array, camera, None, 1.0, np.inf, 1, False)
        points = wrap(made.arrays.hand_out(made.arrays["points"]))
        if not np.isnan(invalid_fill):
            points[points.isnan()] = invalid_fill
        return Image(points.reshape((self.rows, self.columns, 3)))

    def create_normal_map(self, invalid_fill: float = 0.0) -> Image:
        """Normals toward the camera of a vertex map, from the differences to the pixels below and on the right."""
        if self.channels != 3 or self.dtype != float32:
            raise ValueError(
                f"image: expected a vertex map, float32 of 3 channels, got {self.dtype} of {self.channels}"
            )
        points = self._data.numpy().astype(np.float64)
        is_hole = (points == invalid_fill).all(axis=2) | ~np.isfinite(points).all(axis=2)
        corner = points[:-1, :-1]
        with np.errstate(invalid="ignore", divide="ignore"):
            normals = np.cross(points[1:, :-1] - corner, points[:-1, 1:] - corner)
            normals /= np.linalg.norm(normals, axis=2, keepdims=True)
        normals[is_hole[:-1, :-1] | is_hole[1:, :-1] | is_hole[:-1, 1:] | ~np.isfinite(normals).all(axis=2)] = (
            invalid_fill
        )
        return self._like(np.pad(normals, ((0, 1), (0, 1), (0, 0)), constant_values=invalid_fill), float32)

    def colorize_depth(self, scale: float, min_value: float, max_value: float) -> Image:
        """Colors of depth divided by `scale` between the limits, uint8, with the colormap turbo."""
        self._check_depth(uint16, float32)
        metric = self._data.numpy()[..., 0].astype(np.float64) / scale
        steps = np.nan_to_num((metric - min_value) / (max_value - min_value)).clip(0, 1) * 255
        return self._like(colormap_table("turbo")[steps.astype(np.uint8)] * 255.0, uint8)

    def _check_depth(self, *types: Dtype) -> None:
        if self.channels != 1 or self.dtype not in types:
            wanted = " or ".join(map(str, types))
            raise ValueError(f"image: expected depth, {wanted} of 1 channel, got {self.dtype} of {self.channels}")

    def __repr__(self) -> str:
        size = f"size={{{self.rows},{self.columns}}}"
        return f"Image[{size}, channels={self.channels}, {self.dtype}, {self.device}]"


INT16 = Dtype.from_numpy(np.int16)


def _bilateral(pixels: NDArray[np.float64], radius: int, value_sigma: float, dist_sigma: float) -> NDArray[np.float64]:
    """Mean over a disc of pixels, weighted by distance and by the sum of the channels' differences."""
    height, width = pixels.shape[:2]
    padded = np.pad(pixels, ((radius, radius), (radius, radius), (0, 0)), mode="edge")
    total, weights = np.zeros_like(pixels), np.zeros((height, width, 1))
    for y, x in np.ndindex(2 * radius + 1, 2 * radius + 1):
        squared = (y - radius) ** 2 + (x - radius) ** 2
        if squared <= radius**2:
            other = padded[y : y + height, x : x + width]
            difference = np.abs(other - pixels).sum(axis=2, keepdims=True)
            weight = np.exp(-squared / (2 * dist_sigma**2) - difference**2 / (2 * value_sigma**2))
            total += weight * other
            weights += weight
    return total / weights
