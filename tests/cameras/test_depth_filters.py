"""Filters on depth images: Open3D's where there are no holes, and holes that neither count nor are filled."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.cameras.depth_filters import create_depth_pyramid, create_normal_map, pyrdown_color, pyrdown_depth


def _small(seed, height, width, holes):
    rng = np.random.default_rng(seed)
    depth = (1 + rng.integers(0, 3, (height, width)) * 0.5 + 0.02 * rng.random((height, width))).astype(np.float32)
    depth[rng.random((height, width)) < holes] = 0
    return depth


small_depths = st.builds(_small, st.integers(0, 2**32 - 1), st.integers(1, 9), st.integers(1, 9), st.floats(0, 0.6))


def tensor_image(o3d, array):
    pixels = np.array(array, order="C")
    return o3d.t.geometry.Image(o3d.core.Tensor(pixels[..., None] if pixels.ndim == 2 else pixels))


def pixels_of(image):
    pixels = image.as_tensor().numpy()
    return pixels[:, :, 0] if pixels.shape[2] == 1 else pixels


BILATERAL = [(3, 0.03, 1.5), (4, 20.0, 10.0), (5, 0.002, 1.0), (7, 0.03, 1.5), (7, 20.0, 10.0)]


def relief(rng):
    v, u = np.mgrid[:24, :40]
    depth = np.where(u < 20, 1 + 0.01 * v, 1.3 + 0.02 * u) + 0.004 * rng.normal(size=u.shape)
    return depth.astype(np.float32)


def open3d_bilateral(o3d, depth):
    return [pixels_of(tensor_image(o3d, depth).filter_bilateral(*limits)) for limits in BILATERAL]


def test_bilateral_depth_matches_open3d(device, rng, oracle, tolerances):
    depth = relief(rng)
    for limits, expected in zip(BILATERAL, oracle("cameras/bilateral", open3d_bilateral, depth), strict=True):
        result = loom.filter_depth_bilateral(depth, *limits, device=device)
        np.testing.assert_allclose(result, expected, rtol=tolerances.depth_filter_relative)
        assert np.abs(result - depth).max() > 1e-4
    np.testing.assert_array_equal(loom.filter_depth_bilateral(depth, 1, device=device), depth)


@settings(derandomize=True, deadline=None, max_examples=20)
@given(depth=small_depths, kernel_size=st.integers(1, 6))
def test_holes_neither_count_in_the_bilateral_filter_nor_are_filled(depth, kernel_size):
    h, w = depth.shape
    r = kernel_size // 2
    expected = np.zeros((h, w))
    for v, u in zip(*np.nonzero(depth), strict=True):
        total = weights = 0.0
        for dv in range(-r, r + 1):
            for du in range(-r, r + 1):
                d = float(depth[min(max(v + dv, 0), h - 1), min(max(u + du, 0), w - 1)])
                if d > 0 and du * du + dv * dv <= r * r:
                    step, sqdist = d - float(depth[v, u]), du * du + dv * dv
                    weight = np.exp(-(step**2) / (2 * 0.3**2) - sqdist / (2 * 1.5**2))
                    total, weights = total + weight * d, weights + weight
        expected[v, u] = total / weights
    result = loom.filter_depth_bilateral(depth, kernel_size, 0.3, 1.5)
    np.testing.assert_array_equal(result == 0, depth == 0)
    np.testing.assert_allclose(result, expected, rtol=1e-6)


@settings(derandomize=True, deadline=None, max_examples=20)
@given(depth=small_depths, radius=st.integers(0, 3), threshold=st.sampled_from([0.1, 0.7, 3.0]))
def test_pixels_beside_edges_and_holes_are_dropped(depth, radius, threshold):
    h, w = depth.shape
    expected = depth.copy()
    for v in range(h):
        for u in range(w):
            part = depth[max(v - radius, 0) : v + radius + 1, max(u - radius, 0) : u + radius + 1]
            steps = [np.abs(np.diff(part, axis=axis)).max(initial=0) for axis in (0, 1)]
            if (part == 0).any() or max(steps) > np.float32(threshold):
                expected[v, u] = 0
    np.testing.assert_array_equal(loom.erode_depth_edges(depth, radius, threshold), expected)


def test_erosion_takes_the_radius_on_each_side_and_no_border(device):
    depth = np.where(np.arange(20) < 10, 1.0, 2.0) * np.ones((7, 1))
    result = loom.erode_depth_edges(depth, 3, 0.5, device=device)
    np.testing.assert_array_equal(result[0] == 0, (np.arange(20) >= 7) & (np.arange(20) < 13))
    assert (result == result[0]).all() and (loom.erode_depth_edges(depth, 3, 1.5, device=device) == depth).all()


def open3d_pyramid(o3d, depth, matrix):
    """The normal map of a depth image, and points with normals at half and quarter size, downsampled by Open3D."""
    image = tensor_image(o3d, depth).clip_transform(1.0, 0.0, 100.0, 0.0)
    maps = [pixels_of(image.create_vertex_map(o3d.core.Tensor(matrix)).create_normal_map())]
    for stride in (2, 4):
        cloud = o3d.t.geometry.PointCloud.create_from_depth_image(
            tensor_image(o3d, depth), o3d.core.Tensor(matrix), depth_scale=1.0, depth_max=100.0, stride=stride,
            with_normals=True,
        )  # fmt: skip
        maps += [cloud.point.positions.numpy(), cloud.point.normals.numpy()]
    return maps


def test_normals_and_halved_depth_match_open3d(device, rng, oracle, tolerances):
    """Through its clouds with normals, which come from a pyramid: there is no other way to it from Python.

    Open3D divides normals by at least 1e-5, so they are too short where pixels cover less than 1e-5 m^2.
    """
    depth = relief(rng)
    depth[rng.random(depth.shape) < 0.1] = 0
    camera = loom.PinholeCameraIntrinsic(40, 24, 525.0, 525.0, 19.5, 11.5)
    normals, *levels = oracle("cameras/pyramid", open3d_pyramid, depth, camera.matrix)
    result = create_normal_map(depth, camera, device=device)
    empty = (normals == 0).all(axis=2)
    np.testing.assert_array_equal((result == 0).all(axis=2), empty)
    lengths = np.linalg.norm(normals, axis=2)[~empty]
    assert lengths.min() < 0.7
    np.testing.assert_allclose(np.linalg.norm(result, axis=2)[~empty], 1, atol=tolerances.unit_length)
    np.testing.assert_allclose(result[~empty], normals[~empty] / lengths[:, None], atol=tolerances.normal_map)
    np.testing.assert_array_equal(np.isnan(create_normal_map(depth, camera, np.nan, device=device)).all(axis=2), empty)
    for stride, points, expected in zip((2, 4), levels[::2], levels[1::2], strict=True):
        halved = create_depth_pyramid(depth, stride.bit_length(), device=device)[-1]
        assert halved.shape == (24 // stride, 40 // stride)
        np.testing.assert_array_equal(halved > 0, depth[::stride, ::stride] > 0)
        f, cx, cy = 525 / stride, 19.5 / stride, 11.5 / stride
        smaller = loom.PinholeCameraIntrinsic(40 // stride, 24 // stride, f, f, cx, cy)
        from_depth = loom.PointCloud.create_from_depth_image(halved, smaller, with_normals=True, device=device)
        limits = {"rtol": tolerances.depth_filter_relative, "atol": tolerances.image_absolute}
        np.testing.assert_allclose(from_depth.points, points, **limits)
        np.testing.assert_allclose(from_depth.normals, expected, atol=tolerances.normal_map)


@settings(derandomize=True, deadline=None, max_examples=20)
@given(depth=small_depths, threshold=st.sampled_from([0.1, 0.6, 5.0]))
def test_holes_and_other_surfaces_do_not_count_in_halved_depth(depth, threshold):
    h, w = depth.shape
    if min(h, w) < 2:
        with pytest.raises(ValueError, match="depth:"):
            pyrdown_depth(depth)
        return
    weights = np.array([1, 4, 6, 4, 1]) / 16
    expected = np.zeros((h // 2, w // 2))
    for row, column in np.ndindex(*expected.shape):
        center = depth[2 * row, 2 * column]
        if center > 0:
            total = count = 0.0
            for y in range(max(2 * row - 2, 0), min(2 * row + 3, h)):
                for x in range(max(2 * column - 2, 0), min(2 * column + 3, w)):
                    if depth[y, x] > 0 and abs(depth[y, x] - center) < np.float32(threshold):
                        weight = weights[y - 2 * row + 2] * weights[x - 2 * column + 2]
                        total, count = total + weight * depth[y, x], count + weight
            expected[row, column] = total / count
    np.testing.assert_allclose(pyrdown_depth(depth, threshold), expected, rtol=3e-7)


@pytest.mark.parametrize(("threshold", "edge"), [(0.05, 1.0), (0.2, 1 + 0.1 * 5 / 16)])
def test_levels_average_depth_within_the_threshold(device, threshold, edge):
    """Of the weights 1, 4, 6, 4 and 1, those of the two columns beyond an edge of 0.1 m are 5 of 16."""
    depth = np.where(np.arange(16) < 5, 1.0, 1.1) * np.ones((8, 1))
    level = create_depth_pyramid(depth, 2, threshold, device=device)[1]
    np.testing.assert_allclose(level[:, [0, 2, 6]], [[1.0, edge, 1.1]] * 4, rtol=3e-7)


def open3d_pyrdown(o3d, images):
    return [pixels_of(tensor_image(o3d, image).pyrdown()) for image in images]


def test_halved_colors_match_open3d(device, rng, oracle):
    color, depth = rng.integers(0, 256, (36, 40, 3)).astype(np.uint8), relief(rng)
    image = loom.RGBDImage.create_from_color_and_depth(color[:24], depth, device=device)
    sources = [color, color[:, :, 1], np.array(image.color)]
    rgb, green, brightness = oracle("cameras/halved-colors", open3d_pyrdown, sources)
    for source, expected in ((color, rgb), (color[:, :, 1], np.repeat(green[:, :, None], 3, axis=2))):
        result = pyrdown_color(source, device=device)
        assert result.shape == (18, 20, 3) and result.dtype == np.uint8
        off = np.abs(result - expected.astype(int))
        assert off.max() <= 1 and (off == 0).mean() > 0.99, "sums near a half round"
    np.testing.assert_allclose(create_depth_pyramid(image, 2)[1].color, brightness, atol=1e-6)
    image = loom.RGBDImage(color[:24], depth, device=device)
    levels = create_depth_pyramid(image, 3)
    assert levels[0] is image and create_depth_pyramid(image, 1) == [image]
    assert [(level.width, level.height) for level in levels] == [(40, 24), (20, 12), (10, 6)]
    np.testing.assert_array_equal(levels[1].depth, pyrdown_depth(image.depth, device=device))
    np.testing.assert_array_equal(levels[1].color, pyrdown_color(color[:24], device=device))


FILTERS = {"bilateral": loom.filter_depth_bilateral, "erosion": loom.erode_depth_edges, "pyramid": pyrdown_depth}


@pytest.mark.parametrize("run", FILTERS.values(), ids=FILTERS)
def test_a_filter_takes_integers_metres_and_images_alike(device, run, rng):
    raw, color = (1000 * relief(rng)).astype(np.uint16), rng.integers(0, 256, (24, 40, 3)).astype(np.uint8)
    raw[rng.random(raw.shape) < 0.1] = 0
    image = loom.RGBDImage(color, raw, depth_trunc=np.inf, device=device)
    from_integers = run(raw, device=device)
    from_image = run(image)
    assert from_integers.dtype == np.float32
    np.testing.assert_array_equal(from_integers, run(raw.astype(np.float32) / np.float32(1000), device=device))
    np.testing.assert_array_equal(from_integers, from_image.depth)
    assert isinstance(from_image, loom.RGBDImage) and str(from_image.device) == device
    if from_image.width == image.width:
        np.testing.assert_array_equal(from_image.color, color)
    doubled = run(raw.astype(np.float32) / np.float32(500), device=device)
    np.testing.assert_array_equal(run(raw, depth_scale=500.0, device=device), doubled)
    np.testing.assert_array_equal(image.depth, raw.astype(np.float32) / np.float32(1000))


@pytest.mark.parametrize("run", FILTERS.values(), ids=FILTERS)
def test_images_without_depth_stay_so(device, run):
    for fill in (0.0, np.nan, -1.0, np.inf):
        result = run(np.full((4, 6), fill), device=device)
        assert not result.any() and np.isfinite(result).all()


@pytest.mark.parametrize("run", FILTERS.values(), ids=FILTERS)
def test_flat_depth_stays_to_the_bit(device, run):
    assert (run(np.full((9, 12), 1.234), device=device) == np.float32(1.234)).all()


def plane_with_holes():
    """Depth of a tilted plane [m], with holes of 1 to 48 pixels inside, one of 300, and one at the border."""
    v, u = np.mgrid[:48, :64]
    plane = 1 / (0.8 + 0.001 * u + 0.0015 * v)
    depth = plane.copy()
    for rows, columns in (
        ((5, 6), (5, 6)),
        ((10, 16), (8, 16)),
        ((30, 33), (50, 55)),
        ((20, 40), (20, 35)),
        ((0, 3), (60, 64)),
    ):
        depth[slice(*rows), slice(*columns)] = 0
    return plane, depth


def test_small_holes_of_a_plane_are_filled_exactly_and_others_remain(device):
    plane, depth = plane_with_holes()
    filled, mask = loom.fill_depth_holes(depth, 48, device=device)
    assert mask.sum() == 1 + 48 + 15 and not mask[20:40, 20:35].any() and not mask[:3, 60:].any()
    np.testing.assert_allclose(filled[mask], plane[mask], rtol=1e-6)
    np.testing.assert_array_equal(filled[~mask], depth[~mask].astype(np.float32))
    assert loom.fill_depth_holes(depth, 300, device=device)[1].sum() == 64 + 300
    assert not loom.fill_depth_holes(np.zeros((4, 5)), device=device)[1].any()


def test_a_hole_at_an_edge_of_depth_remains(device):
    depth = np.where(np.arange(20) < 10, 1000, 1200).astype(np.uint16) * np.ones((9, 1), np.uint16)
    depth[4, 8:12] = 0
    assert not loom.fill_depth_holes(depth, device=device)[1].any()
    filled, mask = loom.fill_depth_holes(depth, depth_threshold=0.21, device=device)
    assert mask.sum() == 4 and (np.diff(filled[4, 7:13]) > 0).all()
    image = loom.RGBDImage(np.zeros((9, 20, 3), np.uint8), depth, device=device)
    np.testing.assert_array_equal(loom.fill_depth_holes(image, depth_threshold=0.21)[0].depth, filled)
