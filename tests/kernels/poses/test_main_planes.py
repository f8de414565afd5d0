"""The planes with the most points; the remaining points equal those of a brute-force search."""

import numpy as np
import pytest

from pointloom.kernels.lang import int64, uint8, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.poses.main_planes import VOTERS, MainPlanes, find_main_planes, leave_out_planes
from pointloom.kernels.search.nearest_point import NO_POINT

LIMITS = (0.02, 0.05, 0.9)  # tight, slab, cosine


def sheets(rng, counts, noise=0.002):
    """Points on planes with normals x, y, z in turn, two meters apart, and their normals."""
    points, normals = [], []
    for k, count in enumerate(counts):
        p = rng.uniform(-1, 1, (count, 3))
        p[:, k % 3] = 2.0 * (k // 3) + 1.5 + rng.normal(0, noise, count)
        n = rng.normal(0, 0.02, (count, 3))
        n[:, k % 3] += rng.choice([-1, 1], count)  # of either side
        points.append(p), normals.append(n / np.linalg.norm(n, axis=1, keepdims=True))
    order = rng.permutation(sum(counts))
    return np.concatenate(points)[order], np.concatenate(normals)[order]


def on_device(points, normals, device, rows=None):
    mask = np.zeros(len(points), np.uint8)
    mask[slice(None) if rows is None else rows] = 1
    return [upload(points, vec3, device), upload(normals, vec3, device), upload(mask, uint8, device)]


def planes_of(arrays, max_planes):
    return find_main_planes(*arrays, max_planes, *LIMITS).read()


def test_planes_are_ordered_by_their_number_of_points(device, rng):
    points, normals = sheets(rng, (500, 2000, 1000, 200))
    middles, directions = planes_of(on_device(points, normals, device), 3)
    assert np.abs(directions).argmax(axis=1).tolist() == [1, 2, 0]
    assert np.abs(directions).max(axis=1).min() > 0.9999
    heights = [middle[axis] for middle, axis in zip(middles, (1, 2, 0), strict=True)]
    np.testing.assert_allclose(heights, 1.5, atol=0.003)


def test_points_that_are_not_chosen_do_not_count(device, rng):
    points, normals = sheets(rng, (500, 2000, 1000))
    rows = np.flatnonzero(np.abs(normals[:, 1]) < 0.5)
    _, directions = planes_of(on_device(points, normals, device, rows), 3)
    assert np.abs(directions).argmax(axis=1).tolist()[:2] == [2, 0]


def test_parallel_planes_are_two(device, rng):
    points, normals = sheets(rng, (1500, 20, 20, 1000))
    middles, directions = planes_of(on_device(points, normals, device), 2)
    assert np.abs(directions).argmax(axis=1).tolist() == [0, 0]
    np.testing.assert_allclose(middles[:, 0], [1.5, 3.5], atol=0.003)


def test_large_clouds_are_subsampled(device, rng):
    points, normals = sheets(rng, (6 * VOTERS, 3 * VOTERS))
    _, directions = planes_of(on_device(points, normals, device), 2)
    assert np.abs(directions).argmax(axis=1).tolist() == [0, 1]


@pytest.mark.parametrize("count", [0, 1, 4])
def test_fewer_than_five_points_make_no_plane(device, rng, count):
    points, normals = sheets(rng, (count,))
    planes = planes_of(on_device(points, normals, device), 3)
    assert [values.shape for values in planes] == [(0, 3), (0, 3)]


def test_five_points_make_a_plane_even_if_they_coincide(device, rng):
    points, normals = sheets(rng, (5,))
    assert len(planes_of(on_device(points, normals, device), 3)[0]) == 1
    points, normals = np.tile(points[:1], (6, 1)), np.tile(normals[:1], (6, 1))
    middles, directions = planes_of(on_device(points, normals, device), 3)
    assert np.isfinite(middles).all() and np.isfinite(directions).all()


def test_planes_that_do_not_cross_have_no_edge(device):
    points, normals = np.array([[0, 0, 0.1], [0, 0, 0.01]]), np.array([[1.0, 0, 0], [0, 0.1, 0.995]])
    p, n, _ = on_device(points, normals, device)
    nearest = upload(np.array([4, 5]), int64, p.device)
    middles, directions = np.array([[0, 0, 0.2], [0, 0, 0]]), np.array([[0, 0, 1.0], [0, 0.1, -0.995]])
    leave_out_planes(p, n, MainPlanes.of(middles, directions, p.device), 0.05, 0.8, 0.25, nearest)
    assert download(nearest).tolist() == [4, NO_POINT]


def test_remaining_points_are_on_a_plane_or_an_intersection(device, rng):
    points = rng.uniform(-1, 1, (2000, 3))
    normals = rng.normal(size=(2000, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    middles, directions = np.array([[0.3, 0, 0], [0, -0.2, 0]]), np.array([[1.0, 0, 0], [0, -1, 0]])
    p, n, _ = on_device(points, normals, device)
    nearest = upload(np.arange(2000), int64, p.device)
    leave_out_planes(p, n, MainPlanes.of(middles, directions, p.device), 0.1, 0.8, 0.25, nearest)
    heights = np.abs(np.einsum("kj,ikj->ik", directions, points[:, None] - middles))
    on = ((heights < 0.1) & (np.abs(normals @ directions.T) > 0.8)).any(axis=1)
    left = ~on & ((heights < 0.25).sum(axis=1) < 2)
    assert on.sum() > 50 and (~left & ~on).sum() > 50
    np.testing.assert_array_equal(download(nearest), np.where(left, np.arange(2000), NO_POINT))
