"""The downsampling of whole scans, with arrays that are reused between scans."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.odometry.odometry_sampling import MIN_CAPACITY, ScanSampler, first_in_voxels

SIZES, RANGES = (0.5, 1.5), (2.0, 40.0)


def scan(rng, count: int) -> np.ndarray:
    """Points of rows, several in each voxel, and some that are out of range, zero or not finite."""
    ahead = np.repeat(rng.uniform(-45, 45, (count // 4, 3)), 4, axis=0)
    points = (ahead + rng.uniform(0, 0.2, ahead.shape)).astype(np.float32)
    points[::50], points[7::60] = 0.0, np.nan
    return points


@pytest.mark.parametrize("counts", [(400, 8 * MIN_CAPACITY, 400), (4,)])
def test_a_scan_is_downsampled_twice_and_the_next_one_too(device, rng, counts):
    home = resolve_device(device)
    sampler = ScanSampler(*SIZES, *RANGES)
    previous = []
    for count in counts:
        points = upload(scan(rng, count), vec3, home)
        fine, coarse = sampler.thin(points)
        expected = first_in_voxels(points, SIZES[0], *RANGES)
        np.testing.assert_array_equal(fine.numpy(), expected.numpy())
        np.testing.assert_array_equal(coarse.numpy(), first_in_voxels(expected, SIZES[1], *RANGES).numpy())
        previous.append((fine, fine.numpy().copy()))
    for fine, values in previous:  # results are not overwritten by later scans
        np.testing.assert_array_equal(fine.numpy(), values)


def test_a_scan_without_points_in_range_is_empty(device):
    points = upload(np.full((5, 3), np.nan, np.float32), vec3, resolve_device(device))
    fine, coarse = ScanSampler(*SIZES, *RANGES).thin(points)
    assert fine.size == coarse.size == 0
