"""Structure from motion in one call: features, matches and the model of a folder of pictures."""

from __future__ import annotations

import dataclasses
from typing import Any

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.camera_models import CameraModel
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from .colmap_jobs import MAX_SECONDS
from .features import MAX_FEATURES, MAX_SIZE, find_features
from .mapping import SfmResult, map_pictures
from .matches import OVERLAP, match
from .picture_folder import check_place


def reconstruct(
    pictures: FilePath,
    work: FilePath,
    *,
    camera_model: str = "SIMPLE_RADIAL",
    intrinsic: PinholeCameraIntrinsic | CameraModel | None = None,
    max_size: int = MAX_SIZE,
    max_features: int = MAX_FEATURES,
    masks: FilePath | None = None,
    pairs: str = "auto",
    overlap: int = OVERLAP,
    mapper: str = "auto",
    kind: str = "sift",
    use_gpu: bool | None = None,
    seed: int = 0,
    max_seconds: float | None = MAX_SECONDS,
    max_memory: int | None = None,
    progress: ReportProgress | None = None,
) -> SfmResult:
    """Find where pictures were taken, and the points that they see: `find_features`, `match` and `map_pictures`.

    Args:
        pictures: A folder of upright 8-bit pictures, as `choose_frames` writes them.
        work: A folder for features.db, matches.db and sparse/, the model in COLMAP's format; made where there is none.
        camera_model: COLMAP's name of how the lens draws.
        intrinsic: A camera that is known, and kept.
        max_size: The longer side is scaled down to this to find features [px].
        max_features: Of a picture.
        masks: A folder of masks, as `find_features` takes it.
        pairs: "sequential", "exhaustive", "retrieval" or "auto", as `match` has them.
        overlap: Later pictures that each is matched to, where pairs are sequential.
        mapper: "incremental", "global" or "auto", as `map_pictures` has them.
        kind: Of features, as `find_features` has it.
        use_gpu: Whether features are found and matched on a GPU, likewise.
        seed: Of random numbers.
        max_seconds: Of each stage [s]; None for no limit.
        max_memory: Of COLMAP's process [B]; None for nine tenths of what is free.
        progress: Called with the stage ("features", "pairs", "model"), how many of its steps are done, and how many
            there are.

    Returns:
        The model with the most images and its quality; times and memory of all stages.

    Raises:
        FileError: As of the three; there is a model in `work` already.
        TypeError, ValueError: An argument out of range.

    Notes:
        The same model from run to run, on one version of pycolmap.

    Example:
        >>> import pointloom as loom
        >>> loom.sfm.reconstruct("no such folder", "work")
        Traceback (most recent call last):
        pointloom.core.errors.DatasetError: no such folder: does not exist. Give a folder of pictures
    """
    check_place("pictures", pictures)
    place = check_place("work", work)
    common: dict[str, Any] = {"seed": seed, "max_seconds": max_seconds, "max_memory": max_memory, "progress": progress}
    try:
        place.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(work, f"cannot be made: {error.strerror or error}") from error
    features_db, matches_db, sparse = place / "features.db", place / "matches.db", place / "sparse"
    if sparse.is_dir() and any(sparse.iterdir()):
        raise FileError(sparse, "is not empty", remedy="Give a new folder to work in")
    options = {"camera_model": camera_model, "intrinsic": intrinsic, "max_size": max_size, "max_features": max_features}
    options |= {"masks": masks, "kind": kind, "use_gpu": use_gpu}
    found = find_features(pictures, features_db, **options, **common)
    matched = match(features_db, matches_db, pairs=pairs, overlap=overlap, use_gpu=use_gpu, **common)
    result = map_pictures(pictures, matches_db, sparse, fix_intrinsic=intrinsic is not None, mapper=mapper, **common)
    seconds = {"features": found.seconds, "pairs": matched.seconds} | result.seconds
    peak = {"features": found.peak_bytes, "pairs": matched.peak_bytes} | result.peak_bytes
    return dataclasses.replace(result, seconds=seconds, peak_bytes=peak)
