"""Images of tensors as those of pointloom."""

from __future__ import annotations

from typing import Any

import numpy as np

from .....cameras.images import RGBDImage, upload_depth
from .....core.devices import resolve_device
from .....kernels.lang import float32
from .....kernels.memory import upload
from ....core.tensor import Tensor
from ....geometry.image import GRAY_WEIGHTS
from ..tensors import on_host


def rgbd_of(name: str, image: object, depth_scale: float) -> RGBDImage:
    """The pointloom image of a t.geometry.RGBDImage, on its device. Raises TypeError."""
    color, depth = (getattr(image, part, None) for part in ("color", "depth"))
    if color is None or depth is None:
        hint = "; RGBDImage(color, depth) of t.io.read_image makes one"
        raise TypeError(f"{name}: expected a t.geometry.RGBDImage, got {type(image).__name__}{hint}")
    return frame_of(color.as_tensor(), depth.as_tensor(), depth_scale)


def frame_of(color: Tensor, depth: Tensor, depth_scale: float) -> RGBDImage:
    """An image of a color tensor (h, w, 1 or 3), uint8 or floats 0..1, and a depth tensor (h, w, 1)."""
    pixels = plane_of(depth)
    if color.dtype.numpy == np.uint8:
        gray = color.shape[-1] == 1 or len(color.shape) == 2
        made = plane_of(color) if gray else color.array
        return RGBDImage(made, pixels, depth_scale=depth_scale, depth_trunc=np.inf)
    metric, _, height, width = upload_depth(pixels, depth_scale, np.inf, resolve_device(depth.device.name))
    values = on_host(color).astype(np.float32)
    values = values @ GRAY_WEIGHTS if values.shape[2:] == (3,) else values
    shades = upload(values.reshape(-1), float32, metric.device)
    return RGBDImage.from_device_arrays(shades, metric, height, width)


def plane_of(image: Tensor) -> Any:
    """The array (h, w) of a tensor of one channel."""
    return image.array.reshape(tuple(image.shape[:2]))
