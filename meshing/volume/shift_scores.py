"""How well points lie on a volume's surface if they were shifted: for who asks where else they would fit."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

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
    least: float,
    is_coarse: bool = False,
) -> NDArray[np.float32]:
    """The mean closeness of the points to the surface after each shift, 0 (a truncation off, or unseen) to 1.

    Args:
        volume: The TSDFVolume.
        points: [n, 3] [m], spread evenly however many of the first are taken.
        shifts: [m, 3] [m].
        weight_threshold: Voxels seen by no more frames than this are as if absent.
        least: Shifts whose first points score less are not looked at further; what they have then is told.
        is_coarse: Whether a point counts 1 wherever a block of 8^3 voxels is, for steps of a block's size.
    """
    blocks = volume._blocks
    placed: Any = upload(((points - volume.origin) / volume.voxel_size).astype(np.float32), vec3, blocks.device)
    moves: Any = upload((shifts / volume.voxel_size).astype(np.float32), vec3, blocks.device)
    scores = shift_scores.score_shifts(placed, moves, blocks, weight_threshold, least, is_coarse=is_coarse)
    return download(scores)  # sync
