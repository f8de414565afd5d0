"""An outlier pixel or point creates no block beyond the limit and uses no memory for the space in between."""

import resource

import numpy as np
import pytest

import pointloom as loom

CAMERA = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)


def peak():
    """The peak memory of the process [B]."""
    return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def picture(pixel):
    depth = np.full((48, 64), 1.0, np.float32)
    depth[20, 40] = pixel
    return depth


def contents_of(volume):
    arrays = volume._downloaded()
    return {name: arrays[name].tobytes() for name in ("keys", "distances", "weights")}


@pytest.mark.parametrize("pixel", [65.535, 3e38, -np.inf, np.nan])
def test_outlier_pixels_beyond_depth_max_are_ignored(device, tmp_path, pixel):
    before = peak()
    contents, memory = [], []
    for depth in (picture(0.0), picture(pixel)):
        volume = loom.TSDFVolume(voxel_size=0.01, color=False, device=device)
        volume.integrate(depth, CAMERA, np.eye(4), depth_max=3.0)
        contents.append(contents_of(volume))
        memory.append(volume.memory_bytes)
    assert contents[0] == contents[1] and memory[0] == memory[1]
    with loom.PagedTSDFVolume(tmp_path / "v", voxel_size=0.01, color=False, max_blocks=2000, device=device) as paged:
        paged.integrate(picture(pixel), CAMERA, np.eye(4), depth_max=3.0)
        assert contents_of(paged.to_volume()) == contents[0]
    assert peak() - before < 300e6


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
