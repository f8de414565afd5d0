"""Brightness images as the blocks of 2 x 2 pixels that patch costs read."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from pointloom.kernels.lang import uint64
from pointloom.kernels.memory import upload
from pointloom.kernels.stereo.brightness import LEVELS


def as_blocks(levels: np.ndarray) -> np.ndarray:
    """Pixels [h, w], the ones to the right, below, and opposite, with a repeated border, [h, w, 4]."""
    height, width = levels.shape
    padded = np.pad(levels, ((0, 1), (0, 1)), mode="edge")
    return np.stack([padded[k // 2 :, k % 2 :][:height, :width] for k in range(4)], -1)


def stored(pictures: Sequence[np.ndarray], device: str) -> Any:
    levels = [np.round(np.clip(each, 0, 1) * LEVELS).astype(np.uint16) for each in pictures]
    return upload(np.concatenate([as_blocks(each).reshape(-1) for each in levels]).view(np.uint64), uint64, device)
