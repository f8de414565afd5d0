"""Image files: `check_picture` before the work, `write_image` after it."""

from __future__ import annotations

import io
import os
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from ...core.atomic import atomic_write, check_writable
from ...core.errors import FileError
from ...core.paths import path_of
from ...io.file_formats import listed
from ...io.images.image_files import PIXEL_LIMIT, encode_png, write_png
from ...io.images.image_formats import IMAGES, PICTURES

OPAQUE = (*(each for each in IMAGES if each not in PICTURES), ".mp4", ".gif")  # common, without partial transparency
MAX_WEBP = 16383  # [px] per side


def check_picture(path: Any, *, overwrite: bool) -> None:
    """Check that an image can be written, before any work. Raises FileError."""
    if path_of(path).suffix.lower() not in PICTURES:
        reason = f"unknown image format: expected {listed(PICTURES)}"
        raise FileError(path, reason, remedy="Use a file name that ends in .png")
    check_writable(path, overwrite=overwrite)


def write_image(path: str | os.PathLike[str], image: NDArray[Any], *, overwrite: bool = True) -> None:
    """Write an image as PNG or lossless WebP.

    Args:
        path: A .png or .webp file.
        image: uint8 of shape (h, w, 3) (RGB), (h, w, 4) (RGBA) or (h, w). For PNG also uint16 (h, w).
        overwrite: Replace an existing file.

    Raises:
        FileError: The file exists, has another extension (JPEG, GIF and MP4 have no transparency), or cannot be
            written.
        TypeError, ValueError: Unsupported image.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> loom.write_image("gray.png", np.full((48, 64), 128, np.uint8))
        >>> loom.read_color("gray.png").shape
        (48, 64, 3)
    """
    kind, shape = path_of(path).suffix.lower(), getattr(image, "shape", ())
    has_opacity = len(shape) == 3 and shape[2] == 4
    if has_opacity and kind in OPAQUE:
        remedy = f"Write {listed(PICTURES)}, or render with an opaque background"
        raise FileError(path, f"{kind} does not support transparency", remedy=remedy)
    check_picture(path, overwrite=overwrite)
    if not (has_opacity or kind == ".webp"):
        write_png(path, image)
        return
    pixels = _check_bytes(image)
    if kind == ".png":
        data = encode_png(pixels)
    else:
        if max(pixels.shape[:2]) > MAX_WEBP:
            raise ValueError(
                f"image: expected at most {MAX_WEBP} pixels per side for .webp, got shape {list(pixels.shape)}"
            )
        buffer = io.BytesIO()
        Image.fromarray(pixels).save(buffer, "WEBP", lossless=True, exact=True)
        data = buffer.getvalue()
    with atomic_write(path) as file:
        file.write(data)


def _check_bytes(image: object) -> NDArray[np.uint8]:
    if not isinstance(image, np.ndarray) or image.dtype != np.uint8:
        kind = image.dtype if isinstance(image, np.ndarray) else type(image).__name__
        raise TypeError(f"image: expected a NumPy array of uint8, got {kind}")
    if not (image.ndim == 2 or (image.ndim == 3 and image.shape[2] in (3, 4))):
        raise ValueError(f"image: expected shape [h, w], [h, w, 3] or [h, w, 4], got {list(image.shape)}")
    if not 0 < image.shape[0] * image.shape[1] <= PIXEL_LIMIT:
        raise ValueError(f"image: expected 1 to {PIXEL_LIMIT} pixels, got shape {list(image.shape)}")
    return np.ascontiguousarray(image)
