"""Depth and color images: validated input of RGB-D operations."""

from __future__ import annotations

import os
from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.argument_errors import explain_argument_errors
from ..core.array_libraries import NUMPY, check_library, library_of, owned, view_as
from ..core.attribute_hints import HintedNames
from ..core.checks import check_count, check_positive, is_on_gpu
from ..core.devices import DeviceLike
from ..core.gpu_arrays import INTEGERS, device_for, take_numbers
from ..core.masked_arrays import unmasked
from ..core.pickled_arrays import check_form, device_like, pickled, unpickled, unpickling
from ..kernels.arrays.row_numbers import limits_of
from ..kernels.images.depth import decode_depth, intensity_of, metric_depth
from ..kernels.lang import float32, float64, int8, int64, uint8, uint16
from ..kernels.memory import cast, clone, download, empty, fill_column, upload
from .camera import PinholeCameraIntrinsic, check_camera
from .depth_checks import warn_of_scale
from .depth_range import DEPTH_SCALE, OPEN3D_DEPTH_MAX

MAX_RAW = 65535  # maximum integer depth
FLOATS = (wp.float16, float32, float64)
BYTES = (int8, uint8)  # 8-bit types: images, no depth
TOO_SHALLOW = (
    "depth: expected 16-bit integers or float meters, got {}: 8-bit images only visualize depth. Read the data "
    "set's 16-bit files, or convert distances to float meters"
)
TOO_DEEP = "depth: expected integers in 0..65535. Convert larger depths to float meters"
RAW_TRUNC = 7.0  # [m] where Open3D truncates frames of long-range data sets


class RGBDImage(HintedNames):
    """A depth image in meters with a color or gray image of the same size, on one device.

    Args:
        color: 8-bit colors, shape (h, w, 3), or gray (h, w).
        depth: Shape (h, w). Integers of 16 bits and more, or floats.
        depth_scale: Depth units per meter; None: 1000 for integers, 1 for floats.
        depth_trunc: Maximum depth [m]. Larger depths become 0 (no measurement).
        device: Device of the images; None: the GPU that the depth is on, else the CPU.

    Raises:
        ValueError: Wrong shapes, or depth and color of different sizes.
        TypeError: Wrong element types. 8-bit depth.

    Warns:
        UnitWarning: A scale or limit removes all depth, or float depth on the host seems to be millimeters.

    Attributes:
        depth_array: Depth on the device, float32 (h * w,) [m], 0 without measurement.
        color_array: Colors on the device, uint8 (h * w, 3), or intensity, float32 (h * w,).
        width: Columns [px].
        height: Rows [px].
        device: Device of the arrays.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rgbd = loom.RGBDImage(np.zeros((2, 3, 3), np.uint8), np.full((2, 3), 1500, np.uint16))
        >>> float(rgbd.depth[0, 0]), rgbd.width, rgbd.height
        (1.5, 3, 2)
    """

    _fixed = ("color_array", "depth_array", "height", "width", "device")
    _internal = ("from_device_arrays",)

    @explain_argument_errors
    def __init__(
        self,
        color: ArrayLike,
        depth: ArrayLike,
        *,
        depth_scale: float | None = None,
        depth_trunc: float = OPEN3D_DEPTH_MAX,
        device: DeviceLike = None,
    ):
        where = device_for(depth, device)
        self.depth_array, scale, self.height, self.width = upload_depth(
            depth, depth_scale, depth_trunc, where, limit="depth_trunc"
        )
        self.color_array = upload_color(color, self.height, self.width, where)
        if isinstance(depth, np.ndarray):
            warn_of_scale(depth, scale, depth_trunc)
        self.device, self._library = where, library_of(depth)

    @classmethod
    @explain_argument_errors
    def create_from_color_and_depth(
        cls,
        color: ArrayLike,
        depth: ArrayLike,
        depth_scale: float | None = None,
        depth_trunc: float = OPEN3D_DEPTH_MAX,
        convert_rgb_to_intensity: bool = True,
        *,
        device: DeviceLike = None,
    ) -> Self:
        """An RGB-D image with Open3D's defaults: colors become intensities.

        Args:
            color: 8-bit colors, shape (h, w, 3), or gray (h, w).
            depth: Shape (h, w). Integers of 16 bits and more, or floats (Open3D takes 8 bits for 0..1).
            depth_scale: Depth units per meter; None: 1000 for integers, 1 for floats (Open3D divides floats by 1000).
            depth_trunc: Maximum depth [m], included (excluded in Open3D).
            convert_rgb_to_intensity: Store 0.299 R + 0.587 G + 0.114 B, 0..1, instead of colors.
            device: Device of the images; None: the GPU that the depth is on, else the CPU.

        Raises:
            ValueError: Wrong shapes, or depth and color of different sizes.
            TypeError: Wrong element types.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> red = np.full((1, 1, 3), (255, 0, 0), np.uint8)
            >>> rgbd = loom.RGBDImage.create_from_color_and_depth(red, np.full((1, 1), 2000, np.uint16))
            >>> round(float(rgbd.color[0, 0]), 3)
            0.299
        """
        image = cls(color, depth, depth_scale=depth_scale, depth_trunc=depth_trunc, device=device)
        if convert_rgb_to_intensity:
            vars(image)["color_array"] = intensity_of(image.color_array)
        return image

    create_from_color_and_depth = create_from_color_and_depth

    @classmethod
    def create_from_redwood_format(
        cls, color: ArrayLike, depth: ArrayLike, convert_rgb_to_intensity: bool = True, *, device: DeviceLike = None
    ) -> Self:
        """A frame of the Redwood data sets: millimeters, truncated at 4 m. See `create_from_color_and_depth`."""
        return cls.create_from_color_and_depth(color, depth, 1000.0, 4.0, convert_rgb_to_intensity, device=device)

    @classmethod
    def create_from_tum_format(
        cls, color: ArrayLike, depth: ArrayLike, convert_rgb_to_intensity: bool = True, *, device: DeviceLike = None
    ) -> Self:
        """A frame of the TUM RGB-D data sets: 5000 units per meter, cut at 4 m. See `create_from_color_and_depth`."""
        return cls.create_from_color_and_depth(color, depth, 5000.0, 4.0, convert_rgb_to_intensity, device=device)

    @classmethod
    def create_from_sun_format(
        cls, color: ArrayLike, depth: ArrayLike, convert_rgb_to_intensity: bool = True, *, device: DeviceLike = None
    ) -> Self:
        """A frame of SUN3D: 16-bit millimeters rotated left by three bits, truncated at 7 m.

        Arguments and errors as in `create_from_color_and_depth`. Depth must be integers.
        """
        return cls._from_raw("sun", color, depth, convert_rgb_to_intensity, device)

    @classmethod
    def create_from_nyu_format(
        cls, color: ArrayLike, depth: ArrayLike, convert_rgb_to_intensity: bool = True, *, device: DeviceLike = None
    ) -> Self:
        """A raw frame of NYU Depth v2: 351.3 / (1092.5 - d) meters, truncated at 7 m.

        Arguments and errors as in `create_from_color_and_depth`. Depth is 16-bit integers as read from .pgm, whose
        swapped bytes are corrected here.
        """
        return cls._from_raw("nyu", color, depth, convert_rgb_to_intensity, device)

    create_from_redwood_format = create_from_redwood_format
    create_from_tum_format = create_from_tum_format
    create_from_sun_format = create_from_sun_format
    create_from_nyu_format = create_from_nyu_format

    @property
    def depth(self) -> NDArray[np.float32]:
        """Depth [m], float32 (h, w). 0 without measurement."""
        return owned(self.depth_array).reshape(self.height, self.width)

    @property
    def color(self) -> NDArray[Any]:
        """Colors, uint8 (h, w, 3), or intensities 0..1, float32 (h, w)."""
        pixels = download(self.color_array)
        return pixels.reshape(self.height, self.width, *pixels.shape[1:]).copy()

    def __repr__(self) -> str:
        return f"RGBDImage({self.width} x {self.height}, {self.device})"

    def __copy__(self) -> Self:
        return self.from_device_arrays(self.color_array, self.depth_array, self.height, self.width, self._library)

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        arrays = clone(self.color_array), clone(self.depth_array)
        return self.from_device_arrays(*arrays, self.height, self.width, self._library)

    def __getstate__(self) -> dict[str, Any]:
        state = {"device": str(self.device), "library": self._library, "height": self.height, "width": self.width}
        return state | {"arrays": pickled({"color_array": self.color_array, "depth_array": self.depth_array})}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Restore the image on its device, else on the first GPU. Raises `DeviceError` without GPU."""
        with unpickling("image"):
            arrays = unpickled(state["arrays"], device_like("image", state["device"]))
            height, width = (check_count(name, state[name]) for name in ("height", "width"))
            flat = float32, (height * width,)
            color = check_form("color_array", arrays["color_array"], (uint8, (height * width, 3)), flat)
            depth = check_form("depth_array", arrays["depth_array"], flat)
            made = self.from_device_arrays(color, depth, height, width, check_library("library", state["library"]))
        vars(self).update(vars(made))

    @classmethod
    def _from_raw(cls, layout: str, color: ArrayLike, depth: ArrayLike, to_intensity: bool, device: DeviceLike) -> Self:
        where = device_for(depth, device)
        raw, height, width = _upload_raw(depth, where)
        metric, _ = metric_depth(decode_depth(raw, layout), 1000.0, RAW_TRUNC)
        pixels = upload_color(color, height, width, where)
        colors = intensity_of(pixels) if to_intensity else pixels
        return cls.from_device_arrays(colors, metric, height, width, library_of(depth))

    @classmethod
    def from_device_arrays(
        cls, color: wp.array, depth: wp.array, height: int, width: int, library: str = NUMPY
    ) -> Self:
        image = cls.__new__(cls)
        image.color_array, image.depth_array, image.height, image.width = color, depth, height, width
        image.device, image._library = depth.device, library
        return image

    @property
    def array_library(self) -> str:
        """The library of the arrays that operations return: that of the input depth."""
        return self._library


def upload_depth(
    depth: ArrayLike, depth_scale: float | None, depth_max: float, device: DeviceLike, *, limit: str = "depth_max"
) -> tuple[wp.array, float, int, int]:
    """Upload depth as flat float32 [m]. Returns the array, the scale, height and width.
    Zero, negative, NaN and infinite depths, and those beyond `depth_max`, become 0. `limit` is its name in errors."""
    raw, scale, farthest, height, width = upload_raw_depth(depth, depth_scale, depth_max, device, limit=limit)
    return metric_depth(raw, scale, farthest)[0], scale, height, width


def upload_raw_depth(
    depth: Any,
    depth_scale: float | None,
    depth_max: float,
    device: Any,
    *,
    limit: str = "depth_max",
    on_host: bool = False,
) -> tuple[Any, float, float, int, int]:
    """Upload checked depth as flat uint16 or float32. Returns the array, the scale, the limit, height and width.
    `on_host`: depth of the host stays there."""
    image: Any = take_numbers("depth", depth, device) if is_on_gpu(depth) else _as_array("depth", depth)
    _check_size(image)
    scale = None if depth_scale is None else check_positive("depth_scale", depth_scale)
    farthest = check_positive(limit, depth_max, allow_infinite=True)
    if is_on_gpu(depth):
        raw = _flat_floats(image) if image.dtype in FLOATS else _flat_integers(image)
    elif image.dtype.kind == "f":
        with np.errstate(over="ignore"):  # a depth beyond float32 becomes infinite: no measurement
            raw = np.ascontiguousarray(image.reshape(-1), np.float32)
        raw = raw if on_host else upload(raw, float32, device)
    else:
        raw = _upload_raw(image, device, on_host=on_host)[0]
    if scale is None:
        scale = 1.0 if raw.dtype in (float32, np.float32) else DEPTH_SCALE
    return raw, scale, farthest, image.shape[0], image.shape[1]


def integer_scale(depth: RGBDImage | ArrayLike, depth_scale: float) -> float | None:
    """The depth scale of a source of integers. None for floats, which are in meters."""
    if isinstance(depth, RGBDImage):
        return None
    if is_on_gpu(depth):
        return None if take_numbers("depth", depth).dtype in FLOATS else depth_scale
    return None if _as_array("depth", depth).dtype.kind == "f" else depth_scale


def _as_array(name: str, values: object) -> NDArray[Any]:
    if type(values) is np.ndarray:
        return values
    if isinstance(values, str | os.PathLike):
        raise TypeError(f"{name}: expected an array, got a path; loom.read_{name}(path) reads it")
    plain = unmasked(name, values, missing=0 if name == "depth" else None)
    try:
        return np.asarray(plain)
    except (ValueError, TypeError) as error:
        raise TypeError(f"{name}: expected numbers, got {type(values).__name__} ({error})") from error


def _check_size(image: Any) -> None:
    if image.ndim != 2 or 0 in image.shape:
        remedy = "; color comes first, then depth" if image.ndim == 3 else ""
        raise ValueError(f"depth: expected shape [h, w], got {list(image.shape)}{remedy}")


def _flat_floats(image: wp.array) -> wp.array:
    """Depth on a GPU as flat float32, without a copy if possible."""
    flat = view_as(image, image.dtype, (image.size,))
    return flat if image.dtype == float32 else cast(flat, float32)


def _flat_integers(image: wp.array) -> wp.array:
    """Integer depth on a GPU as flat uint16, without a copy if possible."""
    if image.dtype not in INTEGERS:
        raise TypeError(f"depth: expected integers or floats, got {image.dtype.__name__}")
    if image.dtype in BYTES:
        raise TypeError(TOO_SHALLOW.format(image.dtype.__name__))
    flat = view_as(image, image.dtype, (image.size,))
    if image.dtype == uint16:
        return flat
    low, high = limits_of(cast(flat, int64))
    if low < 0 or high > MAX_RAW:
        raise ValueError(TOO_DEEP)
    return cast(flat, uint16)


def upload_taken(image: Any, device: Any) -> Any:
    """An image that stayed on the host, on the device. Another one, or None, as it is."""
    return upload(image, wp.dtype_from_numpy(image.dtype), device) if isinstance(image, np.ndarray) else image


def _upload_raw(depth: Any, device: Any, *, on_host: bool = False) -> tuple[Any, int, int]:
    """Integer depth on the device as flat uint16, with height and width. `on_host` as in `upload_raw_depth`."""
    if is_on_gpu(depth):
        given = take_numbers("depth", depth, device)
        _check_size(given)
        return _flat_integers(given), given.shape[0], given.shape[1]
    image = _as_array("depth", depth)
    _check_size(image)
    if image.dtype.kind not in "iu":
        expected = "the file's integers" if image.dtype.kind == "f" else "integers or floats"
        raise TypeError(f"depth: expected {expected}, got {image.dtype}")
    if image.dtype.itemsize == 1:
        raise TypeError(TOO_SHALLOW.format(image.dtype))
    if image.dtype != np.uint16 and (image.min() < 0 or image.max() > MAX_RAW):
        raise ValueError(TOO_DEEP)
    raw = np.ascontiguousarray(image.reshape(-1), np.uint16)
    return raw if on_host else upload(raw, uint16, device), image.shape[0], image.shape[1]


def upload_color(color: Any, height: int, width: int, device: Any, *, on_host: bool = False) -> Any:
    """Upload checked colors as uint8 (h * w, 3). `on_host`: colors of the host stay there."""
    image = take_numbers("color", color, device) if is_on_gpu(color) else _as_array("color", color)
    kind = image.dtype if isinstance(image, np.ndarray) else wp.dtype_to_numpy(image.dtype)
    if kind != np.uint8:
        raise TypeError(f"color: expected uint8, got {np.dtype(kind)}; scale floats by 255 and round")
    if image.ndim == 2:
        image = np.repeat(image[:, :, None], 3, axis=2) if isinstance(image, np.ndarray) else _repeated(image)
    if image.ndim != 3 or image.shape[2] != 3:
        raise ValueError(f"color: expected shape [h, w, 3], got {list(image.shape)}")
    if image.shape[:2] != (height, width):
        have = f"{image.shape[1]} x {image.shape[0]}"
        raise ValueError(f"color: {have} pixels, but the depth image has {width} x {height}; resize one of them")
    if not isinstance(image, np.ndarray):
        return view_as(image, uint8, (height * width, 3))
    pixels = np.ascontiguousarray(image.reshape(-1, 3))
    return pixels if on_host else upload(pixels, uint8, device)


def _repeated(gray: wp.array) -> wp.array:
    pixels = empty((gray.size, 3), uint8, gray.device)
    for channel in range(3):
        fill_column(pixels, channel, view_as(gray, uint8, (gray.size,)))
    return view_as(pixels, uint8, (*gray.shape, 3))


def check_intrinsic(intrinsic: object, width: int, height: int, name: str = "intrinsic") -> PinholeCameraIntrinsic:
    """The camera of an image of this size, also from its matrix [3, 3]."""
    camera = check_camera(name, intrinsic, (width, height))
    if (camera.width, camera.height) != (width, height):
        expected = f"{camera.width} x {camera.height}"
        is_alike = camera.width * height == camera.height * width
        remedy = f"; {name}.scaled({width / camera.width:g}) is the same camera at that size" if is_alike else ""
        raise ValueError(f"{name}: made for {expected} pixels, but the image has {width} x {height}{remedy}")
    return camera
