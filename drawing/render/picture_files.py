"""Pictures as files: `check_picture` before the work, `save_picture` after it."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from ...core.atomic import check_writable
from ...core.errors import FileError
from ...files.pictures.image_files import write_png


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
        image: Shape [h, w, 3] or [h, w], uint8; or [h, w], uint16.
        overwrite: Replace a file that exists.

    Raises:
        FileError: The file exists and may not be replaced, another extension, or the place cannot be written.
        TypeError, ValueError: Not such an image.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> loom.save_picture("grey.png", np.full((48, 64), 128, np.uint8))
        >>> loom.read_color("grey.png").shape
        (48, 64, 3)
    """
    check_writable(path, overwrite=overwrite)
    write_png(path, image)
