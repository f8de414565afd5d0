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
from ...core.paths import input_path
from ...io.images.image_files import decode_texture, read_color, read_image_header, write_png
from ...io.images.image_formats import IMAGES
from ...io.images.photo_files import is_photo, read_alpha
from .frame_choice import FrameChoice
from .image_folder import EXIF_UPRIGHT, list_photographs, read_orientation, read_stored, upright
from .image_writing import counted, some_of

ALPHA = "alpha"
FOLDER = "_masks"  # appended to the image folder's name

MakeMask = Callable[[NDArray[np.uint8], str], Any]
MASK_THRESHOLD = 128  # brightness threshold of masks
_MIN_VISIBLE = 0.001  # minimum unmasked fraction of an image
_ENDINGS = sorted(IMAGES, key=lambda extension: extension != ".png")
_INVERSE_ORIENTATIONS = {6: 8, 8: 6}  # inverse EXIF orientations. The others are self-inverse


def check_masks(masks: Any) -> FilePath | MakeMask | None:
    if masks is None or callable(masks):
        return masks
    if not isinstance(masks, str | os.PathLike):
        raise TypeError(f'masks: expected a folder, "alpha" or a function, got {type(masks).__name__}')
    if masks != ALPHA and not Path(masks).is_dir():
        raise DatasetError(
            masks, "is not a folder", remedy="Give the folder of the masks, with IMG_1.jpg.png for IMG_1.jpg"
        )
    return masks


def mask_folder(images: Path) -> Path:
    return images.with_name(images.name + FOLDER)


def mask_file(folder: Path, name: str) -> Path:
    return folder / f"{name}.png"


def masks_in(folder: Path, names: Iterable[str]) -> list[Path | None]:
    paths = (mask_file(folder, name) for name in names)
    return [path if path.is_file() else None for path in paths]


def write_mask(folder: Path, name: str, mask: NDArray[np.bool_]) -> None:
    write_png(mask_file(folder, name), np.where(mask, 255, 0).astype(np.uint8))


def read_mask(path: FilePath, size: tuple[int, int]) -> NDArray[np.bool_]:
    header = read_image_header(path)
    if (header.width, header.height) != size:
        reason = f"expected a mask of {size[0]} x {size[1]} pixels as its image, got {header.width} x {header.height}"
        raise FileError(path, reason, remedy="Create masks of the size of their images")
    return read_color(path).max(axis=2) >= MASK_THRESHOLD


def write_masks(choice: FrameChoice, source: Path, images: Path, masks: FilePath | MakeMask) -> FrameChoice:
    """Write the masks of the selected images, and remove images that are completely masked."""
    folder = mask_folder(images)
    originals = list_photographs(source)[0] if source.is_dir() else []
    selected, hidden, missing = [], {}, []
    for k, (name, number) in enumerate(zip(choice.names, choice.numbers, strict=True)):
        origin = originals[number] if originals else None
        header = read_image_header(images / name)
        mask = _mask_of(masks, images / name, origin, (header.width, header.height))
        if mask is None:
            missing.append(name)
        elif hides_all(mask):
            hidden[name if origin is None else origin.name] = "its mask excludes all pixels"
            (images / name).unlink()
            continue
        else:
            write_mask(folder, name, mask)
        selected.append(k)
    return _without_hidden(choice, source, masks, selected, hidden, missing)


def _without_hidden(
    choice: FrameChoice, source: Path, masks: Any, selected: list[int], hidden: dict[str, str], missing: list[str]
) -> FrameChoice:
    check_some_left(source, masks, list(hidden), missing, len(selected))
    return dataclasses.replace(
        choice,
        names=tuple(choice.names[k] for k in selected),
        numbers=tuple(choice.numbers[k] for k in selected),
        left_out=choice.left_out | hidden,
        notes=(*choice.notes, *mask_notes(list(hidden), missing)),
    )


def _check_any_mask(source: Path, masks: Any, missing: list[str], count: int) -> None:
    if len(missing) == count:
        reason = (
            "no image has an alpha channel" if masks == ALPHA else f"{masks} contains no mask such as {missing[0]}.png"
        )
        reason = "the function returned no mask for any image" if callable(masks) else reason
        raise DatasetError(source, reason, remedy="Name masks like their images: IMG_1.jpg.png, or IMG_1.png")


def mask_notes(hidden: list[str], missing: list[str]) -> list[str]:
    notes = []
    if hidden:
        notes.append(f"{counted(len(hidden), 'image')} left out, since the mask excludes all pixels: {some_of(hidden)}")
    if missing:
        notes.append(f"{counted(len(missing), 'image')} without a mask, used completely: {some_of(missing)}")
    return notes


def hides_all(mask: NDArray[np.bool_]) -> bool:
    return bool(mask.mean() < _MIN_VISIBLE)


def check_some_left(source: Path, masks: Any, hidden: list[str], missing: list[str], count: int) -> None:
    if not count:
        raise FileError(source, f"none of {counted(len(hidden), 'image')} is left: the masks exclude all pixels")
    _check_any_mask(source, masks, missing, count)


def _mask_of(masks: Any, image: Path, origin: Path | None, size: tuple[int, int]) -> NDArray[np.bool_] | None:
    """The mask of an image as it was written. None if missing."""
    if callable(masks):
        return _of_function(masks, read_color(image), image.name if origin is None else origin.name, size)
    if masks == ALPHA:
        alpha = None if origin is None else _alpha_of(origin)
        return None if origin is None or alpha is None else _fitted(origin, alpha >= MASK_THRESHOLD, origin, size)
    path = _mask_path(masks, (*(() if origin is None else (origin.name, origin.stem)), image.name, image.stem))
    return None if path is None else _fitted(path, read_color(path).max(axis=2) >= MASK_THRESHOLD, origin, size)


def mask_as_stored(masks: FilePath | MakeMask, image: Path, size: tuple[int, int]) -> NDArray[np.bool_] | None:
    """The mask of a photograph in stored orientation. None if missing. A mask function gets the image as stored."""
    if callable(masks):
        return _of_function(masks, read_stored(image), image.name, size)
    if masks == ALPHA:
        alpha = _alpha_of(image)
        return None if alpha is None else _fitted(image, alpha >= MASK_THRESHOLD, None, size)
    path = _mask_path(masks, (image.name, image.stem))
    if path is None:
        return None
    mask = read_color(path).max(axis=2) >= MASK_THRESHOLD
    if (mask.shape[1], mask.shape[0]) != size:  # drawn on the upright image
        mask = upright(mask, _INVERSE_ORIENTATIONS.get(orientation := read_orientation(image), orientation))
    return _fitted(path, mask, None, size)


def _mask_path(masks: FilePath, names: Sequence[str]) -> Path | None:
    paths = (Path(masks) / f"{name}{ending}" for name in dict.fromkeys(names) for ending in _ENDINGS)
    return next((path for path in paths if path.is_file()), None)


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
    return mask if mask.dtype == np.bool_ else mask >= MASK_THRESHOLD


def _alpha_of(path: Path) -> NDArray[np.uint8] | None:
    if is_photo(path):
        return read_alpha(path)
    header = read_image_header(path)
    if header.kind != "png" or header.channels not in (2, 4) or header.bits != 8:
        return None
    return decode_texture(path, input_path(path).read_bytes())[..., 3]


def _fitted(path: Path, mask: NDArray[np.bool_], origin: Path | None, size: tuple[int, int]) -> NDArray[np.bool_]:
    """Rotate and scale a mask like its image. One that only fits the upright shape is taken as upright."""
    orientation = EXIF_UPRIGHT if origin is None else read_orientation(origin)
    rotated = upright(mask, orientation)
    for each in (rotated, mask):
        height, width = each.shape
        if abs(width * size[1] - height * size[0]) <= max(width, height) and width >= size[0]:
            if (width, height) == size:
                return np.ascontiguousarray(each)
            gray = Image.fromarray(np.where(each, 255, 0).astype(np.uint8))
            return np.asarray(gray.resize(size, Image.Resampling.BOX)) >= MASK_THRESHOLD
    reason = f"expected a mask of {size[0]} x {size[1]} pixels as its image, got {mask.shape[1]} x {mask.shape[0]}"
    raise FileError(path, reason, remedy="Create masks of the size of their images")


def check_mask_files(images: Sequence[Path], folder: Path) -> dict[str, Path]:
    result: dict[str, Path] = {}
    for path in images:
        mask_path = mask_file(folder, path.name)
        if not mask_path.is_file():
            continue
        header = read_image_header(path)
        if read_mask(mask_path, (header.width, header.height)).mean() < _MIN_VISIBLE:
            raise FileError(mask_path, "excludes all pixels of its image", remedy=f"Leave out {path.name}, or its mask")
        result[path.name] = mask_path
    if not result:
        reason = f"contains no mask of an image, such as {images[0].name}.png"
        raise DatasetError(folder, reason, remedy="Name masks like their images, with .png appended")
    return result


def complete_masks(images: Sequence[Path], masks: dict[str, Path], folder: Path) -> None:
    """Write a white mask for each image without one, since COLMAP ignores images without masks."""
    folder.mkdir()
    for path in images:
        mask_path = mask_file(folder, path.name)
        if path.name in masks:
            mask_path.write_bytes(masks[path.name].read_bytes())
        else:
            header = read_image_header(path)
            write_png(mask_path, np.full((header.height, header.width), 255, np.uint8))
