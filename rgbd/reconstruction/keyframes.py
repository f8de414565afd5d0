"""Loops within a fragment: keyframes that see the same again are aligned, begun where odometry says they are."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...kernels.linear_algebra import matmul
from ...registration.rigid import invert_pose

Matrix = NDArray[np.float64]

SAMPLES = 300  # depth pixels of a keyframe, that say what it shares with another
SHARED = 0.35  # share of them that the other should see: 0.3 is what Open3D asks of a loop between fragments
SAME_DEPTH = 0.1  # of the depth: farther behind what the other sees there, a sample is hidden from it
MOST_LOOPS = 3  # for a keyframe: the widest apart in time, which say most, and its neighbour


@dataclass(frozen=True, eq=False)
class Keyframe:
    """A frame that loops are sought for.

    Attributes:
        place: Within its fragment.
        frame: Prepared for alignment.
        points: Some of what it sees, float64 [k, 3], in its camera's coordinates [m].
        depths: The depth map at every few pixels, [m].
        step: How many.
    """

    place: int
    frame: Any
    points: Matrix
    depths: NDArray[np.float32]
    step: int

    @classmethod
    def make(cls, place: int, frame: Any, depth: NDArray[np.float32], intrinsic: PinholeCameraIntrinsic) -> Keyframe:
        """A keyframe of a frame's depth [m]."""
        step = max(1, min(depth.shape) // 60)
        depths = depth[::step, ::step].copy()
        rows, columns = np.nonzero(depths)
        chosen = slice(None, None, max(1, len(rows) // SAMPLES))
        rows, columns = rows[chosen], columns[chosen]
        z = depths[rows, columns].astype(np.float64)
        x = (columns * step - intrinsic.cx) / intrinsic.fx * z
        y = (rows * step - intrinsic.cy) / intrinsic.fy * z
        return cls(place, frame, np.stack([x, y, z], axis=1), depths, step)

    def share_seen_by(self, other: Keyframe, T_other_self: Matrix, intrinsic: PinholeCameraIntrinsic) -> float:
        """Share of what it sees that another sees too, under a pose: in its picture, and not behind what it sees."""
        points = matmul(self.points, T_other_self[:3, :3].T) + T_other_self[:3, 3]
        points = points[points[:, 2] > 0]
        z = points[:, 2]
        column = np.rint((points[:, 0] / z * intrinsic.fx + intrinsic.cx) / other.step).astype(np.int64)
        row = np.rint((points[:, 1] / z * intrinsic.fy + intrinsic.cy) / other.step).astype(np.int64)
        height, width = other.depths.shape
        inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
        there = other.depths[row[inside], column[inside]]
        seen = (there > 0) & (np.abs(z[inside] - there) <= SAME_DEPTH * there)
        return float(seen.sum()) / max(len(self.points), 1)


def find_candidates(
    keyframes: list[Keyframe], poses: list[Matrix], intrinsic: PinholeCameraIntrinsic
) -> list[tuple[int, int, Matrix]]:
    """Pairs of keyframes (later, earlier, T_earlier_later) that should see the same, in order."""
    found = []
    for b, later in enumerate(keyframes):
        chosen = []
        for a, earlier in enumerate(keyframes[:b]):
            T = matmul(invert_pose(poses[earlier.place]), poses[later.place])
            if later.place - earlier.place < 2:
                continue  # that pair is odometry's
            if min(_shares(later, earlier, T, intrinsic)) >= SHARED:
                chosen.append((b, a, T))
        found += chosen if len(chosen) <= MOST_LOOPS else [*chosen[: MOST_LOOPS - 1], chosen[-1]]
    return found


def _shares(later: Keyframe, earlier: Keyframe, T: Matrix, intrinsic: PinholeCameraIntrinsic) -> tuple[float, float]:
    back = earlier.share_seen_by(later, invert_pose(T), intrinsic)
    return later.share_seen_by(earlier, T, intrinsic), back
