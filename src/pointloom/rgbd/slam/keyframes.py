"""Keyframes for relocalization: codes on the device, poses on the host."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ...kernels.lang import uint8
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import copy, download, zeros
from ...kernels.rgbd.keyframe_codes import FERN_COUNT, compare_codes, encode_frame
from ...registration.rigid import rotation_vector
from ..odometry.camera_fit import CameraView
from ..odometry.frames import OdometryFrame

Pose = NDArray[np.float64]

MIN_KEYFRAME_DISTANCE = 0.25  # [m] minimum distance to the nearest keyframe, or ...
MIN_ROTATION = np.deg2rad(18.0)  # ... minimum rotation of a new view
# Minimum distance of two views for the check of the camera, in distances of keyframes: 150 frames of a kitchen have 6
# keyframes and 9 rotated pairs, or 12 views and 34 pairs.
MIN_VIEW_DISTANCE = 0.5
MIN_COMMON = 0.15  # minimum fraction of tests valid in both frames


class CameraViews:
    """Views for the check of the camera, with correctable `poses` T_world_camera, and frame `numbers`."""

    def __init__(self) -> None:
        self.poses: list[Pose] = []
        self.numbers: list[int] = []
        self.cells: list[CameraView] = []

    def is_new(self, pose: Pose) -> bool:
        return all(view_distance(pose, other) > MIN_VIEW_DISTANCE for other in reversed(self.poses))

    def add(self, pose: Pose, number: int, cells: CameraView) -> None:
        self.poses.append(pose.copy())
        self.numbers.append(number)
        self.cells.append(cells)

    def extend(self, others: CameraViews, T: Pose) -> None:
        """Add the views of others, whose poses T transforms."""
        self.poses += [matmul(T, pose) for pose in others.poses]
        self.numbers += others.numbers
        self.cells += others.cells


class Keyframes:
    """Views from which frames can be recognized, with correctable `poses` T_world_camera, and frame `numbers`.

    The check of the camera has `views` of its own.
    """

    def __init__(self, device: wp.Device, seed: int = 0):
        self.device, self.seed = device, seed
        self.poses: list[Pose] = []
        self.numbers: list[int] = []
        self.views = CameraViews()
        self.codes: Any = zeros(64 * FERN_COUNT, uint8, device)

    def __len__(self) -> int:
        return len(self.poses)

    def add(self, frame: OdometryFrame, pose: Pose, number: int) -> int:
        index = len(self.poses)
        if (index + 1) * FERN_COUNT > self.codes.size:
            larger: Any = zeros(2 * self.codes.size, uint8, self.device)
            copy(larger, self.codes, count=self.codes.size)
            self.codes = larger
        self._encode(frame, self.codes, index)
        self.poses.append(pose.copy())
        self.numbers.append(number)
        return index

    def extend(self, others: Keyframes, T: Pose) -> None:
        """Add the views of others (with the same tests), whose poses T transforms."""
        count = len(self)
        needed = (count + len(others)) * FERN_COUNT
        if needed > self.codes.size:
            larger: Any = zeros(max(needed, 2 * self.codes.size), uint8, self.device)
            copy(larger, self.codes, count=count * FERN_COUNT)
            self.codes = larger
        copy(self.codes, others.codes, count=len(others) * FERN_COUNT, offset=count * FERN_COUNT)
        self.poses += [matmul(T, pose) for pose in others.poses]
        self.numbers += others.numbers
        self.views.extend(others.views, T)

    def is_new_view(self, pose: Pose) -> bool:
        return all(view_distance(pose, other) > 1.0 for other in reversed(self.poses))

    def recognize(self, frame: OdometryFrame, count: int) -> list[tuple[int, float]]:
        """The most similar keyframes (index, fraction of differing tests), without near duplicates. A sync."""
        if not self.poses:
            return []
        counts = download(compare_codes(self._encode(frame), self.codes, len(self.poses)))  # sync
        common, different = counts[:, 0], counts[:, 1]
        min_common = max(MIN_COMMON * common.max(initial=0), 1)
        fractions = np.where(common >= min_common, different / np.maximum(common, 1), 1.0)
        matches: list[tuple[int, float]] = []
        for index in np.argsort(fractions, kind="stable").tolist():
            pose = self.poses[index]
            if fractions[index] < 0.5 and all(view_distance(pose, self.poses[i]) > 1.5 for i, _ in matches):
                matches.append((index, float(fractions[index])))
            if len(matches) == count:
                break
        return matches

    def _encode(self, frame: OdometryFrame, codes: wp.array | None = None, row: int = 0) -> Any:
        levels = frame.levels
        last = levels.count - 1
        width, height = (int(side) for side in levels.sizes[last])
        first = int(levels.firsts[last])
        return encode_frame(levels.depth, levels.brightness, first, width, height, seed=self.seed, codes=codes, row=row)


def view_distance(a: Pose, b: Pose) -> float:
    """Distance of two views: 1 for MIN_KEYFRAME_DISTANCE meters, or for MIN_ROTATION radians."""
    shift = float(norm(a[:3, 3] - b[:3, 3])) / MIN_KEYFRAME_DISTANCE
    return shift + float(norm(rotation_vector(matmul(a[:3, :3].T, b[:3, :3])))) / MIN_ROTATION
