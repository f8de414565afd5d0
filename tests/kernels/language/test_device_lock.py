"""The lock around the work of a device: releases that come in the midst of it wait their turn."""

import contextlib
import gc
import threading
from types import SimpleNamespace

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import int32
from pointloom.kernels.language import device_lock
from pointloom.kernels.language.lazy_property import once
from pointloom.kernels.memory import cast, clone, contiguous, download, empty, fill, host_view, move, upload

pytestmark = pytest.mark.both_compilers


def device_array(released):
    stream = SimpleNamespace(is_blocking=True)
    device = SimpleNamespace(is_cuda=True, is_cpu=False, context_guard=contextlib.nullcontext(), stream=stream)
    return SimpleNamespace(device=device, deleter=lambda address, size: released.append((address, size)))


def in_another_thread(action):
    thread = threading.Thread(target=action)
    thread.start()
    thread.join(timeout=60)
    assert not thread.is_alive(), "it waited for the lock"


def test_an_array_is_released_at_once_also_by_the_thread_that_has_the_lock():
    released = []
    first, second = (device_lock.own(device_array(released)) for _ in range(2))
    first.deleter(4096, 12)
    assert released == [(4096, 12)]
    with device_lock.lock:
        second.deleter(1, 10)
        assert released[1:] == [(1, 10)]


def test_an_array_dropped_while_another_thread_works_is_released_when_one_is_dropped_or_made():
    released = []
    first, second, third = (device_lock.own(device_array(released)) for _ in range(3))
    with device_lock.lock:
        in_another_thread(lambda: first.deleter(1, 10))
        assert released == []
    second.deleter(2, 20)
    assert released == [(1, 10), (2, 20)]
    with device_lock.lock:
        in_another_thread(lambda: third.deleter(3, 30))
    device_lock.own(device_array(released))
    assert released[2:] == [(3, 30)]


def test_the_host_has_nothing_to_wait_for():
    with device_lock.lock:
        in_another_thread(lambda: upload(np.arange(3), int32, resolve_device("cpu")))


def test_arrays_are_filled_cloned_cast_and_moved(device, rng):
    warp_device = resolve_device(device)
    values = rng.integers(0, 100, 20).astype(np.int32)
    array = upload(values, int32, warp_device)
    copied, gaps = clone(array), array[::3]
    fill(array, 7)
    np.testing.assert_array_equal(download(array), np.full(20, 7))
    np.testing.assert_array_equal(download(copied), values)
    fill(gaps, 1)
    np.testing.assert_array_equal(download(contiguous(gaps)), np.ones(7))
    np.testing.assert_array_equal(download(gaps), np.ones(7))
    np.testing.assert_array_equal(download(array)[:4], [1, 7, 7, 1])
    assert contiguous(array) is array and move(array, warp_device) is array
    moved = move(copied, resolve_device("cpu"))
    host_view(moved)[0] = -5
    np.testing.assert_array_equal(download(moved), [-5, *values[1:]])
    assert download(cast(copied, int32)).dtype == np.int32
    assert download(empty((0, 3), int32, warp_device)).shape == (0, 3)


@pytest.mark.parametrize("is_on", [True, False])
def test_garbage_collection_is_paused_during_a_lazy_property_alone(is_on):
    class Table:
        @once
        def is_collected(self):
            return gc.isenabled()

    (gc.enable if is_on else gc.disable)()
    try:
        assert not Table().is_collected and gc.isenabled() == is_on
    finally:
        gc.enable()
