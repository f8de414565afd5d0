"""The array cache returns stored arrays unchanged and rebuilds damaged or outdated files."""

import numpy as np
import pytest

from pointloom.datasets import array_cache as module
from pointloom.datasets.array_cache import cached


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """A cache folder that stores every result, however fast it was computed."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(module, "MIN_SECONDS", -1.0)
    return tmp_path / "pointloom" / "datasets"


class Maker:
    """Counts its calls."""

    def __init__(self):
        self.calls = 0

    def __call__(self):
        self.calls += 1
        return {"values": np.arange(1000.0), "few": np.uint8([1, 2])}


def test_cached_arrays_are_bitwise_identical(cache):
    make = Maker()
    first, second = cached("room", {"count": 1}, make), cached("room", {"count": 1}, make)
    assert make.calls == 1 and len(list(cache.iterdir())) == 1
    for name, values in first.items():
        assert values.dtype == second[name].dtype and np.array_equal(values, second[name])


def test_other_parameters_and_other_sources_are_made_anew(cache, monkeypatch):
    make = Maker()
    cached("room", {"count": 1}, make), cached("room", {"count": 2}, make), cached("street", {"count": 1}, make)
    monkeypatch.setattr(module, "source_digest", lambda: "other")
    cached("room", {"count": 1}, make)
    assert make.calls == 4


@pytest.mark.parametrize("damage", ["flipped", "cut", "empty", "of another key"])
def test_a_damaged_file_is_made_anew(cache, damage):
    make = Maker()
    cached("room", {"count": 1}, make)
    (path,) = cache.iterdir()
    content = bytearray(path.read_bytes())
    if damage == "of another key":
        cached("room", {"count": 2}, make)
        make.calls = 1
        content = next(other for other in cache.iterdir() if other != path).read_bytes()
    elif damage == "flipped":
        content[len(content) // 3] ^= 255
    else:
        content = content[: len(content) // 2 if damage == "cut" else 0]
    path.write_bytes(content)
    again = cached("room", {"count": 1}, make)
    assert make.calls == 2 and np.array_equal(again["values"], np.arange(1000.0))
    cached("room", {"count": 1}, make)
    assert make.calls == 2


def test_fast_results_and_unwritable_folders_are_not_cached(tmp_path, monkeypatch):
    make = Maker()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    cached("room", {}, make)
    assert list(tmp_path.iterdir()) == []
    monkeypatch.setattr(module, "MIN_SECONDS", -1.0)
    (tmp_path / "pointloom").write_text("a file where the folder would be")
    assert np.array_equal(cached("room", {}, make)["few"], [1, 2])


def test_lru_entry_is_evicted(cache, monkeypatch):
    make = Maker()
    cached("room", {"count": 0}, make)
    size = next(cache.iterdir()).stat().st_size
    monkeypatch.setattr(module, "MAX_BYTES", 2.5 * size)
    for count in range(1, 6):
        cached("room", {"count": count}, make)
    assert len(list(cache.iterdir())) == 2
    make.calls = 0
    cached("room", {"count": 5}, make)
    assert make.calls == 0
