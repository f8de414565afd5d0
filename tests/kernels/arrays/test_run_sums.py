"""Sums and means over runs of rows."""

import itertools

import numpy as np

from pointloom.kernels.arrays.run_sums import average_vec3, first_rows, sum_columns
from pointloom.kernels.lang import float64, int32, vec3
from pointloom.kernels.memory import upload


def test_means_over_runs_are_those_of_float64(device, rng):
    sizes = np.array([1, 2, 7, 300, 1])
    starts = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int32)
    order = rng.permutation(starts[-1]).astype(np.int32)
    vectors = (rng.random((starts[-1], 3)) * 1000).astype(np.float32)
    columns = rng.normal(size=(starts[-1], 4))
    where = [upload(a, int32, device) for a in (order, starts)]
    parts = [order[a:b] for a, b in itertools.pairwise(starts)]
    expected = np.array([vectors[p].astype(np.float64).sum(axis=0) / len(p) for p in parts]).astype(np.float32)
    result = average_vec3(upload(vectors, vec3, device), *where).numpy()
    np.testing.assert_array_max_ulp(result, expected, 1)
    for mean in (False, True):
        result = sum_columns(upload(columns, float64, device), *where, mean).numpy()
        expected = [columns[p].mean(axis=0) if mean else columns[p].sum(axis=0) for p in parts]
        np.testing.assert_allclose(result, expected, rtol=1e-12, atol=1e-15 if mean else 3e-13)  # of 300 rows
    assert first_rows(*where).numpy().tolist() == [p[0] for p in parts]


def test_a_mean_leaves_out_rows_that_are_not_finite(device):
    values = np.array([[1, 2, 3], [np.nan, 0, 0], [3, 2, 1], [0, np.inf, 0], [np.nan] * 3], np.float32)
    where = [upload(np.array(a), int32, device) for a in ([0, 1, 2, 3, 4], [0, 4, 5])]
    rows = upload(values.astype(np.float64), float64, device)
    for means in (average_vec3(upload(values, vec3, device), *where), sum_columns(rows, *where, mean=True)):
        assert means.numpy()[0].tolist() == [2, 2, 2] and np.isnan(means.numpy()[1]).all()
    assert np.isnan(sum_columns(rows, *where).numpy()[0]).tolist() == [True, False, False]
