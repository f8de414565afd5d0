"""Large arrays of the host ask the system for huge pages."""

import mmap
from types import SimpleNamespace

import pytest
import warp as wp

from pointloom.kernels import memory
from pointloom.kernels.language import huge_pages

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
    large = memory.zeros(huge_pages.MAPPED, wp.uint8, where)
    memory.zeros(huge_pages.MAPPED - 1, wp.uint8, where)
    ((begin, length, _),) = asked
    assert large.ptr <= begin < begin + length <= large.ptr + large.capacity
    assert not large.numpy().any()


def test_a_system_without_huge_pages_changes_nothing(monkeypatch):
    monkeypatch.setattr(huge_pages, "_system", None)
    assert not memory.zeros(huge_pages.MAPPED, wp.uint8, wp.get_device("cpu")).numpy().any()
