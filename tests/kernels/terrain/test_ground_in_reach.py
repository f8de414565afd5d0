"""Cells of terrain that were filled, relaxed against NumPy."""

import numpy as np

from pointloom.kernels.lang import float32, launch
from pointloom.kernels.memory import download, empty, upload
from pointloom.kernels.terrain.ground_in_reach import relax_cells_kernel


def test_filled_cells_take_the_mean_of_their_known_neighbors_and_known_ones_stay(device, rng):
    shape = (6, 9)
    heights, is_known = rng.normal(size=shape).astype(np.float32), rng.random(shape) < 0.4
    heights[rng.random(shape) < 0.2] = np.nan
    heights[:2, :2] = [[1, np.nan], [np.nan, np.nan]]  # a filled cell without neighbors
    is_known[:2, :2] = False
    known, out = np.where(is_known, heights, np.float32(np.nan)), empty(heights.size, float32, device)
    arrays = [upload(a.ravel(), float32, device) for a in (known, heights)]
    launch(relax_cells_kernel, heights.size, [*arrays, *shape, out])
    padded = np.pad(heights.astype(float), 1, constant_values=np.nan)
    sides = np.stack([padded[:-2, 1:-1], padded[2:, 1:-1], padded[1:-1, :-2], padded[1:-1, 2:]])
    counts = np.isfinite(sides).sum(axis=0)
    means = np.where(counts > 0, np.nansum(sides, axis=0) / np.maximum(counts, 1), heights)
    expected = np.where(np.isfinite(known), known, np.where(np.isfinite(heights), means, np.nan))
    np.testing.assert_allclose(download(out).reshape(shape), expected, rtol=1e-6, atol=1e-6)
    assert (counts[np.isfinite(heights) & ~is_known] == 0).any()
