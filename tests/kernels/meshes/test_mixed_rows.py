"""Vertices that are made of others against NumPy."""

import numpy as np

from pointloom.kernels.lang import float64, vec3d, vec3i
from pointloom.kernels.memory import download, upload
from pointloom.kernels.meshes.mixed_rows import MixedRows


def test_values_are_weighted_sums_and_the_nearest_vertex_is_the_first_of_the_heaviest(device, rng):
    rows = rng.integers(0, 30, (100, 3)).astype(np.int32)
    weights = rng.dirichlet(np.ones(3), 100)
    weights[0], weights[1], weights[2] = [0, 0.5, 0.5], [0.5, 0.5, 0], [0, 0, 1]
    made, values = (MixedRows(upload(rows, vec3i, device), upload(weights, vec3d, device)), rng.normal(size=(30, 2)))
    expected = np.take_along_axis(rows, weights.argmax(axis=1)[:, None], axis=1)[:, 0]
    np.testing.assert_array_equal(download(made.nearest()), expected)
    result = download(made.of(upload(values, float64, device)))
    np.testing.assert_allclose(result, np.einsum("nk,nkc->nc", weights, values[rows]), rtol=0, atol=1e-14)
