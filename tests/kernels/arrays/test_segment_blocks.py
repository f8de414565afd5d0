"""Elements by thread, rows resolved in rounds, and sums over many segments, each independent of the others."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom.core.devices import resolve_device
from pointloom.kernels import lang
from pointloom.kernels.arrays.open_rows import CHECKED_ROUNDS, MAX_ROUNDS, resolve_in_rounds
from pointloom.kernels.arrays.runs import CUDA_MIN_LENGTH, CUDA_THREADS, Runs, elements_of, row_of
from pointloom.kernels.arrays.segment_blocks import SegmentBlocks
from pointloom.kernels.lang import (
    ELEMENTS_PER_BLOCK,
    array,
    atomic_add,
    float32,
    float64,
    int32,
    int64,
    kernel,
    launch,
    tid,
    uint8,
)
from pointloom.kernels.language import segment_launches
from pointloom.kernels.memory import copy, download, fill, full, upload, zeros

LENGTH = 64  # of a run on the CPU


@kernel
def visit_elements_kernel(runs: Runs, visits: array(dtype=int32), taken: array(dtype=int32)):
    i = tid()
    for j in elements_of(i, runs):
        visits[j] = visits[j] + 1
        atomic_add(taken, row_of(i, runs), 1)


@pytest.mark.parametrize("count", [0, 1, LENGTH - 1, LENGTH, LENGTH + 1, 1000, CUDA_MIN_LENGTH * CUDA_THREADS + 5])
def test_each_element_is_taken_once(device, count):
    warp_device = resolve_device(device)
    runs = Runs(count, warp_device, LENGTH)
    visits, taken = zeros(count, int32, warp_device), zeros(runs.rows, int32, warp_device)
    launch(visit_elements_kernel, runs.threads, [runs, visits, taken])
    assert (download(visits) == 1).all() and download(taken).sum() == count


class Gpu:
    is_cuda = True


def test_gpu_launches_use_full_warps_up_to_the_device_limit():
    assert Runs(200_000, Gpu(), 4096).threads == 50_016
    assert Runs(1, Gpu(), 4096).threads == 32 and Runs(50_000_000, Gpu(), 4096).threads == CUDA_THREADS


@pytest.mark.parametrize("count", [1, 2**31 - 1])
def test_all_numbers_of_the_largest_arrays_fit_in_32_bits(count):
    runs = Runs(count, Gpu(), 4096)
    last = runs.threads - 1
    assert last * runs.stride < 2**31 and max((count - 1 - last) // runs.step + 1, runs.length) < 2**31
    assert last + ((count - 1 - last) // runs.step) * runs.step <= count - 1 and np.int64(runs.rows) <= 256


pair = lang.vector(2, float64)
N = ELEMENTS_PER_BLOCK
SIZES = [0, 1, 2, 7, N - 1, N, N + 1, 0, 3 * N + 5, 0]
FIRSTS = np.concatenate([[0], np.cumsum(SIZES)[:-1]])


@lang.segment_reduction
def sum_powers(values: array(dtype=float64)) -> pair:
    i = tid()
    return pair(values[i], values[i] * values[i])


@kernel
def count_down_kernel(iterations: array(dtype=int32), running: array(dtype=int32)):
    i = tid()
    if iterations[i] > 0:
        iterations[i] = iterations[i] - 1
        if iterations[i] == 0:
            atomic_add(running, 0, -1)  # a count: the order does not matter


VECTORS = """
numbers = vector({length}, {kind})

@func
def multiples(value: int) -> numbers:
    out = numbers({kind}(0))
    for k in range({length}):
        out[k] = {kind}(value * (k % 5 + 1))
    return out

@segment_reduction
def sum_multiples(values: array(dtype=int32)) -> numbers:
    i = tid()
    return multiples(values[i])

@reduction
def sum_all_multiples(values: array(dtype=int32)) -> numbers:
    i = tid()
    return multiples(values[i])
"""


def sums_of(device, values, firsts, counts, live=None, start=None):
    blocks = SegmentBlocks(firsts, counts, device)
    alive = full(len(counts), 1, int32, device) if live is None else upload(np.array(live), int32, device)
    partials = blocks.partials(pair)
    out = zeros(len(counts), pair, device) if start is None else upload(start, pair, device)
    lang.reduce_segments(sum_powers, blocks, alive, [upload(values, float64, device)], partials, out)
    return out.numpy().copy()


@settings(deadline=None)
@given(st.lists(st.integers(0, 4 * ELEMENTS_PER_BLOCK), max_size=12), st.integers(0, 9))
def test_blocks_part_the_segments(counts, gap):
    firsts = np.concatenate([[0], np.cumsum(np.array(counts, int) + gap)[:-1]]).astype(int)[: len(counts)]
    blocks = SegmentBlocks(firsts, counts, "cpu")
    begin, end, owners = (a.numpy() for a in (blocks.firsts, blocks.lasts, blocks.owners))
    starts = blocks.starts.numpy()
    assert blocks.count == len(begin) == starts[-1] and ((end - begin >= 0) & (end - begin <= ELEMENTS_PER_BLOCK)).all()
    for segment, (first, count) in enumerate(zip(firsts, counts, strict=True)):
        rows = slice(starts[segment], starts[segment + 1])
        assert (owners[rows] == segment).all()
        begins, ends = begin[rows].tolist(), end[rows].tolist()
        assert [*begins, first + count] == [first, *ends]
    assert blocks.element_count == max([f + c for f, c in zip(firsts, counts, strict=True)], default=0)


def test_each_segment_has_its_sum(device, rng, tolerances):
    firsts = np.concatenate([[0], np.cumsum(np.array(SIZES) + 3)[:-1]])  # gaps that belong to none
    values = rng.normal(size=firsts[-1] + SIZES[-1] + 10)
    result = sums_of(device, values, firsts, SIZES)
    for (first, count), sums in zip(zip(firsts, SIZES, strict=True), result, strict=True):
        part = values[first : first + count]
        np.testing.assert_allclose(sums, [part.sum(), (part**2).sum()], atol=tolerances.segment_sum * max(count, 1))
    assert (result[np.array(SIZES) == 0] == 0).all()


@pytest.mark.parametrize(
    ("length", "kind"), [(1, float32), (3, int64), (31, float64), (32, float32), (33, int32), (70, float64)]
)
def test_sums_of_vectors_of_any_length_are_exact_for_small_integers(device, write_kernels, length, kind):
    name = f"sums_of_{length}_{kind.__name__}"
    kernels = write_kernels(name, VECTORS.format(length=length, kind=kind.__name__))
    counts = [ELEMENTS_PER_BLOCK * 9 + 1, 1, 70 * ELEMENTS_PER_BLOCK]
    values, blocks = np.arange(sum(counts)) % 7, SegmentBlocks(np.cumsum([0, *counts[:-1]]), counts, device)
    given, live = upload(values, int32, device), full(len(counts), 1, int32, device)
    partials, out = blocks.partials(kernels.numbers), zeros(len(counts), kernels.numbers, device)
    ends, factors = np.cumsum(counts), np.arange(length) % 5 + 1
    expected = [values[end - count : end].sum() * factors for count, end in zip(counts, ends, strict=True)]
    for _ in range(2):  # with the same scratch
        lang.reduce_segments(kernels.sum_multiples, blocks, live, [given], partials, out)
        np.testing.assert_array_equal(download(out).reshape(3, -1), expected)
    total = download(lang.reduce(kernels.sum_all_multiples, len(values), [given]))
    np.testing.assert_array_equal(total.reshape(-1), values.sum() * factors)


def test_a_segment_alone_is_bitwise_identical(device, rng):
    values = rng.normal(size=sum(SIZES))
    together = sums_of(device, values, FIRSTS, SIZES)
    for first, count, sums in zip(FIRSTS, SIZES, together, strict=True):
        np.testing.assert_array_equal(sums_of(device, values[first : first + count], [0], [count])[0], sums)


def test_inactive_segments_are_skipped_and_change_no_others(device, rng):
    values, live = rng.normal(size=sum(SIZES)), [1, 0, 1, 0, 1, 0, 1, 0, 1, 1]
    all_sums = sums_of(device, values, FIRSTS, SIZES)
    spoiled = values.copy()
    for first, count, alive in zip(FIRSTS, SIZES, live, strict=True):
        spoiled[first : first + count] = spoiled[first : first + count] if alive else np.nan
    result = sums_of(device, spoiled, FIRSTS, SIZES, live)
    alive = np.array(live) == 1
    np.testing.assert_array_equal(result[alive], all_sums[alive])


def test_sums_in_several_launches_are_those_of_one(device, rng, monkeypatch):
    values = rng.normal(size=sum(SIZES))
    at_once = sums_of(device, values, FIRSTS, SIZES)
    monkeypatch.setattr(segment_launches, "MAX_BLOCKS", 3)
    np.testing.assert_array_equal(sums_of(device, values, FIRSTS, SIZES), at_once)


@pytest.mark.parametrize("runs", [2, 5])
def test_a_cached_loop_reruns_without_calling_its_body(device, runs):
    left, running = upload(np.array([0]), int32, device), upload(np.array([0]), int32, device)
    calls = []

    def body():
        calls.append(None)
        launch(count_down_kernel, 1, [left, running])

    loop = lang.DeviceLoop(running, body)
    for iterations in range(1, runs + 1):
        left.fill_(iterations)
        running.fill_(1)
        loop.run()
        assert running.numpy()[0] == 0 and left.numpy()[0] == 0
    assert len(calls) == 1


def test_dropping_a_cached_loop_leaves_others_unchanged(device):
    arrays = [[full(1, 3, int32, device), full(1, 1, int32, device)] for _ in range(2)]
    loops = [lang.DeviceLoop(a[1], lambda a=a: launch(count_down_kernel, 1, a)) for a in arrays]
    loops[0].run()
    del loops[0]
    loops[0].run()
    assert [running.numpy()[0] for _, running in arrays] == [0, 0]


def test_a_loop_among_other_launches_is_a_part_of_their_recording(device):
    left, running, before, after = (zeros(1, int32, device) for _ in range(4))

    def body():
        fill(left, 5)
        fill(running, 1)
        copy(before, left, count=1)
        lang.loop_while(running, lambda: launch(count_down_kernel, 1, [left, running]))
        copy(after, left, count=1)

    recorded = lang.record(left.device, body) if left.device.is_cuda else None
    for _ in range(3):
        fill(after, 9)
        body() if recorded is None else lang.replay(recorded)
        assert (before.numpy()[0], after.numpy()[0]) == (5, 0)


def test_a_loop_that_fails_leaves_launches_as_they_were(device):
    left, running = upload(np.array([2]), int32, device), upload(np.array([1]), int32, device)

    def fail():
        raise RuntimeError("on purpose")

    with pytest.raises(RuntimeError, match="on purpose"):
        lang.loop_while(running, fail)
    lang.loop_while(running, lambda: launch(count_down_kernel, 1, [left, running]))
    assert running.numpy()[0] == 0


def test_a_loop_with_nothing_to_do_does_nothing(device):
    left = full(1, 7, int32, device)
    running = zeros(1, int32, device)
    lang.loop_while(running, lambda: launch(count_down_kernel, 1, [left, running]))
    assert left.numpy()[0] == 7


@kernel
def wait_some_rounds_kernel(rows: array(dtype=int32), left: array(dtype=int32), open_rows: array(dtype=uint8)):
    i = tid()
    left[rows[i]] = left[rows[i]] - 1
    open_rows[i] = uint8(1 if left[rows[i]] > 0 else 0)


@pytest.mark.parametrize("max_rounds", [1, 3, 5, MAX_ROUNDS, MAX_ROUNDS + 3])
def test_remaining_rows_are_those_that_need_more_rounds(device, rng, max_rounds):
    round_counts = rng.integers(1, max_rounds + 1, 200)
    round_counts[17] = max_rounds
    warp_device, sizes = resolve_device(device), []
    left = upload(round_counts, int32, warp_device)

    def attempt(rows, open_rows):
        sizes.append(rows.size)
        launch(wait_some_rounds_kernel, rows.size, [rows, left, open_rows])

    remaining = resolve_in_rounds(attempt, len(round_counts), warp_device)
    assert download(remaining).tolist() == np.flatnonzero(round_counts > MAX_ROUNDS).tolist()
    looks = range(1, MAX_ROUNDS + 1) if warp_device.is_cpu else CHECKED_ROUNDS
    assert len(sizes) == next(look for look in looks if look >= min(max_rounds, MAX_ROUNDS))
    assert sizes[0] == 200 and sizes[-1] == (round_counts > max([0, *(n for n in looks if n < len(sizes))])).sum()
