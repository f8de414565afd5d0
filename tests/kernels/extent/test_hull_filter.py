"""The farthest points by direction, and the points that a coarse hull does not enclose, against NumPy."""

import numpy as np
import pytest

from pointloom.kernels.extent.hull_filter import farthest_rows, mask_outer
from pointloom.kernels.lang import vec3d
from pointloom.kernels.memory import download, upload


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
    assert mask[:2].tolist() == [0, 0]
    assert (mask[2:][~inside] == 1).all()
    assert (mask[2:][inside & (points[2:, 2] < -0.2)] == (0 if is_full else 1)).mean() > 0.8
    assert (mask[2:][inside & is_covered] == 0).mean() > 0.8
