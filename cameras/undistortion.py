"""Pictures of a lens as a pinhole camera would have taken them, for everything that wants straight lines straight."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import form_of, view_as
from ..core.checks import check_numeric
from ..core.devices import resolve_device
from ..core.gpu_arrays import device_for, take_numbers
from ..kernels.images.undistortion import LensOptics, find_places, mark_seen, read_places
from ..kernels.lang import uint8
from ..kernels.memory import download, upload
from .camera import PinholeCameraIntrinsic
from .camera_models import CameraModel
from .lens_projection import FIELD_OF_VIEW, THIN

MOST_SIDE = 1024  # of the squares that are averaged [px]: their sums keep within 32 bits


class Undistortion:
    """What straightens all pictures of one camera: the places are found once.

    Args:
        camera: The lens.
        blank_share: As in `CameraModel.undistorted`.
        max_size: Likewise [px].
        size: Likewise, width and height [px].
        device: Where the pictures are straightened; None for the CPU.

    Attributes:
        camera: As given.
        intrinsic: The pinhole camera that straightened pictures have.
        device: As given.

    Raises:
        TypeError: No CameraModel, or not numbers.
        ValueError: A number out of range, or a lens without an inverse along a border.

    Notes:
        8 B of device memory a pixel of the straightened picture.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.cameras.undistortion import Undistortion
        >>> camera = loom.CameraModel("SIMPLE_RADIAL", 64, 48, [50, 32, 24, -0.1])
        >>> undistortion = Undistortion(camera, blank_share=1)
        >>> pictures = [undistortion.apply(np.full((48, 64), grey, np.uint8)) for grey in (10, 20)]
        >>> pictures[1].shape, int(pictures[1].max()), round(float(undistortion.seen.mean()), 2)
        ((51, 68), 20, 0.98)
    """

    def __init__(
        self,
        camera: CameraModel,
        *,
        blank_share: float = 0.0,
        max_size: int | None = None,
        size: tuple[int, int] | None = None,
        device: Any = None,
    ):
        if not isinstance(camera, CameraModel):
            raise TypeError(f"camera: expected a CameraModel, got {type(camera).__name__}; see its from_intrinsic")
        self.camera, self.device = camera, resolve_device(device)
        self.intrinsic = camera.undistorted(blank_share=blank_share, max_size=max_size, size=size)
        lens, (width, height) = camera._lens, (camera.width, camera.height)
        thin = lens.kind == FIELD_OF_VIEW and lens.shape[0] ** 2 < THIN
        wide = 2.0 * math.tan(lens.shape[0] / 2.0) if lens.kind == FIELD_OF_VIEW and not thin else 0.0
        optics = LensOptics(lens, width, height, lens.reach, wide, int(thin))
        self._places = find_places(optics, self.intrinsic, self.device)
        steps = (lens.focal[0] / self.intrinsic.fx, lens.focal[1] / self.intrinsic.fy)
        self._side = min(max(1, math.floor(min(steps) + 1e-9)), MOST_SIDE)  # pixels of the lens a pixel of the pinhole

    @property
    def seen(self) -> NDArray[np.bool_]:
        """Which pixels of the straightened picture the lens saw, shape [h, w]."""
        shape = (self.intrinsic.height, self.intrinsic.width)
        return download(mark_seen(self._places)).reshape(shape).astype(bool)

    def apply(self, picture: ArrayLike) -> Any:
        """The straightened picture.

        Args:
            picture: Of the camera, uint8 [h, w] or [h, w, 3].

        Returns:
            The same kind of array; 0 where the lens did not see.

        Raises:
            TypeError: Not uint8.
            ValueError: Another shape, or another size than the camera's.
        """
        form = form_of(picture)
        pixels, channels = self._upload(picture, form.on_host)
        straight = read_places(pixels, self.camera.width, self.camera.height, self._side, self._places)
        shape = (self.intrinsic.height, self.intrinsic.width, *([channels] if channels else []))
        return form.hand_out(straight, shape=shape)

    def _upload(self, picture: ArrayLike, on_host: bool) -> tuple[wp.array, int]:
        """The picture on the device, uint8 [pixels, channels]; how many channels it has, 0 of a grey one."""
        image = check_numeric("picture", picture) if on_host else take_numbers("picture", picture, self.device)
        kind = image.dtype if isinstance(image, np.ndarray) else wp.dtype_to_numpy(image.dtype)
        if kind != np.uint8:
            raise TypeError(f"picture: expected uint8, got {np.dtype(kind)}; scale it to 0..255 and round")
        if image.ndim not in (2, 3) or (image.ndim == 3 and image.shape[2] != 3):
            raise ValueError(f"picture: expected shape [h, w] or [h, w, 3], got {list(image.shape)}")
        if tuple(image.shape[:2]) != (self.camera.height, self.camera.width):
            found, wanted = f"{image.shape[1]} x {image.shape[0]}", f"{self.camera.width} x {self.camera.height}"
            raise ValueError(f"picture: {found} pixels, but the camera has {wanted}; was it resized or turned?")
        channels = image.shape[2] if image.ndim == 3 else 0
        flat = (self.camera.width * self.camera.height, channels or 1)
        if isinstance(image, np.ndarray):
            return upload(np.ascontiguousarray(image).reshape(flat), uint8, self.device), channels
        return view_as(image, uint8, flat), channels


def undistort_picture(
    picture: ArrayLike,
    camera: CameraModel,
    *,
    blank_share: float = 0.0,
    max_size: int | None = None,
    size: tuple[int, int] | None = None,
    device: Any = None,
) -> tuple[Any, PinholeCameraIntrinsic]:
    """Straighten a picture: as a pinhole camera would have taken it.

    Args:
        picture: As the lens took it, uint8 [h, w] or [h, w, 3].
        camera: The lens.
        blank_share: From 0, next to nothing is blank and corners may be lost, to 1, nothing is lost; see
            `CameraModel.undistorted`.
        max_size: The longest side that the result may have [px].
        size: Width and height of the result [px], in place of `max_size`.
        device: Where it is done; None for the GPU that the picture lies on, else the CPU.

    Returns:
        The picture, the same kind of array, 0 where the lens did not see; and the pinhole camera that it has.

    Raises:
        TypeError: Not uint8, or no CameraModel.
        ValueError: Another shape, a size that is not the camera's, a number out of range, or a lens without an inverse
            along a border.

    Notes:
        Bilinear between four pixels; pictures that become smaller by two or more are averaged over squares first. The
        outer half of the border's pixels counts as the border. The same bits on every device. For many pictures of
        one camera make an `Undistortion` once, whose `apply` reads 8 B and writes 3 B a
        pixel and whose `seen` is the mask of what is not blank.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("SIMPLE_RADIAL", 64, 48, [50, 32, 24, -0.1])
        >>> straight, pinhole = loom.undistort_picture(np.full((48, 64, 3), 200, np.uint8), camera)
        >>> straight.shape, pinhole.width, pinhole.fx
        ((48, 65, 3), 65, 50.0)
    """
    if not isinstance(camera, CameraModel):
        raise TypeError(f"camera: expected a CameraModel, got {type(camera).__name__}; see its from_intrinsic")
    where = device_for(picture, device)
    undistortion = Undistortion(camera, blank_share=blank_share, max_size=max_size, size=size, device=where)
    return undistortion.apply(picture), undistortion.intrinsic
