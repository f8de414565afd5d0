"""Models of structure from motion as COLMAP writes them: three files in a folder, binary or text.

Read are COLMAP's own files since version 3, and those of programs that write its form. What version 4 writes beside
(rigs, frames) is passed over: the pose of each picture stands in images.* all the same.
"""

from __future__ import annotations

import os
from pathlib import Path
from types import ModuleType

from ...cameras.camera_models import MODELS
from ...core.atomic import atomic_files, atomic_write, finish_files
from ...core.checks import check_name
from ...core.errors import FileError
from ...core.paths import path_of
from . import colmap_binary, colmap_text
from .colmap_records import assemble, records_of
from .sfm_model import SfmModel

FORMS: dict[str, ModuleType] = {"bin": colmap_binary, "txt": colmap_text}
FILES = ("cameras", "images", "points3D")
BESIDE = ("rigs", "frames")  # of COLMAP 4: true of the model that they were written with alone
_KNOWN = tuple(f"{name}.{form}" for name in ("cameras", "points3D", *BESIDE, "images") for form in FORMS)
PLACES = ("sparse/0", "sparse", "0", "dense/sparse")  # where a project keeps its model


def read_colmap_model(folder: str | os.PathLike[str]) -> SfmModel:
    """Read a model of COLMAP.

    Args:
        folder: With cameras, images and points3D, all .bin (taken where there are both) or all .txt; or the folder
            above, where `sparse/0`, `sparse` or `0` holds them.

    Returns:
        The registered pictures and the points. Keypoints without a point are left out; pixel centres, at halves in
        the files, are whole numbers.

    Raises:
        FileError: Missing, cut off, numbers that make no sense, an unknown camera model, files that contradict one
            another, no picture, or several models of which one must be chosen; says where.

    Notes:
        A million points seen ten million times take some seconds and 2.5 GB of memory from binary files.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
        >>> model = loom.SfmModel(["a.png"], [camera], np.eye(4)[None], points=[[0, 0, 2.0]])
        >>> loom.write_colmap_model("sparse", model)
        >>> loom.read_colmap_model("sparse")
        SfmModel(1 picture, 1 camera, 1 points, 0 observations)
    """
    place, form = find_colmap_model(folder)
    paths = {name: place / f"{name}.{form}" for name in FILES}
    read = FORMS[form]
    cameras = read.read_cameras(paths["cameras"])
    pictures = read.read_pictures(paths["images"])
    return assemble(paths, cameras, pictures, read.read_points(paths["points3D"]))


def find_colmap_model(folder: str | os.PathLike[str]) -> tuple[Path, str]:
    """The folder that holds the files of a model, and "bin" or "txt".

    Raises:
        FileError: None, a part of one, or several.
    """
    folder = path_of(folder, "folder")
    if not folder.is_dir():
        reason = "is a file" if folder.exists() else "does not exist"
        raise FileError(folder, reason, remedy="Give the folder of cameras, images and points3D")
    if _files_of(folder):
        return folder, _form_of(folder)
    models = sorted(p for place in (folder, folder / "sparse") for p in _numbered(place) if _files_of(p))
    if len(models) > 1:
        shown = ", ".join(f"{p.relative_to(folder)} ({_size_of(p)})" for p in models[:8])
        raise FileError(folder, f"holds {len(models)} models: {shown}", remedy="Give the folder of one of them")
    for place in [*models, *(folder / name for name in PLACES)]:
        if _files_of(place):
            return place, _form_of(place)
    raise FileError(folder, "holds no model of COLMAP", remedy="Give the folder of cameras, images and points3D")


def is_colmap_model(folder: str | os.PathLike[str]) -> bool:
    """Whether a folder, or one of those below where projects keep it, has a file of a model."""
    folder = path_of(folder, "folder")
    below = [p for place in (folder, folder / "sparse") for p in _numbered(place)]
    return any(_files_of(place) for place in [folder, *below, *(folder / name for name in PLACES)])


def _numbered(folder: Path) -> list[Path]:
    """Its folders 0, 1, 2, ..., as mapping writes one for each part that it could not join."""
    if not folder.is_dir():
        return []
    return [p for p in folder.iterdir() if p.name.isascii() and p.name.isdigit() and p.is_dir()]


def _files_of(folder: Path) -> list[str]:
    finish_files(folder, _KNOWN)
    return [f"{name}.{form}" for form in FORMS for name in FILES if (folder / f"{name}.{form}").is_file()]


def _form_of(folder: Path) -> str:
    found = _files_of(folder)
    for form in FORMS:
        if all(f"{name}.{form}" in found for name in FILES):
            return form
    form = max(FORMS, key=lambda form: sum(name.endswith(form) for name in found))
    missing = [f"{name}.{form}" for name in FILES if f"{name}.{form}" not in found]
    remedy = "The model may be half written; a model without points has an empty points3D.txt"
    raise FileError(folder, f"holds {', '.join(found)}, but not {' and '.join(missing)}", remedy=remedy)


def _size_of(folder: Path) -> str:
    try:
        form = _form_of(folder)
        return f"{FORMS[form].count_pictures(folder / f'images.{form}')} pictures"
    except FileError:
        return "damaged"


def write_colmap_model(
    folder: str | os.PathLike[str], model: SfmModel, *, format: str = "bin", overwrite: bool = True
) -> None:
    """Write a model as COLMAP reads it, version 3 and 4.

    Args:
        folder: Where the files go; made if it is not there.
        model: At least one picture.
        format: "bin" or "txt".
        overwrite: Replace a model that is there already, in either form and with its rigs and frames.

    Raises:
        TypeError: No SfmModel.
        ValueError: No picture, an unknown format, a camera model that COLMAP does not have, or a name that the format
            cannot hold.
        FileError: The place cannot be written, or holds a model that may not be replaced.

    Notes:
        Atomic: all files are written to a hidden folder first and then take their places. If the process is killed
        meanwhile, the next read or write of the folder finishes that. Pictures, cameras and points are numbered from 1
        in their order here. All digits are kept; rotations, quaternions there, come back within 1e-15.

    Example:
        >>> import pathlib, numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
        >>> model = loom.SfmModel(["a.png"], [camera], np.eye(4)[None])
        >>> loom.write_colmap_model("sparse", model, format="txt")
        >>> sorted(path.name for path in pathlib.Path("sparse").iterdir())
        ['cameras.txt', 'images.txt', 'points3D.txt']
    """
    folder = path_of(folder, "folder")
    if not isinstance(model, SfmModel):
        raise TypeError(f"model: expected an SfmModel, got {type(model).__name__}")
    if check_name("format", format) not in FORMS:
        raise ValueError(f"format: expected 'bin' or 'txt', got {format!r}")
    _check_writable(model, format)
    is_new = _prepare(folder, overwrite)
    write, records = FORMS[format], records_of(model)
    writers = {"cameras": write.write_cameras, "images": write.write_pictures, "points3D": write.write_points}
    try:
        with atomic_files(folder, _KNOWN) as part:
            for name, write_file in writers.items():
                with atomic_write(part / f"{name}.{format}") as file:
                    write_file(file, records)
    except FileError as error:
        raise FileError(folder, error.reason, remedy=error.remedy) from error
    except OSError as error:
        raise FileError(folder, f"cannot be written: {error.strerror or error}") from error
    finally:
        if is_new and not any(folder.iterdir()):
            folder.rmdir()


def _check_writable(model: SfmModel, format: str) -> None:
    if not len(model):
        raise ValueError("model: expected at least one picture, got none")
    for camera in set(model.cameras):
        if MODELS[camera.model].number is None:
            reason = f"model: COLMAP has no camera model {camera.model}"
            raise ValueError(f"{reason}; straighten the pictures first, see loom.undistort_picture")
    for name in model.names:
        if "\0" in name or len(name.encode(errors="replace")) > colmap_binary.LONGEST_NAME:
            raise ValueError(f"model: COLMAP's files cannot hold the picture's name {name[:80]!r}")
        if format == "txt" and name.split() != [name]:  # COLMAP itself writes such a name, and reads its first word
            raise ValueError(f"model: text cannot hold the picture's name {name[:80]!r}; write format='bin'")


def _prepare(folder: Path, overwrite: bool) -> bool:
    """Make the folder where it is missing; whether it was."""
    if folder.is_dir():
        found = _files_of(folder)
        if found and not overwrite:
            raise FileError(folder, f"holds {found[0]} already", remedy="Give another folder, or overwrite=True")
        return False
    try:
        folder.mkdir(parents=True)
    except OSError as error:
        raise FileError(folder, f"cannot be made: {error.strerror or error}") from error
    return True
