"""All work of an operation goes to the stream that the caller chose: what is written there before it is waited for."""

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.kernels.arrays.prefix_sum import offsets_of
from pointloom.kernels.arrays.sort import argsort_keys
from pointloom.kernels.lang import int32, int64
from pointloom.kernels.memory import Readback, download, upload

from ..array_library import installed
from ..small_scenes import ON_CLOUDS, ON_HOST, ONCE, digest
from .findings import caller

DEVICE = "cuda:0"


class Streams:
    def __init__(self, device, chosen, monkeypatch) -> None:
        self.used: set[int] = set()
        self.elsewhere: list[str] = []
        real = device.streams.enqueue

        def enqueue(stream, operation, kind):
            if stream.capture is None:
                self.used.add(stream.handle)
                if stream.handle != chosen.cuda_stream:
                    self.elsewhere.append(f"{kind}: {caller()}")
            real(stream, operation, kind)

        monkeypatch.setattr(device.streams, "enqueue", enqueue)


@pytest.fixture
def check(emulated, chosen, monkeypatch):
    """A function (work): it gives the same bits on a stream of the caller's, which gets all of it, as elsewhere."""

    def run(work) -> None:
        expected = digest(work())
        wp.synchronize_device(DEVICE)
        with monkeypatch.context() as patch:
            streams = Streams(emulated, chosen, patch)
            with wp.ScopedStream(chosen):
                result = work()
            assert streams.elsewhere == []
        wp.synchronize_device(DEVICE)
        assert digest(result) == expected

    return run


@pytest.mark.parametrize("operation", [name for name in ON_CLOUDS if not name.startswith(ON_HOST)])
def test_work_on_clouds_runs_on_the_callers_stream(small, check, operation):
    check(lambda: ON_CLOUDS[operation](small.surface))


@pytest.mark.slow
@pytest.mark.parametrize("operation", [name for name in ONCE if not name.startswith(ON_HOST)])
def test_work_on_scenes_runs_on_the_callers_stream(small, check, operation):
    check(lambda: ONCE[operation](small))


@wp.kernel(enable_backward=False)
def move_kernel(points: wp.array(dtype=float, ndim=2), by: float):
    i = wp.tid()
    points[i, 0] = points[i, 0] + by


class Speaker:
    """An array with nothing but the CUDA array interface, which names a stream."""

    def __init__(self, memory, stream):
        self.memory = memory
        self.__cuda_array_interface__ = {**memory.__cuda_array_interface__, "version": 3, "stream": stream}


@pytest.fixture
def points(rng):
    return rng.random((500, 3)).astype(np.float32)


def test_an_array_on_the_current_stream_changes_no_stream(chosen, points):
    memory = wp.array(points, device=DEVICE)
    wp.synchronize_device(DEVICE)
    core = wp._src.context.runtime.core
    with wp.ScopedStream(chosen):
        wp.launch(move_kernel, 500, [memory, 1.0])
        cloud = loom.PointCloud(Speaker(memory, chosen.cuda_stream))
        assert core.wp_cuda_context_get_stream(wp.get_device(DEVICE).context) == chosen.cuda_stream
        result = cloud.points
    np.testing.assert_array_equal(result[:, 0], (points[:, 0] + np.float32(1)).astype(np.float64))


@pytest.mark.parametrize("stream", [1, 2], ids=["legacy", "per thread"])
def test_an_array_on_one_of_cudas_default_streams_is_waited_for(chosen, points, stream):
    memory = wp.array(points, device=DEVICE)
    wp.synchronize_device(DEVICE)
    foreign = wp.Stream(DEVICE, cuda_stream=stream)
    wp.launch(move_kernel, 500, [memory, 1.0], stream=foreign)
    with wp.ScopedStream(chosen, sync_enter=False):
        result = loom.PointCloud(Speaker(memory, stream)).points
    np.testing.assert_array_equal(result[:, 0], (points[:, 0] + np.float32(1)).astype(np.float64))


def test_a_producer_that_is_late_is_waited_for_on_every_stream(emulated, chosen, points, monkeypatch):
    library = installed(DEVICE, monkeypatch)
    late = library.asarray(points)
    wp.launch(move_kernel, 500, [late.memory, 1.0], stream=library.stream)  # queued, and not run before it has to be
    with wp.ScopedStream(chosen):
        cloud = loom.PointCloud(late)
        normals = cloud.estimate_normals(max_nn=8)
        taken = library.from_dlpack(normals)
    host = wp.empty((500, 3), dtype=float, device="cpu", pinned=True)
    wp.copy(host, taken.memory, stream=library.stream)  # their stream waits for pointloom's
    wp.synchronize_stream(library.stream)
    points[:, 0] += 1
    np.testing.assert_array_equal(host.numpy(), points)
    wp.synchronize_device(DEVICE)
    np.testing.assert_array_equal(normals.normals, loom.PointCloud(points).estimate_normals(max_nn=8).normals)


def test_readbacks_wait_for_the_callers_stream(chosen, points):
    memory = wp.array(points, device=DEVICE)
    wp.synchronize_device(DEVICE)
    readback = Readback(memory)
    with wp.ScopedStream(chosen):
        wp.launch(move_kernel, 500, [memory, 1.0])
        readback.send()
        wp.launch(move_kernel, 500, [memory, 1.0])
    np.testing.assert_array_equal(readback.read()[:, 0], points[:, 0] + np.float32(1))
    wp.synchronize_device(DEVICE)  # before the program's own array goes


def test_scratch_of_warp_is_released_after_its_use_on_the_callers_stream(emulated, chosen, rng, monkeypatch):
    """Warp releases scratch on the legacy stream, which does not wait for the caller's: scans use none of Warp's, and a
    sort that needs more than those before waits for them."""
    core, scans = wp._src.context.runtime.core, []
    monkeypatch.setattr(core, "wp_array_scan_int_device", lambda *given: scans.append(given), raising=False)
    waits = []
    with wp.ScopedStream(chosen):
        for count in (5_000, 5_000, 6_000, 5_000):
            keys = upload(rng.integers(0, 1 << 20, count), int64, DEVICE)
            before = emulated.findings.counts["waits"]
            order = argsort_keys(keys, 20)[1]
            waits.append(emulated.findings.counts["waits"] - before)
            np.testing.assert_array_equal(download(order), np.argsort(download(keys), kind="stable"))
        counts = rng.integers(0, 9, 5_000)
        np.testing.assert_array_equal(download(offsets_of(upload(counts, int32, DEVICE)))[1:], np.cumsum(counts))
    assert waits == [1, 0, 1, 0] and not scans
