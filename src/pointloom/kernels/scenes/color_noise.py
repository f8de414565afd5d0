"""Color sensor noise: eight uniform 16-bit numbers (Irwin and Hall), normal to 1 % within three deviations."""

from ..array_types import Bytes
from ..arrays.random import random_bits
from ..lang import array, compute, func, int64, kernel, tid, uint8

COLOR_NOISE_STREAM = 0x40000000  # distinct from the streams of the depth noise
HALF_WORD = 0xFFFF
MEAN_OF_SUM = 262140.0  # of the sum of eight numbers from 0 to 65,535
PER_SIGMA = 1.0 / 53510.0  # their standard deviation: 65,536 sqrt(8 / 12)


@func
def sum_half_words(word: int64) -> int64:
    return (word & int64(HALF_WORD)) + (word >> 16)


@kernel
def measure_colors_kernel(
    sigma: float, seed: int, frame: int, colors: array(dtype=uint8), measured: array(dtype=uint8)
):
    i = tid()
    words = random_bits(seed, i, COLOR_NOISE_STREAM + frame)
    sums = (
        sum_half_words(int64(words[0]))
        + sum_half_words(int64(words[1]))
        + sum_half_words(int64(words[2]))
        + sum_half_words(int64(words[3]))
    )
    normal = (float(sums) - MEAN_OF_SUM) * PER_SIGMA
    value = float(int(colors[i])) + sigma * normal
    measured[i] = uint8(int(min(max(value, 0.0), 255.0) + 0.5))


def measure_colors(colors: Bytes, *, sigma: float, seed: int, frame: int) -> Bytes:
    """Colors, uint8 (n), with noise of standard deviation `sigma` [of 255]; (`seed`, `frame`) selects the noise."""
    return compute(measure_colors_kernel, colors.size, [sigma, seed, frame, colors], uint8, colors.device)
