"""A recording that ends early leaves nothing behind: the next one, and all other work, goes on."""

import threading

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import int32, launch, loop_while
from pointloom.kernels.language import device_lock
from pointloom.kernels.memory import download, upload

SOURCE = """
@kernel
def count_down_kernel(left: array(dtype=int32), turns: array(dtype=int32)):
    i = tid()
    left[i] = left[i] - 1
    turns[i] = turns[i] + 1
"""


class Stop(BaseException):
    """What is no Exception, as KeyboardInterrupt."""


@pytest.fixture(scope="module")
def kernel(emulated, write_kernels):
    return write_kernels("counting_down", SOURCE).count_down_kernel


def counters():
    """The number of iterations left and that of those done."""
    return [upload(np.array([n], np.int32), int32, resolve_device("cuda:0")) for n in (5, 0)]


def count_iterations(kernel) -> int:
    left, iterations = counters()
    loop_while(left, lambda: launch(kernel, 1, [left, iterations]))
    return int(download(iterations)[0])


@pytest.mark.parametrize("error", [ValueError, MemoryError, KeyboardInterrupt, SystemExit, Stop])
@pytest.mark.parametrize("after", [0, 1])
def test_a_recording_works_after_any_interrupted_one(emulated, kernel, error, after):
    left, iterations = counters()

    def body():
        for _ in range(after):
            launch(kernel, 1, [left, iterations])
        raise error("in the body")

    for _ in range(2):
        with pytest.raises(error, match="in the body") as raised:
            loop_while(left, body)
        assert raised.value.__cause__ is None
    assert emulated.streams.captures == 0
    assert download(iterations).tolist() == [0], "nothing of it was launched"
    assert count_iterations(kernel) == 5


def test_another_thread_works_after_a_recording_was_interrupted(emulated, kernel):
    def body():
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        loop_while(counters()[0], body)
    results = []
    thread = threading.Thread(target=lambda: results.append(count_iterations(kernel)))
    thread.start()
    thread.join(timeout=60)
    assert results == [5]
    assert device_lock.lock.acquire(blocking=False)
    device_lock.lock.release()
