"""Raw depth in meters, and pixels unprojected: what NumPy gives, element by element."""

import numpy as np
import pytest

from pointloom.kernels.algebra.camera import Camera
from pointloom.kernels.images.depth import RUN, PixelGrid, color_pixels, largest_depth, metric_depth, unproject_depth
from pointloom.kernels.lang import float32, uint8, uint16
from pointloom.kernels.memory import upload

from ..vectors import rotation


def meters(device, raw, dtype, scale, farthest):
    """Depth as NumPy, once the largest depth that comes with it was checked."""
    depth, largest = metric_depth(upload(raw, dtype, device), scale, farthest)
    assert largest_depth(largest) == depth.numpy().max(initial=0)
    return depth.numpy()


def test_raw_depth_is_divided_and_cut_behind_the_farthest(device):
    raw = np.array([0, 1, 1000, 2999, 3000, 3001, 65535], np.uint16)
    expected = np.where(raw <= 3000, raw.astype(np.float32) / np.float32(1000), 0)
    np.testing.assert_array_equal(meters(device, raw, uint16, 1000.0, 3.0), expected)
    expected = raw.astype(np.float32) / np.float32(5000)
    np.testing.assert_array_equal(meters(device, raw, uint16, 5000.0, np.inf), expected)


def test_valid_depth_in_meters_stays(device):
    raw = np.array([0, -1, np.nan, np.inf, -np.inf, 0.5, 3.0, 3.0001, 1e-30], np.float32)
    expected = np.array([0, 0, 0, 0, 0, 0.5, 3.0, 0, 1e-30], np.float32)
    np.testing.assert_array_equal(meters(device, raw, float32, 1.0, 3.0), expected)
    np.testing.assert_array_equal(meters(device, raw, float32, 4.0, 0.75), expected / 4)
    expected[7] = raw[7]
    for farthest in (1e30, np.inf):
        np.testing.assert_array_equal(meters(device, raw, float32, 1.0, farthest), expected)


@pytest.mark.parametrize("count", [1, RUN - 1, RUN, RUN + 1, 3 * RUN + 5])
def test_depth_of_any_number_of_pixels_is_converted(device, count, rng):
    raw = rng.integers(0, 65536, count).astype(np.uint16)
    expected = raw.astype(np.float32) / np.float32(1000)
    np.testing.assert_array_equal(meters(device, raw, uint16, 1000.0, 100.0), expected)
    np.testing.assert_array_equal(meters(device, expected, float32, 1.0, 100.0), expected)


@pytest.mark.parametrize("stride", [1, 2, 3, 7])
@pytest.mark.parametrize(("height", "width"), [(1, 1), (5, 7), (12, 9)])
def test_pixels_are_unprojected_with_the_pinhole_model(device, height, width, stride, rng):
    depth = (rng.random((height, width)) * 4).astype(np.float32)
    depth[rng.random((height, width)) < 0.3] = 0
    fx, fy, cx, cy = 5.5, 6.5, 3.2, 2.1
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = rotation(rng), [1, -2, 3]
    flat = upload(depth.reshape(-1), float32, device)
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
    pixels = upload(image.reshape(-1, 3), uint8, device)
    colors = color_pixels(pixels, grid).numpy()
    np.testing.assert_array_equal(colors, image[v, u].reshape(-1, 3).astype(np.float32) / np.float32(255))
