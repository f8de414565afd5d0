"""The pictures and masks of a folder to train from: found, straightened or copied, and named."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Sequence
from pathlib import Path, PurePosixPath
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera_models import CameraModel
from ...cameras.undistortion import Undistortion
from ...core.checks import check_list
from ...core.errors import FileError
from ...files.models.sfm_model import SfmModel
from ...files.pictures.image_files import write_png
from ...files.pictures.photo_files import is_photo
from .masks import KEPT, masks_in, read_mask
from .picture_folder import UPRIGHT, check_place, is_grey_16, read_header, read_orientation, read_stored
from .picture_writing import write_bytes

LEAST_UNSEEN = 0.001  # of a straightened picture: fewer blank pixels are no reason for masks
_SUFFIXES = {"jpeg": (".jpg", ".jpeg"), "png": (".png",)}

Pixels = NDArray[np.uint8]


def find_pictures(pictures: Any, model: SfmModel) -> list[Path | Pixels]:
    """The picture of each name of a model; of files the headers alone are read.

    Raises:
        TypeError, ValueError: No pictures, not as many as the model has, an array of another shape.
        FileError: One is missing, damaged, or of another size than its camera.
    """
    if isinstance(pictures, str | os.PathLike):
        folder = check_place("pictures", pictures)
        given: list[Any] = [folder / name for name in model.names]
    else:
        given = check_list("pictures", pictures, "paths or pictures")
    if len(given) != len(model):
        raise ValueError(f"pictures: expected one for each of the {len(model)} of the model, got {len(given)}")
    found: list[Path | Pixels] = []
    for k, (each, camera) in enumerate(zip(given, model.cameras, strict=True)):
        size = camera.width, camera.height
        if not isinstance(each, str | os.PathLike):
            found.append(_checked_array(f"pictures[{k}]", each, size))
            continue
        path = check_place(f"pictures[{k}]", each)
        if not path.is_file():
            raise FileError(path, "does not exist", remedy="Give the folder that the model's names are of")
        header = read_header(path)
        if (header.width, header.height) != size:
            reason = f"is {header.width} x {header.height}, its camera {size[0]} x {size[1]} pixels"
            raise FileError(path, reason, remedy="Give the pictures in the size that the cameras were found in")
        if is_grey_16(header):
            raise FileError(path, "expected a picture of 8 bits, got 16-bit grey", remedy="Convert it to 8 bits")
        found.append(path)
    return found


def _checked_array(name: str, value: Any, size: tuple[int, int]) -> Pixels:
    array = np.asarray(value)
    if array.dtype != np.uint8:
        raise TypeError(f"{name}: expected a path or uint8, got {array.dtype}")
    if array.shape not in ((size[1], size[0]), (size[1], size[0], 3)):
        raise ValueError(f"{name}: expected shape {[size[1], size[0], 3]}, as of its camera, got {list(array.shape)}")
    return array if array.ndim == 3 else np.repeat(array[..., None], 3, axis=2)


def find_masks(masks: Any, model: SfmModel) -> list[NDArray[np.bool_] | Path | None]:
    """The mask of each picture of a model, None where it has none.

    Raises:
        TypeError, ValueError: Not as many as pictures, an array of another kind or shape.
        FileError: No folder, or no mask in it.
    """
    if masks is None:
        return [None] * len(model)
    if isinstance(masks, str | os.PathLike):
        folder = check_place("masks", masks)
        places = masks_in(folder, model.names)
        if not any(places):
            reason = f"holds no mask of a picture, such as {model.names[0]}.png"
            raise FileError(folder, reason, remedy="Name masks as their pictures, with .png behind")
        return [*places]
    given = check_list("masks", masks, "masks")
    if len(given) != len(model):
        raise ValueError(f"masks: expected one, or None, for each of the {len(model)} pictures, got {len(given)}")
    found: list[NDArray[np.bool_] | Path | None] = []
    for k, (each, camera) in enumerate(zip(given, model.cameras, strict=True)):
        if each is None or isinstance(each, str | os.PathLike):
            found.append(None if each is None else check_place(f"masks[{k}]", each))
            continue
        array = np.asarray(each)
        if array.dtype not in (np.bool_, np.uint8):
            raise TypeError(f"masks[{k}]: expected a path, or an array of bool or uint8, got {array.dtype}")
        if array.shape != (camera.height, camera.width):
            raise ValueError(f"masks[{k}]: expected shape {[camera.height, camera.width]}, got {list(array.shape)}")
        found.append(array if array.dtype == np.bool_ else array >= KEPT)
    return found


def is_straight(camera: CameraModel, lens: Undistortion) -> bool:
    """Whether a picture of this camera is one of the straight one too."""
    return camera.is_pinhole and (camera.width, camera.height) == (lens.intrinsic.width, lens.intrinsic.height)


def is_copied(picture: Path | Pixels, camera: CameraModel, lens: Undistortion) -> bool:
    """Whether a picture is what trainers read as it is: upright, of 8 bits, straight, of a kind that all know."""
    if not isinstance(picture, Path) or not is_straight(camera, lens) or is_photo(picture):
        return False
    header = read_header(picture)
    known = picture.suffix.lower() in _SUFFIXES.get(header.kind, ())
    return known and header.bits == 8 and header.channels in (1, 3) and read_orientation(picture) == UPRIGHT


def new_names(names: Sequence[str], copied: Sequence[bool]) -> list[str]:
    """A name for each picture: without folders where that tells them apart, and .png unless it is a copy."""
    plain = [PurePosixPath(name.replace(os.sep, "/")) for name in names]
    bare = [path.name if kept else f"{path.stem}.png" for path, kept in zip(plain, copied, strict=True)]
    if max(Counter(name.casefold() for name in bare).values()) > 1:
        bare = ["_".join(path.parts) + ("" if kept else ".png") for path, kept in zip(plain, copied, strict=True)]
    if max(Counter(name.casefold() for name in bare).values()) > 1:
        digits = len(str(len(names)))
        bare = [f"{k:0{digits}d}_{name}" for k, name in enumerate(bare)]
    return bare


def write_straight(path: Path, picture: Path | Pixels, lens: Undistortion, *, copied: bool) -> None:
    """Write a picture as the straight camera shows it.

    Raises:
        FileError: Damaged, or changed since it was looked at.
    """
    if copied:
        assert isinstance(picture, Path)
        read_stored(picture)  # a damaged one is told here, and not by the trainer
        write_bytes(path, picture.read_bytes())
        return
    write_png(path, lens.apply(read_stored(picture) if isinstance(picture, Path) else picture))


def straight_mask(
    mask: NDArray[np.bool_] | Path | None, lens: Undistortion, unseen: NDArray[np.bool_] | None
) -> NDArray[np.bool_]:
    """What of a straightened picture counts: what its mask keeps, and the lens has seen."""
    if isinstance(mask, Path):
        mask = read_mask(mask, (lens.camera.width, lens.camera.height))
    if mask is None:
        kept = np.ones((lens.intrinsic.height, lens.intrinsic.width), bool)
    elif is_straight(lens.camera, lens):
        kept = mask
    else:
        kept = lens.apply(np.where(mask, 255, 0).astype(np.uint8)) >= KEPT
    return kept if unseen is None else kept & ~unseen


def unseen_of(lens: Undistortion) -> NDArray[np.bool_] | None:
    """What a lens does not see of its straightened picture; None where that is next to nothing."""
    if is_straight(lens.camera, lens):
        return None
    unseen = ~lens.seen
    return unseen if unseen.mean() > LEAST_UNSEEN else None
