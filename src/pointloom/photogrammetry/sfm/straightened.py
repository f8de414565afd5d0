"""SfM models with undistorted images."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.camera_models import CameraModel
from ...io.models.sfm_model import SfmModel


def straightened_model(model: SfmModel, names: Sequence[str], cameras: Sequence[PinholeCameraIntrinsic]) -> SfmModel:
    pixels = np.empty_like(model.pixels)
    for k, (before, after) in enumerate(zip(model.cameras, cameras, strict=True)):
        mine = model.observations[:, 0] == k
        rays = before.unproject(model.pixels[mine])
        pixels[mine] = rays[:, :2] * (after.fx, after.fy) + (after.cx, after.cy)
    seen = np.isfinite(pixels).all(axis=1)  # a lens fitted to few points may not be invertible near the border
    pinholes = tuple(CameraModel.from_intrinsic(camera) for camera in cameras)
    fields = {"observations": model.observations[seen], "pixels": pixels[seen]}
    return replace(model, names=tuple(names), cameras=pinholes, **fields)
