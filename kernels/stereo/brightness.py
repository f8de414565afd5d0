"""Brightness of an image at another size, by area averaging."""

from ..images.depth import BLUE, GREEN, RED
from ..lang import array, float32, func, kernel, tid, uint8

WHITE = 255.0


@func
def brightness_of(pixels: array(dtype=uint8), pixel: int, channels: int) -> float:
    """Brightness of a pixel, 0..1, from 3 channels or 1."""
    value = float(pixels[pixel * channels])
    if channels == 3:
        green = float(pixels[pixel * channels + 1])
        blue = float(pixels[pixel * channels + 2])
        value = RED * value + GREEN * green + BLUE * blue
    return value / WHITE


@kernel
def resize_brightness_kernel(
    pixels: array(dtype=uint8),
    channels: int,
    columns: int,
    rows: int,
    width: int,
    height: int,
    first: int,
    brightness: array(dtype=float32),
):
    """Resize an image of columns x rows to width x height, into `brightness` from `first` on."""
    i = tid()
    across = float(columns) / float(width)
    down = float(rows) / float(height)
    left = float(i % width) * across
    top = float(i // width) * down
    right = left + across
    bottom = top + down
    total = 0.0
    area = 0.0
    for row in range(int(top), min(int(bottom) + 1, rows)):
        tall = min(bottom, float(row + 1)) - max(top, float(row))
        for column in range(int(left), min(int(right) + 1, columns)):
            part = tall * (min(right, float(column + 1)) - max(left, float(column)))
            if part > 0.0:
                total += part * brightness_of(pixels, row * columns + column, channels)
                area += part
    brightness[first + i] = total / area
