"""The hull of a center and points around it: Qhull's triangles, and none if a sign is uncertain."""

import numpy as np
import pytest

from pointloom.kernels.extent.central_hull import find_central_hull


def rows_of(triangles):
    return {tuple(sorted(t)) for t in np.asarray(triangles).tolist()}


@pytest.mark.parametrize("center", ["inside", "outside"])
def test_the_triangles_are_those_of_qhull(center, rng):
    from scipy.spatial import ConvexHull

    points = rng.normal(size=(3000, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True) * rng.uniform(1, 1.01, (3000, 1))
    if center == "outside":
        points = points[points[:, 2] > 0.3]
    triangles = find_central_hull(points)
    assert triangles is not None
    full = triangles[(triangles >= 0).all(axis=1)]
    qhull = ConvexHull(np.concatenate([points, np.zeros((1, 3))]), qhull_options="Qt")
    assert rows_of(full) == rows_of(qhull.simplices[(qhull.simplices < len(points)).all(axis=1)])
    a, b, c = (points[full[:, k]] for k in range(3))
    assert (np.einsum("ij,ij->i", np.cross(a, b), c) > 0).all(), "counterclockwise from outside"
    assert (len(full) == len(triangles)) == (center == "inside")


def test_the_first_of_equal_points_is_the_vertex(rng):
    points = rng.normal(size=(50, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    assert rows_of(find_central_hull(np.repeat(points, 2, axis=0))) == rows_of(2 * find_central_hull(points))


def test_four_points_in_a_facet_have_no_certain_triangles():
    cube = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    assert find_central_hull(cube) is None
    assert find_central_hull(np.zeros((0, 3))) is None


def test_an_uncertain_point_is_inserted_after_the_others(rng):
    """Two points on one ray: the second is below a facet at the center only until there are others."""
    points = np.concatenate([[[1, 0, 0], [0.5, 0, 0]], rng.normal(size=(200, 3))])
    points[2:] /= np.linalg.norm(points[2:], axis=1, keepdims=True)
    triangles = find_central_hull(points)
    assert triangles is not None and 1 not in triangles
