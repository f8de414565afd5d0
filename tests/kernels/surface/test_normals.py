"""Normals oriented towards a direction, a point or references."""

import numpy as np
import pytest

from pointloom.kernels.lang import INFINITY
from pointloom.kernels.search.point_tree import PointTree
from pointloom.kernels.surface.hollow_side import find_sides
from pointloom.kernels.surface.normals import align_normals, estimate_normals, orient_normals

from ..vectors import vectors


def test_zero_normals_take_the_direction_and_nan_normals_stay(device, tolerances):
    rows = [[0, 0, 0], [1, 1, 1], [2, 0, 0]], [[0, 0, 0], [np.nan] * 3, [0, 0, 0]]
    points, n = (vectors(device, values) for values in rows)
    oriented = orient_normals(points, n, [0, 3, 4], False).numpy()
    np.testing.assert_allclose(oriented[[0, 2]], [[0, 0.6, 0.8]] * 2, rtol=tolerances.unit_length)
    assert np.isnan(oriented[1]).all()
    oriented = orient_normals(points, n, [2, 0, 0], True).numpy()
    assert oriented[[0, 2]].tolist() == [[1, 0, 0], [0, 0, 1]], "a camera on the point gives the z axis"


def test_normals_are_aligned_with_their_references(device):
    n = vectors(device, [[0, 0, 1], [0, 0, 1], [0, 0, 1], [1, 0, 0]])
    align_normals(n, vectors(device, [[0, 0, -2], [0, 1, 0.1], [np.nan] * 3, [0, 1, 0]]))
    assert n.numpy().tolist() == [[0, 0, -1], [0, 0, 1], [0, 0, 1], [1, 0, 0]]


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("limits", [(12, INFINITY), (None, 5.0)])
def test_a_plane_far_from_zero_has_its_normal(device, rng, limits, axis):
    """8,000 km away, where a float32 is a metre: squares of the coordinates themselves would cost 1e-3 of a normal."""
    i, j = np.divmod(rng.permutation(400), 20)
    offset = np.zeros(3)
    offset[axis] = 2.0**23
    where = vectors(device, np.column_stack([2 * i, 2 * j, i + j]) + offset)
    tree, expected = PointTree(where), np.array([1, 1, -2]) / np.sqrt(6)
    for normals in (estimate_normals(tree, where, *limits).numpy(), find_sides(tree, 5.0, 5.0).numpy()):
        assert np.abs(np.abs(normals @ expected) - 1).max() < 1e-6
        assert np.linalg.norm(np.cross(normals, expected), axis=1).max() < 1e-6
