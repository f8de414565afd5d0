"""Atomic image output into a folder that is cleaned up on errors."""

from __future__ import annotations

import contextlib
import dataclasses
import io
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from ...core.atomic import atomic_write
from ...core.errors import FileError

KINDS = ("jpg", "png")

_JPEG_QUALITY = 95  # JPEG quality: losses at 4:4:4 are below camera noise
_SHOWN_NUMBERS = 6


@dataclasses.dataclass(frozen=True)
class Wanted:
    """Output options: folder, maximum number, maximum size [px], format."""

    folder: Path
    max_count: int
    max_size: int | None
    kind: str


@contextlib.contextmanager
def new_folder(folder: Path) -> Iterator[None]:
    """A new or empty folder, cleaned up if the block fails."""
    existed = folder.is_dir()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if any(folder.iterdir()):
            raise FileError(folder, "is not empty", remedy="Give a new folder, or an empty one")
    except OSError as error:
        raise FileError(folder, f"cannot be created: {error.strerror or error}") from error
    try:
        yield
    except BaseException:
        with contextlib.suppress(OSError):  # the propagating error is more informative
            for path in folder.iterdir():
                path.unlink(missing_ok=True)
            if not existed:
                folder.rmdir()
        raise


def write_image(path: Path, pixels: NDArray[np.uint8], exif: bytes = b"") -> None:
    buffer = io.BytesIO()
    if path.suffix == ".png":
        Image.fromarray(pixels).save(buffer, "PNG", compress_level=1, **({"exif": exif} if exif else {}))
    else:
        Image.fromarray(pixels).save(buffer, "JPEG", quality=_JPEG_QUALITY, subsampling=0, exif=exif)
    with atomic_write(path) as file:
        file.write(buffer.getbuffer())


def write_bytes(path: Path, data: bytes) -> None:
    with atomic_write(path) as file:
        file.write(data)


def some_of(names: list[str]) -> str:
    more = len(names) - _SHOWN_NUMBERS
    return ", ".join(names[:_SHOWN_NUMBERS]) + (f" and {more} more" if more > 0 else "")


def counted(count: int, noun: str) -> str:
    return f"{count} {noun}{'' if count == 1 else 's'}"
