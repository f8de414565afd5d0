"""The farthest points by direction, and the points that a coarse hull does not enclose, against NumPy."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.extent.hull_filter import farthest_rows, mask_outer
from pointloom.kernels.lang import vec3d
from pointloom.kernels.memory import download, upload


def test_the_farthest_point_of_each_face_of_a_cube_map_is_found_beside_points_without_a_direction(device, rng):
    center = np.array([0.1, -0.2, 0.3])
    points = np.vstack([[[np.nan, 0, 0], [0, np.inf, 0]], [center], rng.normal(size=(200, 3))])
    gaps = points - center
    reach = np.linalg.norm(gaps, axis=1)
    faces = 2 * np.abs(gaps[3:]).argmax(axis=1)
    faces += np.take_along_axis(gaps[3:], faces[:, None] // 2, axis=1)[:, 0] > 0
    expected = [3 + max(np.flatnonzero(faces == face), key=lambda row: reach[3 + row]) for face in range(6)]
    found = farthest_rows(upload(points, vec3d, resolve_device(device)), center, 1)
    assert sorted(found.tolist()) == sorted(expected)


@pytest.mark.parametrize("is_whole", [True, False])
def test_only_points_strictly_inside_the_facets_of_a_hull_are_left_out_and_those_that_are_not_finite(
    device, rng, is_whole
):
    signs = np.array([[x, y, z] for z in ((1, -1) if is_whole else (1,)) for x in (1, -1) for y in (1, -1)], float)
    corners = signs[:, :, None] * np.eye(3)
    turned = np.linalg.det(corners) < 0
    corners[turned] = corners[turned][:, ::-1]
    planes = np.column_stack([signs, -np.ones(len(signs))]) / np.sqrt(3)
    center = np.array([0.1, -0.2, 0.3])
    points = np.vstack([[[np.nan, 0, 0], [0, np.inf, 0], [0, 0, 0]], rng.uniform(-1, 1, (500, 3))])
    planes[:, 3] -= planes[:, :3] @ center
    place = resolve_device(device)
    found = download(mask_outer(upload(points + center, vec3d, place), center, corners + center, planes, 8))
    inside = np.abs(points[2:]).sum(axis=1) < 1
    is_covered = np.ones(501, bool) if is_whole else points[2:, 2] > 0.2
    assert found[:2].tolist() == [0, 0]
    assert (found[2:][~inside] == 1).all()
    assert (found[2:][inside & (points[2:, 2] < -0.2)] == (0 if is_whole else 1)).mean() > 0.8
    assert (found[2:][inside & is_covered] == 0).mean() > 0.8
