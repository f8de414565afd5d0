"""Structure from motion of a folder of images in one call."""

from __future__ import annotations

import dataclasses
from typing import Any

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.camera_models import CameraModel
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from .colmap_jobs import MAX_SECONDS
from .features import MAX_FEATURES, MAX_SIZE, find_features
from .image_folder import check_path
from .mapping import SfmResult, map_images
from .matches import SEQUENCE_OVERLAP, match_features


def reconstruct_images(
    images: FilePath,
    work: FilePath,
    *,
    camera_model: str = "SIMPLE_RADIAL",
    intrinsic: PinholeCameraIntrinsic | CameraModel | None = None,
    max_size: int = MAX_SIZE,
    max_features: int = MAX_FEATURES,
    masks: FilePath | None = None,
    pairs: str = "auto",
    overlap: int = SEQUENCE_OVERLAP,
    mapper: str = "auto",
    kind: str = "sift",
    use_gpu: bool | None = None,
    seed: int = 0,
    max_seconds: float | None = MAX_SECONDS,
    max_memory: int | None = None,
    progress: ReportProgress | None = None,
) -> SfmResult:
    """Run structure from motion: `find_features`, `match_features` and `map_images`.

    Args:
        images: Folder of upright 8-bit images, as from `choose_frames`.
        work: Folder for features.db, matches.db and sparse/ (COLMAP model); created if missing.
        camera_model: COLMAP camera model.
        intrinsic: Known camera, kept fixed.
        max_size: Maximum image side for feature extraction [px].
        max_features: Maximum number per image.
        masks: Folder of masks, as of `find_features`.
        pairs, overlap: As of `match_features`.
        mapper: As of `map_images`.
        kind, use_gpu: As of `find_features`.
        seed: Random seed.
        max_seconds: Time limit per stage [s]; None: no limit.
        max_memory: Memory limit of COLMAP [B]; None: nine tenths of the free memory.
        progress: Called with (stage, steps done, steps in all), stages "features", "pairs", "model".

    Returns:
        The largest model and its quality; times and memory of all stages.

    Raises:
        FileError: As of the three; or `work` already has a model.
        TypeError, ValueError: An argument is out of range.

    Notes:
        Reproducible with one version of pycolmap.

    Example:
        >>> import pointloom as loom
        >>> loom.photogrammetry.reconstruct_images("no such folder", "work")
        Traceback (most recent call last):
        pointloom.core.errors.DatasetError: no such folder: does not exist. Give a folder of images
    """
    check_path("images", images)
    folder = check_path("work", work)
    common: dict[str, Any] = {"seed": seed, "max_seconds": max_seconds, "max_memory": max_memory, "progress": progress}
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(work, f"cannot be created: {error.strerror or error}") from error
    features_db, matches_db, sparse = folder / "features.db", folder / "matches.db", folder / "sparse"
    if sparse.is_dir() and any(sparse.iterdir()):
        raise FileError(sparse, "is not empty", remedy="Give a new folder to work in")
    options = {"camera_model": camera_model, "intrinsic": intrinsic, "max_size": max_size, "max_features": max_features}
    options |= {"masks": masks, "kind": kind, "use_gpu": use_gpu}
    feature_report = find_features(images, features_db, **options, **common)
    matched = match_features(features_db, matches_db, pairs=pairs, overlap=overlap, use_gpu=use_gpu, **common)
    result = map_images(images, matches_db, sparse, fix_intrinsic=intrinsic is not None, mapper=mapper, **common)
    seconds = {"features": feature_report.seconds, "pairs": matched.seconds} | result.seconds
    peak = {"features": feature_report.peak_bytes, "pairs": matched.peak_bytes} | result.peak_bytes
    return dataclasses.replace(result, seconds=seconds, peak_bytes=peak)
