"""The box of the finite points, and positions in float64 relative to an origin."""

import numpy as np
import pytest

from pointloom.kernels.arrays.bounds import RUN_POINTS, bound_points, find_box
from pointloom.kernels.arrays.lowest_bit import lowest_bit
from pointloom.kernels.arrays.origins import add_origin, has_far_points, shift_rays, subtract_origin
from pointloom.kernels.lang import float64, vec3, vec3d
from pointloom.kernels.memory import download, upload


@pytest.mark.parametrize("size", [1, RUN_POINTS - 1, RUN_POINTS, RUN_POINTS + 1, 2 * RUN_POINTS + 1])
def test_the_box_contains_the_finite_points(device, size, rng):
    points = rng.normal(size=(size, 3)).astype(np.float32)
    points[rng.integers(0, size, size // 10)] = [np.nan, 99, -99]
    points[rng.integers(0, size, size // 10)] = [50, np.inf, 0]
    finite = np.isfinite(points).all(axis=1)
    low, high, count = bound_points(upload(points, vec3, device))
    assert count == finite.sum() > 0
    np.testing.assert_array_equal(low, points[finite].min(axis=0))
    np.testing.assert_array_equal(high, points[finite].max(axis=0))


@pytest.mark.parametrize("size", [1, RUN_POINTS + 1, 40_003])
def test_the_box_that_stays_on_the_device_is_the_same(device, size, rng):
    points = -np.abs(rng.normal(size=(size, 3)))
    points[::3], points[1::7] = -0.0, np.nan
    given = upload(points, vec3, device)
    assert download(find_box(given)).tobytes() == np.array(bound_points(given)[:2]).tobytes()


@pytest.mark.parametrize("points", [np.zeros((0, 3)), np.full((5, 3), np.nan), np.full((5, 3), np.inf)])
def test_the_box_of_no_finite_point_is_empty(device, points):
    low, high, count = bound_points(upload(points, vec3, device))
    assert count == 0 and (low == np.inf).all() and (high == -np.inf).all()
    assert download(find_box(upload(points, vec3, device))).tolist() == [0] * 6, "a point where it stays on the device"


def test_the_box_of_minus_zero_is_zero(device):
    low, high, _ = bound_points(upload(np.array([[-0.0, 0.0, -0.0]]), vec3, device))
    assert not np.signbit(low).any() and not np.signbit(high).any()


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


@pytest.mark.parametrize(
    ("points", "exponent"),
    [
        ([[0, 0, 0]], 0),
        ([[0, 96, -32]], 5),
        ([[6, -0.5, 0], [0.0, 3, 1]], -1),
        ([[1, -0.0, 3 * 2.0**-20]], -20),
        ([[1, 2.0**-149, 0]], -149),
    ],
)
def test_coordinates_are_integer_multiples_of_their_lowest_bit(device, points, exponent):
    assert lowest_bit(upload(np.array(points), vec3, device)) == exponent


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
