"""Checked depth frames of one size: input of TSDFVolume.integrate_frames."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic, is_one_camera
from ...cameras.images import check_intrinsic, upload_color, upload_raw_depth
from ...core.checks import check_numeric, check_rigid, is_on_gpu
from ...core.gpu_arrays import take_numbers
from ...kernels.array_types import Device
from ...kernels.linear_algebra import inv
from ...kernels.memory import rows_of


class StackedFrames(NamedTuple):
    """Frames with `raw` depth (k * h * w,) in units of 1 / `scale`, `pixels` uint8 (k * h * w, 3) or None, and `poses`,
    T_world_camera. Images are on the device or the host. `depth` is the argument as one image (k * h, w)."""

    depth: Any
    raw: Any
    pixels: Any
    scale: float
    farthest: float
    cameras: list[PinholeCameraIntrinsic]
    poses: list[NDArray[np.float64]]

    def images(self, rows: range) -> tuple[Any, Any]:
        """Depth and colors of adjacent frames."""
        count = self.raw.size // len(self.poses)
        first, last = rows.start * count, rows.stop * count

        def part(values: Any) -> Any:
            return values[first:last] if isinstance(values, np.ndarray) else rows_of(values, first, last)

        return part(self.raw), None if self.pixels is None else part(self.pixels)


def stacked_frames(
    depth: Any,
    intrinsic: PinholeCameraIntrinsic | Sequence[PinholeCameraIntrinsic] | ArrayLike,
    extrinsic: ArrayLike,
    color: Any,
    depth_scale: float | None,
    depth_max: float,
    device: Any,
    *,
    on_host: bool,
) -> StackedFrames:
    """Check and upload k frames. Images of the host stay there if `on_host`. Raises ValueError or TypeError as
    TSDFVolume.integrate."""
    images = _stack("depth", depth, device)
    if images.ndim != 3:
        raise ValueError(f"depth: expected shape [k, h, w], got {list(images.shape)}. Use integrate() for one frame")
    count, height, width = images.shape
    poses = check_numeric("extrinsic", extrinsic)
    if poses.shape != (count, 4, 4):
        raise ValueError(
            f"extrinsic: expected shape [{count}, 4, 4], a pose for each depth image, got {list(poses.shape)}"
        )
    inverses = [inv(check_rigid("extrinsic", T)) for T in poses]
    given: list[Any] = [intrinsic] * count
    if isinstance(intrinsic, list | tuple) and not is_one_camera(intrinsic):
        given = list(intrinsic)
    if len(given) != count:
        raise ValueError(f"intrinsic: expected 1 camera or {count}, one for each depth image, got {len(given)}")
    if not count:
        raise ValueError("depth: expected at least one image, got shape [0, h, w]")
    tall = images.reshape((count * height, width))
    raw, scale, farthest, *_ = upload_raw_depth(tall, depth_scale, depth_max, device, on_host=on_host)
    cameras = [check_intrinsic(camera, width, height) for camera in given]
    pixels = None
    if color is not None:
        colors = _stack("color", color, device)
        if colors.ndim not in (3, 4) or tuple(colors.shape[:3]) != (count, height, width):
            wanted = f"[{count}, {height}, {width}, 3]"
            raise ValueError(f"color: expected shape {wanted} as the depth images, got {list(colors.shape)}")
        size = count * height, width
        pixels = upload_color(colors.reshape((*size, *colors.shape[3:])), *size, device, on_host=on_host)
    return StackedFrames(tall, raw, pixels, scale, farthest, cameras, inverses)


def _stack(name: str, images: Sequence[Any], device: Device) -> Any:
    """One array of all images: NumPy, or on the GPU."""
    if is_on_gpu(images):
        return take_numbers(name, images, device)
    if isinstance(images, Sequence) and any(is_on_gpu(image) for image in images):
        raise TypeError(
            f"{name}: expected one array of all images, got a {type(images).__name__} of GPU arrays. Stack them with "
            "their library, such as torch.stack"
        )
    try:
        return np.asarray(images)
    except ValueError as error:
        raise ValueError(f"{name}: expected images of one size ({error})") from error
