"""Central hulls against Qhull, the points outside a coarse hull, and masks of boxes and finite points against NumPy."""

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from pointloom.kernels.extent.central_hull import find_central_hull
from pointloom.kernels.extent.hull_filter import farthest_rows, mask_outer
from pointloom.kernels.extent.masks import mask_aligned_box, mask_finite, mask_oriented_box
from pointloom.kernels.lang import vec3d
from pointloom.kernels.memory import download, upload

from ..vectors import vectors


def rows_of(triangles):
    return {tuple(sorted(t)) for t in np.asarray(triangles).tolist()}


@pytest.mark.parametrize("center", ["inside", "outside"])
def test_the_triangles_are_those_of_qhull(center, rng):
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
    assert find_central_hull(cube) is None and find_central_hull(np.zeros((0, 3))) is None


def test_an_uncertain_point_is_inserted_after_the_others(rng):
    """Two points on one ray: the second is below a facet at the center only until there are others."""
    points = np.concatenate([[[1, 0, 0], [0.5, 0, 0]], rng.normal(size=(200, 3))])
    points[2:] /= np.linalg.norm(points[2:], axis=1, keepdims=True)
    triangles, outer = find_central_hull(points), np.delete(np.arange(202), 1)
    assert triangles is not None
    assert rows_of(triangles) == rows_of(outer[ConvexHull(points[outer]).simplices])


def test_the_farthest_point_of_each_cube_face_is_selected(device, rng):
    center = np.array([0.1, -0.2, 0.3])
    points = np.vstack([[[np.nan, 0, 0], [0, np.inf, 0]], [center], rng.normal(size=(200, 3))])
    gaps = points - center
    distances = np.linalg.norm(gaps, axis=1)
    faces = 2 * np.abs(gaps[3:]).argmax(axis=1)
    faces += np.take_along_axis(gaps[3:], faces[:, None] // 2, axis=1)[:, 0] > 0
    expected = [3 + max(np.flatnonzero(faces == face), key=lambda row: distances[3 + row]) for face in range(6)]
    rows = farthest_rows(upload(points, vec3d, device), center, 1)
    assert sorted(rows.tolist()) == sorted(expected)


@pytest.mark.parametrize("is_full", [True, False])
def test_only_interior_and_non_finite_points_are_dropped(device, rng, is_full):
    signs = np.array([[x, y, z] for z in ((1, -1) if is_full else (1,)) for x in (1, -1) for y in (1, -1)], float)
    corners = signs[:, :, None] * np.eye(3)
    flipped = np.linalg.det(corners) < 0
    corners[flipped] = corners[flipped][:, ::-1]
    planes = np.column_stack([signs, -np.ones(len(signs))]) / np.sqrt(3)
    center = np.array([0.1, -0.2, 0.3])
    points = np.vstack([[[np.nan, 0, 0], [0, np.inf, 0], [0, 0, 0]], rng.uniform(-1, 1, (500, 3))])
    planes[:, 3] -= planes[:, :3] @ center
    mask = download(mask_outer(upload(points + center, vec3d, device), center, corners + center, planes, 8))
    inside = np.abs(points[2:]).sum(axis=1) < 1
    is_covered = np.ones(501, bool) if is_full else points[2:, 2] > 0.2
    assert mask[:2].tolist() == [0, 0] and (mask[2:][~inside] == 1).all()
    assert (mask[2:][inside & (points[2:, 2] < -0.2)] == (0 if is_full else 1)).mean() > 0.8
    assert (mask[2:][inside & is_covered] == 0).mean() > 0.8


def test_a_box_may_be_unbounded_and_contains_no_nan(device):
    points = vectors(device, [[1e30, -1e30, 0], [np.nan, 0, 0], [0, 0, 2], [np.inf, 0, 0]])
    everywhere, below = np.full(3, np.inf), np.array([np.inf, np.inf, 1.0])
    assert mask_aligned_box(points, np.zeros(3), -everywhere, below).numpy().tolist() == [1, 0, 0, 1]
    assert mask_aligned_box(points, np.zeros(3), np.full(3, -1e300), everywhere).numpy().tolist() == [1, 0, 1, 1]
    assert mask_oriented_box(points, np.zeros(3), np.eye(3), np.full(3, 2.0)).numpy().tolist() == [0, 0, 1, 0]


@pytest.mark.parametrize("drop_nan", [True, False])
@pytest.mark.parametrize("drop_infinite", [True, False])
def test_each_kind_of_non_finite_number_is_dropped_on_request(device, drop_nan, drop_infinite):
    points = [[0, 0, 0], [np.nan, 0, 0], [0, np.inf, 0], [0, 0, -np.inf], [np.nan, np.inf, 0], [3e38, 3e38, 3e38]]
    has_nan, has_infinite = np.array([0, 1, 0, 0, 1, 0], bool), np.array([0, 0, 1, 1, 1, 0], bool)
    expected = ~((has_nan & drop_nan) | (has_infinite & drop_infinite))
    mask = mask_finite(vectors(device, points), drop_nan, drop_infinite).numpy()
    np.testing.assert_array_equal(mask.astype(bool), expected)
