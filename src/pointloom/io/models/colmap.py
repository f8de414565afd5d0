"""Read and write COLMAP models (binary or text) since version 3. Rigs and frames of version 4 are read only."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

from ...cameras.camera_models import MODELS
from ...core.atomic import atomic_files, atomic_write, finish_files
from ...core.checks import check_name
from ...core.errors import FileError, FilePath
from ...core.paths import path_of
from . import colmap_binary, colmap_text
from .colmap_records import assemble, records_of
from .colmap_rigs import read_frame_poses
from .sfm_model import SfmModel

FORMS: dict[str, ModuleType] = {"bin": colmap_binary, "txt": colmap_text}
FILES = ("cameras", "images", "points3D")
BESIDE = ("rigs", "frames")  # files of COLMAP 4 that are valid only with the model they were written with
_KNOWN = tuple(f"{name}.{form}" for name in ("cameras", "points3D", *BESIDE, "images") for form in FORMS)
MODEL_FOLDERS = ("sparse/0", "sparse", "0", "dense/sparse")  # usual model folders of a project


def read_colmap_model(folder: FilePath) -> SfmModel:
    """Read a COLMAP model.

    Args:
        folder: Folder with cameras, images and points3D, all .bin (preferred) or all .txt; or its parent with
            `sparse/0`, `sparse` or `0`.

    Returns:
        The registered images and the points, without keypoints that have no point. Pixel centers are integers (.5 in
        the files). If there are rigs and frames (COLMAP 4), the pose of an image is that of its frame and of its camera
        in the rig, as in COLMAP. The copies of the poses in the images file are ignored then: they may be outdated.

    Raises:
        FileError: Missing or truncated files, invalid or contradictory values, an unknown camera model, no image, or
            several models. Rigs without frames or the reverse, an image in no frame, or its camera without a pose.

    Notes:
        A million points with ten million observations need a few seconds and 2.5 GB from binary files.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> camera = loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240])
        >>> model = loom.SfmModel(["a.png"], [camera], np.eye(4)[None], points=[[0, 0, 2.0]])
        >>> loom.write_colmap_model("sparse", model)
        >>> loom.read_cameras("sparse")
        SfmModel(1 image, 1 camera, 1 points, 0 observations)
    """
    root, form = find_colmap_model(folder)
    paths = {name: root / f"{name}.{form}" for name in FILES}
    read = FORMS[form]
    cameras = read.read_cameras(paths["cameras"])
    images = read.read_images(paths["images"])
    poses = read_frame_poses({name: root / f"{name}.{form}" for name in BESIDE}, images, read)
    return assemble(paths, cameras, images, read.read_points(paths["points3D"]), poses)


def find_colmap_model(folder: FilePath) -> tuple[Path, str]:
    """The folder of the model files, and "bin" or "txt". Raises `FileError` if there is none, a part or several."""
    folder = path_of(folder, "folder")
    if not folder.is_dir():
        reason = "is a file" if folder.exists() else "does not exist"
        raise FileError(folder, reason, remedy="Give the folder of cameras, images and points3D")
    if _files_of(folder):
        return folder, _form_of(folder)
    models = sorted(p for candidate in (folder, folder / "sparse") for p in _numbered(candidate) if _files_of(p))
    if len(models) > 1:
        shown = ", ".join(f"{p.relative_to(folder)} ({_size_of(p)})" for p in models[:8])
        raise FileError(folder, f"contains {len(models)} models: {shown}", remedy="Give the folder of one of them")
    for candidate in [*models, *(folder / name for name in MODEL_FOLDERS)]:
        if _files_of(candidate):
            return candidate, _form_of(candidate)
    raise FileError(folder, "contains no COLMAP model", remedy="Give the folder of cameras, images and points3D")


def is_colmap_model(folder: FilePath) -> bool:
    folder = path_of(folder, "folder")
    below = [p for candidate in (folder, folder / "sparse") for p in _numbered(candidate)]
    return any(_files_of(candidate) for candidate in [folder, *below, *(folder / name for name in MODEL_FOLDERS)])


def _numbered(folder: Path) -> list[Path]:
    if not folder.is_dir():
        return []
    return [p for p in folder.iterdir() if p.name.isascii() and p.name.isdigit() and p.is_dir()]


def _files_of(folder: Path) -> list[str]:
    finish_files(folder, _KNOWN)
    return [f"{name}.{form}" for form in FORMS for name in FILES if (folder / f"{name}.{form}").is_file()]


def _form_of(folder: Path) -> str:
    names = _files_of(folder)
    for form in FORMS:
        if all(f"{name}.{form}" in names for name in FILES):
            return form
    form = max(FORMS, key=lambda form: sum(name.endswith(form) for name in names))
    missing = [f"{name}.{form}" for name in FILES if f"{name}.{form}" not in names]
    remedy = "The model may be incomplete; a model without points has an empty points3D.txt"
    raise FileError(folder, f"contains {', '.join(names)}, but not {' and '.join(missing)}", remedy=remedy)


def _size_of(folder: Path) -> str:
    try:
        form = _form_of(folder)
        return f"{FORMS[form].count_images(folder / f'images.{form}')} images"
    except FileError:
        return "damaged"


def write_colmap_model(folder: FilePath, model: SfmModel, *, format: str = "bin", overwrite: bool = True) -> None:
    """Write a model for COLMAP 3 and 4.

    Args:
        folder: The folder, created if missing.
        model: At least one image.
        format: "bin" or "txt".
        overwrite: Replace an existing model in either form, with its rigs and frames.

    Raises:
        TypeError: No SfmModel.
        ValueError: No image, an unknown format, a camera model that COLMAP does not support, or an invalid name.
        FileError: The folder cannot be written, or contains a model that may not be replaced.

    Notes:
        Atomic: files are written to a hidden folder first and then moved. After a crash the next read or write
        completes the move. Ids start at 1. All digits are kept. Rotations, stored as quaternions, are accurate to
        1e-15.

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
    writers = {"cameras": write.write_cameras, "images": write.write_images, "points3D": write.write_points}
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
        raise ValueError("model: expected at least one image, got none")
    for camera in set(model.cameras):
        if MODELS[camera.model].number is None:
            reason = f"model: COLMAP has no camera model {camera.model}"
            raise ValueError(f"{reason}; undistort the images first, see loom.undistort_image")
    for name in model.names:
        if "\0" in name or len(name.encode(errors="replace")) > colmap_binary.LONGEST_NAME:
            raise ValueError(f"model: COLMAP's files cannot store the image name {name[:80]!r}")
        if format == "txt" and name.split() != [name]:  # COLMAP writes such a name, but reads only its first word
            raise ValueError(f"model: text cannot store the image name {name[:80]!r}; write format='bin'")


def _prepare(folder: Path, overwrite: bool) -> bool:
    """Create the folder if missing. Returns True if it was."""
    if folder.is_dir():
        existing = _files_of(folder)
        if existing and not overwrite:
            raise FileError(folder, f"already contains {existing[0]}", remedy="Give another folder, or overwrite=True")
        return False
    try:
        folder.mkdir(parents=True)
    except OSError as error:
        raise FileError(folder, f"cannot be created: {error.strerror or error}") from error
    return True
