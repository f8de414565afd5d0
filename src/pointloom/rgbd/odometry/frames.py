"""Depth and color frames prepared for odometry."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.depth_range import DEPTH_MAX
from ...cameras.images import RGBDImage, check_intrinsic, upload_color, upload_depth
from ...core.devices import DeviceLike
from ...core.gpu_arrays import device_for
from ...core.pickled_arrays import check_form, device_like, pickled, unpickled, unpickling
from ...kernels.lang import float32, vec4
from ...kernels.memory import download
from ...kernels.rgbd.level_copies import level_rows
from ...kernels.rgbd.open3d_images import fill_missing, mark_missing
from ...kernels.rgbd.pyramid import FrameLevels, make_levels

MAX_PIXELS = 100_000  # finest level: half VGA. Larger ones cost four times as much with little gain
MIN_SIDE = 24  # [px] of the coarsest level
PLANE_RADIUS = 2  # [px] radius of plane windows


class OdometryFrame:
    """Image pyramid of a frame on a device, reusable for several alignments.

    Args:
        depth: [h, w], integers of 16 bits and more, or floats; or an RGBDImage. 0, NaN and values > `depth_max` are
            invalid.
        intrinsic: The camera, of the image size.
        color: 8-bit colors, shape [h, w, 3], or gray [h, w]; None: depth only.
        depth_scale: Depth units per meter; None: 1000 for integers and 1 for floats.
        depth_max: Maximum depth [m].
        device: None: the GPU of the depth array, else the CPU.

    Attributes:
        levels: Device arrays of the pyramid, finest first.
        intrinsic: The given camera.
        has_color: True if there is brightness.
        blur: Additional uncertainty of the surface [m]: 0 for camera frames.

    Raises:
        ValueError, TypeError: Wrong shapes, sizes or element types, or a camera of another size.

    Notes:
        The finest level has at most 100,000 pixels: 640 x 480 is halved first. 24 B per pixel of the levels.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> loom.rgbd.OdometryFrame(np.full((48, 64), 1500, np.uint16), camera)
        OdometryFrame(64 x 48, 2 levels, cpu)
    """

    def __init__(
        self,
        depth: RGBDImage | ArrayLike,
        intrinsic: PinholeCameraIntrinsic,
        color: ArrayLike | None = None,
        *,
        depth_scale: float | None = None,
        depth_max: float = DEPTH_MAX,
        device: DeviceLike = None,
    ):
        if isinstance(depth, RGBDImage):
            if color is not None:
                raise ValueError("color: expected None, because an RGBDImage contains its color")
            metric, brightness = depth.depth_array, depth.color_array
            height, width = depth.height, depth.width
        else:
            where = device_for(depth, device)
            metric, _, height, width = upload_depth(depth, depth_scale, depth_max, where)
            brightness = None if color is None else upload_color(color, height, width, where)
        self._make(metric, brightness, check_intrinsic(intrinsic, width, height))

    @classmethod
    def _from_device_maps(
        cls,
        depth: wp.array,
        brightness: wp.array | None,
        intrinsic: PinholeCameraIntrinsic,
        max_pixels: int = MAX_PIXELS,
        *,
        normals: wp.array | None = None,
        is_rendered: bool = False,
        blur: float = 0.0,
    ) -> Self:
        """A frame of device arrays [pixels]: float32 depth [m], float32 brightness (< 0: none) or 8-bit colors.

        Pixels without depth have no brightness if it `is_rendered`.
        """
        frame = cls.__new__(cls)
        frame._make(depth, brightness, intrinsic, max_pixels, normals=normals, is_rendered=is_rendered)
        frame.blur = blur
        return frame

    @classmethod
    def from_image(cls, image: RGBDImage, intrinsic: PinholeCameraIntrinsic, least: float, most: float) -> Self:
        """Create a frame from an RGB-D image with a valid depth range."""
        depth = fill_missing(mark_missing(image.depth_array, least, most))
        checked = check_intrinsic(intrinsic, image.width, image.height)
        return cls._from_device_maps(depth, image.color_array, checked)

    def _make(
        self,
        depth: wp.array,
        brightness: wp.array | None,
        intrinsic: PinholeCameraIntrinsic,
        max_pixels: int = MAX_PIXELS,
        **rendered: Any,
    ) -> None:
        size, lens = (intrinsic.width, intrinsic.height), (intrinsic.fx, intrinsic.fy, intrinsic.cx, intrinsic.cy)
        self.intrinsic, self.device, self.has_color = intrinsic, depth.device, brightness is not None
        limits = {"max_pixels": max_pixels, "min_side": MIN_SIDE, "radius": PLANE_RADIUS}
        self.levels: FrameLevels = make_levels(depth, brightness, size, lens, **limits, **rendered)
        self.blur = 0.0
        self._coarsest: tuple[NDArray[np.float32], NDArray[np.float32]] | None = None

    def __getstate__(self) -> dict[str, Any]:
        levels = self.levels
        arrays = pickled({name: getattr(levels, name) for name in ("depth", "brightness", "planes")})
        state = {"arrays": arrays, "sizes": levels.sizes, "lenses": levels.host_lenses, "device": str(self.device)}
        return state | {"intrinsic": self.intrinsic, "has_color": self.has_color, "blur": self.blur}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Restore on the saved device, or the first GPU if its index does not exist."""
        with unpickling("frame"):
            device = device_like("frame", state["device"])
            arrays, levels = unpickled(state["arrays"], device), FrameLevels(state["sizes"], state["lenses"], device)
            for name, dtype in (("depth", float32), ("brightness", float32), ("planes", vec4)):
                setattr(levels, name, check_form(name, arrays[name], (dtype, (levels.total,))))
            self.intrinsic, self.blur = state["intrinsic"], float(state["blur"])
            self.has_color = bool(state["has_color"])
        self.levels, self.device, self._coarsest = levels, device, None

    def coarsest(self) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Depth [h, w] and planes [h, w, 4] of the coarsest level, on the host: synchronizes on first access."""
        if self._coarsest is None:
            width, height = (int(side) for side in self.levels.sizes[-1])
            rows = download(level_rows(self.levels, self.levels.count - 1))  # sync
            self._coarsest = rows[:, 0].reshape(height, width), rows[:, 1:].reshape(height, width, 4)
        return self._coarsest

    @property
    def width(self) -> int:
        """Image columns [px]."""
        return self.intrinsic.width

    @property
    def height(self) -> int:
        """Image rows [px]."""
        return self.intrinsic.height

    def __repr__(self) -> str:
        return f"OdometryFrame({self.width} x {self.height}, {self.levels.count} levels, {self.device})"
