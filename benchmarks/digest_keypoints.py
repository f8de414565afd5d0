"""The operation of digests.py that finds and matches features of pictures."""

from __future__ import annotations

from typing import Any

import numpy as np
from digest_scenes import loom


def found_and_matched(d: Any) -> list[Any]:
    """Features of a made picture and of the same one moved, in full and of coarse scales alone, and their matches."""
    sfm, rng = loom().sfm, np.random.default_rng(9)
    coarse = np.kron(rng.integers(0, 256, (16, 20)), np.ones((8, 8)))
    picture = (0.7 * coarse + 0.3 * rng.integers(0, 256, coarse.shape)).astype(np.uint8)
    mask = np.arange(160) < np.full((128, 1), 150)
    pictures = (picture, {"mask": mask}), (np.roll(picture, (5, 9), (0, 1)), {}), (picture, {"max_features": 9})
    every = [sfm.detect_keypoints(each, device=d.device, **options) for each, options in pictures]
    arrays = [[k.positions, k.scales, k.orientations, k.descriptors] for k in every]
    return [*arrays, sfm.match_keypoints(*every[:2], device=d.device)]
