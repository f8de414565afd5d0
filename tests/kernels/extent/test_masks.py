"""Masks of boxes and of what is finite: what float64 NumPy gives, element by element."""

from __future__ import annotations

import numpy as np
import pytest

from pointloom.kernels.extent.masks import mask_aligned_box, mask_finite, mask_oriented_box

from ..vectors import rotation, vectors


def test_points_on_the_faces_of_a_box_are_inside_it(device):
    points = np.stack(np.meshgrid(*[np.arange(-2, 3)] * 3), -1).reshape(-1, 3) / 2.0
    low, high = np.array([-0.5, -1.0, 0.0]), np.array([0.5, 0.5, 0.0])
    expected = ((points >= low) & (points <= high)).all(axis=1)
    assert 0 < expected.sum() < len(points)
    for origin in (np.zeros(3), np.array([5e5, 5.4e6, -3.0])):
        mask = mask_aligned_box(vectors(device, points), origin, low + origin, high + origin).numpy()
        np.testing.assert_array_equal(mask.astype(bool), expected)
        mask = mask_oriented_box(
            vectors(device, points), origin - (origin + (low + high) / 2), np.eye(3), (high - low) / 2
        ).numpy()
        np.testing.assert_array_equal(mask.astype(bool), expected)


def test_a_point_on_a_face_not_representable_in_float32_is_inside(device):
    """0.1 is stored as 0.10000000149: the bound is rounded in the same way."""
    points = vectors(device, [[0.1, 0.1, 0.1], [0.3, 0.7, 0.9]])
    assert mask_aligned_box(points, np.zeros(3), np.zeros(3), np.full(3, 0.1)).numpy().tolist() == [1, 0]
    assert mask_aligned_box(points, np.zeros(3), np.array([0.3, 0.7, 0.9]), np.ones(3)).numpy().tolist() == [0, 1]


def test_a_box_may_be_unbounded_and_contains_no_nan(device):
    points = vectors(device, [[1e30, -1e30, 0], [np.nan, 0, 0], [0, 0, 2], [np.inf, 0, 0]])
    everywhere, below = np.full(3, np.inf), np.array([np.inf, np.inf, 1.0])
    assert mask_aligned_box(points, np.zeros(3), -everywhere, below).numpy().tolist() == [1, 0, 0, 1]
    assert mask_aligned_box(points, np.zeros(3), np.full(3, -1e300), everywhere).numpy().tolist() == [1, 0, 1, 1]
    assert mask_oriented_box(points, np.zeros(3), np.eye(3), np.full(3, 2.0)).numpy().tolist() == [0, 0, 1, 0]


def test_points_in_a_rotated_box_match_numpy(device, rng):
    points = rng.normal(size=(3001, 3)).astype(np.float32)
    R, center, extent = rotation(rng), np.array([0.2, -0.1, 0.3]), np.array([1.0, 2.0, 0.5])
    local = (points.astype(np.float64) - center) @ R
    expected = (np.abs(local) <= extent / 2).all(axis=1)
    assert expected.sum() > 50
    mask = mask_oriented_box(vectors(device, points), -center, R.T, extent / 2).numpy()
    np.testing.assert_array_equal(mask.astype(bool), expected)


@pytest.mark.parametrize("drop_nan", [True, False])
@pytest.mark.parametrize("drop_infinite", [True, False])
def test_each_kind_of_non_finite_number_is_dropped_on_request(device, drop_nan, drop_infinite):
    points = [[0, 0, 0], [np.nan, 0, 0], [0, np.inf, 0], [0, 0, -np.inf], [np.nan, np.inf, 0], [3e38, 3e38, 3e38]]
    has_nan, has_infinite = np.array([0, 1, 0, 0, 1, 0], bool), np.array([0, 0, 1, 1, 1, 0], bool)
    expected = ~((has_nan & drop_nan) | (has_infinite & drop_infinite))
    mask = mask_finite(vectors(device, points), drop_nan, drop_infinite).numpy()
    np.testing.assert_array_equal(mask.astype(bool), expected)
