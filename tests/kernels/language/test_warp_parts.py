"""Warp's private parts: those that are used are there, and what lacks one does without."""

from __future__ import annotations

import ctypes

import pytest
import warp as wp

from pointloom.kernels.language import warp_parts


def test_this_warp_has_the_private_parts_that_are_used():
    missing = warp_parts.missing()
    assert missing == [], (
        f"warp-lang {wp.__version__} lacks, or has in another form: {', '.join(missing)}. Launches and arrays on a GPU "
        "go by wp.launch and wp.empty with it, ten times slower: read kernels/language/warp_parts.py beside its sources"
    )


@pytest.fixture
def fresh():
    """What is known of this Warp is found out anew, before and after."""
    warp_parts.is_known.cache_clear()
    yield
    warp_parts.is_known.cache_clear()


def test_missing_parts_are_listed_and_not_used(monkeypatch, fresh):
    class array_t(ctypes.Structure):  # noqa: N801  Warp's name
        _fields_ = (("data", ctypes.c_uint64), ("shape", ctypes.c_int32 * 4))

    monkeypatch.setattr(warp_parts.types, "array_t", array_t)
    monkeypatch.setitem(warp_parts.FUNCTIONS, "wp_cuda_launch_kernel", 12)
    monkeypatch.setattr(warp_parts, "ARRAY", {*warp_parts.ARRAY, "_place"})
    missing = warp_parts.missing()
    assert missing[0].startswith("array_t") and "array._place" in missing
    assert not warp_parts.is_known()
