"""Depth and colour images: what the operations take, checked once."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..kernels.depth import metric_depth
from ..kernels.lang import float32, uint8, uint16
from ..kernels.memory import download, upload
from .camera import PinholeCameraIntrinsic
from .checks import check_positive
from .devices import resolve_device


class RGBDImage:
    """A depth image in metres with a colour image of the same size, on one device.

    Args:
        color: 8-bit colours, shape [h, w, 3], or grey [h, w].
        depth: Shape [h, w]; integers are divided by `depth_scale`, floats are metres.
        depth_scale: Integer units a metre.
        depth_trunc: Farthest depth kept [m]; beyond it a pixel has no measurement (0).
        device: Where the images go.

    Raises:
        ValueError: Wrong shapes, or depth and colour of different sizes.
        TypeError: Wrong element types.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> rgbd = loom.RGBDImage(np.zeros((2, 3, 3), np.uint8), np.full((2, 3), 1500, np.uint16))
        >>> float(rgbd.depth[0, 0]), rgbd.width, rgbd.height
        (1.5, 3, 2)
    """

    def __init__(
        self,
        color: ArrayLike,
        depth: ArrayLike,
        *,
        depth_scale: float = 1000.0,
        depth_trunc: float = 3.0,
        device: Any = None,
    ):
        where = resolve_device(device)
        self._depth, _, self.height, self.width = upload_depth(
            depth, depth_scale, depth_trunc, where, limit="depth_trunc"
        )
        self._color = upload_color(color, self.height, self.width, where)
        self.device = where

    @property
    def depth(self) -> NDArray[np.float32]:
        """Depth [m], float32 [h, w]; 0 where there is none."""
        return download(self._depth).reshape(self.height, self.width).copy()

    @property
    def color(self) -> NDArray[np.uint8]:
        """Colours, uint8 [h, w, 3]."""
        return download(self._color).reshape(self.height, self.width, 3).copy()

    def __repr__(self) -> str:
        return f"RGBDImage({self.width} x {self.height}, {self.device})"


def upload_depth(
    depth: Any, depth_scale: float, depth_max: float, device: Any, *, limit: str = "depth_max"
) -> tuple[wp.array, wp.array, int, int]:
    """A depth image as float32 metres on the device, flat; its largest depth (see largest_depth); height and width.

    Integers are divided by `depth_scale`; floats are metres already. Zero, negative, NaN and infinite depths, and
    those beyond `depth_max`, become 0: no measurement. Errors call that one by the name `limit`.
    """
    image = np.asarray(depth)
    if image.ndim != 2 or 0 in image.shape:
        raise ValueError(f"depth: expected shape [h, w], got {list(image.shape)}")
    scale = check_positive("depth_scale", depth_scale)
    farthest = float(depth_max)
    if not farthest > 0:
        raise ValueError(f"{limit}: expected a number > 0, got {depth_max!r}")
    if image.dtype.kind == "f":
        with np.errstate(over="ignore"):  # a depth beyond float32 is infinite: no measurement
            raw = upload(image.reshape(-1), float32, device)
    elif image.dtype == np.uint16:
        raw = upload(image.reshape(-1), uint16, device)
    elif image.dtype.kind in "iu":
        if image.size and (image.min() < 0 or image.max() > 65535):
            raise ValueError("depth: integer depths must lie in 0..65535; convert larger ones to float metres")
        raw = upload(image.reshape(-1).astype(np.uint16), uint16, device)
    else:
        raise TypeError(f"depth: expected integers or floats, got {image.dtype}")
    metric, largest = metric_depth(raw, scale, farthest)
    return metric, largest, image.shape[0], image.shape[1]


def upload_color(color: Any, height: int, width: int, device: Any) -> wp.array:
    """An 8-bit colour image on the device, uint8 [h * w, 3]; grey is repeated."""
    image = np.asarray(color)
    if image.dtype != np.uint8:
        raise TypeError(f"color: expected uint8, got {image.dtype}; scale floats by 255 and round")
    if image.ndim == 2:
        image = np.repeat(image[:, :, None], 3, axis=2)
    if image.ndim != 3 or image.shape[2] != 3:
        raise ValueError(f"color: expected shape [h, w, 3], got {list(image.shape)}")
    if image.shape[:2] != (height, width):
        have = f"{image.shape[1]} x {image.shape[0]}"
        raise ValueError(f"color: {have} pixels, but the depth image has {width} x {height}; resize one of them")
    return upload(image.reshape(-1, 3), uint8, device)


def check_intrinsic(intrinsic: Any, width: int, height: int) -> PinholeCameraIntrinsic:
    """The intrinsic, once it fits the image."""
    if not isinstance(intrinsic, PinholeCameraIntrinsic):
        kind = type(intrinsic).__name__
        raise TypeError(f"intrinsic: expected a PinholeCameraIntrinsic, got {kind}; see its from_matrix")
    if (intrinsic.width, intrinsic.height) != (width, height):
        expected = f"{intrinsic.width} x {intrinsic.height}"
        raise ValueError(f"intrinsic: made for {expected} pixels, but the image has {width} x {height}")
    return intrinsic
