"""Files of images of tensors."""

from __future__ import annotations

from ....core.errors import FilePath
from ...io import images
from ..geometry.image import Image


def read_image(filename: FilePath) -> Image:
    """Read a PNG or JPEG as stored, on the CPU."""
    return Image.from_legacy(images.read_image(filename))


def write_image(filename: FilePath, image: Image, quality: int = -1) -> bool:
    """Write a PNG (8 or 16 bits), or a JPEG of quality 0 to 100, by default 90."""
    if not isinstance(image, Image):
        raise TypeError(f"image: expected a t.geometry.Image, got {type(image).__name__}")
    return images.write_image(filename, image.to_legacy(), quality)
