"""RGB-D images of every format, normals of depth images, and projections of clouds, compared with Open3D."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image
from scipy.spatial.transform import Rotation

import pointloom as loom

PRIME_SENSE = (640, 480, 525.0, 525.0, 319.5, 239.5)
CAMERA = loom.PinholeCameraIntrinsic(*PRIME_SENSE)
POSE = np.eye(4)
POSE[:3, :3], POSE[:3, 3] = Rotation.from_euler("XYZ", (0.2, -0.7, 1.3)).as_matrix(), [0.3, -1.2, 2.5]
EXTRINSIC = np.linalg.inv(POSE)


@pytest.fixture(scope="module")
def redwood(shipped_file):
    """Color and raw depth of a frame in millimeters."""
    folder = shipped_file("rgbd-cupoch-redwood5")
    color, depth = (Image.open(folder / name) for name in ("color/00002.jpg", "depth/00002.png"))
    return np.asarray(color.convert("RGB")), np.asarray(depth)


def encoded(millimeters):
    """A depth image as stored by each format; `defaults` contains larger depths, which are truncated."""
    raw_values = millimeters.astype(np.uint16)
    fractions = 351.3 / np.maximum(raw_values, 500) * 1000  # NYU's own scale: meters = 351.3 / (1092.5 - word)
    nyu = np.where(raw_values > 0, np.rint(1092.5 - fractions), 2047).astype(np.uint16).byteswap()
    sun = (raw_values << 3) | (raw_values >> 13)
    return {"redwood": raw_values, "tum": 5 * raw_values, "sun": sun, "nyu": nyu, "defaults": 2 * raw_values}


def open3d_frame(o3d, layout, color, raw, to_intensity):
    """Depth [m] and color of a frame in a format, and points and colors of its cloud."""
    images = [o3d.geometry.Image(np.array(pixels, order="C")) for pixels in (color, raw.astype(np.uint16))]
    name = "color_and_depth" if layout == "defaults" else f"{layout}_format"
    image = getattr(o3d.geometry.RGBDImage, f"create_from_{name}")(*images, convert_rgb_to_intensity=to_intensity)
    camera = o3d.camera.PinholeCameraIntrinsic(raw.shape[1], raw.shape[0], *PRIME_SENSE[2:])
    cloud = o3d.geometry.PointCloud.create_from_rgbd_image(image, camera)
    return [np.asarray(array) for array in (image.depth, image.color, cloud.points, cloud.colors)]


@pytest.mark.parametrize("layout", ["redwood", "tum", "sun", "nyu", "defaults"])
def test_images_of_a_data_set_are_open3ds(device, layout, redwood, oracle, tolerances):
    color, raw = (pixels[::16, ::16] for pixels in redwood)
    raw, to_intensity = encoded(raw)[layout], layout in ("redwood", "sun", "defaults")
    frame = layout, color, raw, to_intensity
    depth, shade, points, colors = oracle(f"pcd/depth_clouds/{layout}-frame", open3d_frame, *frame)
    name = "color_and_depth" if layout == "defaults" else f"{layout}_format"
    make = getattr(loom.RGBDImage, f"create_from_{name}")
    image = make(color, raw, convert_rgb_to_intensity=to_intensity, device=device)
    at_limit = depth == 0
    assert (image.depth[at_limit] == 0).mean() > 0.999, "ours keeps the farthest depth itself"
    np.testing.assert_allclose(image.depth[~at_limit], depth[~at_limit], rtol=tolerances.float32_relative)
    if to_intensity:
        assert image.color.dtype == np.float32 and image.color.shape == raw.shape
        np.testing.assert_allclose(image.color, shade, rtol=tolerances.intensity_relative)
    else:
        np.testing.assert_array_equal(image.color, color)
    camera = loom.PinholeCameraIntrinsic(raw.shape[1], raw.shape[0], *PRIME_SENSE[2:])
    result, keep = loom.PointCloud.create_from_rgbd_image(image, camera), ~at_limit[image.depth > 0]
    limits = {"rtol": tolerances.image_relative, "atol": tolerances.image_absolute}
    np.testing.assert_allclose(result.points[keep], points, **limits)
    np.testing.assert_allclose(result.colors[keep], colors, rtol=tolerances.intensity_relative)


def decoded(o3d, layout, raw):
    """Meters of every raw value."""
    color = o3d.geometry.Image(np.zeros((256, 256, 3), np.uint8))
    image = getattr(o3d.geometry.RGBDImage, f"create_from_{layout}_format")(color, o3d.geometry.Image(raw))
    return np.asarray(image.depth)


@pytest.mark.parametrize("layout", ["sun", "nyu"])
def test_every_raw_depth_is_decoded_as_by_open3d(device, layout, oracle, tolerances):
    """Except for exactly 7 m, which Open3D drops."""
    raw = np.arange(65536, dtype=np.uint16).reshape(256, 256)
    make = getattr(loom.RGBDImage, f"create_from_{layout}_format")
    result = make(np.zeros((256, 256, 3), np.uint8), raw, device=device).depth
    expected = np.array(oracle(f"pcd/depth_clouds/{layout}", decoded, layout, raw))
    expected[result == 7] = 7
    np.testing.assert_allclose(result, expected, rtol=tolerances.float32_relative)
    assert (result == 7).sum() <= 1 and len(np.unique(result)) > 500


def test_float_depth_is_metres_and_is_cut_too(device):
    """Open3D divides it by depth_scale."""
    depth = np.array([[0.5, 2.0, 3.0, 3.5, np.nan, -1.0]])
    image = loom.RGBDImage.create_from_color_and_depth(np.zeros((1, 6), np.uint8), depth, device=device)
    assert image.depth.tolist() == [[0.5, 2, 3, 0, 0, 0]]


def test_gray_images_stay_gray_as_brightness(device):
    gray = np.arange(256, dtype=np.uint8).reshape(16, 16)
    image = loom.RGBDImage.create_from_color_and_depth(gray, np.full((16, 16), 1000, np.uint16), device=device)
    np.testing.assert_allclose(image.color, gray / 255, rtol=3e-7)
    camera, options = loom.PinholeCameraIntrinsic(16, 16, 1, 1, 0, 0), {"project_valid_depth_only": False, "stride": 3}
    cloud = loom.PointCloud.create_from_rgbd_image(image, camera, **options)
    np.testing.assert_array_equal(cloud.colors, np.repeat(image.color[::3, ::3].reshape(-1, 1), 3, axis=1))
    assert cloud.grid == (6, 6)


def open3d_maps(o3d, raw, K):
    """Points and normals of the pixels; normals are shorter than 1 where pixels are small."""
    image = o3d.t.geometry.Image(o3d.core.Tensor(np.array(raw, order="C")[..., None]))
    vertices = image.clip_transform(1000.0, 0.0, 1000.0, np.nan).create_vertex_map(o3d.core.Tensor(K), np.nan)
    return vertices.as_tensor().numpy(), vertices.create_normal_map(np.nan).as_tensor().numpy()


def test_normals_of_a_depth_image_are_open3ds_of_its_grid(device, redwood, oracle, tolerances):
    raw, stride = redwood[1][96:384, 160:480], 9
    camera = loom.PinholeCameraIntrinsic(320, 288, 525.0, 525.0, 159.5, 143.5)
    options = {"stride": stride, "with_normals": True, "device": device}
    cloud = loom.PointCloud.create_from_depth_image(raw, camera, project_valid_depth_only=False, **options)
    K = camera.matrix / np.array([[stride], [stride], [1]])
    points, expected = oracle("pcd/depth_clouds/normals", open3d_maps, raw[::stride, ::stride], K)
    expected = expected / np.linalg.norm(expected, axis=2, keepdims=True)
    result = cloud.normals.reshape(expected.shape)
    np.testing.assert_array_equal(np.isnan(result), np.isnan(expected))
    assert 0.5 < np.isfinite(result).mean() < 1
    np.testing.assert_allclose(result, expected, atol=tolerances.normal_map)
    np.testing.assert_allclose(cloud.points.reshape(expected.shape), points, atol=tolerances.image_absolute)
    good = np.isfinite(cloud.normals).all(axis=1)
    filtered = loom.PointCloud.create_from_depth_image(raw, camera, **options)
    np.testing.assert_array_equal(filtered.normals, cloud.normals[good])
    np.testing.assert_array_equal(filtered.points, cloud.points[good])
    assert ((filtered.points * filtered.normals).sum(axis=1) <= 1e-6).all(), "toward the camera"


def test_normals_rotate_with_the_camera(device, redwood):
    color, raw = redwood
    image = loom.RGBDImage(color, raw, device=device)
    near = loom.PointCloud.create_from_rgbd_image(image, CAMERA, stride=4, with_normals=True)
    rotated = loom.PointCloud.create_from_rgbd_image(image, CAMERA, EXTRINSIC, stride=4, with_normals=True)
    back = near.transform(np.linalg.inv(EXTRINSIC))
    np.testing.assert_allclose(rotated.normals, back.normals, atol=3e-7)
    np.testing.assert_allclose(rotated.points, back.points, atol=1e-6)
    np.testing.assert_array_equal(rotated.colors, near.colors)


def test_images_of_one_row_or_column_have_no_normals(device):
    for shape in ((1, 5), (5, 1), (1, 1)):
        intrinsic = loom.PinholeCameraIntrinsic(shape[1], shape[0], 1, 1, 0, 0)
        cloud = loom.PointCloud.create_from_depth_image(np.ones(shape), intrinsic, with_normals=True, device=device)
        assert len(cloud) == 0 and cloud.has_normals


def open3d_depth(o3d, points, matrix, extrinsic):
    cloud = o3d.t.geometry.PointCloud(o3d.core.Tensor(points.astype(np.float32)))
    pose = o3d.core.Tensor(matrix), o3d.core.Tensor(extrinsic)
    return cloud.project_to_depth_image(64, 48, *pose, depth_scale=1000.0, depth_max=2.6).as_tensor().numpy()[:, :, 0]


def test_the_depth_image_of_a_cloud_is_open3ds(device, rng, oracle, tolerances):
    points, camera = rng.random((4000, 3)) * 2 - 1, loom.PinholeCameraIntrinsic(64, 48, 52.5, 52.5, 31.5, 23.5)
    extrinsic = EXTRINSIC.copy()  # rotated in its own position, 1.8 m in front of the center of the points
    extrinsic[:3, 3] = [0, 0, 1.8]
    result = loom.PointCloud(points, device=device).project_to_depth_image(64, 48, camera, extrinsic, 1000.0, 2.6)
    expected = oracle("pcd/depth_clouds/projected", open3d_depth, points, camera.matrix, extrinsic)
    assert result.dtype == np.float32 and result.shape == (48, 64) and (expected > 0).mean() > 0.3
    same = np.isclose(result, expected, rtol=tolerances.projected_relative)
    assert same.mean() > tolerances.projected_fraction, f"{1 - same.mean():.3%} of the pixels differ"


def test_every_16_bit_depth_round_trips(device):
    raw = np.arange(65536, dtype=np.uint16).reshape(256, 256)
    intrinsic = loom.PinholeCameraIntrinsic(256, 256, 200.0, 210.0, 127.3, 100.1)
    for scale in (1000.0, 5000.0):
        cloud = loom.PointCloud.create_from_depth_image(raw, intrinsic, depth_scale=scale, device=device)
        back = cloud.project_to_depth_image(256, 256, intrinsic, None, scale, 100.0)
        np.testing.assert_array_equal(np.rint(back).astype(np.uint16), raw)
        again = loom.PointCloud.create_from_depth_image(back, intrinsic, depth_scale=scale, device=device)
        np.testing.assert_allclose(again.points, cloud.points, rtol=1e-6)
        meters = cloud.project_to_depth_image(256, 256, intrinsic, depth_max=100.0)
        again = loom.PointCloud.create_from_depth_image(meters, intrinsic, device=device)
        np.testing.assert_array_equal(again.points, cloud.points)


def test_rgbd_image_round_trip_through_its_cloud(device, redwood):
    color, raw = redwood
    image = loom.RGBDImage(color, raw, device=device)
    cloud = loom.PointCloud.create_from_rgbd_image(image, CAMERA)
    back = cloud.project_to_rgbd_image(640, 480, CAMERA)
    np.testing.assert_array_equal(back.depth, image.depth)
    np.testing.assert_array_equal(back.color, np.where(image.depth[..., None] > 0, color, 0))
    assert (back.width, back.height, str(back.device)) == (640, 480, device)
    again = loom.PointCloud.create_from_rgbd_image(back, CAMERA)
    np.testing.assert_array_equal(again.points, cloud.points)
    np.testing.assert_array_equal(again.colors, cloud.colors)


@settings(derandomize=True, deadline=None, max_examples=25)  # the first example includes compilation
@given(seed=st.integers(0, 2**32 - 1), count=st.integers(0, 60), size=st.tuples(st.integers(1, 9), st.integers(1, 7)))
def test_the_nearest_point_of_each_pixel_wins_ties_to_the_first(seed, count, size):
    """Compared with a loop; coordinates of a coarse lattice give ties, borders, and points behind and at the camera."""
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


def test_clouds_of_no_points_give_empty_images(device):
    intrinsic = loom.PinholeCameraIntrinsic(4, 3, 1, 1, 0, 0)
    for points in (np.zeros((0, 3)), np.full((5, 3), np.nan), [[0, 0, -1.0]], [[0, 0, 0.0]], [[1e30, 0, 1e-30]]):
        cloud = loom.PointCloud(points, colors=np.ones((len(points), 3)), device=device)
        assert not cloud.project_to_depth_image(4, 3, intrinsic).any()
        assert not cloud.project_to_rgbd_image(4, 3, intrinsic).color.any()
