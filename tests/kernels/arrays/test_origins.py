"""Positions in float64 about an origin, and back."""

import numpy as np
import pytest

from pointloom.kernels.arrays.origins import add_origin, has_far_points, shift_rays, subtract_origin
from pointloom.kernels.lang import float64, vec3, vec3d
from pointloom.kernels.memory import download, upload

ORIGIN = np.array([5e5, -5.4e6, 100.5])


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_a_coordinate_beyond_a_limit_is_seen_and_one_that_is_not_finite_is_none(rng, device, dtype):
    points = rng.uniform(-1, 1, (500, 3)).astype(dtype)
    points[7] = np.nan, 1e9, 0
    points[8] = np.inf, 0, 1e9
    kind = vec3 if dtype == np.float32 else vec3d
    far, sample = has_far_points(upload(points, kind, device), 1.0, 3)
    assert not far
    np.testing.assert_array_equal(sample, points[::3])
    for axis in range(3):
        far = points.copy()
        far[[399, 400], axis] = 1.5, -1.5
        assert has_far_points(upload(far, kind, device), 1.0, 3)[0]


def test_points_are_rounded_once_and_round_trip(rng, device):
    points = rng.uniform(-100, 100, (300, 3)) + ORIGIN
    points[3] = np.nan, np.inf, 0
    local, lost = subtract_origin(upload(points, vec3d, device), ORIGIN)
    np.testing.assert_array_equal(download(local), (points - ORIGIN).astype(np.float32))
    assert not download(lost)[0]
    np.testing.assert_array_equal(download(add_origin(local, ORIGIN)), download(local).astype(np.float64) + ORIGIN)


def test_a_point_not_representable_in_float32_sets_the_flag(device):
    local, lost = subtract_origin(upload(np.array([[1e39, 0, 0], [0, 0, -1e39]]), vec3d, device), np.zeros(3))
    assert download(lost)[0] == 1
    np.testing.assert_array_equal(download(local), [[np.inf, 0, 0], [0, 0, -np.inf]])


def test_of_rays_the_starts_move(rng, device):
    rays = rng.normal(size=(50, 6))
    rays[:, :3] += ORIGIN
    result = download(shift_rays(upload(rays.ravel(), float64, device), ORIGIN)).reshape(-1, 6)
    expected = np.hstack([rays[:, :3] - ORIGIN, rays[:, 3:]]).astype(np.float32)
    np.testing.assert_array_equal(result, expected)
