"""Made arrays that are kept come back as they were, and a file that is damaged, or of other sources, is made anew."""

import numpy as np
import pytest

from pointloom.datasets import array_cache as module
from pointloom.datasets.array_cache import cached


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """A cache folder in which all is kept, however fast it was made."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(module, "MIN_SECONDS", -1.0)
    return tmp_path / "pointloom" / "datasets"


class Maker:
    """Counts how often it is asked."""

    def __init__(self):
        self.calls = 0

    def __call__(self):
        self.calls += 1
        return {"values": np.arange(1000.0), "few": np.uint8([1, 2])}


def test_what_is_kept_comes_back_with_the_same_bits(cache):
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
    held = bytearray(path.read_bytes())
    if damage == "of another key":
        cached("room", {"count": 2}, make)
        make.calls = 1
        held = next(other for other in cache.iterdir() if other != path).read_bytes()
    elif damage == "flipped":
        held[len(held) // 3] ^= 255
    else:
        held = held[: len(held) // 2 if damage == "cut" else 0]
    path.write_bytes(held)
    again = cached("room", {"count": 1}, make)
    assert make.calls == 2 and np.array_equal(again["values"], np.arange(1000.0))
    cached("room", {"count": 1}, make)
    assert make.calls == 2


def test_what_is_made_fast_is_not_kept_and_a_folder_that_cannot_be_made_keeps_nothing(tmp_path, monkeypatch):
    make = Maker()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    cached("room", {}, make)
    assert list(tmp_path.iterdir()) == []
    monkeypatch.setattr(module, "MIN_SECONDS", -1.0)
    (tmp_path / "pointloom").write_text("a file where the folder would be")
    assert np.array_equal(cached("room", {}, make)["few"], [1, 2])


def test_the_least_used_goes_where_it_becomes_too_much(cache, monkeypatch):
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
