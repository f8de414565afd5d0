"""Image masks for COLMAP: gray PNG files of the image size, black where excluded. IMG_1.jpg.png for IMG_1.jpg."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from ...core.errors import DatasetError, FileError, FilePath
from ...core.masked_arrays import unmasked
from ...io.pictures.image_files import decode_texture, read_color, read_picture_header, write_png
from ...io.pictures.photo_files import is_photo, read_alpha
from .frame_choice import FrameChoice
from .picture_folder import UPRIGHT, list_photographs, read_orientation, read_stored, upright
from .picture_writing import counted, some_of

ALPHA = "alpha"
FOLDER = "_masks"  # appended to the image folder's name

MakeMask = Callable[[NDArray[np.uint8], str], Any]
KEPT = 128  # brightness threshold of masks
_LEAST = 0.001  # minimum unmasked fraction of an image
_ENDINGS = (".png", ".jpg", ".jpeg")
_BACK = {6: 8, 8: 6}  # inverse EXIF orientations. The others are self-inverse


def check_masks(masks: Any) -> FilePath | MakeMask | None:
    if masks is None or callable(masks):
        return masks
    if not isinstance(masks, str | os.PathLike):
        raise TypeError(f'masks: expected a folder, "alpha" or a function, got {type(masks).__name__}')
    if masks != ALPHA and not Path(masks).is_dir():
        raise DatasetError(masks, "is no folder", remedy="Give the folder of the masks, IMG_1.jpg.png of IMG_1.jpg")
    return masks


def mask_folder(pictures: Path) -> Path:
    return pictures.with_name(pictures.name + FOLDER)


def mask_file(folder: Path, name: str) -> Path:
    return folder / f"{name}.png"


def masks_in(folder: Path, names: Iterable[str]) -> list[Path | None]:
    places = (mask_file(folder, name) for name in names)
    return [place if place.is_file() else None for place in places]


def write_mask(folder: Path, name: str, kept: NDArray[np.bool_]) -> None:
    write_png(mask_file(folder, name), np.where(kept, 255, 0).astype(np.uint8))


def read_mask(path: FilePath, size: tuple[int, int]) -> NDArray[np.bool_]:
    header = read_picture_header(path)
    if (header.width, header.height) != size:
        reason = f"is {header.width} x {header.height}, its picture {size[0]} x {size[1]} pixels"
        raise FileError(path, reason, remedy="Make masks of the size of their pictures")
    return read_color(path).max(axis=2) >= KEPT


def write_masks(choice: FrameChoice, source: Path, pictures: Path, masks: FilePath | MakeMask) -> FrameChoice:
    """Write the masks of the selected images, and remove images that are completely masked."""
    folder = mask_folder(pictures)
    places = list_photographs(source)[0] if source.is_dir() else []
    kept, hidden, missing = [], {}, []
    for k, (name, number) in enumerate(zip(choice.names, choice.numbers, strict=True)):
        origin = places[number] if places else None
        header = read_picture_header(pictures / name)
        mask = _mask_of(masks, pictures / name, origin, (header.width, header.height))
        if mask is None:
            missing.append(name)
        elif hides_all(mask):
            hidden[name if origin is None else origin.name] = "its mask hides all of it"
            (pictures / name).unlink()
            continue
        else:
            write_mask(folder, name, mask)
        kept.append(k)
    return _without_hidden(choice, source, masks, kept, hidden, missing)


def _without_hidden(
    choice: FrameChoice, source: Path, masks: Any, kept: list[int], hidden: dict[str, str], missing: list[str]
) -> FrameChoice:
    check_some_left(source, masks, list(hidden), missing, len(kept))
    return dataclasses.replace(
        choice,
        names=tuple(choice.names[k] for k in kept),
        numbers=tuple(choice.numbers[k] for k in kept),
        left_out=choice.left_out | hidden,
        notes=(*choice.notes, *told_of_masks(list(hidden), missing)),
    )


def _check_found(source: Path, masks: Any, missing: list[str], count: int) -> None:
    if len(missing) == count:
        where = "their masks would be" if masks == ALPHA or callable(masks) else f"there is no mask in {masks}"
        reason = "no picture has a channel of transparency" if masks == ALPHA else f"{where}, as {missing[0]}.png"
        reason = "the function gave no mask of any picture" if callable(masks) else reason
        raise DatasetError(source, reason, remedy="Name masks as their pictures: IMG_1.jpg.png, or IMG_1.png")


def told_of_masks(hidden: list[str], missing: list[str]) -> list[str]:
    notes = []
    if hidden:
        notes.append(f"{counted(len(hidden), 'picture')} left out, whose masks hide all: {some_of(hidden)}")
    if missing:
        notes.append(f"{counted(len(missing), 'picture')} without a mask, taken whole: {some_of(missing)}")
    return notes


def hides_all(mask: NDArray[np.bool_]) -> bool:
    return bool(mask.mean() < _LEAST)


def check_some_left(source: Path, masks: Any, hidden: list[str], missing: list[str], kept: int) -> None:
    if not kept:
        raise FileError(source, f"none of {counted(len(hidden), 'picture')} is left: masks hide all of them")
    _check_found(source, masks, missing, kept)


def _mask_of(masks: Any, picture: Path, origin: Path | None, size: tuple[int, int]) -> NDArray[np.bool_] | None:
    """The mask of an image as it was written. None if missing."""
    if callable(masks):
        return _of_function(masks, read_color(picture), picture.name if origin is None else origin.name, size)
    if masks == ALPHA:
        alpha = None if origin is None else _alpha_of(origin)
        return None if origin is None or alpha is None else _fitted(origin, alpha >= KEPT, origin, size)
    place = _place_of(masks, (*(() if origin is None else (origin.name, origin.stem)), picture.name, picture.stem))
    return None if place is None else _fitted(place, read_color(place).max(axis=2) >= KEPT, origin, size)


def mask_as_stored(masks: FilePath | MakeMask, picture: Path, size: tuple[int, int]) -> NDArray[np.bool_] | None:
    """The mask of a photograph in stored orientation. None if missing. A mask function gets the image as stored."""
    if callable(masks):
        return _of_function(masks, read_stored(picture), picture.name, size)
    if masks == ALPHA:
        alpha = _alpha_of(picture)
        return None if alpha is None else _fitted(picture, alpha >= KEPT, None, size)
    place = _place_of(masks, (picture.name, picture.stem))
    if place is None:
        return None
    mask = read_color(place).max(axis=2) >= KEPT
    if (mask.shape[1], mask.shape[0]) != size:  # drawn on the upright image
        mask = upright(mask, _BACK.get(turn := read_orientation(picture), turn))
    return _fitted(place, mask, None, size)


def _place_of(masks: FilePath, names: Sequence[str]) -> Path | None:
    places = (Path(masks) / f"{name}{ending}" for name in dict.fromkeys(names) for ending in _ENDINGS)
    return next((place for place in places if place.is_file()), None)


def _of_function(
    make: MakeMask, pixels: NDArray[np.uint8], name: str, size: tuple[int, int]
) -> NDArray[np.bool_] | None:
    try:
        given = make(pixels, name)
    except Exception as error:
        raise ValueError(f"masks({name}): the function raised {type(error).__name__}: {error}") from error
    if given is None:
        return None
    mask = np.asarray(unmasked(f"masks({name})", given))
    if mask.ndim != 2 or mask.dtype not in (np.bool_, np.uint8):
        raise TypeError(f"masks({name}): expected bool or uint8 [h, w], got {mask.dtype} {list(mask.shape)}")
    if mask.shape != (size[1], size[0]):
        raise ValueError(f"masks({name}): expected shape {[size[1], size[0]]}, got {list(mask.shape)}")
    return mask if mask.dtype == np.bool_ else mask >= KEPT


def _alpha_of(path: Path) -> NDArray[np.uint8] | None:
    if is_photo(path):
        return read_alpha(path)
    header = read_picture_header(path)
    if header.kind != "png" or header.channels not in (2, 4) or header.bits != 8:
        return None
    return decode_texture(path, path.read_bytes())[..., 3]


def _fitted(place: Path, mask: NDArray[np.bool_], origin: Path | None, size: tuple[int, int]) -> NDArray[np.bool_]:
    """Rotate and scale a mask like its image. One that only fits the upright shape is taken as upright."""
    orientation = UPRIGHT if origin is None else read_orientation(origin)
    turned = upright(mask, orientation)
    for each in (turned, mask):
        height, width = each.shape
        if abs(width * size[1] - height * size[0]) <= max(width, height) and width >= size[0]:
            if (width, height) == size:
                return np.ascontiguousarray(each)
            gray = Image.fromarray(np.where(each, 255, 0).astype(np.uint8))
            return np.asarray(gray.resize(size, Image.Resampling.BOX)) >= KEPT
    reason = f"is a mask of {mask.shape[1]} x {mask.shape[0]}, its picture {size[0]} x {size[1]} pixels"
    raise FileError(place, reason, remedy="Make masks of the size of their pictures")


def check_mask_files(pictures: Sequence[Path], folder: Path) -> dict[str, Path]:
    found: dict[str, Path] = {}
    for path in pictures:
        place = mask_file(folder, path.name)
        if not place.is_file():
            continue
        header = read_picture_header(path)
        if read_mask(place, (header.width, header.height)).mean() < _LEAST:
            raise FileError(place, "hides all of its picture", remedy=f"Leave out {path.name}, or its mask")
        found[path.name] = place
    if not found:
        reason = f"holds no mask of a picture, such as {pictures[0].name}.png"
        raise DatasetError(folder, reason, remedy="Name masks as their pictures, with .png behind")
    return found


def complete_masks(pictures: Sequence[Path], masks: dict[str, Path], folder: Path) -> None:
    """Write a white mask for each image without one, since COLMAP ignores images without masks."""
    folder.mkdir()
    for path in pictures:
        place = mask_file(folder, path.name)
        if path.name in masks:
            place.write_bytes(masks[path.name].read_bytes())
        else:
            header = read_picture_header(path)
            write_png(place, np.full((header.height, header.width), 255, np.uint8))
