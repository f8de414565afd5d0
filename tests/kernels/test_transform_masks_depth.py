"""Transforms, masks, depth images and orientation of normals: what float64 NumPy gives, element by element."""

from __future__ import annotations

import numpy as np
import pytest

from pointloom.kernels.algebra.camera import Camera
from pointloom.kernels.algebra.transform import transform_directions, transform_points
from pointloom.kernels.extent.masks import mask_aligned_box, mask_finite, mask_oriented_box
from pointloom.kernels.images.depth import RUN, PixelGrid, color_pixels, largest_depth, metric_depth, unproject_depth
from pointloom.kernels.lang import float32, uint8, uint16, vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.surface.normals import align_normals, orient_normals
from pointloom.pcd.devices import resolve_device


def vectors(device, values):
    return upload(np.asarray(values, np.float32).reshape(-1, 3), vec3, resolve_device(device))


def rotation(rng):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


@pytest.mark.parametrize("count", [0, 1, 2, 1001])
def test_points_are_mapped_in_float64_and_rounded_once(device, count, rng):
    points = rng.normal(size=(count, 3)).astype(np.float32)
    A, t = rng.normal(size=(3, 3)), rng.normal(size=3) * 1000
    found = transform_points(vectors(device, points), A, t).numpy()
    expected = points.astype(np.float64) @ A.T + t
    np.testing.assert_array_max_ulp(found, expected.astype(np.float32), 1)


def test_large_terms_that_cancel_leave_the_small_difference(device):
    """R p + t with both near 5e6: float32 arithmetic would leave half a metre of noise."""
    points = np.array([[5e6, 0, 0]], np.float32)
    found = transform_points(vectors(device, points), np.eye(3), [-4999999.875, 0, 0]).numpy()
    assert found.tolist() == [[0.125, 0, 0]]


def test_directions_keep_their_lengths_under_any_map(device, rng, tolerances):
    lengths = np.array([1.0, 0.25, 3.0, 1e-10, 1e10, 1.0])[:, None]
    n = rng.normal(size=(6, 3))
    n = (n / np.linalg.norm(n, axis=1, keepdims=True) * lengths).astype(np.float32)
    A = rng.normal(size=(3, 3)) * 100
    found = transform_directions(vectors(device, n), A).numpy().astype(np.float64)
    expected = n.astype(np.float64) @ A.T
    expected *= np.linalg.norm(n.astype(np.float64), axis=1, keepdims=True) / np.linalg.norm(
        expected, axis=1, keepdims=True
    )
    scale = np.linalg.norm(expected, axis=1, keepdims=True)
    assert (np.abs(found - expected) <= tolerances.float32_relative * scale).all()


def test_zero_and_nan_directions_stay(device):
    found = transform_directions(vectors(device, [[0, 0, 0], [np.nan, 1, 0]]), np.eye(3) * 2).numpy()
    assert found[0].tolist() == [0, 0, 0] and np.isnan(found[1]).any()


def test_points_on_the_faces_of_a_box_are_inside_it(device):
    points = np.stack(np.meshgrid(*[np.arange(-2, 3)] * 3), -1).reshape(-1, 3) / 2.0
    low, high = np.array([-0.5, -1.0, 0.0]), np.array([0.5, 0.5, 0.0])
    expected = ((points >= low) & (points <= high)).all(axis=1)
    assert 0 < expected.sum() < len(points)
    for origin in (np.zeros(3), np.array([5e5, 5.4e6, -3.0])):
        found = mask_aligned_box(vectors(device, points), origin, low + origin, high + origin).numpy()
        np.testing.assert_array_equal(found.astype(bool), expected)
        found = mask_oriented_box(
            vectors(device, points), origin - (origin + (low + high) / 2), np.eye(3), (high - low) / 2
        ).numpy()
        np.testing.assert_array_equal(found.astype(bool), expected)


def test_a_point_on_a_face_that_float32_cannot_hold_is_inside(device):
    """0.1 is stored as 0.10000000149: the bound is rounded in the same way."""
    points = vectors(device, [[0.1, 0.1, 0.1], [0.3, 0.7, 0.9]])
    assert mask_aligned_box(points, np.zeros(3), np.zeros(3), np.full(3, 0.1)).numpy().tolist() == [1, 0]
    assert mask_aligned_box(points, np.zeros(3), np.array([0.3, 0.7, 0.9]), np.ones(3)).numpy().tolist() == [0, 1]


def test_a_box_may_be_open_and_holds_no_nan(device):
    points = vectors(device, [[1e30, -1e30, 0], [np.nan, 0, 0], [0, 0, 2], [np.inf, 0, 0]])
    everywhere, below = np.full(3, np.inf), np.array([np.inf, np.inf, 1.0])
    assert mask_aligned_box(points, np.zeros(3), -everywhere, below).numpy().tolist() == [1, 0, 0, 1]
    assert mask_aligned_box(points, np.zeros(3), np.full(3, -1e300), everywhere).numpy().tolist() == [1, 0, 1, 1]
    assert mask_oriented_box(points, np.zeros(3), np.eye(3), np.full(3, 2.0)).numpy().tolist() == [0, 0, 1, 0]


def test_points_in_a_turned_box_are_those_of_numpy(device, rng):
    points = rng.normal(size=(3001, 3)).astype(np.float32)
    R, center, extent = rotation(rng), np.array([0.2, -0.1, 0.3]), np.array([1.0, 2.0, 0.5])
    local = (points.astype(np.float64) - center) @ R
    expected = (np.abs(local) <= extent / 2).all(axis=1)
    assert expected.sum() > 50
    found = mask_oriented_box(vectors(device, points), -center, R.T, extent / 2).numpy()
    np.testing.assert_array_equal(found.astype(bool), expected)


@pytest.mark.parametrize("drop_nan", [True, False])
@pytest.mark.parametrize("drop_infinite", [True, False])
def test_each_kind_of_number_that_is_not_finite_is_dropped_where_asked(device, drop_nan, drop_infinite):
    points = [[0, 0, 0], [np.nan, 0, 0], [0, np.inf, 0], [0, 0, -np.inf], [np.nan, np.inf, 0], [3e38, 3e38, 3e38]]
    has_nan, has_infinite = np.array([0, 1, 0, 0, 1, 0], bool), np.array([0, 0, 1, 1, 1, 0], bool)
    expected = ~((has_nan & drop_nan) | (has_infinite & drop_infinite))
    found = mask_finite(vectors(device, points), drop_nan, drop_infinite).numpy()
    np.testing.assert_array_equal(found.astype(bool), expected)


def metres(device, raw, dtype, scale, farthest):
    """Depth as NumPy, once the largest depth that comes with it was checked."""
    depth, largest = metric_depth(upload(raw, dtype, resolve_device(device)), scale, farthest)
    assert largest_depth(largest) == depth.numpy().max(initial=0)
    return depth.numpy()


def test_raw_depth_is_divided_and_cut_behind_the_farthest(device):
    raw = np.array([0, 1, 1000, 2999, 3000, 3001, 65535], np.uint16)
    expected = np.where(raw <= 3000, raw.astype(np.float32) / np.float32(1000), 0)
    np.testing.assert_array_equal(metres(device, raw, uint16, 1000.0, 3.0), expected)
    expected = raw.astype(np.float32) / np.float32(5000)
    np.testing.assert_array_equal(metres(device, raw, uint16, 5000.0, np.inf), expected)


def test_depth_in_metres_is_kept_where_it_is_a_measurement(device):
    raw = np.array([0, -1, np.nan, np.inf, -np.inf, 0.5, 3.0, 3.0001, 1e-30], np.float32)
    expected = np.array([0, 0, 0, 0, 0, 0.5, 3.0, 0, 1e-30], np.float32)
    np.testing.assert_array_equal(metres(device, raw, float32, 1000.0, 3.0), expected)
    expected[7] = raw[7]
    for farthest in (1e30, np.inf):
        np.testing.assert_array_equal(metres(device, raw, float32, 1000.0, farthest), expected)


@pytest.mark.parametrize("count", [1, RUN - 1, RUN, RUN + 1, 3 * RUN + 5])
def test_depth_of_any_number_of_pixels_is_converted(device, count, rng):
    raw = rng.integers(0, 65536, count).astype(np.uint16)
    expected = raw.astype(np.float32) / np.float32(1000)
    np.testing.assert_array_equal(metres(device, raw, uint16, 1000.0, 100.0), expected)
    np.testing.assert_array_equal(metres(device, expected, float32, 1.0, 100.0), expected)


@pytest.mark.parametrize("stride", [1, 2, 3, 7])
@pytest.mark.parametrize(("height", "width"), [(1, 1), (5, 7), (12, 9)])
def test_pixels_are_unprojected_as_the_pinhole_model_says(device, height, width, stride, rng):
    depth = (rng.random((height, width)) * 4).astype(np.float32)
    depth[rng.random((height, width)) < 0.3] = 0
    fx, fy, cx, cy = 5.5, 6.5, 3.2, 2.1
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = rotation(rng), [1, -2, 3]
    flat = upload(depth.reshape(-1), float32, resolve_device(device))
    grid = PixelGrid(width, height, stride)
    points, valid = unproject_depth(flat, grid, Camera(width, height, fx, fy, cx, cy), T)
    v, u = np.mgrid[0:height:stride, 0:width:stride]
    assert (grid.rows, grid.columns) == u.shape
    z = depth[v, u].astype(np.float64)
    local = np.stack([(u - cx) * z / fx, (v - cy) * z / fy, z], -1).reshape(-1, 3)
    expected = np.where((z > 0).reshape(-1, 1), local @ T[:3, :3].T + T[:3, 3], np.nan)
    np.testing.assert_array_equal(valid.numpy().astype(bool), (z > 0).reshape(-1))
    np.testing.assert_allclose(points.numpy(), expected, rtol=6.1e-8, atol=1e-14)
    image = rng.integers(0, 256, (height, width, 3)).astype(np.uint8)
    pixels = upload(image.reshape(-1, 3), uint8, resolve_device(device))
    colors = color_pixels(pixels, grid).numpy()
    np.testing.assert_array_equal(colors, image[v, u].reshape(-1, 3).astype(np.float32) / np.float32(255))


def test_normals_are_turned_to_a_direction_or_a_point(device, rng):
    points, n = rng.normal(size=(500, 3)).astype(np.float32), rng.normal(size=(500, 3)).astype(np.float32)
    direction, place = np.array([0.3, -2, 0.5]), np.array([0.1, 0.2, 5.0])
    found = orient_normals(vectors(device, points), vectors(device, n), direction, False).numpy()
    assert (found @ direction > 0).all() and (np.abs(found) == np.abs(n)).all()
    found = orient_normals(vectors(device, points), vectors(device, n), place, True).numpy()
    assert ((found * (place - points)).sum(axis=1) > 0).all() and (np.abs(found) == np.abs(n)).all()


def test_zero_normals_take_the_direction_and_nan_normals_stay(device, tolerances):
    points, n = (
        vectors(device, [[0, 0, 0], [1, 1, 1], [2, 0, 0]]),
        vectors(device, [[0, 0, 0], [np.nan] * 3, [0, 0, 0]]),
    )
    found = orient_normals(points, n, [0, 3, 4], False).numpy()
    np.testing.assert_allclose(found[[0, 2]], [[0, 0.6, 0.8]] * 2, rtol=tolerances.unit_length)
    assert np.isnan(found[1]).all()
    found = orient_normals(points, n, [2, 0, 0], True).numpy()
    assert found[0].tolist() == [1, 0, 0] and found[2].tolist() == [0, 0, 1], "a camera on the point gives the z axis"


def test_normals_follow_their_references_in_place(device):
    n = vectors(device, [[0, 0, 1], [0, 0, 1], [0, 0, 1], [1, 0, 0]])
    align_normals(n, vectors(device, [[0, 0, -2], [0, 1, 0.1], [np.nan] * 3, [0, 1, 0]]))
    assert n.numpy().tolist() == [[0, 0, -1], [0, 0, 1], [0, 0, 1], [1, 0, 0]]
