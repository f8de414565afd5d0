"""Masks of boxes and of what is finite: what float64 NumPy gives, element by element."""

import numpy as np
import pytest

from pointloom.kernels.extent.masks import mask_aligned_box, mask_finite, mask_oriented_box

from ..vectors import vectors


def test_a_box_may_be_unbounded_and_contains_no_nan(device):
    points = vectors(device, [[1e30, -1e30, 0], [np.nan, 0, 0], [0, 0, 2], [np.inf, 0, 0]])
    everywhere, below = np.full(3, np.inf), np.array([np.inf, np.inf, 1.0])
    assert mask_aligned_box(points, np.zeros(3), -everywhere, below).numpy().tolist() == [1, 0, 0, 1]
    assert mask_aligned_box(points, np.zeros(3), np.full(3, -1e300), everywhere).numpy().tolist() == [1, 0, 1, 1]
    assert mask_oriented_box(points, np.zeros(3), np.eye(3), np.full(3, 2.0)).numpy().tolist() == [0, 0, 1, 0]


@pytest.mark.parametrize("drop_nan", [True, False])
@pytest.mark.parametrize("drop_infinite", [True, False])
def test_each_kind_of_non_finite_number_is_dropped_on_request(device, drop_nan, drop_infinite):
    points = [[0, 0, 0], [np.nan, 0, 0], [0, np.inf, 0], [0, 0, -np.inf], [np.nan, np.inf, 0], [3e38, 3e38, 3e38]]
    has_nan, has_infinite = np.array([0, 1, 0, 0, 1, 0], bool), np.array([0, 0, 1, 1, 1, 0], bool)
    expected = ~((has_nan & drop_nan) | (has_infinite & drop_infinite))
    mask = mask_finite(vectors(device, points), drop_nan, drop_infinite).numpy()
    np.testing.assert_array_equal(mask.astype(bool), expected)
