"""Depth camera frames on a device, uploaded once for tracking and fusion."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.images import check_intrinsic, integer_scale, upload_color, upload_depth
from ...core.time_checks import check_time
from ..odometry.frames import OdometryFrame

MAX_PIXELS = 20_000  # finest level: a quarter of VGA's sides. More does not help


class SensorFrame:
    """Depth and color on a device, with their pyramid.

    Args:
        frame: An object with `depth` and optionally `color`, `timestamp`, `name`. Integers are divided by
            `depth_scale`, floats are meters.
        intrinsic: The camera of both images.
        depth_scale: Integer units per meter.
        depth_max: Maximum depth [m].
        device: The device.

    Attributes:
        depth: float32 [pixels] [m], 0 if invalid.
        pixels: uint8 [pixels, 3], or None without color.
        still: The depth without moving pixels, set by a tracker. Else None.
        pyramid: The OdometryFrame, of static pixels once known.
        timestamp: Time [s], or None.
    """

    def __init__(
        self, frame: Any, intrinsic: PinholeCameraIntrinsic, depth_scale: float, depth_max: float, device: wp.Device
    ):
        if not hasattr(frame, "depth"):
            kind = type(frame).__name__
            raise TypeError(f"frame: expected an object with depth and color, such as a Frame, got {kind}")
        scale = integer_scale(frame.depth, depth_scale)
        self.depth, _, height, width = upload_depth(frame.depth, scale, depth_max, device)
        self.intrinsic = check_intrinsic(intrinsic, width, height)
        color = getattr(frame, "color", None)
        if color is not None and np.issubdtype(getattr(color, "dtype", np.uint8), np.floating):
            color = np.rint(255 * np.clip(color, 0, 1)).astype(np.uint8)  # an RGBDImage with brightness
        self.pixels: Any = None if color is None else upload_color(color, height, width, device)
        self.still: Any = None
        self._pyramid: OdometryFrame | None = None
        self.name = str(getattr(frame, "name", ""))
        time = getattr(frame, "timestamp", None)
        self.timestamp = None if time is None else check_time("timestamp", time)
        self.device = device

    @property
    def pyramid(self) -> OdometryFrame:
        if self._pyramid is None:
            self._pyramid = self.pyramid_of(self.depth)
        return self._pyramid

    def keep_still(self, depth: wp.array, pyramid: OdometryFrame) -> None:
        self.still, self._pyramid = depth, pyramid

    def leave_only(self, depth: wp.array) -> None:
        """Replace the depth, float32 [pixels], 0 where excluded."""
        self.depth, self.still, self._pyramid = depth, None, None

    def pyramid_of(self, depth: wp.array) -> OdometryFrame:
        return OdometryFrame._from_device_maps(depth, self.pixels, self.intrinsic, MAX_PIXELS)

    def seconds_since(self, earlier: float | None) -> float:
        if earlier is None or self.timestamp is None:
            return math.nan
        return self.timestamp - earlier


def coarsest_level(frame: OdometryFrame) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Depth [h, w], lens and planes [h, w, 4] of the coarsest level (sync)."""
    levels = frame.levels
    depth, planes = frame.coarsest()
    return depth.astype(np.float64), levels.host_lenses[-1], planes.astype(np.float64)
