"""The numbers under the mask of a numpy.ma array are never taken for measured ones."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.open3d.utility import Vector3dVector

CAMERA = loom.PinholeCameraIntrinsic(4, 3, 5.0, 5.0, 1.5, 1.0)


def masked(shape, dtype=float, row=1, value=100):
    array = np.ma.masked_array(np.full(shape, 1, dtype), mask=False)
    array[row] = np.ma.masked
    array.data[row] = value
    return array


@pytest.mark.parametrize("kind", [np.ma.asarray, list], ids=["array", "list of rows"])
def test_masked_floats_are_nan(kind):
    points = masked((5, 3))
    cloud = loom.PointCloud(kind(points), normals=kind(points), weight=masked(5))
    for values in (cloud.points, cloud.normals):
        np.testing.assert_array_equal(values, np.ma.filled(points, np.nan))
    np.testing.assert_array_equal(np.isnan(cloud["weight"]), masked(5).mask)
    assert cloud.get_max_bound().max() == 1
    np.testing.assert_array_equal(Vector3dVector(points), np.ma.filled(points, np.nan))


def test_arrays_with_an_empty_mask_are_plain():
    unmasked = np.ma.masked_array(np.arange(9).reshape(3, 3), mask=False)
    np.testing.assert_array_equal(loom.PointCloud(unmasked).points, unmasked.data)


@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("points", lambda: loom.PointCloud(masked((5, 3), int))),
        ("colors", lambda: loom.PointCloud(np.zeros((5, 3)), colors=masked((5, 3), np.uint8))),
        ("colors", lambda: loom.PointCloud(np.zeros((5, 3)), colors=masked((5, 3)))),
        ("ring", lambda: loom.PointCloud(np.zeros((5, 3)), ring=masked(5, int))),
        ("triangles", lambda: loom.TriangleMesh(np.eye(3), masked((2, 3), int))),
        ("color", lambda: loom.RGBDImage(masked((3, 4, 3), np.uint8), np.ones((3, 4)))),
        ("extrinsic", lambda: loom.PointCloud.create_from_depth_image(np.ones((3, 4)), CAMERA, masked((4, 4)))),
    ],
)
def test_masked_entries_without_a_missing_value_are_refused(name, call):
    with pytest.raises(ValueError, match=rf"^{name}: "):
        call()


@pytest.mark.parametrize("dtype", [np.uint16, np.float32])
def test_masked_depth_is_no_measurement(dtype):
    depth = masked((3, 4), dtype)
    for scale in (None, 1.0):
        cloud = loom.PointCloud.create_from_depth_image(depth, CAMERA, depth_scale=scale)
        assert len(cloud) == 8
    volume = loom.TSDFVolume(voxel_size=0.1)
    volume.integrate(depth, CAMERA, np.eye(4), depth_scale=1.0, depth_max=1000.0)
    assert volume.extract_point_cloud(weight_threshold=0).get_max_bound()[2] < 2
    assert loom.filter_depth_bilateral(depth, depth_scale=1.0).max() == pytest.approx(1)
