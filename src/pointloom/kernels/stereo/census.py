"""Census codes of two images, and their brightness resampled by a homography.

A code compares the 31 pairs of opposite pixels in a window of 9 x 7 (center-symmetric census: Spangenberg, Langner,
Rojas, "Weighted semi-global matching and center-symmetric census transform", CAIP 2013), so it does not depend on
exposure. The Hamming distance of two codes is the matching cost, 0 to 31. Resampling: 4 B per pixel written. Codes: 62
comparisons per pixel, 4 B written.
"""

import numpy as np

from ..array_types import Bytes, Integers, Scalars
from ..lang import array, float32, floor, func, int32, kernel, launch, mat33, tid, uint8, vec3, vector
from ..memory import empty
from .brightness import brightness_of

LANE_COUNT = 16  # pixels of a thread, and disparities computed together: LLVM vectorizes loops over them
WINDOW_HALF_WIDTH, WINDOW_HALF_HEIGHT = 4, 3  # half the window [px]
NO_CODE = -1  # outside the image
OUTSIDE_BRIGHTNESS = -1.0  # brightness

lanes = vector(LANE_COUNT, int32)


@func
def blended(pixels: array(dtype=uint8), channels: int, columns: int, rows: int, u: float, v: float) -> float:
    """Bilinear brightness at a position, OUTSIDE_BRIGHTNESS beyond the pixel centers of the border."""
    value = float(OUTSIDE_BRIGHTNESS)
    if u >= 0.0 and v >= 0.0 and u <= float(columns - 1) and v <= float(rows - 1):
        column = min(int(floor(u)), columns - 2)
        row = min(int(floor(v)), rows - 2)
        first = row * columns + column
        along = u - float(column)
        a = brightness_of(pixels, first, channels)
        b = brightness_of(pixels, first + 1, channels)
        c = brightness_of(pixels, first + columns, channels)
        d = brightness_of(pixels, first + columns + 1, channels)
        above = a + (b - a) * along
        value = above + (c + (d - c) * along - above) * (v - float(row))
    return value


@kernel
def rectify_brightness_kernel(
    pixels: array(dtype=uint8),
    channels: int,
    columns: int,
    rows: int,
    is_copied: int,
    there: mat33,
    width: int,
    height: int,
    brightness: array(dtype=float32),
):
    """Brightness with a repeated border for the window. `there` maps its pixels to the image, unless it is copied."""
    i = tid()
    stride = width + 2 * WINDOW_HALF_WIDTH + LANE_COUNT
    x = min(max(i % stride - WINDOW_HALF_WIDTH, 0), width - 1)
    y = min(max(i // stride - WINDOW_HALF_HEIGHT, 0), height - 1)
    value = float(OUTSIDE_BRIGHTNESS)
    if is_copied == 1:
        if x < columns and y < rows:
            value = brightness_of(pixels, y * columns + x, channels)
    else:
        p = there @ vec3(float(x), float(y), 1.0)
        if p[2] > 0.0:
            value = blended(pixels, channels, columns, rows, p[0] / p[2], p[1] / p[2])
    brightness[i] = value


@kernel
def find_codes_kernel(
    brightness: array(dtype=float32), width: int, step: int, start: int, length: int, codes: array(dtype=int32)
):
    """Codes of rows of pixels, each at start + step * column of a row of `codes`."""
    i = tid()
    blocks = (width + LANE_COUNT - 1) // LANE_COUNT
    y = i // blocks
    first = i % blocks * LANE_COUNT
    stride = width + 2 * WINDOW_HALF_WIDTH + LANE_COUNT
    center = (y + WINDOW_HALF_HEIGHT) * stride + first + WINDOW_HALF_WIDTH
    code = lanes(0)
    for dy in range(WINDOW_HALF_HEIGHT + 1):
        for dx in range(-WINDOW_HALF_WIDTH, WINDOW_HALF_WIDTH + 1):
            if dy > 0 or dx > 0:
                offset = dy * stride + dx
                for k in range(LANE_COUNT):
                    bit = 1 if brightness[center + k + offset] > brightness[center + k - offset] else 0
                    code[k] = code[k] * 2 + bit
    for k in range(LANE_COUNT):
        column = start + step * (first + k)
        if first + k < width and column >= 0 and column < length:
            value = code[k]
            if brightness[center + k] < 0.0:
                value = NO_CODE
            codes[y * length + column] = value


@find_codes_kernel.on_cuda
def find_code_kernel(
    brightness: array(dtype=float32), width: int, step: int, start: int, length: int, codes: array(dtype=int32)
):
    """CUDA variant, a pixel per thread."""
    i = tid()
    x = i % width
    y = i // width
    stride = width + 2 * WINDOW_HALF_WIDTH + LANE_COUNT
    center = (y + WINDOW_HALF_HEIGHT) * stride + x + WINDOW_HALF_WIDTH
    column = start + step * x
    if column >= 0 and column < length:
        code = 0
        for dy in range(WINDOW_HALF_HEIGHT + 1):
            for dx in range(-WINDOW_HALF_WIDTH, WINDOW_HALF_WIDTH + 1):
                if dy > 0 or dx > 0:
                    offset = dy * stride + dx
                    code = code * 2 + (1 if brightness[center + offset] > brightness[center - offset] else 0)
        if brightness[center] < 0.0:
            code = NO_CODE
        codes[y * length + column] = code


def rectify_brightness(
    pixels: Bytes, channels: int, columns: int, rows: int, there: np.ndarray | None, width: int, height: int
) -> Scalars:
    """Brightness of an image seen through a homography, None for a copy, with the border that `find_codes` needs."""
    size = (width + 2 * WINDOW_HALF_WIDTH + LANE_COUNT) * (height + 2 * WINDOW_HALF_HEIGHT)
    out = empty(size, float32, pixels.device)
    matrix = mat33(*np.eye(3).ravel() if there is None else there.ravel())
    arrays = [pixels, channels, columns, rows, int(there is None), matrix, width, height, out]
    launch(rectify_brightness_kernel, size, arrays)
    return out


def find_codes(brightness: Scalars, width: int, height: int, *, step: int, start: int, codes: Integers) -> None:
    """Write the codes of an image into rows of `codes`, at start + step * column."""
    threads = width if codes.device.is_cuda else -(-width // LANE_COUNT)
    launch(find_codes_kernel, threads * height, [brightness, width, step, start, codes.size // height, codes])
