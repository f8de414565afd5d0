"""Raw depth in meters, unprojected pixels, and flying pixels between two surfaces, which are removed."""

import numpy as np
import pytest

from pointloom.kernels.algebra.camera import Camera
from pointloom.kernels.images.depth import (
    PIXELS_PER_RUN,
    PixelGrid,
    color_pixels,
    largest_depth,
    metric_depth,
    unproject_depth,
)
from pointloom.kernels.images.flying_pixels import drop_flying
from pointloom.kernels.lang import float32, uint8, uint16
from pointloom.kernels.memory import download, upload

from ..vectors import rotation


def meters(device, raw, dtype, scale, farthest):
    """Depth as NumPy, once the largest depth that comes with it was checked."""
    depth, largest = metric_depth(upload(raw, dtype, device), scale, farthest)
    assert largest_depth(largest) == depth.numpy().max(initial=0)
    return depth.numpy()


@pytest.mark.parametrize("count", [1, PIXELS_PER_RUN - 1, PIXELS_PER_RUN, PIXELS_PER_RUN + 1, 3 * PIXELS_PER_RUN + 5])
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


def filtered(depth, device, radius=4, jump=0.03):
    depth = np.asarray(depth, np.float32)
    height, width = depth.shape
    flat = upload(np.ascontiguousarray(depth).reshape(-1), float32, device)
    return download(drop_flying(flat, width, height, radius, jump)).reshape(height, width)


def ramp_between(near, far, steps, width=60, height=9):
    """Two walls with inverse depth that runs from one to the other over so many pixels."""
    t = np.clip((np.arange(width) - width // 2) / (steps + 1), 0, 1)
    return np.tile(1 / ((1 - t) / near + t / far), (height, 1)), (t > 0) & (t < 1)


@pytest.mark.parametrize("steps", [1, 2, 3, 4])
@pytest.mark.parametrize("transposed", [False, True])
def test_a_ramp_between_two_walls_is_removed_and_the_walls_stay(device, steps, transposed):
    depth, flies = ramp_between(1.0, 3.0, steps)
    result = filtered(depth.T, device).T if transposed else filtered(depth, device)
    np.testing.assert_array_equal(result == 0, np.tile(flies, (9, 1)))
    np.testing.assert_array_equal(result[:, ~flies], depth.astype(np.float32)[:, ~flies])


def test_slanted_planes_stay(device):
    v, u = np.mgrid[:80, :120]
    for tilt in (0.0, 0.01, 0.1):  # inverse depth a pixel, of 0.2: at 0.1 the plane is seen almost along itself
        depth = 1 / (0.2 + tilt * u + 0.02 * tilt * v)
        np.testing.assert_array_equal(filtered(depth, device, radius=16), depth.astype(np.float32))


def test_a_corner_of_a_room_a_sharp_edge_and_a_thin_post_before_a_wall_stay(device):
    u = np.tile(np.arange(60.0), (9, 1))
    posts = [np.where((u >= 30) & (u < 30 + width), 1.0, 3.0) for width in (1, 2, 3, 4, 6)]
    for depth in (1 / (0.3 + 0.01 * np.abs(u - 30)), np.where(u < 30, 1.0, 3.0), *posts):
        np.testing.assert_array_equal(filtered(depth, device), depth.astype(np.float32))


def test_holes_are_no_surface_and_stay_holes(device):
    depth, _ = ramp_between(1.0, 3.0, 3)
    depth[:, :32] = 0
    result = filtered(depth, device)
    np.testing.assert_array_equal(result, depth.astype(np.float32))  # nothing to fly from
    assert not filtered(np.zeros((1, 1)), device).any() and filtered(np.ones((1, 7)), device).all()


def test_a_plain_python_reading_of_the_rule_agrees(device):
    depth = np.random.default_rng(3).uniform(1, 1.3, (13, 17)).astype(np.float32)
    depth[np.random.default_rng(4).random((13, 17)) < 0.1] = 0
    w = np.where(depth > 0, np.float32(1) / np.where(depth > 0, depth, np.float32(1)), np.float32(0))

    def flies(line, i):
        for r in range(1, 4):
            if i - 2 * r < 0 or i + 2 * r >= len(line):
                continue
            a1, a2, b1, b2 = line[i - r], line[i - 2 * r], line[i + r], line[i + 2 * r]
            if 0 in (a1, a2, b1, b2):
                continue
            limit = np.float32(0.03) * line[i]
            pairs = [(line[i] - a, line[i] - b) for a, b in ((a1 + a1 - a2, b1 + b1 - b2), (a1, b1))]
            if all(min(abs(a), abs(b)) > limit and a * b < 0 for a, b in pairs):
                return True
        return False

    expected = depth.copy()
    for v, u in zip(*np.nonzero(depth), strict=True):
        if flies(w[v], u) or flies(w[:, u], v):
            expected[v, u] = 0
    assert 0 < (expected == 0).sum() - (depth == 0).sum() < depth.size
    np.testing.assert_array_equal(filtered(depth, device, radius=3), expected)
