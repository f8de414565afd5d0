"""Fern codes of frames for relocalization (Glocker et al. 2015, "Real-time RGB-D camera relocalization via randomized
ferns for keyframe encoding"). A fern compares three random pixels by depth and brightness ratios, independent of
exposure. Tests without data are not counted. Dissimilarity is the fraction of common tests that differ.
"""

from ..array_types import Array2, Bytes, Scalars
from ..arrays.random import random_uniform
from ..lang import array, float32, func, int32, kernel, launch, tid, uint8, vec4
from ..memory import empty

FERN_COUNT = 512  # 2,048 tests, one byte each
PIXEL_STREAM, RATIO_STREAM = 0, 1  # streams of random numbers
MIN_THRESHOLD_DEPTH, THRESHOLD_RANGE = 0.4, 4.0  # [m] depth thresholds: minimum and range
MIN_RATIO, RATIO_RANGE = 0.6, 0.9  # ratios of depths or brightnesses: minimum and range
VALID_SHIFT = 4  # shift of the validity bits


@func
def fern_pixel(fraction: float, fern: int, stream: int, seed: int, width: int, height: int) -> int:
    """Random pixel; `fraction` is the random number of its row."""
    column = min(int(random_uniform(seed, fern, stream)[3] * float(width)), width - 1)
    return min(int(fraction * float(height)), height - 1) * width + column


@func
def comparison_bits(bit: int, a: float, b: float, ratio: float) -> int:
    """Bits of a test: a exceeds b by a ratio, and validity."""
    bits = 0
    if a > 0.0 and b > 0.0:
        bits = 1 << (bit + VALID_SHIFT)
        if a > b * ratio:
            bits = bits | (1 << bit)
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
    """Code of a fern for the image from element `first` on. Brightness below 0 without color."""
    i = tid()
    u = random_uniform(seed, i, PIXEL_STREAM)
    w = random_uniform(seed, i, RATIO_STREAM)
    a = first + fern_pixel(u[0], i, 2, seed, width, height)
    b = first + fern_pixel(u[1], i, 3, seed, width, height)
    c = first + fern_pixel(u[2], i, 4, seed, width, height)
    ratios = vec4(w[0], w[1], w[2], w[3]) * RATIO_RANGE + vec4(MIN_RATIO, MIN_RATIO, MIN_RATIO, MIN_RATIO)
    code = comparison_bits(0, depth[a], MIN_THRESHOLD_DEPTH + w[0] * THRESHOLD_RANGE, 1.0)
    code = code | comparison_bits(1, depth[a], depth[b], ratios[1])
    code = code | comparison_bits(2, brightness[a], brightness[b], ratios[2])
    code = code | comparison_bits(3, brightness[b], brightness[c], ratios[3])
    codes[offset + i] = uint8(code)


@func
def count_bits(value: int) -> int:
    return (value & 1) + (value >> 1 & 1) + (value >> 2 & 1) + (value >> 3 & 1)


@kernel
def compare_codes_kernel(code: array(dtype=uint8), codes: array(dtype=uint8), counts: array(dtype=int32, ndim=2)):
    """Common tests of a frame and a keyframe, and differing ones. One thread per keyframe."""
    i = tid()
    common = 0
    different = 0
    for j in range(code.shape[0]):
        x = int(code[j])
        y = int(codes[i * FERN_COUNT + j])
        both = (x & y) >> VALID_SHIFT
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
    """Code of a small image (such as 40 x 30), in `row` of `codes` if given. Depth 0, brightness below 0: missing."""
    if codes is None:
        codes = empty(FERN_COUNT, uint8, depth.device)
    launch(encode_ferns_kernel, FERN_COUNT, [depth, brightness, first, width, height, seed, row * FERN_COUNT, codes])
    return codes


def compare_codes(code: Bytes, codes: Bytes, count: int) -> Array2[int32]:
    """Common and differing tests with the first `count` rows of others, int32 (count, 2)."""
    counts = empty((count, 2), int32, code.device)
    launch(compare_codes_kernel, count, [code, codes, counts])
    return counts
