"""Results of data generators: frozen records with ground truth."""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...pcd.cloud import PointCloud


@dataclasses.dataclass(frozen=True, eq=False)
class PosedScans:
    """Scans of one scene in sensor coordinates, with true poses.

    Attributes:
        scans: Clouds [m].
        poses: T_world_sensor, float64 (n, 4, 4) [m].

    Example:
        >>> scans = PosedScans([PointCloud([[1.0, 2.0, 3.0]])], np.eye(4)[None])
        >>> len(scans), scans.in_world(0).points.tolist()
        (1, [[1.0, 2.0, 3.0]])
    """

    scans: list[PointCloud]
    poses: NDArray[np.float64]

    def __repr__(self) -> str:
        return f"PosedScans({len(self):,} scans of {sum(map(len, self.scans)):,} points together)"

    def __len__(self) -> int:
        return len(self.scans)

    def in_world(self, index: int) -> PointCloud:
        """A scan in world coordinates."""
        return self.scans[index].transform(self.poses[index])


@dataclasses.dataclass(frozen=True, eq=False)
class PosedImages:
    """Images of one scene by one camera, with true poses.

    Attributes:
        images: uint8 RGB (h, w, 3) each.
        intrinsic: The camera, without distortion.
        poses: T_world_camera, float64 (n, 4, 4) [m].
        depths: True depth along the optical axis, float32 (h, w) [m] each. 0 for background.
    """

    images: list[NDArray[np.uint8]]
    intrinsic: PinholeCameraIntrinsic
    poses: NDArray[np.float64]
    depths: list[NDArray[np.float32]]

    def __repr__(self) -> str:
        return f"PosedImages({len(self):,} images of {self.intrinsic.width} x {self.intrinsic.height})"

    def __len__(self) -> int:
        return len(self.images)
