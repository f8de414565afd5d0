"""Counter-based random numbers: a function of (seed, counter, stream), independent of threads.

Philox4x32-10 of Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC 2011. The words are bitwise identical
on all devices. Floats made with log and cos may differ in the last bit between devices.
"""

from ..lang import cos, float32, func, int64, log, sin, sqrt, uint32, uint64, vec2, vec4, vector

vec4u = vector(4, uint32)

MULTIPLIER_0 = 0xD2511F53  # constants of the paper's reference implementation, Random123
MULTIPLIER_1 = 0xCD9E8D57
WEYL_0 = 0x9E3779B9
WEYL_1 = 0xBB67AE85
LOW_WORD = 0xFFFFFFFF
PHILOX_ROUNDS = 10
UPPER_HALF = 0xFFFF0000

WORD_STEP = 1.0 / 16777216.0  # 2^-24: float32 represents the upper 24 bits of a word exactly
TWO_PI = 6.283185307179586


@func
def philox(x0: uint64, x1: uint64, x2: uint64, x3: uint64, k0: uint64, k1: uint64) -> vec4u:
    """Philox4x32-10 block of a counter (x0, x1, x2, x3) and a key (k0, k1) of 32-bit words."""
    c0 = x0
    c1 = x1
    c2 = x2
    c3 = x3
    key0 = k0
    key1 = k1
    for _ in range(PHILOX_ROUNDS):
        p0 = uint64(MULTIPLIER_0) * c0
        p1 = uint64(MULTIPLIER_1) * c2
        c0 = (p1 >> 32) ^ c1 ^ key0
        c1 = p1 & uint64(LOW_WORD)
        c2 = (p0 >> 32) ^ c3 ^ key1
        c3 = p0 & uint64(LOW_WORD)
        key0 = (key0 + uint64(WEYL_0)) & uint64(LOW_WORD)
        key1 = (key1 + uint64(WEYL_1)) & uint64(LOW_WORD)
    return vec4u(uint32(c0), uint32(c1), uint32(c2), uint32(c3))


@func
def random_bits(seed: int, counter: int, stream: int) -> vec4u:
    """Four independent words of 32 random bits."""
    key = uint64(int64(seed) & int64(LOW_WORD))
    lane = uint64(int64(stream) & int64(LOW_WORD))
    return philox(uint64(int64(counter) & int64(LOW_WORD)), 0, lane, 0, key, 0)


@func
def random_below(words: vec4u, count: int) -> int:
    """Random number in 0..count-1 from 64 random bits; bias below 2^-32."""
    size = uint64(int64(count))
    low = (uint64(words[1]) * size) >> 32
    return int((uint64(words[0]) * size + low) >> 32)


@func
def unit_float(word: uint32) -> float:
    """A word as a number in [0, 1), a multiple of 2^-24."""
    return float32(word >> 8) * WORD_STEP


@func
def random_uniform(seed: int, counter: int, stream: int) -> vec4:
    words = random_bits(seed, counter, stream)
    return vec4(unit_float(words[0]), unit_float(words[1]), unit_float(words[2]), unit_float(words[3]))


@func
def half_uniform(words: vec4u, half: int) -> vec4:
    """Numbers in [0, 1), multiples of 2^-16, of the upper (0) or lower half (1) of each word."""
    shift = uint32(16 * half)
    upper = uint32(UPPER_HALF)
    return vec4(
        unit_float((words[0] << shift) & upper),
        unit_float((words[1] << shift) & upper),
        unit_float((words[2] << shift) & upper),
        unit_float((words[3] << shift) & upper),
    )


@func
def gaussian_pair(u: float, v: float) -> vec2:
    """Two independent standard normal numbers from two uniform ones (Box and Muller 1958); |x| < 5.8."""
    radius = sqrt(-2.0 * log(1.0 - u))  # 1 - u is in (0, 1], where the logarithm is finite
    return vec2(radius * cos(TWO_PI * v), radius * sin(TWO_PI * v))
