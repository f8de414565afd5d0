"""Pictures as files: `check_picture` before the work, `save_picture` after it."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from ...pcd.errors import FileError
from ...pcd.io.atomic import check_writable
from ...pcd.io.image_files import write_png


def check_picture(path: Any, *, overwrite: bool) -> None:
    """Hold that a picture can be written, before any work.

    Raises:
        FileError: Another extension than .png, or a place that cannot be written.
    """
    if Path(path).suffix.lower() != ".png":
        raise FileError(path, "pictures are written as .png", remedy="Give a name that ends in .png")
    check_writable(path, overwrite=overwrite)


def save_picture(path: str | os.PathLike[str], image: NDArray[Any], *, overwrite: bool = True) -> None:
    """Write a picture as PNG.

    Args:
        path: Place of the file; ends in .png.
        image: Shape [h, w, 3] or [h, w], uint8.
        overwrite: Replace a file that exists.

    Raises:
        FileError: The file exists and may not be replaced, another extension, or the place cannot be written.
        TypeError, ValueError: Not such an image.
    """
    check_writable(path, overwrite=overwrite)
    write_png(path, image)
