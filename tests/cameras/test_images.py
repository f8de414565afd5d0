"""Points from depth and RGB-D images: Open3D's, pixel by pixel, and organized clouds."""

from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image
from scipy.spatial.transform import Rotation

import pointloom as loom

INTRINSIC = loom.PinholeCameraIntrinsic(640, 480, 525.0, 525.0, 319.5, 239.5)
POSE = np.eye(4)
POSE[:3, :3], POSE[:3, 3] = Rotation.from_euler("XYZ", (0.2, -0.7, 1.3)).as_matrix(), [0.3, -1.2, 2.5]
EXTRINSIC = np.linalg.inv(POSE)


@pytest.fixture(scope="module")
def frame(shipped_file):
    folder = shipped_file("rgbd-cupoch-redwood5")
    read = [np.asarray(Image.open(folder / name)) for name in ("depth/00002.png", "color/00002.jpg")]
    return SimpleNamespace(depth=read[0].astype(np.uint16), color=read[1])


def open3d_points(o3d, depth, color, stride):
    """Of a cut of the frame: points of the depth with options and without, an organized cloud, an RGB-D image's."""
    height, width = depth.shape
    camera = o3d.camera.PinholeCameraIntrinsic(width, height, 525.0, 525.0, width / 2, height / 2)
    image, shade = (o3d.geometry.Image(np.array(pixels, order="C")) for pixels in (depth, color))
    make, far = o3d.geometry.PointCloud.create_from_depth_image, {"depth_trunc": 2.7431}
    rgbd = o3d.geometry.RGBDImage.create_from_color_and_depth(shade, image, convert_rgb_to_intensity=False, **far)
    clouds = [
        make(image, camera, EXTRINSIC, stride=stride, **far),
        make(image, camera),
        make(image, camera, EXTRINSIC, project_valid_depth_only=False),
        o3d.geometry.PointCloud.create_from_rgbd_image(rgbd, camera, EXTRINSIC),
    ]
    points = [np.asarray(cloud.points).astype(np.float32) for cloud in clouds]
    return points, np.asarray(clouds[3].colors).astype(np.float32), np.asarray(rgbd.depth)


@pytest.mark.parametrize("stride", [1, 3])
def test_points_of_depth_and_rgbd_images_match_open3d(device, stride, frame, oracle, tolerances):
    depth, color = frame.depth[::20, ::20], frame.color[::20, ::20]
    expected, colors, meters = oracle(f"cameras/points-{stride}", open3d_points, depth, color, stride)
    camera, far = loom.PinholeCameraIntrinsic(32, 24, 525.0, 525.0, 16.0, 12.0), {"depth_trunc": 2.7431}
    image = loom.RGBDImage(color, depth, device=device, **far)
    make, options = loom.PointCloud.create_from_depth_image, {"device": device}
    clouds = [
        make(depth, camera, EXTRINSIC, stride=stride, **far, **options),
        make(depth, camera, **options),
        make(depth, camera, EXTRINSIC, project_valid_depth_only=False, **options),
        loom.PointCloud.create_from_rgbd_image(image, camera, EXTRINSIC),
    ]
    for cloud, points in zip(clouds, expected, strict=True):
        np.testing.assert_allclose(cloud.points, points, rtol=tolerances.image_relative, atol=tolerances.image_absolute)
    assert 0 < len(clouds[0]) < len(clouds[2]) == 768 and clouds[2].grid == (24, 32)
    np.testing.assert_allclose(clouds[3].colors, colors, rtol=tolerances.float32_relative)
    np.testing.assert_array_equal(image.color, color)
    np.testing.assert_allclose(image.depth, meters, rtol=tolerances.float32_relative)


def test_an_organized_cloud_keeps_the_grid(device, frame):
    options = {"project_valid_depth_only": False, "device": device}
    cloud = loom.PointCloud.create_from_depth_image(frame.depth, INTRINSIC, EXTRINSIC, **options)
    assert cloud.grid == (480, 640) and len(cloud) == 480 * 640
    holes = frame.depth.reshape(-1) == 0
    assert holes.any()
    np.testing.assert_array_equal(np.isnan(cloud.points).all(axis=1), holes)
    valid = loom.PointCloud.create_from_depth_image(frame.depth, INTRINSIC, EXTRINSIC, device=device)
    assert valid.grid is None
    np.testing.assert_array_equal(cloud.remove_non_finite_points().points, valid.points)
    strided = loom.PointCloud.create_from_depth_image(frame.depth, INTRINSIC, EXTRINSIC, stride=7, **options)
    assert strided.grid == (69, 92)
    np.testing.assert_array_equal(strided.points, cloud.points.reshape(480, 640, 3)[::7, ::7].reshape(-1, 3))
    image = loom.RGBDImage(frame.color, frame.depth, device=device)
    organized = loom.PointCloud.create_from_rgbd_image(image, INTRINSIC, project_valid_depth_only=False, stride=2)
    assert organized.grid == (240, 320)
    shades = frame.color[::2, ::2].astype(np.float32) / np.float32(255)
    np.testing.assert_array_equal(organized.colors.reshape(240, 320, 3), shades)


def test_an_organized_cloud_keeps_its_grid_where_its_points_stay(device, frame):
    options = {"stride": 8, "project_valid_depth_only": False, "device": device}
    cloud = loom.PointCloud.create_from_depth_image(frame.depth, INTRINSIC, **options)
    fitted = cloud.estimate_normals(radius=0.1)
    for result in (cloud.transform(np.eye(4)), fitted, fitted.orient_normals_towards_camera_location(), cloud.copy()):
        assert result.grid == (60, 80)
    for lost in (cloud.select_by_index([0, 1]), cloud.voxel_down_sample(0.1), cloud.remove_non_finite_points()):
        assert lost.grid is None
    np.testing.assert_array_equal(np.isnan(fitted.normals).all(axis=1), np.isnan(cloud.points).all(axis=1))


def small(**changes):
    camera = loom.PinholeCameraIntrinsic(3, 2, 1, 1, 0, 0)
    return {"depth": np.full((2, 3), 1000, np.uint16), "intrinsic": camera} | changes


def test_depth_equal_to_the_maximum_is_used(device):
    """Open3D drops it."""
    for depth in (np.full((2, 3), 1000, np.uint16), np.ones((2, 3), np.float32)):  # it ignores the limit of floats
        for depth_trunc, count in ((1.0, 6), (0.999, 0), (np.inf, 6)):
            given = small(depth=depth, depth_trunc=depth_trunc)
            assert len(loom.PointCloud.create_from_depth_image(**given, device=device)) == count


def test_depth_that_is_no_measurement_gives_no_point(device):
    depth = np.array([[0, -1, np.nan], [np.inf, 1e300, 2]])
    cloud = loom.PointCloud.create_from_depth_image(**small(depth=depth, depth_trunc=np.inf), device=device)
    assert cloud.points.tolist() == [[4, 2, 2]]


@pytest.mark.parametrize("dtype", [np.int16, np.int32, np.int64, np.uint16, np.float64, np.float16])
def test_depth_of_any_type_is_taken(device, dtype):
    depth = np.array([[0, 50, 100], [120, 0, 7]], dtype)
    is_float = np.dtype(dtype).kind == "f"
    for given, scale in ((10.0, 10.0), (None, 1.0 if is_float else 1000.0)):
        cloud = loom.PointCloud.create_from_depth_image(**small(depth=depth, depth_scale=given), device=device)
        np.testing.assert_array_equal(cloud.points[:, 2], depth[depth > 0].astype(np.float32) / np.float32(scale))


def test_gray_is_repeated_to_colors(device):
    gray = np.array([[0, 51, 255], [102, 1, 2]], np.uint8)
    image = loom.RGBDImage(gray, np.full((2, 3), 1000, np.uint16), device=device)
    cloud = loom.PointCloud.create_from_rgbd_image(image, small()["intrinsic"])
    expected = np.repeat(gray.reshape(-1, 1).astype(np.float32) / np.float32(255), 3, axis=1)
    np.testing.assert_array_equal(cloud.colors, expected)


@pytest.mark.parametrize("kind", [np.uint8, np.int8])
def test_eight_bits_are_no_depth(kind, device):
    depth, color = np.full((2, 3), 100, kind), np.zeros((2, 3, 3), np.uint8)
    camera = loom.PinholeCameraIntrinsic(3, 2, 3.0, 3.0, 1.0, 0.5)
    for use in (
        lambda: loom.RGBDImage(color, depth, device=device),
        lambda: loom.RGBDImage.create_from_color_and_depth(color, depth, depth_scale=10, depth_trunc=10, device=device),
        lambda: loom.RGBDImage.create_from_sun_format(color, depth, device=device),
        lambda: loom.PointCloud.create_from_depth_image(depth, camera, device=device),
        lambda: loom.TSDFVolume(voxel_size=0.1, device=device).integrate(depth, camera, np.eye(4)),
    ):
        with pytest.raises(TypeError, match="depth:"):
            use()


@pytest.mark.parametrize("name", ["redwood", "tum", "sun", "nyu"])
def test_colors_of_each_format_stay_colors_on_request(name, device):
    rng = np.random.default_rng(0)
    color, depth = rng.integers(0, 256, (4, 6, 3)).astype(np.uint8), np.full((4, 6), 1000, np.uint16)
    create = getattr(loom.RGBDImage, f"create_from_{name}_format")
    gray, colored = (create(color, depth, convert_rgb_to_intensity=on, device=device) for on in (True, False))
    np.testing.assert_array_equal(colored.color, color)
    assert gray.color.shape != color.shape and str(gray.depth_array.device) == device
