"""A depth and colour frame prepared once for odometry."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.images import RGBDImage, check_intrinsic, upload_color, upload_depth
from ...core.gpu_arrays import device_for
from ...kernels.memory import download
from ...kernels.rgbd.level_copies import level_rows
from ...kernels.rgbd.open3d_images import fill_missing, mark_missing
from ...kernels.rgbd.pyramid import FrameLevels, make_levels

MOST_PIXELS = 100_000  # of the finest level: half VGA; a larger one costs four times that and wins little
LEAST_SIDE = 24  # [px] of the coarsest level
PLANE_RADIUS = 2  # [px] of the window of a plane
DEPTH_MAX = 6.0  # [m] beyond it a depth camera measures little


class OdometryFrame:
    """A frame's pyramid on a device, made once, used in each alignment with it.

    Args:
        depth: Shape [h, w]; integers of 16 bits and more, or floats; or an RGBDImage, which brings its
            colours along. 0, NaN and what is beyond `depth_max` is no measurement.
        intrinsic: The camera, of the picture's size.
        color: 8-bit colours, shape [h, w, 3], or grey [h, w]; None for depth alone.
        depth_scale: Units of depth a metre; None for 1000 of integers and 1 of floats.
        depth_max: Farthest depth that counts [m].
        device: Where the frame goes; None for the GPU that the depth lies on, else the CPU.

    Attributes:
        levels: The pyramid's device arrays, finest first.
        intrinsic: The camera of the frame as it was given.
        has_color: Whether there is brightness.
        blur: How far its surface may be off beside a camera's noise [m]: 0 of a camera's frame.

    Raises:
        ValueError: Wrong shapes, sizes that differ, a camera of another size.
        TypeError: Wrong element types.

    Notes:
        The finest level has at most 100,000 pixels: a picture of 640 x 480 is halved first. 24 B a pixel of the levels.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
        >>> loom.odometry.OdometryFrame(np.full((48, 64), 1500, np.uint16), camera)
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
        device: Any = None,
    ):
        if isinstance(depth, RGBDImage):
            if color is not None:
                raise ValueError("color: an RGBDImage has its own; pass None")
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
        most_pixels: int = MOST_PIXELS,
        *,
        normals: wp.array | None = None,
        blur: float = 0.0,
    ) -> Self:
        """A frame of device arrays.

        Args:
            depth: float32 [pixels] [m], 0 where there is none.
            brightness: float32 0..1, below 0 where there is none, or 8-bit colours [pixels, 3], or None.
            intrinsic: The camera.
            most_pixels: Of the finest level.
            normals: vec3 [pixels], for the planes of the finest level where that is the picture itself.
            blur: How far the surface may be off beside a camera's noise [m].
        """
        frame = cls.__new__(cls)
        frame._make(depth, brightness, intrinsic, most_pixels, normals)
        frame.blur = blur
        return frame

    @classmethod
    def from_image(cls, image: RGBDImage, intrinsic: PinholeCameraIntrinsic, least: float, most: float) -> Self:
        """A frame of an RGB-D image whose depths outside of a range are no measurement."""
        frame = cls.__new__(cls)
        depth = fill_missing(mark_missing(image.depth_array, least, most))
        frame._make(depth, image.color_array, check_intrinsic(intrinsic, image.width, image.height))
        return frame

    def _make(
        self,
        depth: Any,
        brightness: Any,
        intrinsic: PinholeCameraIntrinsic,
        most: int = MOST_PIXELS,
        normals: wp.array | None = None,
    ) -> None:
        lens = (intrinsic.fx, intrinsic.fy, intrinsic.cx, intrinsic.cy)
        self.intrinsic, self.device, self.has_color = intrinsic, depth.device, brightness is not None
        self.levels: FrameLevels = make_levels(
            depth,
            brightness,
            intrinsic.width,
            intrinsic.height,
            lens,
            most_pixels=most,
            least_side=LEAST_SIDE,
            radius=PLANE_RADIUS,
            normals=normals,
        )
        self.blur = 0.0
        self._coarsest: tuple[NDArray[np.float32], NDArray[np.float32]] | None = None

    def coarsest(self) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        """Depth [h, w] and planes [h, w, 4] of the coarsest level, on the host: a sync when first asked for."""
        if self._coarsest is None:
            width, height = (int(side) for side in self.levels.sizes[-1])
            rows = download(level_rows(self.levels, self.levels.count - 1))  # sync
            self._coarsest = rows[:, 0].reshape(height, width), rows[:, 1:].reshape(height, width, 4)
        return self._coarsest

    @property
    def width(self) -> int:
        """Columns of the picture [px]."""
        return self.intrinsic.width

    @property
    def height(self) -> int:
        """Rows of the picture [px]."""
        return self.intrinsic.height

    def __repr__(self) -> str:
        return f"OdometryFrame({self.width} x {self.height}, {self.levels.count} levels, {self.device})"
