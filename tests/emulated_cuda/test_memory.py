"""Memory that a CUDA device would refuse, or get wrong without a word."""

import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import warp as wp

from .findings import UNWRITTEN, CudaFault

DEVICE = "cuda:0"
LOAD_AT = """
.visible .entry k(.param .u64 a, .param .u64 out)
{{
    .reg .b64 %rd<9>; .reg .b32 %r<9>;
    ld.param.u64 %rd1, [a];
    ld.param.u64 %rd2, [out];
    ld.global.{kind} %{register}, [%rd1+{offset}];
    st.global.{kind} [%rd2], %{register};
    ret;
}}
"""
HOST_READS = """
import sys
sys.path.insert(0, sys.argv[1])
from emulated_cuda.install import install
install()
import ctypes
import warp as wp
wp.config.quiet = True
a = wp.zeros(4, dtype=float, device="cuda:0")
wp.synchronize()
print("made", flush=True)
ctypes.cast(a.ptr, ctypes.POINTER(ctypes.c_float))[0]
"""


@wp.kernel(enable_backward=False)
def read_next_kernel(a: wp.array(dtype=float), out: wp.array(dtype=float)):
    i = wp.tid()
    out[i] = a[i + 1]


@wp.kernel(enable_backward=False)
def copy_kernel(a: wp.array(dtype=float), out: wp.array(dtype=float)):
    i = wp.tid()
    out[i] = a[i]


@pytest.fixture
def load_at(programs):
    """A function (array, kind of PTX, offset): a launch whose one thread reads there."""

    out = wp.zeros(8, dtype=int, device=DEVICE)

    def load(a, kind: str = "u32", offset: int = 0) -> None:
        text = LOAD_AT.format(kind=kind, register="rd3" if kind == "u64" else "r1", offset=offset)
        programs.launch(text, [a, out], threads=1, block=1)

    return load


@pytest.fixture
def refused(emulated):
    """A function (pattern, action): the completed action must fail with a matching fault."""

    def check(pattern: str, action) -> None:
        with emulated.findings.expected(), pytest.raises(CudaFault, match=pattern):
            action()
            wp.synchronize()

    return check


def test_a_host_that_follows_a_device_pointer_dies():
    command = [sys.executable, "-c", HOST_READS, str(Path(__file__).parents[1])]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.stdout.endswith("made\n"), done.stderr
    assert done.returncode == -signal.SIGSEGV


@pytest.mark.parametrize("order", [0, 1, 2, 3])
def test_an_element_behind_the_end_is_a_fault_that_names_kernel_array_thread_and_caller(refused, settings, order):
    settings(order=order)
    a, out = (wp.zeros(256, dtype=float, device=DEVICE) for _ in range(2))
    message = (
        r"read_next_kernel: address outside any live array .*read of 4 bytes .*byte 1024 of an array of 1024 bytes "
        r"\(.*test_memory.*\), block \(0, 0, 0\), thread \(255, 0, 0\); launched by .*test_memory"
    )
    refused(message, lambda: wp.launch(read_next_kernel, 256, [a, out], device=DEVICE))


@pytest.mark.parametrize(("size", "offset", "is_inside"), [(7, 6, True), (7, 7, False), (8, 7, True), (13, 13, False)])
def test_one_byte_outside_is_outside(load_at, refused, size, offset, is_inside):
    a = wp.zeros(size, dtype=wp.uint8, device=DEVICE)
    if is_inside:
        load_at(a, "u8", offset)
        wp.synchronize()
    else:
        refused("read of 1 bytes", lambda: load_at(a, "u8", offset))


@pytest.mark.parametrize(
    ("owner", "kind", "offset", "message"),
    [(DEVICE, "u64", 4, "misaligned address: read of 8 bytes"), ("cpu", "u32", 0, "outside the device's memory")],
)
def test_an_address_must_be_of_the_device_and_a_multiple_of_the_size(load_at, refused, owner, kind, offset, message):
    a = wp.zeros(8, dtype=int, device=owner)
    refused(message, lambda: load_at(a, kind, offset))


@pytest.mark.parametrize("size", [100, 100_000])
def test_a_released_array_is_never_touched_again(load_at, refused, size):
    a = wp.zeros(size, dtype=int, device=DEVICE)
    stale = wp.array(ptr=a.ptr, shape=a.shape, dtype=int, device=DEVICE)
    wp.synchronize()
    del a
    others = [wp.zeros(size, dtype=int, device=DEVICE) for _ in range(8)]  # whose place is another
    message = f"RELEASED array of {4 * size} bytes"
    refused(message, lambda: load_at(stale))
    refused(message, stale.numpy)
    assert len(others) == 8


def test_a_copy_outside_its_array_is_refused(refused):
    a = wp.zeros(4, dtype=int, device=DEVICE)
    longer = wp.array(ptr=a.ptr, shape=(5,), dtype=int, device=DEVICE)
    refused("copy from of 20 bytes", longer.numpy)
    refused("memset of 20 bytes", longer.zero_)


def test_fresh_memory_is_no_zeros(emulated):
    assert (wp.empty(4, dtype=wp.uint8, device=DEVICE).numpy() == 0xCB).all()
    assert ("copies", "uninitialized bytes copied to the host") in emulated.findings.notes


def test_a_read_of_uninitialized_memory_is_noted_with_its_argument(emulated, settings):
    settings(order=0)  # the first one is reported
    a, out = wp.empty(8, dtype=float, device=DEVICE), wp.empty(8, dtype=float, device=DEVICE)
    a[:5].zero_()
    emulated.findings.notes.pop(("copy_kernel", UNWRITTEN), None)
    wp.launch(copy_kernel, 8, [a, out], device=DEVICE)
    wp.synchronize()
    note = emulated.findings.notes.pop(("copy_kernel", UNWRITTEN))
    assert note.count == 3
    assert note.first.startswith("a[byte 20], thread 5,"), note.first


def test_written_memory_is_not_noted(emulated):
    out = wp.empty(8, dtype=float, device=DEVICE)
    wp.launch(copy_kernel, 8, [wp.zeros(8, dtype=float, device=DEVICE), out], device=DEVICE)
    np.testing.assert_array_equal(out.numpy(), 0)
    assert ("copy_kernel", UNWRITTEN) not in emulated.findings.notes


def test_too_much_memory_is_refused_as_cuda_does(emulated):
    with emulated.findings.expected(), pytest.raises(RuntimeError, match="Failed to allocate"):
        wp.empty(emulated.memory.room // 8 + 1, dtype=wp.float64, device=DEVICE)


def test_pages_of_released_memory_return_to_the_system(emulated):
    def resident() -> int:
        return int(Path("/proc/self/statm").read_text().split()[1]) * 4096

    def fill_and_release(count: int, size: int) -> None:
        for _ in range(count):
            wp.zeros(size, dtype=wp.uint8, device=DEVICE)
        wp.synchronize()

    fill_and_release(100, 1000)
    before = resident()
    fill_and_release(20_000, 2000)
    fill_and_release(20, 8 << 20)
    assert resident() - before < 60 << 20
