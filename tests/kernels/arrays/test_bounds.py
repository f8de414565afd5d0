"""The box of the points that are finite."""

import numpy as np
import pytest

from pointloom.kernels.arrays.bounds import RUN, bound_points, find_box
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload


@pytest.mark.parametrize("size", [1, RUN - 1, RUN, RUN + 1, 2 * RUN + 1])
def test_the_box_contains_the_finite_points(device, size, rng):
    points = rng.normal(size=(size, 3)).astype(np.float32)
    points[rng.integers(0, size, size // 10)] = [np.nan, 99, -99]
    points[rng.integers(0, size, size // 10)] = [50, np.inf, 0]
    finite = np.isfinite(points).all(axis=1)
    low, high, count = bound_points(upload(points, vec3, device))
    assert count == finite.sum() > 0
    np.testing.assert_array_equal(low, points[finite].min(axis=0))
    np.testing.assert_array_equal(high, points[finite].max(axis=0))


@pytest.mark.parametrize("size", [1, RUN + 1, 40_003])
def test_the_box_that_stays_on_the_device_is_the_same(device, size, rng):
    points = -np.abs(rng.normal(size=(size, 3)))
    points[::3], points[1::7] = -0.0, np.nan
    given = upload(points, vec3, device)
    assert download(find_box(given)).tobytes() == np.array(bound_points(given)[:2]).tobytes()


@pytest.mark.parametrize("points", [np.zeros((0, 3)), np.full((5, 3), np.nan)])
def test_the_box_of_no_finite_point_is_a_point_where_it_stays(device, points):
    assert download(find_box(upload(points, vec3, device))).tolist() == [0] * 6


@pytest.mark.parametrize("points", [np.zeros((0, 3)), np.full((5, 3), np.nan), np.full((5, 3), np.inf)])
def test_the_box_of_no_finite_point_is_empty(device, points):
    low, high, count = bound_points(upload(points, vec3, device))
    assert count == 0 and (low == np.inf).all() and (high == -np.inf).all()


def test_the_box_of_minus_zero_is_zero(device):
    low, high, _ = bound_points(upload(np.array([[-0.0, 0.0, -0.0]]), vec3, device))
    assert not np.signbit(low).any() and not np.signbit(high).any()
