"""CUDA's legacy stream, torch's default one: others work on it while we record, and releases wait where it does not."""

import contextlib
import ctypes
import threading

import numpy as np
import pytest
import warp as wp

from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import float32, int32, launch, loop_while, record, replay
from pointloom.kernels.language import device_lock
from pointloom.kernels.language.streams import NonBlockingStream
from pointloom.kernels.memory import download, fill, upload, zeros

from .driver import INVALID_HANDLE, INVALID_VALUE

SOURCE = """
@kernel
def take_away_kernel(left: array(dtype=int32)):
    i = tid()
    left[i] = left[i] - 1
"""


@pytest.fixture(scope="module")
def kernel(emulated, write_kernels):
    return write_kernels("taking_away", SOURCE).take_away_kernel


@pytest.fixture
def gpu(emulated):
    return resolve_device("cuda:0")


class OtherLibrary:
    """What `tensor.zero_()` of torch on its default stream comes to."""

    def __init__(self, device) -> None:
        self.device, self.array, self.errors = device, zeros(256, float32, device), []

    def work(self) -> None:
        try:
            wp._src.context.runtime.core.wp_memset_device(self.device.context, self.array.ptr, 0, 1024, 0)
        except Exception as error:
            self.errors.append(error)

    def work_in_a_thread(self) -> None:
        thread = threading.Thread(target=self.work)
        thread.start()
        thread.join(timeout=60)


def test_another_library_works_on_its_default_stream_while_we_record(gpu):
    other_library, array = OtherLibrary(gpu), zeros(256, float32, gpu)

    def body():
        fill(array, 1)
        other_library.work_in_a_thread()
        fill(array, 2)

    replay(record(gpu, body))
    assert other_library.errors == []
    assert (download(array) == 2).all()


def test_another_library_works_and_arrays_are_created_while_we_record_a_loop(gpu, kernel):
    other_library, left, created = OtherLibrary(gpu), upload(np.array([3], np.int32), int32, gpu), []

    def body():
        other_library.work_in_a_thread()
        created.append(zeros(0, int32, gpu))
        launch(kernel, 1, [left])

    loop_while(left, body)
    assert other_library.errors == []
    assert download(left)[0] == 0 and len(created) == 1


def test_arrays_are_created_on_a_stream_of_the_caller_that_is_recorded(gpu, chosen, kernel):
    left = upload(np.array([3], np.int32), int32, gpu)
    launch(kernel, 1, [left])
    wp.synchronize_device(gpu)
    with wp.ScopedStream(chosen, sync_enter=False), wp.ScopedCapture(stream=chosen) as capture:
        zeros(0, int32, gpu)
        launch(kernel, 1, [left])
    wp.capture_launch(capture.graph, stream=chosen)
    wp.synchronize_stream(chosen)
    assert download(left)[0] == 1


def test_a_blocking_stream_that_records_would_refuse_the_other_library(emulated, gpu):
    other_library = OtherLibrary(gpu)
    with emulated.findings.expected(), wp.ScopedCapture(stream=wp.Stream(gpu)):
        other_library.work_in_a_thread()
    assert "depend on a capturing blocking stream" in str(other_library.errors[0])


def test_a_stream_that_does_not_block_is_not_waited_for_by_the_legacy_stream(gpu, chosen, kernel):
    assert not chosen.is_blocking and wp.Stream(gpu).is_blocking
    values, host = upload(np.zeros(4, np.int32), int32, gpu), wp.empty(4, dtype=wp.int32, device="cpu", pinned=True)
    wp.synchronize_device(gpu)
    with wp.ScopedStream(chosen):
        launch(kernel, 4, [values])
    core = wp._src.context.runtime.core
    core.wp_memcpy_d2h(gpu.context, host.ptr, values.ptr, 16, 0)
    assert host.numpy().tolist() == [0] * 4
    wp.synchronize_stream(chosen)
    core.wp_memcpy_d2h(gpu.context, host.ptr, values.ptr, 16, 0)
    assert host.numpy().tolist() == [-1] * 4


def test_the_driver_stream_is_destroyed_with_its_object(emulated, gpu):
    stream = NonBlockingStream(gpu)
    handle, driver = stream.cuda_stream, emulated.driver
    assert handle in emulated.streams.streams
    del stream
    assert handle not in emulated.streams.streams
    with gpu.context_guard:
        assert driver.cuStreamCreate(ctypes.byref(ctypes.c_void_p()), ctypes.c_uint(7)) == INVALID_VALUE
        assert driver.cuStreamDestroy_v2(ctypes.c_void_p(handle)) == INVALID_HANDLE


def test_a_driver_that_makes_no_stream_is_an_error_of_its_own(emulated, gpu, monkeypatch):
    monkeypatch.setattr(emulated.driver, "cuStreamCreate", lambda *_: 2, raising=False)
    monkeypatch.setattr(device_lock, "_recording_streams", {})
    with pytest.raises(RuntimeError, match=r"cuda:0: the driver makes no stream \(CUDA error 2\)"):
        record(gpu, lambda: None)


@pytest.mark.parametrize("is_its_own", [True, False])
def test_memory_is_released_behind_work_on_a_stream_that_does_not_block(emulated, gpu, chosen, kernel, is_its_own):
    """Of an array made on this stream and dropped elsewhere, and of another one that is dropped on the stream."""
    with wp.ScopedStream(chosen) if is_its_own else contextlib.nullcontext():
        values = upload(np.zeros(64, np.int32), int32, gpu)
        if not is_its_own:
            wp.synchronize_device(gpu)
    with wp.ScopedStream(chosen):
        launch(kernel, 64, [values])
    with contextlib.nullcontext() if is_its_own else wp.ScopedStream(chosen):
        address = values.ptr
        del values
        assert address in emulated.memory.live  # what the legacy stream alone would wait for has run
    wp.synchronize_device(gpu)
    assert address not in emulated.memory.live


def test_a_stream_destroyed_before_the_release_is_not_used_again(emulated, gpu, kernel):
    foreign = NonBlockingStream(gpu)
    with wp.ScopedStream(wp.Stream(gpu, cuda_stream=foreign.cuda_stream)):
        values = upload(np.zeros(64, np.int32), int32, gpu)
        launch(kernel, 64, [values])
    del foreign
    address = values.ptr
    del values
    wp.synchronize_device(gpu)
    assert address not in emulated.memory.live
