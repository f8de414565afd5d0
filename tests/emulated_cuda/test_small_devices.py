"""A device with too little memory for all results: host results are computed in batches, others are refused."""

import gc

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.core.batch_splitting import MIN_ROWS, in_batches
from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import uint8
from pointloom.kernels.memory import empty, zeros

COUNT = 2 * MIN_ROWS + 300


@pytest.fixture
def search(emulated, rng):
    points = rng.random((COUNT, 3)).astype(np.float32)
    points[::7] = points[0]
    return loom.NearestNeighborSearch(points, device="cuda:0")


@pytest.fixture
def with_room(emulated, monkeypatch):
    def limit(size: int) -> None:
        gc.collect()
        emulated.synchronize()
        monkeypatch.setattr(emulated.memory, "room", emulated.memory.used + size)

    return limit


QUERIES = {
    "knn": lambda search, queries: search.knn_search(queries, 24),
    "hybrid": lambda search, queries: search.hybrid_search(queries, 0.08, 24),
    "radius": lambda search, queries: search.radius_search(queries, 0.04),
}


@pytest.mark.parametrize("name", QUERIES)
def test_host_results_are_bitwise_identical_in_batches(emulated, search, with_room, name):
    queries, query_neighbors = search.cloud.points, QUERIES[name]
    query_neighbors(search, queries[:10])
    emulated.memory.peak = before = emulated.memory.used
    expected = query_neighbors(search, queries)
    with_room(int(0.7 * (emulated.memory.peak - before)))
    with emulated.findings.expected():
        result = query_neighbors(search, queries)
    for array, other in zip(result, expected, strict=True):
        np.testing.assert_array_equal(array, other)


OPERATIONS = {
    "normals": lambda cloud: cloud.estimate_normals(max_nn=30).normals,
    "covariances": lambda cloud: cloud.estimate_covariances(max_nn=30)["covariances"],
    "statistical outliers": lambda cloud: cloud.remove_statistical_outlier(20, 1.5)[1],
    "features": lambda cloud: loom.compute_fpfh_feature(cloud.estimate_normals(max_nn=30), max_nn=50),
}


@pytest.mark.parametrize("name", OPERATIONS)
def test_searches_with_less_scratch_are_bitwise_identical(search, emulated, with_room, name):
    """Fewer warps take more groups in turn: two fifths of the memory do, and next to none is refused by name."""
    work = OPERATIONS[name]
    work(search.cloud)
    emulated.memory.peak = before = emulated.memory.used
    expected = work(search.cloud)
    with_room(int(0.4 * (emulated.memory.peak - before)))
    with emulated.findings.expected():
        np.testing.assert_array_equal(work(search.cloud), expected)
    with_room(COUNT)
    with emulated.findings.expected(), pytest.raises(MemoryError, match="cuda:0 has no room"):
        work(search.cloud)


def test_device_results_are_refused_with_their_size(emulated, search, with_room):
    queries = wp.array(search.cloud.points.astype(np.float32), device="cuda:0")
    expected = [array.numpy() for array in search.knn_search(queries, 24)]
    with_room(24 * COUNT)
    reason = rf"cuda:0 has no room for an array of {4 * 24 * COUNT:,} bytes, [\d,]+ are free; take fewer points"
    with emulated.findings.expected(), pytest.raises(MemoryError, match=reason):
        search.knn_search(queries, 24)
    with_room(1 << 30)
    for array, other in zip(search.knn_search(queries, 24), expected, strict=True):
        np.testing.assert_array_equal(array.numpy(), other)


def test_parts_are_as_few_as_fit_and_in_order():
    ranges = []

    def work(begin, end):
        ranges.append((begin, end))
        if end - begin > 3 * MIN_ROWS:
            raise MemoryError("too many")
        return (np.arange(begin, end),)

    (result,) = in_batches(10 * MIN_ROWS, work)
    np.testing.assert_array_equal(result, np.arange(10 * MIN_ROWS))
    assert sum(end - begin <= 3 * MIN_ROWS for begin, end in ranges) == 4


def test_single_batches_that_do_not_fit_are_an_error():
    def work(begin, end):
        raise MemoryError(f"no room for {end - begin}")

    with pytest.raises(MemoryError, match=f"no room for {MIN_ROWS}"):
        in_batches(4 * MIN_ROWS, work)


@pytest.mark.parametrize("make", [empty, zeros])
def test_an_array_that_32_bits_do_not_count_is_refused_before_it_is_made(emulated, make):
    used = emulated.memory.total
    with pytest.raises(ValueError, match=r"an array of 2,147,483,648 elements: device code counts them in 32 bits"):
        make(2**31, uint8, resolve_device("cuda:0"))
    assert emulated.memory.total == used
