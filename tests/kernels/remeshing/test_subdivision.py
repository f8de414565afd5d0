"""Loop's masks where a vertex has three neighbors, and where a triangle runs an edge twice."""

import numpy as np

from pointloom.kernels.lang import vec3d, vec3i
from pointloom.kernels.memory import download, upload
from pointloom.kernels.remeshing.subdivision import EdgeSplit, mask

TETRAHEDRON = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def masked(device, points, triangles) -> tuple[np.ndarray, EdgeSplit]:
    faces = upload(triangles, vec3i, device)
    split = EdgeSplit(faces, len(points))
    return download(mask(faces, split, [upload(points, vec3d, device)])[0]), split


def test_a_tetrahedron_is_masked_by_the_weights_of_three_neighbors(device, rng):
    points = rng.normal(size=(4, 3))
    result, split = masked(device, points, TETRAHEDRON)
    total = points.sum(axis=0)
    np.testing.assert_allclose(result[:4], 7 / 16 * points + 3 / 16 * (total - points), rtol=0, atol=1e-14)
    ends = points[download(split.edges.lows)] + points[download(split.edges.highs)]
    np.testing.assert_allclose(result[download(split.numbers)], 3 / 8 * ends + (total - ends) / 8, rtol=0, atol=1e-14)


def test_a_triangle_that_runs_an_edge_twice_counts_once(device, rng):
    """Edge (0, 1) has two triangles, of which the first runs it twice and has vertex 0 for its third one."""
    points = rng.normal(size=(3, 3))
    result, split = masked(device, points, np.array([[0, 1, 0], [0, 1, 2]]))
    edge = np.flatnonzero((download(split.edges.lows) == 0) & (download(split.edges.highs) == 1))[0]
    expected = 3 / 8 * (points[0] + points[1]) + (points[0] + points[2]) / 8
    np.testing.assert_allclose(result[download(split.numbers)[edge]], expected, rtol=0, atol=1e-14)
