"""Split panoramas (360 degrees, equirectangular) into six cube faces."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike

from ..core.array_libraries import form_of, view_as
from ..core.checks import check_count, check_numeric
from ..core.devices import DeviceLike, resolve_device
from ..core.gpu_arrays import take_numbers
from ..core.pickled_arrays import device_like, unpickling
from ..kernels.array_types import Array2
from ..kernels.images.sphere import find_sphere_positions
from ..kernels.images.undistortion import sample_image
from ..kernels.lang import mat33d, uint8
from ..kernels.language.device_lock import lock_for
from ..kernels.memory import empty, upload
from .camera import PinholeCameraIntrinsic

FACES = ("front", "right", "back", "left", "up", "down")
MIN_FACE_PIXELS = 8  # side of a face [px]
MAX_FACE_PIXELS = 16384
# The axes of each face's camera (x right, y down, z forward) as columns, in the front camera's frame.
ROTATIONS = np.array(
    [
        [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[0, 0, 1], [0, 1, 0], [-1, 0, 0]],
        [[-1, 0, 0], [0, 1, 0], [0, 0, -1]],
        [[0, 0, -1], [0, 1, 0], [1, 0, 0]],
        [[1, 0, 0], [0, 0, -1], [0, 1, 0]],
        [[1, 0, 0], [0, 0, 1], [0, -1, 0]],
    ],
    np.float64,
)


class Panorama:
    """Splits panoramas of one size into cube faces, with a map that is computed once.

    Args:
        width: Width of the panoramas [px]. Twice their height.
        height: Height of the panoramas [px].
        side: Side of the faces [px]. None keeps the angular resolution at the horizon.
        device: Device to use. None for the CPU.

    Attributes:
        intrinsic: The camera of every face: 90 degrees wide.
        turns: Rotations from each face's camera to the front camera, shape (6, 3, 3), in the order of `names`.
        names: "front", "right", "back", "left", "up", "down".

    Raises:
        TypeError, ValueError: A number out of range, or an image that is not twice as wide as high.

    Notes:
        8 B of device memory per pixel of the faces. Bilinear. Bitwise identical on every device.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.cameras.panoramas import Panorama
        >>> panorama = Panorama(64, 32)
        >>> faces = panorama.apply(np.full((32, 64, 3), 90, np.uint8))
        >>> faces.shape, panorama.intrinsic.fx, int(faces.min())
        ((6, 20, 20, 3), 10.0, 90)
    """

    names = FACES

    def __init__(self, width: int, height: int, *, side: int | None = None, device: DeviceLike = None):
        check_count("width", width, minimum=MIN_FACE_PIXELS)
        check_count("height", height, minimum=MIN_FACE_PIXELS // 2)
        if abs(width - 2 * height) > 2:
            raise ValueError(
                f"width: expected twice the height of {height}, as equirectangular images have, got {width}"
            )
        if side is None:
            side = min(max(round(width / math.pi), MIN_FACE_PIXELS), MAX_FACE_PIXELS)
        check_count("side", side, minimum=MIN_FACE_PIXELS, maximum=MAX_FACE_PIXELS, because="no sphere has more pixels")
        self.width, self.height, self.side = int(width), int(height), int(side)
        self.device, self.turns = resolve_device(device), ROTATIONS.copy()
        middle = (self.side - 1) / 2
        self.intrinsic = PinholeCameraIntrinsic(self.side, self.side, self.side / 2, self.side / 2, middle, middle)
        rotations = upload(ROTATIONS, mat33d, self.device)
        self._source_pixels = find_sphere_positions(
            self.side, self.side / 2, rotations, self.width, self.height, self.device
        )

    def __getstate__(self) -> dict[str, Any]:
        return {"width": self.width, "height": self.height, "side": self.side, "device": str(self.device)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Restore on the saved device, or the first GPU if its index does not exist."""
        with unpickling("panorama"):
            device = device_like("panorama", state["device"])
            made = type(self)(state["width"], state["height"], side=state["side"], device=device)
        vars(self).update(vars(made))

    def apply(self, image: ArrayLike) -> Any:
        """Compute the cube faces of a panorama.

        Args:
            image: uint8 (height, width, 3) or (height, width).

        Returns:
            uint8 (6, side, side, 3) or (6, side, side), the same kind of array.

        Raises:
            TypeError: Not uint8.
            ValueError: Another shape.
        """
        form = form_of(image)
        array = check_numeric("image", image) if form.on_host else take_numbers("image", image, self.device)
        kind = array.dtype if form.on_host else wp.dtype_to_numpy(array.dtype)
        if kind != np.uint8:
            raise TypeError(f"image: expected uint8, got {np.dtype(kind)}; scale it to 0..255 and round")
        if array.ndim not in (2, 3) or (array.ndim == 3 and array.shape[2] != 3):
            raise ValueError(f"image: expected shape [h, w] or [h, w, 3], got {list(array.shape)}")
        if tuple(array.shape[:2]) != (self.height, self.width):
            given = f"{array.shape[1]} x {array.shape[0]}"
            raise ValueError(f"image: expected {self.width} x {self.height} pixels, got {given}")
        channels = array.shape[2] if array.ndim == 3 else 1
        pixels = self._ring_of(array, channels)
        faces = sample_image(pixels, self.width + 2, self.height, 1, self._source_pixels)
        shape = (len(FACES), self.side, self.side, *((3,) if array.ndim == 3 else ()))
        return form.hand_out(faces, shape=shape)

    def _ring_of(self, array: Any, channels: int) -> Array2[uint8]:
        """The image on the device, uint8 (pixels, channels), between copies of its last and first column."""
        if isinstance(array, np.ndarray):
            ring = np.concatenate([array[:, -1:], array, array[:, :1]], axis=1).reshape(-1, channels)
            return upload(np.ascontiguousarray(ring), uint8, self.device)
        flat, width = view_as(array, uint8, (self.height, self.width * channels)), self.width * channels
        ring = empty((self.height, width + 2 * channels), uint8, self.device)
        with lock_for(self.device):
            wp.copy(ring[:, channels : channels + width], flat)
            wp.copy(ring[:, :channels], flat[:, width - channels :])
            wp.copy(ring[:, channels + width :], flat[:, :channels])
        return view_as(ring, uint8, (ring.size // channels, channels))
