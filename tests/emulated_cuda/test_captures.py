"""Captures, graphs and conditional nodes: what runs when, and what CUDA refuses in them."""

import numpy as np
import pytest
import warp as wp

DEVICE = "cuda:0"


@wp.kernel(enable_backward=False)
def count_down_kernel(flag: wp.array(dtype=int), iterations: wp.array(dtype=int)):
    iterations[0] = iterations[0] + 1
    flag[0] = flag[0] - 1


@wp.kernel(enable_backward=False)
def add_kernel(a: wp.array(dtype=int), number: int):
    i = wp.tid()
    a[i] = a[i] + number


def test_a_capture_runs_nothing_and_its_graph_runs_as_often_as_it_is_launched():
    a = wp.zeros(4, dtype=int, device=DEVICE)
    with wp.ScopedCapture(DEVICE) as capture:
        wp.launch(add_kernel, 4, [a, 3], device=DEVICE)
    assert a.numpy()[0] == 0
    for _ in range(2):
        wp.capture_launch(capture.graph)
    np.testing.assert_array_equal(a.numpy(), 6)


def test_a_loop_runs_until_the_device_ends_it():
    flag, iterations = wp.array([5], dtype=int, device=DEVICE), wp.zeros(1, dtype=int, device=DEVICE)
    with wp.ScopedCapture(DEVICE) as capture:
        wp.capture_while(flag, lambda: wp.launch(count_down_kernel, 1, [flag, iterations], device=DEVICE))
    for _ in range(2):  # the second time it has nothing to do
        wp.capture_launch(capture.graph)
        assert (iterations.numpy()[0], flag.numpy()[0]) == (5, 0)


@pytest.mark.parametrize("value", [0, 1])
def test_a_branch_is_chosen_by_the_device(value):
    flag, a = wp.array([value], dtype=int, device=DEVICE), wp.zeros(1, dtype=int, device=DEVICE)
    with wp.ScopedCapture(DEVICE) as capture:
        wp.capture_if(
            flag,
            on_true=lambda: wp.launch(add_kernel, 1, [a, 10], device=DEVICE),
            on_false=lambda: wp.launch(add_kernel, 1, [a, 20], device=DEVICE),
        )
    wp.capture_launch(capture.graph)
    assert a.numpy()[0] == (10 if value else 20)


@pytest.mark.parametrize(
    ("what", "message"),
    [
        (lambda a: a.numpy(), "legacy stream depend|pageable host memory in a capture"),
        (lambda a: wp.synchronize(), "Cannot synchronize device"),
        (lambda a: wp.synchronize_stream(DEVICE), "Cannot synchronize stream"),
    ],
    ids=["download", "wait for the device", "wait for the stream"],
)
def test_a_capture_allows_no_wait(emulated, what, message):
    a = wp.zeros(1, dtype=int, device=DEVICE)
    wp.synchronize()
    with emulated.findings.expected(), pytest.raises(RuntimeError, match=message), wp.ScopedCapture(DEVICE):
        what(a)
    assert not emulated.streams.captures
    np.testing.assert_array_equal(a.numpy(), 0)


def test_a_loop_allocates_nothing(emulated):
    flag = wp.array([1], dtype=int, device=DEVICE)
    refused = pytest.raises(RuntimeError, match=r"unsupported operation .memory allocation")
    with emulated.findings.expected(), refused, wp.ScopedCapture(DEVICE):
        wp.capture_while(flag, lambda: wp.zeros(4, dtype=int, device=DEVICE))


def test_an_endless_loop_is_a_fault(emulated, monkeypatch):
    monkeypatch.setattr("tests.emulated_cuda.graphs.ENDLESS", 100)
    flag, a = wp.array([1], dtype=int, device=DEVICE), wp.zeros(1, dtype=int, device=DEVICE)
    with wp.ScopedCapture(DEVICE) as capture:
        wp.capture_while(flag, lambda: wp.launch(add_kernel, 1, [a, 1], device=DEVICE))
    with emulated.findings.expected(), pytest.raises(RuntimeError, match="a captured loop of more than"):
        wp.capture_launch(capture.graph)
        wp.synchronize()


def test_an_array_of_a_graph_is_fresh_in_each_launch():
    out = wp.zeros(4, dtype=int, device=DEVICE)
    with wp.ScopedCapture(DEVICE) as capture:
        a = wp.empty(4, dtype=int, device=DEVICE)
        wp.copy(out, a)
        wp.launch(add_kernel, 4, [a, 1], device=DEVICE)
    for _ in range(2):
        wp.capture_launch(capture.graph)
        assert (out.numpy().view(np.uint32) == 0xCBCBCBCB).all()


def test_arrays_dropped_while_capturing_are_released_afterwards(emulated):
    array, dropped = (wp.zeros(4, dtype=int, device=DEVICE) for _ in range(2))
    address = dropped.ptr
    wp.synchronize()  # so that nothing else puts the release off
    with wp.ScopedCapture(DEVICE):
        del dropped
        wp.launch(add_kernel, 4, [array, 1], device=DEVICE)
        assert address in emulated.memory.live
    wp.synchronize()
    assert address not in emulated.memory.live
