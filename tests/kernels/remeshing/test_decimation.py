"""Triangles that share no edge, triangles that are listed twice, and triangles that name a vertex twice."""

import numpy as np
import pytest

from pointloom.kernels.lang import vec3, vec3i
from pointloom.kernels.memory import download, upload
from pointloom.kernels.remeshing.decimation import Decimation


@pytest.mark.parametrize("target", [1, 2, 3])
def test_the_smallest_isolated_triangles_are_removed_first(device, target):
    """Four lone triangles, one of them without area. One is repeated, and one more names a vertex twice."""
    sizes = np.array([3.0, 1.0, 0.0, 2.0])
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    points = np.concatenate([corners * size + [10 * k, 0, 0] for k, size in enumerate(sizes)])
    triangles = np.vstack([np.arange(12).reshape(4, 3), [[1, 2, 0]], [[3, 4, 3]]])
    arrays = [upload(points, vec3, device)]
    decimation = Decimation(upload(triangles, vec3i, device), arrays, [], None, None, target, np.inf, 1.0)
    decimation.run()
    result, (positions, *_), _, _ = decimation.result()
    edges = download(positions)[download(result)]
    areas = np.linalg.norm(np.cross(edges[:, 1] - edges[:, 0], edges[:, 2] - edges[:, 0]), axis=1)
    np.testing.assert_allclose(np.sort(areas), np.sort(sizes**2)[-target:], rtol=1e-6)
