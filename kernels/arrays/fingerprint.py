"""One number that tells whether the points of an array are what they were.

The sum of a mixed 64-bit word a point, which holds its coordinates' bits and its place: a changed bit, or two points
that change places, go unnoticed once in some 2^64 times. 12 B read a point; whole numbers, so the order of the sum does
not matter.
"""

from ..lang import array, atomic_add, float_bits, func, int64, kernel, launch, tid, vec3
from ..memory import download, zeros
from .hash_table import mix_bits

RUN = 256  # points a thread: one atomic each
LOW_WORD = 0xFFFF_FFFF


@func
def word_of(x: float) -> int64:
    """The bits of a coordinate."""
    return int64(float_bits(x)) & int64(LOW_WORD)


@kernel
def sum_words_kernel(points: array(dtype=vec3), run: int, total: array(dtype=int64)):
    """Add the mixed words of a run of points; whole numbers, in any order."""
    i = tid()
    held = int64(0)
    for j in range(run):
        k = i * run + j
        if k < points.shape[0]:
            p = points[k]
            word = mix_bits(word_of(p[0]) | (word_of(p[1]) << int64(32)))
            held += mix_bits(word + (word_of(p[2]) | (int64(k) << int64(32))))
    atomic_add(total, 0, held)


def fingerprint(points):
    """The fingerprint of a device array of vec3, an int (one sync)."""
    total = zeros(1, int64, points.device)
    launch(sum_words_kernel, -(-points.size // RUN), [points, RUN, total])
    return int(download(total)[0])  # sync
