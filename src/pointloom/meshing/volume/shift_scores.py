"""Fit of shifted points to a volume's surface."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.serialized import locked_objects
from ...kernels.lang import vec3
from ...kernels.memory import download, upload
from ...kernels.volumes import shift_scores
from .tsdf import TSDFVolume


def score_shifts(
    volume: TSDFVolume,
    points: NDArray[np.float64],
    shifts: NDArray[np.float64],
    *,
    weight_threshold: float,
    min_score: float,
    is_coarse: bool = False,
) -> NDArray[np.float32]:
    """Mean closeness of points (n, 3) to the surface after each shift (m, 3) [m], 0 (a truncation off, or unseen) to 1.
    Voxels with at most `weight_threshold` frames are ignored. Shifts whose first points score below `min_score` stop
    early. With `is_coarse` a point scores 1 in any existing block."""
    with locked_objects([volume]):
        blocks, size = volume.blocks, volume.voxel_size
        local_points: Any = upload(((points - volume.origin) / size).astype(np.float32), vec3, blocks.device)
        moves: Any = upload((shifts / size).astype(np.float32), vec3, blocks.device)
        limits = weight_threshold, min_score
        return download(shift_scores.score_shifts(local_points, moves, blocks, *limits, is_coarse=is_coarse))  # sync
