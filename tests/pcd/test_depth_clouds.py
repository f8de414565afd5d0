"""RGB-D images of every format, normals of depth images, and images of clouds: Open3D's, and back again exactly."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image

import pointloom as loom

from ..scan_cases import ON_REAL_SCANS, on_sets

PRIME_SENSE = (640, 480, 525.0, 525.0, 319.5, 239.5)
FILES = {
    "tum": ("TUM_color.png", "TUM_depth.png"),
    "sun": ("SUN_color.jpg", "SUN_depth.png"),
    "nyu": ("NYU_color.ppm", "NYU_depth.pgm"),
}


@pytest.fixture(scope="module")
def redwood(shipped_file):
    """Color and raw depth of a frame in millimeters."""
    return read_frame(shipped_file("rgbd-cupoch-redwood5"), "color/00002.jpg", "depth/00002.png")


@pytest.fixture(scope="module")
def frames(scan_set, redwood, real_file):
    """Color and raw depth of a frame in each format: its files (real), or Redwood's frame encoded (shipped)."""
    if scan_set == "real":
        return {name: read_frame(real_file("rgbd-cupoch-redwood5/other_formats"), *FILES[name]) for name in FILES}
    color, depth = redwood
    millimetres = depth.astype(np.uint16)
    shares = 351.3 / np.maximum(millimetres, 500) * 1000  # NYU's own scale: metres = 351.3 / (1092.5 - word)
    words = np.where(millimetres > 0, np.rint(1092.5 - shares), 2047).astype(np.uint16)
    return {
        "redwood": redwood,
        "tum": (color, 5 * millimetres),
        "sun": (color, (millimetres << 3) | (millimetres >> 13)),
        "nyu": (color, words.byteswap()),
    }


def read_frame(folder, color, depth):
    return np.asarray(Image.open(folder / color).convert("RGB")), np.asarray(Image.open(folder / depth))


@pytest.fixture(scope="module")
def camera():
    """The sensor in both forms, and where it stands: T_camera_world."""
    import open3d as o3d

    pose = np.eye(4)
    pose[:3, :3] = o3d.geometry.get_rotation_matrix_from_xyz((0.2, -0.7, 1.3))
    pose[:3, 3] = [0.3, -1.2, 2.5]
    return SimpleNamespace(
        ours=loom.PinholeCameraIntrinsic(*PRIME_SENSE), theirs=o3d.camera.PinholeCameraIntrinsic(*PRIME_SENSE),
        tensor=o3d.core.Tensor(loom.PinholeCameraIntrinsic(*PRIME_SENSE).matrix), extrinsic=np.linalg.inv(pose),
    )  # fmt: skip


def open3d_image(array):
    import open3d as o3d

    return o3d.geometry.Image(np.array(array, order="C"))


def tensor_image(array):
    import open3d as o3d

    pixels = np.array(array, order="C")
    return o3d.t.geometry.Image(o3d.core.Tensor(pixels[..., None] if pixels.ndim == 2 else pixels))


# ------------------------------------------------------------------------------------------ formats


@pytest.mark.parametrize("to_intensity", [True, False])
@on_sets("layout", shipped=("redwood", *FILES), real=FILES)
def test_images_of_a_data_set_are_open3ds(device, layout, to_intensity, frames, camera, tolerances):
    import open3d as o3d

    color, raw = frames[layout]
    image = getattr(loom.RGBDImage, f"from_{layout}_format")(color, raw, to_intensity, device=device)
    make = getattr(o3d.geometry.RGBDImage, f"create_from_{layout}_format")
    oracle = make(open3d_image(color), open3d_image(raw.astype(np.uint16)), to_intensity)
    expected = np.asarray(oracle.depth)
    at_limit = expected == 0
    assert (image.depth[at_limit] == 0).mean() > 0.999, "ours keeps the farthest depth itself"
    np.testing.assert_allclose(image.depth[~at_limit], expected[~at_limit], rtol=tolerances.float32_relative)
    assert 1 < expected.max() < (7.0 if layout in ("sun", "nyu") else 4.0) and (expected > 0).mean() > 0.3
    if to_intensity:
        assert image.color.dtype == np.float32 and image.color.shape == (480, 640)
        np.testing.assert_allclose(image.color, np.asarray(oracle.color), rtol=tolerances.intensity_relative)
    else:
        np.testing.assert_array_equal(image.color, color)
    found = loom.PointCloud.from_rgbd_image(image, camera.ours)
    theirs = o3d.geometry.PointCloud.create_from_rgbd_image(oracle, camera.theirs)
    keep = ~at_limit[image.depth > 0]
    np.testing.assert_allclose(
        found.points[keep], np.asarray(theirs.points), rtol=tolerances.image_relative, atol=tolerances.image_absolute
    )
    np.testing.assert_allclose(found.colors[keep], np.asarray(theirs.colors), rtol=tolerances.intensity_relative)


@pytest.mark.parametrize("layout", ["sun", "nyu"])
def test_every_raw_depth_is_decoded_as_by_open3d(device, layout, tolerances):
    """But for Open3D's 7 m themselves, which it drops."""
    import open3d as o3d

    raw = np.arange(65536, dtype=np.uint16).reshape(256, 256)
    color = np.zeros((256, 256, 3), np.uint8)
    oracle = getattr(o3d.geometry.RGBDImage, f"create_from_{layout}_format")(open3d_image(color), open3d_image(raw))
    found = getattr(loom.RGBDImage, f"from_{layout}_format")(color, raw, device=device).depth
    expected = np.asarray(oracle.depth).copy()
    expected[found == 7] = 7
    np.testing.assert_allclose(found, expected, rtol=tolerances.float32_relative)
    assert (found == 7).sum() <= 1 and len(np.unique(found)) > 500


def test_color_and_depth_have_open3ds_defaults(device, redwood, tolerances):
    import open3d as o3d

    color, raw = redwood[0], 2 * redwood[1]
    image = loom.RGBDImage.from_color_and_depth(color, raw, device=device)
    oracle = o3d.geometry.RGBDImage.create_from_color_and_depth(open3d_image(color), open3d_image(raw))
    np.testing.assert_allclose(image.depth, np.asarray(oracle.depth), rtol=tolerances.float32_relative)
    np.testing.assert_allclose(image.color, np.asarray(oracle.color), rtol=tolerances.intensity_relative)
    assert image.depth.max() <= 3 < raw.max() / 1000


def test_float_depth_is_metres_and_is_cut_too(device):
    """Open3D divides it by depth_scale."""
    depth = np.array([[0.5, 2.0, 3.0, 3.5, np.nan, -1.0]])
    image = loom.RGBDImage.from_color_and_depth(np.zeros((1, 6), np.uint8), depth, device=device)
    assert image.depth.tolist() == [[0.5, 2, 3, 0, 0, 0]]


def test_grey_images_stay_grey_as_brightness(device):
    grey = np.arange(256, dtype=np.uint8).reshape(16, 16)
    image = loom.RGBDImage.from_color_and_depth(grey, np.full((16, 16), 1000, np.uint16), device=device)
    np.testing.assert_allclose(image.color, grey / 255, rtol=3e-7)
    cloud = loom.PointCloud.from_rgbd_image(
        image, loom.PinholeCameraIntrinsic(16, 16, 1, 1, 0, 0), project_valid_depth_only=False, stride=3
    )
    np.testing.assert_array_equal(cloud.colors, np.repeat(image.color[::3, ::3].reshape(-1, 1), 3, axis=1))
    assert cloud.grid == (6, 6)


@pytest.mark.parametrize("layout", ["sun", "nyu"])
@pytest.mark.parametrize(
    ("depth", "error", "message"),
    [
        (np.ones((2, 3)), TypeError, "depth: expected the file's integers, got float64"),
        (np.full((2, 3), 70000), ValueError, "depth: integer depths must lie in 0..65535"),
        (np.zeros((2, 3, 1), np.uint16), ValueError, r"depth: expected shape \[h, w\], got \[2, 3, 1\]"),
        (np.zeros((3, 3), np.uint16), ValueError, "color: 3 x 2 pixels, but the depth image has 3 x 3"),
    ],
)
def test_raw_depth_of_another_kind_is_refused(layout, depth, error, message):
    with pytest.raises(error, match=message):
        getattr(loom.RGBDImage, f"from_{layout}_format")(np.zeros((2, 3, 3), np.uint8), depth)


# ------------------------------------------------------------------------------------------ normals


@pytest.mark.parametrize("stride", [1, 3])
def test_normals_of_a_depth_image_are_open3ds_of_its_grid(device, stride, redwood, camera, tolerances):
    import open3d as o3d

    raw = redwood[1]
    cloud = loom.PointCloud.from_depth_image(
        raw, camera.ours, stride=stride, project_valid_depth_only=False, with_normals=True, device=device
    )
    K = camera.ours.matrix / np.array([[stride], [stride], [1]])
    depth = tensor_image(raw[::stride, ::stride]).clip_transform(1000.0, 0.0, 1000.0, np.nan)
    vertices = depth.create_vertex_map(o3d.core.Tensor(K), np.nan)
    expected = vertices.create_normal_map(np.nan).as_tensor().numpy()
    expected = expected / np.linalg.norm(expected, axis=2, keepdims=True)  # shorter than 1 where pixels are small
    found = cloud.normals.reshape(expected.shape)
    np.testing.assert_array_equal(np.isnan(found), np.isnan(expected))
    assert 0.5 < np.isfinite(found).mean() < 1
    np.testing.assert_allclose(found, expected, atol=tolerances.normal_map)
    np.testing.assert_allclose(
        cloud.points.reshape(expected.shape), vertices.as_tensor().numpy(), atol=tolerances.image_absolute
    )
    good = np.isfinite(cloud.normals).all(axis=1)
    kept = loom.PointCloud.from_depth_image(raw, camera.ours, stride=stride, with_normals=True, device=device)
    np.testing.assert_array_equal(kept.normals, cloud.normals[good])
    np.testing.assert_array_equal(kept.points, cloud.points[good])
    assert ((kept.points * kept.normals).sum(axis=1) <= 1e-6).all(), "towards the camera"


def test_normals_turn_with_the_camera(device, redwood, camera):
    color, raw = redwood
    image = loom.RGBDImage(color, raw, device=device)
    near = loom.PointCloud.from_rgbd_image(image, camera.ours, stride=4, with_normals=True)
    turned = loom.PointCloud.from_rgbd_image(image, camera.ours, camera.extrinsic, stride=4, with_normals=True)
    back = near.transform(np.linalg.inv(camera.extrinsic))
    np.testing.assert_allclose(turned.normals, back.normals, atol=3e-7)
    np.testing.assert_allclose(turned.points, back.points, atol=1e-6)
    np.testing.assert_array_equal(turned.colors, near.colors)


def test_blurred_normals_are_open3ds_with_normals(device, camera, tolerances):
    """Open3D blurs the depth first; ours leaves that to a filter. No holes: there Open3D's blur spreads NaN."""
    import open3d as o3d

    v, u = np.mgrid[:48, :64]
    depth = (1.5 + 0.2 * np.sin(u / 9) + 0.1 * np.cos(v / 7)).astype(np.float32)
    K = np.array([[60.0, 0, 31.5], [0, 60.0, 23.5], [0, 0, 1]])
    theirs = o3d.t.geometry.PointCloud.create_from_depth_image(
        tensor_image(depth), o3d.core.Tensor(K), depth_scale=1.0, depth_max=3.0, with_normals=True
    )
    smooth = loom.filter_depth_bilateral(depth, 5, 10.0, 10.0, device=device)
    intrinsic = loom.PinholeCameraIntrinsic.from_matrix(K, 64, 48)
    ours = loom.PointCloud.from_depth_image(smooth, intrinsic, with_normals=True, device=device)
    assert len(ours) == len(theirs.point.positions) == 47 * 63
    np.testing.assert_allclose(ours.points, theirs.point.positions.numpy(), atol=2e-6)
    np.testing.assert_allclose(ours.normals, theirs.point.normals.numpy(), atol=tolerances.normal_map)


def test_images_of_one_row_or_column_have_no_normals(device):
    for shape in ((1, 5), (5, 1), (1, 1)):
        intrinsic = loom.PinholeCameraIntrinsic(shape[1], shape[0], 1, 1, 0, 0)
        cloud = loom.PointCloud.from_depth_image(np.ones(shape), intrinsic, with_normals=True, device=device)
        assert len(cloud) == 0 and cloud.has_normals


# ------------------------------------------------------------------------------------------ projection


def oracle_depth(points, camera, extrinsic, depth_scale, depth_max):
    import open3d as o3d

    cloud = o3d.t.geometry.PointCloud(o3d.core.Tensor(points.astype(np.float32)))
    image = cloud.project_to_depth_image(
        640, 480, camera.tensor, o3d.core.Tensor(extrinsic), depth_scale=depth_scale, depth_max=depth_max
    )
    return image.as_tensor().numpy()[:, :, 0]


def facing(camera, points):
    """The camera turned as it is, 1.8 m before the middle of some points."""
    extrinsic = camera.extrinsic.copy()
    extrinsic[:3, 3] = [0, 0, 1.8] - extrinsic[:3, :3] @ np.median(points, axis=0)
    return extrinsic


@ON_REAL_SCANS
def test_the_depth_image_of_a_cloud_is_open3ds(device, fragment, camera, tolerances):
    extrinsic = facing(camera, fragment.points)
    cloud = loom.PointCloud(fragment.points, device=device)
    found = cloud.project_to_depth_image(640, 480, camera.ours, extrinsic, 1000.0, 2.6)
    expected = oracle_depth(fragment.points, camera, extrinsic, 1000.0, 2.6)
    assert found.dtype == np.float32 and found.shape == (480, 640) and (expected > 0).mean() > 0.05
    same = np.isclose(found, expected, rtol=tolerances.projected_relative)
    assert same.mean() > tolerances.projected_share, f"{1 - same.mean():.3%} of the pixels differ"


@pytest.mark.parametrize("moved", [False, True])
@on_sets("layout", shipped=("redwood", "tum"), real=["tum"])
def test_a_depth_image_comes_back_from_its_cloud(device, layout, moved, frames, camera):
    raw = frames[layout][1]
    extrinsic = camera.extrinsic if moved else None
    cloud = loom.PointCloud.from_depth_image(raw, camera.ours, extrinsic, device=device)
    back = cloud.project_to_depth_image(640, 480, camera.ours, extrinsic, 1000.0, 100.0)
    np.testing.assert_array_equal(np.rint(back).astype(np.uint16), raw)
    if not moved:
        metres = cloud.project_to_depth_image(640, 480, camera.ours, depth_scale=1.0, depth_max=np.inf)
        np.testing.assert_array_equal(metres, raw.astype(np.float32) / np.float32(1000))


def test_every_16_bit_depth_comes_back(device):
    raw = np.arange(65536, dtype=np.uint16).reshape(256, 256)
    intrinsic = loom.PinholeCameraIntrinsic(256, 256, 200.0, 210.0, 127.3, 100.1)
    for scale in (1000.0, 5000.0):
        cloud = loom.PointCloud.from_depth_image(raw, intrinsic, depth_scale=scale, device=device)
        back = cloud.project_to_depth_image(256, 256, intrinsic, None, scale, 100.0)
        np.testing.assert_array_equal(np.rint(back).astype(np.uint16), raw)


def test_an_rgbd_image_comes_back_from_its_cloud(device, redwood, camera):
    color, raw = redwood
    image = loom.RGBDImage(color, raw, device=device)
    cloud = loom.PointCloud.from_rgbd_image(image, camera.ours)
    back = cloud.project_to_rgbd_image(640, 480, camera.ours)
    np.testing.assert_array_equal(back.depth, image.depth)
    np.testing.assert_array_equal(back.color, np.where(image.depth[..., None] > 0, color, 0))
    assert (back.width, back.height, str(back.device)) == (640, 480, device)
    again = loom.PointCloud.from_rgbd_image(back, camera.ours)
    np.testing.assert_array_equal(again.points, cloud.points)
    np.testing.assert_array_equal(again.colors, cloud.colors)


@settings(derandomize=True, deadline=None, max_examples=50)  # the first example compiles
@given(seed=st.integers(0, 2**32 - 1), count=st.integers(0, 60), size=st.tuples(st.integers(1, 9), st.integers(1, 7)))
def test_the_nearest_point_of_each_pixel_wins_ties_to_the_first(seed, count, size):
    """Against a loop; coordinates of a coarse lattice, so that points tie, lie on borders, behind and at the camera."""
    rng = np.random.default_rng(seed)
    points = rng.integers(-4, 9, (count, 3)) / 2.0
    points[rng.random(count) < 0.1] = np.nan
    colors = np.linspace(0, 1, 3 * count).reshape(-1, 3)
    width, height = size
    intrinsic = loom.PinholeCameraIntrinsic(width, height, 3.0, 2.5, width / 2, 1.25)
    depth, seen = np.zeros((height, width), np.float32), np.zeros((height, width, 3), np.uint8)
    for (x, y, z), color in zip(points, colors, strict=True):
        if not 0 < z <= 3:
            continue
        u, v = np.floor(3.0 * x / z + width / 2 + 0.5), np.floor(2.5 * y / z + 1.25 + 0.5)
        if 0 <= u < width and 0 <= v < height:
            at = int(v), int(u)
            if depth[at] == 0 or z < depth[at]:
                depth[at], seen[at] = z, np.floor(color.astype(np.float32) * np.float32(255) + np.float32(0.5))
    cloud = loom.PointCloud(points, colors=colors)
    np.testing.assert_array_equal(cloud.project_to_depth_image(width, height, intrinsic, depth_scale=1.0), depth)
    image = cloud.project_to_rgbd_image(width, height, intrinsic)
    np.testing.assert_array_equal(image.depth, depth)
    np.testing.assert_array_equal(image.color, seen)


def test_a_camera_at_utm_coordinates_sees_the_same(device, redwood, camera):
    raw = redwood[1]
    utm = np.array([5e5, 5.4e6, 100.25])
    extrinsic = camera.extrinsic.copy()
    extrinsic[:3, 3] -= extrinsic[:3, :3] @ utm
    cloud = loom.PointCloud.from_depth_image(raw, camera.ours, extrinsic, device=device)
    assert cloud.origin.any()
    back = cloud.project_to_depth_image(640, 480, camera.ours, extrinsic, 1000.0, 100.0)
    np.testing.assert_array_equal(np.rint(back).astype(np.uint16), raw)


def test_clouds_of_no_points_give_empty_images(device):
    intrinsic = loom.PinholeCameraIntrinsic(4, 3, 1, 1, 0, 0)
    for points in (np.zeros((0, 3)), np.full((5, 3), np.nan), [[0, 0, -1.0]], [[0, 0, 0.0]], [[1e30, 0, 1e-30]]):
        cloud = loom.PointCloud(points, colors=np.ones((len(points), 3)), device=device)
        assert not cloud.project_to_depth_image(4, 3, intrinsic).any()
        assert not cloud.project_to_rgbd_image(4, 3, intrinsic).color.any()


@ON_REAL_SCANS
def test_two_runs_of_a_projection_give_the_same_bits(device, fragment, camera):
    cloud = loom.PointCloud(fragment.points, colors=fragment.colors, device=device)
    extrinsic = facing(camera, fragment.points)
    first, second = (cloud.project_to_rgbd_image(640, 480, camera.ours, extrinsic, depth_max=9) for _ in range(2))
    np.testing.assert_array_equal(first.depth, second.depth)
    np.testing.assert_array_equal(first.color, second.color)
    assert (first.depth > 0).mean() > 0.05


@pytest.mark.parametrize(
    ("changes", "error", "message"),
    [
        ({"width": 4}, ValueError, "intrinsic: made for 3 x 2 pixels, but the image has 4 x 2"),
        ({"height": 0}, ValueError, "height: expected a whole number >= 1"),
        ({"width": 2.5}, TypeError, "width: expected a whole number"),
        ({"intrinsic": np.eye(3)}, TypeError, "intrinsic: expected a PinholeCameraIntrinsic, got ndarray"),
        ({"extrinsic": np.diag([2.0, 2, 2, 1])}, ValueError, "extrinsic: expected a rigid motion"),
        ({"depth_scale": 0}, ValueError, "depth_scale: expected a finite number > 0"),
        ({"depth_max": np.nan}, ValueError, "depth_max: expected a number > 0, got nan"),
    ],
)
def test_wrong_arguments_of_a_projection_are_named(changes, error, message):
    arguments = {"width": 3, "height": 2, "intrinsic": loom.PinholeCameraIntrinsic(3, 2, 1, 1, 0, 0)} | changes
    with pytest.raises(error, match=message):
        loom.PointCloud([[0, 0, 1.0]]).project_to_depth_image(**arguments)


def test_an_rgbd_image_wants_colours():
    intrinsic = loom.PinholeCameraIntrinsic(3, 2, 1, 1, 0, 0)
    with pytest.raises(ValueError, match=r"the cloud has no colors: assign cloud\.colors"):
        loom.PointCloud([[0, 0, 1.0]]).project_to_rgbd_image(3, 2, intrinsic)
