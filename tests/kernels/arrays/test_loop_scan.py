"""Running sums and lists in a loop of the device: what NumPy gives."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.arrays.loop_scan import TILE, LoopList, LoopScan
from pointloom.kernels.lang import int32, uint8
from pointloom.kernels.memory import download, empty, upload, zeros


@pytest.mark.parametrize("size", [0, 1, 31, 33, TILE - 1, TILE, TILE + 1, 3 * TILE + 7, TILE * TILE + 1])
def test_sums_run_through_all_tiles(device, size, rng):
    warp_device = resolve_device(device)
    counts = rng.integers(0, 50, size).astype(np.int32)
    given, sums, scan = upload(counts, int32, warp_device), empty(size, int32, warp_device), LoopScan(size, warp_device)
    scan.run(given, sums, size)
    np.testing.assert_array_equal(download(sums), np.cumsum(counts))
    np.testing.assert_array_equal(download(given), counts)
    scan.run(given, given, size)
    np.testing.assert_array_equal(download(given), np.cumsum(counts))


def test_fewer_counts_than_the_capacity(device, rng):
    warp_device, size, capacity = resolve_device(device), TILE + 5, 3 * TILE
    counts = rng.integers(0, 50, capacity).astype(np.int32)
    sums = upload(np.full(capacity, -7, np.int32), int32, warp_device)
    LoopScan(capacity, warp_device).run(upload(counts, int32, warp_device), sums, size)
    np.testing.assert_array_equal(download(sums), [*np.cumsum(counts[:size]), *[-7] * (capacity - size)])


@pytest.mark.parametrize("share", [0.0, 0.3, 1.0])
def test_marks_are_listed_in_their_order(device, rng, share):
    warp_device, size = resolve_device(device), 2 * TILE + 77
    mask = (rng.random(size) < share).astype(np.uint8)
    counts, marks = zeros(3, int32, warp_device), LoopList(size, warp_device)
    marks.find(upload(mask, uint8, warp_device), size, counts, 1)
    assert download(counts).tolist() == [0, mask.sum(), 0]
    np.testing.assert_array_equal(download(marks.rows)[: mask.sum()], np.flatnonzero(mask))
