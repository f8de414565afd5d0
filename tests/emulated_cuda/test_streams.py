"""Work runs when something waits for it, and not before."""

import numpy as np
import pytest
import warp as wp

DEVICE = "cuda:0"


@wp.kernel(enable_backward=False)
def number_kernel(a: wp.array(dtype=int)):
    i = wp.tid()
    a[i] = i


def test_a_launch_runs_when_something_waits(emulated):
    a = wp.zeros(4, dtype=int, device=DEVICE)
    known = emulated.findings.counts["launches"]
    wp.launch(number_kernel, 4, [a], device=DEVICE)
    assert emulated.findings.counts["launches"] == known
    wp.synchronize()
    assert emulated.findings.counts["launches"] == known + 1


def test_without_delay_it_runs_at_once(emulated, settings):
    settings(lazy=False)
    a = wp.zeros(4, dtype=int, device=DEVICE)
    known = emulated.findings.counts["launches"]
    wp.launch(number_kernel, 4, [a], device=DEVICE)
    assert emulated.findings.counts["launches"] == known + 1


def test_pageable_memory_is_read_at_the_call_and_pinned_memory_afterwards():
    pageable, pinned = np.ones(1, np.int32), wp.empty(1, dtype=int, device="cpu", pinned=True)
    pinned.numpy()[0] = 1
    on_device = [wp.empty(1, dtype=int, device=DEVICE) for _ in range(2)]
    wp.copy(on_device[0], wp.array(pageable, dtype=int, device="cpu", copy=False))
    wp.copy(on_device[1], pinned)
    pageable[0] = pinned.numpy()[0] = 2
    assert [a.numpy()[0] for a in on_device] == [1, 2]


def test_a_missing_wait_shows_in_a_pinned_download():
    a, host = wp.zeros(4, dtype=int, device=DEVICE), wp.empty(4, dtype=int, device="cpu", pinned=True)
    wp.launch(number_kernel, 4, [a], device=DEVICE)
    wp.copy(host, a)
    assert (host.numpy().view(np.uint32) == 0xCBCBCBCB).all()
    wp.synchronize()
    np.testing.assert_array_equal(host.numpy(), range(4))


def test_a_missing_wait_between_streams_is_detected_and_an_event_fixes_it():
    host = wp.empty(4, dtype=int, device="cpu", pinned=True)
    first, second = wp.Stream(DEVICE), wp.Stream(DEVICE)
    a = wp.zeros(4, dtype=int, device=DEVICE)
    wp.synchronize()
    wp.launch(number_kernel, 4, [a], stream=first)
    wp.copy(host, a, stream=second)
    wp.synchronize_stream(second)
    np.testing.assert_array_equal(host.numpy(), 0)
    second.wait_event(first.record_event())
    wp.copy(host, a, stream=second)
    wp.synchronize_stream(second)
    np.testing.assert_array_equal(host.numpy(), range(4))


def test_a_download_waits_for_earlier_launches_and_an_array_lives_until_they_have_run():
    out, a = (wp.zeros(4, dtype=int, device=DEVICE) for _ in range(2))
    wp.launch(number_kernel, 4, [a], device=DEVICE)
    wp.copy(out, a)
    del a
    np.testing.assert_array_equal(out.numpy(), range(4))


def test_repeated_queries_make_progress(emulated):
    a = wp.zeros(4, dtype=int, device=DEVICE)
    wp.launch(number_kernel, 4, [a], device=DEVICE)
    event = wp.get_stream(DEVICE).record_event()
    assert not wp.is_event_complete(event) if hasattr(wp, "is_event_complete") else not event.is_complete
    wp.synchronize_event(event)
    assert event.is_complete


@pytest.mark.parametrize("name", ["int", "float"])
def test_scan_and_sort_of_warp_exist(name):
    dtype = {"int": wp.int32, "float": wp.float32}[name]
    given = np.random.default_rng(0).permutation(100).astype(name + "32")
    keys, values = wp.zeros(200, dtype=dtype, device=DEVICE), wp.zeros(200, dtype=wp.int32, device=DEVICE)
    wp.copy(keys, wp.array(given, dtype=dtype, device=DEVICE), count=100)
    wp.copy(values, wp.array(np.arange(100, dtype=np.int32), device=DEVICE), count=100)
    wp.utils.radix_sort_pairs(keys, values, 100)
    np.testing.assert_array_equal(values.numpy()[:100], np.argsort(given))
    sums = wp.zeros(100, dtype=dtype, device=DEVICE)
    wp.utils.array_scan(wp.array(given, dtype=dtype, device=DEVICE), sums, inclusive=True)
    np.testing.assert_array_equal(sums.numpy(), np.cumsum(given))


def test_strided_and_indexed_copies_stay_in_their_arrays():
    a = wp.array(np.arange(24, dtype=np.float32).reshape(4, 6), device=DEVICE)
    np.testing.assert_array_equal(a[1:3, 2].numpy(), [8, 14])
    rows = a[wp.array([3, 0], dtype=wp.int32, device=DEVICE)]
    np.testing.assert_array_equal(rows.numpy(), a.numpy()[[3, 0]])
