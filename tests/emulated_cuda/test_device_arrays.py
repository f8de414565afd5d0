"""Arrays on a GPU that Warp did not make: in all that Warp looks at they are as its own, and so are their copies."""

import gc
import itertools
import threading

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.kernels import memory
from pointloom.kernels.language import device_arrays, device_copies, device_lock, warp_parts

OWN = {
    *("kind_", "packed_", "_allocator", "deleter", "ptr", "ctype", "_array_interface", "_ref", "_apic_capture_origin"),
    "block_",
}
SHAPES = (5, 0, (4,), (2, 3), (2, 0, 4), (2, 1, 3, 2), (np.int64(3), np.int32(2)))


@pytest.fixture
def where(emulated):
    device = wp.get_device("cuda:0")
    memory.empty(1, wp.int32, device)
    return device


@pytest.fixture
def by_warp(monkeypatch):
    return lambda: monkeypatch.setattr(warp_parts, "is_known", lambda: False)


def state_of(array) -> dict:
    return {name: value for name, value in vars(array).items() if name not in OWN}


@pytest.mark.parametrize("shape", SHAPES, ids=str)
@pytest.mark.parametrize("dtype", [wp.float32, wp.uint8, wp.vec3, wp.mat44d], ids=lambda t: t.__name__)
def test_a_new_array_has_the_state_of_a_warp_array(where, shape, dtype):
    array, warps = memory.empty(shape, dtype, where), wp.empty(shape, dtype=dtype, device=where)
    assert hasattr(array, "kind_") and not hasattr(warps, "kind_")
    assert state_of(array) == state_of(warps)
    assert bytes(array.__ctype__())[8:] == bytes(warps.__ctype__())[8:]
    assert array.packed_ == bytes(array.__ctype__())
    assert array.memory_kind == warps.memory_kind


def test_a_slice_keeps_its_base_array_alive(where, emulated):
    base = memory.upload(np.arange(24, dtype=np.float32).reshape(8, 3), wp.vec3, where)
    for first, last in ((0, 8), (2, 5), (7, 8), (0, 0), (3, 3)):
        part, warps = memory.rows_of(base, first, last), base[first:last]
        assert state_of(part) == state_of(warps) and part.ptr == warps.ptr and part._ref is base
        np.testing.assert_array_equal(part.numpy(), warps.numpy())
    part = memory.rows_of(base, 2, 5)
    del base, warps
    gc.collect()
    assert memory.download(part).tolist() == [[6, 7, 8], [9, 10, 11], [12, 13, 14]]


@pytest.fixture
def in_blocks(where, monkeypatch):
    """Small arrays are parts of new blocks."""
    monkeypatch.setattr(device_arrays, "blocks", device_arrays.BLOCKS)
    device_arrays.drop_blocks(where)
    yield
    device_arrays.drop_blocks(where)


def test_small_arrays_are_zeroed_parts_of_one_allocation(where, emulated, in_blocks):
    made = []
    counts = emulated.count_requests(lambda: made.extend(memory.empty(n, wp.vec3, where) for n in range(1, 200)))
    assert counts["allocations"] == 3  # 263 kB
    places = sorted((array.ptr, array.ptr + 12 * array.size) for array in made)
    assert all(end <= first and first % 256 == 0 for (_, end), (first, _) in itertools.pairwise(places))
    assert not any(memory.download(array).any() for array in made)
    array, warps = memory.empty((3, 2), wp.float32, where), wp.empty((3, 2), dtype=wp.float32, device=where)
    assert state_of(array) == state_of(warps) and array.memory_kind == warps.memory_kind
    assert not any(emulated.count_requests(lambda: memory.zeros(9, wp.int32, where)).values())


def test_a_block_is_released_with_the_last_of_its_arrays(where, emulated, in_blocks):
    gc.collect()
    emulated.synchronize()
    used = emulated.memory.used
    first, second = memory.upload(np.arange(5), wp.int32, where), memory.empty(7, wp.int32, where)
    part = memory.rows_of(first, 1, 3)
    device_arrays.drop_blocks(where)
    del first, second
    assert memory.download(part).tolist() == [1, 2] and emulated.memory.used > used
    del part
    gc.collect()
    emulated.synchronize()
    assert emulated.memory.used == used


@pytest.mark.parametrize("case", ["large", "empty", "stream", "recording"])
def test_other_arrays_are_not_in_blocks(where, in_blocks, chosen, case):
    size = {"large": device_arrays.BLOCKS[-1][0] + 1, "empty": 0}.get(case, 8)
    if case == "recording":
        with wp.ScopedCapture(device=where):
            array = memory.empty(size, wp.uint8, where)
    elif case == "stream":  # the caller's
        with wp.ScopedStream(chosen):
            array = memory.empty(size, wp.uint8, where)
    else:
        array = memory.empty(size, wp.uint8, where)
    assert not device_arrays.is_zero(array)


def test_each_stream_has_its_blocks(where, in_blocks):
    here = memory.empty(5, wp.int32, where)
    with wp.ScopedStream(wp.Stream(where)):
        there, next_there = (memory.empty(5, wp.int32, where) for _ in range(2))
    next_here = memory.empty(5, wp.int32, where)
    assert here.block_ is next_here.block_ and there.block_ is next_there.block_ is not here.block_


def test_threads_get_different_parts(where, in_blocks):
    made: list = []
    threads = [
        threading.Thread(target=lambda: made.extend(memory.zeros(3, wp.int32, where) for _ in range(300)))
        for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len({array.ptr for array in made}) == 1200


def test_results_are_the_same_in_blocks(where, in_blocks, monkeypatch):
    def results() -> list[bytes]:
        cloud = loom.PointCloud(np.random.default_rng(1).normal(size=(2000, 3)) * (3, 3, 0.02), device="cuda:0")
        plane = cloud.segment_plane(0.05, seed=1)
        kept = cloud.voxel_down_sample(0.2).remove_statistical_outlier(8, 1.0)[0].estimate_normals(max_nn=10)
        labels = np.asarray(kept.cluster_dbscan(0.4, 4))
        return [np.asarray(part).tobytes() for part in (*plane, kept.points, kept.normals, labels)]

    inside = results()
    monkeypatch.setattr(device_arrays, "blocks", ())
    assert results() == inside


def test_an_allocator_of_the_program_is_obeyed(where):
    class Counting:
        def __init__(self) -> None:
            self.made, self.real = 0, where.mempool_allocator

        def allocate(self, size):
            self.made += 1
            return self.real.allocate(size)

        def deallocate(self, address, size):
            self.made -= 1
            self.real.deallocate(address, size)

    allocator = Counting()
    with wp.ScopedAllocator(where, allocator):
        array = memory.zeros(7, wp.vec3, where)
        assert allocator.made == 1
    del array
    assert allocator.made == 0


def test_an_array_is_released_once_and_at_once(where, emulated):
    wp.synchronize()
    used = emulated.memory.used
    array = memory.empty(1 << 20, wp.uint8, where)
    assert emulated.memory.used > used
    del array
    wp.synchronize()
    assert emulated.memory.used == used


def test_an_array_dropped_while_another_thread_works_is_released_afterwards(where, emulated):
    wp.synchronize()
    used, arrays = emulated.memory.used, [memory.empty(1 << 20, wp.uint8, where)]
    with device_lock.lock:
        thread = threading.Thread(target=arrays.clear)
        thread.start()
        thread.join(timeout=60)
        assert not thread.is_alive(), "it waited for the lock"
        wp.synchronize()
        assert emulated.memory.used > used
    small = memory.empty(1, wp.uint8, where)
    del small
    wp.synchronize()
    assert emulated.memory.used == used


def test_arrays_of_a_recording_are_released_behind_it(where):
    made = memory.zeros(100, wp.int32, where)
    graph = device_lock.record(where, lambda: memory.fill(made, 3))
    with wp.ScopedCapture(device=where, stream=wp.Stream(where)):
        memory.empty(10, wp.int32, where)
    device_lock.replay(graph)
    assert memory.download(made).tolist() == [3] * 100


@pytest.mark.parametrize("dtype", [wp.float32, wp.uint8, wp.int64, wp.vec3, wp.mat33d, wp.vec2i])
@pytest.mark.parametrize("rows", [0, 1, 1000])
def test_uploads_and_downloads_equal_those_of_warp(where, by_warp, dtype, rows):
    shape = (rows, *getattr(dtype, "_shape_", ()))
    values = np.random.default_rng(0).integers(0, 99, shape)

    def there_and_back() -> list[np.ndarray]:
        array = memory.upload(values, dtype, where)
        copied = memory.clone(array)
        memory.write(copied, np.flip(values, 0).astype(wp.dtype_to_numpy(getattr(dtype, "_wp_scalar_type_", dtype))))
        third = memory.zeros(rows + 2, dtype, where)
        memory.copy(third, array, count=rows // 2, offset=1)
        return [memory.download(x) for x in (array, copied, third, memory.full(rows, dtype(3), dtype, where))]

    results = there_and_back()
    by_warp()
    for mine, warps in zip(results, there_and_back(), strict=True):
        assert mine.dtype == warps.dtype
        np.testing.assert_array_equal(mine, warps)


def test_copies_that_are_not_plain_are_left_to_warp(where):
    a, b = memory.zeros((4, 3), wp.float32, where), memory.zeros(3, wp.float64, where)
    column, row = a[:, 1], memory.rows_of(a, 0, 1)
    assert not device_copies.is_copied(b, row, 3)  # another width
    assert not device_copies.is_copied(row, a, 4)  # more than the available memory
    assert not device_copies.is_copied(a, row, 4)  # more than there is
    assert device_copies.fetched(column) is None and not device_copies.is_zeroed(column)  # gaps
    assert not device_copies.is_written(b, np.zeros(3, np.int64))  # another type
    assert not device_copies.is_written(b, np.zeros(6)[::2])
    assert memory.download(column).tolist() == [0.0] * 4


def test_a_recording_does_not_read_the_host(where):
    values = memory.zeros(3, wp.int32, where)
    with wp.ScopedCapture(device=where, stream=wp.Stream(where)):
        assert device_copies.fetched(values) is None
        assert not device_copies.is_written(values, np.zeros(3, np.int32))


def test_shapes_that_are_none_are_refused_by_warp(where):
    for shape in (-1, (2, -3), (1, 2, 3, 4, 5)):
        assert device_arrays.new(shape, wp.int32, where) is None
        with pytest.raises(Exception, match=r"shape|dimension|extent|negative|size"):
            memory.empty(shape, wp.int32, where)


def test_reinterpreted_memory_equals_that_of_warp(where):
    base = memory.upload(np.arange(96, dtype=np.uint8), wp.uint8, where)
    for first, dtype, shape in ((0, wp.float32, 24), (48, wp.vec3, (2, 2)), (95, wp.uint8, (1,)), (4, wp.int32, (0,))):
        view = device_arrays.reinterpreted(base, first, dtype, shape)
        warps = wp.array(ptr=base.ptr + first, dtype=dtype, shape=shape, device=where)
        assert state_of(view) == state_of(warps) and view.ptr == warps.ptr and view._ref is base
        assert view.numpy().tobytes() == warps.numpy().tobytes()
    for first, dtype, shape in ((0, wp.float32, 25), (95, wp.int32, 1), (-4, wp.int32, 1), (0, wp.uint8, (1,) * 5)):
        assert device_arrays.reinterpreted(base, first, dtype, shape) is None
    rows = memory.upload(np.arange(24, dtype=np.float32).reshape(8, 3), wp.float32, where)
    assert memory.download(memory.flat(memory.rows_of(rows, 2, 4))).tolist() == [6, 7, 8, 9, 10, 11]


def test_copies_to_pinned_memory_equal_those_of_warp(where, by_warp):
    values = memory.upload(np.arange(6, dtype=np.int64), wp.int64, where)
    results = []
    for _ in range(2):
        readback = memory.Readback(values)
        readback.send()
        results.append(readback.read().tolist())
        by_warp()
    assert results == [list(range(6))] * 2
