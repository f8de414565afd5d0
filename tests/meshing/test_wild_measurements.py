"""An outlier point creates no block beyond the limit and uses no memory for the space in between."""

import resource

import numpy as np
import pytest

import pointloom as loom


def peak():
    return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


@pytest.mark.parametrize(("far", "carve"), [(65.0, False), (1e7, True), (1e30, True), (np.nan, False)])
def test_outlier_points_create_no_block_beyond_max_range(device, far, carve):
    before, side = peak(), np.linspace(-1.0137, 0.9871, 25)
    wall = np.stack([np.full(625, 2.0), np.repeat(side, 25), np.tile(side, 25)], axis=1)
    wild = np.vstack([wall, [[far, far / 3, far / 7]]])
    blocks = []
    for points in (wall, wild):
        volume = loom.TSDFVolume(voxel_size=0.05, color=False, device=device)
        volume.integrate_points(points, np.zeros(3), carve=carve, max_range=50.0)
        blocks.append((volume._downloaded()["keys"].tobytes(), volume.memory_bytes))
    assert blocks[0] == blocks[1]
    grid = loom.OccupancyGrid(0.2, device=device)
    grid.insert_scan(wild, np.zeros(3), max_range=3.0)
    assert grid.memory_bytes < 5e6 and np.abs(grid.bounds).max() < 6.5
    assert peak() - before < 300e6
