"""SIFT feature extraction with COLMAP into its database."""

from __future__ import annotations

import dataclasses
import os
from collections import Counter
from pathlib import Path
from typing import Any

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.camera_models import CameraModel
from ...core.atomic import check_writable
from ...core.checks import check_progress
from ...core.errors import DatasetError, FileError, FilePath
from ...core.escaped_text import escaped
from ...core.progress import ReportProgress
from ...core.reports import Assessed, quality
from ...core.timing import Clock
from ...io.images.image_files import read_image_header
from ...kernels.language.cpu_pool import usable_cores
from .colmap_jobs import count_rows, database_in_the_making, open_database, run_job
from .exif_checks import focal_problem
from .image_folder import EXIF_UPRIGHT, check_path, is_gray_16, list_images, read_lens, read_orientation, scaled_size
from .image_writing import some_of
from .limited_process import check_limits, free_memory
from .masks import check_mask_files, complete_masks
from .settings import SfmSettings, check_settings

_BYTES_A_PIXEL = 360  # per pixel of the scaled image: SIFT's first octave has twice its size
_MIN_FEATURES = 50  # features below which an image is hardly ever registered


@dataclasses.dataclass(frozen=True)
class FeatureReport(Assessed):
    """Result of `find_features`.

    Args:
        database: Path of the database.
        names: Image names, by number.
        counts: Features of each image.
        sizes: Number of images of each (width, height) [px].
        seconds: Run time [s].
        peak_bytes: Peak memory of COLMAP [B].
        camera_count: Number of cameras: one for each size and EXIF lens.
        on_gpu: True if COLMAP used a GPU.
        notes: Rejected EXIF lenses.
    """

    database: str
    names: tuple[str, ...]
    counts: tuple[int, ...]
    sizes: dict[tuple[int, int], int]
    seconds: float
    peak_bytes: int
    camera_count: int = 1
    on_gpu: bool = False
    notes: tuple[str, ...] = ()

    @property
    def poor_names(self) -> tuple[str, ...]:
        """Names of images with few features."""
        return tuple(name for name, count in zip(self.names, self.counts, strict=True) if count < _MIN_FEATURES)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks. Empty if the result is reliable."""
        if not (poor := self.poor_names):
            return ()
        names = escaped(some_of(list(poor)))
        return (
            f"{len(poor)} of {len(self.names)} images have fewer than {_MIN_FEATURES} features ({names}), "
            "too few for a pose: take sharp images of a scene with texture, and check the masks",
        )

    def to_dict(self) -> dict[str, Any]:
        sizes = [{"width": w, "height": h, "count": count} for (w, h), count in self.sizes.items()]
        lists = {"names": list(self.names), "counts": list(self.counts), "poor_names": list(self.poor_names)}
        fields = {"database": self.database, "seconds": self.seconds, "peak_bytes": self.peak_bytes}
        more = {"camera_count": self.camera_count, "on_gpu": self.on_gpu, "notes": list(self.notes)}
        return fields | lists | {"sizes": sizes} | more | quality(self)


def find_features(
    images: FilePath,
    database: FilePath,
    settings: SfmSettings | None = None,
    *,
    masks: FilePath | None = None,
    progress: ReportProgress | None = None,
) -> FeatureReport:
    """Find features in each image of a folder, SIFT (Lowe 2004) by default.

    Args:
        images: Folder of upright 8-bit PNG or JPEG images, as from `choose_frames`.
        database: Output file (COLMAP database); replaced if it exists.
        settings: Camera, features and limits; None: the defaults.
        masks: Folder of masks as from `choose_frames`: IMG_1.jpg.png for IMG_1.jpg, no features where black. Images
            without a mask are used completely.
        progress: Called with ("features", done, all).

    Returns:
        The number of features of each image.

    Raises:
        FileError: Fewer than two images. A damaged, rotated or 16-bit image. A mask that is missing, of another size or
            that hides all; pycolmap is missing (`pip install "pointloom[sfm]"`). COLMAP failed. A full disk.
        TypeError, ValueError: An argument out of range, or a camera of another aspect ratio.

    Notes:
        Reproducible for any number of cores. Uses as many cores as memory allows: 360 B per pixel of the scaled image
        and core, 0.6 GB at 1600 x 1067. COLMAP runs in a separate process, which is killed on interruption.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.photogrammetry.sfm.features import find_features
        >>> find_features("no such folder", "features.db")
        Traceback (most recent call last):
        pointloom.core.errors.DatasetError: no such folder: does not exist. Give a folder of images
    """
    clock, report, settings = Clock(), check_progress(progress), check_settings(settings)
    limits = check_limits(settings.max_seconds, settings.max_memory)
    folder, target = check_path("images", images), check_writable(check_path("database", database))
    groups = _groups(folder, by_lens=settings.intrinsic is None)
    problems = {} if settings.intrinsic is not None else _focal_problems(folder, groups)
    memory = limits["max_memory"] or free_memory()
    job = _job_of(folder, groups, settings, problems) | {"seed": int(settings.seed), "kind": settings.kind}
    job |= {"threads": threads_for([size for size, _ in groups], settings.max_size, memory), "gpu": settings.use_gpu}
    job |= {"max_size": int(settings.max_size), "max_features": int(settings.max_features)}
    mask_files = None if masks is None else _checked_masks(masks, folder)
    count = sum(len(names) for names in groups.values())
    with database_in_the_making(target) as part:
        report("features", 0, count)
        poll = lambda: report("features", min(count_rows(part, "keypoints"), count), count)  # noqa: E731
        job |= {"masks": None if mask_files is None else _masks_beside(part, folder, mask_files)}
        done, peak = run_job(job | {"database": os.fspath(part)}, folder, poll=poll, **limits)
        names, counts = _features_of(part)
    report("features", count, count)
    clock.stop("features")
    notes = tuple(f"EXIF's focal length of {name} is rejected: {reason}" for name, reason in problems.items())
    stats = clock.seconds["features"], peak, len(groups), done["gpu"], notes
    return FeatureReport(os.fspath(target), names, counts, _counted_sizes(groups), *stats)


def _focal_problems(folder: Path, groups: dict[Group, list[str]]) -> dict[str, str]:
    problems = {names[0]: focal_problem(folder / names[0], size) for (size, _), names in groups.items()}
    return {name: reason for name, reason in problems.items() if reason is not None}


def _job_of(
    folder: Path, groups: dict[Group, list[str]], settings: SfmSettings, problems: dict[str, str]
) -> dict[str, Any]:
    cameras = [
        _group(size, names, settings.camera_model, settings.intrinsic) | {"doubted": names[0] in problems}
        for (size, _), names in groups.items()
    ]
    return {"stage": "features", "images": os.fspath(folder.resolve()), "groups": cameras}


def _masks_beside(database: Path, images: Path, masks: dict[str, Path]) -> str:
    folder = database.with_name("masks")
    complete_masks(list_images(images), masks, folder)
    return os.fspath(folder)


def _counted_sizes(groups: dict[Group, list[str]]) -> dict[tuple[int, int], int]:
    sizes = Counter({size: 0 for size, _ in groups})
    for (size, _), group in groups.items():
        sizes[size] += len(group)
    return dict(sizes)


def _checked_masks(masks: Any, folder: Path) -> dict[str, Path]:
    path = check_path("masks", masks)
    if not path.is_dir():
        raise DatasetError(
            path, "is not a folder", remedy="Give the folder of the masks, with IMG_1.jpg.png for IMG_1.jpg"
        )
    return check_mask_files(list_images(folder), path)


def threads_for(sizes: list[tuple[int, int]], max_size: int, memory: float) -> int:
    pixels = max(width * height for width, height in (scaled_size(size, max_size) for size in sizes))
    return max(1, min(usable_cores(), int(memory // (_BYTES_A_PIXEL * pixels))))


Group = tuple[tuple[int, int], tuple[str, ...]]


def _groups(folder: Path, *, by_lens: bool) -> dict[Group, list[str]]:
    """Image names by size and EXIF lens, the group of the first image first. FileError if unsuitable for COLMAP."""
    paths = sorted(list_images(folder), key=lambda path: path.name)
    if len(paths) < 2:
        raise DatasetError(
            folder, "contains only one image; structure from motion needs two", remedy="Give another folder"
        )
    groups: dict[Group, list[str]] = {}
    for path in paths:
        header = read_image_header(path)
        fault = "is 16-bit gray" if is_gray_16(header) else ""
        if read_orientation(path) != EXIF_UPRIGHT:
            fault = "has an EXIF orientation that is not upright"
        if fault:
            raise FileError(path, fault, remedy="photogrammetry.choose_frames writes upright 8-bit images of a folder")
        lens = read_lens(path) if by_lens else ()
        groups.setdefault(((header.width, header.height), lens), []).append(path.name)
    return groups


def _group(
    size: tuple[int, int], names: list[str], camera_model: str, intrinsic: PinholeCameraIntrinsic | CameraModel | None
) -> dict[str, Any]:
    if intrinsic is None:
        return {"names": names, "model": camera_model, "params": ""}
    factor = size[0] / intrinsic.width
    if size != (intrinsic.width, intrinsic.height):
        scaled = (round(intrinsic.width * factor), round(intrinsic.height * factor))
        if abs(scaled[1] - size[1]) > 1 or isinstance(intrinsic, CameraModel):
            raise ValueError(
                f"intrinsic: expected {size[0]} x {size[1]} pixels as of {escaped(names[0])}, "
                f"got {intrinsic.width} x {intrinsic.height}"
            )
        intrinsic = intrinsic.scaled(factor)
    camera = intrinsic if isinstance(intrinsic, CameraModel) else CameraModel.from_intrinsic(intrinsic)
    return {"names": names, "model": camera.model, "params": ",".join(repr(value) for value in camera.params)}


def _features_of(database: Path) -> tuple[tuple[str, ...], tuple[int, ...]]:
    query = "SELECT name, coalesce(rows, 0) FROM images LEFT JOIN keypoints USING (image_id) ORDER BY image_id"
    with open_database(database) as connection:
        rows = connection.execute(query).fetchall()
    return tuple(name for name, _ in rows), tuple(count for _, count in rows)
