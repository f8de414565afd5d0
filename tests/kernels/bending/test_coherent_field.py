"""Points under a field of Gaussians against NumPy."""

import numpy as np

from pointloom.kernels.bending.coherent_field import move_points
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload


def test_points_move_by_the_sum_of_the_gaussians_and_stay_where_they_are_not_finite(device, rng):
    points = rng.normal(size=(50, 3)).astype(np.float32)
    points[3], points[7] = np.nan, [0, np.inf, 0]
    shift, unit, scale = np.array([0.5, -1.0, 2.0]), 0.25, 1.5
    centers, weights = rng.normal(size=(2, 12, 3))
    result = download(move_points(upload(points, vec3, device), shift, unit, centers, weights, scale))
    scaled = (points.astype(float) + shift) * unit
    gaps = ((scaled[:, None] - centers) ** 2).sum(axis=2)
    expected = points + np.exp(-scale * gaps) @ weights / unit
    expected[[3, 7]] = points[[3, 7]]
    np.testing.assert_allclose(result, expected, rtol=1e-6, atol=1e-6)
    still = move_points(upload(points, vec3, device), shift, unit, centers[:0], weights[:0], scale)
    np.testing.assert_array_equal(download(still), points)
