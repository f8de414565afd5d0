"""Masks of pictures whose depth is sought: what they leave out has none."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_list
from ...core.errors import FileError
from ...files.pictures.image_files import read_color, read_picture_header
from .depth_maps import DepthMap
from .posed_pictures import PosedCamera

Mask = str | os.PathLike[str] | NDArray[np.bool_] | NDArray[np.uint8] | None
KEPT = 128  # brightness from which a pixel of a mask counts as white


def check_picture_masks(masks: Any, cameras: Sequence[PosedCamera]) -> list[Path | NDArray[np.bool_] | None]:
    """A mask or None for each picture; files are asked for their headers alone.

    Raises:
        TypeError: Of another type.
        ValueError: Another number than pictures, an array of another shape.
        FileError: A file that cannot be read, or of another size.
    """
    given = check_list("masks", masks, "masks")
    if len(given) != len(cameras):
        raise ValueError(f"masks: expected one, or None, for each of the {len(cameras)} pictures, got {len(given)}")
    out: list[Path | NDArray[np.bool_] | None] = []
    for i, (each, camera) in enumerate(zip(given, cameras, strict=True)):
        lens = camera.intrinsic
        if isinstance(each, str | os.PathLike):
            header = read_picture_header(each)
            if (header.width, header.height) != (lens.width, lens.height):
                reason = f"is {header.width} x {header.height}, its picture {lens.width} x {lens.height} pixels"
                raise FileError(each, reason, remedy="Make masks of the size of their pictures")
            out.append(Path(each))
        else:
            out.append(None if each is None else _checked(f"masks[{i}]", each, (lens.height, lens.width)))
    return out


def _checked(name: str, mask: Any, size: tuple[int, int]) -> NDArray[np.bool_]:
    if not isinstance(mask, np.ndarray) or mask.dtype not in (np.bool_, np.uint8):
        kind = mask.dtype if isinstance(mask, np.ndarray) else type(mask).__name__
        raise TypeError(f"{name}: expected a path, or an array of bool or uint8, got {kind}")
    if mask.shape != size:
        raise ValueError(f"{name}: expected shape {list(size)} as of its picture, got {list(mask.shape)}")
    return mask.copy() if mask.dtype == np.bool_ else mask >= KEPT


def emptied(
    maps: Iterator[DepthMap], masks: Sequence[Path | NDArray[np.bool_] | None], cameras: Sequence[PosedCamera]
) -> Iterator[DepthMap]:
    """The maps without depth where masks leave it out."""
    for each, mask, camera in zip(maps, masks, cameras, strict=True):
        if mask is None:
            yield each
            continue
        kept = read_color(mask).max(axis=2) >= KEPT if isinstance(mask, Path) else mask
        if kept.shape != (camera.intrinsic.height, camera.intrinsic.width):
            raise FileError(str(mask), "was changed while depth was sought", remedy="Begin again")
        wide = np.where(kept[..., None], each.normals, np.float32(0))
        yield DepthMap(np.where(kept, each.depth, np.float32(0)), wide, np.where(kept, each.confidence, np.float32(0)))
