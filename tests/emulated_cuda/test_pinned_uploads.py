"""Uploads through page-locked pieces: complete, without a wait for earlier work, also if interrupted."""

import gc
import threading

import numpy as np
import pytest
import warp as wp

import pointloom as loom
from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import float32, uint8
from pointloom.kernels.language import pinned_uploads, warp_parts
from pointloom.kernels.language.pinned_results import pool
from pointloom.kernels.memory import download, empty, move, upload, write

from ..small_scenes import digest
from .settings import Order

COUNT = 20_000  # floats: 80 kB, which CUDA does not stage
SIZE = 4 * COUNT
PIECE_BYTES = pinned_uploads.PIECE_BYTES  # before a test sets another
CAMERA = loom.PinholeCameraIntrinsic(240, 160, 200.0, 200.0, 119.5, 79.5)


@pytest.fixture(autouse=True)
def two_pieces(emulated, settings, monkeypatch):
    """At most two pieces, each of the size of one upload, none of them locked yet, and copies that run at a wait."""
    settings(order=Order.FORWARD, lazy=True)
    monkeypatch.setattr(pinned_uploads, "PIECE_BYTES", SIZE)
    monkeypatch.setattr(pinned_uploads, "MAX_PIECES", 2)
    gc.collect()
    loom.free_memory("cuda:0")
    yield
    loom.free_memory("cuda:0")


def arrays(count):
    return [empty(COUNT, float32, resolve_device("cuda:0")) for _ in range(count)]


def numbers(first):
    return np.arange(first, first + COUNT, dtype=np.float32)


def busy_pieces():
    return [not piece.is_read for piece in pinned_uploads._pieces["cuda:0"]]


def test_an_upload_does_not_wait_and_the_source_may_change(emulated):
    (target,), source = arrays(1), numbers(3)
    counts = emulated.count_requests(lambda: write(target, source))
    assert (counts["waits"], counts["copies to device"], counts["bytes to device"]) == (0, 1, SIZE)
    write(target, source)
    source[:] = -1  # the copy has not run
    assert True in busy_pieces()
    np.testing.assert_array_equal(download(target), numbers(3))


def test_a_third_upload_waits_for_the_first_alone(emulated):
    targets = arrays(3)
    for k in range(2):
        write(targets[k], numbers(k))
    assert busy_pieces() == [True, True]
    counts = dict(emulated.findings.counts)
    write(targets[2], numbers(2))
    assert emulated.findings.counts["waits"] - counts["waits"] == 1
    assert busy_pieces() == [True, True]  # the second has not run
    for k in range(3):
        np.testing.assert_array_equal(download(targets[k]), numbers(k))


def test_many_uploads_use_two_buffers(emulated):
    targets = arrays(9)
    for k, target in enumerate(targets):
        write(target, numbers(k))
    for k, target in enumerate(targets):
        np.testing.assert_array_equal(download(target), numbers(k))
    assert len(pool.buffers) == 2


def test_an_upload_of_many_pieces_is_complete_and_waits_for_the_first_ones(emulated):
    (target,) = arrays(1)
    pixels, colors = empty((COUNT, 3), uint8, target.device), np.full((COUNT, 3), 7, np.uint8)
    large, values = empty(5 * COUNT + 3, float32, target.device), np.arange(5 * COUNT + 3, dtype=np.float32)
    counts = emulated.count_requests(lambda: write(large, values))
    assert (counts["waits"], counts["copies to device"]) == (4, 6)
    write(pixels, colors)
    colors[:] = 1
    np.testing.assert_array_equal(download(large), values)
    np.testing.assert_array_equal(download(pixels), np.full((COUNT, 3), 7))
    assert len(pool.buffers) == 2


def test_uploads_of_one_stream_share_a_piece(emulated, monkeypatch):
    monkeypatch.setattr(pinned_uploads, "PIECE_BYTES", 4 * SIZE)
    targets = arrays(4)
    for k, target in enumerate(targets):
        write(target, numbers(k))
    assert len(pool.buffers) == 1
    for k, target in enumerate(targets):
        np.testing.assert_array_equal(download(target), numbers(k))


def test_uploads_of_two_streams_share_no_piece(emulated, monkeypatch):
    """The event of a piece follows the copies of one stream alone."""
    monkeypatch.setattr(pinned_uploads, "PIECE_BYTES", 4 * SIZE)
    targets = arrays(2)
    write(targets[0], numbers(0))
    with wp.ScopedStream(wp.Stream("cuda:0"), sync_exit=True):
        write(targets[1], numbers(1))
    assert len(pool.buffers) == 2
    for k, target in enumerate(targets):
        np.testing.assert_array_equal(download(target), numbers(k))


def test_small_uploads_lock_no_memory(emulated):
    target = empty(4, float32, resolve_device("cuda:0"))
    write(target, numbers(5)[:4])
    np.testing.assert_array_equal(download(target), [5, 6, 7, 8])
    assert not pool.buffers


def test_small_uploads_to_a_gpu_that_reads_pageable_memory_are_staged(emulated, monkeypatch):
    """The emulated device stages pageable memory, so that a change of the source would not show."""
    target = empty(4, float32, resolve_device("cuda:0"))
    monkeypatch.setattr(target.device, "is_cpu_memory_access_from_gpu_supported", True)
    counts = emulated.count_requests(lambda: [write(target, numbers(k)[:4]) for k in range(9)])
    assert counts["waits"] == 0 and len(pool.buffers) == 1
    np.testing.assert_array_equal(download(target), [8, 9, 10, 11])


@pytest.mark.filterwarnings("ignore:copies from and to a GPU use ordinary memory:RuntimeWarning")
@pytest.mark.parametrize("how", ["write", "upload", "move", "not contiguous", "without Warp's parts"])
@pytest.mark.parametrize("count", [4, COUNT])
@pytest.mark.parametrize("locked_bytes", [0, None])
def test_a_page_locked_source_may_change(emulated, monkeypatch, how, count, locked_bytes):
    """Results of a GPU are page-locked, as are torch's pinned tensors. CUDA reads them when the copy runs."""
    device, values = resolve_device("cuda:0"), numbers(3)[:count]
    source = wp.empty(2 * count, dtype=wp.float32, device="cpu", pinned=True)
    view = source.numpy()[::2] if how == "not contiguous" else source.numpy()[:count]
    view[:] = values
    if locked_bytes is not None:
        monkeypatch.setattr(emulated.driver, "max_locked_bytes", locked_bytes)
    if how == "without Warp's parts":
        monkeypatch.setattr(warp_parts, "is_known", lambda: False)
    if how == "move":
        target = move(source[:count], device)
    elif how == "not contiguous":
        target = move(source[::2], device)
    elif how == "upload":
        target = upload(view, float32, device)
    else:
        target = empty(count, float32, device)
        write(target, view)
    source.numpy()[:] = -1
    np.testing.assert_array_equal(download(target), values)


@pytest.mark.filterwarnings("ignore:copies from and to a GPU use ordinary memory:RuntimeWarning")
def test_uploads_work_without_page_locked_memory(emulated, monkeypatch):
    monkeypatch.setattr(emulated.driver, "max_locked_bytes", 0)
    (target,) = arrays(1)
    write(target, numbers(2))
    np.testing.assert_array_equal(download(target), numbers(2))
    assert not pool.buffers


@pytest.mark.parametrize("broken", ["_copy", "_next_piece", "record_event"])
def test_a_buffer_of_an_interrupted_upload_is_used_again_after_its_copies(emulated, monkeypatch, broken):
    targets, (lost,) = arrays(4), arrays(1)
    write(targets[0], numbers(0))

    def interrupt(*_):
        raise KeyboardInterrupt

    owner = type(targets[0].device.stream) if broken == "record_event" else pinned_uploads
    with monkeypatch.context() as patch:
        patch.setattr(owner, broken, interrupt)
        with pytest.raises(KeyboardInterrupt):
            write(lost, numbers(-1))
    for k in (1, 2, 3):
        write(targets[k], numbers(k))
    for k, target in enumerate(targets):
        np.testing.assert_array_equal(download(target), numbers(k))
    if broken == "record_event":
        np.testing.assert_array_equal(download(lost), numbers(-1))


def test_free_memory_waits_for_uploads_and_unlocks_their_memory(emulated):
    targets = arrays(2)
    for k in range(2):
        write(targets[k], numbers(k))
    loom.free_memory("cuda:0")
    assert not pool.buffers
    for k in range(2):
        np.testing.assert_array_equal(download(targets[k]), numbers(k))


def test_no_memory_from_before_a_fork_is_used_again(emulated):
    targets = arrays(2)
    for k in range(2):
        write(targets[k], numbers(k))
    before = set(pool.buffers)
    pool.note_fork()  # as in the parent
    for k in range(2):
        write(targets[k], numbers(k + 7))
    assert len(pool.buffers) == 2 and not before & pool.buffers
    for k in range(2):
        np.testing.assert_array_equal(download(targets[k]), numbers(k + 7))


def test_threads_share_the_buffers(emulated):
    targets, wrong = [arrays(6) for _ in range(3)], []

    def work(k):
        for n, target in enumerate(targets[k]):
            write(target, numbers(100 * k + n))
            if not np.array_equal(download(target), numbers(100 * k + n)):
                wrong.append((k, n))

    threads = [threading.Thread(target=work, args=(k,)) for k in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong and len(pool.buffers) <= 2


def frames(count):
    v, u = np.mgrid[: CAMERA.height, : CAMERA.width]
    depths = [1000 + 200 * np.sin(u / (30 + k)) + 100 * np.cos(v / 25) for k in range(count)]
    poses = np.stack([np.eye(4)] * count)
    poses[:, 0, 3] = 0.002 * np.arange(count)
    return np.stack(depths).astype(np.uint16), poses, np.full((count, *v.shape, 3), 90, np.uint8)


def test_frames_of_the_host_allocate_nothing_and_wait_as_often_alone_as_together(emulated, monkeypatch):
    """Once the volume has its blocks: only the images and the poses are copied."""
    monkeypatch.setattr(pinned_uploads, "PIECE_BYTES", PIECE_BYTES)
    depths, poses, colors = frames(16)
    waits = []
    for together in (1, 4):
        volume = loom.TSDFVolume(voxel_size=0.05, device="cuda:0")
        for k in range(4):
            rows = slice(together * k, together * (k + 1))
            run = lambda: volume.integrate_frames(depths[rows], CAMERA, poses[rows], colors[rows])  # noqa: B023, E731
            counts = emulated.count_requests(run)
        assert counts["allocations"] == 0
        assert counts["bytes to device"] <= 1.01 * (depths[rows].nbytes + colors[rows].nbytes)
        waits.append(counts["waits"])
    assert waits[1] == waits[0]


def test_two_volumes_in_two_threads_are_those_of_one(emulated):
    depths, poses, colors = frames(8)

    def fused(volume):
        for k in range(0, 8, 2):
            volume.integrate_frames(depths[k : k + 2], CAMERA, poses[k : k + 2], colors[k : k + 2])

    def made():
        return loom.TSDFVolume(voxel_size=0.05, device="cuda:0")

    alone, volumes = made(), [made(), made()]
    fused(alone)
    threads = [threading.Thread(target=fused, args=(volume,)) for volume in volumes]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for volume in volumes:
        assert digest(volume.downloaded()) == digest(alone.downloaded())
