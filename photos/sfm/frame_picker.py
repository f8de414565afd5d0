"""Which frames of a video to take: sharp ones, each of which shows the scene from another place than the last.

Frames are looked at once, one after the other, at a reduced size. Kept are a number for each frame, and small copies of
the last few: a video of hours needs no more memory than one of seconds.

A frame is blurred where the variance of its Laplacian (Pech-Pacheco et al. 2000) is below 0.6 of the median of its
neighbours: an absolute bar would depend on what is seen. How far the picture moved is the peak of the phase
correlation (Kuglin and Hines 1975) of small copies of two frames.
"""

from __future__ import annotations

import collections
import math

import numpy as np
from numpy.typing import NDArray
from PIL import Image

ANALYSIS_SIZE = 640  # [px], the longer side of frames that are looked at; blur that is not seen there does not matter
THUMBNAIL_SIZE = 80  # [px], likewise, of the copies whose movement is measured

NEIGHBOURS = 7  # frames on both sides whose median sharpness is the measure
BLURRED = 0.6  # of that median
NEAR = 2  # frames on both sides of a place among which the sharpest is taken
FAST = 1.5  # times the movement wanted: a camera that moves on so far in one frame is at another place in the next
LAG = NEIGHBOURS + NEAR  # frames that must be known beyond a place before it is judged

STILL = 0.004  # of the longer side: what a tripod's phase correlation gives, a third of a pixel of a thumbnail
_SAME = 0.25  # of a block's contrast: by which the median block of a picture that is the same may differ, by noise
_BLOCK = 8  # [px] of a thumbnail

_BLACK = 16  # brightness that a twentieth of the pixels of a frame passes unless it is black
_BLANK = 2.0  # standard deviation of the brightness of a frame without anything in it
_BRIGHT = 95  # percentile
_LEAST = 1e-12


def sharpness(grey: NDArray[np.uint8]) -> float:
    """The variance of a picture's Laplacian; grows with the contrast of its finest detail.

    Args:
        grey: Shape [h, w].

    Example:
        >>> import numpy as np
        >>> sharp = np.tile(np.repeat([0, 200], 8), (16, 4)).astype(np.uint8)
        >>> soft = np.tile(np.abs(np.arange(-8, 8)) * 25, (16, 4)).astype(np.uint8)
        >>> sharpness(sharp) > 10 * sharpness(soft)
        True
    """
    if min(grey.shape) < 3:
        return 0.0
    z = grey.astype(np.int16)
    laplacian = z[:-2, 1:-1] + z[2:, 1:-1] + z[1:-1, :-2] + z[1:-1, 2:] - 4 * z[1:-1, 1:-1]
    return float(laplacian.var(dtype=np.float64))


def thumbnail(grey: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """A small copy, each pixel the mean of those that it covers."""
    height, width = grey.shape
    factor = min(1.0, THUMBNAIL_SIZE / max(height, width))
    size = (max(1, round(width * factor)), max(1, round(height * factor)))
    return np.asarray(Image.fromarray(grey).resize(size, Image.Resampling.BOX))


def is_blank(small: NDArray[np.uint8]) -> bool:
    """Whether nothing is seen: black, or all of one brightness."""
    return bool(np.percentile(small, _BRIGHT) < _BLACK or small.std() < _BLANK)


def movement(first: NDArray[np.uint8], second: NDArray[np.uint8]) -> float:
    """How far a picture moved, as a share of its longer side.

    Args:
        first: A thumbnail, shape [h, w].
        second: Another of the same size.

    Returns:
        The length of the shift that fits best; 0 of blank pictures, 1 of pictures of different sizes.

    Example:
        >>> import numpy as np
        >>> scene = np.random.default_rng(0).integers(0, 256, (60, 100)).astype(np.uint8)
        >>> round(movement(scene[:, 5:85], scene[:, 10:90]), 2)
        0.06
    """
    if first.shape != second.shape:
        return 1.0
    height, width = first.shape
    window = np.outer(np.hanning(height + 2)[1:-1], np.hanning(width + 2)[1:-1])
    spectra = [np.fft.rfft2((small - small.mean(dtype=np.float64)) * window) for small in (first, second)]
    cross = spectra[0] * spectra[1].conj()
    surface = np.fft.irfft2(cross / np.maximum(np.abs(cross), _LEAST), s=(height, width))
    row, column = np.unravel_index(int(np.argmax(surface)), surface.shape)
    dy = _peak(surface[:, column], int(row))
    dx = _peak(surface[row], int(column))
    return math.hypot(dx, dy) / max(height, width)


def is_still(first: NDArray[np.uint8], second: NDArray[np.uint8]) -> bool:
    """Whether a camera stood still between two thumbnails, also where something moved before it.

    A camera that goes ahead, zooms or rolls leaves the middle where it is, and changes most blocks of the picture;
    noise and who walks by change few.

    Example:
        >>> import numpy as np
        >>> scene = np.random.default_rng(0).integers(0, 256, (60, 100)).astype(np.uint8)
        >>> is_still(scene, scene), is_still(scene[:, 5:85], scene[:, 6:86])
        (True, False)
    """
    if first.shape != second.shape or movement(first, second) >= STILL:
        return False
    height, width = (side // _BLOCK * _BLOCK for side in first.shape)
    if not height or not width:
        return bool(np.array_equal(first, second))
    one, two = (
        small[:height, :width].reshape(height // _BLOCK, _BLOCK, -1, _BLOCK).astype(np.float32)
        for small in (first, second)
    )
    contrast = one.std(axis=(1, 3), dtype=np.float64)
    seen = contrast >= _BLANK
    if not seen.any():
        return True
    # a lamp that flickers changes the brightness of a whole block, and moves nothing
    difference = (two - one).std(axis=(1, 3), dtype=np.float64)
    return bool(np.median(difference[seen] / contrast[seen]) < _SAME)


def _peak(values: NDArray[np.float64], place: int) -> float:
    """The shift at a peak, between two pixels where its neighbours say so; negative beyond the half."""
    count = len(values)
    left, middle, right = values[place - 1], values[place], values[(place + 1) % count]
    bend = left - 2 * middle + right
    offset = 0.5 * (left - right) / bend if bend < -_LEAST else 0.0
    shift = place + min(max(offset, -0.5), 0.5)
    return shift if shift <= count / 2 else shift - count


class FramePicker:
    """Takes frames as they come, and says in the end which to keep.

    Args:
        min_movement: How far the picture moves from one frame that is kept to the next, as a share of its longer side.
        max_gap: At most so many frames from one to the next, where the camera does not stand still.

    Attributes:
        chosen: Numbers of the frames to keep, from 0; complete once `end` was called.
        still: How many times a frame was due after `max_gap` and the camera had not moved.
        blank: Numbers of black frames and of those that show nothing.
        blurred: How many of the others were blurred.

    Example:
        >>> import numpy as np
        >>> scene = np.random.default_rng(0).integers(0, 256, (60, 200)).astype(np.uint8)
        >>> picker = FramePicker()
        >>> for number in range(30):
        ...     picker.add(scene[:, 2 * number : 2 * number + 80])
        >>> picker.end()
        >>> 8 <= len(picker.chosen) <= 15, picker.blurred, picker.blank
        (True, 0, [])
    """

    def __init__(self, *, min_movement: float = 0.04, max_gap: int = 30):
        self._min_movement, self.max_gap = min_movement, max_gap
        self.chosen: list[int] = []
        self.blank: list[int] = []
        self.blurred = self.still = 0
        self._sharpness: list[float] = []  # of all frames; NaN of blank ones
        self._small: collections.deque[NDArray[np.uint8]] = collections.deque(maxlen=LAG + NEAR + 1)
        self._last: NDArray[np.uint8] | None = None
        self._judged = 0
        self._skipped = 0  # frames since the last one taken in which the camera stood still

    def add(self, grey: NDArray[np.uint8]) -> None:
        """Look at the next frame, shape [h, w]."""
        small = thumbnail(grey)
        if is_blank(small):
            self.blank.append(len(self._sharpness))
            self._sharpness.append(float("nan"))
        else:
            self._sharpness.append(sharpness(grey))
        self._small.append(small)
        if len(self._sharpness) > LAG:
            self._judge()

    def end(self) -> None:
        """Judge the last frames."""
        while self._judged < len(self._sharpness):
            self._judge()

    def _judge(self) -> None:
        place = self._judged
        self._judged += 1
        if self._is_blurred(place):
            self.blurred += 1
        last = self.chosen[-1] if self.chosen else -1
        if place <= last or math.isnan(self._sharpness[place]):
            return
        moved = 0.0 if self._last is None else movement(self._last, self._thumbnail(place))
        if self._last is not None and moved < self._min_movement:
            due = place - last - self._skipped >= self.max_gap
            if due and is_still(self._last, self._thumbnail(place)):
                self.still += 1
                self._skipped = place - last
                due = False
            if not due:
                return
        reach = NEAR if moved < FAST * self._min_movement else 0
        near = range(max(place - reach, last + 1), min(place + reach + 1, len(self._sharpness)))
        sharp = [n for n in near if not math.isnan(self._sharpness[n]) and not self._is_blurred(n)]
        if sharp:
            best = max(sharp, key=lambda n: self._sharpness[n])
            self.chosen.append(best)
            self._skipped = 0
            self._last = self._thumbnail(best)

    def _thumbnail(self, number: int) -> NDArray[np.uint8]:
        return self._small[number - len(self._sharpness)]

    def _is_blurred(self, number: int) -> bool:
        around = np.array(self._sharpness[max(number - NEIGHBOURS, 0) : number + NEIGHBOURS + 1])
        around = around[~np.isnan(around)]
        return bool(len(around) and self._sharpness[number] < BLURRED * np.median(around))


def spaced(numbers: list[int], count: int) -> list[int]:
    """At most `count` of some numbers, evenly among them, with the first and the last.

    Example:
        >>> spaced([3, 7, 20, 21, 30], 3)
        [3, 20, 30]
    """
    if len(numbers) <= count:
        return numbers
    if count == 1:
        return numbers[:1]
    return [numbers[round(place)] for place in np.linspace(0, len(numbers) - 1, count)]
