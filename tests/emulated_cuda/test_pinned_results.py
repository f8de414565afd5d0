"""NumPy results of 1 MB and more: they live in page-locked memory, which the next results use again."""

import contextlib
import gc
import pickle
import threading
from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import vec3
from pointloom.kernels.language import device_copies, pinned_results
from pointloom.kernels.memory import download, upload

from .processes import START, run

COUNT = 1 << 18  # floats: 1 MB, the smallest result in page-locked memory


@pytest.fixture
def pool(emulated):
    """The pool, without memory of earlier tests."""
    gc.collect()
    loom.free_memory("cuda:0")
    yield pinned_results.pool
    gc.collect()
    loom.free_memory("cuda:0")


def on_device(count=COUNT, first=0):
    """An array that Warp uploads, without page-locked memory."""
    return wp.array(np.arange(first, first + count, dtype=np.float32), device="cuda:0")


def address_of(values):
    return values.__array_interface__["data"][0]


def test_the_next_result_uses_the_memory_of_a_dropped_one(emulated, pool):
    values, expected = on_device(), np.arange(COUNT, dtype=np.float32)
    first = download(values)
    assert address_of(first) in emulated.allocations.pinned and pool.size == first.nbytes == 1 << 20
    assert first.flags.writeable
    np.testing.assert_array_equal(first, expected, strict=True)
    first[:] = -1
    address = address_of(first)
    del first
    counts = emulated.count_requests(lambda: np.testing.assert_array_equal(download(values), expected))
    assert (counts["copies to host"], counts["bytes to host"], counts["waits"]) == (1, 1 << 20, 1)
    assert address_of(download(values)) == address and pool.size == 1 << 20


def test_results_that_are_in_use_share_no_memory(pool):
    values, others = on_device(), on_device(first=7)
    first, second = download(values), download(others)
    part = second[5:10]
    del second
    third = download(values)
    assert not np.shares_memory(first, third) and not np.shares_memory(part, third)
    np.testing.assert_array_equal(part, np.arange(12, 17, dtype=np.float32))
    assert len(pool.buffers) == 3
    del part
    assert len([download(others) for _ in range(5)]) == 5 and len(pool.buffers) == 7


def test_small_results_use_other_memory(emulated, pool):
    assert address_of(download(on_device(COUNT - 1))) not in emulated.allocations.pinned
    assert not pool.buffers


def test_a_buffer_fits_results_of_half_its_size_and_more(pool):
    download(on_device(3 * COUNT))
    assert pool.size == 3 << 20
    download(on_device(2 * COUNT))
    assert pool.size == 3 << 20
    download(on_device(COUNT))
    assert pool.size == 4 << 20
    assert pinned_results.rounded_up((1 << 20) + 1) == 9 << 17


def test_beyond_the_limit_results_use_other_memory(emulated, pool):
    pool.limit = 2 << 20
    results = [download(on_device(first=k)) for k in range(3)]
    assert [address_of(result) in emulated.allocations.pinned for result in results] == [True, True, False]
    np.testing.assert_array_equal([result[0] for result in results], [0, 1, 2])
    del results
    large = download(on_device(2 * COUNT))  # idle memory makes room
    assert address_of(large) in emulated.allocations.pinned and pool.size == 2 << 20


def test_the_limit_is_a_fraction_of_the_memory_of_the_host(pool):
    download(on_device())
    assert pool.limit == pinned_results.host_bytes() // 16 > 1 << 20


def test_a_driver_that_locks_no_more_pages_is_asked_again_later(emulated, pool, monkeypatch):
    monkeypatch.setattr(emulated.driver, "max_locked_bytes", sum(n for n, _ in emulated.allocations.pinned.values()))
    monkeypatch.setattr(pinned_results, "RESULTS_BEFORE_RETRY", 2)
    monkeypatch.setattr(pool, "has_warned", False)
    with pytest.warns(RuntimeWarning, match="^copies from and to a GPU use ordinary memory for now, .* locks no "):
        result = download(on_device())
    assert address_of(result) not in emulated.allocations.pinned
    np.testing.assert_array_equal(result, np.arange(COUNT, dtype=np.float32))
    monkeypatch.undo()
    locked = [address_of(download(on_device())) in emulated.allocations.pinned for _ in range(3)]
    assert locked == [False, False, True]


def test_released_memory_is_locked_again_at_once(emulated, pool, monkeypatch):
    monkeypatch.setattr(emulated.driver, "max_locked_bytes", sum(n for n, _ in emulated.allocations.pinned.values()))
    monkeypatch.setattr(pool, "has_warned", True)
    assert address_of(download(on_device())) not in emulated.allocations.pinned
    monkeypatch.undo()
    loom.free_memory("cuda:0")
    assert address_of(download(on_device())) in emulated.allocations.pinned


def test_free_memory_releases_what_no_array_uses(emulated, pool):
    kept, dropped = download(on_device()), download(on_device())
    addresses = address_of(kept), address_of(dropped)
    del dropped
    loom.free_memory("cuda:0")
    assert [address in emulated.allocations.pinned for address in addresses] == [True, False]
    np.testing.assert_array_equal(kept, np.arange(COUNT, dtype=np.float32))
    del kept
    loom.free_memory("cuda:0")
    assert not pool.buffers and addresses[0] not in emulated.allocations.pinned


def test_threads_get_their_own_memory(pool):
    results, values = {}, [on_device(first=k) for k in range(4)]

    def work(k):
        for _ in range(20):
            results[k] = download(values[k])

    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for k, result in results.items():
        np.testing.assert_array_equal(result, np.arange(k, k + COUNT, dtype=np.float32))
    assert len(pool.buffers) <= 8  # two of each thread


def test_memory_of_an_interrupted_download_returns_after_the_wait(emulated, pool, monkeypatch):
    values = on_device()

    def interrupted(*_):
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(device_copies, "checked", interrupted)  # the copy is queued
        with pytest.raises(KeyboardInterrupt):
            download(values)
    assert len(pool.returned) == 1 and pool.size == 1 << 20
    np.testing.assert_array_equal(download(values), np.arange(COUNT, dtype=np.float32))
    assert pool.size == 1 << 20


def test_an_interrupted_download_waits_for_its_own_device(pool):
    """Not for the one that locked the pages."""
    download(on_device())
    entered = []

    class Guard(contextlib.nullcontext):
        def __enter__(self):
            entered.append(1)

    def interrupt(*_):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        pinned_results.fill_pinned((COUNT,), np.dtype(np.float32), SimpleNamespace(context_guard=Guard()), interrupt)
    assert entered == [1] and len(pool.returned) == 1


def test_results_of_operations_are_plain_arrays(pool, rng):
    cloud = loom.PointCloud(rng.random((1 << 17, 3)).astype(np.float32), device="cuda:0")
    result = loom.NearestNeighborSearch(cloud).knn_search(cloud, 2).sqdists
    assert pool.size >= result.nbytes >= 1 << 20
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(result)), result)
    result += 1
    assert result.min() >= 1


def test_vectors_and_empty_results(pool):
    points = np.ones((COUNT, 3), np.float32)
    np.testing.assert_array_equal(download(upload(points, vec3, resolve_device("cuda:0"))), points, strict=True)
    assert download(upload(points[:0], vec3, resolve_device("cuda:0"))).shape == (0, 3)


FORK = """
import warp as wp
from pointloom.kernels.memory import download
from pointloom.kernels.language.pinned_results import pool
from pointloom.core.devices import resolve_device

count, device = 1 << 18, resolve_device("cuda:0")
first = download(wp.array(np.full(count, 1, np.float32), device=device))
idle = download(wp.array(np.full(count, 2, np.float32), device=device))
del idle
(reading, writing), (waiting, going) = os.pipe(), os.pipe()
child = os.fork()
if child == 0:
    os.read(waiting, 1)  # until the parent has written
    found = [float(first.min()), float(first.max()), len(pool.buffers)]
    first[:] = 5  # the child's own copy
    del first
    os.write(writing, json.dumps([*found, len(pool.returned)]).encode())
    sys.exit(0)
first[:] = 3
address = first.__array_interface__["data"][0]
del first
again = download(wp.array(np.full(count, 4, np.float32), device=device))
os.write(going, b"1")
_, status = os.waitpid(child, 0)
found = {"child": json.loads(os.read(reading, 1 << 16)), "status": status, "size": pool.size}
found["same"] = [float(again.min()), float(again.max())]
found["locked"] = sum(size for size, _ in installed().allocations.pinned.values())
print(json.dumps(found))
"""


def test_a_forked_process_has_copies_and_the_parent_locks_new_memory(emulated):
    report = run("-c", START + FORK, POINTLOOM_CPU="warp")
    assert report == {"child": [1.0, 1.0, 0, 0], "status": 0, "size": 1 << 20, "same": [4.0, 4.0], "locked": 1 << 20}


@pytest.mark.parametrize(
    "read",
    [
        lambda cloud: cloud.normals,
        lambda cloud: cloud["label"],
        lambda cloud: cloud.compute_nearest_neighbor_distance(),
        lambda cloud: loom.NearestNeighborSearch(cloud).knn_search(cloud, 2).indices,
    ],
)
def test_arrays_of_a_cloud_are_not_copied_again(emulated, pool, rng, read):
    points = rng.random((1 << 18, 3)).astype(np.float32)
    cloud = loom.PointCloud(points, normals=points, label=np.arange(1 << 18), device="cuda:0")
    values = read(cloud)
    starts = emulated.allocations.pinned.items()
    assert any(start <= address_of(values) < start + size for start, (size, _) in starts)
