"""Points from depth and RGB-D images: Open3D's, pixel by pixel, and organised clouds."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom

PRIME_SENSE = (640, 480, 525.0, 525.0, 319.5, 239.5)


@pytest.fixture(scope="module")
def frame(shipped_file):
    """A redwood frame as Open3D images and as arrays, its camera in both forms, and a pose."""
    import open3d as o3d

    folder = shipped_file("rgbd-cupoch-redwood5")
    depth = o3d.io.read_image(str(folder / "depth" / "00002.png"))
    color = o3d.io.read_image(str(folder / "color" / "00002.jpg"))
    pose = np.eye(4)
    pose[:3, :3] = o3d.geometry.get_rotation_matrix_from_xyz((0.2, -0.7, 1.3))
    pose[:3, 3] = [0.3, -1.2, 2.5]
    assert np.asarray(depth).shape == (480, 640) and np.asarray(color).shape == (480, 640, 3)
    return SimpleNamespace(
        o3d=o3d, depth_image=depth, color_image=color, depth=np.asarray(depth), color=np.asarray(color),
        camera=o3d.camera.PinholeCameraIntrinsic(*PRIME_SENSE), intrinsic=loom.PinholeCameraIntrinsic(*PRIME_SENSE),
        extrinsic=np.linalg.inv(pose),
    )  # fmt: skip


def assert_points(found, expected, tolerances):
    np.testing.assert_allclose(found, expected, rtol=tolerances.image_relative, atol=tolerances.image_absolute)


@pytest.mark.parametrize("stride", [1, 3])
def test_points_of_a_depth_image_are_open3ds(device, stride, frame, tolerances):
    cloud = loom.PointCloud.from_depth_image(
        frame.depth, frame.intrinsic, frame.extrinsic, depth_trunc=2.7431, stride=stride, device=device
    )
    oracle = frame.o3d.geometry.PointCloud.create_from_depth_image(
        frame.depth_image, frame.camera, frame.extrinsic, depth_trunc=2.7431, stride=stride
    )
    assert 1000 < len(cloud) < 640 * 480
    assert_points(cloud.points, np.asarray(oracle.points), tolerances)


def test_a_depth_image_without_options_gives_the_points_in_the_camera(device, frame, tolerances):
    cloud = loom.PointCloud.from_depth_image(frame.depth, frame.intrinsic, device=device)
    oracle = frame.o3d.geometry.PointCloud.create_from_depth_image(frame.depth_image, frame.camera)
    assert_points(cloud.points, np.asarray(oracle.points), tolerances)


def test_an_organised_cloud_keeps_the_grid_and_open3ds_points(device, frame, tolerances):
    cloud = loom.PointCloud.from_depth_image(
        frame.depth, frame.intrinsic, frame.extrinsic, project_valid_depth_only=False, device=device
    )
    oracle = frame.o3d.geometry.PointCloud.create_from_depth_image(
        frame.depth_image, frame.camera, frame.extrinsic, project_valid_depth_only=False
    )
    assert cloud.grid == (480, 640) and len(cloud) == 480 * 640
    assert_points(cloud.points, np.asarray(oracle.points), tolerances)
    holes = frame.depth.reshape(-1) == 0
    assert holes.any()
    np.testing.assert_array_equal(np.isnan(cloud.points).all(axis=1), holes)
    valid = loom.PointCloud.from_depth_image(frame.depth, frame.intrinsic, frame.extrinsic, device=device)
    assert valid.grid is None
    np.testing.assert_array_equal(cloud.remove_non_finite_points().points, valid.points)
    strided = loom.PointCloud.from_depth_image(
        frame.depth, frame.intrinsic, frame.extrinsic, stride=7, project_valid_depth_only=False, device=device
    )
    assert strided.grid == (69, 92)
    np.testing.assert_array_equal(strided.points, cloud.points.reshape(480, 640, 3)[::7, ::7].reshape(-1, 3))


def test_an_organised_cloud_keeps_its_grid_where_its_points_stay(device, frame):
    cloud = loom.PointCloud.from_depth_image(
        frame.depth, frame.intrinsic, stride=8, project_valid_depth_only=False, device=device
    )
    fitted = cloud.estimate_normals(radius=0.1)
    for kept in (cloud.transform(np.eye(4)), fitted, fitted.orient_normals_towards_camera_location(), cloud.copy()):
        assert kept.grid == (60, 80)
    for lost in (cloud.select_by_index([0, 1]), cloud.voxel_down_sample(0.1), cloud.remove_non_finite_points()):
        assert lost.grid is None
    np.testing.assert_array_equal(np.isnan(fitted.normals).all(axis=1), np.isnan(cloud.points).all(axis=1))


def test_points_of_an_rgbd_image_are_open3ds(device, frame, tolerances):
    image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=2.7431, device=device)
    cloud = loom.PointCloud.from_rgbd_image(image, frame.intrinsic, frame.extrinsic)
    rgbd = frame.o3d.geometry.RGBDImage.create_from_color_and_depth(
        frame.color_image, frame.depth_image, depth_trunc=2.7431, convert_rgb_to_intensity=False
    )
    oracle = frame.o3d.geometry.PointCloud.create_from_rgbd_image(rgbd, frame.camera, frame.extrinsic)
    assert_points(cloud.points, np.asarray(oracle.points), tolerances)
    np.testing.assert_allclose(cloud.colors, np.asarray(oracle.colors), rtol=tolerances.float32_relative)
    np.testing.assert_array_equal(image.color, frame.color)
    np.testing.assert_allclose(image.depth, np.asarray(rgbd.depth), rtol=tolerances.float32_relative)
    organised = loom.PointCloud.from_rgbd_image(
        image, frame.intrinsic, frame.extrinsic, project_valid_depth_only=False, stride=2
    )
    assert organised.grid == (240, 320) and organised.colors.shape == (240 * 320, 3)
    np.testing.assert_array_equal(
        organised.colors.reshape(240, 320, 3), frame.color[::2, ::2].astype(np.float32) / np.float32(255)
    )


def test_depth_in_metres_gives_the_same_points_and_is_cut_too(device, frame, tolerances):
    """Open3D ignores depth_trunc where depth is float."""
    metres = (frame.depth / 1000).astype(np.float32)
    from_floats = loom.PointCloud.from_depth_image(metres, frame.intrinsic, depth_trunc=2.7431, device=device)
    from_integers = loom.PointCloud.from_depth_image(frame.depth, frame.intrinsic, depth_trunc=2.7431, device=device)
    assert_points(from_floats.points, from_integers.points, tolerances)


def small(**changes):
    """Arguments of a 3 x 2 image."""
    return {
        "depth": np.full((2, 3), 1000, np.uint16),
        "intrinsic": loom.PinholeCameraIntrinsic(3, 2, 1, 1, 0, 0),
    } | changes


def test_the_farthest_depth_itself_is_kept(device):
    """Open3D drops it."""
    for depth_trunc, count in ((1.0, 6), (0.999, 0), (np.inf, 6)):
        assert len(loom.PointCloud.from_depth_image(**small(depth_trunc=depth_trunc), device=device)) == count


def test_depth_that_is_no_measurement_gives_no_point(device):
    depth = np.array([[0, -1, np.nan], [np.inf, 1e300, 2]])
    cloud = loom.PointCloud.from_depth_image(**small(depth=depth, depth_trunc=np.inf), device=device)
    assert cloud.points.tolist() == [[4, 2, 2]]


@pytest.mark.parametrize("dtype", [np.int16, np.int32, np.int64, np.uint16, np.float64, np.float16])
def test_depth_of_any_type_is_taken(device, dtype):
    depth = np.array([[0, 50, 100], [120, 0, 7]], dtype)
    scale = 1.0 if np.dtype(dtype).kind == "f" else 10.0
    cloud = loom.PointCloud.from_depth_image(**small(depth=depth, depth_scale=10.0), device=device)
    expected = depth[depth > 0].astype(np.float32) / np.float32(scale)
    np.testing.assert_array_equal(cloud.points[:, 2], expected)


def test_a_camera_at_utm_coordinates_keeps_millimetres(device, frame, tolerances):
    extrinsic = frame.extrinsic.copy()
    utm = np.array([5e5, 5.4e6, 100.25])
    extrinsic[:3, 3] -= extrinsic[:3, :3] @ utm
    near = loom.PointCloud.from_depth_image(frame.depth, frame.intrinsic, frame.extrinsic, device=device)
    far = loom.PointCloud.from_depth_image(frame.depth, frame.intrinsic, extrinsic, device=device)
    assert far.origin.any()
    np.testing.assert_allclose(far.points - utm, near.points, rtol=0, atol=tolerances.position / 100)


def test_grey_is_repeated_to_colours(device):
    grey = np.array([[0, 51, 255], [102, 1, 2]], np.uint8)
    image = loom.RGBDImage(grey, np.full((2, 3), 1000, np.uint16), device=device)
    cloud = loom.PointCloud.from_rgbd_image(image, small()["intrinsic"])
    np.testing.assert_array_equal(
        cloud.colors, np.repeat(grey.reshape(-1, 1).astype(np.float32) / np.float32(255), 3, axis=1)
    )


@pytest.mark.parametrize(
    ("changes", "error", "message"),
    [
        (
            {"depth": np.zeros((3, 2), np.uint16)},
            ValueError,
            "intrinsic: made for 3 x 2 pixels, but the image has 2 x 3",
        ),
        ({"depth": np.zeros((2, 3, 1), np.uint16)}, ValueError, r"depth: expected shape \[h, w\], got \[2, 3, 1\]"),
        ({"depth": np.zeros((0, 3), np.uint16)}, ValueError, r"depth: expected shape \[h, w\], got \[0, 3\]"),
        ({"depth": np.full((2, 3), -1)}, ValueError, "depth: integer depths must lie in 0..65535"),
        ({"depth": np.full((2, 3), 70000)}, ValueError, "depth: integer depths must lie in 0..65535"),
        ({"depth": np.zeros((2, 3), complex)}, TypeError, "depth: expected integers or floats, got complex128"),
        ({"intrinsic": np.eye(3)}, TypeError, "intrinsic: expected a PinholeCameraIntrinsic, got ndarray"),
        ({"extrinsic": np.diag([2.0, 2, 2, 1])}, ValueError, "extrinsic: expected a rigid motion"),
        ({"extrinsic": np.diag([1.0, 1, -1, 1])}, ValueError, "extrinsic: expected a rigid motion"),
        ({"extrinsic": np.full((4, 4), np.nan)}, ValueError, "extrinsic: expected a rigid motion, got NaN"),
        ({"extrinsic": np.eye(3)}, ValueError, r"extrinsic: expected shape \[4, 4\], got \[3, 3\]"),
        ({"depth_scale": 0}, ValueError, "depth_scale: expected a finite number > 0"),
        ({"depth_trunc": 0}, ValueError, "depth_trunc: expected a number > 0, got 0"),
        ({"depth_trunc": np.nan}, ValueError, "depth_trunc: expected a number > 0, got nan"),
        ({"stride": 0}, ValueError, "stride: expected a whole number >= 1"),
        ({"stride": 1.5}, TypeError, "stride: expected a whole number"),
    ],
)
def test_wrong_arguments_are_named(changes, error, message):
    with pytest.raises(error, match=message):
        loom.PointCloud.from_depth_image(**small(**changes))


@pytest.mark.parametrize(
    ("color", "error", "message"),
    [
        (np.zeros((3, 3, 3), np.uint8), ValueError, "color: 3 x 3 pixels, but the depth image has 3 x 2; resize"),
        (np.zeros((2, 3, 4), np.uint8), ValueError, r"color: expected shape \[h, w, 3\], got \[2, 3, 4\]"),
        (np.zeros((2, 3, 3)), TypeError, "color: expected uint8, got float64"),
        (np.zeros(6, np.uint8), ValueError, r"color: expected shape \[h, w, 3\], got \[6\]"),
    ],
)
def test_colours_that_do_not_go_with_the_depth_are_refused(color, error, message):
    with pytest.raises(error, match=message):
        loom.RGBDImage(color, np.zeros((2, 3), np.uint16))


@pytest.mark.parametrize("kind", [np.uint8, np.int8])
def test_eight_bits_are_no_depth(kind, device):
    depth, color = np.full((2, 3), 100, kind), np.zeros((2, 3, 3), np.uint8)
    camera = loom.PinholeCameraIntrinsic(3, 2, 3.0, 3.0, 1.0, 0.5)
    for use in (
        lambda: loom.RGBDImage(color, depth, device=device),
        lambda: loom.RGBDImage.from_color_and_depth(color, depth, depth_scale=10, depth_trunc=10, device=device),
        lambda: loom.RGBDImage.from_sun_format(color, depth, device=device),
        lambda: loom.PointCloud.from_depth_image(depth, camera, device=device),
        lambda: loom.TSDFVolume(voxel_size=0.1, device=device).integrate(depth, camera, np.eye(4)),
    ):
        with pytest.raises(
            TypeError, match=r"depth: expected 16-bit integers or float metres, got u?int8: 8 bits hold"
        ):
            use()
