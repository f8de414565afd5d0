"""Tuple test of fast global registration (Zhou, Park and Koltun, ECCV 2016, section 3.2): random triples whose triangle
sides agree up to a ratio. The result depends only on the seed.
"""

from ..algebra.transform import distance_between
from ..array_types import Integers
from ..arrays.concatenation import concatenate_rows
from ..arrays.random import random_below, random_bits
from ..arrays.select import positions_of
from ..lang import array, compute, float64, int32, kernel, launch, tid, uint8
from ..memory import empty
from .pair_fits import PairCoordinates, source_point, target_point

TUPLE_SIZE = 3
CPU_BATCH, CUDA_BATCH, MAX_BATCH = 8192, 2**17, 2**20  # smaller batches would save a GPU less than a sync takes


@kernel
def test_tuples_kernel(
    pairs: PairCoordinates,
    seed: int,
    first: int,
    ratio: float64,
    tuples: array(dtype=int32, ndim=2),
    passed: array(dtype=uint8),
):
    """Draw triple `first + i`. 1 if all sides agree within the ratio."""
    i = tid()
    for j in range(TUPLE_SIZE):
        tuples[i, j] = random_below(random_bits(seed, first + i, j), pairs.count)
    similar = 1
    for j in range(TUPLE_SIZE):
        row = tuples[i, j]
        other = tuples[i, (j + 1) % TUPLE_SIZE]
        a = distance_between(source_point(pairs, row), source_point(pairs, other))
        b = distance_between(target_point(pairs, row), target_point(pairs, other))
        if not (a * ratio < b and b < a / ratio):
            similar = 0
    passed[i] = uint8(similar)


@kernel
def list_tuples_kernel(tuples: array(dtype=int32, ndim=2), chosen: array(dtype=int32), rows: array(dtype=int32)):
    i = tid()
    rows[i] = tuples[chosen[i // TUPLE_SIZE], i % TUPLE_SIZE]


def similar_tuples(pairs: PairCoordinates, seed: int, trials: int, ratio: float, max_triples: int) -> Integers:
    """Rows of the first triples that pass, int32 (3 t), t <= `max_triples`. Repeats are weights. One sync per batch."""
    device, batches, total, done = pairs.device, [], 0, 0
    batch = CUDA_BATCH if device.is_cuda else CPU_BATCH
    while done < trials and total < max_triples and pairs.count:
        size = min(batch, trials - done)
        tuples, passed = empty((size, TUPLE_SIZE), int32, device), empty(size, uint8, device)
        launch(test_tuples_kernel, size, [pairs, seed, done, ratio, tuples, passed])
        chosen = positions_of(passed)  # sync
        if chosen.size:
            chosen = chosen[: min(chosen.size, max_triples - total)]
            rows = compute(list_tuples_kernel, TUPLE_SIZE * chosen.size, [tuples, chosen], int32, device)
            batches.append(rows)
            total += chosen.size
        done, batch = done + size, min(2 * batch, MAX_BATCH)
    return concatenate_rows(batches) if batches else empty(0, int32, device)
