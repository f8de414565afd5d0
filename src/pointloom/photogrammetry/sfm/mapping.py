"""Structure from motion: poses and points from matches, by COLMAP."""

from __future__ import annotations

import dataclasses
import os
import shutil
from pathlib import Path
from typing import Any

from ...core.checks import check_progress
from ...core.errors import DatasetError, FileError, FilePath
from ...core.progress import ReportProgress
from ...core.reports import Assessed, quality
from ...core.timing import Clock
from ...io.models.colmap import read_colmap_model
from ...io.models.sfm_model import SfmModel
from .camera_check import CameraCheck
from .colmap_jobs import names_by_number, open_database, run_job, scratch_beside
from .image_folder import check_path
from .image_writing import new_folder
from .limited_process import check_limits
from .model_quality import ModelQuality, assess_model
from .repetition_check import check_repetition
from .settings import SfmSettings, check_settings

MANY_IMAGES = 150  # up to here incremental mapping costs about as much as global mapping


@dataclasses.dataclass(frozen=True)
class SfmResult(Assessed):
    """Result of `map_images`.

    Args:
        model: The largest model. None if there is none.
        folder: Its folder, in COLMAP's format.
        quality: Its quality.
        missing: Names of images without a pose.
        seconds: Time of each stage [s].
        peak_bytes: Peak memory of COLMAP in each [B].
    """

    model: SfmModel | None
    folder: str
    quality: ModelQuality
    missing: tuple[str, ...]
    seconds: dict[str, float]
    peak_bytes: dict[str, int]

    @property
    def warnings(self) -> tuple[str, ...]:
        return self.quality.warnings

    def to_dict(self) -> dict[str, Any]:
        fields = {"folder": self.folder, "missing": list(self.missing), "seconds": self.seconds}
        return fields | {"peak_bytes": self.peak_bytes, "quality": self.quality.to_dict(), **quality(self)}


def map_images(
    images: FilePath,
    matches: FilePath,
    folder: FilePath,
    settings: SfmSettings | None = None,
    *,
    progress: ReportProgress | None = None,
) -> SfmResult:
    """Estimate camera poses and points from matches.

    Args:
        images: Image folder, for the point colors.
        matches: Database of `match_features`. Not modified.
        folder: Output folder of the model (COLMAP binary), new or empty.
        settings: Known camera, mapper and limits; None: the defaults.
        progress: Called with ("model", images registered, all); restarts with each model.

    Returns:
        The largest model and its quality. An unreliable model, or none, is a result, not an error.

    Raises:
        FileError: Missing files, a folder that is not empty, pycolmap is missing, COLMAP failed, or a full disk.
        TypeError, ValueError: An argument is out of range.

    Notes:
        Runs on one core for reproducibility: with two, the last bits and sometimes the points differ. The unit is
        arbitrary. Schoenberger and Frahm, "Structure-from-motion revisited", CVPR 2016.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.photogrammetry.sfm.mapping import map_images
        >>> map_images(".", "matches.db", "sparse")
        Traceback (most recent call last):
        pointloom.core.errors.FileError: matches.db: does not exist. photogrammetry.find_features creates one
    """
    clock, report, settings = Clock(), check_progress(progress), check_settings(settings)
    source, database = check_path("images", images), check_path("matches", matches)
    target = check_path("folder", folder)
    if not source.is_dir():
        raise DatasetError(images, "is not a folder", remedy="Give the folder of the images")
    names = _names_of(database)
    job: dict[str, Any] = {"stage": "model", "images": os.fspath(source.resolve()), "threads": 1}
    usual = "global" if len(names) > MANY_IMAGES else "incremental"
    job |= {"mapper": usual if settings.mapper == "auto" else settings.mapper, "seed": int(settings.seed)}
    job |= {"fixed_camera": settings.keeps_intrinsic}
    limits = check_limits(settings.max_seconds, settings.max_memory)
    report("model", 0, len(names))
    with new_folder(target):
        done, peak = _map(job, database, target, names, report, limits)
    model = read_colmap_model(target) if done["sizes"] else None
    checks: dict[str, Any] = {"model_sizes": done["sizes"] or None, "focal": CameraCheck.from_json(done["cameras"])}
    checks["repetition"] = None if model is None else check_repetition(model, database)
    assessed = assess_model(model, len(names), fix_intrinsic=settings.keeps_intrinsic, **checks)
    missing = tuple(sorted(set(names) - set(model.names if model else ())))
    clock.stop("model")
    return SfmResult(model, os.fspath(target), assessed, missing, clock.seconds, {"model": peak})


def _names_of(database: Path) -> list[str]:
    with open_database(database) as connection:
        names = list(names_by_number(connection, database).values())
        (tried,) = connection.execute("SELECT count(*) FROM two_view_geometries").fetchone()
    if not tried and len(names) > 1:
        raise FileError(database, "contains no matches", remedy="photogrammetry.match_features computes them")
    return names


def _map(
    job: dict[str, Any], database: Path, target: Path, names: list[str], report: ReportProgress, limits: dict[str, Any]
) -> tuple[dict[str, Any], int]:
    with scratch_beside(target) as folder:
        copy, scratch, model = (folder / name for name in ("database.db", "scratch", "model"))
        shutil.copyfile(database, copy)  # COLMAP writes to databases that it opens
        scratch.mkdir()
        model.mkdir()
        job |= {"database": os.fspath(copy), "scratch": os.fspath(scratch), "model": os.fspath(model)}

        def report_registered(message: dict[str, Any]) -> None:
            report("model", min(int(message.get("registered", 0)), len(names)), len(names))

        done, peak = run_job(job, database, report=report_registered, **limits)
        for path in sorted(model.iterdir()):
            path.replace(target / path.name)
    return done, peak
