"""The noise of a colour camera's sensor: the same everywhere in the picture, of its own in each channel.

One thread a value: reads and writes one byte, and draws four words of random bits.

The noise is the sum of eight uniform numbers of 16 bits (Irwin and Hall): normal to 1 % of its density within three
standard deviations, and, unlike the logarithm and cosine of Box and Muller's, the same bits on every device.
"""

from ..array_types import Bytes
from ..arrays.random import random_bits
from ..lang import array, func, int64, kernel, launch, tid, uint8
from ..memory import empty

STREAM = 0x40000000  # apart from the streams that the depth camera's noise draws from
HALF_WORD = 0xFFFF
MEAN = 262140.0  # of eight numbers from 0 to 65,535
PER_SIGMA = 1.0 / 53510.0  # their standard deviation: 65,536 sqrt(8 / 12)


@func
def halves(word: int64) -> int64:
    """The sum of both halves of a word."""
    return (word & int64(HALF_WORD)) + (word >> 16)


@kernel
def measure_colors_kernel(
    sigma: float, seed: int, frame: int, colors: array(dtype=uint8), measured: array(dtype=uint8)
):
    """Each value with noise of this standard deviation [of 255], rounded, within 0..255."""
    i = tid()
    words = random_bits(seed, i, STREAM + frame)
    sums = halves(int64(words[0])) + halves(int64(words[1])) + halves(int64(words[2])) + halves(int64(words[3]))
    normal = (float(sums) - MEAN) * PER_SIGMA
    value = float(int(colors[i])) + sigma * normal
    measured[i] = uint8(int(min(max(value, 0.0), 255.0) + 0.5))


def measure_colors(colors: Bytes, *, sigma: float, seed: int, frame: int) -> Bytes:
    """Colours as a sensor with noise measures them.

    Args:
        colors: uint8 device array [n].
        sigma: Standard deviation of the noise [of 255].
        seed, frame: Choose the noise; the same two give the same noise.

    Returns:
        uint8 device array [n].
    """
    measured = empty(colors.size, uint8, colors.device)
    launch(measure_colors_kernel, colors.size, [sigma, seed, frame, colors, measured])
    return measured
