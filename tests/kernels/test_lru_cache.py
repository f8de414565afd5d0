"""The least recently used values are evicted within the capacity; values in use are not."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom.kernels.lru_cache import LruCache


class Shelf:
    """Things of one size, and a note of what was made and what was dropped."""

    def __init__(self, room):
        self.made, self.dropped = [], []
        self.cache = LruCache(room, on_evict=self.dropped.append)

    def take(self, key, size=10, beside=None):
        return self.cache.get(key, size, lambda: self.made.append(key) or key, beside=beside)


def test_the_least_recently_used_value_is_evicted():
    shelf = Shelf(20)
    for key in (1, 2, 1, 3, 1, 2):
        shelf.take(key)
    assert shelf.made == [1, 2, 3, 2] and shelf.dropped == [2, 3]


def test_the_budget_is_filled_to_its_last_byte():
    shelf = Shelf(20)
    for key, size in ((1, 10), (2, 10), (3, 1)):
        shelf.take(key, size)
    assert shelf.dropped == [1]


def test_values_in_use_are_not_evicted():
    shelf = Shelf(20)
    shelf.take("own")
    for key in (1, 2, 3):
        shelf.take(key, beside="own")
    assert shelf.take("own") == "own"
    assert shelf.made == ["own", 1, 2, 3] and shelf.dropped == [1, 2]


def test_a_value_larger_than_the_budget_is_cached_alone():
    shelf = Shelf(5)
    for key in (1, 1, 2):
        shelf.take(key)
    assert shelf.made == [1, 2] and shelf.dropped == [1]
    shelf.take(3, beside=2)
    assert shelf.dropped == [1]


def test_a_value_that_cannot_be_made_is_not_cached():
    shelf = Shelf(20)
    shelf.take(1)
    with pytest.raises(ZeroDivisionError):
        shelf.cache.get(2, 10, lambda: 1 // 0)
    assert shelf.take(1) == 1 and shelf.take(2) == 2 and shelf.made == [1, 2]


def test_a_value_that_is_put_replaces_the_one_of_its_key_and_pop_removes_it():
    shelf = Shelf(20)
    for key, value in ((1, "a"), (2, "b"), (1, "c")):
        shelf.cache.put(key, value, 10)
    assert (shelf.cache.find(1), shelf.cache.find(3), shelf.cache.size, shelf.dropped) == ("c", None, 20, [])
    shelf.cache.put(4, "d", 10)
    assert shelf.cache.find(2) is None and shelf.dropped == ["b"]
    assert (shelf.cache.pop(1), shelf.cache.pop(1), shelf.cache.size) == ("c", None, 10)
    shelf.cache.clear()
    assert shelf.dropped == ["b", "d"] and shelf.cache.size == 0


@given(requests=st.lists(st.tuples(st.integers(0, 6), st.integers(1, 9)), max_size=40), room=st.integers(9, 30))
@settings(max_examples=25, deadline=None)
def test_the_budget_is_never_exceeded(requests, room):
    sizes = dict(requests)
    shelf = Shelf(room)
    for key, _ in requests:
        shelf.take(key, sizes[key])
        cached = [k for k in set(shelf.made) if shelf.made.count(k) > shelf.dropped.count(k)]
        assert key in cached and sum(sizes[k] for k in cached) <= room
