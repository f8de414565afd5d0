"""A lost frame found on the model by its shape alone, from no guess, wherever the camera stands by now.

The frame's points are registered with the model's by `registration`'s features and consensus, and taken where its
score believes the pose. It takes as long as some frames, so it is tried less and less often while a camera is lost.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...pcd.cloud import PointCloud
from ...registration.globally.global_registration import FEWEST_POINTS, Description, describe, register_described
from .frames import SensorFrame
from .model import Model

Pose = NDArray[np.float64]

VOXELS = 2.0  # voxels of the model in one of registration; with larger ones little overlap is not found
LEAST_VOXEL = 0.04  # [m] below it a single frame's normals are noise
SURE = 0.8  # score above which a pose is worth a second look; of poses on a tenth of a frame half that may be wrong
FIRST, LATER = (1, 4, 10, 20), 20  # which frames of those in a row that are not found are tried, and then every so many


class PlaceSearch:
    """Registers lost frames with a model; its description is made once while the model stays.

    Args:
        model: The Model.
        seed: As of `register_globally`.
    """

    def __init__(self, model: Model, seed: int):
        self.model, self.seed = model, seed
        self.voxel_size = max(VOXELS * model.volume.voxel_size, LEAST_VOXEL)
        self._described: tuple[int, Description | None] = (-1, None)

    def is_due(self, attempts: int) -> bool:
        """Whether a frame is tried that is the `attempts`-th in a row, from 1 on, that shows something and is lost."""
        return attempts in FIRST or (attempts > FIRST[-1] and attempts % LATER == 0)

    def find(self, frame: SensorFrame) -> Pose | None:
        """T_world_camera of a frame, or None where none is believed."""
        target = self._model()
        stride = max(1, round(frame.intrinsic.width / 320))
        cloud = PointCloud._from_device_depth(frame.depth, None, frame.intrinsic, None, stride, True, True)
        if target is None or len(cloud) < FEWEST_POINTS:
            return None
        found = register_described(describe(cloud, self.voxel_size), target, seed=self.seed)
        return found.transformation if found.score is not None and found.score > SURE else None

    def _model(self) -> Description | None:
        count = self.model.frame_count
        if self._described[0] != count:
            cloud = self.model.extract_point_cloud(self.model.threshold)
            thin = cloud.voxel_down_sample(self.voxel_size / 2) if len(cloud) else cloud
            self._described = count, describe(thin, self.voxel_size) if len(thin) >= FEWEST_POINTS else None
        return self._described[1]
