"""Names of the CUDA driver, huge pages and owners of files on each operating system."""

import ctypes
import mmap
import os
import sys
from types import SimpleNamespace

import pytest
import warp as wp

from pointloom.kernels import memory
from pointloom.kernels.language import cache_folders, driver, huge_pages, warp_compiler


@pytest.mark.parametrize(("system", "names"), [("linux", ["libcuda.so", "libcuda.so.1"]), ("win32", ["nvcuda.dll"])])
def test_the_driver_is_loaded_by_its_name_on_each_system(system, names, monkeypatch):
    requested = []

    def load(name):
        requested.append(name)
        raise OSError(f"no {name}")

    monkeypatch.setattr(sys, "platform", system)
    monkeypatch.setattr(ctypes.cdll, "LoadLibrary", load)
    with pytest.raises(OSError, match=f"no {names[-1]}"):
        driver.driver.__wrapped__()
    assert requested == names
    monkeypatch.setattr(ctypes, "CDLL", load)
    assert not warp_compiler._has_driver() and requested.pop() == names[-1]
    monkeypatch.setattr(ctypes, "CDLL", requested.append)
    assert warp_compiler._has_driver() and requested.pop() == names[-1]


PAGE = mmap.PAGESIZE


@pytest.fixture
def asked(monkeypatch):
    calls = []
    system = SimpleNamespace(madvise=lambda begin, length, advice: calls.append((begin.value, length.value, advice)))
    monkeypatch.setattr(huge_pages, "_system", system)
    return calls


@pytest.mark.parametrize(
    ("address", "size", "begin", "length"),
    [(8 * PAGE, 4 * PAGE, 8 * PAGE, 4 * PAGE), (8 * PAGE + 64, 4 * PAGE, 9 * PAGE, 3 * PAGE)],
    ids=["whole pages", "parts of pages at both ends"],
)
def test_the_request_covers_the_whole_pages_of_a_block(asked, address, size, begin, length):
    huge_pages.request_huge_pages(address, size)
    assert asked == [(begin, length, huge_pages.ADVICE)]


def test_large_arrays_ask_and_small_ones_do_not(asked):
    where = wp.get_device("cpu")
    large = memory.zeros(huge_pages.MIN_MAPPED_BYTES, wp.uint8, where)
    memory.zeros(huge_pages.MIN_MAPPED_BYTES - 1, wp.uint8, where)
    ((begin, length, _),) = asked
    assert large.ptr <= begin < begin + length <= large.ptr + large.capacity and not large.numpy().any()


def test_a_system_without_huge_pages_changes_nothing(monkeypatch):
    monkeypatch.setattr(huge_pages, "_system", None)
    assert not memory.zeros(huge_pages.MIN_MAPPED_BYTES, wp.uint8, wp.get_device("cpu")).numpy().any()


def test_without_users_digests_alone_protect_files(tmp_path, monkeypatch):
    file = tmp_path / "kernel.o"
    file.write_bytes(b"code")
    cache_folders.seal(file)
    tmp_path.chmod(0o777)
    file.chmod(0o666)
    assert cache_folders.other_writers(tmp_path) and not cache_folders.is_intact(file)
    monkeypatch.delattr(os, "getuid")
    assert cache_folders.other_writers(tmp_path) == "" and cache_folders.is_intact(file)
    file.write_bytes(b"node")
    assert not cache_folders.is_intact(file)
