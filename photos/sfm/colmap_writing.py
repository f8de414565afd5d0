"""What was found without COLMAP, written into its database: run by colmap_worker.py, and as bare as that."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np


def write_features(pycolmap: Any, job: dict[str, Any]) -> None:
    """Features of the pictures: one file of arrays each, in the order of the names."""
    with pycolmap.Database.open(job["database"]) as database:
        numbers = {image.name: image.image_id for image in database.read_all_images()}
        for name, path in zip(_names(job), sorted(Path(job["found"]).glob("*.npz")), strict=True):
            with np.load(path) as arrays:
                shapes, descriptors = arrays["shapes"], arrays["descriptors"]
            kind = pycolmap.FeatureExtractorType.SIFT
            database.write_keypoints(numbers[name], shapes)
            database.write_descriptors(numbers[name], pycolmap.FeatureDescriptors(kind, descriptors))


def write_matches(pycolmap: Any, job: dict[str, Any]) -> None:
    """Matches of pairs of pictures, several files of arrays, held against one motion of the camera."""
    with pycolmap.Database.open(job["database"]) as database:
        for path in sorted(Path(job["found"]).glob("*.npz")):
            with np.load(path) as arrays:
                pairs, firsts, matches = arrays["pairs"], arrays["firsts"], arrays["matches"]
            for (a, b), first, last in zip(pairs.tolist(), firsts, firsts[1:], strict=False):
                database.write_matches(a, b, matches[first:last].astype(np.uint32))


def _names(job: dict[str, Any]) -> list[str]:
    return [name for group in job["groups"] for name in group["names"]]
