"""Distributions of voxels against NumPy."""

import numpy as np
import pytest

from pointloom.kernels.icp.normal_distributions import NormalDistributions
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload


def build(points, device, size=0.5, **options):
    rules = {"min_points": 6, "regularization": 1e-3, "limit": 9.0, "with_neighbors": True} | options
    return NormalDistributions(upload(points, vec3, device), size, (-size / 2,) * 3, **rules)


def groups_of(points, size):
    """The rows of each occupied voxel, voxels in ascending order."""
    cells = np.floor(points.astype(float) / size + 0.5).astype(int)
    _, numbers = np.unique(cells, axis=0, return_inverse=True)
    return [np.flatnonzero(numbers.ravel() == k) for k in range(numbers.max() + 1)]


def test_distributions_match_numpy(device, rng):
    points = (rng.random((600, 3)) * [3, 2, 0.1] - 1).astype(np.float32)
    points[:8] = points[8]  # equal points in one voxel
    made = build(points, device, regularization=0.05)
    means, information, nearest = (download(a) for a in (made.means, made.information, made.representatives))
    groups = groups_of(points, 0.5)
    assert len(groups) == len(means) and made.count == sum(len(rows) >= 6 for rows in groups) < len(groups)
    for rows, mean, inverse, row in zip(groups, means, information, nearest, strict=True):
        inside = points[rows].astype(float)
        np.testing.assert_allclose(mean, inside.mean(axis=0), rtol=0, atol=1e-14)
        if len(rows) < 6:
            assert row == -1
            continue
        values, vectors = np.linalg.eigh(np.cov(inside.T))
        values = np.maximum(values, 0.05 * values.max())
        np.testing.assert_allclose(inverse, vectors / values @ vectors.T, rtol=0, atol=1e-11 / values.min())
        gaps = ((inside - mean) ** 2).sum(axis=1)
        assert row in rows and gaps[rows == row] <= gaps.min() * (1 + 1e-9)


def test_equal_points_have_no_distribution(device):
    made = build(np.full((20, 3), 0.1, np.float32), device)
    assert made.count == 0 and download(made.representatives).tolist() == [-1]


@pytest.mark.parametrize(("scales", "expected"), [
    ((1.0, 0.8, 0.05), [0, 0, 1]), ((1.0, 0.05, 0.05), [0, 0.1, 0.1]), ((1.0, 0.7, 0.6), [0, 0.1, 0.1]),
])  # fmt: skip
def test_shapes_are_the_directions_that_a_distribution_determines(device, rng, scales, expected):
    """Along the normal of a plane. With less weight, across a line and across the longest axis of a scattered one."""
    axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    points = (rng.normal(size=(20_000, 3)) * scales / 50 @ axes.T).astype(np.float32)
    (shape,) = download(build(points, device).shapes)
    np.testing.assert_allclose(np.diag(axes.T @ shape @ axes), expected, atol=2e-3)
