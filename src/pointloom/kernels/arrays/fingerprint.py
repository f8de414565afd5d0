"""64-bit fingerprint of an array of points: an integer sum of hashed coordinates and positions."""

from ..array_types import Points
from ..lang import array, float_bits, func, int64, kernel, launch, tid, vec3
from ..memory import download, zeros
from .hash_table import mix_bits
from .row_atomics import add_long
from .runs import Runs, elements_of, row_of

RUN_POINTS = 256  # points per thread on the CPU: one atomic each
LOW_WORD = 0xFFFF_FFFF


@func
def word_of(x: float) -> int64:
    return int64(float_bits(x)) & int64(LOW_WORD)


@kernel
def sum_words_kernel(points: array(dtype=vec3), runs: Runs, totals: array(dtype=int64)):
    """Add the hashed words of a thread's points to a row's sum."""
    i = tid()
    total = int64(0)
    for k in elements_of(i, runs):
        p = points[k]
        word = mix_bits(word_of(p[0]) | (word_of(p[1]) << 32))
        total += mix_bits(word + (word_of(p[2]) | (int64(k) << 32)))
    add_long(totals, row_of(i, runs), total)


def fingerprint(points: Points) -> int:
    """Fingerprint of a device array of vec3, an int (one sync)."""
    runs = Runs(points.size, points.device, RUN_POINTS)
    totals = zeros(runs.rows, int64, points.device)
    launch(sum_words_kernel, runs.threads, [points, runs, totals])
    return int(download(totals).sum())  # sync
