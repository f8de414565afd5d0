"""Pipeline stages from images to an SfM model: frames, features, matches, model."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ...cameras.camera import PinholeCameraIntrinsic
from ...cameras.camera_models import CameraModel
from ...core.errors import FileError, FilePath
from ...core.progress import ReportProgress
from ...core.records import digest_of, digest_of_file
from ...core.stages import StageResult
from ...io.images.image_files import read_image_header
from ...io.models.colmap import read_colmap_model, write_colmap_model
from ...io.models.sfm_model import SfmModel
from ..sfm import features as features_module
from ..sfm import mapping
from ..sfm import matches as matches_module
from ..sfm.frames import choose_frames
from ..sfm.image_folder import check_path
from ..sfm.image_writing import counted, some_of
from ..sfm.masks import FOLDER, MakeMask, mask_folder
from ..sfm.model_quality import MIN_ANGLE, MIN_PARALLAX, ModelQuality
from ..sfm.settings import SfmSettings
from ..sfm.sphere_images import cut_spheres, with_all_faces

IMAGES, DATABASE, MODEL = "images", "database.db", "sparse"
MASKS, SPHERES = IMAGES + FOLDER, "spheres"

MIN_IMAGES = 2  # minimum images of a model


def digest_of_source(source: FilePath) -> str:
    path = check_path("source", source)
    try:
        if not path.is_dir():
            return digest_of_file(path)
        files = sorted(file for file in path.iterdir() if file.is_file() and not file.name.startswith("."))
        return digest_of([[file.name, digest_of_file(file)] for file in files])
    except OSError as error:
        reason = "does not exist" if not path.exists() else f"cannot be read: {error.strerror or error}"
        raise FileError(path, reason, remedy="Give a video, or a folder of images") from error


def read_model(model: StageResult) -> SfmModel:
    return read_colmap_model(model.folder / MODEL)


def image_names(frames: StageResult) -> list[str]:
    return sorted(path.name for path in (frames.folder / IMAGES).iterdir())


def take_frames(
    folder: Path,
    report: ReportProgress,
    *,
    source: FilePath,
    max_frames: int,
    masks: FilePath | MakeMask | None,
    panorama: bool,
) -> dict[str, Any]:
    target = folder / (SPHERES if panorama else IMAGES)
    choice = choose_frames(source, target, max_frames=max_frames, masks=masks, progress=report)
    record = choice.to_dict()
    if panorama:
        hidden = None if masks is None else (mask_folder(target), folder / MASKS)
        faces = cut_spheres(target, choice.names, folder / IMAGES, hidden, report)
        for each in (target, mask_folder(target)):
            shutil.rmtree(each, ignore_errors=True)
        return record | {"kept": len(faces), "frames": choice.frame_count, "names": faces}
    if len(choice.names) < MIN_IMAGES:
        reason = f"expected several usable images from different positions, got {len(choice.names)}"
        raise FileError(source, reason, remedy="Move while you film, or take more images")
    return {"kept": len(choice.names), "frames": choice.frame_count} | record


def masks_of(frames: Path) -> Path | None:
    masks = frames / MASKS
    return masks if masks.is_dir() else None


def find_features(
    folder: Path,
    report: ReportProgress,
    *,
    frames: StageResult,
    intrinsic: PinholeCameraIntrinsic | None,
    camera_model: str,
    max_features: int,
    panorama: bool,
    seed: int,
) -> dict[str, Any]:
    images = frames.folder / IMAGES
    if panorama:  # cube faces have any size
        side = read_image_header(images / image_names(frames)[0]).width
        intrinsic = PinholeCameraIntrinsic(side, side, side / 2, side / 2, (side - 1) / 2, (side - 1) / 2)
    settings = SfmSettings(camera_model=camera_model, intrinsic=intrinsic, max_features=max_features, seed=seed)
    where = images, folder / DATABASE, settings
    return features_module.find_features(*where, masks=masks_of(frames.folder), progress=report).to_dict()


def match(
    folder: Path, report: ReportProgress, *, frames: StageResult, features: StageResult, pairs: str, seed: int
) -> dict[str, Any]:
    where = features.folder / DATABASE, folder / DATABASE, SfmSettings(pairs=pairs, seed=seed)
    return matches_module.match_features(*where, progress=report).to_dict()


def map_images(
    folder: Path,
    report: ReportProgress,
    *,
    frames: StageResult,
    matches: StageResult,
    fixed_camera: bool,
    mapper: str,
    panorama: bool,
    seed: int,
) -> dict[str, Any]:
    where = frames.folder / IMAGES, matches.folder / DATABASE, folder / MODEL
    settings = SfmSettings(fix_intrinsic=fixed_camera, mapper=mapper, seed=seed)
    result = mapping.map_images(*where, settings, progress=report)
    cameras = () if result.model is None else tuple(dict.fromkeys(result.model.cameras))
    missing, notes = list(result.missing), []
    if panorama and result.model is not None:
        complete, added = with_all_faces(result.model, image_names(frames))
        if added:
            write_colmap_model(folder / MODEL, complete)
            missing = [name for name in missing if name not in set(added)]
            notes.append(f"{counted(len(added), 'face')} registered by other faces of the same image: {some_of(added)}")
    record = {"missing": missing, "cameras": [described(camera) for camera in cameras], "notes": notes}
    return result.quality.to_dict() | record | {"turned": only_rotated(result.quality, cameras)}


def only_rotated(quality: ModelQuality, cameras: Sequence[CameraModel]) -> bool:
    longer = max((max(camera.width, camera.height) for camera in cameras), default=1)
    return not (quality.angle >= MIN_ANGLE and quality.parallax >= MIN_PARALLAX * longer)


def described(camera: CameraModel) -> str:
    params = " ".join(f"{value:.5g}" for value in camera.params)
    return f"{camera.model} {camera.width} x {camera.height}: {params}"
