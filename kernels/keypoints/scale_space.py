"""The Gaussian scale space of a grey picture: octaves of six levels, each octave half the size of the one before.

The first octave is of twice the picture's size, as a picture's finest detail is otherwise lost (Lowe 2004, section 3).
Level k of an octave is blurred by 1.6 * 2^(k / 3) of its own pixels; the next octave is every second pixel of level 3.
Beyond its border a picture goes on as it is there. Blurs are cut off at four sigma, which leaves 6e-5 of the weight.

One thread 16 pixels of a row; each level is two passes with 11 to 27 products a pixel, and reads and writes 16 B a
pixel. Rows of levels are padded to whole threads, those between the passes by one more on either side, so that the pass
along rows asks nothing of borders.

Source: Lowe 2004, "Distinctive image features from scale-invariant keypoints"; numbers as VLFeat and COLMAP have them.
"""

import math

import numpy as np

from ..array_types import Bytes, Device, Scalars
from ..lang import array, float32, kernel, launch, struct, tid, uint8, vector
from ..linear_algebra import elementwise
from ..memory import empty, upload

LANES = 16  # pixels a thread
lanes = vector(LANES, float32)

SCALES = 3  # levels from one size to its double
LEVELS = SCALES + 3  # so that each of three differences has one on either side
BASE_SIGMA = 1.6  # of an octave's level 0, in its own pixels
CAMERA_SIGMA = 0.5  # of a picture as a camera takes it
CUT = 4.0  # sigma, at which a blur ends
OCTAVES = 4
LEAST_SIDE = 8  # of an octave [px]; a smaller one has hardly an extremum inside


def level_sigma(level: float) -> float:
    """How far a level is blurred, in pixels of its octave."""
    return BASE_SIGMA * 2.0 ** (level / SCALES)


@struct
class Octave:
    """The levels of one size, one after the other.

    Attributes:
        width, height: Of a level [px].
        stride: From one row to the next.
        step: Pixels of the picture in one of this octave.
        levels: Brightness, float32 [LEVELS * height * stride].
    """

    width: int
    height: int
    stride: int
    step: float
    levels: array(dtype=float32)

    def __init__(self, width: int, height: int, step: float, device: Device) -> None:
        self.width, self.height, self.step, self.device = width, height, step, device
        self.stride = -(-width // LANES) * LANES
        self.levels = empty(LEVELS * height * self.stride, float32, device)

    @property
    def blocks(self) -> int:
        """Threads a row."""
        return self.stride // LANES


@kernel
def double_picture_kernel(picture: array(dtype=uint8), width: int, height: int, octave: Octave):
    """Level 1, which level 0 is made of: the picture at twice its size, with means between its pixels, 0 to 1."""
    i = tid()
    row = i // octave.stride
    x = min(i % octave.stride, octave.width - 1)
    left = x // 2
    right = min((x + 1) // 2, width - 1)
    top = row // 2
    bottom = min((row + 1) // 2, height - 1)
    above = int(picture[top * width + left]) + int(picture[top * width + right])
    below = int(picture[bottom * width + left]) + int(picture[bottom * width + right])
    octave.levels[octave.height * octave.stride + i] = float(above + below) * 0.25 / 255.0


@kernel
def halve_level_kernel(fine: Octave, coarse: Octave):
    """Level 0 of every second pixel of the level that is blurred twice as far."""
    i = tid()
    row = i // coarse.stride
    x = min(i % coarse.stride, coarse.width - 1)
    coarse.levels[i] = fine.levels[(SCALES * fine.height + 2 * row) * fine.stride + 2 * x]


@kernel
def blur_columns_kernel(
    octave: Octave, level: int, blocks: int, weights: array(dtype=float32), between: array(dtype=float32)
):
    """Each pixel with those above and below it; one block more on either side repeats the border."""
    i = tid()
    row = i // blocks
    first = (i % blocks - 1) * LANES
    reach = weights.shape[0] // 2
    total = lanes(0.0)
    if first >= 0 and first + LANES <= octave.width:
        for k in range(weights.shape[0]):
            weight = weights[k]
            y = min(max(row + k - reach, 0), octave.height - 1)
            at = (level * octave.height + y) * octave.stride + first
            for j in range(LANES):
                total[j] = total[j] + weight * octave.levels[at + j]
    else:
        for k in range(weights.shape[0]):
            weight = weights[k]
            y = min(max(row + k - reach, 0), octave.height - 1)
            at = (level * octave.height + y) * octave.stride
            for j in range(LANES):
                total[j] = total[j] + weight * octave.levels[at + min(max(first + j, 0), octave.width - 1)]
    for j in range(LANES):
        between[i * LANES + j] = total[j]


@kernel
def blur_rows_kernel(between: array(dtype=float32), level: int, weights: array(dtype=float32), octave: Octave):
    """Each pixel with those left and right of it."""
    i = tid()
    blocks = octave.stride // LANES
    row = i // blocks
    at = (row * (blocks + 2) + i % blocks + 1) * LANES - weights.shape[0] // 2
    total = lanes(0.0)
    for k in range(weights.shape[0]):
        weight = weights[k]
        for j in range(LANES):
            total[j] = total[j] + weight * between[at + k + j]
    to = level * octave.height * octave.stride + i * LANES
    for j in range(LANES):
        octave.levels[to + j] = total[j]


def blur_weights(sigma: float) -> np.ndarray:
    """Of a blur, [2 r + 1]; they sum to 1."""
    reach = max(math.ceil(CUT * sigma), 1)
    weights = elementwise(math.exp, -0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    return (weights / weights.sum()).astype(np.float32)


class ScaleSpace:
    """The octaves of pictures of one size; the arrays are used for one picture after the other.

    Args:
        width, height: Of the pictures [px].
        device: Where to compute.
    """

    def __init__(self, width: int, height: int, device: Device) -> None:
        self.width, self.height, self.device = width, height, device
        self.octaves: list[Octave] = []
        for number in range(OCTAVES):
            size = (2 * width) >> number, (2 * height) >> number
            if min(size) >= LEAST_SIDE:
                self.octaves.append(Octave(*size, 0.5 * 2.0**number, device))
        sigmas = [math.sqrt(BASE_SIGMA**2 - (2 * CAMERA_SIGMA) ** 2)]
        sigmas += [math.sqrt(level_sigma(k) ** 2 - level_sigma(k - 1) ** 2) for k in range(1, LEVELS)]
        self.weights = [upload(blur_weights(sigma), float32, device) for sigma in sigmas]
        most = max(((o.blocks + 2) * LANES * o.height for o in self.octaves), default=0)
        self.between: Scalars = empty(most, float32, device)

    def show(self, picture: Bytes) -> None:
        """Fill the octaves from a grey picture, uint8 [height * width] on the device."""
        for number, octave in enumerate(self.octaves):
            if number == 0:
                launch(double_picture_kernel, octave.height * octave.stride, [picture, self.width, self.height, octave])
                self._blur(octave, 1, 0)
            else:
                launch(halve_level_kernel, octave.height * octave.stride, [self.octaves[number - 1], octave])
            for level in range(1, LEVELS):
                self._blur(octave, level - 1, level)

    def _blur(self, octave: Octave, source: int, level: int) -> None:
        """A level from another."""
        weights, blocks = self.weights[level], octave.blocks + 2
        launch(blur_columns_kernel, octave.height * blocks, [octave, source, blocks, weights, self.between])
        launch(blur_rows_kernel, octave.height * octave.blocks, [self.between, level, weights, octave])
