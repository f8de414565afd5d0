"""Arrays from NumPy and back, and least recently used values that are evicted."""

import subprocess
import sys

import numpy as np
import pytest
import warp as wp
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom.core.devices import resolve_device
from pointloom.kernels import memory
from pointloom.kernels.lang import vec3, vec3d
from pointloom.kernels.language import huge_pages
from pointloom.kernels.lru_cache import LruCache
from pointloom.kernels.memory import cast, download, upload


def test_an_uploaded_array_is_a_copy(device, rng):
    values = rng.random((7, 3)).astype(np.float32)
    array = upload(values, vec3, resolve_device(device))
    original = values.copy()
    values[:] = 0
    np.testing.assert_array_equal(download(array), original)


FLOATS = [np.float16, np.float32, np.float64]
INTEGERS = [np.int8, np.int16, np.int32, np.int64, np.uint8, np.uint16, np.uint32, np.uint64, np.bool_]
CAST_SOURCES = {  # by the operations: to each type from these
    np.float64: [*FLOATS[:2], *INTEGERS],
    np.float32: [np.float64, np.float16, np.int64, np.uint8],
    np.float16: [np.float64],
    np.int64: [np.uint8, np.int16, np.uint64, np.bool_],
    np.uint8: [np.int32],
    np.int32: [np.int32],
}


@pytest.mark.parametrize("target", CAST_SOURCES)
def test_a_cast_gives_the_result_of_numpy(device, target, rng):
    for source in CAST_SOURCES[target]:
        values, fractions = rng.integers(0, 100, 300), rng.random(300) if np.dtype(source).kind == "f" else 0
        values = (values + fractions).astype(source)
        array = upload(values, wp.dtype_from_numpy(np.dtype(source)), resolve_device(device))
        result = download(cast(array, wp.dtype_from_numpy(np.dtype(target))))
        expected = (values.astype(np.float32) if target == np.float16 else values).astype(target)
        assert result.dtype == target
        np.testing.assert_array_equal(result, expected, err_msg=f"from {source.__name__}")


def test_a_cast_rounds_to_the_nearest_even_and_keeps_non_finite_values(device):
    warp_device = resolve_device(device)
    halfway = np.array([2049, 2051, 65504, 65519.99, 65520, 1e-8, -0.0, np.inf, -np.inf, np.nan, 1 + 2**-11])
    for dtype in (wp.float32, wp.float64):
        result = download(cast(upload(halfway, dtype, warp_device), wp.float16))
        with np.errstate(over="ignore"):
            np.testing.assert_array_equal(result, halfway.astype(np.float32).astype(np.float16))
    wide = np.array([2**53 + 1, -(2**62) - 1, 2**24 + 1], np.int64)
    for target in (np.float32, np.float64):
        result = download(cast(upload(wide, wp.int64, warp_device), wp.dtype_from_numpy(np.dtype(target))))
        np.testing.assert_array_equal(result, wide.astype(target))
    wrapped = np.array([-1, 255, 256, -300, 2**31 - 1], np.int32)
    for target in (np.uint8, np.uint64):
        result = download(cast(upload(wrapped, wp.int32, warp_device), wp.dtype_from_numpy(np.dtype(target))))
        np.testing.assert_array_equal(result, wrapped.astype(target))


def test_arrays_with_gaps_with_columns_of_vectors_and_without_elements_are_cast(device, rng):
    warp_device = resolve_device(device)
    table, points = rng.random((7, 4)).astype(np.float32), rng.random((5, 3)).astype(np.float32)
    array = upload(table, wp.float32, warp_device)
    np.testing.assert_array_equal(download(cast(array, wp.float64)), table.astype(np.float64))
    np.testing.assert_array_equal(download(cast(array[:, 1], wp.float64)), table[:, 1].astype(np.float64))
    np.testing.assert_array_equal(download(cast(upload(points, vec3, warp_device), vec3d)), points.astype(np.float64))
    assert cast(upload(np.zeros((0, 3)), wp.float64, warp_device), wp.int32).shape == (0, 3)


def test_a_cast_of_another_pair_of_types_compiles_nothing_again(device, monkeypatch, rng):
    warp_device, loaded = resolve_device(device), []
    load = wp.Module.load
    arrays = [upload(rng.integers(0, 9, 10), dtype, warp_device) for dtype in (wp.int16, wp.uint32, wp.int8)]

    def note(module, *arguments, **options):
        known = list(module.execs.values())
        executable = load(module, *arguments, **options)
        if not any(executable is one for one in known):
            loaded.append(module.name)
        return executable

    monkeypatch.setattr(wp.Module, "load", note)
    for array in (*arrays, *arrays):
        cast(array, wp.float32)
    assert len(loaded) == len(set(loaded)) <= (len(arrays) if warp_device.is_cuda else 0)


WITHOUT_ROOM = """
import resource
import numpy as np
from pointloom.kernels import memory
from pointloom.kernels.lang import float32, vec3
from pointloom.core.devices import resolve_device

cpu = resolve_device("cpu")
values = np.zeros(2**27, np.float32)
memory.zeros(4, float32, cpu)
with open("/proc/self/statm") as file:
    room = int(file.read().split()[0]) * resource.getpagesize() + 2**28
resource.setrlimit(resource.RLIMIT_AS, (room, room))
for make in (
    lambda: memory.empty(2**28, vec3, cpu),
    lambda: memory.zeros((2**20, 2**10), float32, cpu),
    lambda: memory.full(2**30, 1.0, float32, cpu),
    lambda: memory.upload(values, float32, cpu),
):
    try:
        make()
        print("made")
    except MemoryError as error:
        print(error)
"""


def test_a_memory_error_reports_the_size_of_the_array():
    done = subprocess.run([sys.executable, "-c", WITHOUT_ROOM], capture_output=True, text=True, check=True, timeout=120)
    sizes = ("3,221,225,472", "4,294,967,296", "4,294,967,296", "536,870,912")
    for line, size in zip(done.stdout.splitlines(), sizes, strict=True):
        assert line.startswith(f"cpu has no room for an array of {size} bytes; take fewer points")


class Pooled:
    """A GPU whose pool keeps released memory, with the interface that kernels/memory.py uses."""

    is_cuda, is_cpu, is_mempool_enabled, alias = True, False, True, "cuda:7"

    def __init__(self, monkeypatch, threshold=0):
        self.threshold, self.calls = threshold, []
        monkeypatch.setattr(wp, "get_mempool_release_threshold", lambda device: device.threshold)
        monkeypatch.setattr(wp, "set_mempool_release_threshold", Pooled.set)
        monkeypatch.setattr(memory, "_pools", set())

    def set(self, threshold):
        self.calls.append(threshold)
        self.threshold = threshold


@pytest.mark.parametrize("shape", [5, 0, (4,), (2, 3), (2, 0, 4), (np.int64(3), np.int32(2))], ids=str)
@pytest.mark.parametrize("dtype", [wp.float32, wp.uint8, wp.vec3, wp.mat44d], ids=lambda t: t.__name__)
def test_a_new_array_of_the_host_has_the_state_of_a_warp_array(shape, dtype):
    where = wp.get_device("cpu")
    for array, warps in (
        (memory.empty(shape, dtype, where), wp.empty(shape, dtype=dtype, device=where)),
        (memory.zeros(shape, dtype, where), wp.zeros(shape, dtype=dtype, device=where)),
    ):
        own = {"kind_", "packed_", "ptr", "ctype", "_array_interface"}
        states = [{name: value for name, value in vars(a).items() if name not in own} for a in (array, warps)]
        assert states[0] == states[1] and (array.ptr is None) == (warps.ptr is None)
        assert bytes(array.__ctype__())[8:] == bytes(warps.__ctype__())[8:]
    np.testing.assert_array_equal(array.numpy(), warps.numpy())


@pytest.mark.parametrize(
    ("threshold", "calls"), [(0, [memory.POOL_FRACTION]), (123, [])], ids=["default", "of the user"]
)
def test_the_pool_of_a_gpu_is_configured_once_to_keep_released_memory(monkeypatch, threshold, calls):
    gpu = Pooled(monkeypatch, threshold)
    for _ in range(2):
        memory._keep_pool(gpu)
    assert gpu.calls == calls


def test_the_first_array_on_a_gpu_sets_its_pool(device, monkeypatch):
    warp_device, devices = resolve_device(device), []
    monkeypatch.setattr(memory, "_keep_pool", devices.append)
    memory.empty(3, vec3, warp_device)
    assert devices == ([warp_device] if warp_device.is_cuda else [])


def test_tables_uploaded_together_equal_single_uploads(device):
    tables = [np.arange(3), np.zeros(0, np.int64), np.array([7, -1], np.int32), np.array([5])]
    parts = memory.upload_together(tables, wp.int32, resolve_device(device))
    assert [download(part).tolist() for part in parts] == [table.tolist() for table in tables]
    assert all(part.dtype == wp.int32 and part.is_contiguous for part in parts)


def test_a_large_array_is_downloaded_into_pages_that_were_mapped_before(device, rng):
    values = rng.integers(0, 2**31, huge_pages.MIN_MAPPED_BYTES // 4 + 5).astype(np.int32)
    assert (download(upload(values, wp.int32, resolve_device(device))) == values).all()


def test_pages_are_mapped_without_a_change_of_their_bytes():
    values = np.arange(1 << 20, dtype=np.int32)
    huge_pages.populate(values.ctypes.data + 4, values.nbytes - 4)  # neither end is that of a page
    huge_pages.populate(values.ctypes.data, 8)
    assert (values == np.arange(1 << 20)).all()


def test_a_download_contains_the_values_at_the_time_of_the_request(device):
    values = upload(np.array([3, 1, 2]), wp.int32, resolve_device(device))
    readback = memory.Readback(values)
    assert readback.read().tolist() == [3, 1, 2]
    readback.send()
    assert readback.read().tolist() == [3, 1, 2]
    memory.write(values, np.array([9, 8, 7], np.int32))
    readback.forget()
    assert readback.read().tolist() == [9, 8, 7]
    readback.send()
    assert readback.read().tolist() == [9, 8, 7]


class Shelf:
    """Things of one size, and a note of what was made and what was dropped."""

    def __init__(self, room):
        self.made, self.dropped = [], []
        self.cache = LruCache(room, on_evict=self.dropped.append)

    def take(self, key, size=10, beside=None):
        return self.cache.get(key, size, lambda: self.made.append(key) or key, beside=beside)


@pytest.mark.parametrize(
    ("room", "requests", "made", "dropped"),
    [
        (20, [(key,) for key in (1, 2, 1, 3, 1, 2)], [1, 2, 3, 2], [2, 3]),
        (20, [(1, 10), (2, 10), (3, 1)], [1, 2, 3], [1]),
        (20, [("own",), *((key, 10, "own") for key in (1, 2, 3)), ("own",)], ["own", 1, 2, 3], [1, 2]),
        (5, [(1,), (1,), (2,)], [1, 2], [1]),
        (5, [(1,), (2,), (3, 10, 2)], [1, 2, 3], [1]),
    ],
    ids=["least recently used", "up to the last byte", "not if in use", "larger than the budget", "larger and in use"],
)
def test_the_least_recently_used_values_beyond_the_budget_are_evicted(room, requests, made, dropped):
    shelf = Shelf(room)
    assert [shelf.take(*request) for request in requests] == [key for key, *_ in requests]
    assert (shelf.made, shelf.dropped) == (made, dropped)


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
