"""Association of images with given cameras by name."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ...core.errors import DatasetError, FileError, FilePath
from ...core.wording import few_of
from ...io.models.sfm_model import SfmModel
from .picture_folder import OTHER_SUFFIXES, PHOTO_SUFFIXES, read_header

FEWEST = 2


@dataclasses.dataclass(frozen=True)
class PosedPictures:
    """Images with cameras (`model`, `paths` in its order), and the names without a partner."""

    model: SfmModel
    paths: tuple[Path, ...]
    picture_count: int
    without_pose: tuple[str, ...]
    without_picture: tuple[str, ...]

    @property
    def notes(self) -> tuple[str, ...]:
        said = []
        for names, what in (
            (self.without_pose, "pictures have no pose"),
            (self.without_picture, "poses have no picture"),
        ):
            if names:
                said.append(f"{len(names)} {what}: {few_of(names, 4)}")
        return tuple(said)


def with_poses(folder: FilePath, paths: Sequence[Path], cameras: SfmModel) -> PosedPictures:
    """Match cameras to images by name, with or without folders and extension; ambiguous names never match."""
    chosen: dict[int, Path] = {}
    missing = []
    by_name, by_stem = _places(paths, "name"), _places(paths, "stem")
    for i, name in enumerate(cameras.names):
        found = by_name.get(Path(name).name) or by_stem.get(_stem(name)) or by_stem.get(Path(name).name) or []
        if len(found) > 1 or (found and found[0] in chosen.values()):
            several = ", ".join(path.name for path in found)
            remedy = "Name each picture and camera differently, and leave one of them"
            raise FileError(folder, f"camera {name!r} may be of {several}, or of one that another is of", remedy=remedy)
        if found:
            chosen[i] = found[0]
        else:
            missing.append(name)
    if len(chosen) < FEWEST:
        reason = (
            f"{len(chosen)} of its {len(paths)} pictures ({paths[0].name}, ...) are named as cameras are "
            f"({cameras.names[0] if len(cameras) else 'none'}, ...)"
        )
        raise DatasetError(folder, reason, remedy="Name the pictures as the cameras are, or give the cameras of these")
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
            reason = f"is {header.width} x {header.height}, its camera {camera.width} x {camera.height} pixels"
            raise FileError(path, reason, remedy="Give the pictures in the size that the cameras were found in")
    left = tuple(path.name for path in paths if path.name not in taken)
    return PosedPictures(model, in_order, len(paths), left, tuple(missing))


def _stem(name: str) -> str:
    path = Path(name)
    return path.stem if path.suffix.lower() in (*PHOTO_SUFFIXES, *OTHER_SUFFIXES) else path.name


def _places(paths: Sequence[Path], part: str) -> dict[str, list[Path]]:
    found: dict[str, list[Path]] = {}
    for path in paths:
        found.setdefault(getattr(path, part), []).append(path)
    return found
