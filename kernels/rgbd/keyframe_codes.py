"""Codes of frames by which places are known again: a few hundred tests of depth and brightness at random pixels.

A fern takes three pixels at random places of a small picture and asks: is the first deeper than a threshold; deeper
than the second by a ratio; brighter than the second by a ratio; and the second than the third. Ratios do not care for
the exposure. What has no depth or no brightness answers nothing: it counts neither for nor against. Two frames differ
by the share of the tests that both answer and answer differently: near 0 from one place, near a half between places.

One thread a fern: 6 reads; one thread a keyframe: a byte read a fern. Glocker et al. 2015, "Real-time RGB-D camera
relocalization via randomized ferns for keyframe encoding"; there a fern counts as a whole and holes as zeros.
"""

from ..array_types import Array2, Bytes, Scalars
from ..arrays.random import random_uniform
from ..lang import array, float32, func, int32, kernel, launch, tid, uint8, vec4
from ..memory import empty

FERNS = 512  # 2,048 tests; a byte each
PLACES, SIZES = 0, 1  # streams of random numbers
SHALLOWEST, RANGE = 0.4, 4.0  # [m] thresholds of depth: from where, and over how much
LEAST_RATIO, RATIOS = 0.6, 0.9  # of two depths or two brightnesses: from where, and over how much
ANSWERED = 4  # shift of the bits that say which tests were answered


@func
def fern_pixel(share: float, fern: int, stream: int, seed: int, width: int, height: int) -> int:
    """A pixel at random; `share` is the random number of its row."""
    column = min(int(random_uniform(seed, fern, stream)[3] * float(width)), width - 1)
    return min(int(share * float(height)), height - 1) * width + column


@func
def answer(place: int, a: float, b: float, ratio: float) -> int:
    """The bits of a test at a place of the code: whether a exceeds b by a ratio, and that it was answered."""
    bits = 0
    if a > 0.0 and b > 0.0:
        bits = 1 << (place + ANSWERED)
        if a > b * ratio:
            bits = bits | (1 << place)
    return bits


@kernel
def encode_ferns_kernel(
    depth: array(dtype=float32),
    brightness: array(dtype=float32),
    first: int,
    width: int,
    height: int,
    seed: int,
    offset: int,
    codes: array(dtype=uint8),
):
    """The answers of a fern to a picture of some pixels from `first` on; without colour its brightness is below 0."""
    i = tid()
    u = random_uniform(seed, i, PLACES)
    w = random_uniform(seed, i, SIZES)
    a = first + fern_pixel(u[0], i, 2, seed, width, height)
    b = first + fern_pixel(u[1], i, 3, seed, width, height)
    c = first + fern_pixel(u[2], i, 4, seed, width, height)
    ratios = vec4(w[0], w[1], w[2], w[3]) * RATIOS + vec4(LEAST_RATIO, LEAST_RATIO, LEAST_RATIO, LEAST_RATIO)
    code = answer(0, depth[a], SHALLOWEST + w[0] * RANGE, 1.0)
    code = code | answer(1, depth[a], depth[b], ratios[1])
    code = code | answer(2, brightness[a], brightness[b], ratios[2])
    code = code | answer(3, brightness[b], brightness[c], ratios[3])
    codes[offset + i] = uint8(code)


@func
def count_bits(value: int) -> int:
    """How many of the lowest four bits are set."""
    return (value & 1) + (value >> 1 & 1) + (value >> 2 & 1) + (value >> 3 & 1)


@kernel
def compare_codes_kernel(code: array(dtype=uint8), codes: array(dtype=uint8), counts: array(dtype=int32, ndim=2)):
    """Tests that a frame and a keyframe both answer, and how many of these differently; a thread a keyframe."""
    i = tid()
    common = 0
    different = 0
    for j in range(code.shape[0]):
        x = int(code[j])
        y = int(codes[i * FERNS + j])
        both = (x & y) >> ANSWERED
        common += count_bits(both)
        different += count_bits((x ^ y) & both)
    counts[i, 0] = common
    counts[i, 1] = different


def encode_frame(
    depth: Scalars,
    brightness: Scalars,
    first: int,
    width: int,
    height: int,
    *,
    seed: int,
    codes: Bytes | None = None,
    row: int = 0,
) -> Bytes:
    """The code of a picture, uint8 [FERNS], or written to a row of `codes`.

    Args:
        depth: float32 device array [m], 0 where there is none.
        brightness: float32, of the same pixels; below 0 where there is none.
        first: The picture's first element in both.
        width, height: Its size; small (40 x 30, say), since pixels are taken as they are.
        seed: Chooses the tests.
        codes: uint8 [rows * FERNS] to write to; None for an array of one row.
        row: The row written to.
    """
    if codes is None:
        codes = empty(FERNS, uint8, depth.device)
    launch(encode_ferns_kernel, FERNS, [depth, brightness, first, width, height, seed, row * FERNS, codes])
    return codes


def compare_codes(code: Bytes, codes: Bytes, count: int) -> Array2[int32]:
    """Tests that a code has in common with each of the first `count` rows of others, and how many of them differ.

    Returns:
        int32 device array [count, 2].
    """
    counts = empty((count, 2), int32, code.device)
    launch(compare_codes_kernel, count, [code, codes, counts])
    return counts
