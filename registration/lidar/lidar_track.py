"""What LiDAR odometry carries from scan to scan: the map, the motion, and a scan that lies beside the map."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...kernels.linear_algebra import matmul
from ...kernels.odometry.voxel_map import VoxelMap
from ..rigid import invert_pose, pose_of
from .deskewing import twist_of
from .lidar_steps import OdometryStep
from .raw_scan import RawScan
from .scan_matching import AdaptiveThreshold

Matrix = NDArray[np.float64]

YOUNG = 3  # scans after the first: later the map holds what was matched wrongly, and that is matched again


@dataclass(frozen=True, eq=False)
class Aside:
    """The last scan, where it lies beside the map: it joins the map if the next one lies on it and not on the map.

    Attributes:
        points: Of the scan, thinned for the map.
        pose: Where it was predicted.
    """

    points: wp.array
    pose: Matrix

    def map_like(self, voxel_map: VoxelMap, max_range: float) -> VoxelMap:
        """A map of this scan alone."""
        alone = VoxelMap(voxel_map.voxel_size, voxel_map.room, self.points.device)
        alone.add(self.points, self.pose, max_range)
        return alone


@dataclass(frozen=True, eq=False)
class Known:
    """What is carried from scan to scan, beside the steps.

    Attributes:
        threshold: How far predictions were off.
        map: Points of the scans so far; None before the first.
        first: The first scan, until the second one came.
        pruned_at: Where the sensor was when the map was last cut.
        motion: From scan to scan, as the last ones that lay on the map have it.
        has_motion: Whether any scan lay on the map of those before it.
        has_way: Whether any did and told all of its motion, and nothing else fitted.
        began: Number of the first scan.
        sound: Number and pose of the last scan that lay on the map.
        aside: The last scan, where it did not.
    """

    threshold: AdaptiveThreshold
    map: VoxelMap | None = None
    first: RawScan | None = None
    pruned_at: NDArray[np.float64] = field(default_factory=lambda: np.zeros(3))
    motion: Matrix = field(default_factory=lambda: np.eye(4))
    has_motion: bool = False
    has_way: bool = False
    began: int = 0
    sound: tuple[int, Matrix] | None = None
    aside: Aside | None = None

    def after(self, step: OdometryStep, last_pose: Matrix, aside: Aside | None) -> Known:
        """The motion and the last sound scan once a step is taken; `aside` is that of the step."""
        if not step.is_sound:
            return replace(self, motion=matmul(invert_pose(last_pose), step.pose), aside=aside)
        motion = matmul(invert_pose(last_pose), step.pose)
        if self.sound is not None and step.index - self.sound[0] > 1 and not step.has_joined:
            gap = step.index - self.sound[0]
            motion = pose_of(twist_of(matmul(invert_pose(self.sound[1]), step.pose)) / gap)
        has_motion = self.has_motion or (self.sound is not None and step.iterations > 0)
        has_way = self.has_way or (has_motion and not step.is_undetermined and not step.rivals)
        began = step.index if self.sound is None else self.began
        return replace(
            self, motion=motion, has_motion=has_motion, has_way=has_way, began=began, sound=(step.index, step.pose),
            aside=None,
        )  # fmt: skip

    def is_young(self, index: int) -> bool:
        """Whether nothing sure is known of the motion yet, and the run has just begun."""
        return not self.has_way and index - self.began <= YOUNG


@dataclass(frozen=True, eq=False)
class Next:
    """A scan on its way into the map.

    Attributes:
        step: Its step.
        known: What holds once it is there.
        additions: Of the map, before it.
        parts: Points and poses that join the map: the scan's, before it those of one that was aside, or none.
    """

    step: OdometryStep
    known: Known
    additions: int
    parts: tuple[tuple[wp.array, Matrix], ...]

    def has_begun(self) -> bool:
        """Whether the map has changed."""
        return self.known.map is not None and self.known.map.additions > self.additions

    def join(self, max_range: float) -> None:
        """Add what is not yet in the map."""
        assert self.known.map is not None
        for points, pose in self.parts[self.known.map.additions - self.additions :]:
            self.known.map.add(points, pose, max_range)
