"""Selection of sharp video frames with sufficient motion, in one pass with constant memory.

Blurred: variance of the Laplacian (Pech-Pacheco et al. 2000) below 0.6 of the median of neighboring frames. Motion:
peak of the phase correlation (Kuglin and Hines 1975) of thumbnails.
"""

from __future__ import annotations

import collections
import math

import numpy as np
from numpy.typing import NDArray
from PIL import Image

ANALYSIS_SIZE = 640  # [px] longer side for analysis. Finer blur is irrelevant
THUMBNAIL_SIZE = 80  # [px] longer side of thumbnails

NEIGHBOR_FRAMES = 7  # frames on both sides for the median sharpness
MIN_RELATIVE_SHARPNESS = 0.6  # fraction of that median
SEARCHED_FRAMES = 2  # frames on both sides searched for the sharpest
FAST_MOVEMENT_FACTOR = 1.5  # times the requested movement: faster cameras are elsewhere in the next frame
LAG = NEIGHBOR_FRAMES + SEARCHED_FRAMES  # look-ahead frames

MIN_MOVEMENT = 0.004  # of the longer side: tripod noise, a third of a thumbnail pixel
_MAX_BLOCK_CHANGE = 0.25  # relative change of a block by noise
_BLOCK_PIXELS = 8  # [px] of a thumbnail

_MAX_BLACK_BRIGHTNESS = 16  # brightness exceeded by 5% of the pixels unless the frame is black
_MIN_BRIGHTNESS_DEVIATION = 2.0  # standard deviation of a uniform frame
_BRIGHT_PERCENTILE = 95  # percentile
_MIN_DIVISOR = 1e-12


def sharpness(gray: NDArray[np.uint8]) -> float:
    if min(gray.shape) < 3:
        return 0.0
    z = gray.astype(np.int16)
    laplacian = z[:-2, 1:-1] + z[2:, 1:-1] + z[1:-1, :-2] + z[1:-1, 2:] - 4 * z[1:-1, 1:-1]
    return float(laplacian.var(dtype=np.float64))


def thumbnail(gray: NDArray[np.uint8]) -> NDArray[np.uint8]:
    height, width = gray.shape
    factor = min(1.0, THUMBNAIL_SIZE / max(height, width))
    size = (max(1, round(width * factor)), max(1, round(height * factor)))
    return np.asarray(Image.fromarray(gray).resize(size, Image.Resampling.BOX))


def is_blank(small: NDArray[np.uint8]) -> bool:
    return bool(
        np.percentile(small, _BRIGHT_PERCENTILE) < _MAX_BLACK_BRIGHTNESS or small.std() < _MIN_BRIGHTNESS_DEVIATION
    )


def movement(first: NDArray[np.uint8], second: NDArray[np.uint8]) -> float:
    """Image shift between two thumbnails relative to the longer side. 0 if blank, 1 if sizes differ."""
    if first.shape != second.shape:
        return 1.0
    height, width = first.shape
    window = np.outer(np.hanning(height + 2)[1:-1], np.hanning(width + 2)[1:-1])
    spectra = [np.fft.rfft2((small - small.mean(dtype=np.float64)) * window) for small in (first, second)]
    cross = spectra[0] * spectra[1].conj()
    surface = np.fft.irfft2(cross / np.maximum(np.abs(cross), _MIN_DIVISOR), s=(height, width))
    row, column = np.unravel_index(int(np.argmax(surface)), surface.shape)
    dy = _peak(surface[:, column], int(row))
    dx = _peak(surface[row], int(column))
    return math.hypot(dx, dy) / max(height, width)


def is_still(first: NDArray[np.uint8], second: NDArray[np.uint8]) -> bool:
    """True if the camera did not move: forward motion, zoom and roll change most blocks, noise and objects few."""
    if first.shape != second.shape or movement(first, second) >= MIN_MOVEMENT:
        return False
    height, width = (side // _BLOCK_PIXELS * _BLOCK_PIXELS for side in first.shape)
    if not height or not width:
        return bool(np.array_equal(first, second))
    one, two = (
        small[:height, :width].reshape(height // _BLOCK_PIXELS, _BLOCK_PIXELS, -1, _BLOCK_PIXELS).astype(np.float32)
        for small in (first, second)
    )
    contrast = one.std(axis=(1, 3), dtype=np.float64)
    seen = contrast >= _MIN_BRIGHTNESS_DEVIATION
    if not seen.any():
        return True
    # a flickering lamp changes the mean brightness of a block without motion
    difference = (two - one).std(axis=(1, 3), dtype=np.float64)
    return bool(np.median(difference[seen] / contrast[seen]) < _MAX_BLOCK_CHANGE)


def _peak(values: NDArray[np.float64], index: int) -> float:
    """Subpixel peak position; negative beyond the half."""
    count = len(values)
    left, middle, right = values[index - 1], values[index], values[(index + 1) % count]
    bend = left - 2 * middle + right
    offset = 0.5 * (left - right) / bend if bend < -_MIN_DIVISOR else 0.0
    shift = index + min(max(offset, -0.5), 0.5)
    return shift if shift <= count / 2 else shift - count


class FramePicker:
    """Selects frames of a stream; `end` completes the selection.

    Args:
        min_movement: Minimum image shift between selected frames, relative to the longer side.
        max_gap: Maximum number of frames between selected ones unless the camera is still.

    Attributes:
        chosen: Numbers of the selected frames, from 0.
        still: Number of times that `max_gap` was reached without camera motion.
        blank: Numbers of black or uniform frames.
        blurred: Number of blurred frames among the others.
    """

    def __init__(self, *, min_movement: float = 0.04, max_gap: int = 30):
        self._min_movement, self.max_gap = min_movement, max_gap
        self.chosen: list[int] = []
        self.blank: list[int] = []
        self.blurred = self.still = 0
        self._sharpness: list[float] = []  # of all frames. NaN if blank
        self._small: collections.deque[NDArray[np.uint8]] = collections.deque(maxlen=LAG + SEARCHED_FRAMES + 1)
        self._last: NDArray[np.uint8] | None = None
        self._judged = 0
        self._skipped = 0  # frames since the last selected one with a still camera

    def add(self, gray: NDArray[np.uint8]) -> None:
        small = thumbnail(gray)
        if is_blank(small):
            self.blank.append(len(self._sharpness))
            self._sharpness.append(float("nan"))
        else:
            self._sharpness.append(sharpness(gray))
        self._small.append(small)
        if len(self._sharpness) > LAG:
            self._judge()

    def end(self) -> None:
        while self._judged < len(self._sharpness):
            self._judge()

    def _judge(self) -> None:
        index = self._judged
        self._judged += 1
        if self._is_blurred(index):
            self.blurred += 1
        last = self.chosen[-1] if self.chosen else -1
        if index <= last or math.isnan(self._sharpness[index]):
            return
        moved = 0.0 if self._last is None else movement(self._last, self._thumbnail(index))
        if self._last is not None and moved < self._min_movement:
            due = index - last - self._skipped >= self.max_gap
            if due and is_still(self._last, self._thumbnail(index)):
                self.still += 1
                self._skipped = index - last
                due = False
            if not due:
                return
        radius = SEARCHED_FRAMES if moved < FAST_MOVEMENT_FACTOR * self._min_movement else 0
        near = range(max(index - radius, last + 1), min(index + radius + 1, len(self._sharpness)))
        sharp = [n for n in near if not math.isnan(self._sharpness[n]) and not self._is_blurred(n)]
        if sharp:
            best = max(sharp, key=lambda n: self._sharpness[n])
            self.chosen.append(best)
            self._skipped = 0
            self._last = self._thumbnail(best)

    def _thumbnail(self, number: int) -> NDArray[np.uint8]:
        return self._small[number - len(self._sharpness)]

    def _is_blurred(self, number: int) -> bool:
        around = np.array(self._sharpness[max(number - NEIGHBOR_FRAMES, 0) : number + NEIGHBOR_FRAMES + 1])
        around = around[~np.isnan(around)]
        return bool(len(around) and self._sharpness[number] < MIN_RELATIVE_SHARPNESS * np.median(around))


def spaced(numbers: list[int], count: int) -> list[int]:
    """At most `count` of some numbers, evenly spaced, with the first and the last."""
    if len(numbers) <= count:
        return numbers
    if count == 1:
        return numbers[:1]
    return [numbers[round(position)] for position in np.linspace(0, len(numbers) - 1, count)]
