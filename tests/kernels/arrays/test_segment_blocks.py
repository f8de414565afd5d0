"""Sums over many segments in two launches: right at every size, blind to the dead, the same bits as each alone."""

from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom.kernels import lang
from pointloom.kernels.arrays.segment_blocks import SegmentBlocks
from pointloom.kernels.lang import BLOCK, array, atomic_add, float64, int32, kernel, launch, tid
from pointloom.kernels.language import segment_launches
from pointloom.kernels.memory import empty, full, upload, zeros

pair = lang.vector(2, float64)
SIZES = [0, 1, 2, 7, BLOCK - 1, BLOCK, BLOCK + 1, 0, 3 * BLOCK + 5, 0]


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


def sums_of(device, values, firsts, counts, live=None, start=None):
    blocks = SegmentBlocks(firsts, counts, device)
    alive = full(len(counts), 1, int32, device) if live is None else upload(np.array(live), int32, device)
    partials = empty(max(1, blocks.count), pair, device)
    out = zeros(len(counts), pair, device) if start is None else upload(start, pair, device)
    lang.reduce_segments(sum_powers, blocks, alive, [upload(values, float64, device)], partials, out)
    return out.numpy().copy()


@given(st.lists(st.integers(0, 4 * BLOCK), max_size=12), st.integers(0, 9))
def test_blocks_part_the_segments(counts, gap):
    firsts = np.concatenate([[0], np.cumsum(np.array(counts, int) + gap)[:-1]]).astype(int)[: len(counts)]
    blocks = SegmentBlocks(firsts, counts, "cpu")
    begin, end, owners = (a.numpy() for a in (blocks.firsts, blocks.lasts, blocks.owners))
    starts = blocks.starts.numpy()
    assert blocks.count == len(begin) == starts[-1]
    assert ((end - begin > 0) & (end - begin <= BLOCK)).all()
    for segment, (first, count) in enumerate(zip(firsts, counts, strict=True)):
        rows = slice(starts[segment], starts[segment + 1])
        assert (owners[rows] == segment).all()
        begins, ends = begin[rows].tolist(), end[rows].tolist()
        assert [*begins, first + count] == [first, *ends] if count else not begins
    assert blocks.element_count == max([f + c for f, c in zip(firsts, counts, strict=True)], default=0)


def test_each_segment_has_its_sum(device, rng, tolerances):
    firsts = np.concatenate([[0], np.cumsum(np.array(SIZES) + 3)[:-1]])  # gaps that belong to none
    values = rng.normal(size=firsts[-1] + SIZES[-1] + 10)
    result = sums_of(device, values, firsts, SIZES)
    for (first, count), sums in zip(zip(firsts, SIZES, strict=True), result, strict=True):
        part = values[first : first + count]
        np.testing.assert_allclose(sums, [part.sum(), (part**2).sum()], atol=tolerances.segment_sum * max(count, 1))
    assert (result[np.array(SIZES) == 0] == 0).all()


def test_a_segment_alone_is_bitwise_identical(device, rng):
    values = rng.normal(size=sum(SIZES))
    firsts = np.concatenate([[0], np.cumsum(SIZES)[:-1]])
    together = sums_of(device, values, firsts, SIZES)
    for first, count, sums in zip(firsts, SIZES, together, strict=True):
        np.testing.assert_array_equal(sums_of(device, values[first : first + count], [0], [count])[0], sums)


def test_inactive_segments_are_skipped_and_change_no_others(device, rng):
    values, live = rng.normal(size=sum(SIZES)), [1, 0, 1, 0, 1, 0, 1, 0, 1, 1]
    firsts = np.concatenate([[0], np.cumsum(SIZES)[:-1]])
    all_sums = sums_of(device, values, firsts, SIZES)
    spoiled = values.copy()
    for first, count, alive in zip(firsts, SIZES, live, strict=True):
        spoiled[first : first + count] = spoiled[first : first + count] if alive else np.nan
    result = sums_of(device, spoiled, firsts, SIZES, live)
    alive = np.array(live) == 1
    np.testing.assert_array_equal(result[alive], all_sums[alive])


def test_sums_in_several_launches_are_those_of_one(device, rng, monkeypatch):
    values, firsts = rng.normal(size=sum(SIZES)), np.concatenate([[0], np.cumsum(SIZES)[:-1]])
    at_once = sums_of(device, values, firsts, SIZES)
    monkeypatch.setattr(segment_launches, "MAX_THREADS", 3 * 256 + 255)
    np.testing.assert_array_equal(sums_of(device, values, firsts, SIZES), at_once)


def test_more_segments_than_threads_can_be_numbered_for_are_parted():
    """Nine million segments of one block each would be 2.3e9 threads on CUDA; none of these arrays has memory."""
    count, launches = 9_000_000, []

    def unread(size, dtype):
        return wp.array(ptr=4096, dtype=dtype, shape=(size,), device="cpu", copy=False)

    def note(name, threads, arguments, device, block_dim):
        launches.append((name, threads, [(a.ptr - 4096) // wp.types.type_size_in_bytes(a.dtype) for a in arguments]))
        assert block_dim == 256 and {a.size for a in arguments} <= {threads // 256, threads // 256 + 1, count}

    kernels = SimpleNamespace(tiles="tiles", fold_tiles="fold")
    tables = [unread(count, int32) for _ in range(3)]
    blocks = SimpleNamespace(firsts=tables[0], lasts=tables[1], owners=tables[2], starts=unread(count + 1, int32))
    blocks.count = count
    live, partials, out = unread(count, int32), unread(count, pair), unread(count, pair)
    segment_launches.launch_segments(note, kernels, [], blocks, live, partials, out)  # type: ignore[arg-type]
    max_segments = 2**31 // 256 - 1
    rest = count - max_segments
    assert launches == [
        ("tiles", max_segments * 256, [0, 0, 0, 0, 0]),
        ("tiles", rest * 256, [max_segments, max_segments, max_segments, 0, max_segments]),
        ("fold", max_segments * 256, [0, 0, 0, 0]),
        ("fold", rest * 256, [max_segments, max_segments, 0, max_segments]),
    ]


@settings(max_examples=25, deadline=None)
@given(st.lists(st.integers(0, 50), min_size=1, max_size=300))
def test_many_small_segments_have_their_sums(counts):
    values = np.arange(1.0, sum(counts) + 1)  # whole numbers: sums are exact
    firsts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    expected = [[values[f : f + c].sum(), (values[f : f + c] ** 2).sum()] for f, c in zip(firsts, counts, strict=True)]
    np.testing.assert_array_equal(sums_of("cpu", np.append(values, 0.0), firsts, counts), expected)


@pytest.mark.parametrize("iterations", [[3], [1, 5, 2, 2], [1]])
def test_a_loop_runs_until_the_last_is_done(device, iterations):
    left, running = (upload(np.array(iterations), int32, device), upload(np.array([len(iterations)]), int32, device))
    calls = []

    def body():
        calls.append(None)
        launch(count_down_kernel, len(iterations), [left, running])

    lang.loop_while(running, body)
    assert running.numpy()[0] == 0 and not left.numpy().any()
    assert len(calls) == 1  # the body is recorded, and its launches are made again


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
