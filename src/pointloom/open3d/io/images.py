"""Files of images."""

from __future__ import annotations

from pathlib import Path

import PIL.Image

from ...core.atomic import atomic_write
from ...core.errors import FileError, FilePath
from ...core.paths import input_path
from ...io.file_formats import listed
from ...io.images import image_files
from ..argument_types import ImageLike
from ..geometry.image import Image, pixels_of

RGBA_CHANNELS = {2: (0, 3), 4: (0, 1, 2, 3)}  # channels of RGBA by number of channels
PNG, JPEG = ".png", (".jpg", ".jpeg")


def read_image(filename: FilePath) -> Image:
    """Read a PNG or JPEG as stored: 8 or 16 bits, gray or color, with alpha."""
    header = image_files.read_image_header(filename)
    if header.channels == 1 and header.bits == 16:
        return Image(image_files.read_depth(filename))
    if header.kind == "png" and header.channels in RGBA_CHANNELS and header.bits == 8:  # JPEG has four channels of ink
        pixels = image_files.decode_texture(filename, input_path(filename).read_bytes())
        has_alpha = pixels.shape[2] == 4  # false for CMYK
        return Image(pixels[..., RGBA_CHANNELS[header.channels]] if has_alpha else pixels)
    pixels = image_files.read_color(filename)
    return Image(pixels[..., 0] if header.channels == 1 and _is_gray(filename) else pixels)


def write_image(filename: FilePath, image: ImageLike, quality: int = -1) -> bool:
    """Write a PNG (8 or 16 bits), or a JPEG of quality 0 to 100, by default 90."""
    pixels = pixels_of(image)
    if (suffix := Path(filename).suffix.lower()) not in (PNG, *JPEG):
        raise FileError(filename, f"images are written to {listed((PNG, *JPEG))}, not to {suffix or 'no extension'}")
    if suffix in JPEG:
        with atomic_write(filename) as file:
            PIL.Image.fromarray(pixels).save(file, "JPEG", quality=90 if quality < 0 else quality)
    else:
        image_files.write_png(filename, pixels)
    return True


def _is_gray(filename: FilePath) -> bool:
    """True if pixels are gray and not palette indices."""
    with PIL.Image.open(filename) as image:
        return image.mode in ("L", "1")
