"""Association of images with given cameras by name."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ...core.errors import DatasetError, FileError, FilePath
from ...core.wording import few_of
from ...io.models.sfm_model import SfmModel
from .image_folder import OTHER_SUFFIXES, PHOTO_SUFFIXES, read_header

MIN_IMAGES = 2


@dataclasses.dataclass(frozen=True)
class PosedImages:
    """Images with cameras (`model`, `paths` in its order), and the names without a partner."""

    model: SfmModel
    paths: tuple[Path, ...]
    image_count: int
    without_pose: tuple[str, ...]
    without_image: tuple[str, ...]

    @property
    def notes(self) -> tuple[str, ...]:
        lines = []
        for names, what in ((self.without_pose, "images have no pose"), (self.without_image, "poses have no image")):
            if names:
                lines.append(f"{len(names)} {what}: {few_of(names, 4)}")
        return tuple(lines)


def with_poses(folder: FilePath, paths: Sequence[Path], cameras: SfmModel) -> PosedImages:
    """Match cameras to images by name, with or without folders and extension. Ambiguous names never match."""
    chosen: dict[int, Path] = {}
    missing = []
    by_name, by_stem = _paths_by(paths, "name"), _paths_by(paths, "stem")
    for i, name in enumerate(cameras.names):
        candidates = by_name.get(Path(name).name) or by_stem.get(_stem(name)) or by_stem.get(Path(name).name) or []
        if len(candidates) > 1 or (candidates and candidates[0] in chosen.values()):
            several = ", ".join(path.name for path in candidates)
            remedy = "Give each image and each camera a unique name, and remove duplicates"
            raise FileError(folder, f"camera {name!r} matches {several}, or an image of another camera", remedy=remedy)
        if candidates:
            chosen[i] = candidates[0]
        else:
            missing.append(name)
    if len(chosen) < MIN_IMAGES:
        reason = (
            f"{len(chosen)} of its {len(paths)} images ({paths[0].name}, ...) have the name of a camera "
            f"({cameras.names[0] if len(cameras) else 'none'}, ...)"
        )
        raise DatasetError(
            folder, reason, remedy="Name the images like the cameras, or give the cameras of these images"
        )
    rows = np.array(sorted(chosen))
    model = SfmModel(
        tuple(chosen[i].name for i in rows),
        tuple(cameras.cameras[i] for i in rows),
        cameras.T_camera_world[rows],
        left_out=cameras.left_out,
    )
    taken = {path.name: path for path in chosen.values()}
    in_order = tuple(taken[name] for name in model.names)
    for path, camera in zip(in_order, model.cameras, strict=True):
        header = read_header(path)
        if (header.width, header.height) != (camera.width, camera.height):
            reason = (
                f"expected {camera.width} x {camera.height} pixels as of its camera, got {header.width} x "
                f"{header.height}"
            )
            raise FileError(path, reason, remedy="Give the images in the size for which the cameras were estimated")
    left = tuple(path.name for path in paths if path.name not in taken)
    return PosedImages(model, in_order, len(paths), left, tuple(missing))


def _stem(name: str) -> str:
    path = Path(name)
    return path.stem if path.suffix.lower() in (*PHOTO_SUFFIXES, *OTHER_SUFFIXES) else path.name


def _paths_by(paths: Sequence[Path], part: str) -> dict[str, list[Path]]:
    groups: dict[str, list[Path]] = {}
    for path in paths:
        groups.setdefault(getattr(path, part), []).append(path)
    return groups
