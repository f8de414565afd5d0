"""Validated images with cameras and poses on the mesh's device."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic, is_one_camera
from ...cameras.images import RGBDImage, check_intrinsic, upload_color
from ...core.checks import check_list, check_rigid
from ...core.devices import check_same_device
from ...core.masked_arrays import unmasked
from ...kernels.array_types import Device
from ...kernels.arrays.concatenation import concatenate_rows
from ...kernels.lang import uint8
from ...kernels.linear_algebra import matmul
from ...kernels.textures.stacked_images import StackedImages, smooth_brightness

MAX_PIXELS = 2**31 - 1  # in total: 32-bit indices on the device


@dataclass(frozen=True)
class PosedImages:
    """Validated images: uint8 colors (pixels, 3), float32 depths (pixels,) [m] or None, cameras and poses."""

    colors: list[wp.array]
    depths: list[wp.array | None]
    cameras: list[PinholeCameraIntrinsic]
    T_camera_world: NDArray[np.float64]

    def stacked(self, origin: NDArray[np.float64], margin: float) -> StackedImages:
        """Images for kernels, poses about an origin [m]. 7 B per pixel."""
        sizes = np.array([(camera.width, camera.height) for camera in self.cameras], np.int64)
        firsts = np.concatenate([[0], np.cumsum(sizes.prod(axis=1))])
        layout = np.column_stack([sizes, firsts[:-1]])
        lenses = np.array([(camera.fx, camera.fy, camera.cx, camera.cy) for camera in self.cameras])
        poses = self.T_camera_world.copy()
        poses[:, :3, 3] += matmul(poses[:, :3, :3], origin)
        pixels = concatenate_rows(self.colors)
        return StackedImages(layout, lenses, poses, pixels, smooth_brightness(pixels, layout), margin)


@dataclass(frozen=True)
class Names:
    """Argument names of images, cameras and poses, for errors."""

    images: str
    cameras: str
    poses: str


def check_images(names: Names, images: Any, intrinsics: Any, T_camera_world: Any, device: Device) -> PosedImages:
    """Validate as many images (RGBDImages or uint8 arrays) as cameras and poses, and upload them."""
    listed, poses = check_list(names.images, images, "images"), list(T_camera_world)
    if not listed:
        raise ValueError(f"{names.images}: expected at least one image, got none")
    if len(poses) != len(listed):
        raise ValueError(f"{names.poses}: expected {len(listed)}, one per image, got {len(poses)}")
    cameras = (
        [intrinsics] * len(listed)
        if is_one_camera(intrinsics)
        else list(check_list(names.cameras, intrinsics, "cameras"))
    )
    if len(cameras) != len(listed):
        expected = f"expected one, or {len(listed)}, one per image"
        raise ValueError(f"{names.cameras}: {expected}, got {len(cameras)}")
    colors, depths, checked = [], [], list[PinholeCameraIntrinsic]()
    for i, (image, given) in enumerate(zip(listed, cameras, strict=True)):
        try:
            color, depth, camera = _take(image, given, device)
        except (TypeError, ValueError) as error:
            raise type(error)(f"{names.images}[{i}]: {error}") from error
        colors.append(color)
        depths.append(depth)
        checked.append(camera)
    pixel_count = sum(color.shape[0] for color in colors)
    if pixel_count > MAX_PIXELS:
        expected = "expected at most 2^31 - 1 pixels in total"
        raise ValueError(f"{names.images}: {expected}, got {pixel_count:,}. Use fewer or smaller images")
    T = np.array([check_rigid(f"{names.poses}[{i}]", pose) for i, pose in enumerate(poses)])
    return PosedImages(colors, depths, checked, T)


def _take(
    image: RGBDImage | ArrayLike, intrinsic: PinholeCameraIntrinsic | ArrayLike, device: Device
) -> tuple[wp.array, wp.array | None, PinholeCameraIntrinsic]:
    if isinstance(image, RGBDImage):
        check_same_device("device", image.device, device)
        camera = check_intrinsic(intrinsic, image.width, image.height)
        if image.color_array.dtype != uint8:
            raise ValueError("intensity only. Create the image with convert_rgb_to_intensity=False to keep its colors")
        return image.color_array, image.depth_array, camera
    pixels = np.asarray(unmasked("image", image))
    if pixels.ndim not in (2, 3) or 0 in pixels.shape:
        raise ValueError(f"expected an RGBDImage or a uint8 image [h, w, 3], got {_named(image, pixels)}")
    height, width = pixels.shape[:2]
    camera = check_intrinsic(intrinsic, width, height)
    return upload_color(pixels, height, width, device), None, camera


def _named(image: RGBDImage | ArrayLike, pixels: NDArray[Any]) -> str:
    return type(image).__name__ if pixels.dtype == object or not pixels.ndim else f"shape {list(pixels.shape)}"
