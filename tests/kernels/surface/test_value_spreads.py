"""Mean and spread of numbers over neighbors against NumPy."""

import numpy as np

from pointloom.kernels.lang import float64, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.search.point_tree import PointTree
from pointloom.kernels.surface.value_spreads import spread_values

RADIUS = 0.2


def test_spreads_are_those_of_the_finite_numbers_of_the_neighbors(device, rng):
    points, values = rng.random((300, 3)).astype(np.float32), rng.normal(size=300)
    points[0] = 5.0  # a point without neighbors
    values[1:30:3] = [np.nan, np.inf] * 5
    result = spread_values(PointTree(upload(points, vec3, device)), upload(values, float64, device), RADIUS)
    near = np.linalg.norm(points[:, None].astype(float) - points[None], axis=2) < RADIUS
    groups = [values[row & np.isfinite(values)] for row in near]
    known = np.isfinite(values)
    counts = np.where(known, [len(group) for group in groups], 0)
    np.testing.assert_array_equal(download(result.counts), counts)
    assert counts[0] == 1 and counts.max() > 5
    means = [group.mean() if one else np.nan for group, one in zip(groups, known, strict=True)]
    np.testing.assert_allclose(download(result.means), means, rtol=1e-12, atol=1e-12)
    spreads = [group.std(ddof=1) if n > 1 else np.nan for group, n in zip(groups, counts, strict=True)]
    np.testing.assert_allclose(download(result.deviations), spreads, rtol=1e-9, atol=1e-12)
