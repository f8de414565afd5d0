"""Normals from lists of neighbors."""

import numpy as np

from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import int64, vec3d
from pointloom.kernels.memory import upload
from pointloom.kernels.surface.listed_normals import fit_listed_normals


def test_normals_are_the_smallest_axes_of_the_listed_neighbors(device, rng):
    points = rng.random((300, 3)) * [1.0, 1.0, 0.1] + [5e5, 5e6, 100.0]
    neighbors = rng.integers(0, 300, (300, 12))
    neighbors[::3, 8:], neighbors[::7, 2:] = -1, -1  # fewer neighbors, and too few for a plane
    where = resolve_device(device)
    normals = fit_listed_normals(upload(points, vec3d, where), upload(neighbors, int64, where)).numpy()
    for rows, normal in zip(neighbors, normals, strict=True):
        listed = points[rows[rows >= 0]]
        if len(listed) < 3:
            assert normal.tolist() == [0, 0, 1]
            continue
        values, axes = np.linalg.eigh(np.cov(listed.T, bias=True))
        assert abs(normal @ axes[:, 0]) > 1 - 1e-6 * values[1] / (values[1] - values[0])
