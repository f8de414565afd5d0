"""What the makers give out: frozen records of clouds or pictures with the truth beside them."""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...pcd.cloud import PointCloud


@dataclasses.dataclass(frozen=True, eq=False)
class PosedScans:
    """Scans of one place, each in the frame of its own sensor, and where the sensor truly was.

    Attributes:
        scans: Clouds [m].
        poses: T_world_sensor of each, float64 [n, 4, 4] [m].

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
        """A scan where it truly lies."""
        return self.scans[index].transform(self.poses[index])


@dataclasses.dataclass(frozen=True, eq=False)
class PosedPictures:
    """Pictures of one place by one camera, and where it truly was.

    Attributes:
        pictures: uint8 RGB [h, w, 3] each.
        intrinsic: The camera, without distortion.
        poses: T_world_camera of each, float64 [n, 4, 4] [m].
        depths: True depth along the optical axis of each, float32 [h, w] [m]; 0 where nothing is.
    """

    pictures: list[NDArray[np.uint8]]
    intrinsic: PinholeCameraIntrinsic
    poses: NDArray[np.float64]
    depths: list[NDArray[np.float32]]

    def __repr__(self) -> str:
        return f"PosedPictures({len(self):,} pictures of {self.intrinsic.width} x {self.intrinsic.height})"

    def __len__(self) -> int:
        return len(self.pictures)
