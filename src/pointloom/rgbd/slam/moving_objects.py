"""Exclusion of moving objects from the model by free space seen in recent frames."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul
from ...kernels.rgbd.moved_pixels import FreeSpace, hide_moved
from ...registration.rigid import invert_pose
from .frames import SensorFrame

Pose = NDArray[np.float64]

FRAME_INTERVAL = 6  # fused frames between kept ones
MAX_STORED_FRAMES = 5  # stored frames: the last second, at 30 Hz
COMPARED_FRAMES = (0, 2)  # compared ones, from the oldest: old ones for slow motion, recent ones for fast


class Movers:
    """The frames of the last second, for comparison with new ones."""

    def __init__(self) -> None:
        self._earlier: list[tuple[FreeSpace, Pose]] = []
        self._count = 0

    def __bool__(self) -> bool:
        return bool(self._earlier)

    def still_depth(self, frame: SensorFrame, pose: Pose) -> Any:
        """The frame's depth on its device, 0 for pixels in space that was free before."""
        compared = [self._earlier[index] for index in COMPARED_FRAMES if index < len(self._earlier)]
        if not compared:
            return frame.depth
        views = [(free, matmul(invert_pose(its_pose), pose)) for free, its_pose in compared]
        return hide_moved(frame.depth, frame.intrinsic, views)

    def add(self, frame: SensorFrame, pose: Pose) -> None:
        if self._count % FRAME_INTERVAL == 0:
            self._earlier = [*self._earlier[-MAX_STORED_FRAMES + 1 :], (FreeSpace(frame.pyramid.levels), pose.copy())]
        self._count += 1
