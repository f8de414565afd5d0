"""Filters on depth images: Open3D's where there are no holes, and holes that neither count nor are filled."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

import pointloom as loom


@pytest.fixture(scope="module")
def raw(shipped_file):
    """A depth image with holes [mm]."""
    return np.asarray(Image.open(shipped_file("rgbd-cupoch-redwood5/depth/00002.png")))


@pytest.fixture(scope="module")
def color(shipped_file):
    """Its colours."""
    return np.asarray(Image.open(shipped_file("rgbd-cupoch-redwood5/color/00002.jpg")))


@pytest.fixture(scope="module")
def metres(raw):
    """The depth image in metres, its holes filled with what stands left of them."""
    filled = raw.copy()
    for column in range(1, filled.shape[1]):
        hole = filled[:, column] == 0
        filled[hole, column] = filled[hole, column - 1]
    filled[filled == 0] = 1234
    return filled.astype(np.float32) / np.float32(1000)


def tensor_image(array):
    import open3d as o3d

    pixels = np.array(array, order="C")
    return o3d.t.geometry.Image(o3d.core.Tensor(pixels[..., None] if pixels.ndim == 2 else pixels))


def pixels_of(image):
    pixels = image.as_tensor().numpy()
    return pixels[:, :, 0] if pixels.shape[2] == 1 else pixels


small_depths = st.builds(
    lambda seed, h, w, holes: _small(seed, h, w, holes),
    st.integers(0, 2**32 - 1), st.integers(1, 9), st.integers(1, 9), st.floats(0, 0.6),
)  # fmt: skip


def _small(seed, height, width, holes):
    rng = np.random.default_rng(seed)
    depth = (1 + rng.integers(0, 3, (height, width)) * 0.5 + 0.02 * rng.random((height, width))).astype(np.float32)
    depth[rng.random((height, width)) < holes] = 0
    return depth


# ------------------------------------------------------------------------------------------ bilateral


@pytest.mark.parametrize("kernel_size", [3, 4, 5, 7])
@pytest.mark.parametrize(("value_sigma", "dist_sigma"), [(0.03, 1.5), (20.0, 10.0), (0.002, 1.0)])
def test_bilateral_depth_is_open3ds(device, kernel_size, value_sigma, dist_sigma, metres, tolerances):
    part = metres[100:260:, 200:420]
    found = loom.filter_depth_bilateral(part, kernel_size, value_sigma, dist_sigma, device=device)
    expected = pixels_of(tensor_image(part).filter_bilateral(kernel_size, value_sigma, dist_sigma))
    np.testing.assert_allclose(found, expected, rtol=tolerances.depth_filter_relative)
    assert np.abs(found - part).max() > 1e-4
    np.testing.assert_array_equal(loom.filter_depth_bilateral(part, 1, device=device), part)


@settings(derandomize=True, deadline=None, max_examples=50)  # the first example compiles
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
                    weight = np.exp(
                        -((d - float(depth[v, u])) ** 2) / (2 * 0.3**2) - (du * du + dv * dv) / (2 * 1.5**2)
                    )
                    total, weights = total + weight * d, weights + weight
        expected[v, u] = total / weights
    found = loom.filter_depth_bilateral(depth, kernel_size, 0.3, 1.5)
    np.testing.assert_array_equal(found == 0, depth == 0)
    np.testing.assert_allclose(found, expected, rtol=1e-6)


def test_the_bilateral_filter_takes_noise_and_leaves_edges(device, rng):
    true = np.where(np.arange(80) < 40, 1.0, 1.5) * np.ones((60, 1))
    noisy = true + 0.005 * rng.normal(size=true.shape)
    found = loom.filter_depth_bilateral(noisy, 7, 0.03, 3.0, device=device)
    assert (found - true).std() < (noisy - true).std() / 3
    assert np.abs(found - true).max() < 0.02, "nothing between the two walls"


# ------------------------------------------------------------------------------------------ erosion


@settings(derandomize=True, deadline=None, max_examples=50)  # the first example compiles
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
    found = loom.erode_depth_edges(depth, 3, 0.5, device=device)
    np.testing.assert_array_equal(found[0] == 0, (np.arange(20) >= 7) & (np.arange(20) < 13))
    assert (found == found[0]).all()
    assert (loom.erode_depth_edges(depth, 3, 1.5, device=device) == depth).all()


def test_erosion_takes_the_points_that_float_between_surfaces(device, rng):
    """What a sensor mixes at an edge lies 1 cm steps apart from neither wall; erosion leaves the two walls."""
    depth = np.where(np.arange(60) < 30, 1.0, 2.0) * np.ones((40, 1))
    depth[:, 30] = rng.uniform(1, 2, 40)
    found = loom.erode_depth_edges(depth, 2, 0.1, device=device)
    kept = found[found > 0]
    assert set(kept.tolist()) == {1.0, 2.0} and len(kept) > 0.85 * depth.size


# ------------------------------------------------------------------------------------------ normals, pyramids


def test_a_normal_map_is_open3ds_made_unit(device, raw, tolerances):
    """Open3D divides by at least 1e-5, so its normals are too short where pixels cover less than 1e-5 m^2."""
    import open3d as o3d

    camera = loom.PinholeCameraIntrinsic.prime_sense_default()
    found = loom.create_normal_map(raw, camera, device=device)
    depth = tensor_image(raw).clip_transform(1000.0, 0.0, 100.0, 0.0)
    expected = pixels_of(depth.create_vertex_map(o3d.core.Tensor(camera.matrix)).create_normal_map())
    empty = (expected == 0).all(axis=2)
    np.testing.assert_array_equal((found == 0).all(axis=2), empty)
    lengths = np.linalg.norm(expected, axis=2)[~empty]
    assert lengths.min() < 0.7
    np.testing.assert_allclose(np.linalg.norm(found, axis=2)[~empty], 1, atol=tolerances.unit_length)
    np.testing.assert_allclose(found[~empty], expected[~empty] / lengths[:, None], atol=tolerances.normal_map)
    holes = loom.create_normal_map(raw, camera, np.nan, device=device)
    np.testing.assert_array_equal(np.isnan(holes).all(axis=2), (found == 0).all(axis=2))


def test_normals_of_a_slanted_wall_are_its_own(device):
    n = np.array([0.48, 0.36, -0.8])
    camera = loom.PinholeCameraIntrinsic(64, 48, 60.0, 61.0, 31.5, 23.5)
    v, u = np.mgrid[:48, :64]
    rays = np.stack([(u - 31.5) / 60, (v - 23.5) / 61, np.ones_like(u)], axis=2)
    depth = -1.6 / (rays @ n)
    found = loom.create_normal_map(depth, camera, device=device)[:-1, :-1]
    np.testing.assert_allclose(found, np.broadcast_to(n, found.shape), atol=2e-5)


@pytest.mark.parametrize("stride", [2, 4, 8])
def test_halved_depth_is_open3ds(device, stride, raw, tolerances):
    """Through its clouds with normals, which come from a pyramid: there is no other way to it from Python."""
    import open3d as o3d

    camera = loom.PinholeCameraIntrinsic.prime_sense_default()
    levels = loom.create_depth_pyramid(raw, stride.bit_length(), device=device)
    halved = levels[-1]
    assert halved.shape == (480 // stride, 640 // stride)
    intrinsic = loom.PinholeCameraIntrinsic(
        640 // stride, 480 // stride, 525 / stride, 525 / stride, 319.5 / stride, 239.5 / stride
    )
    ours = loom.PointCloud.from_depth_image(halved, intrinsic, with_normals=True, device=device)
    theirs = o3d.t.geometry.PointCloud.create_from_depth_image(
        tensor_image(raw), o3d.core.Tensor(camera.matrix), depth_max=100.0, stride=stride, with_normals=True
    )
    np.testing.assert_allclose(
        ours.points, theirs.point.positions.numpy(), rtol=tolerances.depth_filter_relative,
        atol=tolerances.image_absolute,
    )  # fmt: skip
    np.testing.assert_allclose(ours.normals, theirs.point.normals.numpy(), atol=tolerances.normal_map)
    assert ((halved > 0) == (raw[::stride, ::stride] > 0)).all()


@settings(derandomize=True, deadline=None, max_examples=50)  # the first example compiles
@given(depth=small_depths, threshold=st.sampled_from([0.1, 0.6, 5.0]))
def test_holes_and_other_surfaces_do_not_count_in_halved_depth(depth, threshold):
    h, w = depth.shape
    if min(h, w) < 2:
        with pytest.raises(ValueError, match="depth: expected at least 2 x 2 pixels to halve"):
            loom.pyrdown_depth(depth)
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
    np.testing.assert_allclose(loom.pyrdown_depth(depth, threshold), expected, rtol=3e-7)


def test_halved_colours_are_open3ds(device, color):
    for picture in (color, color[:, :, 1]):
        found = loom.pyrdown_color(picture, device=device)
        expected = pixels_of(tensor_image(picture).pyrdown()).astype(int)
        if picture.ndim == 2:
            expected = np.repeat(expected[:, :, None], 3, axis=2)
        assert found.shape == (240, 320, 3) and found.dtype == np.uint8
        assert np.abs(found - expected).max() <= 1 and (found == expected).mean() > 0.999, "sums near a half round"


def test_a_pyramid_of_rgbd_images_halves_both(device, raw, color):
    for make in (loom.RGBDImage, loom.RGBDImage.from_color_and_depth):
        image = make(color, raw, device=device)
        levels = loom.create_depth_pyramid(image, 3)
        assert levels[0] is image
        assert [(level.width, level.height) for level in levels] == [(640, 480), (320, 240), (160, 120)]
        np.testing.assert_array_equal(levels[1].depth, loom.pyrdown_depth(image.depth, device=device))
        if image.color.ndim == 3:
            np.testing.assert_array_equal(levels[1].color, loom.pyrdown_color(color, device=device))
        else:
            grey = pixels_of(tensor_image(image.color).pyrdown())
            np.testing.assert_allclose(levels[1].color, grey, atol=1e-6)
        assert loom.create_depth_pyramid(image, 1) == [image]


# ------------------------------------------------------------------------------------------ the rest of the contract

FILTERS = {"bilateral": loom.filter_depth_bilateral, "erosion": loom.erode_depth_edges, "pyramid": loom.pyrdown_depth}


@pytest.mark.parametrize("run", FILTERS.values(), ids=FILTERS)
def test_a_filter_takes_integers_metres_and_images_alike(device, run, raw, color):
    image = loom.RGBDImage(color, raw, depth_trunc=np.inf, device=device)
    from_integers = run(raw, device=device)
    from_metres = run(raw.astype(np.float32) / np.float32(1000), device=device)
    from_image = run(image)
    assert from_integers.dtype == np.float32
    np.testing.assert_array_equal(from_integers, from_metres)
    np.testing.assert_array_equal(from_integers, from_image.depth)
    assert isinstance(from_image, loom.RGBDImage) and str(from_image.device) == device
    if from_image.width == image.width:
        np.testing.assert_array_equal(from_image.color, color)
    np.testing.assert_array_equal(run(raw, depth_scale=500.0, device=device).shape, from_integers.shape)
    np.testing.assert_array_equal(image.depth, raw.astype(np.float32) / np.float32(1000))


@pytest.mark.parametrize("run", FILTERS.values(), ids=FILTERS)
def test_images_without_depth_stay_so(device, run):
    for fill in (0.0, np.nan, -1.0, np.inf):
        found = run(np.full((4, 6), fill), device=device)
        assert not found.any() and np.isfinite(found).all()


@pytest.mark.parametrize("run", FILTERS.values(), ids=FILTERS)
def test_flat_depth_stays_to_the_bit(device, run):
    found = run(np.full((9, 12), 1.234), device=device)
    assert (found == np.float32(1.234)).all()


@pytest.mark.parametrize(
    ("run", "arguments", "error", "message"),
    [
        (loom.filter_depth_bilateral, {"kernel_size": 0}, ValueError, "kernel_size: expected a whole number >= 1"),
        (loom.filter_depth_bilateral, {"value_sigma": 0}, ValueError, "value_sigma: expected a finite number > 0"),
        (loom.filter_depth_bilateral, {"dist_sigma": np.nan}, ValueError, "dist_sigma: expected a finite number > 0"),
        (loom.erode_depth_edges, {"radius": -1}, ValueError, "radius: expected a whole number >= 0"),
        (loom.erode_depth_edges, {"depth_threshold": 0}, ValueError, "depth_threshold: expected a finite number > 0"),
        (loom.pyrdown_depth, {"diff_threshold": 0}, ValueError, "diff_threshold: expected a finite number > 0"),
        (loom.pyrdown_depth, {"depth_scale": -1}, ValueError, "depth_scale: expected a finite number > 0"),
        (loom.create_depth_pyramid, {"levels": 0}, ValueError, "levels: expected a whole number >= 1"),
        (loom.create_depth_pyramid, {"levels": 4}, ValueError, "expected at least 2 x 2 pixels to halve, got 1 x 1"),
        (loom.create_normal_map, {"intrinsic": np.eye(3)}, TypeError, "intrinsic: expected a PinholeCameraIntrinsic"),
    ],
)
def test_wrong_arguments_are_named(run, arguments, error, message):
    with pytest.raises(error, match=message):
        run(np.ones((4, 4)), **arguments)


def test_wrong_images_are_named():
    with pytest.raises(ValueError, match=r"depth: expected shape \[h, w\], got \[4\]"):
        loom.erode_depth_edges(np.ones(4))
    with pytest.raises(TypeError, match="color: expected uint8, got float64"):
        loom.pyrdown_color(np.ones((4, 4)))
    with pytest.raises(ValueError, match="color: expected at least 2 x 2 pixels to halve, got 5 x 1"):
        loom.pyrdown_color(np.ones((1, 5), np.uint8))
