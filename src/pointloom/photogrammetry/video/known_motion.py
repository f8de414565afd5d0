"""Pipeline stages with known lenses and poses: images by name, guided matching, triangulation."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera_models import MODELS, CameraModel
from ...cameras.undistortion import Undistortion
from ...core.errors import DatasetError, FilePath
from ...core.progress import ReportProgress
from ...core.stages import StageResult
from ...io.images.photo_files import is_photo
from ...io.models.colmap import read_colmap_model, write_colmap_model
from ...io.models.sfm_model import SfmModel
from ...kernels.array_types import Device
from ..sfm import features
from ..sfm.frame_picker import spaced
from ..sfm.guided_matches import read_matches, write_matches
from ..sfm.image_choice import duplicate_notes
from ..sfm.image_folder import EXIF_UPRIGHT, list_photographs, read_header, read_orientation, read_stored
from ..sfm.image_writing import write_bytes, write_image
from ..sfm.masks import MASK_THRESHOLD, MakeMask, check_some_left, hides_all, mask_as_stored, mask_notes, write_mask
from ..sfm.model_quality import assess_model
from ..sfm.pose_check import PoseCheck
from ..sfm.posed_images import with_poses
from ..sfm.settings import SfmSettings
from ..sfm.triangulation import match_posed, points_of
from .motion import DATABASE, IMAGES, MASKS, MODEL, described, masks_of, only_rotated
from .settings import VideoSettings

CAMERAS, MATCHES = "cameras", "matches.npz"


def take_images(
    folder: Path,
    report: ReportProgress,
    *,
    source: FilePath,
    max_frames: int,
    posed: VideoSettings,
    masks: FilePath | MakeMask | None = None,
) -> dict[str, Any]:
    """Copy the images with a pose in stored orientation, to which the lenses refer."""
    if not Path(source).is_dir():
        raise DatasetError(source, "is not a folder", remedy="Cameras with poses require the folder of their images")
    paths, second = list_photographs(source)
    given = posed.read_posed([path.name for path in paths])
    assert given is not None
    with_pose = with_poses(source, paths, given)
    chosen = spaced(list(range(len(with_pose.paths))), max_frames)
    images = folder / IMAGES
    images.mkdir()
    names, cameras, selected, lenses = [], [], [], {}
    hides = _Masks(Path(source), folder / MASKS, masks)
    for done, k in enumerate(chosen):
        report("write", done, len(chosen))
        path, lens = with_pose.paths[k], with_pose.model.cameras[k]
        mask = hides.mask_of(path, (lens.width, lens.height))
        if mask is not None and hides_all(mask):
            continue
        name, camera = _write(images, path, lens, lenses)
        if mask is not None:
            hides.write(name, mask, lenses.get(lens))
        names.append(name)
        cameras.append(camera)
        selected.append(k)
    report("write", len(chosen), len(chosen))
    hides.check(len(names))
    if len({Path(name).stem for name in names}) < len(names):
        raise DatasetError(source, "contains images whose names differ only in the extension", remedy="Rename them")
    model = SfmModel(tuple(names), tuple(cameras), with_pose.model.T_camera_world[selected])
    write_colmap_model(folder / CAMERAS, model)
    notes = [*with_pose.notes, *hides.notes]
    if len(chosen) < len(with_pose.paths):
        notes.append(
            f"{len(chosen)} of {len(with_pose.paths)} images are used, evenly spaced by their names (max_frames)"
        )
    notes += [f"not used, {line}" for line in given.left_out[:4]] + duplicate_notes(second)
    missing = len(with_pose.without_pose) * len(names) // len(with_pose.paths)
    return {"kept": len(names), "frames": len(paths), "notes": notes, "missing": missing}


class _Masks:
    def __init__(self, source: Path, folder: Path, masks: FilePath | MakeMask | None):
        self.source, self.folder, self.masks = source, folder, masks
        self.hidden: list[str] = []
        self.missing: list[str] = []

    def mask_of(self, image: Path, size: tuple[int, int]) -> NDArray[np.bool_] | None:
        if self.masks is None:
            return None
        mask = mask_as_stored(self.masks, image, size)
        if mask is None:
            self.missing.append(image.name)
        elif hides_all(mask):
            self.hidden.append(image.name)
        return mask

    def write(self, name: str, mask: NDArray[np.bool_], lens: Undistortion | None) -> None:
        self.folder.mkdir(exist_ok=True)
        if lens is not None:
            mask = lens.apply(np.where(mask, 255, 0).astype(np.uint8)) >= MASK_THRESHOLD
        write_mask(self.folder, name, mask)

    def check(self, count: int) -> None:
        if self.masks is not None:
            check_some_left(self.source, self.masks, self.hidden, self.missing, count)

    @property
    def notes(self) -> list[str]:
        return mask_notes(self.hidden, self.missing)


def _write(
    images: Path, path: Path, camera: CameraModel, lenses: dict[CameraModel, Undistortion]
) -> tuple[str, CameraModel]:
    """Write an image for COLMAP and return its camera, undistorted if COLMAP lacks the lens model."""
    header = read_header(path)
    if MODELS[camera.model].number is None:
        lens = lenses.setdefault(camera, Undistortion(camera))
        write_image(images / f"{path.stem}.png", lens.apply(read_stored(path)))
        return f"{path.stem}.png", CameraModel.from_intrinsic(lens.intrinsic)
    if header.bits == 8 and header.channels in (1, 3) and not is_photo(path) and read_orientation(path) == EXIF_UPRIGHT:
        write_bytes(images / path.name, path.read_bytes())
        return path.name, camera
    write_image(images / f"{path.stem}.png", read_stored(path))
    return f"{path.stem}.png", camera


def find_features(
    folder: Path, report: ReportProgress, *, frames: StageResult, max_features: int, seed: int
) -> dict[str, Any]:
    images, database = frames.folder / IMAGES, folder / DATABASE
    settings, masks = SfmSettings(max_features=max_features, seed=seed), masks_of(frames.folder)
    return features.find_features(images, database, settings, masks=masks, progress=report).to_dict()


def match(
    folder: Path, report: ReportProgress, *, frames: StageResult, features: StageResult, device: Device
) -> dict[str, Any]:
    model = read_colmap_model(frames.folder / CAMERAS)
    pair_matches, check = match_posed(features.folder / DATABASE, model, device=device, progress=report)
    write_matches(folder / MATCHES, pair_matches)
    return {"pair_count": len(pair_matches.pairs), "match_count": len(pair_matches.matches), "poses": check.to_dict()}


def triangulate(
    folder: Path, report: ReportProgress, *, frames: StageResult, features: StageResult, matches: StageResult, seed: int
) -> dict[str, Any]:
    model = read_colmap_model(frames.folder / CAMERAS)
    check = PoseCheck.from_json(matches.report["poses"])
    pair_matches = read_matches(matches.folder / MATCHES)
    where = features.folder / DATABASE, model, pair_matches, check, frames.folder / IMAGES
    complete, _ = points_of(*where, SfmSettings(seed=seed))
    assessed = assess_model(complete, len(model) + frames.report["missing"], fix_intrinsic=True, poses=check)
    write_colmap_model(folder / MODEL, complete)
    cameras = tuple(dict.fromkeys(complete.cameras))
    record = {"missing": [], "cameras": [described(camera) for camera in cameras]}
    return assessed.to_dict() | record | {"turned": only_rotated(assessed, cameras)}
