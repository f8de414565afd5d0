"""Parts of shapes against NumPy and SciPy."""

import numpy as np
from scipy.sparse.csgraph import connected_components

from pointloom.kernels.lang import int32, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.segmentation.shape_parts import heights_across, largest_part, rows_labeled


def test_the_heights_of_planes_points_above_each_plane_are_bounds_to_a_step(device, rng):
    points, labels = rng.normal(size=(200, 3)).astype(np.float32), rng.integers(-1, 3, 200).astype(np.int32)
    positions, normals = rng.normal(size=(3, 3)), rng.normal(size=(3, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    low, high = heights_across(upload(points, vec3, device), labels, positions, normals, 1e-4)
    heights = np.einsum("njk,jk->nj", points[:, None] - positions, normals)
    for k in range(3):
        np.testing.assert_allclose(low[k], heights[labels == k].min(axis=0), rtol=0, atol=1.01e-4)
        np.testing.assert_allclose(high[k], heights[labels == k].max(axis=0), rtol=0, atol=1.01e-4)


def test_the_largest_part_is_that_of_scipy_and_rows_are_chosen_by_their_labels(device, rng):
    radius = 0.13
    points, rows = rng.random((300, 3)).astype(np.float32), np.flatnonzero(rng.random(300) < 0.7).astype(np.int32)
    chosen = points[rows].astype(float)
    near = np.linalg.norm(chosen[:, None] - chosen[None], axis=2) < radius
    numbers = connected_components(near)[1]
    sizes = np.bincount(numbers)
    assert (sizes == sizes.max()).sum() == 1 and len(sizes) > 1
    result = largest_part(upload(points, vec3, device), upload(rows, int32, device), radius)
    np.testing.assert_array_equal(download(result), rows[numbers == sizes.argmax()])
    labels = rng.integers(-1, 3, 300).astype(np.int32)
    result = rows_labeled(upload(labels, int32, device), upload(rows, int32, device), 1)
    np.testing.assert_array_equal(download(result), rows[labels[rows] == 1])
