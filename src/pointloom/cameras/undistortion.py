"""Undistort images: resample them to a pinhole camera."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import form_of, view_as
from ..core.checks import check_numeric
from ..core.devices import DeviceLike, resolve_device
from ..core.gpu_arrays import device_for, take_numbers
from ..core.pickled_arrays import device_like, unpickling
from ..kernels.array_types import Device
from ..kernels.images.undistortion import find_lens_positions, mask_visible, sample_image
from ..kernels.lang import uint8
from ..kernels.memory import download, upload
from .camera import PinholeCameraIntrinsic
from .camera_models import CameraModel

MAX_SIDE = 1024  # maximum side of averaged squares [px]: their sums stay within 32 bits


class Undistortion:
    """Undistorts all images of one camera with a map that is computed once.

    Args:
        camera: The lens.
        blank_fraction: As in `CameraModel.undistorted`.
        max_size: As in `CameraModel.undistorted` [px].
        size: As in `CameraModel.undistorted`, width and height [px].
        device: Device to use. None for the CPU.

    Attributes:
        camera: As given.
        intrinsic: The pinhole camera of the undistorted images.
        device: As given.

    Raises:
        TypeError: No CameraModel, or not numbers.
        ValueError: A number out of range, or a lens without an inverse along a border.

    Notes:
        8 B of device memory per pixel of the result.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.cameras.undistortion import Undistortion
        >>> camera = loom.CameraModel("SIMPLE_RADIAL", 64, 48, [50, 32, 24, -0.1])
        >>> undistortion = Undistortion(camera, blank_fraction=1)
        >>> images = [undistortion.apply(np.full((48, 64), gray, np.uint8)) for gray in (10, 20)]
        >>> images[1].shape, int(images[1].max()), round(float(undistortion.seen.mean()), 2)
        ((51, 68), 20, 0.98)
    """

    def __init__(
        self,
        camera: CameraModel,
        *,
        blank_fraction: float = 0.0,
        max_size: int | None = None,
        size: tuple[int, int] | None = None,
        device: DeviceLike = None,
    ):
        if not isinstance(camera, CameraModel):
            raise TypeError(f"camera: expected a CameraModel, got {type(camera).__name__}; see its from_intrinsic")
        intrinsic = camera.undistorted(blank_fraction=blank_fraction, max_size=max_size, size=size)
        self._prepare(camera, intrinsic, resolve_device(device))

    def _prepare(self, camera: CameraModel, intrinsic: PinholeCameraIntrinsic, device: Device) -> None:
        self.camera, self.intrinsic, self.device = camera, intrinsic, device
        lens = camera._lens
        self._source_pixels = find_lens_positions(lens, camera.width, camera.height, intrinsic, device)
        steps = (lens.focal[0] / intrinsic.fx, lens.focal[1] / intrinsic.fy)
        self._side = min(max(1, math.floor(min(steps) + 1e-9)), MAX_SIDE)  # lens pixels per pinhole pixel

    def __getstate__(self) -> dict[str, Any]:
        return {"camera": self.camera, "intrinsic": self.intrinsic, "device": str(self.device)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Restore on the saved device, or the first GPU if its index does not exist."""
        with unpickling("undistortion"):
            self._prepare(state["camera"], state["intrinsic"], device_like("undistortion", state["device"]))

    @property
    def seen(self) -> NDArray[np.bool_]:
        """Mask of the pixels that the lens saw, shape (h, w)."""
        shape = (self.intrinsic.height, self.intrinsic.width)
        return download(mask_visible(self._source_pixels)).reshape(shape).astype(bool)

    def apply(self, image: ArrayLike) -> Any:
        """Undistort an image.

        Args:
            image: Image of the camera, uint8 (h, w) or (h, w, 3).

        Returns:
            The same kind of array. 0 where the lens did not see.

        Raises:
            TypeError: Not uint8.
            ValueError: Another shape, or a size that is not the camera's.
        """
        form = form_of(image)
        pixels, channels = self._upload(image, form.on_host)
        straight = sample_image(pixels, self.camera.width, self.camera.height, self._side, self._source_pixels)
        shape = (self.intrinsic.height, self.intrinsic.width, *([channels] if channels else []))
        return form.hand_out(straight, shape=shape)

    def _upload(self, image: ArrayLike, on_host: bool) -> tuple[wp.array, int]:
        """The image on the device, uint8 (pixels, channels), and its number of channels, 0 for gray."""
        array = check_numeric("image", image) if on_host else take_numbers("image", image, self.device)
        kind = array.dtype if isinstance(array, np.ndarray) else wp.dtype_to_numpy(array.dtype)
        if kind != np.uint8:
            raise TypeError(f"image: expected uint8, got {np.dtype(kind)}; scale it to 0..255 and round")
        if array.ndim not in (2, 3) or (array.ndim == 3 and array.shape[2] != 3):
            raise ValueError(f"image: expected shape [h, w] or [h, w, 3], got {list(array.shape)}")
        if tuple(array.shape[:2]) != (self.camera.height, self.camera.width):
            given, wanted = f"{array.shape[1]} x {array.shape[0]}", f"{self.camera.width} x {self.camera.height}"
            raise ValueError(
                f"image: expected {wanted} pixels, as the camera has, got {given}; was it resized or rotated?"
            )
        channels = array.shape[2] if array.ndim == 3 else 0
        flat = (self.camera.width * self.camera.height, channels or 1)
        if isinstance(array, np.ndarray):
            return upload(np.ascontiguousarray(array).reshape(flat), uint8, self.device), channels
        return view_as(array, uint8, flat), channels


def undistort_image(
    image: ArrayLike,
    camera: CameraModel,
    *,
    blank_fraction: float = 0.0,
    max_size: int | None = None,
    size: tuple[int, int] | None = None,
    device: DeviceLike = None,
) -> tuple[Any, PinholeCameraIntrinsic]:
    """Undistort an image to a pinhole camera.

    Args:
        image: The distorted array, uint8 (h, w) or (h, w, 3).
        camera: The lens.
        blank_fraction: From 0 (almost no blank pixels) to 1 (nothing is cropped). See `CameraModel.undistorted`.
        max_size: Maximum side length of the result [px].
        size: Width and height of the result [px], instead of `max_size`.
        device: Device to use; None: the GPU that the image is on, else the CPU.

    Returns:
        The image, the same kind of array, 0 where the lens did not see; and its pinhole camera.

    Raises:
        TypeError: Not uint8, or no CameraModel.
        ValueError: Another shape, a size that is not the camera's, a number out of range, or a lens without an inverse
            along a border.

    Notes:
        Bilinear interpolation, after area averaging if the image shrinks by 2 or more. Border pixels are extended by
        half a pixel. Bitwise identical on every device. For many images, construct an `Undistortion` once.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("SIMPLE_RADIAL", 64, 48, [50, 32, 24, -0.1])
        >>> straight, pinhole = loom.undistort_image(np.full((48, 64, 3), 200, np.uint8), camera)
        >>> straight.shape, pinhole.width, pinhole.fx
        ((48, 65, 3), 65, 50.0)
    """
    if not isinstance(camera, CameraModel):
        raise TypeError(f"camera: expected a CameraModel, got {type(camera).__name__}; see its from_intrinsic")
    where = device_for(image, device)
    undistortion = Undistortion(camera, blank_fraction=blank_fraction, max_size=max_size, size=size, device=where)
    return undistortion.apply(image), undistortion.intrinsic
