"""Structure from motion of a folder of images in one call."""

from __future__ import annotations

import dataclasses

from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from .features import find_features
from .image_folder import check_path
from .mapping import SfmResult, map_images
from .matches import match_features
from .settings import SfmSettings, check_settings


def reconstruct_images(
    images: FilePath,
    work: FilePath,
    settings: SfmSettings | None = None,
    *,
    masks: FilePath | None = None,
    progress: ReportProgress | None = None,
) -> SfmResult:
    """Run structure from motion: `find_features`, `match_features` and `map_images`.

    Args:
        images: Folder of upright 8-bit images, as from `choose_frames`.
        work: Folder for features.db, matches.db and sparse/ (COLMAP model); created if missing.
        settings: Settings of all stages; None: the defaults. A known camera is kept.
        masks: Folder of masks, as of `find_features`.
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
    folder, settings = check_path("work", work), check_settings(settings)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(work, f"cannot be created: {error.strerror or error}") from error
    features_db, matches_db, sparse = folder / "features.db", folder / "matches.db", folder / "sparse"
    if sparse.is_dir() and any(sparse.iterdir()):
        raise FileError(sparse, "is not empty", remedy="Give a new folder to work in")
    feature_report = find_features(images, features_db, settings, masks=masks, progress=progress)
    matched = match_features(features_db, matches_db, settings, progress=progress)
    result = map_images(images, matches_db, sparse, settings, progress=progress)
    seconds = {"features": feature_report.seconds, "pairs": matched.seconds} | result.seconds
    peak = {"features": feature_report.peak_bytes, "pairs": matched.peak_bytes} | result.peak_bytes
    return dataclasses.replace(result, seconds=seconds, peak_bytes=peak)
