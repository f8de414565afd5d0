"""Points and directions under a map: what float64 NumPy gives, element by element."""

import numpy as np
import pytest

from pointloom.kernels.algebra.transform import transform_directions, transform_points

from ..vectors import vectors


@pytest.mark.parametrize("count", [0, 1, 2, 1001])
def test_points_are_mapped_in_float64_and_rounded_once(device, count, rng):
    points = rng.normal(size=(count, 3)).astype(np.float32)
    A, t = rng.normal(size=(3, 3)), rng.normal(size=3) * 1000
    result = transform_points(vectors(device, points), A, t).numpy()
    expected = points.astype(np.float64) @ A.T + t
    np.testing.assert_array_max_ulp(result, expected.astype(np.float32), 1)


def test_large_terms_that_cancel_leave_the_small_difference(device):
    """R p + t with both near 5e6: float32 arithmetic would leave half a metre of noise."""
    points = np.array([[5e6, 0, 0]], np.float32)
    result = transform_points(vectors(device, points), np.eye(3), [-4999999.875, 0, 0]).numpy()
    assert result.tolist() == [[0.125, 0, 0]]


def test_directions_keep_their_lengths_under_any_map(device, rng, tolerances):
    lengths = np.array([1.0, 0.25, 3.0, 1e-10, 1e10, 1.0])[:, None]
    n = rng.normal(size=(6, 3))
    n = (n / np.linalg.norm(n, axis=1, keepdims=True) * lengths).astype(np.float32)
    A = rng.normal(size=(3, 3)) * 100
    result = transform_directions(vectors(device, n), A).numpy().astype(np.float64)
    expected = n.astype(np.float64) @ A.T
    scale = np.linalg.norm(n.astype(np.float64), axis=1, keepdims=True)
    expected *= scale / np.linalg.norm(expected, axis=1, keepdims=True)
    assert (np.abs(result - expected) <= tolerances.float32_relative * scale).all()


def test_zero_and_nan_directions_stay(device):
    result = transform_directions(vectors(device, [[0, 0, 0], [np.nan, 1, 0]]), np.eye(3) * 2).numpy()
    assert result[0].tolist() == [0, 0, 0] and np.isnan(result[1]).any()
