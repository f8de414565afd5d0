"""Brightness of an image at another size, by area averaging, as blocks of 2 x 2 pixels.

A block is one load in bilinear interpolation: 16 bits each for a pixel, the ones to the right and below, and the
opposite one, from the lowest bits on. 8 B per pixel.
"""

from ..images.depth import BLUE_WEIGHT, GREEN_WEIGHT, RED_WEIGHT
from ..lang import array, func, int64, kernel, tid, uint8, uint64

WHITE_LEVEL = 255.0
MAX_PACKED_LEVEL = 65535.0  # of brightness 1
PACKED_LEVEL_MASK = 0xFFFF


@func
def brightness_of(pixels: array(dtype=uint8), pixel: int, channels: int) -> float:
    """Brightness of a pixel, 0..1, from 3 channels or 1."""
    value = float(pixels[pixel * channels])
    if channels == 3:
        green = float(pixels[pixel * channels + 1])
        blue = float(pixels[pixel * channels + 2])
        value = RED_WEIGHT * value + GREEN_WEIGHT * green + BLUE_WEIGHT * blue
    return value / WHITE_LEVEL


@func
def resized_brightness(
    pixels: array(dtype=uint8), channels: int, columns: int, rows: int, width: int, height: int, x: int, y: int
) -> float:
    """Mean brightness of the area of a pixel of a smaller image."""
    across = float(columns) / float(width)
    down = float(rows) / float(height)
    left = float(x) * across
    top = float(y) * down
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
    return total / area


@func
def brightness_in(block: uint64) -> float:
    """Brightness of the pixel of a block."""
    return float(int(block & uint64(PACKED_LEVEL_MASK))) * (1.0 / MAX_PACKED_LEVEL)


@kernel
def resize_brightness_kernel(
    pixels: array(dtype=uint8),
    channels: int,
    columns: int,
    rows: int,
    width: int,
    height: int,
    first: int,
    blocks: array(dtype=uint64),
):
    """Resize an image of columns x rows to width x height, into `blocks` from `first` on. The border is repeated."""
    i = tid()
    block = uint64(0)
    for k in range(4):
        x = min(i % width + k % 2, width - 1)
        y = min(i // width + k // 2, height - 1)
        value = 0.0
        if width == columns and height == rows:
            value = brightness_of(pixels, y * columns + x, channels)
        else:
            value = resized_brightness(pixels, channels, columns, rows, width, height, x, y)
        block = block | (uint64(int64(value * MAX_PACKED_LEVEL + 0.5)) << uint64(16 * k))
    blocks[first + i] = block
