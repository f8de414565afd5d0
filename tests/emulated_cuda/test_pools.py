"""A GPU's pool caches released memory: free for the next array, and returned on request."""

import gc

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.devices import resolve_device
from pointloom.kernels import memory
from pointloom.kernels.lang import float32
from pointloom.kernels.language import pools
from pointloom.kernels.memory import check_room, empty, free_bytes

SIZE = 1 << 20


@pytest.fixture
def gpu(emulated, monkeypatch):
    """The device, whose pool keeps all there is, with nothing kept yet."""
    device = resolve_device("cuda:0")
    empty(1, float32, device)
    gc.collect()
    monkeypatch.setattr(emulated.memory, "threshold", 1 << 40)
    loom.free_memory(device)
    return device


def test_released_memory_is_cached_and_counts_as_free(emulated, gpu):
    before = free_bytes(gpu)
    array = empty(SIZE, float32, gpu)
    assert free_bytes(gpu) == before - 4 * SIZE
    del array
    emulated.synchronize()
    assert emulated.memory.reserved - emulated.memory.used == pools.reserved_bytes(gpu) == 4 * SIZE
    assert free_bytes(gpu) == before


def test_cached_memory_returns_to_the_system_on_request(emulated, gpu):
    array, other = empty(SIZE, float32, gpu), empty(SIZE, float32, gpu)
    del array
    free = gpu.free_memory
    assert loom.free_memory("cuda:0") == 4 * SIZE
    assert gpu.free_memory == free + 4 * SIZE
    assert loom.free_memory() == 0
    del other
    assert loom.free_memory() == 4 * SIZE


def test_arrays_in_reference_cycles_are_released_too(gpu):
    cycle = [empty(SIZE, float32, gpu)]
    cycle.append(cycle)
    del cycle
    assert loom.free_memory(gpu) == 4 * SIZE


def test_clouds_and_operations_work_after_a_release(gpu, rng):
    points = rng.random((400, 3)).astype(np.float32)
    cloud = loom.PointCloud(points, device="cuda:0").estimate_normals(max_nn=8)
    reg = loom.registration
    moved = loom.PointCloud(points + np.float32(0.01), device="cuda:0")
    expected = reg.registration_icp(moved, cloud, 0.1).transformation
    loom.free_memory()
    np.testing.assert_array_equal(reg.registration_icp(moved, cloud, 0.1).transformation, expected)


def test_a_large_allocation_empties_the_pool_first(emulated, gpu):
    array = empty(SIZE, float32, gpu)
    del array
    emulated.synchronize()
    check_room(gpu, gpu.free_memory, "a thing that fits")
    assert pools.reserved_bytes(gpu) == 4 * SIZE
    check_room(gpu, gpu.free_memory + 1, "a thing that the pool has to make room for")
    assert pools.reserved_bytes(gpu) == 0
    with pytest.raises(MemoryError, match=r"a huge thing would take about 8\.59 GB, and cuda:0 has 8\.\d\d GB free"):
        check_room(gpu, emulated.memory.room + 1, "a huge thing")


def test_the_host_keeps_nothing_and_an_unknown_device_is_refused():
    assert loom.free_memory("cpu") == 0
    with pytest.raises(loom.DeviceError, match="device:"):
        loom.free_memory("cuda:9")


def test_a_failing_pool_raises_its_own_error(emulated, gpu, monkeypatch):
    monkeypatch.setattr(emulated.driver, "cuMemPoolTrimTo", lambda *_: 999, raising=False)
    with pytest.raises(RuntimeError, match=r"cuda:0: its pool of memory does not answer \(CUDA error 999\)"):
        loom.free_memory(gpu)


def test_caches_for_the_next_call_are_released_too(gpu, monkeypatch):
    cached = [empty(SIZE, float32, gpu)]
    monkeypatch.setattr(memory, "on_give_back", [cached.clear])
    assert loom.free_memory(gpu) == 4 * SIZE
